; The handlers that begin in words 0x100 to 0x1FF, reached by an escape. Their rules are at the head of
; `rules.s`; they end by going `back`.

first_page_end:
        .space  0x200 - VECTORS * (3 - NEAR) - (first_page_end - engine_first_page)
engine_more_page:

; Logic.
engine_close_xor:
        lsr     r19
        brcs    engine_not
        rjmp    back
engine_not:
        brts    1f
        set
        rjmp    back
1:      clt
        rjmp    back
engine_close_and:
        sbrs    r19, 0
        clt
        lsr     r19
        rjmp    back
engine_rise:
        rcall   edge
        sbrc    r21, 0
        clt
        rjmp    back
engine_fall:
        rcall   edge
        brts    1b
        bst     r21, 0
        rjmp    back

; Exclusive OR with an image, by a mask, or with a bit by address.
engine_xor:
        ld      r21, X+
        and     r21, r18
        brne    engine_not
        rjmp    back
engine_xor_not:
        ld      r21, X+
        and     r21, r18
        breq    engine_not
        rjmp    back
engine_xor_cell:
        rcall   byte
        sbrc    r21, 7
        rjmp    engine_not
        rjmp    back
engine_xor_cell_not:
        rcall   byte
        sbrs    r21, 7
        rjmp    engine_not
        rjmp    back

; Coils: negated of an output, by a mask; the others of a bit by address.
engine_coil_not:
        ld      r21, X+
        or      r18, r21
        brtc    1f
        eor     r18, r21
1:      rjmp    back
engine_cell_coil_not:
        rcall   address
        brts    zero_1
        rjmp    one
engine_cell_set:
        rcall   where
one:    ldi     r21, 0x80
        st      Z, r21
        rjmp    back
engine_cell_reset:
        rcall   where
        rjmp    zero_1

; Timers and counters. One that is reset has no state, and nothing that has elapsed.
engine_reset_timer:
        rcall   where
        st      Z+, r1
        rjmp    zero_4
engine_reset_counter:
        rcall   where
zero_4: std     Z+3, r1
        std     Z+2, r1
        std     Z+1, r1
zero_1: st      Z, r1
        rjmp    back
engine_load_counter:
        rcall   where
        adiw    r30, 4
        rcall   load_b
        sbiw    r30, 4
        rcall   store_b
        rjmp    back

; Contacts of a counter.
engine_reached:
        rcall   address
        rcall   reached
        brge    3f
2:      clt
3:      rjmp    back
engine_reached_not:
        rcall   address
        rcall   reached
        brge    2b
        rjmp    back
engine_zero:
        rcall   address
        rcall   zero
        brlt    2b
        rjmp    back
engine_zero_not:
        rcall   address
        rcall   zero
        brge    2b
        rjmp    back

; Counters. Behind value and preset a byte has the INs as they were: bit 0 of CTU, bit 1 of CTD.
engine_count_up:
        rjmp    count_up
engine_count_down:
        rjmp    count_down

; Loads.
b_to_value:
        movw    r22, r8
        movw    r24, r10
        rjmp    back
engine_load_word:
        rcall   address
        ld      r22, Z
        ldd     r23, Z+1
        rjmp    word_value
engine_load_inputs:
        rjmp    load_inputs
engine_load_outputs:
        .if     WIDE
        rjmp    load_outputs
        .else
        mov     r22, r18
        swap    r22
        andi    r22, INPUTS
        rjmp    byte_value
        .endif
engine_load_bit:
        clr     r22
        bld     r22, 0
        rjmp    byte_value
engine_load_markers:
        rjmp    load_markers
byte_value:
        clr     r23
word_value:
        clr     r24
        clr     r25
        rjmp    back
engine_load_timer:
        rjmp    load_timer

; Stores, where acc = 1.
engine_preset:
        rcall   where
        sbrc    r25, 7
        rjmp    zero_4
        rjmp    1f
engine_store:
        rcall   where
1:      std     Z+3, r25
        std     Z+2, r24
        std     Z+1, r23
        st      Z, r22
        rjmp    back
engine_store_pwm:
        rjmp    store_pwm
engine_store_markers:
        rjmp    store_markers
