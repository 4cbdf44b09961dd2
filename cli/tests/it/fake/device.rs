//! The map of a board in memory, with its states, as `docs/modbus.md` defines them.

use std::collections::BTreeMap;
use unoclp_board::diagnostics::Kept;
use unoclp_core::{Cause, Fault, Loader};
use unoclp_modbus::{Access, Device, Exception, Table};
use unoclp_source::BOARD;

pub const RUN: u16 = 1;
pub const STOP: u16 = 2;
pub const FAULT: u16 = 3;

/// What an upload under way has got.
pub struct Upload {
    /// The next block's number.
    next: u8,
    /// What checks the text of the first time.
    loader: Loader<'static>,
    /// The text of the first and of the second time.
    texts: [Vec<u8>; 2],
    /// The first has ended.
    second: bool,
}

/// A board.
pub struct Board {
    /// Vendor, product, version.
    pub identity: [&'static str; 3],
    /// Whether it knows function 43.
    pub identifies: bool,
    pub state: u16,
    /// A5 is closed.
    pub switch: bool,
    /// Stopped by command.
    pub stopped: bool,
    pub fault: u16,
    pub line: u32,
    pub kept: Kept,
    /// The text of the program that it keeps, where it was uploaded.
    pub text: Vec<u8>,
    /// The program on its card, which a restart takes.
    pub card: Option<Vec<u8>>,
    /// A fault that it finds in the second text.
    pub second_differs: bool,
    /// A fault that it finds when it restarts.
    pub fault_at_restart: u16,
    pub inputs: u16,
    pub outputs: u16,
    pub markers: u64,
    /// Without markers, registers and analogue inputs.
    pub is_of_version_1: bool,
    /// Words that read as something else than 0, and have no meaning to the board.
    pub words: BTreeMap<(u16, u16), u16>,
    /// Forced inputs, to what; forced outputs, to what.
    pub forces: [u16; 4],
    pub settings: [u16; 4],
    /// It does not keep settings.
    pub eeprom_fails: bool,
    pub single_scans: u32,
    pub restarts: u32,
    pub upload: Option<Upload>,
}

impl Default for Board {
    fn default() -> Board {
        Board {
            identity: ["unoclp", "unoclp UNO", "0.1.0"],
            identifies: true,
            state: RUN,
            switch: false,
            stopped: false,
            fault: 0,
            line: 0,
            kept: Kept { bytes: 3, crc: 77 },
            text: Vec::new(),
            card: None,
            second_differs: false,
            fault_at_restart: 0,
            inputs: 0,
            outputs: 0,
            markers: 0,
            is_of_version_1: false,
            words: BTreeMap::new(),
            forces: [0; 4],
            settings: [1, 1152, 0, 0],
            eeprom_fails: false,
            single_scans: 0,
            restarts: 0,
            upload: None,
        }
    }
}

impl Board {
    /// In this state.
    pub fn in_state(state: u16) -> Board {
        Board {
            state,
            ..Board::default()
        }
    }

    /// Whether an upload is under way.
    pub fn is_uploading(&self) -> bool {
        self.upload.is_some()
    }

    fn allows(&self, command: u16) -> bool {
        let (stop, uploading) = (self.state == STOP, self.is_uploading());
        match command {
            1 => self.state == RUN || stop && !self.switch && !uploading,
            2 => self.state != FAULT || uploading,
            3 => stop && !self.switch && !uploading,
            5 => self.state != RUN,
            _ => true,
        }
    }

    fn command(&mut self, command: u16) {
        match command {
            1 => (self.state, self.stopped) = (RUN, false),
            2 if self.is_uploading() => self.upload = None,
            2 => (self.state, self.stopped) = (STOP, true),
            3 => self.single_scans += 1,
            4 => self.restart(),
            _ => {
                self.fault = 0;
                self.upload = Some(Upload {
                    next: 0,
                    loader: Loader::new(vec![0; BOARD.linked_bytes.into()].leak(), BOARD),
                    texts: [Vec::new(), Vec::new()],
                    second: false,
                });
            }
        }
    }

    fn restart(&mut self) {
        self.restarts += 1;
        self.forces = [0; 4];
        self.upload = None;
        if let Some(card) = &self.card {
            self.kept = Kept::of(card).unwrap();
        }
        (self.fault, self.line) = (self.fault_at_restart, 0);
        self.state = match (self.fault, self.switch) {
            (0, false) => RUN,
            (0, true) => STOP,
            _ => FAULT,
        };
    }

