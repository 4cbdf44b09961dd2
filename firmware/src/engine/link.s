; From stored bytes to linked bytes: one passage through the stored form.
;
; In assembly because it takes a third of what it took in Rust. Y is the job, as `link.rs` has it; the
; other registers are
;
;   r12      the kind of the instruction's operand
;   r14-r15  its handler
;   r16      its first stored byte
;   r17      its number
;
; What calls `next` keeps nothing in r18-r27 and Z. Bytes that are missing are 0: the checksum
; tells, at the end.

; What has been read and not been put yet, because it depends on what follows: a rung has begun, and acc
; is 1; a coil, whose output is in JOB_ONES, or where JOB_COUNT is not 0 the near address of its bit; contacts in a row,
; so many, of images that must be 1 and 0, or of the inputs of one port (JOB_PORT).
        .equ    NOTHING, 0
        .equ    COIL, 2
        .equ    CONTACTS, 3
; Contacts in parallel: what must be 1 and 0 of the images, behind a base where acc was the same for each of them, the
; head of a rung or the place of a branch point. Then another branch is open; acc there is that of the base; a contact
; stands in it.
        .equ    PARALLEL, 4
        .equ    BRANCH, 5
        .equ    READY, 6
        .equ    CONTACT, 7
; The base: a branch point, HEAD, or this.
        .equ    NO_BASE, 9
; The first stored byte of a contact of an input above 16: its number follows.
        .equ    FAR_INPUT, 0x88

        .section .text.engine_link, "ax", @progbits
        .global engine_link
        .type   engine_link, @function
engine_link:
        push    r12
        push    r14
        push    r15
        push    r16
        push    r17
        push    r28
        push    r29
        movw    r28, r24
link_all:
        rcall   link_next
        sbrc    r25, 7
        rjmp    1f
        mov     r16, r24
        rcall   link_one
        rjmp    link_all
1:      ldi     r24, pm_lo8(engine_end)
        rcall   link_fast
        pop     r29
        pop     r28
        pop     r17
        pop     r16
        pop     r15
        pop     r14
        pop     r12
        ret

; r24 := the next stored byte; at the end r25 is less than 0.
link_next:
        ldd     r24, Y+JOB_POSITION
        ldd     r25, Y+JOB_POSITION+1
        adiw    r24, 1
        std     Y+JOB_POSITION, r24
        std     Y+JOB_POSITION+1, r25
        ldd     r24, Y+JOB_READER
        ldd     r25, Y+JOB_READER+1
        call    engine_next
        sbrc    r25, 7
        clr     r24
        ret

; Puts the byte r24; beyond the limit it is only counted.
link_put:
        ldd     r30, Y+JOB_PUT
        ldd     r31, Y+JOB_PUT+1
        ldd     r18, Y+JOB_LIMIT
        ldd     r19, Y+JOB_LIMIT+1
        cp      r30, r18
        cpc     r31, r19
        brcc    1f
        st      Z, r24
1:      adiw    r30, 1
        std     Y+JOB_PUT, r30
        std     Y+JOB_PUT+1, r31
        ret

; Puts the address r25:r24.
link_address:
        push    r24
        mov     r24, r25
        rcall   link_put
        pop     r24
        rjmp    link_put

; Puts r17 of the next stored bytes.
link_copy:
        rcall   link_next
        rcall   link_put
        dec     r17
        brne    link_copy
        ret

; Puts the handler r24 of those that are run most, after what is pending.
link_fast:
        mov     r14, r24
        ldi     r24, NEAR
        mov     r15, r24
; Puts the handler r15:r14, likewise.
link_handler:
        rcall   link_flush
        mov     r25, r15
        ldi     r24, pm_lo8(engine_escape_first)
        cpi     r25, NEAR - 1
        brcs    1f
        ldi     r24, pm_lo8(engine_escape)
        brne    2f
1:      rcall   link_put
2:      mov     r24, r14
        rjmp    link_put

; Puts what is pending.
link_flush:
        ldd     r25, Y+JOB_PENDING
        cpi     r25, PARALLEL
        brcs    1f
        rcall   link_part
        rjmp    link_flush
1:      std     Y+JOB_PENDING, r1
        ldi     r24, NO_BASE
        std     Y+JOB_BASE, r24
        cpi     r25, COIL
        brcs    3f
        ldd     r24, Y+JOB_ONES
        brne    1f
        .if     WIDE
        ldd     r18, Y+JOB_COUNT
        ldi     r19, pm_lo8(engine_cell_coil)
        cpse    r18, r1
        rjmp    link_cell
        .endif
        mov     r18, r24
        lsl     r18
        add     r24, r18
        ldi     r18, pm_lo8(engine_coil)
        add     r24, r18
        rjmp    link_put
