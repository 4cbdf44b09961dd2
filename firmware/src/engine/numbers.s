; Operands, and arithmetic. The rules are at the head of `rules.s`.

; a * b, of two bytes, in r1:r0. The assembler is told of a chip without it, hence the word.
.macro  mul_    a, b
        .word   0x9C00 + ((\b & 16) << 5) + (\a << 4) + (\b & 15)
.endm

; Z := the next operand, an address. Where acc = 0, the handler that asks where to store ends here.
where:
        rcall   address
        brts    1f
        pop     r0
        pop     r0
        .if     WIDE            ; an address in flash has three bytes
        pop     r0
        .endif
        rjmp    back
address:
        ld      r31, X+
        ld      r30, X+
1:      ret

; r21 := the byte at the next operand.
byte:
        rcall   address
        ld      r21, Z
        ret

; r21 := the byte at the next operand, which becomes acc.
edge:
        rcall   byte
        clr     r0
        bld     r0, 0
        st      Z, r0
        ret

; b := the four bytes at Z.
load_b:
        ld      r8, Z
        ldd     r9, Z+1
        ldd     r10, Z+2
        ldd     r11, Z+3
        ret
load_b_behind:
        ldd     r8, Z+1
        ldd     r9, Z+2
        ldd     r10, Z+3
        ldd     r11, Z+4
        ret
store_b:
        st      Z, r8
        std     Z+1, r9
        std     Z+2, r10
        std     Z+3, r11
        ret

; b := the next two bytes, with a sign.
short:
        ld      r8, X+
        ld      r9, X+
extend:
        clr     r10
        sbrc    r9, 7
        com     r10
        mov     r11, r10
        ret

; Compares value with b.
compare_b:
        cp      r22, r8
        cpc     r23, r9
        cpc     r24, r10
        cpc     r25, r11
        ret

; b := value shifted right by the next operand.
shift_right:
        movw    r8, r22
        movw    r10, r24
        ld      r21, X+
        rjmp    2f
1:      lsr     r11
        ror     r10
        ror     r9
        ror     r8
2:      subi    r21, 1
        brcc    1b
        ret

; value := -value.
negate:
        com     r25
        com     r24
        com     r23
        neg     r22
        sbci    r23, 0xFF
        sbci    r24, 0xFF
        sbci    r25, 0xFF
        ret

negate_b:
        ldi     r21, 0xFF
        com     r11
        com     r10
        com     r9
        neg     r8
        sbc     r9, r21
        sbc     r10, r21
        sbc     r11, r21
        ret

add_b:
        add     r22, r8
        adc     r23, r9
        adc     r24, r10
        adc     r25, r11
        ret

; value := value * b.
multiply:
        clr     r21
        mul_    22, 8
        movw    r12, r0
        mul_    23, 9
        movw    r14, r0
        mul_    22, 9
        add     r13, r0
        adc     r14, r1
        adc     r15, r21
        mul_    23, 8
        add     r13, r0
        adc     r14, r1
        adc     r15, r21
        mul_    22, 10
        add     r14, r0
        adc     r15, r1
        mul_    24, 8
        add     r14, r0
        adc     r15, r1
        mul_    22, 11
        add     r15, r0
        mul_    23, 10
        add     r15, r0
        mul_    24, 9
        add     r15, r0
        mul_    25, 8
        add     r15, r0
        clr     r1
        movw    r22, r12
        movw    r24, r14
        ret

; The same of numbers without signs. By 0: an error.
unsigned_modulo:
        rcall   unsigned_division
        movw    r22, r12
        movw    r24, r14
        rjmp    back
unsigned_divide:
        rcall   unsigned_division
        rjmp    back
unsigned_division:
        mov     r0, r8
        or      r0, r9
        or      r0, r10
        or      r0, r11
        breq    no_quotient
        rjmp    divide_unsigned

