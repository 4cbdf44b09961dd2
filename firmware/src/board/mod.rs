//! The Arduino UNO: the only place that touches registers.
//!
//! | point | pin | port |
//! | --- | --- | --- |
//! | inputs 01–04 | D2–D5 | PD2–PD5 |
//! | inputs 05–08, analogue inputs A 00–03 | A0–A3 | PC0–PC3 |
//! | analogue input A 04, direction of RS-485 | A4 | PC4 |
//! | outputs 01–04 | D6–D9 | PD6, PD7, PB0, PB1 |
//! | card | D10–D13 | PB2 CS, PB3 MOSI, PB4 MISO, PB5 SCK |
//! | LED L | D13 | PB5, when the card does not use it |
//! | serial | D0, D1 | USART0, timer 2 |
//! | direction of RS-485, where it is set | A4 | PC4 |
//! | STOP | A5 | PC5 |

/// The head of the clock's interrupt, by the number that the chip gives it.
macro_rules! tick_interrupt {
    () => {
        "
.macro  interrupt_tick
        .global __vector_13
        .type   __vector_13, @function
__vector_13:
.endm
"
    };
}

/// The same of the serial port's, and its direction of RS-485.
macro_rules! interrupts {
    () => {
        "
.macro  interrupt_received
        .global __vector_18
        .type   __vector_18, @function
__vector_18:
.endm
.macro  interrupt_may_send
        .global __vector_19
        .type   __vector_19, @function
__vector_19:
.endm
.macro  interrupt_sent
        .global __vector_20
        .type   __vector_20, @function
__vector_20:
.endm
.macro  direction_low
        cbi     0x08, 4         ; PORTC: the direction pin
.endm
"
    };
}

pub mod allowance;
pub mod analogue;
pub mod clock;
pub mod eeprom;
pub mod flash;
pub mod pins;
pub mod pwm;
pub mod serial;
mod shared;
pub mod spi;
pub mod stack;
pub mod watchdog;

pub use avr_device::atmega328p as chip;
use chip::{PORTC, Peripherals, SPI, TC0, TC1};
use unoclp_core::{Image, Millis};

/// The parts of the board, ready to use.
pub struct Board {
    /// Inputs, outputs, LED L and the card's select line.
    pub pins: pins::Pins,
    /// The serial port.
    pub serial: serial::Serial,
    /// The EEPROM.
    pub eeprom: eeprom::Eeprom,
    /// Analogue inputs and the supply voltage.
    pub analogue: analogue::Analogue,
    /// The watchdog.
    pub watchdog: watchdog::Watchdog,
    spi: SPI,
    timer: TC1,
    pwm: TC0,
}

impl Board {
    /// Takes the board and sets it up, outputs first (NC-7); all but the [serial line](serial::Serial::open).
    pub fn take() -> Board {
        // SAFETY: called once, by `main`, before anything else runs; so there is one owner of
        // each peripheral.
        let chip = unsafe { Peripherals::steal() };
        let pins = pins::Pins::new(chip.PORTB, chip.PORTC, chip.PORTD);
        stack::paint();
        let watchdog = watchdog::Watchdog::take(chip.WDT, &chip.CPU, clock::is_on(&chip.TC1));
        clock::start(&chip.TC1);
        // SAFETY: the port of `pins`; the serial port changes one bit of it, in single instructions.
        let direction = unsafe { PORTC::steal() };
        Board {
            pins,
            serial: serial::Serial::new(chip.USART0, chip.TC2, direction),
            eeprom: eeprom::Eeprom::new(chip.EEPROM),
            analogue: analogue::Analogue::start(chip.ADC),
            watchdog,
            spi: chip.SPI,
            timer: chip.TC1,
            pwm: chip.TC0,
        }
    }

    /// Makes outputs PWM, 0 to 255 of each; at 0 the pin is as its port has it. Only 01 and 04 can be, and
    /// only those that are among these, bit 0 output 01.
    #[inline(never)]
    pub fn write_pwm(&self, among: u8, duty: &[u8; 4]) {
        let [first, _, _, last] = *duty;
        if among & 1 != 0 {
            pwm::set_d6(&self.pwm, first);
        }
        if among & 8 != 0 {
            pwm::set_d9(&self.timer, last);
        }
    }

    /// All outputs off, those that are PWM too (NC-7).
    #[inline(never)]
    pub fn switch_outputs_off(&self) {
        self.write_pwm(u8::MAX, &[0; 4]);
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

    /// Begins again, as after a reset, once all has been sent.
    pub fn restart(&self) -> ! {
        while !self.serial.is_quiet() {}
        self.watchdog.restart()
    }

    /// Gives D10 to D13 back: the card is no longer selected, and LED L is ours.
    pub fn release_card(&self) {
        spi::release(&self.spi, &self.pins);
    }
}
