; Scans, one after the other, as long as they need nothing but to read inputs 01 to 04, to run the program, and to
; write outputs. It is left where one needs more, and where something else is to be done.
;
;   r24       0 where a scan is to begin, 1 where it has been prepared, 2 where it has been finished; at the end 0
;             where something else is to be done, 1 where it is to be prepared, 2 where it is to be finished
;   r6, r7    `Scans`
;   r16, r17  when the last scan began, in counts of timer 1
;   r2-r5     the time stamp: it holds as long as no millisecond has begun, and AGE is 0
;   X         the linked code
;   r20, r21  the data of its first timer
;
;   r22, r23  at the end, where a scan is to be prepared: the count of timer 1 at which it began

        push    r28
        push    r29
        push    r27
        push    r26
        push    r21
        push    r20
        movw    r30, r6
        ldd     r18, Z+{POINTS}
        cpi     r24, 1
        breq    .Lscan_run
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
        in      r20, 0x09       ; PIND
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
        lsr     r20
        lsr     r20
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
        ldi     r31, 2          ; NEAR
        set
        ld      r30, X+
        icall
        movw    r30, r6
        std     Z+{POINTS}, r18
        ldd     r25, Z+{BEHIND}
        cpi     r25, {FINISHES}
        brsh    .Lscan_finish
        in      r24, 0x0b       ; PORTD
        bst     r18, 4
        bld     r24, 6
        bst     r18, 5
        bld     r24, 7
        out     0x0b, r24
        in      r24, 0x05       ; PORTB
        bst     r18, 6
        bld     r24, 0
        bst     r18, 7
        bld     r24, 1
        out     0x05, r24

.Lscan_written:
        lds     r24, PORT_AT
        or      r24, r25
        brne    .Lscan_end
        sbic    0x06, 5         ; PINC: STOP
        rjmp    scan_begin
.Lscan_end:
        ldi     r24, 0
        rjmp    .Lscan_out
.Lscan_finish:
        ldi     r24, 2
.Lscan_out:
        pop     r20
        pop     r20
        pop     r20
        pop     r20
        pop     r29
        pop     r28