; value := value / b, c := the rest without its sign, which is bit 7 of r21. By 0: an error.
divide:
        mov     r0, r8
        or      r0, r9
        or      r0, r10
        or      r0, r11
        breq    no_quotient
        push    r25
        mov     r1, r25
        eor     r1, r11
        sbrc    r25, 7
        rcall   negate
        sbrc    r11, 7
        rcall   negate_b
        rcall   divide_unsigned
        sbrc    r1, 7
        rcall   negate
        clr     r1
        pop     r21
        ret

; The same without signs, in 640 cycles.
divide_unsigned:
        clr     r12
        clr     r13
        movw    r14, r12
        ldi     r21, 33
        rjmp    2f
1:      rol     r12
        rol     r13
        rol     r14
        rol     r15
        cp      r12, r8
        cpc     r13, r9
        cpc     r14, r10
        cpc     r15, r11
        brcs    2f
        sub     r12, r8
        sbc     r13, r9
        sbc     r14, r10
        sbc     r15, r11
2:      rol     r22
        rol     r23
        rol     r24
        rol     r25
        dec     r21
        brne    1b
        com     r22
        com     r23
        com     r24
        com     r25
        ret

; An error: value := 0, c := 0, and S 04 tells.
no_quotient:
        ldi     r21, 0x80
        sts     ENGINE_ERROR, r21
        clr     r12
        clr     r13
        movw    r14, r12
        movw    r22, r12
        movw    r24, r12
        ret

modulo:
        rcall   divide
        movw    r22, r12
        movw    r24, r14
        sbrc    r21, 7
        rcall   negate
        rjmp    back

; The root is r9:r8, the bit that is tried the one that r31:r30 has set but not the root's next; as the
; argument goes left, the bit goes right. When it falls out, 15 bits are known.
square_root:
        sbrs    r25, 7
        rjmp    1f
        rcall   no_quotient
        rjmp    back
1:      ldi     r31, 0xC0
        ldi     r30, 0
        ldi     r21, 0x40
        mov     r9, r21
        sub     r8, r8
2:      brcs    3f
        cp      r24, r8
        cpc     r25, r9
        brcs    4f
3:      sub     r24, r8
        sbc     r25, r9
        or      r8, r30
        or      r9, r31
4:      lsr     r31
        ror     r30
        eor     r9, r31
        eor     r8, r30
        rol     r22
        rol     r23
        rol     r24
        rol     r25
        sbrs    r22, 0
        rjmp    2b
        brcs    5f
        lsl     r23             ; half a bit of the argument
        cpc     r8, r24
        cpc     r9, r25
        brcc    6f
5:      inc     r8
6:      movw    r22, r8
        rjmp    word_value

        .if     WIDE
; Outputs 01 to 08: those from 05 on are bits of their own.
load_outputs:
        mov     r22, r18
        swap    r22
        andi    r22, INPUTS
        lds     r21, OUTPUT_CELLS
        sbrc    r21, 7
        ori     r22, 1 << 4
        lds     r21, OUTPUT_CELLS+1
        sbrc    r21, 7
        ori     r22, 1 << 5
        lds     r21, OUTPUT_CELLS+2
        sbrc    r21, 7
        ori     r22, 1 << 6
        lds     r21, OUTPUT_CELLS+3
        sbrc    r21, 7
        ori     r22, 1 << 7
        rjmp    byte_value
store_outputs:
        ld      r21, X+         ; which there are
        ld      r8, X+
        brtc    1f
        mov     r30, r22
        swap    r30
        and     r21, r30
        andi    r18, INPUTS
        or      r18, r21
        and     r30, r8
        swap    r30
        sts     OUTPUT_CELLS+3, r30
        lsl     r30
        sts     OUTPUT_CELLS+2, r30
        lsl     r30
        sts     OUTPUT_CELLS+1, r30
        lsl     r30
        sts     OUTPUT_CELLS, r30
1:      rjmp    back
        .endif

; All inputs.
load_inputs:
        mov     r22, r18
        andi    r22, INPUTS
        lds     r21, ENGINE_MORE_INPUTS
        or      r22, r21
        rjmp    byte_value