    fn block(&mut self, data: &[u8]) -> Result<(), Exception> {
        let Some(upload) = &mut self.upload else {
            return Err(Exception::ServerDeviceFailure);
        };
        let (number, size) = (data[0], usize::from(data[1]));
        let words = size.div_ceil(2);
        if size > 244 || data.len() != 2 + 2 * words {
            return Err(Exception::IllegalDataValue);
        }
        if number == upload.next.wrapping_sub(1) && !upload.texts[0].is_empty() {
            return Ok(());
        }
        if number != upload.next {
            return Err(Exception::IllegalDataValue);
        }
        upload.next = number.wrapping_add(1);
        let time = usize::from(upload.second);
        upload.texts[time].extend(&data[2..2 + size]);
        let [first, second] = &upload.texts;
        let ends = size == 0;
        let mut bytes = data[2..2 + size].iter();
        let checked = match (upload.second, ends) {
            (true, _) if self.second_differs || !first.starts_with(second) => {
                Err(Fault::without_line(Cause::FileChanged))
            }
            (true, _) => Ok(()),
            (false, false) => bytes.try_for_each(|&byte| upload.loader.push(byte)),
            (false, true) => upload.loader.end(),
        };
        let fault = checked
            .err()
            .map(|fault| (fault.cause.number().into(), fault.line.unwrap_or(0)));
        if let Some((number, line)) = fault {
            (self.fault, self.line, self.upload) = (number, line, None);
            return Err(Exception::ServerDeviceFailure);
        }
        if ends && upload.second {
            self.text = first.clone();
            self.kept = Kept::of(first).unwrap();
            self.upload = None;
        } else if ends {
            upload.second = true;
        }
        Ok(())
    }

    fn flags(&self) -> u16 {
        let forced = self.forces[0] | self.forces[2] != 0;
        u16::from(self.switch)
            | u16::from(self.stopped) << 1
            | u16::from(forced) << 2
            | u16::from(self.is_uploading()) << 3
    }
}

impl Device for Board {
    fn has(&self, table: Table, first: u16, count: u16, access: Access) -> bool {
        let last = first + (count - 1);
        let within = |&(a, b): &(u16, u16)| (a..=b).contains(&first) && (a..=b).contains(&last);
        let old = self.is_of_version_1;
        let ranges: &[(u16, u16)] = match (table, access) {
            (Table::Coils | Table::DiscreteInputs, _) if old => &[(0, 3)],
            (Table::InputRegisters, _) if old => &[(16, 32)],
            (Table::HoldingRegisters, _) if old => &[(400, 400), (402, 405), (410, 413)],
            (Table::Coils, _) => &[(0, 3), (16, 79)],
            (Table::DiscreteInputs, _) => &[(0, 7)],
            (Table::InputRegisters, _) => &[(0, 4), (16, 32), (128, 301), (320, 351)],
            (Table::HoldingRegisters, _) => &[
                (0, 63),
                (128, 301),
                (320, 351),
                (400, 400),
                (402, 405),
                (410, 413),
            ],
        };
        ranges.iter().any(within)
    }

    fn bit(&self, table: Table, address: u16) -> bool {
        match (table, address) {
            (Table::DiscreteInputs, _) => {
                let [points, to, ..] = self.forces;
                (self.inputs & !points | to) >> address & 1 != 0
            }
            (_, 0..4) => self.outputs >> address & 1 != 0,
            _ => self.markers >> (address - 16) & 1 != 0,
        }
    }

    fn word(&self, table: Table, address: u16) -> u16 {
        let [line_high, line_low] = [(self.line >> 16) as u16, self.line as u16];
        match (table, address) {
            (Table::InputRegisters, 16) | (Table::HoldingRegisters, 400) => self.state,
            (Table::InputRegisters, 17) => self.flags(),
            (Table::InputRegisters, 18) => self.fault,
            (Table::InputRegisters, 20) => line_high,
            (Table::InputRegisters, 21) => line_low,
            (Table::InputRegisters, 28) => self.kept.bytes,
            (Table::InputRegisters, 29) => self.kept.crc,
            (Table::HoldingRegisters, 402..406) => self.forces[usize::from(address - 402)],
            (Table::HoldingRegisters, 410..414) => self.settings[usize::from(address - 410)],
            (table, _) => {
                let word = self.words.get(&(table as u16, address));
                word.copied().unwrap_or_default()
            }
        }
    }

    fn set_bit(&mut self, _: u16, _: bool) {}

    fn check_word(&self, address: u16, value: u16) -> Result<(), Exception> {
        match address {
            400 if !(1..=5).contains(&value) => Err(Exception::IllegalDataValue),
            400 if !self.allows(value) => Err(Exception::ServerDeviceFailure),
            402 | 403 if value > 0xFF => Err(Exception::IllegalDataValue),
            404 | 405 if value > 0xF => Err(Exception::IllegalDataValue),
            410..414 if self.state == RUN => Err(Exception::ServerDeviceFailure),
            _ => Ok(()),
        }
    }

    fn set_word(&mut self, address: u16, value: u16) {
        match address {
            400 => self.command(value),
            402..406 => self.forces[usize::from(address - 402)] = value,
            410..414 if !self.eeprom_fails => self.settings[usize::from(address - 410)] = value,
            _ => {}
        }
    }

    fn take(&mut self, first: u16, data: &[u8]) -> Option<Result<(), Exception>> {
        (first == 1000).then(|| self.block(data))
    }

    fn identification(&self, object: u8, index: u8) -> Option<u8> {
        let text = self.identity[usize::from(object)].as_bytes();
        text.get(usize::from(index)).copied()
    }
}
