//! What a board says of itself: state, fault, times, and which program it keeps.

use crate::client::{Client, Failure, Table};
use crate::map::{State, flag, input, number};
use std::fmt;
use unoclp_core::{Cause, Crc16, Fault, Loader, Profile};

/// What the board says of itself.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Diagnostics {
    /// What it does; none where it is not among the states of this version.
    pub state: Option<State>,
    /// Bits of [`flag`].
    pub flags: u16,
    /// The fault, or that of the last upload.
    pub trouble: Option<Trouble>,
    /// The cause of the start; [`cause`](crate::map::cause) puts it into words.
    pub cause: u16,
    /// ms since the start, wrapping.
    pub uptime: u32,
    /// Scan times in µs: last, least, most; 32767 for more.
    pub scan_times: [u16; 3],
    /// Bytes that the stack has never used.
    pub free_stack: u16,
    /// What it keeps.
    pub program: Kept,
    /// The supply in mV; 0 where it has not been measured.
    pub supply: u32,
    /// Restarts and faults since power-up.
    pub restarts: u16,
    /// Faults since power-up.
    pub faults: u16,
}

/// A fault as the board tells it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Trouble {
    /// Its number.
    pub number: u16,
    /// Its line; none where there is none.
    pub line: Option<u32>,
}

impl Trouble {
    /// The fault, where this version knows its number.
    pub fn fault(self) -> Option<Fault> {
        let cause = Cause::ALL
            .iter()
            .find(|cause| u16::from(cause.number()) == self.number)?;
        Some(Fault {
            cause: *cause,
            line: self.line,
        })
    }
}

impl fmt::Display for Trouble {
    /// `fault 24, line 7: no such code`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(fault) = self.fault() {
            return fault.fmt(f);
        }
        write!(f, "fault {}", self.number)?;
        if let Some(line) = self.line {
            write!(f, ", line {line}")?;
        }
        f.write_str(": unknown to this version of unoclp")
    }
}

/// Which program a board keeps.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Kept {
    /// Bytes of its stored form.
    pub bytes: u16,
    /// Its check sum in the EEPROM.
    pub crc: u16,
}

impl Kept {
    /// How a board keeps this file; none where the file has a fault.
    pub fn of(file: &[u8]) -> Option<Kept> {
        let mut memory = vec![0; usize::from(Profile::UNO.linked_bytes)];
        let mut loader = Loader::new(&mut memory, Profile::UNO);
        file.iter().try_for_each(|&byte| loader.push(byte)).ok()?;
        let program = loader.finish().ok()?;
        let bytes = u16::try_from(program.stored_bytes()).ok()?;
        let [low, high] = bytes.to_le_bytes();
        let mut crc = Crc16::default();
        crc.extend(&[1, low, high, 0, 0]);
        crc.extend(program.stored());
        let crc = crc.value();
        Some(Kept { bytes, crc })
    }
}

impl Diagnostics {
    /// Reads them.
    ///
    /// # Errors
    /// [`Failure`].
    pub fn read(client: &mut Client) -> Result<Diagnostics, Failure> {
        let count = input::FAULTS - input::STATE + 1;
        let words = client.words(Table::InputRegisters, input::STATE, count)?;
        let word = |address: u16| {
            let word = words.get(usize::from(address - input::STATE));
            word.copied().unwrap_or_default()
        };
        let long = |address| number(word(address), word(address + 1));
        Ok(Diagnostics {
            state: State::of(word(input::STATE)),
            flags: word(input::FLAGS),
            trouble: match word(input::FAULT) {
                0 => None,
                number => Some(Trouble {
                    number,
                    line: Some(long(input::LINE)).filter(|&line| line != 0),
                }),
            },
            cause: word(input::CAUSE),
            uptime: long(input::UPTIME),
            scan_times: [0, 1, 2].map(|n| word(input::SCAN_TIME + n)),
            free_stack: word(input::FREE_STACK),
            program: Kept {
                bytes: word(input::PROGRAM_BYTES),
                crc: word(input::PROGRAM_CRC),
            },
            supply: 1_126_400_u32
                .checked_div(word(input::SUPPLY).into())
                .unwrap_or_default(),
            restarts: word(input::RESTARTS),
            faults: word(input::FAULTS),
        })
    }

    /// Whether a flag is set.
    pub const fn has(&self, flag: u16) -> bool {
        self.flags & flag != 0
    }

    /// Whether A5 holds the board in STOP.
    pub const fn is_switched_off(&self) -> bool {
        self.has(flag::STOP_SWITCH)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_board_keeps_what_its_page_says() {
        // The stored form of a contact and a coil, behind program start and a new rung.
        let kept = Kept::of(b"0\n787600\n827301\n877901\n").unwrap();
        let crc = Crc16::of(&[1, 3, 0, 0, 0, 0x01, 0x10, 0x50]).value();
        assert_eq!(kept, Kept { bytes: 3, crc });
        assert_eq!(Kept::of(b"0\n1\n"), None);
        assert_eq!(Kept::of(b""), None);
    }

    #[test]
    fn trouble_reads_as_everywhere() {
        let trouble = |number, line| Trouble { number, line }.to_string();
        assert_eq!(trouble(24, Some(7)), "fault 24, line 7: no such code");
        assert_eq!(
            trouble(99, Some(7)),
            "fault 99, line 7: unknown to this version of unoclp"
        );
        assert_eq!(
            trouble(99, None),
            "fault 99: unknown to this version of unoclp"
        );
    }
}