1:      ldd     r25, Y+JOB_COUNT
        .if     WIDE
        ldd     r18, Y+JOB_PORT
        tst     r18
        brne    link_port
        .endif
        cpi     r25, 3
        brcs    2f
        ldi     r24, pm_lo8(engine_contacts)
        .if     WIDE
link_row:
        .endif
        rcall   link_put
        ldd     r24, Y+JOB_ONES
        ldd     r25, Y+JOB_ZEROS
        eor     r24, r25        ; one that must be 1 and 0 is left out, so it is never 1
        rcall   link_put
        ldd     r24, Y+JOB_ONES
        rjmp    link_put
2:
; Puts each contact by itself.
link_singles:
        ldd     r20, Y+JOB_ONES
        ldi     r21, pm_lo8(engine_contact)
        rcall   4f
        ldd     r20, Y+JOB_ZEROS
        ldi     r21, pm_lo8(engine_contact_not)
4:      lsr     r20
        brcc    5f
        mov     r24, r21
        rcall   link_put
5:      subi    r21, -4
        tst     r20
        brne    4b
3:      ret

        .if     WIDE
; Puts the contacts of port r18, so many as r25 says.
link_port:
        std     Y+JOB_PORT, r1
        cpi     r25, 2
        brcs    1f
        ldi     r24, pm_lo8(engine_first_row)
        dec     r18
        breq    link_row
        ldi     r24, pm_lo8(engine_second_row)
        dec     r18
        breq    link_row
        ldi     r24, pm_lo8(engine_third_row)
        rjmp    link_row
1:      mov     r24, r18        ; but one, whose bit is in one of these
        lsl     r24
        lsl     r24
        lsl     r24
        ldi     r19, pm_lo8(engine_cell)
        ldd     r20, Y+JOB_ONES
        tst     r20
        brne    2f
        ldi     r19, pm_lo8(engine_cell_not)
        ldd     r20, Y+JOB_ZEROS
2:      lsr     r20
        breq    3f
        inc     r24
        rjmp    2b
3:      subi    r24, lo8(-(INPUT_CELLS - 8 - POINTS))
; Puts the handler r19 and the near address r24.
link_cell:
        push    r24
        mov     r24, r19
        rcall   link_put
        pop     r24
        rjmp    link_put
        .endif

; Puts contacts in parallel, and what of another branch has come; a contact in it is pending then.
link_part:
        ldd     r24, Y+JOB_ONES
        ldd     r20, Y+JOB_ZEROS
        or      r20, r24
        mov     r24, r20
        dec     r24
        and     r24, r20
        breq    1f
        ldi     r24, pm_lo8(engine_any)
        rcall   link_put
        ldd     r24, Y+JOB_ZEROS
        rcall   link_put
        mov     r24, r20
        rcall   link_put
        rjmp    2f
1:      rcall   link_singles    ; it is but one
2:      std     Y+JOB_PENDING, r1
        cpi     r25, PARALLEL
        breq    5f
        ldi     r24, pm_lo8(engine_open_branch)
        rcall   link_put
        cpi     r25, BRANCH
        breq    5f
        ldd     r24, Y+JOB_BASE
        cpi     r24, HEAD
        breq    3f
        mov     r18, r24        ; 3 words each
        lsl     r18
        add     r24, r18
        ldi     r18, pm_lo8(engine_recall_branch)
        add     r24, r18
        rcall   link_put
3:      cpi     r25, CONTACT
        brne    5f
        std     Y+JOB_ONES, r1
        std     Y+JOB_ZEROS, r1
        ldi     r24, 1
        std     Y+JOB_COUNT, r24
        ldi     r24, CONTACTS
        std     Y+JOB_PENDING, r24
        ldi     r24, NO_BASE
        std     Y+JOB_BASE, r24
; Adds the contact of the branch to those that are pending.
link_join:
        ldd     r24, Y+JOB_LAST
        ldd     r18, Y+JOB_OPEN_CONTACT
        tst     r18
        breq    4f
        ldd     r18, Y+JOB_ONES
        or      r18, r24
        std     Y+JOB_ONES, r18
        ret
4:      ldd     r18, Y+JOB_ZEROS
        or      r18, r24
        std     Y+JOB_ZEROS, r18
5:      ret

; r24 := 1 shifted left by r24, 0 to 7.
link_bit:
        mov     r25, r24
        ldi     r24, 1
        rjmp    2f
1:      lsl     r24
2:      dec     r25
        brpl    1b
        ret

; The instruction that begins with r16.
link_one:
        mov     r24, r16        ; the place of its row
        .if     WIDE
        cpi     r24, FAR_INPUT  ; of an input above 16, and inverted
        brcs    1f
        cpi     r24, FAR_INPUT + 2
        brcc    1f
        subi    r16, FAR_INPUT - 1
        swap    r16
        ldi     r24, KIND_INPUT
        mov     r12, r24
        rcall   link_next
        mov     r17, r24
        dec     r17
        rjmp    link_contact
