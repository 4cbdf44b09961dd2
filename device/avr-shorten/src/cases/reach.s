; The reach of branches: 63 words ahead, 64 back.

== as far as it goes
f:
.L1:
        nops 63
        breq .L1
        brne .L2
        nops 63
.L2:
        ret
=> unchanged

== one word more
f:
        brne .L2
        nops 64
.L2:
        ret
=>
f:
        breq .Lnear1
        rjmp .L2
.Lnear1:
        nops 64
.L2:
        ret

== one word more back
f:
.L1:
        nops 64
        brlo .L1
        ret
=>
f:
.L1:
        nops 64
        brsh .Lnear1
        rjmp .L1
.Lnear1:
        ret

== by way of a jump that is there
f:
        brne .L2
        nops 20
        breq .L3
        rjmp .L2
.L3:
        nops 80
.L2:
        ret
=>
f:
        brne .Lvia1
        nops 20
        breq .L3
.Lvia1:
        rjmp .L2
.L3:
        nops 80
.L2:
        ret

== but not in the scan
f:
scan_begin:
        brne .L2
        nops 20
        breq .L3
        rjmp .L2
.L3:
        nops 80
.L2:
        ret
=>
f:
scan_begin:
        breq .Lnear1
        rjmp .L2
.Lnear1:
        nops 20
        breq .L3
        rjmp .L2
.L3:
        nops 80
.L2:
        ret
