; Equal parts.

== three equal rows become a subroutine
f:
        std Y+1, r18
        std Y+2, r19
        std Y+3, r20
        std Y+4, r21
        nop
        std Y+1, r18
        std Y+2, r19
        std Y+3, r20
        std Y+4, r21
        ret
g:
        std Y+1, r18
        std Y+2, r19
        std Y+3, r20
        std Y+4, r21
        ret
=>
f:
        call __part1
        nop
        call __part1
        ret
g:
        call __part1
        ret
__part1:
        std Y+1, r18
        std Y+2, r19
        std Y+3, r20
        std Y+4, r21
        ret

== a call at the end is a jump
f:
        ldi r22, 32
        ldi r20, 9
        ldi r21, 0
        call memset
        nop
        ldi r22, 32
        ldi r20, 9
        ldi r21, 0
        call memset
        ret
=>
f:
        call __part1
        nop
        call __part1
        ret
__part1:
        ldi r22, 32
        ldi r20, 9
        ldi r21, 0
        jmp memset

== not where it saves next to nothing
f:
        std Y+1, r18
        std Y+2, r19
        nop
        std Y+1, r18
        std Y+2, r19
        ret
=> unchanged

== not past a call, which would have less stack
f:
        movw r24, r14
        call g
        movw r22, r12
        call g
        movw r24, r14
        call g
        movw r22, r12
        ret
=> unchanged

== not with the stack, r0, or a branch
f:
        std Y+1, r18
        push r24
        std Y+2, r19
        in r0, 63
        std Y+3, r19
        in r24, 61
        std Y+4, r19
        breq .L1
        std Y+1, r18
        push r24
        std Y+2, r19
        in r0, 63
        std Y+3, r19
        in r24, 61
        std Y+4, r19
        breq .L1
.L1:
        ret
=> unchanged

== not what may be skipped
f:
        sbrc r24, 0
        std Y+1, r18
        std Y+2, r19
        std Y+3, r20
        sbrc r24, 1
        std Y+1, r18
        std Y+2, r19
        std Y+3, r20
        sbrc r24, 2
        std Y+1, r18
        std Y+2, r19
        ret
=> unchanged

== not between writes that are allowed for four cycles only
f:
        ldi r25, 24
        sts 96, r25
        ldi r25, 11
        sts 96, r25
        nop
        ldi r25, 24
        sts 96, r25
        ldi r25, 11
        sts 96, r25
        ret
=> unchanged

== not a call of a function that has arguments on the stack
f:
        ldi r22, 32
        ldi r20, 9
        call g
        nop
        ldi r22, 32
        ldi r20, 9
        call g
        ret
g:
        push r28
        push r29
        in r28, 61
        in r29, 62
        sbiw r28, 1
        in r0, 63
        cli
        out 62, r29
        out 63, r0
        out 61, r28
        ldd r24, Y+6
        adiw r28, 1
        in r0, 63
        cli
        out 62, r29
        out 63, r0
        out 61, r28
        pop r29
        pop r28
        ret
=> unchanged

== not of the scan
f:
scan_begin:
        std Y+1, r18
        std Y+2, r19
        std Y+3, r20
        std Y+4, r21
        nop
        std Y+1, r18
        std Y+2, r19
        std Y+3, r20
        std Y+4, r21
        nop
        std Y+1, r18
        std Y+2, r19
        std Y+3, r20
        std Y+4, r21
        ret
=> unchanged
