; Timers. Their rules are at the head of `rules.s`.

; A timer's data is its state, a time, low byte first, and its preset. Bits 0 and 1 of the state are its
; phase: 0 idle, 1 timing, 2 done; bit 7 is Q. While it is timing, the time is the time stamp of the
; scan that began the delay. Else it is what has elapsed, so that the elapsed time of any timer is told
; by its data alone; where that is the preset, whatever it is, it is the highest number.
;
; IN is acc when the block is reached, Q is acc behind it.
on_delay:
        brtc    settled
        ld      r30, Y
        lsr     r30             ; C: timing; Z: idle
        brcs    timing
        brne    passed
        rjmp    start
off_delay:
        brts    settled
        ld      r30, Y
        lsr     r30
        brcs    timing
        breq    passed
start:  std     Y+1, r2
        std     Y+2, r3
        std     Y+3, r4
        std     Y+4, r5
timing:
        rcall   still_timing
        brcc    over
; The delay goes on: Q = NOT IN.
        bld     r30, 7
        com     r30
        bst     r30, 7
        andi    r30, 0x80
        inc     r30
        st      Y, r30
        rjmp    passed
; The delay is over: Q = IN, and the phase follows.
over:   ldi     r30, 0xFF
        brts    1f
settled:
        ldi     r30, 0
1:      std     Y+1, r30
        std     Y+2, r30
        std     Y+3, r30
        std     Y+4, r30
        ldi     r30, 0
        bld     r30, 1
        bld     r30, 7
state:  st      Y, r30
passed: adiw    r28, TIMER_DATA
        ldi     r31, NEAR
        next

; TP is done where the pulse is over and IN is still 1.
pulse:
        ld      r30, Y
        lsr     r30
        brcs    1f
        brne    2f
        brtc    2f
        std     Y+1, r2
        std     Y+2, r3
        std     Y+3, r4
        std     Y+4, r5
1:      rcall   still_timing
        brcc    2f
        set
        ldi     r30, 0x81
        rjmp    state
2:      ldi     r30, 0xFF
        brts    3f
        ldi     r30, 0
3:      std     Y+1, r30
        std     Y+2, r30
        std     Y+3, r30
        std     Y+4, r30
        ldi     r30, 0
        bld     r30, 1
        clt
        rjmp    state

; TOR keeps what it has gathered as its time while IN is 0.
retentive:
        ld      r30, Y
        lsr     r30
        brcs    2f
        brne    3f
        brtc    passed
        rcall   turn
1:      rcall   still_timing
        brcc    over
        clt
        ldi     r30, 1
        rjmp    state
2:      brts    1b
        rcall   turn
        ldi     r30, 0
        rjmp    state
3:      set
        rjmp    passed

; Of the timer at Y: from a time stamp to the time since then, and back.
turn:
        movw    r30, r28
        rcall   elapsed
        std     Y+1, r8
        std     Y+2, r9
        std     Y+3, r10
        std     Y+4, r11
        ret

; C: less than its preset has elapsed of the timer at Y.
still_timing:
        movw    r30, r28
        rcall   elapsed
        ldd     r21, Y+5
        cp      r8, r21
        ldd     r21, Y+6
        cpc     r9, r21
        ldd     r21, Y+7
        cpc     r10, r21
        ldd     r21, Y+8
        cpc     r11, r21
        ret

; b := the time since the time stamp at Z+1.
elapsed:
        movw    r8, r2
        movw    r10, r4
        ldd     r21, Z+1
        sub     r8, r21
        ldd     r21, Z+2
        sbc     r9, r21
        ldd     r21, Z+3
        sbc     r10, r21
        ldd     r21, Z+4
        sbc     r11, r21
        ret

load_timer:
        rcall   address
        rcall   elapsed
        ld      r21, Z
        sbrs    r21, 0
        rcall   load_b_behind
        ldd     r22, Z+5
        ldd     r23, Z+6
        ldd     r24, Z+7
        ldd     r25, Z+8
        rcall   compare_b
        brcs    1f
        rjmp    b_to_value
1:      rjmp    back
