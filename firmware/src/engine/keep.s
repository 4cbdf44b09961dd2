; The numbers that are kept over a power cut, and the snapshot of them (NC-21).
;
;   r25:r24  the addresses of the numbers, two bytes each; X from here on
;   r23:r22  their snapshot, four bytes each; Z from here on
;   r20      how many
;   r18      bit 0: the snapshot is taken, else the numbers are brought back
;
; Gives in r24 whether anything has changed by that. It stands in the room that the first handlers leave.

        .global engine_keep
        .type   engine_keep, @function
engine_keep:
        push    r28
        push    r29
        movw    r26, r24
        movw    r30, r22
        clr     r24
1:      subi    r20, 1
        brcs    4f
        ld      r28, X+
        ld      r29, X+
        ldi     r25, 4
2:      ld      r22, Y
        ld      r23, Z
        cpse    r22, r23
        ldi     r24, 1
        sbrc    r18, 0
        mov     r23, r22
        st      Y+, r23
        st      Z+, r23
        dec     r25
        brne    2b
        rjmp    1b
4:      pop     r29
        pop     r28
        ret
