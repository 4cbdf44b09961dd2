; What the compiler calls and does not bring along, or brings along in ten times the size. The
; calling convention is that of avr-gcc: arguments in r25:r24, r23:r22, r21:r20, the result in
; r25:r24; r18-r27, r30, r31 and r0 are free, r1 is 0 again at the end.

        .section .text.runtime, "ax", @progbits

; The compiler is told that the chip has no `mul`, because it loses products of it
; (docs/avr-codegen.md). The assembler is told the same, hence the words.

; u8 * u8
        .global __mulqi3
        .type   __mulqi3, @function
__mulqi3:
        .word   0x9F86          ; mul r24, r22
        mov     r24, r0
        clr     r1
        ret

; u16 * u16
        .global __mulhi3
        .type   __mulhi3, @function
__mulhi3:
        .word   0x9F86          ; mul r24, r22
        movw    r18, r0
        .word   0x9F87          ; mul r24, r23
        add     r19, r0
        .word   0x9F96          ; mul r25, r22
        add     r19, r0
        clr     r1
        movw    r24, r18
        ret

; memcpy(to, from, bytes)
        .global memcpy
        .type   memcpy, @function
memcpy:
        movw    r26, r22
        movw    r30, r24
        rjmp    2f
1:      ld      r0, X+
        st      Z+, r0
2:      subi    r20, 1
        sbci    r21, 0
        brcc    1b
        ret

; memset(to, byte, bytes)
        .global memset
        .type   memset, @function
memset:
        movw    r30, r24
        rjmp    2f
1:      st      Z+, r22
2:      subi    r20, 1
        sbci    r21, 0
        brcc    1b
        ret
