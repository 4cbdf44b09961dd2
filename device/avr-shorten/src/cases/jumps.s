; The rule for jumps.

== a branch around a jump takes the other condition
f:
        breq .L1
        rjmp .L2
.L1:
        nop
.L2:
        ret
=>
f:
        brne .L2
        nop
.L2:
        ret

== not where the jump leads out of the function
f:
        breq .L1
        jmp g
.L1:
        nop
        ret
=> unchanged

== a branch to a jump goes where that goes
f:
        tst r24
        breq .L1
        call g
.L2:
        call g
        nop
        ret
.L1:
        rjmp .L2
=>
f:
        tst r24
        breq .L2
        call g
.L2:
        call g
        nop
        ret

== a jump to a return is one
f:
        brne .L1
        nop
        rjmp .L2
.L1:
        inc r24
        breq .L3
.L2:
        ret
.L3:
        inc r25
        rjmp .L2
=>
f:
        brne .L1
        nop
        ret
.L1:
        inc r24
        breq .L3
        ret
.L3:
        inc r25
        ret

== an endless loop stays
f:
.L1:
        rjmp .L1
=> unchanged

== two jumps in a circle are one
f:
        breq .L2
.L1:
        rjmp .L2
.L2:
        rjmp .L1
=>
f:
.L1:
        rjmp .L1

== what nothing leads to is dropped
f:
        ret
        nop
        rjmp .L1
        inc r24
=>
f:
        ret

== not behind a return that may be skipped
f:
        sbrc r24, 0
        ret
        inc r24
        ret
=> unchanged

== not what was written by hand
f:
        ret
        ;APP
        nop
        ;NO_APP
=> unchanged

== a call before a return is a jump
f:
        inc r24
        call g
        ret
=>
f:
        inc r24
        jmp g

== not where the call may be skipped
f:
        sbrs r24, 0
        call g
        ret
=> unchanged

== code that one jump leads to moves there
f:
        breq .L1
        inc r24
        rjmp .L2
.L1:
        dec r24
        rjmp .L3
.L2:
        inc r25
        call g
.L3:
        nop
        ret
=>
f:
        breq .L1
        inc r24
        inc r25
        call g
.L3:
        nop
        ret
.L1:
        dec r24
        rjmp .L3

== not where the jump may be skipped
f:
        sbrc r24, 0
        rjmp .L2
        dec r24
        ret
.L2:
        inc r25
        ret
=> unchanged
