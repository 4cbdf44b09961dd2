//! The instruction table as bytes: a board that keeps constants apart from its RAM keeps it there.

use super::{
    BEHIND_POINTS, FIRST_POINT, Kind, Line, Opcode, POINTS, Row, TABLE, WORD_CONSTANT,
    constant_bytes, holds_point, near_row, xx,
};

/// Bytes of a packed row: the code in 28 bits, low byte first, and above it the run bytes; the kind.
pub const ROW: usize = 5;
/// Where the kind stands among the bytes of a packed row.
pub const KIND_IN_ROW: usize = 4;
/// Where the run bytes do.
const RUN_IN_ROW: usize = 3;
/// The place of the row whose bytes hold the first points, and of the first row after those that hold points.
pub const ROW_OF_FIRST_POINT: u8 = row_of(FIRST_POINT);
/// See [`ROW_OF_FIRST_POINT`].
pub const ROW_BEHIND_POINTS: u8 = row_of(BEHIND_POINTS);
/// The bits of the code in its highest byte.
const CODE: u8 = 0x0F;
/// The highest of them.
const SIGN: u8 = 0x08;
/// No code has as many.
const MOST: u32 = 1 << 27;
/// Run bytes whose bits are all set are one more than they say.
const RUN: u8 = 0x0F;
/// Bytes of a packed kind: the last XX, and in the highest bit the first, which is 0 or 1; the first of its lines, and
/// in the high four bits their bytes.
pub(crate) const KIND: usize = 2;
/// Where the kinds begin, after the rows.
pub(crate) const KINDS: usize = TABLE.len() * ROW;

/// Bytes of the packed table: the instruction table without its texts, and after it the kinds of operands, as a board
/// has them. Only the loader makes sense of it, through [`Rows`].
pub const PACKED: usize = KINDS + Kind::ALL.len() * KIND;

/// The packed table, from where a board keeps it.
pub trait Rows {
    /// Fills bytes with those of the packed table from an index on; with anything beyond its end.
    fn read(&self, at: usize, bytes: &mut [u8]);
}

/// The rows, of instructions that take so many bytes of run memory each.
pub(crate) const fn packed_rows(run: &[u8; TABLE.len()]) -> [u8; KINDS] {
    let mut rows = [0; KINDS];
    let mut at = 0;
    while at < KINDS {
        rows[at] = row(at / ROW, run[at / ROW])[at % ROW];
        at += 1;
    }
    rows
}

/// Bytes of run memory of an instruction, as these rows have them.
pub(crate) const fn packed_run_bytes(rows: &[u8; KINDS], opcode: Opcode) -> u8 {
    run_bytes(rows[ROW * row_of(opcode as u8) as usize + RUN_IN_ROW] >> 4)
}

/// A packed row of the table, of an instruction that takes so many bytes of run memory.
const fn row(index: usize, run: u8) -> [u8; ROW] {
    let Row { code, kind, .. } = TABLE[index];
    let bits = if run > RUN { RUN } else { run };
    assert!(run_bytes(bits) == run && code.unsigned_abs() < MOST);
    let [a, b, c, d] = code.to_le_bytes();
    [a, b, c, d & CODE | bits << 4, kind as u8]
}

/// A packed kind, of which XX may be these numbers.
pub(crate) const fn packed_kind(kind: Kind, numbers: Option<(u8, u8)>) -> [u8; KIND] {
    let (first, last) = match numbers {
        // As it is stored.
        Some((first, _)) if kind.is_value() => (first, WORD_CONSTANT),
        // The loader asks the board itself.
        Some((first, _)) if matches!(kind, Kind::Input | Kind::Output) => (first, POINTS),
        Some(numbers) => numbers,
        // A code without a number has 0 for it.
        None => (0, 99),
    };
    let line = match kind.first_line(0) {
        Some(line) => line as u8,
        None => NO_LINE,
    };
    assert!(first <= 1 && last < 0x80 && kind.line_bytes(0) < 16 && line <= NO_LINE);
    [first << 7 | last, kind.line_bytes(0) << 4 | line]
}

/// In place of a line, where none follows.
const NO_LINE: u8 = 0x0F;

