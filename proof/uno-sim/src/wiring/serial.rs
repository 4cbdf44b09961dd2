//! The registers of USART0, through which the program reaches the serial port, and its interrupts.

use super::Wiring;
use crate::Error;
use crate::avr::{Avr, Interrupt, reg};
use crate::uart::{Requests, Setting};
use simavr_ffi as ffi;
use std::ffi::c_void;
use std::ptr::NonNull;

/// The interrupts of USART0, by their numbers (ATmega328P datasheet, table 11-6).
#[derive(Clone, Copy)]
pub(super) struct Interrupts {
    received: Interrupt,
    room: Interrupt,
    sent: Interrupt,
}

impl Interrupts {
    pub fn of(avr: &Avr) -> Result<Interrupts, Error> {
        let first = avr.chip().serial_interrupt();
        Ok(Interrupts {
            received: avr.interrupt(first)?,
            room: avr.interrupt(first + 1)?,
            sent: avr.interrupt(first + 2)?,
        })
    }
}

/// Takes the registers over from simavr.
///
/// # Safety
/// `wiring` is the wiring of this chip, and outlives it.
pub(super) unsafe fn connect(avr: &mut Avr, wiring: NonNull<Wiring>) {
    let parameter = wiring.as_ptr().cast();
    // SAFETY: each callback expects a pointer to a `Wiring`; the rest is the caller's.
    unsafe {
        avr.on_read(reg::UDR0, read_data, parameter);
        avr.on_write(reg::UDR0, write_data, parameter);
        // simavr's own callback is replaced: the register holds what is read.
        avr.on_read(reg::UCSR0A, read_status, parameter);
        for register in [
            reg::UCSR0A,
            reg::UCSR0B,
            reg::UCSR0C,
            reg::UBRR0,
            reg::UBRR0 + 1,
        ] {
            avr.on_write(register, write_control, parameter);
        }
        let interrupts = wiring.as_ref().serial;
        avr.on(interrupts.received.pending(), taken, parameter);
        avr.on(interrupts.room.pending(), taken, parameter);
        avr.on(interrupts.sent.pending(), sent_taken, parameter);
    }
}

/// The registers as after a reset, in place of what simavr leaves there.
///
/// # Safety
/// `wiring` is alive and so is its chip; no reference to either is held.
pub(super) unsafe fn reset(wiring: NonNull<Wiring>) {
    /// UCSR0C: 8 data bits.
    const EIGHT_BITS: u8 = 3 << 1;
    // SAFETY: the caller's; the reference ends with the statement.
    unsafe {
        let wiring = &mut *wiring.as_ptr();
        wiring.uart.reset();
        Avr::set_register_of(wiring.avr, reg::UCSR0C, EIGHT_BITS);
    }
    // SAFETY: the caller's.
    unsafe { settle(wiring) };
}

/// Shows the program what the port is at: flags, interrupts, and the time of what comes next.
///
/// # Safety
/// `wiring` is alive and so is its chip; no reference to either is held.
pub(super) unsafe fn settle(wiring: NonNull<Wiring>) {
    // SAFETY: the caller's; the reference ends with the block, before simavr is called.
    let (avr, interrupts, requests, wait) = unsafe {
        let wiring = wiring.as_ref();
        let (avr, uart) = (wiring.avr, &wiring.uart);
        Avr::set_register_of(avr, reg::UCSR0A, uart.status());
        Avr::set_register_of(avr, reg::UCSR0B, uart.control());
        let wait = |due: u64| due.saturating_sub(wiring.cycles());
        let due = uart.due(setting(avr));
        (avr, wiring.serial, uart.requests(), due.map(wait))
    };
    let Requests {
        received,
        room,
        sent,
    } = requests;
    // SAFETY: the chip is alive, and `is_due` expects a pointer to a `Wiring`.
    unsafe {
        interrupts.received.request(avr, received);
        interrupts.room.request(avr, room);
        interrupts.sent.request(avr, sent);
        if let Some(cycles) = wait {
            Avr::after(avr, cycles, is_due, wiring.as_ptr().cast());
        }
    }
}

