; The handlers that are run most, in words 0x200 to 0x2FF or 0x300 to 0x3FF. Their rules are at the head of `rules.s`.

; What stands beyond these words where rows of more inputs stand there.
.macro  do_load
        movw    r22, r8
        movw    r24, r10
        next
.endm
.macro  do_add
        add     r22, r8
        adc     r23, r9
        adc     r24, r10
        adc     r25, r11
        next
.endm
.macro  do_store_near
        ld      r30, X+
        brtc    1f
        st      Z, r22
        std     Z+1, r23
        std     Z+2, r24
        std     Z+3, r25
1:      next
.endm

        .space  0x200 - (more_page_end - engine_more_page)

; Contacts, by bit of the images. 6 cycles, both ways.
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
engine_contacts:
        ld      r21, X+
        and     r21, r18
        ld      r30, X+
        cpse    r21, r30
        clt
        next

; Contacts in parallel: one of them is 1. Two bytes follow: those that must be 0, and all of them. 12 cycles.
engine_any:
        ld      r21, X+
        eor     r21, r18
        ld      r30, X+
        and     r21, r30
        brne    1f
        clt
1:      next

; Coils, by output. 5 cycles; with a new rung behind it 6.
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
engine_new_rung:
        rjmp    new_rung

; Timers. A coil follows.
engine_on_delay:
        rjmp    on_delay
engine_off_delay:
        rjmp    off_delay

; Contacts and coils by a near address: 10 cycles.
engine_cell:
        ld      r30, X+
        ld      r21, Z
        sbrs    r21, 7
        clt
        next
engine_cell_not:
        ld      r30, X+
        ld      r21, Z
        sbrc    r21, 7
        clt
        next
engine_cell_coil:
        ld      r30, X+
        clr     r21
        bld     r21, 7
        st      Z, r21
        next
        .if     WIDE
; With a new rung behind it: 11 cycles.
engine_cell_coil_new_rung:
        ld      r30, X+
        clr     r21
        bld     r21, 7
        st      Z, r21
        set
        next
; A row of contacts of inputs 09 to 16, or 17 to 24, as of the images: 15 cycles. That of 01 to 08 comes last.
engine_second_row:
        lds     r0, MORE_INPUTS + 1
        rjmp    row
engine_third_row:
        lds     r0, MORE_INPUTS + 2
        rjmp    row
        .endif
; Contacts by any address: 15 cycles.
engine_far_cell:
        rjmp    far_cell
engine_far_cell_not:
        rjmp    far_cell_not

; b := what the next operation takes: a register by a near address, or by any, a constant of one, two or four bytes, or
; value, which what was pushed becomes.
engine_near:
        ld      r30, X+
        ld      r8, Z
        ldd     r9, Z+1
        ldd     r10, Z+2
        ldd     r11, Z+3
        next
engine_far:
        rjmp    far
engine_byte:
        rjmp    byte_constant
engine_word:
        rjmp    word_constant
engine_long:
        rjmp    long_constant
engine_popped:
        rjmp    popped

; What operations do most. A store has a near address, and is done where acc = 1.
engine_load:
        .if     WIDE
        rjmp    load
        .else
        do_load
        .endif
engine_add:
        .if     WIDE
        rjmp    add
        .else
        do_add
        .endif
engine_subtract:
        rjmp    subtract
engine_store_near:
        .if     WIDE
        rjmp    store_near
        .else
        do_store_near
        .endif

; The handler of the next byte is one of those in the words before: 5 cycles.
engine_escape_first:
        rjmp    escape_first
engine_escape:
        ld      r30, X+
        ldi     r31, NEAR - 1
        ijmp

; The end of the code, and of the scan.
engine_end:
        end_scan
        .if     WIDE
; A row of contacts of inputs 01 to 08: it may go on beyond the words, since it begins there. 13 cycles.
engine_first_row:
        lds     r0, MORE_INPUTS
        .endif
engine_page_end:

        .if     WIDE
row:    ld      r21, X+
        and     r21, r0
        ld      r30, X+
        cpse    r21, r30
        clt
        next
load:   do_load
add:    do_add
store_near:
        do_store_near

; A program that changed in run memory may push what nobody pops. The address to return to could then lie far beyond the
; firmware, where a large flash holds whatever was there before: the board starts anew.
scan_ends:
        lds     r30, ENGINE_STACK
        in      r31, 0x3d       ; SPL
        cpse    r30, r31
        jmp     0
        ret
        .endif

new_rung:
        set
        next
escape_first:
        ld      r30, X+
        ldi     r31, NEAR - 2
        ijmp
far_cell:
        ld      r31, X+
        ld      r30, X+
        ld      r21, Z
        sbrs    r21, 7
        clt
        ldi     r31, NEAR
        next
far_cell_not:
        ld      r31, X+
        ld      r30, X+
        ld      r21, Z
        sbrc    r21, 7
        clt
; Goes on from beyond the words of the handlers that are run most.
back:
        ldi     r31, NEAR
        next

far:
        rcall   address
        rcall   load_b
        rjmp    back
byte_constant:
        ld      r8, X+
        clr     r9
        sbrc    r8, 7
        com     r9
        mov     r10, r9
        mov     r11, r9
        next
word_constant:
        rcall   short
        next
long_constant:
        ld      r8, X+
        ld      r9, X+
        ld      r10, X+
        ld      r11, X+
        next
subtract:
        sub     r22, r8
        sbc     r23, r9
        sbc     r24, r10
        sbc     r25, r11
        next
popped:
        movw    r8, r22
        movw    r10, r24
        pop     r22
        pop     r23
        pop     r24
        pop     r25
        next
