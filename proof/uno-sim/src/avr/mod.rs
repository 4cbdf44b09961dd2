//! The thin layer over simavr: one ATmega328P at 16 MHz, and every call into C.
//!
//! simavr keeps the whole chip in one `avr_t`. Between two steps nothing else touches it; during a step the callbacks
//! registered with [`Avr::on`] run, and may raise IRQs. So this type gives out no reference that could outlive a call.

mod memory;
mod quick;
pub mod reg;
mod wait;
mod wires;

use crate::Error;
use crate::chip::Chip;
pub use quick::Far;
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

unsafe extern "C" {
    /// Executes one instruction, as `run_cycle_limit` is 1, and gives the byte address of the next. simavr's own header of
    /// its core, which the bindings leave out, declares it.
    fn avr_run_one(avr: *mut ffi::avr_t) -> ffi::avr_flashaddr_t;
}

/// The simulated chip.
pub struct Avr {
    avr: NonNull<ffi::avr_t>,
    chip: Chip,
}

impl Avr {
    /// An ATmega328P fresh from the factory, just powered, with this many bytes of flash.
    #[cfg(test)]
    pub fn new(flash_len: usize) -> Result<Avr, Error> {
        Avr::of(Chip::Atmega328p, flash_len)
    }

    /// Any chip likewise.
    pub fn of(chip: Chip, flash_len: usize) -> Result<Avr, Error> {
        // SAFETY: the name is a C string; simavr copies nothing of it.
        let avr = unsafe { ffi::avr_make_mcu_by_name(chip.name().as_ptr()) };
        let avr = NonNull::new(avr).ok_or(Error::Simavr("it was built without this chip"))?;
        // SAFETY: `avr` is a chip that simavr has just allocated and that nobody else knows. The field is a plain
        // value, by which `avr_init` allocates the flash.
        let status = unsafe {
            (*avr.as_ptr()).flashend = flash_len as u32 - 1;
            ffi::avr_init(avr.as_ptr())
        };
        let avr = Avr { avr, chip };
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
    ///
    /// This is simavr's `avr_callback_run_raw`, in which nothing is asked for what is not due yet: after most
    /// instructions nothing is, and a test runs milliards of them.
    #[inline]
    pub fn step(&mut self) -> Cpu {
        let avr = self.avr.as_ptr();
        // SAFETY: the chip is initialised, and `&mut self` keeps everybody else out; the timer is null or one of the chip's
        // own slots.
        unsafe {
            if (*avr).state as u32 != ffi::cpu_Running {
                return self.step_slowly();
            }
            (*avr).pc = avr_run_one(avr);
            let timer = (*avr).cycle_timers.timer;
            let is_due = !timer.is_null() && (*timer).when <= (*avr).cycle;
            if !is_due && (*avr).interrupt_state == 0 && (*avr).state as u32 == ffi::cpu_Running {
                return Cpu::Alive;
            }
        }
        self.after_instruction()
    }

    /// A step of a chip that sleeps, or does not run any more.
    #[cold]
    fn step_slowly(&mut self) -> Cpu {
        // SAFETY: see `step`. This is what `avr_run` calls where no debugger is attached.
        unsafe { ffi::avr_callback_run_raw(self.avr.as_ptr()) };
        self.cpu()
    }

    /// What `avr_callback_run_raw` does after the instruction: timers that are due, sleep, interrupts.
    fn after_instruction(&mut self) -> Cpu {
        let avr = self.avr.as_ptr();
        // SAFETY: see `step`; the flags of SREG are an array of bytes in the chip.
        unsafe {
            let sleep = ffi::avr_cycle_timer_process(avr);
            if (*avr).state as u32 == ffi::cpu_Sleeping {
                if (*avr).sreg[ffi::S_I as usize] == 0 {
                    (*avr).state = ffi::cpu_Done as i32;
                    return Cpu::Done;
                }
                (*avr).cycle += 1 + sleep;
            }
            let state = (*avr).state as u32;
            if (state == ffi::cpu_Running || state == ffi::cpu_Sleeping)
                && (*avr).interrupt_state != 0
            {
                ffi::avr_service_interrupts(avr);
            }
        }
        self.cpu()
    }

    fn cpu(&self) -> Cpu {
        // SAFETY: see `pc`.
        match unsafe { (*self.avr.as_ptr()).state } as u32 {
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

    /// Which chip it is.
    pub fn chip(&self) -> Chip {
        self.chip
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
