//! The assembly of the engine, and what it shares with Rust: every number that both know stands in Rust
//! alone, and comes to the assembly as a constant of this list.

use super::data::Data;
use super::layout::{ADDRESS_BYTES, POINTS, SNAPSHOT_BYTES};
use super::link::{self, Job};
use super::memory;
use crate::instructions::BOARD;
use crate::operation::Images;
use crate::page::Running;
use core::arch::global_asm;
use core::mem::offset_of;
use unoclp_core::isa::{self, Kind, Opcode};

/// The label of each handler, for Rust to find.
macro_rules! labels {
    ($($name:ident $run:literal $handler:ident;)*) => {
        global_asm!($(concat!("        .global ", stringify!($handler)),)*);
    };
}

unoclp_core::uno_engine!(labels);

/// Each constant by its name. Of each instruction `OP_` and its name, the byte that stores it, and `OWN_` and its
/// name, the bytes of data that it has of its own.
macro_rules! assembly {
    ({ $($constant:ident = $value:expr;)* }
        $($name:ident $kind:ident $class:ident $code:literal $letters:literal $stored:literal $own:literal
            $effect:literal $il:literal $picture:literal;)*) => {
        global_asm!(
            $(concat!("        .equ    ", stringify!($constant), ", {", stringify!($constant), "}"),)*
            $(concat!("        .equ    OP_", stringify!($name), ", ", $stored),)*
            $(concat!("        .equ    OWN_", stringify!($name), ", ", $own),)*
            include_str!("rules.s"),
            include_str!("first.s"),
            include_str!("counters.s"),
            include_str!("keep.s"),
            include_str!("more.s"),
            include_str!("handlers.s"),
            include_str!("timers.s"),
            include_str!("real.s"),
            include_str!("numbers.s"),
            include_str!("link.s"),
            include_str!("words.s"),
            $($constant = const $value,)*
        );
    };
}

unoclp_core::instructions!(assembly {
    WIDE = cfg!(mega) as u8;
    NEAR = NEAR;
    VECTORS = VECTORS;
    DATA_OUTPUTS = DATA_OUTPUTS;
    DATA_STACK = DATA_STACK;
    JOB_MORE_OUTPUTS = JOB_MORE_OUTPUTS;
    JOB_PORT = JOB_PORT;
    REAL = BOARD.real as u8;
    PAGE_DATA = offset_of!(Running, data);
    DATA_SYSTEM = offset_of!(Data, system);
    DATA_INPUTS = offset_of!(Data, inputs);
    DATA_MORE_INPUTS = offset_of!(Data, more_inputs);
    DATA_BUDGET = offset_of!(Data, budget);
    DATA_LINE = offset_of!(Data, line);
    DATA_PWM = offset_of!(Data, pwm);
    DATA_ANALOGUE = offset_of!(Data, analogue);
    DATA_READINGS = offset_of!(Data, readings);
    DATA_MARKERS = offset_of!(Data, markers);
    DATA_REGISTERS = offset_of!(Data, registers);

    TIMER_DATA = isa::TIMER_DATA;
    COUNTER_DATA = isa::COUNTER_DATA;
    MARKER_TARGET = isa::MARKER_TARGET;
    TIMER_TARGET = isa::TIMER_TARGET;
    NEAR_REGISTERS = BOARD.engine.near_registers;
    POPPED = isa::POPPED;
    BYTE_CONSTANT = isa::BYTE_CONSTANT;
    LABELS = BOARD.labels;
    POINTS = POINTS;
    INPUTS = Images::INPUTS;

    ROW_BYTES = isa::ROW;
    KIND_IN_ROW = isa::KIND_IN_ROW;
    FIRST_POINT = isa::FIRST_POINT;
    BEHIND_POINTS = isa::BEHIND_POINTS;
    ROW_OF_FIRST_POINT = isa::ROW_OF_FIRST_POINT;
    ROW_BEHIND_POINTS = isa::ROW_BEHIND_POINTS;

    KIND_INPUT = Kind::Input as u8;
    KIND_OUTPUT = Kind::Output as u8;
    KIND_MARKER = Kind::Marker as u8;
    KIND_SYSTEM = Kind::System as u8;
    KIND_TIMER_Q = Kind::TimerQ as u8;
    KIND_COUNTER = Kind::Counter as u8;
    KIND_ANALOGUE = Kind::Analogue as u8;
    KIND_PWM = Kind::Pwm as u8;
    KIND_READING = Kind::Reading as u8;
    KIND_GROUP = Kind::Group as u8;
    KIND_BIT = Kind::Bit as u8;
    KIND_TIME = Kind::Time as u8;
    KIND_LABEL = Kind::Label as u8;
    KIND_JUMP = Kind::Jump as u8;
    KIND_TIMER = Kind::Timer as u8;
    KIND_COUNT = Kind::Count as u8;
    KIND_VALUE = Kind::Value as u8;
    KIND_TABLE = Kind::Table as u8;
    KIND_MOVE = Kind::Move as u8;
    KIND_DRUM = Kind::Drum as u8;
    KIND_SCALE = Kind::Scale as u8;
    KIND_FILTER = Kind::Filter as u8;

    JOB_READER = offset_of!(Job, reader);
    JOB_PUT = offset_of!(Job, put);
    JOB_LIMIT = offset_of!(Job, limit);
    JOB_OWN = offset_of!(Job, own);
    JOB_TIMER = offset_of!(Job, timer);
    JOB_TIMERS = offset_of!(Job, timers);
    JOB_TIMERS_END = offset_of!(Job, timers_end);
    JOB_COUNTERS = offset_of!(Job, counters);
    JOB_COUNTERS_END = offset_of!(Job, counters_end);
    JOB_KEPT = offset_of!(Job, kept);
    JOB_KEPT_END = offset_of!(Job, kept_end);
    JOB_POSITION = offset_of!(Job, position);
    JOB_CLOSING = offset_of!(Job, closing);
    JOB_OPEN = offset_of!(Job, open);
    JOB_OUTPUTS = offset_of!(Job, outputs);
    JOB_JUMPS_BACK = offset_of!(Job, jumps_back);
    JOB_PENDING = offset_of!(Job, pending);
    JOB_ONES = offset_of!(Job, ones);
    JOB_ZEROS = offset_of!(Job, zeros);
    JOB_COUNT = offset_of!(Job, count);
    RUNG = link::RUNG;
    HEAD = link::HEAD;
    JOB_BASE = offset_of!(Job, base);
    JOB_LAST = offset_of!(Job, last);
    JOB_OPEN_CONTACT = offset_of!(Job, normally_open);

    WORDS_WRITTEN = memory::WRITTEN;
    WORDS_ELAPSED = memory::ELAPSED;
});

