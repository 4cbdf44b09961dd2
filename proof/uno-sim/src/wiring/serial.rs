//! The registers of a USART, through which the program reaches a serial port, and its interrupts.
//!
//! Each callback is there for each port: `AT` is how far its registers stand behind those of USART0.

use super::Wiring;
use crate::Error;
use crate::avr::{Avr, Interrupt, reg};
use crate::uart::{Requests, Setting, Uart};
use simavr_ffi as ffi;
use std::ffi::c_void;
use std::ptr::NonNull;

/// USART0, and USART1 of a chip that has one.
pub(super) const FIRST: u16 = 0;
pub(super) const SECOND: u16 = 8;

/// The interrupts of a USART, by their numbers (ATmega328P datasheet, table 11-6).
#[derive(Clone, Copy)]
struct Interrupts {
    received: Interrupt,
    room: Interrupt,
    sent: Interrupt,
}

/// A serial port with its interrupts.
pub(crate) struct Port {
    pub uart: Uart,
    interrupts: Interrupts,
}

impl Port {
    /// With nothing on the line; its interrupts from this number on.
    pub(super) fn new(avr: &Avr, first: u8) -> Result<Port, Error> {
        Ok(Port {
            uart: Uart::new(),
            interrupts: Interrupts::of(avr, first)?,
        })
    }
}

