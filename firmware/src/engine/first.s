; The handlers that begin in the words before 0x100, behind the interrupt vectors, reached by an escape. Their rules
; are at the head of `rules.s`; they end by going `back`.

        .section .progmem.gcc.engine, "ax", @progbits
        .space  0x200 * (NEAR - 2) - VECTORS * (NEAR - 2)
engine_first_page:

; REAL numbers. Where the board has none the loader refuses them, and their labels are those of what comes next.
        .if     REAL
engine_real_add:
        rjmp    real_add
engine_real_subtract:
        rjmp    real_subtract
engine_real_multiply:
        rjmp    real_multiply
engine_real_divide:
        rjmp    real_divide
engine_real_root:
        rjmp    real_root
engine_real_from_signed:
        rjmp    real_from_signed
engine_real_from_unsigned:
        rjmp    real_from_unsigned
engine_real_round:
        rjmp    real_round
engine_real_cut:
        rjmp    real_cut
engine_real_comparable:
        rjmp    real_comparable
engine_real_absolute:
        andi    r25, 0x7F
        rjmp    real_check
engine_real_negate:
        subi    r25, 0x80
        rjmp    real_check
        .else
engine_real_add:
engine_real_subtract:
engine_real_multiply:
engine_real_divide:
engine_real_root:
engine_real_from_signed:
engine_real_from_unsigned:
engine_real_round:
engine_real_cut:
engine_real_comparable:
engine_real_absolute:
engine_real_negate:
        .endif

; Numbers without signs.
engine_unsigned_divide:
        rjmp    unsigned_divide
engine_unsigned_modulo:
        rjmp    unsigned_modulo
engine_unsigned_greater_or_equal:
        rcall   compare_b
        brcc    1f
        clt
1:      rjmp    back
engine_unsigned_less:
        rcall   compare_b
        brcs    1b
        clt
        rjmp    back

; What is pushed stands on the stack.
engine_push:
        push    r25
        push    r24
        push    r23
        push    r22
        rjmp    back

; The low bits of value, as many as the next byte says. b becomes 1 in those, and c the highest of them.
engine_extend_zero:
        rcall   low_bits
        rjmp    back
engine_extend_sign:
        rcall   low_bits
        eor     r22, r12
        eor     r23, r13
        eor     r24, r14
        eor     r25, r15
        sub     r22, r12
        sbc     r23, r13
        sbc     r24, r14
        sbc     r25, r15
        rjmp    back
low_bits:
        ld      r21, X+
        clr     r8
        clr     r9
        movw    r10, r8
        movw    r12, r8
        movw    r14, r8
1:      subi    r21, 1
        brcs    2f
        movw    r12, r8
        movw    r14, r10
        sec
        rol     r8
        rol     r9
        rol     r10
        rol     r11
        rjmp    1b
2:      eor     r12, r8
        eor     r13, r9
        eor     r14, r10
        eor     r15, r11
        and     r22, r8
        and     r23, r9
        and     r24, r10
        and     r25, r11
        ret

; Tables: how many registers, then the address of the first.
engine_load_table:
        movw    r8, r22
        movw    r10, r24
        clr     r22
        clr     r23
        movw    r24, r22
        rcall   table
        brcc    1f
        ld      r22, Z
        ldd     r23, Z+1
        ldd     r24, Z+2
        ldd     r25, Z+3
1:      rjmp    back
engine_store_table:
        pop     r8
        pop     r9
        pop     r10
        pop     r11
        brtc    2f
        rcall   table
        brcc    3f
        std     Z+3, r25
        std     Z+2, r24
        std     Z+1, r23
        st      Z, r22
3:      rjmp    back
2:      adiw    r26, 3
        rjmp    back
; Z := the address of the register with the index b. C: there is one, else an error.
table:
        ld      r21, X+
        ld      r31, X+
        ld      r30, X+
        cp      r8, r21
        cpc     r9, r1
        cpc     r10, r1
        cpc     r11, r1
        brcc    1f
        lsl     r8
        rol     r9
        lsl     r8
        rol     r9
        add     r30, r8
        adc     r31, r9
        sec
        ret
1:      ldi     r21, 0x80
        sts     ENGINE_ERROR, r21
        clc
        ret
