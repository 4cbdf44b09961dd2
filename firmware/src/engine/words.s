; Words of values of 32 bits, as Modbus has them, read or written in a row.
;
; In assembly because a scan waits for it: 20 cycles a word, 35 of what has elapsed.
;
;   r25:r24  the words, the high byte first; X from here on
;   r23:r22  the first value, low byte first; Z from here on
;   r21:r20  behind the last value: what is asked for there is 0, and takes nothing
;   r18      how many words
;   r16      bytes from a value to the next
;   r14      bit 0: the first word is a low one
;   r12      WORDS_WRITTEN, WORDS_ELAPSED: the values are timers, and what has elapsed of them is read
;   r11-r8   the time, ms

        .section .text.engine_words, "ax", @progbits
        .global engine_words
        .type   engine_words, @function
engine_words:
        movw    r26, r24
        movw    r30, r22
        bst     r14, 0
words_value:
        cp      r30, r20
        cpc     r31, r21
        brcc    3f
        sbrc    r12, WORDS_WRITTEN
        rjmp    words_write
        sbrc    r12, WORDS_ELAPSED
        rjmp    1f
        ld      r22, Z
        ldd     r23, Z+1
        ldd     r24, Z+2
        ldd     r25, Z+3
        rjmp    4f
1:      ldd     r22, Z+1
        ldd     r23, Z+2
        ldd     r24, Z+3
        ldd     r25, Z+4
        ld      r0, Z
        sbrs    r0, 0           ; it stands
        rjmp    2f
        com     r22             ; since when it runs: the time less that
        com     r23
        com     r24
        com     r25             ; sets the carry
        adc     r22, r8
        adc     r23, r9
        adc     r24, r10
        adc     r25, r11
2:      ldd     r0, Z+5         ; its preset at most
        cp      r22, r0
        ldd     r0, Z+6
        cpc     r23, r0
        ldd     r0, Z+7
        cpc     r24, r0
        ldd     r0, Z+8
        cpc     r25, r0
        brcs    4f
        ldd     r22, Z+5
        ldd     r23, Z+6
        ldd     r24, Z+7
        ldd     r25, Z+8
        rjmp    4f
3:      sbrc    r12, WORDS_WRITTEN
        ret
        clr     r22
        clr     r23
        movw    r24, r22
4:      brts    5f
        subi    r18, 1
        brcs    7f
        st      X+, r25
        st      X+, r24
5:      subi    r18, 1
        brcs    7f
        st      X+, r23
        st      X+, r22
6:      clt
        add     r30, r16
        adc     r31, r1
        rjmp    words_value
7:      ret

words_write:
        brts    1f
        subi    r18, 1
        brcs    7b
        ld      r0, X+
        std     Z+3, r0
        ld      r0, X+
        std     Z+2, r0
1:      subi    r18, 1
        brcs    7b
        ld      r0, X+
        std     Z+1, r0
        ld      r0, X+
        st      Z, r0
        rjmp    6b
        .text
