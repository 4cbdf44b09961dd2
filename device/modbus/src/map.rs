//! What the addresses of a board stand for: the one list that the firmware serves, the client reads, the tests'
//! board imitates and `docs/modbus.md` shows.

use crate::Table;
use core::fmt;
use unoclp_core::Board;
use unoclp_core::isa::{REGISTERS, TIMER_DATA};

/// Addresses in a row that hold values of one kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Span {
    /// Where.
    pub table: Table,
    /// The first address.
    pub first: u16,
    /// How many values there are.
    pub values: u16,
    /// What a value takes.
    pub width: Width,
    /// What a client may do.
    pub rights: Rights,
    /// The name in `docs/modbus.md`.
    pub name: &'static str,
}

/// What a value takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Width {
    /// A coil or a discrete input.
    Bit,
    /// A register.
    Word,
    /// Two registers, the high word first, at an even address.
    Long,
}

/// What a client may do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rights {
    /// Read.
    Read,
    /// Read and write. The bit of [`locks`] that refuses the writing.
    Write(u8),
    /// Write blocks, by function 16 from the first address on. The bit that refuses it.
    Window(u8),
}

impl Rights {
    /// Whether it can be read, and written address by address.
    pub const fn has_addresses(self) -> bool {
        !matches!(self, Rights::Window(_))
    }

    /// The bit of [`locks`] that refuses to write it; 0 where nobody can.
    pub const fn lock(self) -> u8 {
        match self {
            Rights::Read => 0,
            Rights::Write(lock) | Rights::Window(lock) => lock,
        }
    }
}

impl Span {
    /// How many addresses it has.
    pub const fn addresses(self) -> u16 {
        match self.width {
            Width::Bit | Width::Word => self.values,
            Width::Long => 2 * self.values,
        }
    }

    /// The first address after it.
    pub const fn end(self) -> u16 {
        self.first + self.addresses()
    }

    /// With as many points as this board has; with none where it has not the span.
    pub fn on(self, board: &Board) -> Span {
        Span {
            values: match self {
                coil::OUTPUTS => board.outputs.min(WORD_POINTS).into(),
                discrete::INPUTS => board.inputs.into(),
                input::ANALOGUE => board.analogue.min(WORD_POINTS).into(),
                input::PROGRAM => program_words(board),
                holding::FORCED_MORE | holding::MORE_TO => (board.inputs > WORD_POINTS).into(),
                span => span.values,
            },
            ..self
        }
    }
}

/// What a board may refuse, whoever asks: bits of [`setting::LOCK`].
pub mod locks {
    /// Uploads.
    pub const UPLOAD: u8 = 1 << 0;
    /// Changes of the settings.
    pub const SETTINGS: u8 = 1 << 1;
    /// All commands but that of an upload.
    pub const COMMANDS: u8 = 1 << 2;
    /// Writing of coils, registers and presets, and forcing.
    pub const WRITING: u8 = 1 << 3;
    /// All of these.
    pub const ALL: u8 = UPLOAD | SETTINGS | COMMANDS | WRITING;
}

