; REAL numbers, IEEE 754 single, in value and b. The rules are at the head of `rules.s`; on entry b is
; set. What is not finite becomes 0, an error. Sums, products and quotients are avr-libc's, by names
; that the compiler's own library does not have: it would take far more room.

        .if     REAL
; The library changes r18 to r27 and T, which stand in r8, r9 and r12 to r15 meanwhile.
real_subtract:
        ldi     r30, 0x80
        eor     r11, r30
real_add:
        ldi     r30, pm_lo8(__addsf3x)
        ldi     r31, pm_hi8(__addsf3x)
        rjmp    real_run
real_multiply:
        ldi     r30, pm_lo8(__mulsf3x)
        ldi     r31, pm_hi8(__mulsf3x)
        rjmp    real_run
real_divide:
        ldi     r30, pm_lo8(__divsf3x)
        ldi     r31, pm_hi8(__divsf3x)
real_run:
        movw    r12, r18
        mov     r14, r20
        bld     r15, 0
        movw    r18, r8
        movw    r20, r10
        movw    r8, r26
        clr     r26             ; no digits behind the 24
        clr     r27
        icall
        call    __fp_round
        movw    r18, r12
        mov     r20, r14
        bst     r15, 0
        movw    r26, r8
; Is the exponent 255?
real_check:
        movw    r30, r24
        lsl     r30
        rol     r31
        inc     r31
        brne    1f
real_error:
        rcall   no_quotient
1:      rjmp    back

; The root: half the exponent, and a digit of the mantissa at a time. r12 to r15 hold the digit that is
; tried and the one behind it, r8 to r11 the root with the latter.
real_root:
        mov     r21, r25
        lsl     r21
        or      r21, r24
        or      r21, r23
        or      r21, r22
        breq    1b              ; of -0 it is -0
        lsl     r24
        rol     r25
        brcs    real_error
        cpi     r25, 0xFF
        breq    real_error
        subi    r25, 1          ; carry: a subnormal, with the exponent of the least normal
        adc     r25, r1
        ror     r24
        subi    r24, 0x80       ; the first digit of the others
        mov     r30, r25
        clr     r25
        lsr     r30
        brcc    2f
        rcall   real_double
2:      cpi     r25, 0x20
        brcc    3f
        rcall   real_double
        rcall   real_double
        dec     r30
        rjmp    2b
3:      subi    r30, 0x100 - 68
        clr     r8
        clr     r9
        mov     r10, r8
        movw    r12, r8
        mov     r14, r8
        ldi     r21, 0x20
        mov     r11, r21
        ldi     r21, 0x60
        mov     r15, r21
4:      cp      r22, r8
        cpc     r23, r9
        cpc     r24, r10
        cpc     r25, r11
        brcs    5f
        sub     r22, r8
        sbc     r23, r9
        sbc     r24, r10
        sbc     r25, r11
        or      r8, r12
        or      r9, r13
        or      r10, r14
        or      r11, r15
5:      rcall   real_double
        lsr     r15
        ror     r14
        ror     r13
        ror     r12
        eor     r8, r12
        eor     r9, r13
        eor     r10, r14
        eor     r11, r15
        brcc    4b
        movw    r22, r8
        movw    r24, r10
        ori     r22, 1          ; a root is never a half
        clr     r31
        rjmp    real_pack

; value := value * 2.
real_double:
        lsl     r22
        rol     r23
        rol     r24
        rol     r25
        ret

; To an integer: the mantissa goes to the top of value, and right as the exponent says.
real_cut:
        clr     r31
        rjmp    1f
real_round:
        ldi     r31, 0xFF
1:      mov     r8, r25
        lsl     r24
        rol     r25
        sec
        ror     r24
        ldi     r30, 158        ; the exponent of bit 31
        sub     r30, r25
        brcs    6f
        mov     r9, r30
        cpi     r30, 34
        brcs    2f
        ldi     r30, 34         ; less than a quarter
2:      mov     r25, r24
        mov     r24, r23
        mov     r23, r22
        clr     r22
        clr     r21
3:      subi    r30, 1
        brcs    4f
        lsr     r25
        ror     r24
        ror     r23
        ror     r22
        ror     r21
        brcc    3b
        ori     r21, 1
        rjmp    3b
4:      and     r21, r31
        rcall   real_nearest
        sbrc    r8, 7
        rcall   negate
        tst     r9              ; from bit 31 on only the least fits
        brne    5f
        eor     r8, r25
        brpl    5f
6:      rcall   no_quotient
5:      rjmp    back

; From an integer: the highest bit goes to the top, and the lowest byte is the fraction.
real_from_unsigned:
        clr     r31
        rjmp    1f
real_from_signed:
        mov     r31, r25
        sbrc    r31, 7
        rcall   negate
1:      cp      r1, r22
        cpc     r1, r23
        cpc     r1, r24
        cpc     r1, r25
        breq    5b
        ldi     r30, 158        ; the exponent of bit 31
real_pack:
2:      tst     r25
        brmi    3f
        rcall   real_double
        dec     r30
        rjmp    2b
3:      mov     r21, r22
        mov     r22, r23
        mov     r23, r24
        mov     r24, r25
        lsl     r24
        lsl     r31
        ror     r30
        ror     r24
        mov     r25, r30
        rcall   real_nearest
        rjmp    back

; Rounds value by the fraction in r21, halves to even.
real_nearest:
        mov     r0, r22
        lsr     r0
        ldi     r30, 0x7F
        adc     r21, r30
        adc     r22, r1
        adc     r23, r1
        adc     r24, r1
        adc     r25, r1
        ret

; Sign and magnitude become a two's complement, in the same order.
real_comparable:
        sbrs    r25, 7
        rjmp    1f
        subi    r25, 0x80
        rcall   negate
1:      rjmp    back
        .endif
