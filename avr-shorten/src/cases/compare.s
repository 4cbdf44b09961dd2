; Comparisons with 0.

== behind an operation that sets Z by its result
f:
        andi r24, 32
        cpi r24, 0
        breq .L1
        call g
.L1:
        nop
        ret
=>
f:
        andi r24, 32
        breq .L1
        call g
.L1:
        nop
        ret

== not of another register
f:
        andi r24, 32
        cpi r25, 0
        breq .L1
        call g
.L1:
        nop
        ret
=> unchanged

== not where the carry that it clears is needed
f:
        andi r24, 32
        cpi r24, 0
        cpc r25, r1
        breq .L1
        call g
.L1:
        nop
        ret
=> unchanged

== not behind an operation that leaves the flags alone
f:
        mov r24, r22
        cpi r24, 0
        breq .L1
        call g
.L1:
        nop
        ret
=> unchanged

== not where the operation may be skipped
f:
        sbrc r22, 0
        andi r24, 32
        cpi r24, 0
        breq .L1
        call g
.L1:
        nop
        ret
=> unchanged

== not where a label stands between
f:
        breq .L2
        andi r24, 32
.L2:
        cpi r24, 0
        breq .L1
        call g
.L1:
        nop
        ret
=> unchanged