/// Declares the spans of each table as constants, [`ALL`] of them as a list, and [`lock`].
macro_rules! spans {
    ($($(#[$doc:meta])* $module:ident: $table:ident {
        $($(#[$about:meta])* $span:ident = $first:literal, $values:expr, $width:ident, $rights:expr, $name:literal;)*
    })*) => {
        $($(#[$doc])* pub mod $module {
            use super::*;
            $($(#[$about])* pub const $span: Span = Span {
                table: Table::$table,
                first: $first,
                values: $values as u16,
                width: Width::$width,
                rights: $rights,
                name: $name,
            };)*
        })*

        /// Every span of any board, table by table and in order; of those that [`BOARD`] has not, there are no values.
        const EVERY: &[Span] = &[$($($module::$span),*),*];

        /// The bit of [`locks`] that refuses to write at an address of a table: that of the last span that begins
        /// there or before. As code and not as a table, which would stand in the RAM of a board.
        #[inline(always)]
        pub(crate) fn lock(table: Table, address: u16) -> u8 {
            let mut lock = 0;
            $($(if const { $module::$span.values > 0 }
                && $module::$span.table as u8 == table as u8
                && address >= $module::$span.first
            {
                lock = const { $module::$span.rights.lock() };
            })*)*
            lock
        }
    };
}

spans! {
    /// Coils.
    coil: Coils {
        /// The image of the outputs.
        OUTPUTS = 0, BOARD.outputs, Bit, Rights::Write(locks::WRITING), "output 01–04";
        /// The markers.
        MARKERS = 16, BOARD.markers, Bit, Rights::Write(locks::WRITING), "marker M 01–64";
    }

    /// Discrete inputs.
    discrete: DiscreteInputs {
        /// The inputs as the program sees them.
        INPUTS = 0, BOARD.inputs, Bit, Rights::Read, "input 01–08";
    }

    /// Input registers. From [`STATE`](input::STATE) to [`FAULTS`](input::FAULTS) they are the diagnostics, which
    /// one request reads.
    input: InputRegisters {
        /// The analogue inputs, 0 to 1023.
        ANALOGUE = 0, BOARD.analogue, Word, Rights::Read, "analogue input A 00–04";
        /// A [`State`].
        STATE = 16, 1, Word, Rights::Read, "state";
        /// Bits of [`flag`], and the [`form`] of the stored program.
        FLAGS = 17, 1, Word, Rights::Read, "bits";
        /// The number of the fault; 0: none.
        FAULT = 18, 1, Word, Rights::Read, "number of the fault";
        /// The cause of the start: see [`cause`].
        CAUSE = 19, 1, Word, Rights::Read, "cause of the start";
        /// The line of the fault; 0: none.
        LINE = 20, 1, Long, Rights::Read, "line of the fault";
        /// ms since the start, wrapping.
        UPTIME = 22, 1, Long, Rights::Read, "uptime";
        /// The last, the least and the most scan time, µs; 32767 for more.
        SCAN_TIMES = 24, 3, Word, Rights::Read, "scan time: last, minimum, maximum";
        /// Bytes that the stack has never used.
        FREE_STACK = 27, 1, Word, Rights::Read, "free stack";
        /// Bytes of the stored form of the program.
        PROGRAM_BYTES = 28, 1, Word, Rights::Read, "bytes of the program in its stored form";
        /// The checksum of [`eeprom::program`](crate::eeprom::program).
        PROGRAM_SUM = 29, 1, Word, Rights::Read, "its checksum";
        /// The reading of the 1.1 V reference.
        SUPPLY = 30, 1, Word, Rights::Read, "supply";
        /// Restarts since power-up.
        RESTARTS = 31, 1, Word, Rights::Read, "restarts since power-up";
        /// Faults since power-up.
        FAULTS = 32, 1, Word, Rights::Read, "faults since power-up";
        /// What has elapsed of the timers, ms.
        TIMERS = 128, super::TIMERS, Long, Rights::Read, "timer T 01–87: elapsed time";
        /// What the counters have counted.
        COUNTERS = 320, BOARD.counters, Long, Rights::Read, "counter C 01–16: value";
        /// The stored form of the program, two bytes a word; where a program is shorter, whatever is kept after it.
        PROGRAM = 1000, program_words(&BOARD), Word, Rights::Read, "the program in its stored form";
    }

    /// Holding registers.
    holding: HoldingRegisters {
        /// The registers D that clients have always found here, and as many more as there is room for.
        FIRST_REGISTERS = 0, 64, Long, Rights::Write(locks::WRITING), "register D 01–64";
        /// The presets of the timers, ms.
        TIMERS = 128, super::TIMERS, Long, Rights::Write(locks::WRITING), "timer T 01–87: preset";
        /// The presets of the counters.
        COUNTERS = 320, BOARD.counters, Long, Rights::Write(locks::WRITING), "counter C 01–16: preset";
        /// Takes a [`Command`]; reads as the state.
        COMMAND = 400, 1, Word, Rights::Write(locks::COMMANDS), "command";
        /// Which inputs are forced, bit 0 input 01.
        FORCED_INPUTS = 402, 1, Word, Rights::Write(locks::WRITING), "inputs forced";
        /// To what the inputs are forced.
        INPUTS_TO = 403, 1, Word, Rights::Write(locks::WRITING), "values of the forced inputs";
        /// Which outputs are forced, bit 0 output 01.
        FORCED_OUTPUTS = 404, 1, Word, Rights::Write(locks::WRITING), "outputs forced";
        /// To what the outputs are forced.
        OUTPUTS_TO = 405, 1, Word, Rights::Write(locks::WRITING), "values of the forced outputs";
        /// So many seconds without a request end all forcing; 0: none do.
        FORCING_ENDS = 406, 1, Word, Rights::Write(locks::WRITING), "end of forcing";
        /// Which inputs above 16 are forced, bit 0 input 17; no board without them has it.
        FORCED_MORE = 407, BOARD.inputs > WORD_POINTS, Word, Rights::Write(locks::WRITING), "inputs 17–32 forced";
        /// To what those are forced.
        MORE_TO = 408, BOARD.inputs > WORD_POINTS, Word, Rights::Write(locks::WRITING), "values of these inputs";
        /// The settings: see [`setting`].
        SETTINGS = 410, setting::ALL.len(), Word, Rights::Write(locks::SETTINGS), "[settings](#settings)";
        /// Blocks of an upload: a word with the block's number and size, then its text.
        UPLOAD = 1000, 123, Word, Rights::Window(locks::UPLOAD), "[upload](#upload)";
        /// All registers D.
        REGISTERS = 2000, super::REGISTERS, Long, Rights::Write(locks::WRITING), "register D 01–98";
    }
}

/// The board that has these addresses: in a firmware its own, on a PC the UNO. [`of`] tells those of any.
pub(crate) const BOARD: Board = {
    #[cfg(all(target_arch = "avr", mega))]
    const BOARD: Board = Board::MEGA;
    #[cfg(not(all(target_arch = "avr", mega)))]
    const BOARD: Board = Board::UNO;
    BOARD
};

/// Inputs that a word holds.
const WORD_POINTS: u8 = 16;

/// Registers that a board has whatever its program names.
pub const NEAR_REGISTERS: u8 = BOARD.engine.near_registers;

const SPANS: usize = {
    let (mut spans, mut index) = (0, 0);
    while index < EVERY.len() {
        spans += (EVERY[index].values > 0) as usize;
        index += 1;
    }
    spans
};

/// Every address that a board has, table by table and in order.
pub const ALL: &[Span] = &{
    let mut all = [EVERY[0]; SPANS];
    let (mut at, mut index) = (0, 0);
    while index < EVERY.len() {
        if EVERY[index].values > 0 {
            all[at] = EVERY[index];
            at += 1;
        }
        index += 1;
    }
    all
};

/// As many timers as fit an UNO's run memory: the linked form of a timer takes two bytes beside its data.
const TIMERS: u16 = Board::UNO.linked_bytes / (2 + TIMER_DATA as u16);

/// Words that hold the longest program of a board.
const fn program_words(board: &Board) -> u16 {
    board.stored_bytes.div_ceil(2)
}

/// Every address that this board has, table by table and in order: those of [`ALL`] with as many points as it has.
pub fn of(board: &Board) -> impl Iterator<Item = Span> {
    let board = *board;
    EVERY
        .iter()
        .map(move |span| span.on(&board))
        .filter(|span| span.values > 0)
}

/// The most text that a block of an upload holds, bytes.
pub const BLOCK_BYTES: u8 = (2 * (holding::UPLOAD.values - 1)) as u8;

/// Bytes of an area in [`AREAS`]: its table, its first address, low byte first, and how many it has.
pub const AREA: usize = 4;

/// The most words of a request.
const MOST_WORDS: u16 = 125;

/// Whether a span goes on where the one before it ends.
const fn joins(index: usize) -> bool {
    index > 0
        && ALL[index - 1].table as u8 == ALL[index].table as u8
        && ALL[index - 1].end() == ALL[index].first
}

/// Whether a span lies in an area. A window does not, nor the [program](input::PROGRAM), which has more addresses than a
/// byte counts.
const fn has_area(span: Span) -> bool {
    span.rights.has_addresses() && span.addresses() <= u8::MAX as u16
}

/// Whether a span begins an area: where none goes before it, or it has too many addresses for a byte to count them
/// with those before.
const fn begins_area(index: usize) -> bool {
    let span = ALL[index];
    (!joins(index) || span.addresses() > 128) && has_area(span)
}

const AREAS_BYTES: usize = {
    let (mut areas, mut index) = (0, 0);
    while index < ALL.len() {
        areas += begins_area(index) as usize;
        index += 1;
    }
    areas * AREA
};

/// Every address that can be read, but for the [program](input::PROGRAM), as areas that one request may lie in, [`AREA`] bytes each: for a board that keeps
/// constants apart from its RAM. What lies side by side is one area. Where a byte cannot count its addresses it is two,
/// and the first goes on into the second by as much as a request can.
pub const AREAS: [u8; AREAS_BYTES] = {
    let mut packed = [0; AREAS_BYTES];
    let (mut at, mut index) = (0, 0);
    while index < ALL.len() {
        let span = ALL[index];
        let addresses = span.addresses() as u8;
        if begins_area(index) {
            if joins(index) {
                assert!((u8::MAX - packed[at - 1]) as u16 >= MOST_WORDS - 1);
                packed[at - 1] = u8::MAX;
            }
            let [low, high] = span.first.to_le_bytes();
            (packed[at], packed[at + 1], packed[at + 2]) = (span.table as u8, low, high);
            at += AREA;
        }
        if has_area(span) {
            packed[at - 1] += addresses;
        }
        index += 1;
    }
    packed
};

/// Whether all of the addresses `first` to `first + (count - 1)` of a table can be read, or written one by one.
/// It looks at each of them; the firmware has a shorter way to the same answer.
pub fn has(table: Table, first: u16, count: u16) -> bool {
    let is_there = |address: u16| {
        ALL.iter().any(|span| {
            let within = (span.first..span.end()).contains(&address);
            span.table == table && span.rights.has_addresses() && within
        })
    };
    first
        .checked_add(count.saturating_sub(1))
        .is_some_and(|last| (first..=last).all(is_there))
}

/// Bits of [`input::FLAGS`].
pub mod flag {
    /// A5 is closed.
    pub const STOP_SWITCH: u16 = 1 << 0;
    /// STOP by command.
    pub const STOPPED: u16 = 1 << 1;
    /// Something is forced.
    pub const FORCED: u16 = 1 << 2;
    /// An upload is under way.
    pub const UPLOAD: u16 = 1 << 3;
    /// The card failed.
    pub const CARD_FAILED: u16 = 1 << 4;
}

/// The form in which a board stores programs, in the high byte of [`input::FLAGS`].
pub mod form {
    /// What stands there for a version of [`eeprom::program`](crate::eeprom::program): 0 for version 1, which
    /// was there before it was told.
    pub const fn bits(version: u8) -> u16 {
        (version.wrapping_sub(1) as u16) << 8
    }

    /// The version that the bits tell.
    pub const fn version(flags: u16) -> u8 {
        ((flags >> 8) as u8).wrapping_add(1)
    }
}

/// What may be written to [`holding::COMMAND`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Command {
    /// RUN, from the beginning.
    Run = 1,
    /// STOP; ends an upload.
    Stop = 2,
    /// One single scan; in RUN, STOP comes first, and the scan goes on from where the program is.
    SingleScan = 3,
    /// The whole start-up again.
    Restart = 4,
    /// Begin an upload.
    Upload = 5,
}

impl Command {
    /// The command of a value of [`holding::COMMAND`].
    #[inline(always)]
    pub const fn of(word: u16) -> Option<Command> {
        // One byte to compare, where that costs room.
        if word > 0xFF {
            return None;
        }
        match word as u8 {
            1 => Some(Command::Run),
            2 => Some(Command::Stop),
            3 => Some(Command::SingleScan),
            4 => Some(Command::Restart),
            5 => Some(Command::Upload),
            _ => None,
        }
    }
}

/// What a board does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum State {
    /// It scans.
    Run = 1,
    /// It does not; all outputs are off.
    Stop = 2,
    /// It shows a fault; all outputs are off.
    Fault = 3,
}

impl State {
    /// The state of a value of [`input::STATE`]. A later firmware's would be none of these.
    pub const fn of(word: u16) -> Option<State> {
        match word {
            1 => Some(State::Run),
            2 => Some(State::Stop),
            3 => Some(State::Fault),
            _ => None,
        }
    }

    /// The state's name.
    pub const fn name(self) -> &'static str {
        match self {
            State::Run => "RUN",
            State::Stop => "STOP",
            State::Fault => "FAULT",
        }
    }
}

/// The cause of a start ([`input::CAUSE`]) in words.
pub const fn cause(word: u16) -> &'static str {
    match word {
        1 => "power",
        2 => "reset",
        3 => "watchdog",
        4 => "no reset",
        5 => "command",
        _ => "unknown",
    }
}

/// A setting: one of the registers [`holding::SETTINGS`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Setting {
    /// The name in `docs/modbus.md`.
    pub name: &'static str,
    /// What it is unless set otherwise.
    pub default: u16,
    /// Its range.
    pub least: u16,
    /// Its range.
    pub most: u16,
}

/// The settings, in the order of their registers.
pub mod setting {
    use super::Setting;

    /// The board's address.
    pub const ADDRESS: Setting = Setting {
        name: "address",
        default: 1,
        least: 1,
        most: 247,
    };
    /// The rate, in 100 baud.
    pub const RATE: Setting = Setting {
        name: "rate, in 100 baud",
        default: 1152,
        least: 24,
        most: 1152,
    };
    /// The [`Parity`](super::Parity).
    pub const PARITY: Setting = Setting {
        name: "parity",
        default: 0,
        least: 0,
        most: 2,
    };
    /// Whether A4 is the direction pin of an RS-485 driver.
    pub const DIRECTION: Setting = Setting {
        name: "direction pin (A4)",
        default: 0,
        least: 0,
        most: 1,
    };
    /// Bits of [`lock`](crate::lock). Over Modbus it can only grow.
    pub const LOCK: Setting = Setting {
        name: "lock",
        default: 0,
        least: 0,
        most: 15,
    };
    /// All of them.
    pub const ALL: [Setting; 5] = [ADDRESS, RATE, PARITY, DIRECTION, LOCK];
}

