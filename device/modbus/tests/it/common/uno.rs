//! The UNO's map in memory, as far as `frames.toml` goes: in STOP, with its program.

use std::collections::BTreeMap;

use unoclp_modbus::{Access, Exception, Points, Table};

/// Coils and holding registers that have been written; all others are 0 or as below.
#[derive(Default)]
pub struct Uno {
    coils: BTreeMap<u16, bool>,
    words: BTreeMap<u16, u16>,
}

/// The window of an upload, which is not under way.
const WINDOW: u16 = 1000;

/// First and last of the addresses. Of the presets, only those of two timers and two counters can be written.
fn ranges(table: Table, access: Access) -> &'static [(u16, u16)] {
    match (table, access) {
        (Table::Coils, _) => &[(0, 3), (16, 79)],
        (Table::DiscreteInputs, _) => &[(0, 7)],
        (Table::InputRegisters, _) => &[(0, 4), (16, 32), (128, 301), (320, 351)],
        (Table::HoldingRegisters, Access::Read) => &[
            (0, 301),
            (320, 351),
            (400, 400),
            (402, 406),
            (410, 414),
            (2000, 2195),
        ],
        (Table::HoldingRegisters, Access::Write) => &[
            (0, 131),
            (320, 323),
            (400, 400),
            (402, 406),
            (410, 414),
            (2000, 2195),
        ],
    }
}

/// What a holding register is before it is written: presets, state, settings.
fn initial(address: u16) -> u16 {
    match address {
        129 => 1000,
        130 => 1,
        131 => 0x86A0,
        321 => 5,
        322 => 1,
        323 => 0x1170,
        400 => 2,
        410 => 1,
        411 => 1152,
        _ => 0,
    }
}

impl Points for Uno {
    fn has(&self, table: Table, first: u16, count: u16, access: Access) -> bool {
        let last = first + (count - 1);
        let within = |&(start, end): &(u16, u16)| start <= first && last <= end;
        ranges(table, access).iter().any(within)
    }

    fn bit(&self, table: Table, address: u16) -> bool {
        table == Table::Coils && self.coils.get(&address).is_some_and(|on| *on)
    }

    fn word(&self, table: Table, address: u16) -> u16 {
        match (table, address) {
            (Table::InputRegisters, 16) => 2,
            (Table::InputRegisters, _) => 0,
            // The first registers are in two places.
            (_, 2000..2064) => self.word(table, address - 2000),
            _ => *self.words.get(&address).unwrap_or(&initial(address)),
        }
    }

    fn set_bit(&mut self, address: u16, on: bool) {
        self.coils.insert(address, on);
    }

    fn check_word(&self, address: u16, value: u16) -> Result<(), Exception> {
        let fine = match address {
            0..128 | 2000.. => true,
            // Of a preset, the sign.
            128..400 => address % 2 == 1 || value < 0x8000,
            400 => (1..=5).contains(&value),
            402 | 403 | 406 => value < 1 << 8,
            404 | 405 => value < 1 << 4,
            410 => (1..=247).contains(&value),
            411 => (24..=1152).contains(&value),
            412 => value <= 2,
            413 => value <= 1,
            _ => value <= 15,
        };
        if fine {
            Ok(())
        } else {
            Err(Exception::IllegalDataValue)
        }
    }

    fn set_word(&mut self, address: u16, value: u16) {
        match address {
            // The program has no others.
            64..128 | 2064.. => {}
            2000.. => self.set_word(address - 2000, value),
            _ => {
                self.words.insert(address, value);
            }
        }
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
