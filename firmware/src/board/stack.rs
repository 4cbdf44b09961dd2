//! How deep the stack has been.

use core::arch::asm;

/// What the free memory is filled with at the start.
const PAINT: u8 = 0xC5;
/// On a Mega, which has a lot of it, more is told as this: a scan waits for the counting.
const MOST: u16 = 64;
/// Bytes below the stack pointer that are left alone.
const NEAR: u8 = 8;

// SAFETY: the linker defines it: the first byte after the statics. Only its address is used.
unsafe extern "C" {
    #[link_name = "_end"]
    safe static END: u8;
}

/// Fills the memory between the statics and the stack.
#[inline(always)]
pub fn paint() {
    // SAFETY: what lies there belongs to nobody: the stack is above it, and no interrupt is enabled yet.
    unsafe {
        asm!(
            "in {below}, 0x3d",
            "in r31, 0x3e",
            "sub {below}, {near}",
            "sbci r31, 0",
            "mov r30, {below}",
            "1: st -Z, {paint}",
            "cpi r30, lo8(_end)",
            "ldi {below}, hi8(_end)",
            "cpc r31, {below}",
            "brne 1b",
            below = out(reg_upper) _,
            near = in(reg) NEAR,
            paint = in(reg) PAINT,
            out("Z") _,
        );
    }
}

/// Bytes that the stack has not used since the start. Takes 7 cycles for each.
pub fn free() -> u16 {
    let mut at = &raw const END;
    let mut free = 0;
    // SAFETY: it ends at the first byte in use, at the latest that of the stack pointer.
    while unsafe { at.read_volatile() } == PAINT {
        at = at.wrapping_add(1);
        free += 1;
        if cfg!(mega) && free == MOST {
            break;
        }
    }
    free
}
