//! The snapshot of the numbers that are kept (NC-21): among the data of the instructions that name them, which are
//! the first of the program.

use super::Plc;
use crate::isa::Opcode;
use crate::kept::{self, NUMBER_BYTES, Number};

/// Bytes of data of each of those instructions. The snapshot comes first; the rest is for a board's engine.
const DATA: usize = Opcode::KeepRegister.row().own as usize;

const _: () = assert!(DATA >= NUMBER_BYTES as usize);
const _: () = assert!(DATA == Opcode::KeepCounter.row().own as usize);

impl Plc<'_> {
    /// Takes the snapshot; gives how many bytes of data it stands in.
    pub(super) fn save(&mut self) -> usize {
        let mut length = 0;
        for number in kept::numbers(self.code) {
            let value = self.number(number).to_le_bytes();
            if let Some(place) = self.own.get_mut(length..length + value.len()) {
                place.copy_from_slice(&value);
            }
            length += DATA;
        }
        length
    }

    /// Brings the snapshot back.
    pub(super) fn recall(&mut self) {
        for (index, number) in kept::numbers(self.code).enumerate() {
            let data = self.own.get(index * DATA..).unwrap_or_default();
            if let Some(&value) = data.first_chunk() {
                self.set_number(number, i32::from_le_bytes(value));
            }
        }
    }

    fn number(&mut self, number: Number) -> i32 {
        match number {
            Number::Register(register) => self.register(register),
            Number::Counter(counter) => self.with_counter(counter, |counter| counter.value),
        }
    }

    fn set_number(&mut self, number: Number, value: i32) {
        match number {
            Number::Register(register) => self.set_register(register, value),
            Number::Counter(counter) => self.with_counter(counter, |counter| counter.value = value),
        }
    }
}
