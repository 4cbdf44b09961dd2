//! What each address stands for: the tables of `docs/modbus.md`.

use super::upload::Upload;
use super::{Command, Panel, State};
use crate::board::flash::{Codes, flash_codes};
use crate::board::{Board, clock, stack};
use crate::{settings, store};
use unoclp_core::Profile;
use unoclp_modbus::{Access, Device, Exception, Table};

const INPUTS: u16 = Profile::UNO.inputs as u16;
const OUTPUTS: u16 = Profile::UNO.outputs as u16;

// Input registers.
const DIAGNOSTICS: u16 = 16;
const DIAGNOSTICS_COUNT: u16 = 17;

// Holding registers.
const COMMAND: u16 = 400;
const FORCES: u16 = 402;
const FORCES_COUNT: u16 = 4;
const SETTINGS: u16 = 410;
const SETTINGS_COUNT: u16 = settings::COUNT as u16;
const WINDOW: u16 = 1000;

/// The board as the server shows it, for one step.
pub struct Map<'a, 'm> {
    pub board: &'a Board,
    pub panel: &'a mut Panel,
    pub upload: Option<&'a mut Upload<'m>>,
}

impl Map<'_, '_> {
    /// A word of the diagnostics, by its number from 0.
    #[inline(never)]
    fn diagnostic(&self, number: u16) -> u16 {
        let Map { board, panel, .. } = self;
        let line = panel.fault.and_then(|fault| fault.line).unwrap_or(0);
        let pair = match number {
            0 => return panel.state as u16,
            1 => return self.bits().into(),
            2 => return panel.fault.map_or(0, |fault| fault.cause.number().into()),
            3 => return board.start as u16 + 1,
            4 | 5 => line,
            6 | 7 => clock::now(),
            8 => return panel.times.last,
            9 => return panel.times.least,
            10 => return panel.times.most,
            11 => return stack::free(),
            12 | 13 => store::kept(&board.eeprom),
            14 => return board.supply.reading(),
            15 => return board.watchdog.restarts(),
            _ => return board.watchdog.faults(),
        };
        if number & 1 == 0 {
            (pair >> 16) as u16
        } else {
            pair as u16
        }
    }

    fn bits(&self) -> u8 {
        let panel = &self.panel;
        u8::from(self.board.pins.stop())
            | u8::from(panel.stopped) << 1
            | u8::from(panel.forces.any()) << 2
            | u8::from(panel.uploading) << 3
            | u8::from(panel.card_failed) << 4
    }

    /// The command of this number, if it can be followed now.
    fn command(&self, number: u16) -> Result<Command, Exception> {
        let Panel {
            state, uploading, ..
        } = *self.panel;
        let fault = state == State::Fault;
        let held = self.board.pins.stop() || fault || uploading;
        let (command, now) = match number {
            1 => (Command::Run, !held),
            2 => (Command::Stop, !fault || uploading),
            3 => (Command::SingleScan, !held && state == State::Stop),
            4 => (Command::Restart, true),
            5 => (Command::Upload, state != State::Run),
            _ => return Err(Exception::IllegalDataValue),
        };
        if now {
            Ok(command)
        } else {
            Err(Exception::ServerDeviceFailure)
        }
    }
}

/// Whether all addresses of a request lie in this range.
#[inline(never)]
fn within(first: u16, count: u16, start: u16, length: u16) -> bool {
    let offset = first.wrapping_sub(start);
    offset < length && count <= length - offset
}

impl Device for Map<'_, '_> {
    fn has(&self, table: Table, first: u16, count: u16, _: Access) -> bool {
        match table {
            Table::Coils => within(first, count, 0, OUTPUTS),
            Table::DiscreteInputs => within(first, count, 0, INPUTS),
            Table::InputRegisters => within(first, count, DIAGNOSTICS, DIAGNOSTICS_COUNT),
            Table::HoldingRegisters => {
                within(first, count, COMMAND, 1)
                    || within(first, count, FORCES, FORCES_COUNT)
                    || within(first, count, SETTINGS, SETTINGS_COUNT)
            }
        }
    }

    fn bit(&self, table: Table, address: u16) -> bool {
        let images = self.panel.images;
        let image = match table {
            Table::Coils => images.outputs,
            _ => images.inputs,
        };
        image.0 as u8 & bit(address) != 0
    }

    fn word(&self, table: Table, address: u16) -> u16 {
        if table == Table::InputRegisters {
            return self.diagnostic(address - DIAGNOSTICS);
        }
        let panel = &self.panel;
        match address {
            COMMAND => panel.state as u16,
            FORCES..SETTINGS => {
                let forces = panel.forces.0.get(usize::from(address - FORCES));
                forces.copied().unwrap_or(0).into()
            }
            _ => panel.settings.get((address - SETTINGS) as u8),
        }
    }

    fn set_bit(&mut self, address: u16, on: bool) {
        let outputs = &mut self.panel.images.outputs.0;
        let bit = u16::from(bit(address));
        *outputs = if on { *outputs | bit } else { *outputs & !bit };
    }

    fn check_word(&self, address: u16, value: u16) -> Result<(), Exception> {
        if address == COMMAND {
            return self.command(value).map(|_| ());
        }
        let sound = if address < SETTINGS {
            let points = if address - FORCES < 2 {
                INPUTS
            } else {
                OUTPUTS
            };
            value < 1 << points
        } else if self.panel.state == State::Run {
            return Err(Exception::ServerDeviceFailure);
        } else {
            settings::allows((address - SETTINGS) as u8, value)
        };
        if sound {
            Ok(())
        } else {
            Err(Exception::IllegalDataValue)
        }
    }

    fn set_word(&mut self, address: u16, value: u16) {
        if address == COMMAND {
            if let Ok(command) = self.command(value) {
                self.panel.stopped = match command {
                    Command::Run => false,
                    Command::Stop => true,
                    _ => self.panel.stopped,
                };
                self.panel.command = Some(command);
            }
        } else if address < SETTINGS {
            let forces = &mut self.panel.forces.0;
            if let Some(place) = forces.get_mut(usize::from(address - FORCES)) {
                *place = value as u8;
            }
        } else {
            let settings = &mut self.panel.settings;
            settings.set((address - SETTINGS) as u8, value);
            settings.save(&self.board.eeprom);
        }
    }

    fn take(&mut self, first: u16, data: &[u8]) -> Option<Result<(), Exception>> {
        if first != WINDOW {
            return None;
        }
        Some(match &mut self.upload {
            Some(upload) => upload.take(self.board, self.panel, data),
            None => Err(Exception::ServerDeviceFailure),
        })
    }

    fn identification(&self, object: u8, index: u8) -> Option<u8> {
        let text = match object {
            0 => flash_codes!(Codes::plain("unoclp")),
            1 => flash_codes!(Codes::plain("unoclp UNO")),
            _ => flash_codes!(Codes::plain(env!("CARGO_PKG_VERSION"))),
        };
        text.at(index)
    }
}

/// The bit of the point at this address, 0 to 7.
fn bit(address: u16) -> u8 {
    1 << (address & 7)
}
