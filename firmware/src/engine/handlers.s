; The handlers of the engine. Linked code is a row of bytes, each the word address of a handler:
; whatever a handler has to do, it ends by going to that of the next byte. So all of them must
; begin in the first 256 words of flash. avr-gcc's linker script puts `.progmem.gcc*` right behind
; the interrupt vectors; the last lines check that they fit.
;
; A handler may change nothing but
;
;   T        acc (NC-6)
;   r18      the images: inputs 01-04 in bits 0-3, outputs 01-04 in bits 4-7
;   r19      acc of each open branch as it was when the branch opened, the innermost in bit 0
;   r20      the branch points of the rung
;   r0, r21  scratch
;   X        the linked byte after the next
;   Y        the data of the next timer
;   Z        r30: scratch, and the low byte of the address to go to; r31: 0
;   SREG     all other flags
;
; and reads the time stamp of the scan, r22 to r25. r1 is 0 between handlers.

; Goes on to the next linked byte: 4 cycles.
.macro  next
        ld      r30, X+
        ijmp
.endm

        .section .progmem.gcc.engine, "ax", @progbits

; Contacts, by bit of the images. 6 cycles, both ways.
        .global engine_contact, engine_contact_not
engine_contact:
.irp    bit, 0, 1, 2, 3, 4, 5, 6, 7
        sbrs    r18, \bit
        clt
        next
.endr
engine_contact_not:
.irp    bit, 0, 1, 2, 3, 4, 5, 6, 7
        sbrc    r18, \bit
        clt
        next
.endr

; A row of contacts. Two bytes follow: the points that it asks for, and how they must be. 11 cycles.
        .global engine_contacts
engine_contacts:
        ld      r21, X+
        and     r21, r18
        ld      r30, X+
        cpse    r21, r30
        clt
        next

; Coils, by output. 5 cycles; with a new rung behind it 6.
        .global engine_coil, engine_coil_new_rung
engine_coil:
.irp    bit, 4, 5, 6, 7
        bld     r18, \bit
        next
.endr
engine_coil_new_rung:
.irp    bit, 4, 5, 6, 7
        bld     r18, \bit
        set
        next
.endr

; Set and reset coils, by output. 6 cycles.
        .global engine_set_coil, engine_reset_coil
engine_set_coil:
.irp    bit, 4, 5, 6, 7
        brtc    1f
        ori     r18, 1 << \bit
1:      next
.endr
engine_reset_coil:
.irp    bit, 4, 5, 6, 7
        brtc    1f
        andi    r18, 0xFF - (1 << \bit)
1:      next
.endr

; Branch points, by number. 5 cycles.
        .global engine_store_branch, engine_recall_branch
engine_store_branch:
.irp    bit, 0, 1, 2, 3, 4, 5, 6, 7
        bld     r20, \bit
        next
.endr
engine_recall_branch:
.irp    bit, 0, 1, 2, 3, 4, 5, 6, 7
        bst     r20, \bit
        next
.endr

; 7 cycles.
        .global engine_open_branch, engine_close_branch
engine_open_branch:
        lsl     r19
        bld     r19, 0
        set
        next
engine_close_branch:
        sbrc    r19, 0
        set
        lsr     r19
        next

; 5 cycles.
        .global engine_new_rung
engine_new_rung:
        set
        next

; Timers. The preset follows, low byte first; then a coil.
        .global engine_on_delay, engine_off_delay
engine_on_delay:
        rjmp    on_delay
engine_off_delay:
        rjmp    off_delay

; The end of the code, and of the scan.
        .global engine_end, engine_page_end
engine_end:
        ret
engine_page_end:

; A timer's data is its phase (0 idle, 1 timing, 2 on), then the time stamp of the scan that began
; the delay, low byte first. IN is acc when the block is reached, Q is acc behind it. A phase other
; than timing, with Q = IN, is settled: TON idle at IN = 0 and on at 1, TOF on at 1 and idle at 0.
;
; All states take much the same time, 16 to 47 cycles; the coil comes on top.
on_delay:
        brtc    settled
        ld      r30, Y
        lsr     r30             ; C: timing; Z: idle
        brcs    timing
        brne    settled
        rjmp    start
off_delay:
        brts    settled
        ld      r30, Y
        lsr     r30
        brcs    timing
        breq    settled

start:
        std     Y+1, r22
        std     Y+2, r23
        std     Y+3, r24
        std     Y+4, r25
        ldi     r30, 1
        st      Y, r30
        ld      r30, X+         ; a preset of 0 is over at once
        ld      r0, X+
        or      r30, r0
        ld      r0, X+
        or      r30, r0
        ld      r0, X+
        or      r30, r0
        breq    over
; The delay goes on: Q = NOT IN.
waiting:
        bld     r30, 0
        com     r30
        bst     r30, 0
        adiw    r28, 5
        next

; Here C is 1, so that the subtraction gives since - now - 1: for an elapsed time of 32 bits the
; complement, to which the preset adds up to 2^32 or more where it is greater than that time.
timing:
        ldd     r0, Y+1
        sbc     r0, r22
        ldd     r1, Y+2
        sbc     r1, r23
        ldd     r30, Y+3
        sbc     r30, r24
        ldd     r31, Y+4
        sbc     r31, r25
        ld      r21, X+
        add     r0, r21
        ld      r21, X+
        adc     r1, r21
        ld      r21, X+
        adc     r30, r21
        ld      r21, X+
        adc     r31, r21
        ldi     r31, 0
        mov     r1, r31
        brcs    waiting
        rjmp    over

settled:
        adiw    r26, 4
; The delay is over: Q = IN, and the phase follows.
over:
        ldi     r30, 0
        bld     r30, 1
        st      Y, r30
        adiw    r28, 5
        next

; Nothing reads this byte: the linker refuses it, as "relocation truncated to fit: R_AVR_8", where the
; page of the handlers ends behind the first 512 bytes of flash.
        .type   engine_page_fits, @object
engine_page_fits:
        .byte   engine_page_end - 257
        .p2align 1
        .size   engine_page_fits, . - engine_page_fits
        .text