1:      mov     r24, r16
        .endif
        cpi     r24, BEHIND_POINTS
        brcc    2f
        cpi     r24, FIRST_POINT
        brcc    1f
        dec     r24
        rjmp    3f
1:      swap    r24
        andi    r24, 0x0F
        subi    r24, 1 - ROW_OF_FIRST_POINT
        rjmp    3f
2:      subi    r24, BEHIND_POINTS - ROW_BEHIND_POINTS
3:      clr     r25
        movw    r30, r24
        lsl     r30
        rol     r31
        subi    r30, lo8(-(ENGINE_HANDLERS))
        sbci    r31, hi8(-(ENGINE_HANDLERS))
        lpm     r14, Z+
        lpm     r15, Z
        ldi     r18, ROW_BYTES
        mul_    24, 18
        movw    r30, r0
        clr     r1
        subi    r30, lo8(-(ENGINE_ROWS + KIND_IN_ROW))
        sbci    r31, hi8(-(ENGINE_ROWS + KIND_IN_ROW))
        lpm     r12, Z
        mov     r17, r16
        andi    r17, 0x0F
        mov     r24, r16
        andi    r24, 0xF0
        breq    2f
        cpi     r24, OP_Coil
        brcs    link_contact
        breq    link_coil
        cpi     r24, OP_StoreBranch
        brcs    3f
        cpi     r24, BEHIND_POINTS
        brcc    2f
        andi    r17, 7          ; branch points, 3 words each
        add     r14, r17
        sbrc    r16, 4
        rjmp    link_recall
        add     r14, r17
        add     r14, r17
        rcall   link_handler
        std     Y+JOB_BASE, r17
        ret
link_recall:
        ldd     r24, Y+JOB_PENDING
        cpi     r24, BRANCH
        brne    4f
        ldd     r24, Y+JOB_BASE
        cp      r24, r17
        brne    4f
        ldi     r24, READY
        std     Y+JOB_PENDING, r24
        ret
3:
        .if     WIDE
        cpi     r17, POINTS
        brcs    5f
        ldi     r24, pm_lo8(engine_cell_set)
        sbrc    r16, 4
        ldi     r24, pm_lo8(engine_cell_reset)
        rcall   link_more
        inc     r17
        rjmp    link_object
5:
        .endif
        andi    r17, 3          ; set and reset coils, 4 words each
        lsl     r17
4:      add     r14, r17
        add     r14, r17
        rjmp    link_handler
2:      mov     r25, r12
        tst     r25
        brne    1f
        rjmp    link_plain
1:      cpi     r25, KIND_TIMER
        brne    1f
        rjmp    link_timer
1:      cpi     r25, KIND_SCALE
        brne    1f
        ldi     r17, 8
        rcall   link_handler
        rjmp    link_copy
1:      rjmp    link_numbered

; A coil of output r17.
link_coil:
        .if     WIDE
        cpi     r17, POINTS
        brcs    1f
        rjmp    link_far_coil
1:
        .endif
        rcall   link_flush
        andi    r17, 3
        std     Y+JOB_ONES, r17
        .if     WIDE
        std     Y+JOB_COUNT, r1
        .endif
        ldi     r24, COIL
        std     Y+JOB_PENDING, r24
        ret

; A contact of input or output r17.
link_contact:
        sbrs    r16, 5          ; 0x10 and 0x20 are of inputs, 0x30 and 0x40 of outputs
        rjmp    1f
        sbrs    r16, 4
        rjmp    2f
        rjmp    3f
1:      sbrc    r16, 6
        rjmp    3f
2:      cpi     r17, POINTS
        brcs    4f
        .if     WIDE
        rjmp    link_port_contact
link_far_contact:
        .endif
        inc     r17             ; inputs from 05 on
        ldi     r24, pm_lo8(engine_cell)
        sbrs    r16, 4
        ldi     r24, pm_lo8(engine_cell_not)
        rcall   link_fast
        rjmp    link_object
3:
        .if     WIDE
        cpi     r17, POINTS
        brcc    link_far_contact
        .endif
        ori     r17, POINTS
4:      mov     r24, r17
        rcall   link_bit
        mov     r17, r24
        ldd     r25, Y+JOB_PENDING
        cpi     r25, CONTACT
        brne    1f
        rcall   link_part
        rjmp    5f
1:      cpi     r25, CONTACTS
        .if     WIDE
        brne    6f
        ldd     r24, Y+JOB_PORT
        tst     r24
        breq    5f
        dec     r24
        brne    6f
        cpi     r17, 1 << POINTS ; inputs 01 to 04 stand in the first port too
        brcs    5f
