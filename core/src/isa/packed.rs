//! The instruction table as bytes: a board that keeps constants apart from its RAM keeps it there.

use super::{BEHIND_POINTS, FIRST_POINT, Kind, Line, TABLE, first_of, holds_point, xx};

/// Bytes of a packed row: the code, low byte first; the kind; the stored byte; the run bytes.
pub const ROW: usize = 7;
/// Where the kind stands among the bytes of a packed row.
pub const KIND_IN_ROW: usize = 4;
/// The place of the row whose bytes hold the first points, and of the first row behind those that hold points.
pub const ROW_OF_FIRST_POINT: usize = row_of(FIRST_POINT);
/// See [`ROW_OF_FIRST_POINT`].
pub const ROW_BEHIND_POINTS: usize = row_of(BEHIND_POINTS);
/// Bytes of a packed kind: the first and the last XX; the bytes of its lines; the first of them.
const KIND: usize = 4;
/// Where the kinds begin, behind the rows.
const KINDS: usize = TABLE.len() * ROW;

/// The instruction table without its texts, and behind it the kinds of operands. Only the loader makes
/// sense of it, through a [`PackedTable`].
pub const PACKED: [u8; KINDS + Kind::ALL.len() * KIND] = {
    let mut packed = [0; KINDS + Kind::ALL.len() * KIND];
    let mut row = 0;
    while row < TABLE.len() {
        let [a, b, c, d] = TABLE[row].code.to_le_bytes();
        let kind = TABLE[row].kind as u8;
        let bytes = [a, b, c, d, kind, TABLE[row].stored, TABLE[row].run];
        let mut byte = 0;
        while byte < ROW {
            packed[row * ROW + byte] = bytes[byte];
            byte += 1;
        }
        row += 1;
    }
    let mut index = 0;
    while index < Kind::ALL.len() {
        let kind = Kind::ALL[index];
        assert!(kind as usize == index);
        let (first, last) = match kind.numbers() {
            Some(numbers) => numbers,
            // A code without a number has 0 for it.
            None => (0, 99),
        };
        let line = match kind.first_line(0) {
            Some(line) => line as u8,
            None => NO_LINE,
        };
        let bytes = [first, last, kind.line_bytes(0), line];
        let mut byte = 0;
        while byte < KIND {
            packed[KINDS + index * KIND + byte] = bytes[byte];
            byte += 1;
        }
        index += 1;
    }
    packed
};

/// In place of a line, where none follows.
const NO_LINE: u8 = 0xFF;

/// How [`PACKED`] is read where this board keeps it: fills the bytes from an index on, with anything
/// beyond its end.
pub type PackedTable = fn(usize, &mut [u8]);

/// Reads [`PACKED`] where constants stand in memory like all else.
pub fn read_packed(at: usize, bytes: &mut [u8]) {
    for (byte, &packed) in bytes.iter_mut().zip(PACKED.iter().skip(at)) {
        *byte = packed;
    }
}

/// What the loader needs of a row.
#[derive(Clone, Copy)]
pub(crate) struct Entry {
    pub kind: Kind,
    pub stored: u8,
    pub run: u8,
    /// The numbers that XX may be; what the board decides is not among them.
    pub first: u8,
    pub last: u8,
    /// The bytes of its lines, and the first of them; for [`Kind::Value`] where XX is 0.
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
    let more = if entry.kind == Kind::Value && *stored.get(1)? != 0 {
        0
    } else if entry.kind == Kind::Drum {
        1 + *stored.get(2)?
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
pub(crate) fn find(table: PackedTable, by: By) -> Option<(Entry, u8)> {
    let (at, xx) = match by {
        By::Code(code) => find_code(table, code)?,
        By::Stored(byte) => (row_of(byte) * ROW, 0),
    };
    if at >= KINDS {
        return None;
    }
    let mut row = [0; ROW];
    table(at, &mut row);
    let [.., kind, stored, run] = row;
    let mut more = [0; KIND];
    table(KINDS + KIND * usize::from(kind), &mut more);
    let [first, last, line_bytes, line] = more;
    let entry = Entry {
        kind: Kind::of(kind).unwrap_or(Kind::None),
        stored,
        run,
        first,
        last,
        line_bytes,
        line: Line::of(line),
    };
    match by {
        By::Stored(byte) if first_of(byte) != stored => None,
        _ => Some((entry, xx)),
    }
}

/// Where the first row stands that a code fits, and its XX.
fn find_code(table: PackedTable, code: i32) -> Option<(usize, u8)> {
    let mut row = [0; 5];
    let mut at = 0;
    while at < KINDS {
        table(at, &mut row);
        let [a, b, c, d, kind] = row;
        if let Some(xx) = xx(code, i32::from_le_bytes([a, b, c, d]))
            && (xx == 0 || Kind::of(kind).is_some_and(Kind::has_number))
        {
            return Some((at, xx));
        }
        at += ROW;
    }
    None
}

/// The place in the table of the row that a first stored byte belongs to; where there is none, of
/// another row or beyond the table.
const fn row_of(byte: u8) -> usize {
    let row = match byte {
        ..0x10 => byte.wrapping_sub(1),
        0x10..0xA0 => (byte >> 4) + 14,
        _ => byte - (0xA0 - 24),
    };
    row as usize
}

const _: () = {
    let mut row = 0;
    while row < TABLE.len() {
        assert!(row_of(TABLE[row].stored) == row);
        row += 1;
    }
};
