//! A board in memory: the addresses are those of the map, its states as `docs/modbus.md` defines them.

use std::collections::BTreeMap;
use unoclp_client::diagnostics::Kept;
use unoclp_core::{Cause, Crc16, Fault, Loader};
use unoclp_modbus::eeprom::program::{FORM, HEAD_BYTES, head};
use unoclp_modbus::map::{
    self, BLOCK_BYTES, Command, PRODUCT, Span, State, VENDOR, coil, discrete, flag, form, holding,
    input, setting,
};
use unoclp_modbus::{Access, Exception, Points, Table};

pub const RUN: u16 = State::Run as u16;
pub const STOP: u16 = State::Stop as u16;
pub const FAULT: u16 = State::Fault as u16;

/// How a board of this version keeps the program of this text.
pub fn kept(text: &str) -> Kept {
    kept_in(FORM, text.as_bytes())
}

/// How a board keeps it whose stored form has this version.
fn kept_in(version: u8, text: &[u8]) -> Kept {
    let mut memory = vec![0; unoclp_core::Board::UNO.linked_bytes.into()];
    let mut loader = Loader::new(&mut memory, unoclp_core::Board::UNO);
    text.iter().for_each(|&byte| loader.push(byte).unwrap());
    let program = loader.finish().unwrap();
    let bytes = program.stored_bytes() as u16;
    let mut head: [u8; HEAD_BYTES] = head(bytes);
    if version != FORM {
        // What it sums up differs from what a board of this version does.
        head[0] = version;
    }
    let mut sum = Crc16::of(&head);
    sum.extend(program.stored());
    let sum = sum.value();
    Kept {
        version,
        bytes,
        sum,
    }
}

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
    /// The version of its stored form.
    pub version: u8,
    pub kept: Kept,
    /// The text of the program that it keeps, where it was uploaded.
    pub text: Vec<u8>,
    /// The program on its card, which a restart takes.
    pub card: Option<Vec<u8>>,
    /// A fault that it finds in the second text.
    pub second_differs: bool,
    /// A fault that it finds when it restarts.
    pub fault_at_restart: u16,
    /// The fault and its line in which each program ends soon after it has begun to run.
    pub fault_in_run: Option<(u16, u32)>,
    pub inputs: u16,
    pub outputs: u16,
    pub markers: u64,
    /// Without markers, registers and analogue inputs, a lock and an end of forcing.
    pub is_of_version_1: bool,
    /// Words that read as something else than 0, and have no meaning to the board.
    pub words: BTreeMap<(u16, u16), u16>,
    /// Forced inputs, to what; forced outputs, to what; when forcing ends.
    pub forces: [u16; 5],
    pub settings: [u16; 5],
    /// The settings are defaults that A5 and 01 to 04 have put in the place of those that are kept.
    pub has_defaults: bool,
    /// How often the settings may still be changed.
    pub changes_left: u32,
    /// They have been changed since they were last kept.
    pub changed: bool,
    /// It does not keep settings.
    pub eeprom_fails: bool,
    pub single_scans: u32,
    pub restarts: u32,
    pub upload: Option<Upload>,
}

