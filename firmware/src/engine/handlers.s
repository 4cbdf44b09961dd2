; The handlers of the engine. Linked code is a row of bytes, each the word address of a handler:
; whatever a handler has to do, it ends by going to that of the next byte. So these must begin in the
; first 256 words of flash; avr-gcc's linker script puts `.progmem.gcc*` right behind the interrupt
; vectors. What does not fit there begins in the 256 words behind, in `more.s`, and is reached by an
; escape. The last lines check that both fit.
;
; A handler may change nothing but
;
;   T        acc (NC-6)
;   r18      the images: inputs 01-04 in bits 0-3, outputs 01-04 in bits 4-7
;   r19      acc of each open branch as it was when the branch opened, the innermost in bit 0
;   r20      the branch points of the rung
;   r22-r25  value (NC-16)
;   r0, r21  scratch
;   r8-r15   scratch: b in r8-r11, c in r12-r15
;   X        the linked byte after the next
;   Y        the data of the next timer
;   Z        r30: scratch, and the low byte of the address to go to; r31: 0, or 1 for an escape
;   SREG     all other flags
;
; and reads the time stamp of the scan, r2 to r5. r1 is 0 between handlers. Where an operand is an
; address, its high byte comes first. What a bit of its own stands for is in bit 7 of a byte: a marker,
; a system marker, an input from 05 on, Q of a timer.

; Goes on to the next linked byte: 4 cycles.
.macro  next
        ld      r30, X+
        ijmp
.endm

; `Data`, which stands behind the frame in the page.
        .equ    ENGINE, PAGE + PAGE_DATA
        .equ    ENGINE_ERROR, ENGINE + DATA_SYSTEM + 3
        .equ    ENGINE_MORE_INPUTS, ENGINE + DATA_MORE_INPUTS
        .equ    ENGINE_BUDGET, ENGINE + DATA_BUDGET
        .equ    ENGINE_LINE, ENGINE + DATA_LINE
        .global READINGS, MARKERS, REGISTERS
        .equ    READINGS, ENGINE + DATA_ANALOGUE
        .equ    MARKERS, ENGINE + DATA_MARKERS
        .equ    REGISTERS, ENGINE + DATA_REGISTERS

        .section .progmem.gcc.engine, "ax", @progbits

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
        .global engine_contacts
engine_contacts:
        ld      r21, X+
        and     r21, r18
        ld      r30, X+
        cpse    r21, r30
        clt
        next

; Coils, by output. 5 cycles; with a new rung behind it 6.
        .global engine_coil_new_rung
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
        set
        next

; Timers. A coil follows.
engine_on_delay:
        rjmp    on_delay
engine_off_delay:
        rjmp    off_delay

; Contacts and coils by address: 15 cycles.
engine_cell:
        rjmp    cell
engine_cell_not:
        rjmp    cell_not
engine_cell_coil:
        rjmp    cell_coil

; The handler of the next byte is one of those beyond the first 256 words: 5 cycles.
        .global engine_escape
engine_escape:
        ld      r30, X+
        ldi     r31, 1
        ijmp

; The end of the code, and of the scan.
engine_end:
        ret
engine_page_end:

cell:
        ld      r31, X+
        ld      r30, X+
        ld      r21, Z
        sbrs    r21, 7
        clt
        ldi     r31, 0
        next
cell_not:
        ld      r31, X+
        ld      r30, X+
        ld      r21, Z
        sbrc    r21, 7
        clt
        ldi     r31, 0
        next
cell_coil:
        ld      r31, X+
        ld      r30, X+
        clr     r21
        bld     r21, 7
        st      Z, r21
; Goes on from beyond the first 256 words.
back:
        ldi     r31, 0
        next
