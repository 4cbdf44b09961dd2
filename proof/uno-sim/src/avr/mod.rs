//! The thin layer over simavr: one ATmega328P at 16 MHz, and every call into C.
//!
//! simavr keeps the whole chip in one `avr_t`. Between two steps nothing else touches it; during a step the callbacks
//! registered with [`Avr::on`] run, and may raise IRQs. So this type gives out no reference that could outlive a call.

mod memory;
pub mod reg;
mod wait;
mod wires;

use crate::Error;
use simavr_ffi as ffi;
use std::ptr::NonNull;
pub use wait::Leave;
pub use wires::{Interrupt, Irq};

/// Clock of the UNO, Hz.
pub const CLOCK_HZ: u32 = 16_000_000;

/// What simavr says of the CPU after a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cpu {
    /// Running, or asleep with something that can wake it.
    Alive,
    /// Asleep with interrupts off.
    Done,
    /// Ran out of flash, or met an invalid opcode.
    Crashed,
}

/// The simulated chip.
pub struct Avr {
    avr: NonNull<ffi::avr_t>,
}

impl Avr {
    /// A chip fresh from the factory, just powered, with this many bytes of flash.
    pub fn new(flash_len: usize) -> Result<Avr, Error> {
        // SAFETY: the name is a C string; simavr copies nothing of it.
        let avr = unsafe { ffi::avr_make_mcu_by_name(c"atmega328p".as_ptr()) };
        let avr = NonNull::new(avr).ok_or(Error::Simavr("it was built without this chip"))?;
        // SAFETY: `avr` is a chip that simavr has just allocated and that nobody else knows. The field is a plain
        // value, by which `avr_init` allocates the flash.
        let status = unsafe {
            (*avr.as_ptr()).flashend = flash_len as u32 - 1;
            ffi::avr_init(avr.as_ptr())
        };
        let avr = Avr { avr };
        if status != 0 {
            return Err(Error::Simavr("avr_init failed"));
        }
        // SAFETY: as above; the fields are plain values, and a callback that does nothing.
        unsafe {
            let avr = &mut *avr.avr.as_ptr();
            avr.frequency = CLOCK_HZ;
            // Quiet: simavr would print. What it has to say of the program is found in other ways.
            avr.set_log(0);
            // By default a sleeping chip makes the process sleep too, to keep pace with real time.
            avr.sleep = Some(sleep_no_time);
        }
        Ok(avr)
    }

    /// One instruction, with the interrupts and peripherals that are due after it.
    #[inline]
    pub fn step(&mut self) -> Cpu {
        // SAFETY: the chip is initialised, and `&mut self` keeps everybody else out. This is what `avr_run` calls where no
        // debugger is attached.
        let state = unsafe {
            ffi::avr_callback_run_raw(self.avr.as_ptr());
            (*self.avr.as_ptr()).state
        };
        match state as u32 {
            ffi::cpu_Done => Cpu::Done,
            ffi::cpu_Crashed | ffi::cpu_Stopped => Cpu::Crashed,
            _ => Cpu::Alive,
        }
    }

    /// Makes the next [`Avr::step`], and the one that is under way, return [`Cpu::Crashed`].
    ///
    /// # Safety
    /// To be called from a callback only, with the chip of that callback.
    pub unsafe fn crash(avr: NonNull<ffi::avr_t>) {
        // SAFETY: the caller's; `state` is a plain value.
        unsafe { (*avr.as_ptr()).state = ffi::cpu_Crashed as i32 };
    }

    /// Resets the chip: registers to their start values, PC to 0, cycle count to 0. RAM and EEPROM stay.
    pub fn reset(&mut self) {
        // SAFETY: see `step`.
        unsafe { ffi::avr_reset(self.avr.as_ptr()) };
    }

    /// Starts the watchdog's time again where the watchdog is on, as the instruction `wdr` does.
    pub fn restart_watchdog(&mut self) {
        // SAFETY: this request takes no parameter.
        unsafe { self.ioctl(*b"wdtr", std::ptr::null_mut()) };
    }

    /// Byte address of the next instruction.
    #[inline]
    pub fn pc(&self) -> u32 {
        // SAFETY: nothing writes to the chip while `&self` is held; plain value. The same holds for the next three.
        unsafe { (*self.avr.as_ptr()).pc }
    }

    /// Cycles since the last reset.
    #[inline]
    pub fn cycle(&self) -> u64 {
        // SAFETY: see `pc`.
        unsafe { (*self.avr.as_ptr()).cycle }
    }

    /// The same from within a callback: cycles up to the start of the instruction.
    ///
    /// # Safety
    /// `avr` is an initialised chip.
    pub unsafe fn cycle_of(avr: NonNull<ffi::avr_t>) -> u64 {
        // SAFETY: the caller's; plain value.
        unsafe { (*avr.as_ptr()).cycle }
    }

    /// Holds the CPU for so many cycles, from within the callback of an I/O register.
    ///
    /// # Safety
    /// See [`Avr::cycle_of`].
    pub unsafe fn hold(avr: NonNull<ffi::avr_t>, cycles: u64) {
        // SAFETY: the caller's; simavr adds the cycles of the instruction to this value when the instruction is done.
        unsafe { (*avr.as_ptr()).cycle += cycles };
    }

    /// The global interrupt flag.
    pub fn interrupts_on(&self) -> bool {
        // SAFETY: see `pc`.
        unsafe { (*self.avr.as_ptr()).sreg[7] != 0 }
    }

    /// The chip itself, for callbacks.
    pub fn as_ptr(&self) -> NonNull<ffi::avr_t> {
        self.avr
    }
}

impl Drop for Avr {
    fn drop(&mut self) {
        // SAFETY: the chip came from simavr's `malloc`, and nobody uses it any more. `avr_terminate` frees what it owns
        // but not itself.
        unsafe {
            ffi::avr_terminate(self.avr.as_ptr());
            libc::free(self.avr.as_ptr().cast());
        }
    }
}

/// Stands in for simavr's sleep: simulated time passes, real time need not.
unsafe extern "C" fn sleep_no_time(_: *mut ffi::avr_t, _: ffi::avr_cycle_count_t) {}
