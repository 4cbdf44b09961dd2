; Decisions, with what the rules for jumps and copies make of them.

== a truth value that is branched by at once is not made
f:
        ldi r26, 1
        cp r18, r20
        cpc r19, r21
        brlo .L1
        mov r26, r1
.L1:
        andi r26, 1
        cpi r26, 0
        breq .L2
        call g
.L2:
        call h
        nop
        ret
=>
f:
        cp r18, r20
        cpc r19, r21
        brsh .L2
        call g
.L2:
        call h
        nop
        ret

== not where the value is not known
f:
        cp r18, r20
        brlo .L1
        mov r26, r22
.L1:
        andi r26, 1
        cpi r26, 0
        breq .L2
        call g
.L2:
        call h
        nop
        ret
=> unchanged

== not where the flags of the comparison are needed
f:
        ldi r26, 1
        cp r18, r20
        brlo .L1
        mov r26, r1
.L1:
        cpi r26, 0
        breq .L2
        adc r18, r19
        call g
.L2:
        call h
        nop
        ret
=> unchanged

== not what was written by hand
f:
        ldi r26, 1
        cp r18, r20
        brlo .L1
        mov r26, r1
.L1:
        ;APP
        cpi r26, 0
        ;NO_APP
        breq .L2
        call g
.L2:
        call h
        nop
        ret
=> unchanged
