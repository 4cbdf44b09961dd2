; Copies and constants.

== what is there already is not put there again
f:
        movw r30, r14
        ldd r24, Z+9
        movw r30, r14
        ldd r25, Z+10
        ret
=>
f:
        movw r30, r14
        ldd r24, Z+9
        ldd r25, Z+10
        ret

== nor on two paths that agree
f:
        movw r30, r14
        tst r24
        breq .L1
        std Z+1, r24
.L1:
        movw r30, r14
        std Z+2, r24
        ret
=>
f:
        movw r30, r14
        tst r24
        breq .L1
        std Z+1, r24
.L1:
        std Z+2, r24
        ret

== but where one path differs
f:
        movw r30, r14
        tst r24
        breq .L1
        ld r30, Z
.L1:
        movw r30, r14
        std Z+2, r24
        ret
=> unchanged

== and where a loop leads back
f:
        movw r30, r14
.L1:
        movw r30, r14
        ld r24, Z+
        st X+, r24
        tst r24
        brne .L1
        ret
=>
f:
.L1:
        movw r30, r14
        ld r24, Z+
        st X+, r24
        tst r24
        brne .L1
        ret

== a pointer that has moved on is another value
f:
        movw r26, r14
        st X+, r24
        movw r26, r14
        st X+, r25
        ret
=> unchanged

== a call changes what is not kept for the caller
f:
        movw r18, r14
        call g
        movw r18, r14
        add r24, r18
        ret
=>
f:
        movw r18, r14
        call g
        movw r18, r14
        add r24, r18
        ret

== a constant is kept across a call in a register that is kept
f:
        ldi r17, 3
        call g
        ldi r17, 3
        mov r24, r17
        ret
=>
f:
        ldi r17, 3
        call g
        mov r24, r17
        ret

== the first half of a pair does not make the pair
f:
        mov r30, r14
        movw r30, r14
        ld r24, Z
        ret
=>
f:
        movw r30, r14
        ld r24, Z
        ret

== what nothing needs is dropped
f:
        ldi r26, 7
        mov r27, r24
        ret
=>
f:
        ret

== nor a read of the frame, however far its slot is
f:
        push r28
        push r29
        in r28, 61
        in r29, 62
        subi r28, 80
        sbci r29, 0
        in r0, 63
        cli
        out 62, r29
        out 63, r0
        out 61, r28
        ldd r27, Y+3
        adiw r28, 18
        ldd r27, Y+62
        sbiw r28, 18
        ldd r24, Y+5
        subi r28, 176
        sbci r29, 255
        in r0, 63
        cli
        out 62, r29
        out 63, r0
        out 61, r28
        pop r29
        pop r28
        ret
=>
f:
        push r28
        push r29
        in r28, 61
        in r29, 62
        subi r28, 80
        sbci r29, 0
        in r0, 63
        cli
        out 62, r29
        out 63, r0
        out 61, r28
        adiw r28, 18
        sbiw r28, 18
        ldd r24, Y+5
        subi r28, 176
        sbci r29, 255
        in r0, 63
        cli
        out 62, r29
        out 63, r0
        out 61, r28
        pop r29
        pop r28
        ret

== a read by Y is none of the frame where Y is no frame pointer
f:
        push r28
        push r29
        movw r28, r24
        ldd r27, Y+3
        ldd r24, Y+2
        pop r29
        pop r28
        ret
=> unchanged

== nor where Y was the frame pointer at the entry only
f:
        push r28
        push r29
        in r28, 61
        in r29, 62
        sbiw r28, 8
        in r0, 63
        cli
        out 62, r29
        out 63, r0
        out 61, r28
        movw r16, r28
        ldd r28, Y+1
        ldd r27, Y+3
        movw r28, r16
        adiw r28, 8
        in r0, 63
        cli
        out 62, r29
        out 63, r0
        out 61, r28
        pop r29
        pop r28
        ret
=> unchanged

== nor where an asm block moves Y, in whatever spelling
f:
        push r28
        push r29
        in r28, 61
        in r29, 62
        sbiw r28, 8
        in r0, 63
        cli
        out 62, r29
        out 63, r0
        out 61, r28
        ;APP
        movw YL, 0x18
        ;NO_APP
        ldd r27, Y+3
        adiw r28, 8
        in r0, 63
        cli
        out 62, r29
        out 63, r0
        out 61, r28
        pop r29
        pop r28
        ret
=> unchanged

== not a result, nor a register of the caller's, nor a read of anything but the stack
f:
        ldi r25, 7
        ldi r17, 7
        ldd r26, Z+1
        lds r27, 132
        ret
=> unchanged

== not the flags of an operation whose result is dropped
f:
        sub r26, r18
        breq .L1
        inc r24
.L1:
        ret
=> unchanged

== not what may be skipped, nor what is known from where it was
f:
        sbrc r24, 0
        ldi r18, 1
        ldi r18, 1
        add r24, r18
        ret
=> unchanged

== not what was written by hand
f:
        ;APP
        ldi r26, 1
        ;NO_APP
        ret
=> unchanged

== what an asm block calls may change all
f:
        movw r16, r14
        ;APP
        icall
        ;NO_APP
        movw r16, r14
        movw r24, r16
        ret
=>
f:
        movw r16, r14
        ;APP
        icall
        ;NO_APP
        movw r16, r14
        movw r24, r14
        ret

== the last register has no next one
f:
        mov r16, r31
        mov r24, r31
        add r24, r22
        ret
=>
f:
        mov r16, r31
        mov r24, r16
        add r24, r22
        ret
