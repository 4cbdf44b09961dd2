//! The registers EECR and EEAR, through which the program reaches the EEPROM.

use super::Wiring;
use crate::avr::{Avr, reg};
use crate::eeprom::Action;
use simavr_ffi as ffi;
use std::ffi::c_void;
use std::ptr::NonNull;

/// Cycles for which the CPU stands after EERE has been set (datasheet, section 8.6.3), and after EEPE.
const READ_HOLD: u64 = 4;
const WRITE_HOLD: u64 = 2;
/// EEPE: a write is going on.
const BUSY: u8 = 1;

/// Takes the registers over from simavr.
///
/// # Safety
/// `wiring` is the wiring of this chip, and outlives it.
pub(super) unsafe fn connect(avr: &mut Avr, wiring: NonNull<Wiring>) {
    let parameter = wiring.as_ptr().cast();
    // SAFETY: each callback expects a pointer to a `Wiring`; the rest is the caller's.
    unsafe {
        avr.on_read(reg::EECR, read_control, parameter);
        avr.on_write(reg::EECR, write_control, parameter);
        avr.on_write(reg::EEAR, write_address, parameter);
        avr.on_write(reg::EEAR + 1, write_address, parameter);
    }
}

/// Has [`is_due`] called when the write that is going on wants it; to be repeated after a reset.
///
/// # Safety
/// `wiring` is alive and so is its chip; no reference to either is held.
pub(super) unsafe fn await_end(wiring: NonNull<Wiring>) {
    // SAFETY: the caller's; the reference ends before simavr is called.
    let (avr, wait) = unsafe {
        let wiring = wiring.as_ref();
        let wait = |due: u64| due.saturating_sub(wiring.cycles());
        (wiring.avr, wiring.eeprom.due().map(wait))
    };
    if let Some(cycles) = wait {
        // SAFETY: the chip is alive, and `is_due` expects a pointer to a `Wiring`.
        unsafe { Avr::after(avr, cycles, is_due, wiring.as_ptr().cast()) };
    }
}

/// The program reads EECR.
unsafe extern "C" fn read_control(
    _: *mut ffi::avr_t,
    _: ffi::avr_io_addr_t,
    wiring: *mut c_void,
) -> u8 {
    // SAFETY: `wiring` is what `connect` registered, and nobody else holds a reference to it during a step.
    let wiring = unsafe { &*wiring.cast::<Wiring>() };
    let control = wiring.eeprom.control(wiring.cycles());
    if wiring.eeprom.is_busy() {
        // SAFETY: the chip is the one that is stepping.
        unsafe { Avr::pass_waiting(wiring.avr, reg::EECR, BUSY, wiring.chips_leave()) };
    }
    control
}

/// The program writes to EECR.
unsafe extern "C" fn write_control(
    _: *mut ffi::avr_t,
    _: ffi::avr_io_addr_t,
    value: u8,
    wiring: *mut c_void,
) {
    let wiring = wiring.cast::<Wiring>();
    // SAFETY: as in `read_control`; the reference ends with this block. The chip is the one that is stepping.
    let (avr, action) = unsafe {
        let wiring = &mut *wiring;
        let [low, high, data] = [reg::EEAR, reg::EEAR + 1, reg::EEDR]
            .map(|register| Avr::register_of(wiring.avr, register));
        let (address, now) = (u16::from_le_bytes([low, high]), wiring.cycles());
        let action = wiring.eeprom.set_control(value, address, data, now);
        (wiring.avr, action)
    };
    // SAFETY: the chip is the one that is stepping; the pointer is not null, and no reference to its target is held.
    unsafe {
        match action {
            Action::Nothing => {}
            Action::Read(byte) => {
                Avr::set_register_of(avr, reg::EEDR, byte);
                Avr::hold(avr, READ_HOLD);
            }
            Action::Programming { .. } => {
                await_end(NonNull::new_unchecked(wiring));
                Avr::hold(avr, WRITE_HOLD);
            }
        }
    }
}

/// The program writes to a half of EEAR, which the chip does not take while a write is going on.
unsafe extern "C" fn write_address(
    _: *mut ffi::avr_t,
    register: ffi::avr_io_addr_t,
    value: u8,
    wiring: *mut c_void,
) {
    // SAFETY: as in `read_control`; the chip is the one that is stepping, and `register` a half of EEAR.
    unsafe {
        let wiring = &*wiring.cast::<Wiring>();
        if !wiring.eeprom.is_busy() {
            Avr::set_register_of(wiring.avr, register, value);
        }
    }
}

/// The time of a write is over, or that until the power goes.
unsafe extern "C" fn is_due(_: *mut ffi::avr_t, _: u64, wiring: *mut c_void) -> u64 {
    // SAFETY: as in `read_control`; the chip is the one that is stepping.
    unsafe {
        let wiring = &mut *wiring.cast::<Wiring>();
        if wiring.eeprom.is_due() {
            wiring.power_cut = true;
            Avr::crash(wiring.avr);
        }
    }
    0
}