6:
        .else
        breq    5f
        .endif
        cpi     r25, READY
        brne    1f
        ldd     r24, Y+JOB_ONES ; not the same point twice
        ldd     r18, Y+JOB_ZEROS
        or      r24, r18
        and     r24, r17
        brne    1f
        ldi     r24, CONTACT
        std     Y+JOB_PENDING, r24
        andi    r16, 0x10
        std     Y+JOB_LAST, r17
        std     Y+JOB_OPEN_CONTACT, r16
        ret
1:      ldd     r24, Y+JOB_BASE ; it stays one for the first contact
        cpi     r25, PARALLEL
        brcs    1f
        ldi     r24, NO_BASE
1:      mov     r14, r24
        rcall   link_flush
        std     Y+JOB_BASE, r14
        std     Y+JOB_ONES, r1
        std     Y+JOB_ZEROS, r1
        std     Y+JOB_COUNT, r1
        ldi     r24, CONTACTS
        std     Y+JOB_PENDING, r24
5:      ldd     r24, Y+JOB_COUNT
        cpi     r24, 3
        adc     r24, r1         ; it goes on to 3
        std     Y+JOB_COUNT, r24
        andi    r16, 0x10
        std     Y+JOB_LAST, r17
        std     Y+JOB_OPEN_CONTACT, r16
        rjmp    link_join

        .if     WIDE
; A contact of input r17, from 05 on: in a row with others of its port.
link_port_contact:
        mov     r14, r17
        lsr     r14
        lsr     r14
        lsr     r14
        inc     r14
        mov     r24, r17
        andi    r24, 7
        rcall   link_bit
        mov     r17, r24
        ldd     r25, Y+JOB_PENDING
        cpi     r25, CONTACTS
        brne    1f
        ldd     r24, Y+JOB_PORT
        cp      r24, r14
        breq    5b
        or      r24, r14        ; inputs 01 to 04 stand in the first port too
        cpi     r24, 1
        brne    1f
        ldd     r24, Y+JOB_ONES
        ldd     r18, Y+JOB_ZEROS
        or      r24, r18
        cpi     r24, 1 << POINTS
        brcc    1f
        std     Y+JOB_PORT, r14
        ldi     r24, NO_BASE
        std     Y+JOB_BASE, r24
        rjmp    5b
1:      rcall   link_flush
        std     Y+JOB_ONES, r1
        std     Y+JOB_ZEROS, r1
        std     Y+JOB_COUNT, r1
        std     Y+JOB_PORT, r14
        ldi     r24, CONTACTS
        std     Y+JOB_PENDING, r24
        rjmp    5b
        .endif

        .if     WIDE
; A coil of output r17, from 05 on; and of the bit that has this kind and number.
link_far_coil:
        inc     r17
        ldi     r24, KIND_OUTPUT
        mov     r12, r24
link_cell_coil:
        rcall   link_flush
        rcall   link_find
        std     Y+JOB_ONES, r24
        ldi     r24, 1
        std     Y+JOB_COUNT, r24
        ldi     r24, COIL
        std     Y+JOB_PENDING, r24
        ret
        .endif

; An instruction without an operand.
link_plain:
        cpi     r16, OP_If
        brcs    1f
        rjmp    link_bracket
1:      cpi     r16, OP_NewRung
        breq    link_new_rung
        ldd     r24, Y+JOB_CLOSING
        ldd     r25, Y+JOB_CLOSING+1
        cpi     r16, OP_CloseBranch
        breq    2f
        ldi     r18, 0
        cpi     r16, OP_OpenBranch
        breq    1f
        ldi     r18, 1
        cpi     r16, OP_OpenAnd
        breq    1f
        ldi     r18, 2
        cpi     r16, OP_OpenXor
        breq    1f
        rcall   link_handler
        ldi     r17, OWN_RisingEdge
        cpi     r16, OP_RisingEdge
        breq    link_own
        cpi     r16, OP_FallingEdge
        breq    link_own
        ldd     r24, Y+JOB_OUTPUTS
        cpi     r16, OP_StoreOutputs
        .if     WIDE
        breq    link_all_outputs
        ret
link_all_outputs:
        rcall   link_put
        ldd     r24, Y+JOB_MORE_OUTPUTS
        rjmp    link_put
        .else
        breq    link_put_far
        ret
        .endif
1:      lsl     r24             ; how what is opened is closed
        rol     r25
        lsl     r24
        rol     r25
        or      r24, r18
        rjmp    5f
2:      mov     r18, r24
        andi    r18, 3
        breq    4f
        ldi     r19, pm_lo8(engine_close_and)
        cpi     r18, 1
        breq    3f
        ldi     r19, pm_lo8(engine_close_xor)
