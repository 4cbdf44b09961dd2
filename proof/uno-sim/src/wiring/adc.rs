//! The registers of the converter, and its interrupt.

use super::Wiring;
use crate::avr::{Avr, reg};
use simavr_ffi as ffi;
use std::ffi::c_void;
use std::ptr::NonNull;

/// Bits of ADCSRB: what starts a conversion; 0 is free running.
const TRIGGER: u8 = 7;

/// Takes the registers over from simavr.
///
/// # Safety
/// `wiring` is the wiring of this chip, and outlives it.
pub(super) unsafe fn connect(avr: &mut Avr, wiring: NonNull<Wiring>) {
    let parameter = wiring.as_ptr().cast();
    // SAFETY: each callback expects a pointer to a `Wiring`; the rest is the caller's.
    unsafe {
        for register in [reg::ADC, reg::ADC + 1] {
            avr.on_read(register, read_result, parameter);
        }
        for register in [reg::ADCSRA, reg::ADCSRB, reg::ADMUX] {
            avr.on_write(register, write_control, parameter);
        }
        let interrupt = wiring.as_ref().conversion;
        avr.on(interrupt.pending(), taken, parameter);
    }
}

/// Shows the program what the converter is at: flags, interrupt, and the time of what comes next.
///
/// # Safety
/// `wiring` is alive and so is its chip; no reference to either is held.
pub(super) unsafe fn settle(wiring: NonNull<Wiring>) {
    // SAFETY: the caller's; the reference ends with the block, before simavr is called.
    let (avr, interrupt, request, wait) = unsafe {
        let wiring = wiring.as_ref();
        let (avr, adc) = (wiring.avr, &wiring.adc);
        Avr::set_register_of(avr, reg::ADCSRA, adc.control());
        Avr::set_register_of(avr, reg::ADMUX, adc.mux());
        let wait = |due: u64| due.saturating_sub(wiring.cycles());
        (avr, wiring.conversion, adc.request(), adc.due().map(wait))
    };
    // SAFETY: the chip is alive, and `is_due` expects a pointer to a `Wiring`.
    unsafe {
        interrupt.request(avr, request);
        if let Some(cycles) = wait {
            Avr::after(avr, cycles, is_due, wiring.as_ptr().cast());
        }
    }
}

/// Lets the converter do something at this time, and shows the program what comes of it.
///
/// # Safety
/// `parameter` points to a `Wiring` to which no reference is held, and so is its chip alive.
unsafe fn with<T>(parameter: *mut c_void, act: impl FnOnce(&mut Wiring, u64) -> T) -> T {
    let wiring = parameter.cast::<Wiring>();
    // SAFETY: the caller's; the reference ends with the block. The pointer is not null.
    let (result, wiring) = unsafe {
        let now = (*wiring).cycles();
        (act(&mut *wiring, now), NonNull::new_unchecked(wiring))
    };
    // SAFETY: the caller's.
    unsafe { settle(wiring) };
    result
}

/// The program reads a half of the result.
unsafe extern "C" fn read_result(
    _: *mut ffi::avr_t,
    register: ffi::avr_io_addr_t,
    wiring: *mut c_void,
) -> u8 {
    let read = |wiring: &mut Wiring, _| match register {
        reg::ADC => wiring.adc.take_low(),
        _ => wiring.adc.take_high(),
    };
    // SAFETY: `wiring` is what `connect` registered, and nobody else holds a reference to it during a step.
    unsafe { with(wiring, read) }
}

/// The program writes to a register that sets the converter up.
unsafe extern "C" fn write_control(
    _: *mut ffi::avr_t,
    register: ffi::avr_io_addr_t,
    value: u8,
    wiring: *mut c_void,
) {
    let write = |wiring: &mut Wiring, now| match register {
        reg::ADCSRA => wiring.adc.set_control(value, now),
        reg::ADMUX => wiring.adc.set_mux(value, now),
        // SAFETY: the chip is the one that is stepping, and `register` one of its own.
        _ => unsafe { Avr::set_register_of(wiring.avr, register, value) },
    };
    // SAFETY: as in `read_result`.
    unsafe { with(wiring, write) }
}

/// The time has come that the converter was waiting for.
unsafe extern "C" fn is_due(_: *mut ffi::avr_t, _: u64, wiring: *mut c_void) -> u64 {
    let pass = |wiring: &mut Wiring, now| {
        let ddr = wiring.chip.analogue_port();
        let registers = [reg::ADCSRB, ddr, ddr + 1];
        // SAFETY: the chip is the one that is stepping.
        let [trigger, ddr, port] =
            registers.map(|register| unsafe { Avr::register_of(wiring.avr, register) });
        let (pull_ups, free_running) = (port & !ddr, trigger & TRIGGER == 0);
        wiring.adc.pass(now, &wiring.inputs, pull_ups, free_running);
    };
    // SAFETY: as in `read_result`.
    unsafe { with(wiring, pass) };
    0
}

/// The CPU has taken the interrupt.
unsafe extern "C" fn taken(_: *mut ffi::avr_irq_t, pending: u32, wiring: *mut c_void) {
    if pending == 0 {
        // SAFETY: as in `read_result`.
        unsafe { with(wiring, |wiring, _| wiring.adc.is_served()) }
    }
}