; Eight markers from and to the low bits of value.
load_markers:
        rcall   address
        ldi     r21, 8
1:      ld      r0, Z+
        lsl     r0
        ror     r22
        dec     r21
        brne    1b
        rjmp    byte_value
store_markers:
        rcall   where
        mov     r0, r22
        ldi     r21, 8
1:      clr     r8
        lsr     r0
        ror     r8
        st      Z+, r8
        dec     r21
        brne    1b
        rjmp    back

store_pwm:
        rcall   where
        mov     r21, r23
        or      r21, r24
        or      r21, r25
        brne    2f
        mov     r21, r22
        rjmp    3f
2:      ldi     r21, 0xFF
        sbrc    r25, 7
        clr     r21
3:      st      Z, r21
        rjmp    back

; The bytes are copied from the end that is not overwritten.
move:
        ld      r9, X+
        ld      r8, X+
        rcall   address
        ld      r21, X+
        brtc    3f
        movw    r10, r26
        movw    r26, r8         ; from X to Z
        cp      r26, r30
        cpc     r27, r31
        brcs    2f
1:      ld      r0, X+
        st      Z+, r0
        dec     r21
        brne    1b
        rjmp    4f
2:      add     r26, r21
        adc     r27, r1
        add     r30, r21
        adc     r31, r1
5:      ld      r0, -X
        st      -Z, r0
        dec     r21
        brne    5b
4:      movw    r26, r10
3:      rjmp    back

; How many steps, then each.
drum:
        rcall   address
        rcall   load_b
        ld      r0, X+
        movw    r30, r26        ; the first
        add     r26, r0
        adc     r27, r1
        clr     r21
        cp      r8, r0
        cpc     r9, r1
        cpc     r10, r1
        cpc     r11, r1
        brcc    1f
        add     r30, r8
        adc     r31, r1
        ld      r21, Z
1:      rjmp    outputs

; Four bounds, low bytes first.
scale:
        rcall   short           ; of what comes, the lower
        rcall   compare_b
        brge    1f
        movw    r22, r8
        movw    r24, r10
1:      movw    r12, r8
        rcall   short           ; and the upper
        rcall   compare_b
        brlt    2f
        movw    r22, r8
2:      sub     r22, r12        ; by how much value exceeds the lower, 16 bits
        sbc     r23, r13
        clr     r24
        clr     r25
        sub     r8, r12         ; the span, 16 bits
        sbc     r9, r13
        push    r8
        push    r9
        rcall   short           ; what the lower becomes
        push    r8
        push    r9
        movw    r12, r8
        movw    r14, r10
        rcall   short           ; and the upper
        sub     r8, r12
        sbc     r9, r13
        sbc     r10, r14
        sbc     r11, r15
        mov     r30, r11
        sbrc    r11, 7
        rcall   negate_b
        rcall   multiply
        pop     r31
        pop     r0
        pop     r9
        pop     r8
        clr     r10
        clr     r11
        rcall   divide_unsigned
        mov     r8, r0
        mov     r9, r31
        sbrc    r30, 7
        rcall   negate
        rcall   extend
        rcall   add_b
        rjmp    back

; Its data is whether it has begun, a time stamp, and the smoothed value times 256.
filter:
        rcall   address
        ld      r14, X+         ; strength
        ld      r12, X+         ; time
        ld      r13, X+
        cpi     r24, 0x40       ; value times 256, cut to 31 bits
        ldi     r21, 0
        cpc     r25, r21
        brlt    1f
        ldi     r24, 0x3F
        ldi     r23, 0xFF
        ldi     r22, 0xFF
        rjmp    2f
1:      cpi     r24, 0xC0
        ldi     r21, 0xFF
        cpc     r25, r21
        brge    2f
        ldi     r24, 0xC0
        ldi     r23, 0
        ldi     r22, 0