impl Interrupts {
    /// Those from this number on.
    fn of(avr: &Avr, first: u8) -> Result<Interrupts, Error> {
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
pub(super) unsafe fn connect<const AT: u16>(avr: &mut Avr, wiring: NonNull<Wiring>) {
    let parameter = wiring.as_ptr().cast();
    // SAFETY: each callback expects a pointer to a `Wiring`; the rest is the caller's.
    unsafe {
        avr.on_read(reg::UDR0 + AT, read_data::<AT>, parameter);
        avr.on_write(reg::UDR0 + AT, write_data::<AT>, parameter);
        // simavr's own callback is replaced: the register holds what is read.
        avr.on_read(reg::UCSR0A + AT, read_status::<AT>, parameter);
        for register in [
            reg::UCSR0A,
            reg::UCSR0B,
            reg::UCSR0C,
            reg::UBRR0,
            reg::UBRR0 + 1,
        ] {
            avr.on_write(register + AT, write_control::<AT>, parameter);
        }
        let interrupts = wiring.as_ref().port::<AT>().interrupts;
        avr.on(interrupts.received.pending(), taken::<AT>, parameter);
        avr.on(interrupts.room.pending(), taken::<AT>, parameter);
        avr.on(interrupts.sent.pending(), sent_taken::<AT>, parameter);
    }
}

/// The registers as after a reset, in place of what simavr leaves there.
///
/// # Safety
/// `wiring` is alive and so is its chip; no reference to either is held.
pub(super) unsafe fn reset<const AT: u16>(wiring: NonNull<Wiring>) {
    /// UCSR0C: 8 data bits.
    const EIGHT_BITS: u8 = 3 << 1;
    // SAFETY: the caller's; the reference ends with the statement.
    unsafe {
        let wiring = &mut *wiring.as_ptr();
        wiring.port_mut::<AT>().uart.reset();
        Avr::set_register_of(wiring.avr, reg::UCSR0C + AT, EIGHT_BITS);
    }
    // SAFETY: the caller's.
    unsafe { settle::<AT>(wiring) };
}

/// Shows the program what the port is at: flags, interrupts, and the time of what comes next.
///
/// # Safety
/// `wiring` is alive and so is its chip; no reference to either is held.
pub(super) unsafe fn settle<const AT: u16>(wiring: NonNull<Wiring>) {
    // SAFETY: the caller's; the reference ends with the block, before simavr is called.
    let (avr, interrupts, requests, wait) = unsafe {
        let wiring = wiring.as_ref();
        let (avr, port) = (wiring.avr, wiring.port::<AT>());
        let uart = &port.uart;
        Avr::set_register_of(avr, reg::UCSR0A + AT, uart.status());
        Avr::set_register_of(avr, reg::UCSR0B + AT, uart.control());
        let wait = |due: u64| due.saturating_sub(wiring.cycles());
        let due = uart.due(setting::<AT>(avr));
        (avr, port.interrupts, uart.requests(), due.map(wait))
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
            Avr::after(avr, cycles, is_due::<AT>, wiring.as_ptr().cast());
        }
    }
}

/// # Safety
/// See [`Avr::register_of`].
unsafe fn setting<const AT: u16>(avr: NonNull<ffi::avr_t>) -> Setting {
    let registers = [reg::UBRR0, reg::UBRR0 + 1, reg::UCSR0A, reg::UCSR0C];
    // SAFETY: the caller's.
    let [low, high, status, form] =
        registers.map(|register| unsafe { Avr::register_of(avr, register + AT) });
    Setting::of(u16::from_le_bytes([low, high]), status, form)
}

/// Lets the port do something at this time, and shows the program what comes of it.
///
/// # Safety
/// `parameter` points to a `Wiring` to which no reference is held, and so is its chip alive.
unsafe fn with<const AT: u16, T>(
    parameter: *mut c_void,
    act: impl FnOnce(&mut Uart, u64, Setting) -> T,
) -> T {
    let wiring = parameter.cast::<Wiring>();
    // SAFETY: the caller's; the reference ends with the block. The pointer is not null.
    let (result, wiring) = unsafe {
        let now = (*wiring).cycles();
        let setting = setting::<AT>((*wiring).avr);
        (
            act(&mut (*wiring).port_mut::<AT>().uart, now, setting),
            NonNull::new_unchecked(wiring),
        )
    };
    // SAFETY: the caller's.
    unsafe { settle::<AT>(wiring) };
    result
}

/// The program reads UDR0.
unsafe extern "C" fn read_data<const AT: u16>(
    _: *mut ffi::avr_t,
    _: ffi::avr_io_addr_t,
    wiring: *mut c_void,
) -> u8 {
    // SAFETY: `wiring` is what `connect` registered, and nobody else holds a reference to it during a step.
    unsafe { with::<AT, _>(wiring, |uart, now, _| uart.take_data(now)) }
}

/// The program writes to UDR0.
unsafe extern "C" fn write_data<const AT: u16>(
    _: *mut ffi::avr_t,
    _: ffi::avr_io_addr_t,
    value: u8,
    wiring: *mut c_void,
) {
    // SAFETY: as in `read_data`.
    unsafe {
        with::<AT, _>(wiring, |uart, now, setting| {
            uart.set_data(value, now, setting)
        })
    }
}

/// The program reads UCSR0A.
unsafe extern "C" fn read_status<const AT: u16>(
    _: *mut ffi::avr_t,
    _: ffi::avr_io_addr_t,
    wiring: *mut c_void,
) -> u8 {
    // SAFETY: as in `read_data`.
    unsafe { (*wiring.cast::<Wiring>()).port::<AT>().uart.status() }
}

/// The program writes to a register that sets the port up.
unsafe extern "C" fn write_control<const AT: u16>(
    avr: *mut ffi::avr_t,
    register: ffi::avr_io_addr_t,
    value: u8,
    wiring: *mut c_void,
) {
    let write = |uart: &mut Uart, now, _| match register - AT {
        reg::UCSR0A => uart.set_status(value),
        reg::UCSR0B => uart.set_control(value, now),
        _ => {
            let avr = NonNull::new(avr).expect("the chip that is stepping");
            // SAFETY: it is alive, and `register` is one of its own.
            unsafe { Avr::set_register_of(avr, register, value) }
        }
    };
    // SAFETY: as in `read_data`.
    unsafe { with::<AT, _>(wiring, write) }
}

/// The time has come that the port was waiting for.
unsafe extern "C" fn is_due<const AT: u16>(_: *mut ffi::avr_t, _: u64, wiring: *mut c_void) -> u64 {
    // SAFETY: as in `read_data`.
    unsafe { with::<AT, _>(wiring, |uart, now, setting| uart.pass(now, setting)) }
    0
}

/// The CPU has taken the interrupt USART_RX or USART_UDRE, which is asked for as long as its flag is set.
unsafe extern "C" fn taken<const AT: u16>(
    _: *mut ffi::avr_irq_t,
    pending: u32,
    wiring: *mut c_void,
) {
    if pending == 0 {
        // SAFETY: as in `read_data`.
        unsafe { with::<AT, _>(wiring, |_, _, _| ()) }
    }
}

/// The CPU has taken the interrupt USART_TX.
unsafe extern "C" fn sent_taken<const AT: u16>(
    _: *mut ffi::avr_irq_t,
    pending: u32,
    wiring: *mut c_void,
) {
    if pending == 0 {
        // SAFETY: as in `read_data`.
        unsafe { with::<AT, _>(wiring, |uart, _, _| uart.sent_is_served()) }
    }
}
