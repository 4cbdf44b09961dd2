//! The Arduino Mega 2560: the only place that touches its registers.
//!
//! | point | pin | port |
//! | --- | --- | --- |
//! | inputs 01–08 | D22–D29 | PA0–PA7 |
//! | inputs 09–16 | A8–A15 | PK0–PK7 |
//! | inputs 17–24 | D37–D30 | PC0–PC7 |
//! | analogue inputs A 00–07 | A0–A7 | PF0–PF7 |
//! | outputs 01–08 | D2–D9 | PE4, PE5, PG5, PE3, PH3–PH6 |
//! | outputs 09–16 | D49–D42 | PL0–PL7 |
//! | card | D50–D53 | PB3 MISO, PB2 MOSI, PB1 SCK, PB0 CS |
//! | LED L | D13 | PB7 |
//! | serial, USB | D0, D1 | USART0, timer 2 |
//! | serial, bus | D19, D18 | USART1, timer 0 |
//! | direction of RS-485 on the bus, where it is set | D20 | PD1 |
//! | STOP | D21 | PD0 |

/// The head of the clock's interrupt, by the number that the chip gives it.
macro_rules! tick_interrupt {
    () => {
        "
.macro  interrupt_tick
        .global __vector_20
        .type   __vector_20, @function
__vector_20:
.endm
"
    };
}

/// The same of the serial port's; the direction of RS-485 is the bus's.
macro_rules! interrupts {
    () => {
        "
.macro  interrupt_received
        .global __vector_25
        .type   __vector_25, @function
__vector_25:
.endm
.macro  interrupt_may_send
        .global __vector_26
        .type   __vector_26, @function
__vector_26:
.endm
.macro  interrupt_sent
        .global __vector_27
        .type   __vector_27, @function
__vector_27:
.endm
.macro  direction_low
.endm
"
    };
}

/// The same of the bus.
macro_rules! bus_interrupts {
    () => {
        "
.macro  bus_interrupt_received
        .global __vector_36
        .type   __vector_36, @function
__vector_36:
.endm
.macro  bus_interrupt_may_send
        .global __vector_37
        .type   __vector_37, @function
__vector_37:
.endm
.macro  bus_interrupt_sent
        .global __vector_38
        .type   __vector_38, @function
__vector_38:
.endm
.macro  bus_direction_low
        cbi     0x0B, 1         ; PORTD: the direction pin
.endm
"
    };
}

#[path = "../board/allowance.rs"]
pub mod allowance;
#[path = "../board/analogue.rs"]
pub mod analogue;
#[path = "../board/clock.rs"]
pub mod clock;
#[path = "../board/eeprom.rs"]
pub mod eeprom;
#[path = "../board/flash.rs"]
pub mod flash;
pub mod pins;
pub mod pwm;
#[path = "../board/serial.rs"]
pub mod serial;
/// The second serial port, from the source of the first (`build.rs`).
#[allow(dead_code, reason = "no text is sent to it")]
pub mod bus {
    include!(concat!(env!("OUT_DIR"), "/bus.rs"));
}
#[path = "../board/shared.rs"]
mod shared;
#[path = "../board/spi.rs"]
pub mod spi;
#[path = "../board/stack.rs"]
pub mod stack;
#[path = "../board/watchdog.rs"]
pub mod watchdog;

use crate::engine::data::PWM;
pub use avr_device::atmega2560 as chip;
use chip::{PORTD, Peripherals, SPI, TC1, TC3, TC4, TC5};
use unoclp_core::{Image, Millis};

/// The parts of the board, ready to use.
pub struct Board {
    /// Inputs, outputs, LED L and the card's select line.
    pub pins: pins::Pins,
    /// The serial port of USB.
    pub serial: serial::Serial,
    /// That of a bus.
    pub bus: bus::Serial,
    /// The EEPROM.
    pub eeprom: eeprom::Eeprom,
    /// Analogue inputs and the supply voltage.
    pub analogue: analogue::Analogue,
    /// The watchdog.
    pub watchdog: watchdog::Watchdog,
    spi: SPI,
    timer: TC1,
    pwm: (TC3, TC4, TC5),
}

