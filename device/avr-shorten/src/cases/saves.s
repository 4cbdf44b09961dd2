; Entries and exits.

== registers that are kept for the caller
f:
        push r14
        push r15
        push r16
        push r17
        movw r14, r24
        pop r17
        pop r16
        pop r15
        pop r14
        ret
=>
f:
        call __save_r14
        movw r14, r24
        pop r17
        pop r16
        pop r15
        pop r14
        ret
__save:
__save_r14:
        pop r31
        pop r30
        push r14
        push r15
        push r16
        push r17
        ijmp

== one register more where one in between is left out
f:
        push r14
        push r15
        push r17
        movw r14, r24
        pop r17
        pop r15
        pop r14
        ret
=>
f:
        call __save_r14
        movw r14, r24
        pop r17
        pop r16
        pop r15
        pop r14
        ret
__save:
__save_r14:
        pop r31
        pop r30
        push r14
        push r15
        push r16
        push r17
        ijmp

== room on the stack
f:
        push r16
        push r17
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
        std Y+8, r24
        movw r24, r28
        adiw r24, 1
        adiw r28, 8
        in r0, 63
        cli
        out 62, r29
        out 63, r0
        out 61, r28
        pop r29
        pop r28
        pop r17
        pop r16
        ret
g:
        push r28
        push r29
        in r28, 61
        in r29, 62
        subi r28, 100
        sbci r29, 0
        in r0, 63
        cli
        out 62, r29
        out 63, r0
        out 61, r28
        nop
        subi r28, 156
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
        ldi r26, 8
        call __frame_r16
        std Y+8, r24
        movw r24, r28
        adiw r24, 1
        adiw r28, 8
        ldi r30, 4
        jmp __unframe_r16
g:
        ldi r26, 100
        call __frame_r18
        nop
        subi r28, 156
        sbci r29, 255
        ldi r30, 2
        jmp __unframe_r18
__frame:
__frame_r18:
        pop r31
        pop r30
        rjmp .Lframe_r18
__frame_r16:
        pop r31
        pop r30
        push r16
        push r17
.Lframe_r18:
        push r28
        push r29
        in r28, 61
        in r29, 62
        sub r28, r26
        sbc r29, r1
        in r0, 63
        cli
        out 62, r29
        out 63, r0
        out 61, r28
        ijmp
__unframe:
__unframe_r16:
        ldd r16, Y+4
        ldd r17, Y+3
__unframe_r18:
        ldd r26, Y+2
        ldd r27, Y+1
        add r28, r30
        adc r29, r1
        in r0, 63
        cli
        out 62, r29
        out 63, r0
        out 61, r28
        movw r28, r26
        ret

== a function that does not return gives nothing back
f:
        push r16
        push r17
.L1:
        call g
        rjmp .L1
=>
f:
.L1:
        call g
        rjmp .L1

== not two registers
f:
        push r16
        push r17
        movw r16, r24
        pop r17
        pop r16
        ret
=> unchanged

== not where an argument is on the stack
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
        ldd r24, Y+13
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

== nor where it is far
f:
        push r28
        push r29
        in r28, 61
        in r29, 62
        subi r28, 70
        sbci r29, 0
        in r0, 63
        cli
        out 62, r29
        out 63, r0
        out 61, r28
        adiw r28, 12
        ldd r24, Y+62
        sbiw r28, 12
        subi r28, 186
        sbci r29, 255
        in r0, 63
        cli
        out 62, r29
        out 63, r0
        out 61, r28
        pop r29
        pop r28
        ret
=> unchanged

== not where the stack is looked at
f:
        push r14
        push r15
        push r16
        in r30, 61
        in r31, 62
        ldd r24, Z+6
        pop r16
        pop r15
        pop r14
        ret
=> unchanged

== not an interrupt
interrupt:
        push r0
        in r0, 63
        push r0
        push r24
        lds r24, 198
        pop r24
        pop r0
        out 63, r0
        pop r0
        reti
=> unchanged

== not where an exit is another one
f:
        push r14
        push r15
        push r16
        breq .L1
        pop r16
        pop r15
        pop r14
        ret
.L1:
        pop r16
        ret
=> unchanged