impl Default for Board {
    fn default() -> Board {
        Board {
            identity: [VENDOR, PRODUCT, "0.1.0"],
            identifies: true,
            state: RUN,
            switch: false,
            stopped: false,
            fault: 0,
            line: 0,
            version: FORM,
            kept: Kept {
                version: FORM,
                bytes: 3,
                sum: 77,
            },
            text: Vec::new(),
            card: None,
            second_differs: false,
            fault_at_restart: 0,
            fault_in_run: None,
            inputs: 0,
            outputs: 0,
            markers: 0,
            is_of_version_1: false,
            words: BTreeMap::new(),
            forces: [0; 5],
            settings: setting::ALL.map(|setting| setting.default),
            has_defaults: false,
            changes_left: 16,
            changed: false,
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

    /// Whether an upload is in progress.
    pub fn is_uploading(&self) -> bool {
        self.upload.is_some()
    }

    /// What takes the place of this board's firmware has another version of the stored form.
    pub fn of_version(version: u8, board: Board) -> Board {
        let kept = Kept {
            version,
            ..board.kept
        };
        Board {
            version,
            kept,
            ..board
        }
    }

    fn allows(&self, command: Command) -> bool {
        let (stop, uploading) = (self.state == STOP, self.is_uploading());
        match command {
            Command::Run => self.state == RUN || stop && !self.switch && !uploading,
            Command::Stop => self.state != FAULT || uploading,
            Command::SingleScan => self.state != FAULT && !self.switch && !uploading,
            Command::Restart => true,
            Command::Upload => self.state != RUN && !uploading,
        }
    }

    fn command(&mut self, command: Command) {
        match command {
            Command::Run => {
                (self.state, self.stopped) = (RUN, false);
                self.begin_to_run();
            }
            Command::Stop if self.is_uploading() => self.upload = None,
            Command::Stop => (self.state, self.stopped) = (STOP, true),
            Command::SingleScan => {
                (self.state, self.stopped) = (STOP, true);
                self.single_scans += 1;
            }
            Command::Restart => self.restart(),
            Command::Upload => {
                self.fault = 0;
                let memory = vec![0; unoclp_core::Board::UNO.linked_bytes.into()].leak();
                self.upload = Some(Upload {
                    next: 0,
                    loader: Loader::new(memory, unoclp_core::Board::UNO),
                    texts: [Vec::new(), Vec::new()],
                    second: false,
                });
            }
        }
    }

    fn restart(&mut self) {
        self.restarts += 1;
        self.forces = [0; 5];
        self.upload = None;
        if let Some(card) = &self.card {
            self.kept = kept_in(self.version, card);
        }
        (self.fault, self.line) = (self.fault_at_restart, 0);
        self.state = match (self.fault, self.switch) {
            (0, false) => RUN,
            (0, true) => STOP,
            _ => FAULT,
        };
        if self.state == RUN {
            self.begin_to_run();
        }
    }

    fn begin_to_run(&mut self) {
        if let Some((fault, line)) = self.fault_in_run {
            (self.state, self.fault, self.line) = (FAULT, fault, line);
        }
    }

    fn block(&mut self, data: &[u8]) -> Result<(), Exception> {
        let Some(upload) = &mut self.upload else {
            return Err(Exception::ServerDeviceFailure);
        };
        let (number, size) = (data[0], usize::from(data[1]));
        let words = size.div_ceil(2);
        if size > BLOCK_BYTES.into() || data.len() != 2 + 2 * words {
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
            self.kept = kept_in(self.version, first);
            self.upload = None;
        } else if ends {
            upload.second = true;
        }
        Ok(())
    }

    fn flags(&self) -> u16 {
        let forced = self.forces[0] | self.forces[2] != 0;
        let flags = [
            (self.switch, flag::STOP_SWITCH),
            (self.stopped, flag::STOPPED),
            (forced, flag::FORCED),
            (self.is_uploading(), flag::UPLOAD),
        ];
        let set = flags.iter().filter(|(is_set, _)| *is_set);
        set.fold(form::bits(self.version), |flags, (_, flag)| flags | flag)
    }

    /// Firmware of version 1 had fewer tables, and less in them.
    fn had(table: Table, first: u16, count: u16) -> bool {
        let last = first + (count - 1);
        match table {
            Table::Coils | Table::DiscreteInputs => last < 4,
            Table::InputRegisters => first >= input::STATE.first && last <= input::FAULTS.first,
            Table::HoldingRegisters => {
                let is_new = |span: Span| (first..=last).contains(&(span.end() - 1));
                first >= holding::COMMAND.first
                    && !is_new(holding::FORCING_ENDS)
                    && !is_new(holding::SETTINGS)
            }
        }
    }
}

/// The number of an address in a span, if it lies there.
fn at(span: Span, table: Table, address: u16) -> Option<usize> {
    let is_there = span.table == table && (span.first..span.end()).contains(&address);
    is_there.then(|| usize::from(address - span.first))
}

/// The registers of the forces, one after another.
const FORCES: Span = Span {
    values: 5,
    ..holding::FORCED_INPUTS
};

impl Points for Board {
    fn has(&self, table: Table, first: u16, count: u16, _: Access) -> bool {
        map::has(table, first, count) && (!self.is_of_version_1 || Board::had(table, first, count))
    }

    fn bit(&self, table: Table, address: u16) -> bool {
        if let Some(index) = at(discrete::INPUTS, table, address) {
            let [points, to, ..] = self.forces;
            (self.inputs & !points | to) >> index & 1 != 0
        } else if let Some(index) = at(coil::MARKERS, table, address) {
            self.markers >> index & 1 != 0
        } else {
            self.outputs >> address & 1 != 0
        }
    }

    fn word(&self, table: Table, address: u16) -> u16 {
        let at = |span| at(span, table, address);
        if at(input::STATE).or(at(holding::COMMAND)).is_some() {
            return self.state;
        }
        if at(input::FLAGS).is_some() {
            return self.flags();
        }
        if at(input::FAULT).is_some() {
            return self.fault;
        }
        if let Some(half) = at(input::LINE) {
            return [(self.line >> 16) as u16, self.line as u16][half];
        }
        if at(input::PROGRAM_BYTES).is_some() {
            return self.kept.bytes;
        }
        if at(input::PROGRAM_SUM).is_some() {
            return self.kept.sum;
        }
        if let Some(index) = at(FORCES) {
            return self.forces[index];
        }
        if let Some(index) = at(holding::SETTINGS) {
            return self.settings[index];
        }
        let word = self.words.get(&(table as u16, address));
        word.copied().unwrap_or_default()
    }

    fn set_bit(&mut self, address: u16, on: bool) {
        let at = |span| at(span, Table::Coils, address);
        if let Some(index) = at(coil::MARKERS) {
            self.markers = self.markers & !(1 << index) | u64::from(on) << index;
        } else if let Some(index) = at(coil::OUTPUTS) {
            self.outputs = self.outputs & !(1 << index) | u16::from(on) << index;
        }
    }

    fn check_word(&self, address: u16, value: u16) -> Result<(), Exception> {
        let at = |span| at(span, Table::HoldingRegisters, address);
        if at(holding::COMMAND).is_some() {
            return match Command::of(value) {
                Some(command) if self.allows(command) => Ok(()),
                Some(_) => Err(Exception::ServerDeviceFailure),
                None => Err(Exception::IllegalDataValue),
            };
        }
        let points = match at(FORCES) {
            Some(0 | 1 | 4) => discrete::INPUTS.values,
            Some(_) => coil::OUTPUTS.values,
            None => 16,
        };
        if value.checked_shr(points.into()).unwrap_or(0) != 0 {
            return Err(Exception::IllegalDataValue);
        }
        let Some(index) = at(holding::SETTINGS) else {
            return Ok(());
        };
        let setting = setting::ALL[index];
        let lifts = setting == setting::LOCK && self.settings[index] & !value != 0;
        if self.state == RUN {
            Err(Exception::ServerDeviceFailure)
        } else if !(setting.least..=setting.most).contains(&value) || lifts {
            Err(Exception::IllegalDataValue)
        } else if self.changes_left == 0 {
            Err(Exception::ServerDeviceBusy)
        } else {
            Ok(())
        }
    }

    fn set_word(&mut self, address: u16, value: u16) {
        let at = |span| at(span, Table::HoldingRegisters, address);
        if at(holding::COMMAND).is_some() {
            if let Some(command) = Command::of(value) {
                self.command(command);
            }
        } else if let Some(index) = at(FORCES) {
            self.forces[index] = value;
        } else if let Some(index) = at(holding::SETTINGS)
            && !self.eeprom_fails
        {
            self.changed |= self.has_defaults || self.settings[index] != value;
            self.settings[index] = value;
        } else if let Some(word) = at(holding::REGISTERS).or(at(holding::FIRST_REGISTERS)) {
            // The first of them stand in two rows.
            for span in [holding::REGISTERS, holding::FIRST_REGISTERS] {
                let address = span.first + word as u16;
                self.words.insert((span.table as u16, address), value);
            }
        }
    }

    fn is_written(&mut self) {
        if std::mem::take(&mut self.changed) {
            self.has_defaults = false;
            self.changes_left -= 1;
        }
    }

    fn take(&mut self, first: u16, data: &[u8]) -> Option<Result<(), Exception>> {
        (first == holding::UPLOAD.first).then(|| self.block(data))
    }

    fn identification(&self, object: u8, index: u8) -> Option<u8> {
        let text = self.identity[usize::from(object)].as_bytes();
        text.get(usize::from(index)).copied()
    }
}
