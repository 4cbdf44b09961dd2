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
        ldd r27, Y+3
        ret
=>
f:

        ret

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
