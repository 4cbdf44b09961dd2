; The interrupts of the serial port while it serves Modbus: a byte has come, the next may go, the last
; has gone. The checksum is built with each byte, both ways. Each takes about 100 cycles, the last 15, and
; the first byte of a frame 30 more.
;
; PORT_FRAME is where the frame stands, PORT_AT how many bytes of it have come or gone, 255 at most, PORT_OVER
; how many came behind these, PORT_END how many are to go, before the checksum. Timer 2 runs since the last
; byte that has come; its flag OCF2A says that a frame has ended: the next byte begins another, unless that
; frame is for this server and waits for a scan to end.

        .text

; A byte has come.
        interrupt_received
        push    r24
        in      r24, 0x3f       ; SREG
        push    r24
        push    r25
        push    r30
        push    r31
        lds     r24, 0xC0       ; UCSR0A, of the byte that is read next
        lds     r25, 0xC6       ; UDR0
        sbis    0x17, 1         ; OCF2A: there was silence, a frame begins
        rjmp    1f
        push    r24
        rcall   port_is_ours
        tst     r24
        pop     r24
        brne    port_done       ; it waits to be taken
        ldi     r30, 0
        sts     PORT_AT, r30
        sts     PORT_OVER, r30
        ldi     r30, 0xFF
        sts     PORT_CRC, r30
        sts     PORT_CRC+1, r30
1:      ldi     r30, 0
        sts     0xB2, r30       ; TCNT2: the silence begins anew
        ldi     r30, 1 << 1
        out     0x17, r30       ; OCF2A
        andi    r24, 0x1C       ; FE0, DOR0, UPE0
        brne    port_broken
        lds     r24, PORT_AT
        inc     r24
        breq    port_full
        sts     PORT_AT, r24
        dec     r24
        rcall   port_place
        st      Z, r25
port_take:
        rcall   port_check
        rjmp    port_done
port_full:                      ; byte 256 is the last of the checksum, and needs no place
        lds     r24, PORT_OVER
        inc     r24
        sts     PORT_OVER, r24
        cpi     r24, 1
        breq    port_take       ; another one is too many
port_broken:
        ldi     r24, 2
        sts     PORT_OVER, r24
        rjmp    port_done

; The next byte may go.
        interrupt_may_send
        push    r24
        in      r24, 0x3f       ; SREG
        push    r24
        push    r25
        push    r30
        push    r31
        lds     r24, PORT_AT
        lds     r30, PORT_END
        cp      r24, r30
        brsh    port_sum
        rcall   port_place
        ld      r25, Z
        sts     0xC6, r25       ; UDR0
        inc     r24
        sts     PORT_AT, r24
        rcall   port_check
port_done:
        pop     r31
        pop     r30
        pop     r25
        pop     r24
        out     0x3f, r24
        pop     r24
        reti

port_sum:
        brne    port_last
        lds     r25, PORT_CRC
        sts     0xC6, r25
        inc     r24
        sts     PORT_AT, r24
        rjmp    port_done
port_last:
        lds     r25, PORT_CRC+1
        sts     0xC6, r25
        ldi     r24, 0x42       ; TXC0 begins at 0; U2X0 stays
        sts     0xC0, r24
        ldi     r24, 0x48       ; TXCIE0, TXEN0
        sts     0xC1, r24       ; UCSR0B
        rjmp    port_done

; The last byte has gone: the bus is free, and the port listens.
        interrupt_sent
        push    r24
        direction_low
        ldi     r24, 0
        sts     PORT_AT, r24
        ldi     r24, 0x98       ; RXCIE0, RXEN0, TXEN0
        sts     0xC1, r24
        pop     r24
        reti

; Whether the frame that has ended is sound and for this server: r24. Called by `Serial::received` too.
; Uses Z.
        .global port_is_ours
port_is_ours:
        lds     r24, PORT_AT
        cpi     r24, 4          ; address, function and checksum
        brlo    1f
        lds     r24, PORT_OVER
        lsr     r24             ; one byte over is sound
        lds     r30, PORT_CRC
        or      r24, r30
        lds     r30, PORT_CRC+1
        or      r24, r30
        brne    1f
        lds     r30, PORT_FRAME
        lds     r31, PORT_FRAME+1
        ld      r24, Z
        tst     r24
        breq    2f              ; a broadcast
        lds     r30, 0xB4       ; OCR2B, the address: serial.rs
        cp      r24, r30
        breq    2f
1:      ldi     r24, 0
        ret
2:      ldi     r24, 1
        ret

; Z := where byte r24 of the frame stands.
port_place:
        lds     r30, PORT_FRAME
        lds     r31, PORT_FRAME+1
        add     r30, r24
        brcc    1f
        inc     r31
1:      ret

; Takes byte r25 into the checksum, as `unoclp_modbus::Crc` does: x is the byte xor the low half,
; p whether its bits are odd. The sum becomes (p:x:0) >> 1 xor (p:x:0) >> 2 xor the high half xor p.
; Uses r24, r25 and Z.
port_check:
        lds     r24, PORT_CRC
        eor     r25, r24
        mov     r24, r25
        swap    r24
        eor     r24, r25
        mov     r30, r24
        lsr     r24
        lsr     r24
        eor     r24, r30
        mov     r30, r24
        lsr     r24
        eor     r24, r30
        andi    r24, 1
        lds     r30, PORT_CRC+1
        eor     r30, r24
        lsr     r24
        ror     r25
        ror     r24
        eor     r30, r24
        mov     r31, r25
        lsr     r25
        ror     r24
        eor     r30, r24
        eor     r31, r25
        sts     PORT_CRC, r30
        sts     PORT_CRC+1, r31
        ret