/// What the loader needs of a row.
#[derive(Clone, Copy)]
pub(crate) struct Entry {
    pub kind: Kind,
    pub stored: u8,
    pub run: u8,
    /// The numbers that XX may be; what the board decides is not among them.
    pub first: u8,
    pub last: u8,
    /// The bytes of its lines, and the first of them; where [XX may be a constant](Kind::is_value), of a constant.
    pub line_bytes: u8,
    pub line: Option<Line>,
}

/// How many bytes store the instruction at the head of `stored`, whose row this is; none where they end
/// too soon.
pub(crate) fn stored_size(entry: &Entry, stored: &[u8]) -> Option<usize> {
    let head = if holds_point(*stored.first()?) || !entry.kind.has_number() {
        1
    } else {
        2
    };
    let more = if entry.kind.is_value() {
        constant_bytes(*stored.get(1)?)
    } else if entry.kind == Kind::Drum {
        // Behind a line that was refused it may be any byte.
        stored.get(2)?.wrapping_add(1)
    } else {
        entry.line_bytes
    };
    Some(head + usize::from(more))
}

/// What a row is looked for by.
#[derive(Clone, Copy)]
pub(crate) enum By {
    /// A code that fits it.
    Code(i32),
    /// An instruction's first stored byte.
    Stored(u8),
}

/// The first row that fits, and XX of the code (0 where it has none).
#[inline(never)]
pub(crate) fn find(rows: &impl Rows, by: By) -> Option<(Entry, u8)> {
    let (index, xx) = match by {
        By::Code(code) => find_code(rows, code)?,
        By::Stored(byte) => (row_of(near_row(byte)), 0),
    };
    if usize::from(index) >= TABLE.len() {
        return None;
    }
    // What stands after the rest of the code.
    let mut more = [0; ROW - RUN_IN_ROW];
    rows.read(usize::from(index) * ROW + RUN_IN_ROW, &mut more);
    let [run, kind] = more;
    let mut more = [0; KIND];
    rows.read(KINDS + KIND * usize::from(kind), &mut more);
    let [numbers, lines] = more;
    let entry = Entry {
        kind: Kind::of(kind).unwrap_or(Kind::None),
        stored: stored_of(index),
        run: run_bytes(run >> 4),
        first: numbers >> 7,
        last: numbers & 0x7F,
        line_bytes: lines >> 4,
        line: Line::of(lines & NO_LINE),
    };
    Some((entry, xx))
}

/// The run bytes that these bits stand for.
const fn run_bytes(bits: u8) -> u8 {
    if bits == RUN { RUN + 1 } else { bits }
}

/// The first row that a code fits, and its XX.
fn find_code(rows: &impl Rows, code: i32) -> Option<(u8, u8)> {
    for index in 0..TABLE.len() as u8 {
        let mut row = [0; ROW];
        rows.read(usize::from(index) * ROW, &mut row);
        let [a, b, c, d, kind] = row;
        let d = if d & SIGN != 0 { d | !CODE } else { d & CODE };
        if let Some(xx) = xx(code, i32::from_le_bytes([a, b, c, d]))
            && (xx == 0 || Kind::of(kind).is_some_and(Kind::has_number))
        {
            return Some((index, xx));
        }
    }
    None
}

/// The place in the table of the row that a first stored byte belongs to; where there is none, of
/// another row or beyond the table.
const fn row_of(byte: u8) -> u8 {
    match byte {
        ..0x10 => byte.wrapping_sub(1),
        0x10..0xA0 => (byte >> 4) + 14,
        _ => byte - (0xA0 - 24),
    }
}

/// The byte that stores the instruction of a row, without a point.
const fn stored_of(row: u8) -> u8 {
    match row {
        ..15 => row + 1,
        15..24 => (row - 14) << 4,
        _ => row.wrapping_add(0xA0 - 24),
    }
}

const _: () = {
    let mut row = 0;
    while row < TABLE.len() {
        assert!(
            row_of(TABLE[row].stored) as usize == row && stored_of(row as u8) == TABLE[row].stored
        );
        row += 1;
    }
};
