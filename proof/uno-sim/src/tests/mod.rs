//! The board with programs of a few instructions, assembled here.

mod analogue;
mod assembly;
mod board;
mod eeprom;
mod port;
mod power;
mod pwm;
mod serial;
mod serial_interrupts;
mod spi;

use crate::{Program, Slot, Uno};

fn board(words: &[u16]) -> Uno {
    Uno::with_program(Program::from_words(words), Slot::Empty).expect("simavr knows the chip")
}

fn steps(uno: &mut Uno, count: usize) {
    for _ in 0..count {
        uno.step().expect("the program goes on");
    }
}

fn working_register(uno: &Uno, r: u32) -> u8 {
    uno.read_ram(r, 1).expect("a register")[0]
}