2:      mov     r25, r24
        mov     r24, r23
        mov     r23, r22
        clr     r22
        ld      r21, Z
        tst     r21
        breq    5f              ; it begins: the value as it is
        rcall   elapsed
        cp      r8, r12
        cpc     r9, r13
        cpc     r10, r1
        cpc     r11, r1
        rcall   load_sum
        brcs    6f
        rcall   subtract_b
3:      asr     r25
        ror     r24
        ror     r23
        ror     r22
        dec     r14
        brne    3b
        rcall   add_b
5:      rcall   stamp
        ldi     r21, 1
        st      Z, r21
        std     Z+5, r22
        std     Z+6, r23
        std     Z+7, r24
        std     Z+8, r25
        movw    r8, r22
        movw    r10, r24
6:      ldi     r21, 0x80       ; rounded
        add     r8, r21
        adc     r9, r1
        adc     r10, r1
        adc     r11, r1
        mov     r22, r9
        mov     r23, r10
        mov     r24, r11
        clr     r25
        sbrc    r24, 7
        com     r25
        rjmp    back
load_sum:
        ldd     r8, Z+5
        ldd     r9, Z+6
        ldd     r10, Z+7
        ldd     r11, Z+8
        ret
subtract_b:
        sub     r22, r8
        sbc     r23, r9
        sbc     r24, r10
        sbc     r25, r11
        ret

; The time stamp at Z+1 is that of this scan.
stamp:
        std     Z+1, r2
        std     Z+2, r3
        std     Z+3, r4
        std     Z+4, r5
        ret

; Its data is whether it ran, a time stamp, and the thousandths that are left; then its register.
integrate:
        rcall   edge            ; r21: whether it ran
        mov     r15, r21
        rcall   elapsed
        rcall   stamp
        brtc    9f
        sbrs    r15, 0
9:      rjmp    8f
        push    r22
        push    r23
        push    r24
        push    r25
        mov     r21, r10        ; the time is cut to 15 bits
        or      r21, r11
        brne    1f
        sbrs    r9, 7
        rjmp    2f
1:      ldi     r21, 0xFF
        mov     r8, r21
        mov     r9, r21
        lsr     r9
        clr     r10
        clr     r11
2:      mov     r21, r23        ; and value to 16 with its sign
        lsl     r21
        sbc     r21, r21        ; what the upper bytes are then
        cp      r24, r21
        cpc     r25, r21
        breq    3f
        ldi     r22, 0xFF
        ldi     r23, 0x7F
        sbrs    r25, 7
        rjmp    4f
        com     r22
        com     r23
4:      clr     r24
        sbrc    r25, 7
        com     r24
        mov     r25, r24
3:      rcall   multiply
        ldd     r8, Z+5
        ldd     r9, Z+6
        rcall   extend
        rcall   add_b
        ldi     r21, 1000 & 0xFF
        mov     r8, r21
        ldi     r21, 1000 >> 8
        mov     r9, r21
        clr     r10
        clr     r11
        rcall   divide
        sbrs    r21, 7
        rjmp    4f
        com     r13             ; the rest has the sign of the sum
        neg     r12
        brcs    4f
        inc     r13
4:      std     Z+5, r12
        std     Z+6, r13
        rcall   address
        rcall   load_b
        rcall   add_b
        movw    r8, r22
        movw    r10, r24
        rcall   store_b
        pop     r25
        pop     r24
        pop     r23
        pop     r22
        rjmp    back
8:      adiw    r26, 2
        rjmp    back

; Nothing reads these bytes: the linker refuses them, as "relocation truncated to fit: R_AVR_8", where
; the handlers do not begin in the words that they are to.
        .type   engine_pages_fit, @object
engine_pages_fit:
        .byte   first_page_end - 257 - 0x200 * (NEAR - 2)
        .byte   more_page_end - 769 - 0x200 * (NEAR - 2)
        .byte   engine_page_end - 1281 - 0x200 * (NEAR - 2)
        .size   engine_pages_fit, . - engine_pages_fit
        .text
