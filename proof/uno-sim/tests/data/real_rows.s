; Runs the REAL operations of the engine on operands in RAM. The host fills the rows, each value, b,
; result and error, writes how many and the operation's number, and lets this run from `done` to `done`.

        .equ    ENGINE_ERROR, error
        .equ    REAL, 1
        .global main, done, rows, count, operation, engine_start, engine_back

        .section .bss
error:  .skip   1
operation: .skip 1
count:  .skip   1
rows:   .skip   100 * 13

        .text
main:
        clr     r1
done:   nop
        lds     r16, operation
        lds     r6, count
        ldi     r28, lo8(rows)
        ldi     r29, hi8(rows)
row:
        sts     error, r1
        ld      r22, Y
        ldd     r23, Y+1
        ldd     r24, Y+2
        ldd     r25, Y+3
        ldd     r8, Y+4
        ldd     r9, Y+5
        ldd     r10, Y+6
        ldd     r11, Y+7
        ; What an operation must keep: acc is bit 0 of the count.
        ldi     r18, 0x18
        ldi     r19, 0x19
        ldi     r20, 0x20
        ldi     r26, 0x26
        ldi     r27, 0x27
        bst     r6, 0
        ldi     r30, lo8(gs(entries))
        ldi     r31, hi8(gs(entries))
        add     r30, r16
        adc     r31, r1
engine_start:
        ijmp
back:
engine_back:
        std     Y+8, r22
        std     Y+9, r23
        std     Y+10, r24
        std     Y+11, r25
        clr     r21
        bld     r21, 0
        eor     r21, r6
        andi    r21, 1
        eor     r18, r26        ; 0x3E
        eor     r19, r27        ; 0x3E
        eor     r18, r19
        cpi     r20, 0x20
        cpc     r18, r1
        cpc     r21, r1
        brne    lost
        cpi     r19, 0x3E
        brne    lost
        tst     r1
        brne    lost
        lds     r21, error
        std     Y+12, r21
        adiw    r28, 13
        dec     r6
        brne    row
        rjmp    done
lost:   clr     r1
        ldi     r21, 0xEE
        std     Y+12, r21
        rjmp    done

entries:
        rjmp    real_add
        rjmp    real_subtract
        rjmp    real_multiply
        rjmp    real_divide
        rjmp    real_root
        rjmp    real_from_signed
        rjmp    real_from_unsigned
        rjmp    real_round
        rjmp    real_cut
        rjmp    real_comparable
        rjmp    absolute
        rjmp    opposite

; As in `first.s`.
absolute:
        andi    r25, 0x7F
        rjmp    real_check
opposite:
        subi    r25, 0x80
        rjmp    real_check

; As in `numbers.s`.
negate:
        com     r25
        com     r24
        com     r23
        neg     r22
        sbci    r23, 0xFF
        sbci    r24, 0xFF
        sbci    r25, 0xFF
        ret
no_quotient:
        ldi     r21, 0x80
        sts     ENGINE_ERROR, r21
        clr     r12
        clr     r13
        movw    r14, r12
        movw    r22, r12
        movw    r24, r12
        ret

        .include "real.s"
