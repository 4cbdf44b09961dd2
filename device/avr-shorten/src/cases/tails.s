; Equal ends of paths.

== of two functions: one jumps to the other
f:
        inc r24
        ldd r18, Z+1
        std Y+2, r18
        pop r17
        pop r16
        ret
g:
        dec r24
        ldd r18, Z+1
        std Y+2, r18
        pop r17
        pop r16
        ret
=>
f:
        inc r24
.Ltail1:
        ldd r18, Z+1
        std Y+2, r18
        pop r17
        pop r16
        ret
g:
        dec r24
        jmp .Ltail1

== not where the jump is as long as what it saves
f:
        inc r24
        pop r16
        ret
g:
        dec r24
        pop r16
        ret
=> unchanged

== of one function: the way that falls into the label stays
f:
        breq .L1
        ldi r18, 1
        std Y+2, r18
        rjmp .L2
.L1:
        nop
        ldi r18, 1
        std Y+2, r18
.L2:
        call g
        inc r24
        ret
=>
f:
        breq .L1
        rjmp .Ltail1
.L1:
        nop
.Ltail1:
        ldi r18, 1
        std Y+2, r18
.L2:
        call g
        inc r24
        ret

== not from what may be skipped
f:
        inc r24
        sbrc r24, 0
        ldi r18, 1
        std Y+1, r18
        ret
g:
        dec r24
        sbrs r24, 0
        ldi r18, 1
        std Y+1, r18
        ret
=> unchanged

== not from where interrupts come on again and the stack pointer is half set
f:
        inc r24
        out 62, r29
        out 63, r0
        out 61, r28
        pop r28
        ret
g:
        dec r24
        out 62, r29
        sei
        out 61, r28
        pop r28
        ret
=> unchanged

== not past a label, nor past what was written by hand
f:
        inc r24
        breq .L1
        ldi r18, 1
.L1:
        ldi r19, 1
        ret
g:
        ;APP
        ldi r18, 1
        ;NO_APP
        ldi r19, 1
        ret
=> unchanged

== not before a write that is allowed for four cycles
f:
        inc r24
        ldi r25, 4
        out 31, r25
        sbi 31, 1
        ret
g:
        dec r24
        ldi r25, 4
        out 31, r25
        sbi 31, 1
        ret
=> unchanged

== the scan jumps nowhere, but may be jumped to
f:
        inc r24
        ldi r18, 1
        ldi r19, 1
        std Y+2, r18
        ret
run:
scan_begin:
        dec r24
        ldi r18, 1
        ldi r19, 1
        std Y+2, r18
        ret
=>
f:
        inc r24
        jmp .Ltail1
run:
scan_begin:
        dec r24
.Ltail1:
        ldi r18, 1
        ldi r19, 1
        std Y+2, r18
        ret
