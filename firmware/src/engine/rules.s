; The handlers of the engine. Linked code is a row of bytes, each the low byte of the word address of a handler:
; whatever a handler has to do, it ends by going to that of the next byte. Those that are run most begin in words 0x200
; to 0x2FF, or 0x300 to 0x3FF (NEAR), so that the high byte of their address is that of the data they need most: markers, the first registers
; and other cells stand at 0x200 to 0x2FF of the data space, and one byte names them. The others begin in the words
; before, in `first.s` and `more.s`, and are reached by escapes. avr-gcc's linker script puts `.progmem.gcc*` right
; behind the interrupt vectors. The last lines of `numbers.s` check that all of them fit.
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
;   Z        r30: scratch, and the low byte of the address to go to; r31: NEAR behind an escape
;   SP       what is pushed, 4 bytes each
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

; Ends the scan.
.macro  end_scan
        .if     WIDE
        rjmp    scan_ends
        .else
        ret
        .endif
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
        .if     WIDE
        .global INPUT_CELLS, OUTPUT_CELLS, MORE_INPUTS, ENGINE_STACK
        .equ    INPUT_CELLS, ENGINE + DATA_INPUTS
        .equ    OUTPUT_CELLS, ENGINE + DATA_OUTPUTS
        .equ    MORE_INPUTS, ENGINE + DATA_MORE_INPUTS
        .equ    ENGINE_STACK, ENGINE + DATA_STACK
        .endif