/// The parity bit of each byte: a value of [`setting::PARITY`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(u8)]
pub enum Parity {
    /// There is none.
    #[default]
    None = 0,
    /// The ones are even in number.
    Even = 1,
    /// The ones are odd in number.
    Odd = 2,
}

impl Parity {
    /// The parity of a setting's value.
    pub const fn of(word: u16) -> Option<Parity> {
        match word {
            0 => Some(Parity::None),
            1 => Some(Parity::Even),
            2 => Some(Parity::Odd),
            _ => None,
        }
    }
}

impl fmt::Display for Parity {
    /// `no parity`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Parity::None => "no parity",
            Parity::Even => "even parity",
            Parity::Odd => "odd parity",
        })
    }
}

/// What a board says that it is, by function 43/14; its version follows.
pub const VENDOR: &str = "unoclp";
/// See [`VENDOR`].
pub const PRODUCT: &str = "unoclp UNO";
/// The same of the firmware for Nanos, which has no REAL numbers.
pub const NANO: &str = "unoclp Nano";
/// The same of the firmware for the Mega 2560.
pub const MEGA: &str = "unoclp Mega";

/// The number that two words hold, the high one first.
pub const fn long(high: u16, low: u16) -> u32 {
    (high as u32) << 16 | low as u32
}
