; The interrupt of each millisecond. It takes its cycles from the scans: 33 in 255 of 256 cases, from
; the end of an instruction of the scan to the beginning of the next, and 41 at most.

        .text
        interrupt_tick
        push    r24
        in      r24, 0x3f       ; SREG
        push    r24

        lds     r24, MILLIS     ; the clock goes on
        inc     r24
        sts     MILLIS, r24
        breq    carry

age:    lds     r24, AGE        ; the scan grows older; at 255 it stays
        inc     r24
        breq    done
        sts     AGE, r24

done:   pop     r24
        out     0x3f, r24
        pop     r24
        reti

carry:  lds     r24, MILLIS+1
        inc     r24
        sts     MILLIS+1, r24
        brne    age
        lds     r24, MILLIS+2
        inc     r24
        sts     MILLIS+2, r24
        brne    age
        lds     r24, MILLIS+3
        inc     r24
        sts     MILLIS+3, r24
        rjmp    age
