; Scans, one after the other, as `scan.s` beside this folder makes them, with the ports of the Mega: the registers are as
; told there.

        push    r28
        push    r29
        push    r27
        push    r26
        push    r21
        push    r20
        in      r18, 0x3d       ; SPL, as it is within the call of the program
        subi    r18, 3
        sts     ENGINE_STACK, r18
        movw    r30, r6
        ldd     r18, Z+{POINTS}
        cpi     r24, 1
        brne    .Lscan_entered
        rjmp    .Lscan_run
.Lscan_entered:
        brlo    scan_begin
        ldd     r25, Z+{BEHIND}
        andi    r25, {DUE}
        rjmp    .Lscan_written

.Lscan_most:
        cpi     r25, 8          ; more than a millisecond: AGE stands, and the watchdog will bite
        brsh    .Lscan_prepare
        std     Z+{MOST}, r24
        std     Z+{MOST}+1, r25
        rjmp    .Lscan_timed
.Lscan_prepare:
        ldi     r24, 1
        rjmp    .Lscan_out

; A simulator stops here to set pins and clock.
        .global scan_begin
scan_begin:
        in      r20, 0x00       ; PINA
        lds     r21, 0x106      ; PINK
        in      r19, 0x06       ; PINC
        lds     r22, 0x84       ; TCNT1
        lds     r23, 0x85
; Behind the pins: an input is never seen with a time stamp from before it changed (NC-5). Behind the timer: its
; count is of a time that AGE knows of.
        lds     r24, AGE
        ldd     r25, Z+{BEFORE}
        or      r24, r25
        brne    .Lscan_prepare
        movw    r24, r22
        sub     r24, r16
        sbc     r25, r17
        ldd     r26, Z+{LEAST}
        ldd     r27, Z+{LEAST}+1
        cp      r24, r26
        cpc     r25, r27
        brsh    .Lscan_not_least
        std     Z+{LEAST}, r24
        std     Z+{LEAST}+1, r25
.Lscan_not_least:
        ldd     r26, Z+{MOST}
        ldd     r27, Z+{MOST}+1
        cp      r26, r24
        cpc     r27, r25
        brlo    .Lscan_most
.Lscan_timed:
        std     Z+{LAST}, r24
        std     Z+{LAST}+1, r25
        movw    r16, r22
        com     r20
        com     r21
        com     r19
; Inputs from 05 on are bits of their own, written where a port has changed.
        ldd     r24, Z+{PORTS}
        cp      r24, r20
        breq    .Lscan_second
        std     Z+{PORTS}, r20
        sts     MORE_INPUTS, r20
        mov     r24, r20
        sts     INPUT_CELLS+3, r24
        lsl     r24
        sts     INPUT_CELLS+2, r24
        lsl     r24
        sts     INPUT_CELLS+1, r24
        lsl     r24
        sts     INPUT_CELLS, r24
.Lscan_second:
        ldd     r24, Z+{PORTS}+1
        cp      r24, r21
        breq    .Lscan_third
        std     Z+{PORTS}+1, r21
        sts     MORE_INPUTS+1, r21
        sts     INPUT_CELLS+11, r21
        lsl     r21
        sts     INPUT_CELLS+10, r21
        lsl     r21
        sts     INPUT_CELLS+9, r21
        lsl     r21
        sts     INPUT_CELLS+8, r21
        lsl     r21
        sts     INPUT_CELLS+7, r21
        lsl     r21
        sts     INPUT_CELLS+6, r21
        lsl     r21
        sts     INPUT_CELLS+5, r21
        lsl     r21
        sts     INPUT_CELLS+4, r21
.Lscan_third:
        ldd     r24, Z+{PORTS}+2
        cp      r24, r19
        breq    .Lscan_read
        std     Z+{PORTS}+2, r19
        sts     MORE_INPUTS+2, r19
        sts     INPUT_CELLS+19, r19
        lsl     r19
        sts     INPUT_CELLS+18, r19
        lsl     r19
        sts     INPUT_CELLS+17, r19
        lsl     r19
        sts     INPUT_CELLS+16, r19
        lsl     r19
        sts     INPUT_CELLS+15, r19
        lsl     r19
        sts     INPUT_CELLS+14, r19
        lsl     r19
        sts     INPUT_CELLS+13, r19
        lsl     r19
        sts     INPUT_CELLS+12, r19
.Lscan_read:
        andi    r20, {INPUTS}
        ldd     r18, Z+{POINTS}
        andi    r18, {OUTPUTS}
        or      r18, r20

.Lscan_run:
        in      r30, 0x3d       ; SP
        in      r31, 0x3e
        ldd     r28, Z+1
        ldd     r29, Z+2
        ldd     r26, Z+3
        ldd     r27, Z+4
        ldi     r22, 0
        ldi     r23, 0
        movw    r24, r22
        ldi     r31, 3          ; NEAR
        set
        ld      r30, X+
        icall
        clr     r1              ; a byte that is no handler's may have led to a product
        movw    r30, r6
        std     Z+{POINTS}, r18
        ldd     r25, Z+{BEHIND}
        cpi     r25, {FINISHES}
        brlo    .Lscan_write
        ldi     r24, 2          ; it is to be finished
        rjmp    .Lscan_out
.Lscan_write:
        in      r24, 0x0E       ; PORTE
        bst     r18, 4
        bld     r24, 4
        bst     r18, 5
        bld     r24, 5
        bst     r18, 7
        bld     r24, 3
        out     0x0E, r24
        in      r24, 0x14       ; PORTG
        bst     r18, 6
        bld     r24, 5
        out     0x14, r24
        ldi     r20, 0          ; outputs 05 to 08, from bit 3 on
        lds     r24, OUTPUT_CELLS
        bst     r24, 7
        bld     r20, 3
        lds     r24, OUTPUT_CELLS+1
        bst     r24, 7
        bld     r20, 4
        lds     r24, OUTPUT_CELLS+2
        bst     r24, 7
        bld     r20, 5
        lds     r24, OUTPUT_CELLS+3
        bst     r24, 7
        bld     r20, 6
        std     Z+{REST}, r20
        lds     r24, 0x102      ; PORTH
        andi    r24, 0x87
        or      r24, r20
        sts     0x102, r24
        lds     r24, OUTPUT_CELLS+4
        bst     r24, 7
        bld     r21, 0
        lds     r24, OUTPUT_CELLS+5
        bst     r24, 7
        bld     r21, 1
        lds     r24, OUTPUT_CELLS+6
        bst     r24, 7
        bld     r21, 2
        lds     r24, OUTPUT_CELLS+7
        bst     r24, 7
        bld     r21, 3
        lds     r24, OUTPUT_CELLS+8
        bst     r24, 7
        bld     r21, 4
        lds     r24, OUTPUT_CELLS+9
        bst     r24, 7
        bld     r21, 5
        lds     r24, OUTPUT_CELLS+10
        bst     r24, 7
        bld     r21, 6
        lds     r24, OUTPUT_CELLS+11
        bst     r24, 7
        bld     r21, 7
        std     Z+{REST}+1, r21
        sts     0x10B, r21      ; PORTL

.Lscan_written:
        lds     r24, PORT_AT
        or      r24, r25
        lds     r25, BUS_AT
        or      r24, r25
        brne    .Lscan_end
        sbic    0x09, 0         ; PIND: STOP
        rjmp    scan_begin
.Lscan_end:
        ldi     r24, 0
        rjmp    .Lscan_out
.Lscan_out:
        pop     r20
        pop     r20
        pop     r20
        pop     r20
        pop     r29
        pop     r28