/// The high byte of the words that the handlers begin in that are run most, and of the data that one byte names. RAM
/// begins at 0x100 or at 0x200, and the page takes two times 0x100.
const NEAR: u8 = if cfg!(mega) { 3 } else { 2 };
/// Bytes of the chip's interrupt vectors, which stand before the handlers.
const VECTORS: usize = if cfg!(mega) { 4 * 57 } else { 4 * 26 };

/// Outputs that are bits of their own.
#[cfg(mega)]
const DATA_OUTPUTS: usize = offset_of!(Data, outputs);
#[cfg(not(mega))]
const DATA_OUTPUTS: usize = 0;

/// Where the stack stands when a scan ends.
#[cfg(mega)]
const DATA_STACK: usize = offset_of!(Data, stack);
#[cfg(not(mega))]
const DATA_STACK: usize = 0;

/// The port of contacts that are pending.
#[cfg(mega)]
const JOB_PORT: usize = offset_of!(Job, port);
#[cfg(not(mega))]
const JOB_PORT: usize = 0;

/// The outputs 05 to 08 that are not PWM.
#[cfg(mega)]
const JOB_MORE_OUTPUTS: usize = offset_of!(Job, more_outputs);
#[cfg(not(mega))]
const JOB_MORE_OUTPUTS: usize = 0;

// `link.s` tells these apart by their bits.
const _: () = {
    // Contacts: bit 5 is set of inverted inputs and of outputs, bit 4 of inputs and outputs that are not
    // inverted, bit 6 of inverted outputs alone.
    assert!(Opcode::InputContact as u8 == 0x10 && Opcode::InputContactNot as u8 == 0x20);
    assert!(Opcode::OutputContact as u8 == 0x30 && Opcode::OutputContactNot as u8 == 0x40);
    // Bit 0 is set of what is inverted.
    assert!(Opcode::XorInput as u8 & 1 == 0);
    assert!(Opcode::XorInputNot as u8 == Opcode::XorInput as u8 + 1);
    assert!(Opcode::Jump as u8 & 1 == 0 && Opcode::JumpNot as u8 == Opcode::Jump as u8 + 1);
    // No kind is 0 but that of what has no operand.
    assert!(Kind::None as u8 == 0);
    // Those of operations that take an operand come last.
    assert!(Kind::Real as u8 == Kind::Value as u8 + 1);
    assert!(Kind::ALL.len() == Kind::Real as usize + 1);
    assert!(isa::WORD_CONSTANT == isa::BYTE_CONSTANT + 1);
    // IF, ELS and END come last.
    assert!(Opcode::If as u8 == 0xFD && Opcode::Else as u8 == 0xFE);
    // What is kept stands together, and its numbers where those of other instructions do.
    let (register, counter) = (Opcode::KeepRegister, Opcode::KeepCounter);
    assert!(counter as usize == register as usize + 1);
    assert!(Opcode::Push as usize == counter as usize + 1);
    let bytes = ADDRESS_BYTES + SNAPSHOT_BYTES;
    assert!(BOARD.engine.run_bytes(register) as usize == bytes);
    assert!(BOARD.engine.run_bytes(counter) as usize == bytes);
    // It keeps address and place of a label, 4 bytes, in the registers.
    assert!(BOARD.labels <= isa::REGISTERS && BOARD.labels.is_power_of_two());
    // The page is left by `subi` with one byte, and all of the data that one byte names stands at its end.
    assert!(offset_of!(Data, registers) < if cfg!(mega) { 256 } else { 128 });
    assert!(offset_of!(Running, data) + offset_of!(Data, system) >= 0x100);
    assert!(size_of::<Running>() == 0x200);
};