engine_store_outputs:
        .if     WIDE
        rjmp    store_outputs
        .else
        ld      r21, X+         ; which there are
        mov     r30, r22
        swap    r30
        and     r21, r30
        .endif
outputs:
        brtc    1f
        andi    r18, INPUTS
        or      r18, r21
1:      rjmp    back

; Operations.
engine_negate:
        rcall   negate
        rjmp    back
engine_and:
        and     r22, r8
        and     r23, r9
        and     r24, r10
        and     r25, r11
        rjmp    back
engine_or:
        or      r22, r8
        or      r23, r9
        or      r24, r10
        or      r25, r11
        rjmp    back
engine_exor:
        eor     r22, r8
        eor     r23, r9
        eor     r24, r10
        eor     r25, r11
        rjmp    back
engine_multiply:
        rcall   multiply
        rjmp    back
engine_divide:
        rcall   divide
        rjmp    back
engine_modulo:
        rjmp    modulo
engine_square_root:
        rjmp    square_root

; Bits of value.
engine_shift_left:
        ld      r21, X+
        rjmp    2f
1:      lsl     r22
        rol     r23
        rol     r24
        rol     r25
2:      subi    r21, 1
        brcc    1b
        rjmp    back
engine_shift_right:
        rcall   shift_right
        rjmp    b_to_value
engine_bit:
        rcall   shift_right
        sbrs    r8, 0
        clt
        rjmp    back
engine_bit_not:
        rcall   shift_right
        sbrc    r8, 0
        clt
        rjmp    back

; Comparisons.
engine_greater:
        rcall   compare_b
        breq    4f
        rjmp    1f
engine_greater_or_equal:
        rcall   compare_b
1:      brlt    4f
        rjmp    back
engine_less_or_equal:
        rcall   compare_b
        breq    5f
        rjmp    2f
engine_less:
        rcall   compare_b
2:      brge    4f
        rjmp    back
engine_equal:
        rcall   compare_b
        brne    4f
        rjmp    back
engine_not_equal:
        rcall   compare_b
        brne    5f
4:      clt
5:      rjmp    back

; Others.
engine_pulse:
        rjmp    pulse
engine_retentive:
        rjmp    retentive
engine_move:
        rjmp    move
engine_drum:
        rjmp    drum
engine_scale:
        rjmp    scale
engine_filter:
        rjmp    filter
engine_integrate:
        rjmp    integrate

; A label sets what a jump has passed over: acc, and which timer is next.
engine_label:
        set
engine_timer:
        ld      r29, X+
        ld      r28, X+
        rjmp    back
; A timer is called again: its preset, the high byte first, then its address. The handler of its kind follows, and then
; which timer is next.
engine_again:
        ld      r11, X+
        ld      r10, X+
        ld      r9, X+
        ld      r8, X+
        ld      r29, X+
        ld      r28, X+
        std     Y+5, r8
        std     Y+6, r9
        std     Y+7, r10
        std     Y+8, r11
        rjmp    back
engine_jump:
        rcall   where
        movw    r26, r30
        rjmp    back
engine_jump_not:
        rcall   address
        brts    1f
        movw    r26, r30
1:      rjmp    back
engine_jump_back_not:
        brtc    jump_back
        rjmp    no_jump_back
engine_jump_back:
        brts    jump_back
no_jump_back:
        adiw    r26, 6
        rjmp    back
engine_return:
        brts    1f
        rjmp    back
engine_return_not:
        brtc    1f
        rjmp    back
1:      end_scan

; A jump back has its cost behind its target, then its line, low bytes first.
jump_back:
        rcall   address
        lds     r8, ENGINE_BUDGET
        lds     r9, ENGINE_BUDGET+1
        ld      r21, X+
        sub     r8, r21
        ld      r21, X+
        sbc     r9, r21
        sts     ENGINE_BUDGET, r8
        sts     ENGINE_BUDGET+1, r9
        brcs    1f
        movw    r26, r30
        rjmp    back
1:      ld      r21, X+
        sts     ENGINE_LINE, r21
        ld      r21, X+
        sts     ENGINE_LINE+1, r21
        andi    r18, INPUTS
        end_scan

more_page_end:

