//! What a board says of itself: state, fault, times, and which program it keeps.

use crate::client::{Client, Failure};
use crate::map::{Span, State, flag, form, input, long};
use unoclp_core::{Cause, Fault, Program};
use unoclp_modbus::{Table, eeprom};

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
    /// Whether it comes of the kept program as it runs; others that name a line are those of a file that was refused.
    pub fn is_of_the_run(self) -> bool {
        self.number == Cause::TooManyJumps.number().into()
    }

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

/// Which program a board keeps, told by its stored form.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Kept {
    /// The version of the form.
    pub version: u8,
    /// Bytes of the stored form.
    pub bytes: u16,
    /// Its checksum in the EEPROM.
    pub sum: u16,
}

impl Default for Kept {
    /// No program.
    fn default() -> Kept {
        Kept {
            version: eeprom::program::FORM,
            bytes: 0,
            sum: 0,
        }
    }
}

impl Kept {
    /// How a board of this version keeps a program.
    pub fn of(program: &Program<'_>) -> Kept {
        Kept {
            version: eeprom::program::FORM,
            // More does not fit the board that it was checked for.
            bytes: program.stored_bytes() as u16,
            sum: eeprom::program::sum(program.stored()).value(),
        }
    }

    /// Whether both are told in the same form, and so of different programs. Of forms of two versions nothing can
    /// be said.
    pub fn differs(self, other: Kept) -> bool {
        self.version == other.version && self != other
    }
}

impl Diagnostics {
    /// Reads them.
    ///
    /// # Errors
    /// [`Failure`].
    pub async fn read(client: &mut Client) -> Result<Diagnostics, Failure> {
        let words = read_to(client, input::FAULTS).await?;
        Ok(Diagnostics::of(&words))
    }

    /// Reads again what may change from one scan to the next: state, fault, the cause of the start and the time since.
    /// One slice of the board's time is enough for it.
    ///
    /// # Errors
    /// [`Failure`].
    pub async fn renew(&mut self, client: &mut Client) -> Result<(), Failure> {
        let now = Diagnostics::of(&read_to(client, input::UPTIME).await?);
        self.state = now.state;
        self.flags = now.flags;
        self.trouble = now.trouble;
        self.cause = now.cause;
        self.uptime = now.uptime;
        self.program.version = now.program.version;
        Ok(())
    }

    /// Where the words lie that tell them, to the end of this span: table, first address, how many.
    pub const fn asked(last: Span) -> (Table, u16, u16) {
        let first = input::STATE.first;
        (input::STATE.table, first, last.end() - first)
    }

    /// From the words that begin with the state; 0 stands for what is missing.
    pub fn of(words: &[u16]) -> Diagnostics {
        let first = input::STATE.first;
        let at = |address: u16| {
            let word = words.get(usize::from(address - first));
            word.copied().unwrap_or_default()
        };
        let word = |span: Span| at(span.first);
        let long = |span: Span| long(at(span.first), at(span.first + 1));
        let flags = word(input::FLAGS);
        Diagnostics {
            state: State::of(word(input::STATE)),
            flags,
            trouble: match word(input::FAULT) {
                0 => None,
                number => Some(Trouble {
                    number,
                    line: Some(long(input::LINE)).filter(|&line| line != 0),
                }),
            },
            cause: word(input::CAUSE),
            uptime: long(input::UPTIME),
            scan_times: [0, 1, 2].map(|n| at(input::SCAN_TIMES.first + n)),
            free_stack: word(input::FREE_STACK),
            program: Kept {
                version: form::version(flags),
                bytes: word(input::PROGRAM_BYTES),
                sum: word(input::PROGRAM_SUM),
            },
            supply: 1_126_400_u32
                .checked_div(word(input::SUPPLY).into())
                .unwrap_or_default(),
            restarts: word(input::RESTARTS),
            faults: word(input::FAULTS),
        }
    }

    /// Whether a flag is set.
    pub const fn has(&self, flag: u16) -> bool {
        self.flags & flag != 0
    }

    /// Whether it is in FAULT because nobody has given it a program yet: it keeps none, and no card has one.
    pub fn waits_for_program(&self) -> bool {
        let no_card = u16::from(Cause::NoCard.number());
        let is_fault = self.state == Some(State::Fault);
        let is_this = self
            .trouble
            .is_some_and(|trouble| trouble.number == no_card);
        is_fault && is_this && self.program.bytes == 0
    }

    /// Whether A5 holds the board in STOP.
    pub const fn is_switched_off(&self) -> bool {
        self.has(flag::STOP_SWITCH)
    }
}

/// The words from the state to the end of this span.
async fn read_to(client: &mut Client, last: Span) -> Result<Vec<u16>, Failure> {
    let (table, first, count) = Diagnostics::asked(last);
    client.words(table, first, count).await
}

#[cfg(test)]
mod tests {
    use super::*;
    use unoclp_core::{Board, Crc16, Loader};

    #[test]
    fn a_board_keeps_what_its_page_says() {
        let mut memory = [0; 960];
        let mut loader = Loader::new(&mut memory, Board::UNO);
        for &byte in b"0\n787600\n827301\n877901\n" {
            loader.push(byte).unwrap();
        }
        let kept = Kept::of(&loader.finish().unwrap());
        // The stored form of a contact and a coil, after program start and a new rung.
        let sum = Crc16::of(&[1, 3, 0, 0, 0, 0x01, 0x10, 0x50]).value();
        let expected = Kept {
            version: 2,
            bytes: 3,
            sum,
        };
        assert_eq!(kept, expected);
    }

    #[test]
    fn a_board_without_program_and_card_waits_for_one() {
        let trouble = |number| Some(Trouble { number, line: None });
        let empty = Diagnostics {
            state: Some(State::Fault),
            trouble: trouble(51),
            ..Diagnostics::default()
        };
        assert!(empty.waits_for_program());
        let kept = Kept {
            bytes: 9,
            ..Kept::default()
        };
        for other in [
            Diagnostics {
                trouble: trouble(52),
                ..empty
            },
            Diagnostics {
                program: kept,
                ..empty
            },
            Diagnostics {
                state: Some(State::Stop),
                ..empty
            },
        ] {
            assert!(!other.waits_for_program(), "{other:?}");
        }
    }

    #[test]
    fn programs_differ_in_one_form_only() {
        let kept = Kept {
            version: 1,
            bytes: 3,
            sum: 7,
        };
        assert!(!kept.differs(kept));
        for (version, bytes, sum, differs) in [
            (1, 4, 7, true),
            (1, 3, 8, true),
            (2, 3, 7, false),
            (2, 4, 8, false),
        ] {
            let other = Kept {
                version,
                bytes,
                sum,
            };
            assert_eq!(kept.differs(other), differs, "{other:?}");
        }
    }
}