3:      mov     r14, r19
        ldi     r19, NEAR - 1
        mov     r15, r19
4:      lsr     r25
        ror     r24
        lsr     r25
        ror     r24
5:      std     Y+JOB_CLOSING, r24
        std     Y+JOB_CLOSING+1, r25
        rjmp    link_branch
link_put_far:
        rjmp    link_put

link_new_rung:
        ldd     r24, Y+JOB_PENDING
        cpi     r24, RUNG
        breq    2f
        cpi     r24, COIL
        brne    1f
        ldd     r24, Y+JOB_ONES
        .if     WIDE
        ldd     r18, Y+JOB_COUNT
        tst     r18
        breq    3f
        std     Y+JOB_PENDING, r1
        ldi     r19, pm_lo8(engine_cell_coil_new_rung)
        rcall   link_cell
        rjmp    2f
3:
        .endif
        lsl     r24
        lsl     r24
        ldi     r18, pm_lo8(engine_coil_new_rung)
        add     r24, r18
        std     Y+JOB_PENDING, r1
        mov     r14, r24
1:      rcall   link_handler
2:      ldi     r24, RUNG
        std     Y+JOB_PENDING, r24
        ldi     r24, HEAD
        std     Y+JOB_BASE, r24
        ret

; Puts the address of r17 bytes of own data.
link_own:
        ldd     r24, Y+JOB_OWN
        ldd     r25, Y+JOB_OWN+1
        sub     r24, r17
        sbc     r25, r1
        std     Y+JOB_OWN, r24
        std     Y+JOB_OWN+1, r25
        rjmp    link_address

; A branch is opened or closed: of contacts in parallel it is joined with what is pending.
link_branch:
        ldd     r24, Y+JOB_PENDING
        cpi     r16, OP_OpenBranch
        breq    6f
        cpi     r16, OP_CloseBranch
        brne    9f
        cpi     r24, CONTACT
        brne    9f
        ldi     r24, PARALLEL
        std     Y+JOB_PENDING, r24
        rjmp    link_join
6:      cpi     r24, PARALLEL
        breq    7f
        cpi     r24, CONTACTS
        brne    9f
        ldd     r24, Y+JOB_COUNT
        cpi     r24, 1
        brne    9f
7:      ldd     r24, Y+JOB_BASE
        ldi     r25, READY      ; acc is that of the base there
        cpi     r24, HEAD
        breq    8f
        ldi     r25, BRANCH
        brcc    9f
8:      std     Y+JOB_PENDING, r25
        ret
9:      rjmp    link_handler

; IF jumps where acc = 0; ELS jumps as acc is 1 at the head of a rung, and is a label, as END is. Each of these jumps has
; the place of the one before that is open in place of its target, until that is known.
link_bracket:
        breq    link_if
        cpi     r16, OP_Else
        brne    1f
        ldi     r24, pm_lo8(engine_new_rung)
        mov     r14, r24
        ldi     r24, NEAR
        mov     r15, r24
        rcall   link_new_rung
        ldi     r24, pm_lo8(engine_jump)
        rcall   link_more
        rcall   link_address
        rcall   link_close
        rcall   link_open
        ldi     r24, pm_lo8(engine_label)
        rcall   link_more
        rjmp    link_label_timer
1:      rcall   link_flush
        rcall   link_close
        rcall   link_handler
        rjmp    link_label_timer
link_if:
        rcall   link_handler
        rcall   link_address
        rcall   link_open
        ldi     r24, RUNG
        std     Y+JOB_PENDING, r24
        ret
; Puts the handler r24 of `more.s`.
link_more:
        mov     r14, r24
        ldi     r24, NEAR - 1
        mov     r15, r24
        rjmp    link_handler
; The jump whose target has just been put is open.
link_open:
        ldd     r30, Y+JOB_PUT
        ldd     r31, Y+JOB_PUT+1
        sbiw    r30, 2
        ldd     r24, Y+JOB_OPEN
        ldd     r25, Y+JOB_OPEN+1
        std     Y+JOB_OPEN, r30
        std     Y+JOB_OPEN+1, r31
        rjmp    link_target
; The target of the jump that is open is here.
link_close:
        ldd     r30, Y+JOB_OPEN
        ldd     r31, Y+JOB_OPEN+1
        ld      r24, Z
        std     Y+JOB_OPEN+1, r24
        ldd     r24, Z+1
        std     Y+JOB_OPEN, r24
        ldd     r24, Y+JOB_PUT
        ldd     r25, Y+JOB_PUT+1
; Puts the address r25:r24 at Z; not beyond the limit.
link_target:
        ldd     r18, Y+JOB_LIMIT
        ldd     r19, Y+JOB_LIMIT+1
        cp      r30, r18
        cpc     r31, r19
        brcc    1f
        st      Z, r25
        std     Z+1, r24
