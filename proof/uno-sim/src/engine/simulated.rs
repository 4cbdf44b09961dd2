//! What an engine needs of a simulated board, whoever simulates it.

use super::error::EngineError;
use crate::sd::{Kind, SdCard};
use crate::{Analogue, Error, Halt, Pin, Program, Pwm, Slot, Uno};

/// A board with the firmware, simulated. [`Uno`] is one, on simavr; [`crate::avr8js::Avr8js`] is another.
pub trait Simulated: Sized {
    /// A board with this program and a card with this image, just powered, its EEPROM erased. `before` is one that is no
    /// longer needed, and may become this one.
    ///
    /// # Errors
    /// Where the simulation cannot be set up.
    fn powered(
        program: &Program,
        image: Vec<u8>,
        before: Option<Self>,
    ) -> Result<Self, EngineError>;

    /// Takes the power away and gives it back. What was sent before is forgotten, and which outputs have moved.
    fn cut_power(&mut self);

    /// Cycles since the board was made.
    fn cycles(&self) -> u64;

    /// Runs for at least so many cycles.
    ///
    /// # Errors
    /// Where the program or the simulator came to an end.
    fn run_cycles(&mut self, cycles: u64) -> Result<(), Halt>;

    /// Runs until the instruction at this byte address is the next one; at least one is executed.
    ///
    /// # Errors
    /// [`Halt::Timeout`] where that takes more than so many cycles; else as [`Simulated::run_cycles`].
    fn run_until(&mut self, address: u32, max_cycles: u64) -> Result<(), Halt>;

    /// Switches the timer interrupts off: the millisecond clock shows what is written to it.
    fn stop_clock(&mut self);

    /// Bytes of data space.
    ///
    /// # Errors
    /// Where they do not all lie there.
    fn read_ram(&self, address: u32, len: usize) -> Result<&[u8], Error>;

    /// Writes bytes into RAM.
    ///
    /// # Errors
    /// Where they do not all lie there.
    fn write_ram(&mut self, address: u32, bytes: &[u8]) -> Result<(), Error>;

    /// Closes the buttons whose bits are set (bit n: input n + 1) and opens the others.
    fn set_inputs(&mut self, closed: u32);

    /// Turns the potentiometer at analogue input `index` to where the converter reads this.
    fn set_reading(&mut self, index: usize, reading: u16);

    /// Bytes go to the board.
    fn send_serial(&mut self, bytes: &[u8]);

    /// What the board has sent since [`Simulated::take_serial`].
    fn serial(&self) -> &[u8];

    /// The same, and forgets it.
    fn take_serial(&mut self) -> Vec<u8>;

    /// Bit n: output n + 1 is on.
    fn outputs(&self) -> u32;

    /// An output, from 0, whose level has changed since the power came.
    fn moved_output(&self) -> Option<u8>;

    /// The pulses on output `index`, from 0, where a timer makes them.
    fn pwm(&self, index: usize) -> Option<Pwm>;
}

impl Simulated for Uno {
    fn powered(program: &Program, image: Vec<u8>, _: Option<Uno>) -> Result<Uno, EngineError> {
        let card = SdCard::new(Kind::Sdhc, image)?;
        Ok(Uno::with_program(program.clone(), Slot::Card(card))?)
    }

    fn cut_power(&mut self) {
        self.power_up();
        Uno::take_serial(self);
        self.take_edges();
    }

    fn cycles(&self) -> u64 {
        Uno::cycles(self)
    }

    fn run_cycles(&mut self, cycles: u64) -> Result<(), Halt> {
        Uno::run_cycles(self, cycles)
    }

    fn run_until(&mut self, address: u32, max_cycles: u64) -> Result<(), Halt> {
        Uno::run_until(self, address, max_cycles)
    }

    fn stop_clock(&mut self) {
        Uno::stop_clock(self);
    }

    fn read_ram(&self, address: u32, len: usize) -> Result<&[u8], Error> {
        Uno::read_ram(self, address, len)
    }

    fn write_ram(&mut self, address: u32, bytes: &[u8]) -> Result<(), Error> {
        Uno::write_ram(self, address, bytes)
    }

    fn set_inputs(&mut self, closed: u32) {
        self.set_all_inputs(closed);
    }

    fn set_reading(&mut self, index: usize, reading: u16) {
        self.set_analogue(index, Analogue::Reading(reading));
    }

    fn send_serial(&mut self, bytes: &[u8]) {
        Uno::send_serial(self, bytes);
    }

    fn serial(&self) -> &[u8] {
        self.serial_bytes()
    }

    fn take_serial(&mut self) -> Vec<u8> {
        Uno::take_serial(self)
    }

    fn outputs(&self) -> u32 {
        self.all_outputs()
    }

    fn moved_output(&self) -> Option<u8> {
        self.edges().iter().find_map(|edge| match edge.pin {
            Pin::Output(output) => Some(output),
            Pin::Led | Pin::Direction => None,
        })
    }

    fn pwm(&self, index: usize) -> Option<Pwm> {
        Uno::pwm(self, index)
    }
}
