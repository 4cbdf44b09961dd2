//! What must answer while an instruction runs: the card on the SPI, the serial port, the converter, and the EEPROM.
//!
//! simavr calls back into this module from within a step. Each callback takes a short reference to the [`Wiring`] and
//! gives it up before it raises an IRQ, because that may call back again.

mod adc;
mod eeprom;
mod serial;

use crate::adc::Adc;
use crate::avr::{Avr, Interrupt, Irq, Leave, reg};
use crate::chip::Chip;
use crate::eeprom::Eeprom;
use crate::inputs::Inputs;
use crate::uart::{Flaw, Uart};
use crate::{Error, Slot};
use serial::{FIRST, Port, SECOND};
use simavr_ffi as ffi;
use std::ffi::c_void;
use std::ops::{Deref, DerefMut};
use std::ptr::NonNull;

/// The state that the callbacks share with the board.
pub(crate) struct Wiring {
    avr: NonNull<ffi::avr_t>,
    to_spi: Irq,
    conversion: Interrupt,
    chip: Chip,
    /// Cycles up to the last reset.
    pub cycles_before: u64,
    /// How far the chip is let run, in cycles since the board was made.
    pub leave: Leave,
    pub eeprom: Eeprom,
    /// The power has gone at a write to the EEPROM.
    pub power_cut: bool,
    /// What is in the card slot.
    pub slot: Slot,
    /// USART0, and USART1 where the chip has one.
    usb: Port,
    bus: Option<Port>,
    pub adc: Adc,
    pub inputs: Inputs,
    /// The invalid opcode that stopped the program.
    pub bad_opcode: Option<u16>,
}

/// Owner of a [`Wiring`] at a fixed address, which simavr's callbacks know.
///
/// The references that it gives out must not be held during [`Avr::step`], [`Avr::reset`] or [`Irq::raise`].
pub(crate) struct Wired(NonNull<Wiring>);

impl Wired {
    /// Connects a slot, a serial line and an empty EEPROM to the chip. The chip must be dropped before the result.
    pub fn new(avr: &mut Avr, slot: Slot) -> Result<Wired, Error> {
        let chip = avr.chip();
        avr.quiet_uart();
        avr.unwire_timers()?;
        // simavr names peripherals by four characters; the SPI of this chip has the number 0, not '0'.
        let spi = *b"spi\0";
        let wiring = Box::new(Wiring {
            avr: avr.as_ptr(),
            to_spi: avr.irq(spi, ffi::SPI_IRQ_INPUT)?,
            conversion: avr.interrupt(chip.conversion_interrupt())?,
            chip,
            cycles_before: 0,
            leave: Leave::default(),
            eeprom: Eeprom::new(chip.eeprom_len()),
            power_cut: false,
            slot,
            usb: Port::new(avr, chip.serial_interrupt())?,
            bus: match chip.bus_interrupt() {
                Some(first) => Some(Port::new(avr, first)?),
                None => None,
            },
            adc: Adc::new(),
            inputs: Inputs {
                shared: chip == Chip::Atmega328p,
                ..Inputs::new()
            },
            bad_opcode: None,
        });
        let wired = Wired(NonNull::from(Box::leak(wiring)));
        let parameter = wired.0.as_ptr().cast();
        let from_spi = avr.irq(spi, ffi::SPI_IRQ_OUTPUT)?;
        let bad_opcode = avr.bad_opcode_irq()?;
        // SAFETY: the IRQs are this chip's; each callback expects a pointer to a `Wiring`, which outlives the chip.
        unsafe {
            avr.on(from_spi, spi_out, parameter);
            avr.on(bad_opcode, invalid_opcode, parameter);
            eeprom::connect(avr, wired.0);
            serial::connect::<FIRST>(avr, wired.0);
            serial::reset::<FIRST>(wired.0);
            if wired.bus.is_some() {
                serial::connect::<SECOND>(avr, wired.0);
                serial::reset::<SECOND>(wired.0);
            }
            adc::connect(avr, wired.0);
        }
        Ok(wired)
    }

    /// Puts bytes on the serial line to the program, from this cycle on. The end of the last one's stop bit.
    pub fn send_serial(&mut self, bytes: &[u8], flaw: Option<Flaw>, at: u64) -> u64 {
        self.send::<FIRST>(bytes, flaw, at)
    }

    /// The same on the line of the bus.
    ///
    /// # Panics
    /// Where the chip has none.
    pub fn send_bus(&mut self, bytes: &[u8], at: u64) -> u64 {
        self.send::<SECOND>(bytes, None, at)
    }

    fn send<const AT: u16>(&mut self, bytes: &[u8], flaw: Option<Flaw>, at: u64) -> u64 {
        let at = at.max(self.cycles());
        let wire = self.port_mut::<AT>().uart.wire();
        let ends = bytes.iter().map(|&byte| wire.send(byte, flaw, at));
        let end = ends.last().unwrap_or(at);
        // SAFETY: the chip is alive, and no reference to the wiring is held.
        unsafe { serial::settle::<AT>(self.0) };
        end
    }

