//! The UNO's map in memory, as far as `frames.toml` goes: in STOP, with no timer, counter or analogue input
//! in the program.

use std::collections::BTreeMap;

use unoclp_modbus::{Access, Device, Exception, Table};

/// Coils and holding registers that have been written; all others are 0 or as below.
#[derive(Default)]
pub struct Uno {
    coils: BTreeMap<u16, bool>,
    words: BTreeMap<u16, u16>,
}

/// First and last of the addresses.
fn ranges(table: Table) -> &'static [(u16, u16)] {
    match table {
        Table::Coils => &[(0, 71)],
        Table::DiscreteInputs => &[(0, 127)],
        Table::InputRegisters => &[(0, 38), (64, 255), (256, 287)],
        Table::HoldingRegisters => &[
            (2048, 2095),
            (3072, 3263),
            (3328, 3359),
            (4096, 4100),
            (4112, 4115),
        ],
    }
}

impl Device for Uno {
    fn has(&self, table: Table, first: u16, count: u16, access: Access) -> bool {
        let mut addresses = first..=first + (count - 1);
        addresses.all(|address| {
            let within = |&(first, last): &(u16, u16)| (first..=last).contains(&address);
            let only_read = table == Table::Coils && within(&(4, 7));
            ranges(table).iter().any(within) && !(only_read && access == Access::Write)
        })
    }

    fn bit(&self, table: Table, address: u16) -> bool {
        table == Table::Coils && self.coils.get(&address).is_some_and(|on| *on)
    }

    fn word(&self, table: Table, address: u16) -> u16 {
        let initial = match (table, address) {
            (Table::HoldingRegisters, 4112) => 1,
            (Table::HoldingRegisters, 4113) => 1152,
            (Table::HoldingRegisters, _) => 0,
            _ => return 0,
        };
        *self.words.get(&address).unwrap_or(&initial)
    }

    fn set_bit(&mut self, address: u16, on: bool) {
        self.coils.insert(address, on);
    }

    fn check_word(&self, address: u16, value: u16) -> Result<(), Exception> {
        let fine = match address {
            4112 => (1..=247).contains(&value),
            4113 => [24, 48, 96, 192, 384, 576, 1152].contains(&value),
            4114 => value <= 2,
            4115 => value <= 1,
            _ => true,
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

    fn identification(&self, object: u8, index: u8) -> Option<u8> {
        let texts = ["unoclp", "UNO", "0.1.0"];
        let text = texts[usize::from(object)].as_bytes();
        text.get(usize::from(index)).copied()
    }
}
