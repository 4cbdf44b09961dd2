//! The scan in assembly: direct threading, with the images in a register.
//!
//! Owns the linked form of a program and what runs it; must not know pins or clocks. All `unsafe`
//! of the engine is the block in [`Linked::scan`]. It relies on this of linked code, which
//! [`link`] alone makes, out of a checked program:
//!
//! - **Each byte is that of a handler, or one of the operands that the handler before it takes.**
//!   Points are cut to those that have a handler.
//! - **The last byte is that of the end**, and there is no other in front of it.
//! - **There is data for as many timers as the code has.**
//!
//! That the handlers stand where a byte can name them is checked when the firmware is linked; their
//! rules are at the head of `handlers.s`.

mod link;

use core::arch::{asm, global_asm};
use unoclp_core::{Image, Millis, Profile, Program, isa};

global_asm!(include_str!("handlers.s"), options(raw));

/// Bytes of a timer's data: its phase, and a time stamp.
const TIMER_BYTES: usize = 5;
/// Inputs in the low half of the images' register, outputs in the high half.
const POINTS: u8 = 4;
const INPUTS: u8 = 0x0F;

const _: () = {
    assert!(Profile::UNO.inputs <= POINTS && Profile::UNO.outputs <= POINTS);
    assert!(isa::LINKED_TIMER_BYTES - isa::STORED_TIMER_BYTES == TIMER_BYTES);
};

/// A program in its linked form, with everything that it needs to run.
pub struct Linked<'m> {
    code: &'m [u8],
    /// [`TIMER_BYTES`] for each, in file order.
    timers: &'m mut [u8],
    /// Both images as the last scan left them.
    images: u8,
}

impl<'m> Linked<'m> {
    /// Links a program within its run memory, which needs one byte beyond those of the profile: all
    /// outputs 0 (NC-7), no timer started. None where that byte is missing.
    pub fn link(program: Program<'m>) -> Option<Linked<'m>> {
        let (code, timers) = link::link(program)?;
        let mut linked = Linked {
            code,
            timers,
            images: 0,
        };
        linked.restart();
        Some(linked)
    }

    /// The linked code: it changes no more.
    pub fn code(&self) -> &'m [u8] {
        self.code
    }

    /// Starts anew, as after power-up: all outputs 0 (NC-7), no timer started.
    pub fn restart(&mut self) {
        self.timers.fill(0);
        self.images = 0;
    }

    /// The output image.
    pub fn outputs(&self) -> Image {
        Image(u16::from(self.images >> POINTS))
    }

    /// Writes the output image from outside of the program.
    #[inline(always)]
    pub fn set_outputs(&mut self, outputs: Image) {
        self.images = self.images & INPUTS | (outputs.0 as u8) << POINTS;
    }

    /// One scan (NC-5): runs the program once on this input image with this time stamp, and gives
    /// the output image. It cannot fail.
    #[inline(always)]
    pub fn scan(&mut self, inputs: Image, now: Millis) -> Image {
        let mut images = self.images & !INPUTS | inputs.0 as u8 & INPUTS;
        let (now_low, now_high) = (now as u16, (now >> 16) as u16);
        // SAFETY: the code is as the head of this file says, so handlers go from one to the next
        // until that of the end returns; they read the code and no byte behind it, and write the
        // data of its timers. They change only the registers that are named here, and Y, which is
        // saved because it cannot be named.
        unsafe {
            asm!(
                "push r28",
                "push r29",
                "movw r28, r20",
                "ldi r31, 0",
                "set",
                "ld r30, X+",
                "icall",
                "pop r29",
                "pop r28",
                inout("X") self.code.as_ptr() => _,
                inout("r21r20") self.timers.as_mut_ptr() => _,
                inout("r18") images,
                out("r19") _,
                out("Z") _,
                in("r23r22") now_low,
                in("r25r24") now_high,
            );
        }
        self.images = images;
        Image(u16::from(images >> POINTS))
    }
}
