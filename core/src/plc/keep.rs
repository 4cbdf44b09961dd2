//! The snapshot of the numbers that are kept (NC-21): the data of the instructions that name them, which are
//! the first of the program.

use super::Plc;
use crate::kept::{self, Number};

impl Plc<'_> {
    /// The numbers that are kept over a power cut as they stand, in the program's order.
    pub fn kept(&mut self) -> impl Iterator<Item = i32> {
        let code = self.code;
        kept::numbers(code).map(move |number| self.number(number))
    }

    /// Brings back what was kept, before the first scan.
    pub fn keep(&mut self, values: impl IntoIterator<Item = i32>) {
        for (number, value) in kept::numbers(self.code).zip(values) {
            self.set_number(number, value);
        }
    }

    /// Takes the snapshot; gives how many bytes it is long.
    pub(super) fn save(&mut self) -> usize {
        let mut length = 0;
        for number in kept::numbers(self.code) {
            let value = self.number(number).to_le_bytes();
            if let Some(place) = self.own.get_mut(length..length + value.len()) {
                place.copy_from_slice(&value);
            }
            length += value.len();
        }
        length
    }

    /// Brings the snapshot back.
    pub(super) fn recall(&mut self) {
        for (index, number) in kept::numbers(self.code).enumerate() {
            if let Some(&value) = self.own.as_chunks().0.get(index) {
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
