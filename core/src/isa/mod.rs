//! What an instruction is: its code, its letters, its stored form and its effect.
//!
//! Decoding, encoding, listings and the table in `docs/numeric-code.md` come from the rows of
//! [`TABLE`]. To add an instruction, add its row, and its effect in `plc/`.
//!
//! # Stored form
//!
//! An instruction is stored as the byte of its row. Of the rows from 0x10 to 0x9F the low four bits
//! of that byte hold the index of the point. Of the others that have an XX, a byte with XX follows;
//! then the [operand lines](Line), each in as many bytes as [`Line::bytes`] says, the low one first.

mod instruction;
mod packed;
mod table;

pub use instruction::{Instruction, Operand, Value};
pub(crate) use packed::{By, Entry, find, stored_size};
pub use packed::{PACKED, PackedTable, read_packed};
pub use table::{Opcode, TABLE};

/// What stands in the last two digits of a code, and on the lines that follow it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Kind {
    /// Nothing: the code is complete.
    None,
    /// Input XX of the board.
    Input,
    /// Output XX of the board.
    Output,
    /// Branch point XX of the rung, 01–08.
    Branch,
    /// Marker XX, 01–64.
    Marker,
    /// System marker XX, 01–04.
    System,
    /// Timer XX of the program, counted in file order.
    TimerQ,
    /// Counter XX, 01–16.
    Counter,
    /// Register XX, 01–32.
    Register,
    /// Analogue input A XX, 00–04.
    Analogue,
    /// The output with this number as PWM, 01 or 04.
    Pwm,
    /// System reading XX, 01 or 02.
    Reading,
    /// Eight markers: group XX, 01–08.
    Group,
    /// Bit XX of the value, or so many bits, 00–31.
    Bit,
    /// So many ms, 00–99.
    Time,
    /// Label XX, 01–32.
    Label,
    /// A jump to label XX.
    Jump,
    /// A timer block. Lines: preset, target.
    Timer,
    /// Counter XX. Line: preset.
    Count,
    /// Register XX, 01–32; with XX = 00 a constant. Line then: the constant.
    Value,
    /// Registers from XX on. Lines: `68YY`, the first register to write; how many.
    Move,
    /// Register XX tells the step. Lines: how many steps, then each.
    Drum,
    /// Lines: four bounds.
    Scale,
    /// Strength XX, 01–08. Line: time.
    Filter,
}

/// One row of the instruction table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Row {
    /// The code; where it has an XX, with XX = 00.
    pub code: i32,
    /// What each pair of digits spells in ASCII.
    pub letters: &'static str,
    /// What the instruction works on.
    pub kind: Kind,
    /// The byte that stores it.
    pub stored: u8,
    /// Bytes of run memory, its data among them. More for what [`Line::more_run_bytes`] tells, two for
    /// inputs from 05 on, and each counter's data.
    pub run: u8,
    /// The effect in one line.
    pub effect: &'static str,
}

/// A line that follows a code.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Line {
    /// A timer's preset in ms, 0 to 2147483647.
    TimerPreset,
    /// What a timer drives: `79XX`, an output, or `77XX`, a marker.
    Target,
    /// A counter's preset, 0 to 2147483647.
    CounterPreset,
    /// Any number.
    Constant,
    /// `68XX`, a register.
    MoveTo,
    /// How many registers.
    MoveCount,
    /// How many steps, 1–32.
    Steps,
    /// The outputs of a step: a 0 or 1 for each of 01 02 03 04.
    Step,
    /// −32768 to 32767: the lower and upper bound of what comes, and what they become.
    FromLow,
    /// See [`Line::FromLow`].
    FromHigh,
    /// See [`Line::FromLow`].
    ToLow,
    /// See [`Line::FromLow`].
    ToHigh,
    /// A filter's time in ms, 0–30000.
    FilterTime,
}

impl Line {
    /// How many bytes store it.
    pub const fn bytes(self) -> u8 {
        match self {
            Line::TimerPreset | Line::CounterPreset | Line::Constant => 4,
            Line::Target | Line::MoveTo | Line::MoveCount | Line::Steps | Line::Step => 1,
            Line::FromLow | Line::FromHigh | Line::ToLow | Line::ToHigh | Line::FilterTime => 2,
        }
    }

    /// Bytes of run memory that the line, stored as this, adds to those of its instruction's row.
    pub const fn more_run_bytes(self, stored: u8) -> u8 {
        match self {
            Line::Constant => 3,
            Line::Step => 1,
            Line::Target if stored >= MARKER_TARGET => 2,
            _ => 0,
        }
    }
}

/// A stored target of a timer from this byte on is a marker, below it an output.
pub const MARKER_TARGET: u8 = 0x40;

