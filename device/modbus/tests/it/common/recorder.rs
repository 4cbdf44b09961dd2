//! A device with addresses at every edge, whose values are a function of their addresses, and that writes
//! down what is asked of it.

use std::cell::RefCell;
use std::collections::BTreeSet;

use unoclp_modbus::{Access, Exception, Points, Table};

/// The first address of the window for blocks.
pub const WINDOW: u16 = 0x2000;

/// The addresses that exist in every table.
const EVERYWHERE: [(u16, u16); 5] = [
    (0, 9),
    (0x1000, 0x1000 + 2000),
    (0x3001, 0x3001 + 130),
    (0x7FFE, 0x8001),
    (0xF800, 0xFFFF),
];

/// Whether one address exists. Each table has an address of its own, 100 times its number; coils 4 to 7
/// and registers 0xF900 to 0xF90F are only to be read.
pub fn exists(table: Table, address: u16, access: Access) -> bool {
    let only_read = match table {
        Table::Coils => (4..8).contains(&address),
        _ => address & 0xFFF0 == 0xF900,
    };
    let everywhere = |(first, last)| (first..=last).contains(&address);
    let exists = EVERYWHERE.into_iter().any(everywhere) || address == 100 * table as u16;
    exists && !(access == Access::Write && only_read)
}

pub fn word_at(table: Table, address: u16) -> u16 {
    (address ^ 0x5A00 ^ table as u16).wrapping_mul(0x9E37)
}

pub fn bit_at(table: Table, address: u16) -> bool {
    word_at(table, address) & 0x0100 != 0
}

/// What the device says to a value: some cannot be taken, some fail.
pub fn check(value: u16) -> Result<(), Exception> {
    match value & 0xFFF0 {
        0xBAD0 => Err(Exception::IllegalDataValue),
        0xDEA0 => Err(Exception::ServerDeviceFailure),
        _ => Ok(()),
    }
}

/// What it says to a block.
pub fn check_block(data: &[u8]) -> Result<(), Exception> {
    match data {
        [0xEE, ..] => Err(Exception::ServerDeviceBusy),
        [0xEF, ..] => Err(Exception::IllegalDataValue),
        _ => Ok(()),
    }
}

pub fn text(object: u8) -> &'static [u8] {
    match object {
        0 => b"vendor",
        1 => b"",
        2 => b"1.2.3",
        _ => panic!("there is no object {object}"),
    }
}

/// What the device was asked for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Call {
    Bit(u16),
    Word(u16),
    Check(u16),
    SetBit(u16, bool),
    SetWord(u16, u16),
    Take(u16, Vec<u8>),
    /// None: between two slices.
    Scan,
}

#[derive(Debug, Default)]
pub struct Recorder {
    calls: RefCell<Vec<Call>>,
    checked: RefCell<BTreeSet<u16>>,
    written: bool,
    /// How many words are done at once.
    most: u8,
    /// What `has` affirmed last.
    granted: RefCell<Option<(Table, u16, u16, Access)>>,
}

impl Recorder {
    /// One that does so many words at once.
    pub fn of(most: u8) -> Recorder {
        Recorder {
            most,
            ..Recorder::default()
        }
    }

    pub fn scan(&mut self) {
        self.calls.get_mut().push(Call::Scan);
    }

    pub fn calls(&self) -> Vec<Call> {
        self.calls.borrow().clone()
    }

    /// What has changed the device.
    pub fn writes(&self) -> Vec<Call> {
        let mut calls = self.calls();
        calls.retain(|call| matches!(call, Call::SetBit(..) | Call::SetWord(..) | Call::Take(..)));
        calls
    }

    fn note(&self, call: Call) {
        self.calls.borrow_mut().push(call);
    }

    fn must_be_granted(&self, table: Table, address: u16, access: Access) {
        let granted = *self.granted.borrow();
        let within = granted.is_some_and(|(t, first, count, a)| {
            t == table && a == access && address.wrapping_sub(first) < count
        });
        assert!(
            within,
            "{table:?} {address:#x} {access:?}: only {granted:x?}"
        );
    }
}

impl Points for Recorder {
    fn has(&self, table: Table, first: u16, count: u16, access: Access) -> bool {
        let last = first.checked_add(count.checked_sub(1).unwrap()).unwrap();
        let has = (first..=last).all(|address| exists(table, address, access));
        *self.granted.borrow_mut() = has.then_some((table, first, count, access));
        has
    }

    fn bit(&self, table: Table, address: u16) -> bool {
        self.must_be_granted(table, address, Access::Read);
        self.note(Call::Bit(address));
        bit_at(table, address)
    }

    fn word(&self, table: Table, address: u16) -> u16 {
        self.must_be_granted(table, address, Access::Read);
        self.note(Call::Word(address));
        word_at(table, address)
    }

    fn set_bit(&mut self, address: u16, on: bool) {
        self.must_be_granted(Table::Coils, address, Access::Write);
        self.note(Call::SetBit(address, on));
    }

    fn check_word(&self, address: u16, value: u16) -> Result<(), Exception> {
        self.must_be_granted(Table::HoldingRegisters, address, Access::Write);
        assert!(!self.written, "{address:#x} is checked after a write");
        self.checked.borrow_mut().insert(address);
        self.note(Call::Check(address));
        check(value)
    }

    fn set_word(&mut self, address: u16, value: u16) {
        self.must_be_granted(Table::HoldingRegisters, address, Access::Write);
        let checked = self.checked.get_mut().contains(&address);
        self.written = true;
        assert!(checked && check(value).is_ok(), "{address:#x}, {value:#x}");
        self.note(Call::SetWord(address, value));
    }

    fn take(&mut self, first: u16, data: &[u8]) -> Option<Result<(), Exception>> {
        assert!((2..=246).contains(&data.len()) && data.len().is_multiple_of(2));
        if first != WINDOW {
            return None;
        }
        self.note(Call::Take(first, data.to_vec()));
        Some(check_block(data))
    }

    fn at_once(&self) -> u8 {
        self.most
    }

    fn identification(&self, object: u8, index: u8) -> Option<u8> {
        text(object).get(usize::from(index)).copied()
    }
}
