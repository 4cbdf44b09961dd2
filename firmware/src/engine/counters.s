; Counters, in the room that the first handlers leave. Their rules are at the head of `rules.s`.

count_up:
        rcall   address
        ldd     r21, Z+8
        mov     r0, r21
        bld     r21, 0
        std     Z+8, r21
        brtc    1f
        sbrc    r0, 0
        rjmp    1f
        rcall   load_b
        sec
        adc     r8, r1
        adc     r9, r1
        adc     r10, r1
        adc     r11, r1
        brvs    1f
        rcall   store_b
1:      rcall   reached
        rjmp    2f
count_down:
        rcall   address
        ldd     r21, Z+8
        mov     r0, r21
        bld     r21, 1
        std     Z+8, r21
        brtc    1f
        sbrc    r0, 1
        rjmp    1f
        rcall   load_b
        sec
        sbc     r8, r1
        sbc     r9, r1
        sbc     r10, r1
        sbc     r11, r1
        brvs    1f
        rcall   store_b
1:      rcall   zero
2:      set
        brge    3f
        clt
3:      rjmp    back

; Of the counter at Z: S is 0 where it has reached its preset, or where it is 0 or less.
reached:
        rcall   load_b
        ldd     r21, Z+4
        cp      r8, r21
        ldd     r21, Z+5
        cpc     r9, r21
        ldd     r21, Z+6
        cpc     r10, r21
        ldd     r21, Z+7
        cpc     r11, r21
        ret
zero:
        rcall   load_b
        cp      r1, r8
        cpc     r1, r9
        cpc     r1, r10
        cpc     r1, r11
        ret