    /// What a reset of the chip does around it. To be called when the chip has been reset, and counts from 0.
    pub fn after_reset(&mut self) {
        self.bad_opcode = None;
        self.eeprom.reset();
        self.adc = Adc::new();
        // SAFETY: the chip is alive, and no reference to the wiring is held.
        unsafe {
            eeprom::await_end(self.0);
            serial::reset::<FIRST>(self.0);
            if self.bus.is_some() {
                serial::reset::<SECOND>(self.0);
            }
            adc::settle(self.0);
        }
    }
}

impl Deref for Wired {
    type Target = Wiring;

    fn deref(&self) -> &Wiring {
        // SAFETY: the box is alive as long as `self`, and callbacks run only where nobody holds a reference (see `Wired`).
        unsafe { self.0.as_ref() }
    }
}

impl DerefMut for Wired {
    fn deref_mut(&mut self) -> &mut Wiring {
        // SAFETY: see `deref`.
        unsafe { self.0.as_mut() }
    }
}

impl Drop for Wired {
    fn drop(&mut self) {
        // SAFETY: the pointer came from a box, and the chip whose callbacks knew it is gone.
        drop(unsafe { Box::from_raw(self.0.as_ptr()) });
    }
}

impl Wiring {
    fn port<const AT: u16>(&self) -> &Port {
        match AT {
            FIRST => &self.usb,
            _ => self.bus.as_ref().expect("a chip with a second port"),
        }
    }

    fn port_mut<const AT: u16>(&mut self) -> &mut Port {
        match AT {
            FIRST => &mut self.usb,
            _ => self.bus.as_mut().expect("a chip with a second port"),
        }
    }

    /// The serial port.
    pub fn uart(&self) -> &Uart {
        &self.port::<FIRST>().uart
    }

    /// The same, to change.
    pub fn uart_mut(&mut self) -> &mut Uart {
        &mut self.port_mut::<FIRST>().uart
    }

    /// That of the bus.
    ///
    /// # Panics
    /// Where the chip has none.
    pub fn bus_mut(&mut self) -> &mut Uart {
        &mut self.port_mut::<SECOND>().uart
    }

    /// Cycles since the board was made; in a callback, up to the start of the instruction.
    pub fn cycles(&self) -> u64 {
        // SAFETY: the chip is alive.
        self.cycles_before + unsafe { Avr::cycle_of(self.avr) }
    }

    /// How far the chip is let run, in its own cycles: since the last reset.
    pub fn chips_leave(&self) -> Leave {
        Leave {
            end: self.leave.end.saturating_sub(self.cycles_before),
            ..self.leave
        }
    }

    /// The power goes, and comes back: what that does to EEPROM and card. A card that was pulled out stays so.
    pub fn power_cycle(&mut self) {
        let now = self.cycles();
        self.eeprom.power_off(now);
        self.power_cut = false;
        if let Slot::Card(card) = &mut self.slot
            && !card.is_removed()
        {
            card.power_cycle();
        }
    }

    /// Lets the card see its CS.
    pub fn select_card(&mut self, low: bool) {
        if let Slot::Card(card) = &mut self.slot {
            card.select(low);
        }
    }

    /// One byte over the SPI. An empty slot, or pins that are not outputs, read as 0xFF: MISO is pulled up.
    fn exchange(&mut self, mosi: u8) -> u8 {
        // SAFETY: called within a step, by the chip that is stepping; it writes nothing meanwhile.
        let ddr = unsafe { Avr::register_of(self.avr, reg::DDRB) };
        let now = self.cycles();
        let (sck, mosi_pin) = self.chip.card_pins();
        match &mut self.slot {
            Slot::Card(card) if ddr & sck != 0 => {
                card.set_time(now);
                card.exchange(if ddr & mosi_pin == 0 { 0xFF } else { mosi })
            }
            _ => 0xFF,
        }
    }
}

/// The program has shifted out a byte, so it has one to come.
///
/// simavr calls this when the byte is through: 8 × the divider of SPCR and SPSR after the write to SPDR.
unsafe extern "C" fn spi_out(_: *mut ffi::avr_irq_t, value: u32, wiring: *mut c_void) {
    let wiring = wiring.cast::<Wiring>();
    // SAFETY: `wiring` is what `Wired::new` registered; the reference ends before the IRQ is raised.
    let (irq, miso) = unsafe { ((*wiring).to_spi, (*wiring).exchange(value as u8)) };
    // SAFETY: the chip is the one that is stepping.
    unsafe { irq.raise(miso.into()) };
}

/// The program has come to an opcode that the chip does not have: stop it there.
unsafe extern "C" fn invalid_opcode(_: *mut ffi::avr_irq_t, value: u32, wiring: *mut c_void) {
    let wiring = wiring.cast::<Wiring>();
    // SAFETY: as in `spi_out`; the chip is the one that is stepping.
    unsafe {
        (*wiring).bad_opcode = Some(value as u16);
        Avr::crash((*wiring).avr);
    }
}
