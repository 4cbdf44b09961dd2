//! The UNO's map in memory, as far as `frames.toml` goes: in STOP.

use std::collections::BTreeMap;

use unoclp_modbus::{Access, Device, Exception, Table};

/// Coils and holding registers that have been written; all others are 0 or as below.
#[derive(Default)]
pub struct Uno {
    coils: BTreeMap<u16, bool>,
    words: BTreeMap<u16, u16>,
}

/// The window of an upload, which is not under way.
const WINDOW: u16 = 1000;

/// First and last of the addresses.
fn ranges(table: Table) -> &'static [(u16, u16)] {
    match table {
        Table::Coils | Table::DiscreteInputs => &[(0, 3)],
        Table::InputRegisters => &[(16, 32)],
        Table::HoldingRegisters => &[(400, 400), (402, 405), (410, 413)],
    }
}

impl Device for Uno {
    fn has(&self, table: Table, first: u16, count: u16, _: Access) -> bool {
        let last = first + (count - 1);
        let within = |&(start, end): &(u16, u16)| start <= first && last <= end;
        ranges(table).iter().any(within)
    }

    fn bit(&self, table: Table, address: u16) -> bool {
        table == Table::Coils && self.coils.get(&address).is_some_and(|on| *on)
    }

    fn word(&self, table: Table, address: u16) -> u16 {
        let initial = match (table, address) {
            (Table::InputRegisters, 16) | (Table::HoldingRegisters, 400) => return 2,
            (Table::InputRegisters, _) => return 0,
            (_, 410) => 1,
            (_, 411) => 1152,
            _ => 0,
        };
        *self.words.get(&address).unwrap_or(&initial)
    }

    fn set_bit(&mut self, address: u16, on: bool) {
        self.coils.insert(address, on);
    }

    fn check_word(&self, address: u16, value: u16) -> Result<(), Exception> {
        let fine = match address {
            400 => (1..=5).contains(&value),
            402..=405 => value < 16,
            410 => (1..=247).contains(&value),
            411 => (24..=1152).contains(&value),
            412 => value <= 2,
            _ => value <= 1,
        };
        if fine {
            Ok(())
        } else {
            Err(Exception::IllegalDataValue)
        }
    }

    fn set_word(&mut self, address: u16, value: u16) {
        self.words.insert(address, value);
    }

    fn take(&mut self, first: u16, _: &[u8]) -> Option<Result<(), Exception>> {
        (first == WINDOW).then_some(Err(Exception::ServerDeviceFailure))
    }

    fn identification(&self, object: u8, index: u8) -> Option<u8> {
        let texts = ["unoclp", "unoclp UNO", "0.1.0"];
        let text = texts[usize::from(object)].as_bytes();
        text.get(usize::from(index)).copied()
    }
}