/// # Safety
/// See [`Avr::register_of`].
unsafe fn setting(avr: NonNull<ffi::avr_t>) -> Setting {
    let registers = [reg::UBRR0, reg::UBRR0 + 1, reg::UCSR0A, reg::UCSR0C];
    // SAFETY: the caller's.
    let [low, high, status, form] =
        registers.map(|register| unsafe { Avr::register_of(avr, register) });
    Setting::of(u16::from_le_bytes([low, high]), status, form)
}

/// Lets the port do something at this time, and shows the program what comes of it.
///
/// # Safety
/// `parameter` points to a `Wiring` to which no reference is held, and so is its chip alive.
unsafe fn with<T>(parameter: *mut c_void, act: impl FnOnce(&mut Wiring, u64, Setting) -> T) -> T {
    let wiring = parameter.cast::<Wiring>();
    // SAFETY: the caller's; the reference ends with the block. The pointer is not null.
    let (result, wiring) = unsafe {
        let now = (*wiring).cycles();
        let setting = setting((*wiring).avr);
        (
            act(&mut *wiring, now, setting),
            NonNull::new_unchecked(wiring),
        )
    };
    // SAFETY: the caller's.
    unsafe { settle(wiring) };
    result
}

/// The program reads UDR0.
unsafe extern "C" fn read_data(
    _: *mut ffi::avr_t,
    _: ffi::avr_io_addr_t,
    wiring: *mut c_void,
) -> u8 {
    // SAFETY: `wiring` is what `connect` registered, and nobody else holds a reference to it during a step.
    unsafe { with(wiring, |wiring, now, _| wiring.uart.take_data(now)) }
}

/// The program writes to UDR0.
unsafe extern "C" fn write_data(
    _: *mut ffi::avr_t,
    _: ffi::avr_io_addr_t,
    value: u8,
    wiring: *mut c_void,
) {
    // SAFETY: as in `read_data`.
    unsafe {
        with(wiring, |wiring, now, setting| {
            wiring.uart.set_data(value, now, setting)
        })
    }
}

/// The program reads UCSR0A.
unsafe extern "C" fn read_status(
    _: *mut ffi::avr_t,
    _: ffi::avr_io_addr_t,
    wiring: *mut c_void,
) -> u8 {
    // SAFETY: as in `read_data`.
    unsafe { (*wiring.cast::<Wiring>()).uart.status() }
}

/// The program writes to a register that sets the port up.
unsafe extern "C" fn write_control(
    _: *mut ffi::avr_t,
    register: ffi::avr_io_addr_t,
    value: u8,
    wiring: *mut c_void,
) {
    let write = |wiring: &mut Wiring, now, _| match register {
        reg::UCSR0A => wiring.uart.set_status(value),
        reg::UCSR0B => wiring.uart.set_control(value, now),
        // SAFETY: the chip is the one that is stepping, and `register` one of its own.
        _ => unsafe { Avr::set_register_of(wiring.avr, register, value) },
    };
    // SAFETY: as in `read_data`.
    unsafe { with(wiring, write) }
}

/// The time has come that the port was waiting for.
unsafe extern "C" fn is_due(_: *mut ffi::avr_t, _: u64, wiring: *mut c_void) -> u64 {
    // SAFETY: as in `read_data`.
    unsafe {
        with(wiring, |wiring, now, setting| {
            wiring.uart.pass(now, setting)
        })
    }
    0
}

/// The CPU has taken the interrupt USART_RX or USART_UDRE, which is asked for as long as its flag is set.
unsafe extern "C" fn taken(_: *mut ffi::avr_irq_t, pending: u32, wiring: *mut c_void) {
    if pending == 0 {
        // SAFETY: as in `read_data`.
        unsafe { with(wiring, |_, _, _| ()) }
    }
}

/// The CPU has taken the interrupt USART_TX.
unsafe extern "C" fn sent_taken(_: *mut ffi::avr_irq_t, pending: u32, wiring: *mut c_void) {
    if pending == 0 {
        // SAFETY: as in `read_data`.
        unsafe { with(wiring, |wiring, _, _| wiring.uart.sent_is_served()) }
    }
}