/// Inputs 01 to this number take one byte of run memory, those beyond three.
pub const FAST_INPUTS: u8 = 4;
/// The branch points of a rung are 01 to this number (NC-8).
pub const BRANCH_POINTS: u8 = 8;
/// The deepest nesting of branches and blocks (NC-8).
pub const DEEPEST: u8 = 8;
/// Markers M 01 to this number (NC-12).
pub const MARKERS: u8 = 64;
/// The markers from this one on are retentive (NC-12).
pub const RETENTIVE: u8 = 57;
/// System markers S 01 to this number (NC-12).
pub const SYSTEM_MARKERS: u8 = 4;
/// Counters C 01 to this number (NC-15).
pub const COUNTERS: u8 = 16;
/// Registers D 01 to this number (NC-16).
pub const REGISTERS: u8 = 32;
/// Labels 01 to this number (NC-19).
pub const LABELS: u8 = 32;
/// Analogue inputs A 00 to below this number (NC-18).
pub const ANALOGUE: u8 = 5;
/// A program has at most so many timers, because a code names them by two digits.
pub const TIMERS: u8 = 99;

/// Program start, the first code of a file. It is checked and not stored.
pub const START: i32 = 0;
/// The code of an output as an operand line: `79XX` with XX = 00.
pub const OUTPUT_OPERAND: i32 = 7900;
/// The code of a marker as an operand line: `77XX` with XX = 00.
pub const MARKER_OPERAND: i32 = 7700;
/// The code of a register as an operand line: `68XX` with XX = 00.
pub const REGISTER_OPERAND: i32 = 6800;

/// Bytes of a timer's data in run memory: its state, a time stamp, its preset.
pub const TIMER_DATA: usize = 9;
/// Bytes of a counter's data in run memory: its value, its preset, its inputs as they were.
pub const COUNTER_DATA: usize = 9;

/// What a jump back may cost in all in one scan: each costs the stored bytes from its label to itself
/// (NC-19).
pub const JUMP_BUDGET: u16 = 2_000;

/// The last two digits of a code, where all before them are those of `base`.
///
/// By subtraction: a division of 32 bits would take 1.5 KB of the firmware.
#[inline(never)]
pub(crate) fn xx(code: i32, base: i32) -> Option<u8> {
    let xx = if base < 0 {
        base.wrapping_sub(code)
    } else {
        code.wrapping_sub(base)
    };
    (0..100).contains(&xx).then_some(xx as u8)
}

/// The byte of the row that a first stored byte belongs to.
pub(crate) const fn first_of(byte: u8) -> u8 {
    if holds_point(byte) { byte & 0xF0 } else { byte }
}

/// Whether the low four bits of a first stored byte are the index of a point.
pub const fn holds_point(byte: u8) -> bool {
    byte >= 0x10 && byte < 0xA0
}

impl Kind {
    /// Whether the code's last two digits are a number, XX.
    pub const fn has_number(self) -> bool {
        !matches!(self, Kind::None | Kind::Timer | Kind::Scale)
    }

    /// The first line that follows a code with this XX.
    pub const fn first_line(self, xx: u8) -> Option<Line> {
        match self {
            Kind::Timer => Some(Line::TimerPreset),
            Kind::Count => Some(Line::CounterPreset),
            Kind::Value if xx == 0 => Some(Line::Constant),
            Kind::Move => Some(Line::MoveTo),
            Kind::Drum => Some(Line::Steps),
            Kind::Scale => Some(Line::FromLow),
            Kind::Filter => Some(Line::FilterTime),
            _ => None,
        }
    }

    /// How many bytes store what follows a code with this XX; the steps of a drum not among them.
    pub(crate) const fn line_bytes(self, xx: u8) -> u8 {
        match self {
            Kind::Timer => 5,
            Kind::Count => 4,
            Kind::Value if xx == 0 => 4,
            Kind::Move | Kind::Filter | Kind::Jump => 2,
            Kind::Drum => 1,
            Kind::Scale => 8,
            _ => 0,
        }
    }

    /// The numbers that XX may be, first and last; the board has fewer inputs and outputs, and the
    /// program fewer timers.
    pub const fn numbers(self) -> (u8, u8) {
        match self {
            Kind::Input | Kind::Output => (1, 16),
            Kind::Branch => (1, BRANCH_POINTS),
            Kind::TimerQ => (1, TIMERS),
            Kind::Marker => (1, MARKERS),
            Kind::System | Kind::Pwm => (1, SYSTEM_MARKERS),
            Kind::Counter | Kind::Count => (1, COUNTERS),
            Kind::Register | Kind::Move | Kind::Drum => (1, REGISTERS),
            Kind::Value => (0, REGISTERS),
            Kind::Analogue => (0, ANALOGUE - 1),
            Kind::Reading => (1, 2),
            Kind::Group | Kind::Filter => (1, 8),
            Kind::Bit => (0, 31),
            Kind::Label | Kind::Jump => (1, LABELS),
            Kind::Time | Kind::None | Kind::Timer | Kind::Scale => (0, 99),
        }
    }
}