1:      ret

; A timer: its data, then its coil; or another call of one.
link_timer:
        ldi     r17, 4
1:      rcall   link_next
        push    r24
        dec     r17
        brne    1b
        rcall   link_next
        mov     r17, r24
        cpi     r17, TIMER_TARGET ; timers from here on
        brcc    link_again
        rcall   link_handler
        ldd     r30, Y+JOB_TIMER
        ldd     r31, Y+JOB_TIMER+1
        ldd     r18, Y+JOB_TIMERS_END
        ldd     r19, Y+JOB_TIMERS_END+1
        cp      r30, r18
        cpc     r31, r19
        brcc    1f              ; of a changed program: over the last
        adiw    r30, TIMER_DATA
        std     Y+JOB_TIMER, r30
        std     Y+JOB_TIMER+1, r31
1:      ldi     r25, 4
2:      pop     r24             ; the highest byte first
        st      -Z, r24
        dec     r25
        brne    2b
        ldi     r25, TIMER_DATA - 4
3:      st      -Z, r1
        dec     r25
        brne    3b
        cpi     r17, MARKER_TARGET ; markers from here on
        brcc    4f
        rjmp    link_coil
4:      subi    r17, MARKER_TARGET - 1
        .if     WIDE
        ldi     r24, KIND_MARKER
        mov     r12, r24
        rjmp    link_cell_coil
        .else
        ldi     r24, pm_lo8(engine_cell_coil)
        rcall   link_fast
        ldi     r24, KIND_MARKER
        mov     r12, r24
        rjmp    link_object
        .endif
; A timer is called again: its preset and its address, then its handler as it stands, and which timer is next.
link_again:
        subi    r17, TIMER_TARGET - 1
        rcall   link_flush
        ldi     r24, pm_lo8(engine_escape)
        rcall   link_put
        ldi     r24, pm_lo8(engine_again)
        rcall   link_put
        ldi     r16, 4
1:      pop     r24
        rcall   link_put
        dec     r16
        brne    1b
        ldi     r24, KIND_TIMER_Q
        mov     r12, r24
        rcall   link_find
        rcall   link_address
        rcall   link_handler
        ldi     r24, pm_lo8(engine_timer)
        rcall   link_more
        rjmp    link_next_timer

; An instruction with a number.
link_numbered:
        rcall   link_next
        mov     r17, r24
        mov     r25, r12
        cpi     r25, KIND_TIME
        brne    1f
        ret
1:
        .if     WIDE
        cpi     r16, OP_MarkerCoil
        brne    1f
        rjmp    link_cell_coil
1:
        .endif
        cpi     r16, OP_KeepRegister
        brcs    1f
        cpi     r16, OP_Push
        brcc    1f
        rjmp    link_object
1:      cpi     r25, KIND_LABEL
        brne    1f
        rjmp    link_label
1:      cpi     r25, KIND_JUMP
        brne    1f
        rjmp    link_jump
1:      cpi     r25, KIND_INPUT
        brne    1f
        cpi     r17, POINTS + 1
        brcs    1f
        ldi     r24, pm_lo8(engine_xor_cell)
        sbrc    r16, 0          ; inverted
        ldi     r24, pm_lo8(engine_xor_cell_not)
        mov     r14, r24
1:
        .if     WIDE
        cpi     r25, KIND_OUTPUT
        brne    1f
        cpi     r17, POINTS + 1
        brcs    1f
        ldi     r24, pm_lo8(engine_cell_coil_not)
        cpi     r16, OP_NegatedCoil
        breq    2f
        ldi     r24, pm_lo8(engine_xor_cell)
        cpi     r16, OP_XorOutput
        breq    2f
        ldi     r24, pm_lo8(engine_xor_cell_not)
2:      mov     r14, r24
1:
        .endif
        ldi     r24, pm_lo8(engine_load)
        ldi     r18, NEAR
        cp      r14, r24
        cpc     r15, r18
        breq    3f              ; of a counter or a reading too
        cpi     r25, KIND_VALUE
        brcs    4f
3:      rjmp    link_operation
4:      cpi     r16, OP_Store
        brne    1f
        cpi     r17, NEAR_REGISTERS + 1
        brcc    1f
        ldi     r24, pm_lo8(engine_store_near)
        rcall   link_fast
        rjmp    link_object
1:      rcall   link_handler
        mov     r25, r12
        mov     r24, r17
        cpi     r25, KIND_BIT
        brne    1f
        rjmp    link_put
1:      cpi     r25, KIND_INPUT
        brne    1f
        cpi     r17, POINTS + 1
        brcc    8f
        rjmp    2f
1:      cpi     r25, KIND_OUTPUT
        brne    3f
        .if     WIDE
        cpi     r17, POINTS + 1
        brcs    1f
        rjmp    link_object