impl Board {
    /// Takes the board and sets it up, outputs first (NC-7); all but the [serial line](serial::Serial::open).
    pub fn take() -> Board {
        // SAFETY: called once, by `main`, before anything else runs; so there is one owner of
        // each peripheral.
        let chip = unsafe { Peripherals::steal() };
        let pins = pins::Pins::take();
        stack::paint();
        let watchdog = watchdog::Watchdog::take(chip.WDT, &chip.CPU, clock::is_on(&chip.TC1));
        clock::start(&chip.TC1);
        // SAFETY: the port of `pins`; the serial ports change one bit of it, in single instructions.
        let direction = || unsafe { PORTD::steal() };
        Board {
            pins,
            serial: serial::Serial::new(chip.USART0, chip.TC2, direction()),
            bus: bus::Serial::new(chip.USART1, chip.TC0, direction()),
            eeprom: eeprom::Eeprom::new(chip.EEPROM),
            analogue: analogue::Analogue::start(chip.ADC),
            watchdog,
            spi: chip.SPI,
            timer: chip.TC1,
            pwm: (chip.TC3, chip.TC4, chip.TC5),
        }
    }

    /// Makes outputs PWM, 0 to 255 of each; at 0 the pin is as its port has it. Only those that are among these, bit 0
    /// output 01.
    #[inline(never)]
    pub fn write_pwm(&self, among: u32, duty: &[u8; PWM]) {
        if among == 0 {
            return;
        }
        let (third, fourth, fifth) = &self.pwm;
        pwm::write(third, fourth, fifth, among, Some(duty));
    }

    /// Gives the pins of these outputs back.
    #[inline(never)]
    pub fn end_pwm(&self, among: u32) {
        if among == 0 {
            return;
        }
        let (third, fourth, fifth) = &self.pwm;
        pwm::write(third, fourth, fifth, among, None);
    }

    /// All outputs off, those that are PWM too (NC-7).
    #[inline(never)]
    pub fn switch_outputs_off(&self) {
        self.end_pwm(u32::MAX);
        self.pins.write_outputs(Image::default());
    }

    /// The time in ms since start, and this moment.
    #[inline(always)]
    pub fn moment(&self) -> (Millis, clock::Moment) {
        clock::moment(&self.timer)
    }

    /// The bus to the card, which still sleeps.
    pub fn card_bus(&self) -> spi::CardBus<'_> {
        let bus = spi::CardBus::new(&self.spi, &self.pins);
        if watchdog::started() != watchdog::Start::Power {
            // The card has kept its power, and is long out of its idle state.
            bus.end_packet();
        }
        bus
    }

    /// The bus to the card, at full speed, with the card selected: for what comes after start-up.
    #[inline(always)]
    pub fn resume_card(&self) -> spi::CardBus<'_> {
        let bus = spi::CardBus::new(&self.spi, &self.pins);
        bus.full_speed();
        bus
    }

    /// Whether nothing is being received, handled or sent on either port.
    #[inline(always)]
    pub fn is_quiet(&self) -> bool {
        self.serial.is_quiet() && self.bus.is_quiet()
    }

    /// Begins again, as after a reset, once all has been sent. What a line is hearing meanwhile would not end.
    pub fn restart(&self) -> ! {
        while self.serial.is_sending() || self.bus.is_sending() {}
        self.watchdog.restart()
    }

    /// Gives D50 to D53 back: the card is no longer selected.
    pub fn release_card(&self) {
        spi::release(&self.spi, &self.pins);
    }
}

/// What stops everything: outputs off, without an owner of the chip.
pub fn switch_off() {
    // SAFETY: nothing else runs any more, so nobody else uses the timers.
    let chip = unsafe { Peripherals::steal() };
    let _ = pins::Pins::take();
    pwm::write(&chip.TC3, &chip.TC4, &chip.TC5, u32::MAX, None);
}