1:
        .endif
        subi    r24, 0 - POINTS
2:      dec     r24
        rcall   link_bit
        rjmp    link_put
3:      cpi     r25, KIND_FILTER
        brne    4f
        ldi     r17, OWN_Filter
        push    r24
        rcall   link_own
        pop     r24
        rcall   link_put
        ldi     r17, 2
        rjmp    link_copy
4:      cpi     r25, KIND_TABLE
        brne    5f
        rcall   link_next
        rcall   link_put
        rjmp    link_object
5:      cpi     r16, OP_Integrate
        brne    6f
        push    r17
        ldi     r17, OWN_Integrate
        rcall   link_own
        pop     r17
        rjmp    8f
6:      cpi     r25, KIND_COUNT
        brne    7f
        rjmp    link_count
7:      cpi     r25, KIND_MOVE
        brne    7f
        rcall   link_object
        rcall   link_next
        mov     r17, r24
        rcall   link_object
        rcall   link_next
        lsl     r24
        lsl     r24
        rjmp    link_put
7:      cpi     r25, KIND_DRUM
        brne    8f
        rcall   link_object
        rcall   link_next
        mov     r17, r24
        rcall   link_put
1:      rcall   link_next
        swap    r24
        ldd     r25, Y+JOB_OUTPUTS
        and     r24, r25
        rcall   link_put
        dec     r17
        brne    1b
        ret
8:      rjmp    link_object

; An operation: what it takes comes before it.
link_operation:
        cpi     r25, KIND_VALUE
        brcs    2f
        mov     r25, r17
        ldi     r17, 4
        ldi     r24, pm_lo8(engine_long)
        tst     r25
        breq    1f
        ldi     r17, 0
        ldi     r24, pm_lo8(engine_popped)
        cpi     r25, POPPED
        breq    1f
        ldi     r17, 1
        ldi     r24, pm_lo8(engine_byte)
        cpi     r25, BYTE_CONSTANT
        breq    1f
        ldi     r17, 2
        ldi     r24, pm_lo8(engine_word)
        brcc    1f
        mov     r17, r25
2:      rcall   link_flush
        rcall   link_find
        ldi     r18, pm_lo8(engine_near)
        cpi     r25, NEAR
        breq    3f
        ldi     r18, pm_lo8(engine_far)
3:      push    r24
        mov     r24, r18
        rcall   link_put
        cpi     r25, NEAR
        breq    4f
        mov     r24, r25
        rcall   link_put
4:      pop     r24
        rcall   link_put
        rjmp    link_handler
1:      push    r24
        rcall   link_flush
        pop     r24
        rcall   link_put
        tst     r17
        breq    5f
        ldd     r24, Y+JOB_POSITION ; what a jump back costs counts it as 4 bytes
        ldd     r25, Y+JOB_POSITION+1
        adiw    r24, 4
        sub     r24, r17
        sbc     r25, r1
        std     Y+JOB_POSITION, r24
        std     Y+JOB_POSITION+1, r25
        rcall   link_copy
5:      rjmp    link_handler

link_label:
        rcall   link_flush
        ldd     r24, Y+JOB_PUT
        ldd     r25, Y+JOB_PUT+1
        rcall   link_place
        st      Z+, r24
        st      Z+, r25
        ldd     r24, Y+JOB_POSITION
        ldd     r25, Y+JOB_POSITION+1
        sbiw    r24, 2
        st      Z+, r24
        st      Z+, r25
        rcall   link_handler
link_label_timer:
        ldi     r24, RUNG
        std     Y+JOB_PENDING, r24
link_next_timer:
        ldd     r24, Y+JOB_TIMER
        ldd     r25, Y+JOB_TIMER+1
        rjmp    link_address

; Z := the place of label r17: where it stands in the linked and in the stored form.
link_place:
        mov     r30, r17
        dec     r30
        andi    r30, LABELS - 1
        lsl     r30
        lsl     r30
        clr     r31
        subi    r30, lo8(-(REGISTERS))
        sbci    r31, hi8(-(REGISTERS))
        ret

link_jump:
        rcall   link_place
        ldd     r18, Z+2
        ldd     r19, Z+3
        ldd     r24, Y+JOB_POSITION
        ldd     r25, Y+JOB_POSITION+1
        adiw    r24, 2          ; behind the line
        sub     r24, r18
        sbc     r25, r19
        brcs    1f
        push    r24
        push    r25
        ldi     r24, 1
        std     Y+JOB_JUMPS_BACK, r24
        ldi     r24, pm_lo8(engine_jump_back)
        sbrc    r16, 0          ; where acc must be 0
        ldi     r24, pm_lo8(engine_jump_back_not)
        mov     r14, r24
        rcall   2f
        pop     r25
        pop     r24
        rcall   3f              ; the cost
        ldi     r17, 2
        rjmp    link_copy
1:      rcall   2f
        rcall   link_next
        rjmp    link_next
2:      rcall   link_handler
        rcall   link_place
        ld      r24, Z
        ldd     r25, Z+1
        rjmp    link_address
3:      push    r25
        rcall   link_put
        pop     r24
        rjmp    link_put

; A counter: its preset, then its address.
link_count:
        mov     r24, r17
        dec     r24
        ldi     r25, COUNTER_DATA
        mul_    24, 25
        movw    r14, r0
        clr     r1
        ldd     r24, Y+JOB_COUNTERS
        ldd     r25, Y+JOB_COUNTERS+1
        adiw    r24, 4
        add     r14, r24
        adc     r15, r25
        ldi     r16, 4
1:      rcall   link_next
        movw    r30, r14
        ldd     r18, Y+JOB_COUNTERS_END
        ldd     r19, Y+JOB_COUNTERS_END+1
        cp      r30, r18
        cpc     r31, r19
        brcc    2f
        st      Z+, r24
2:      movw    r14, r30
        dec     r16
        brne    1b

; Puts the address of what has this kind and number: its low byte alone where the handler needs no more.
link_object:
        rcall   link_find
        cpi     r16, OP_KeepRegister
        brcs    link_place_of
        cpi     r16, OP_Push
        brcc    link_place_of
        rjmp    link_keep
link_place_of:
        mov     r18, r15
        cpi     r18, NEAR
        brne    1f
        cp      r25, r18
        brne    1f
        rjmp    link_put
1:      rjmp    link_address

; r25:r24 := the address of what has this kind and number.
link_find:
        ldi     r24, lo8(REGISTERS)
        ldi     r25, hi8(REGISTERS)
        ldi     r18, 4
        mov     r19, r12
        cpi     r19, KIND_MARKER
        breq    1f
        cpi     r19, KIND_GROUP
        brne    2f
        ldi     r18, 8
        rjmp    3f
1:      ldi     r18, 1
3:      subi    r24, DATA_REGISTERS - DATA_MARKERS
        sbc     r25, r1
        rjmp    9f
2:      cpi     r19, KIND_TIMER_Q
        brne    3f
        ldd     r24, Y+JOB_TIMERS
        ldd     r25, Y+JOB_TIMERS+1
        cpi     r16, OP_PresetTimer
        brne    4f
        adiw    r24, 5
4:      ldi     r18, TIMER_DATA ; as of a counter
        rjmp    9f
3:      cpi     r19, KIND_COUNT
        breq    5f
        cpi     r19, KIND_COUNTER
        brne    3f
5:      ldd     r24, Y+JOB_COUNTERS
        ldd     r25, Y+JOB_COUNTERS+1
        cpi     r16, OP_PresetCounter
        brne    4b
        adiw    r24, 4
        rjmp    4b
3:      cpi     r19, KIND_READING
        brne    3f
        subi    r24, DATA_REGISTERS - DATA_READINGS
        rjmp    8f
3:      cpi     r19, KIND_ANALOGUE
        brne    3f
        inc     r17             ; from 00
        subi    r24, DATA_REGISTERS - DATA_ANALOGUE
        ldi     r18, 2
        rjmp    8f
3:      cpi     r19, KIND_SYSTEM
        brne    3f
        subi    r24, DATA_REGISTERS - DATA_SYSTEM
        rjmp    7f
3:      cpi     r19, KIND_INPUT ; those from 05 on
        brne    3f
        subi    r24, DATA_REGISTERS - DATA_INPUTS + POINTS
        rjmp    7f
3:
        .if     WIDE
        cpi     r19, KIND_OUTPUT ; those from 05 on
        brne    3f
        subi    r24, DATA_REGISTERS - DATA_OUTPUTS + POINTS
        rjmp    7f
3:
        .endif
        cpi     r19, KIND_PWM
        brne    9f
        subi    r24, DATA_REGISTERS - DATA_PWM
7:      ldi     r18, 1
8:      sbc     r25, r1
9:      mov     r19, r17
        dec     r19
        mul_    18, 19
        add     r24, r0
        adc     r25, r1
        clr     r1
        ret
link_keep:
        ldd     r30, Y+JOB_KEPT ; it has no handler, but its address stands there
        ldd     r31, Y+JOB_KEPT+1
        ldd     r18, Y+JOB_KEPT_END
        ldd     r19, Y+JOB_KEPT_END+1
        cp      r30, r18
        cpc     r31, r19
        brcc    2f
        st      Z+, r24
        st      Z+, r25
        std     Y+JOB_KEPT, r30
        std     Y+JOB_KEPT+1, r31
2:      ret
        .text
