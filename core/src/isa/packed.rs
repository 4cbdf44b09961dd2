//! The instruction table as bytes: a board that keeps constants apart from its RAM keeps it there.

use super::{Kind, TABLE, first_of, xx};

/// Bytes of a packed row: the code, low byte first; the kind; the stored byte; the run bytes.
const ROW: usize = 7;

/// The instruction table without its texts. Only the loader makes sense of it, through a [`PackedTable`].
pub const PACKED: [u8; TABLE.len() * ROW] = {
    let mut packed = [0; TABLE.len() * ROW];
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
    packed
};

/// How [`PACKED`] is read where this board keeps it: gives the byte at an index, and anything for an
/// index beyond its end.
pub type PackedTable = fn(usize) -> u8;

/// Reads [`PACKED`] where constants stand in memory like all else.
pub fn read_packed(at: usize) -> u8 {
    PACKED.get(at).copied().unwrap_or_default()
}

/// What the loader needs of a row.
#[derive(Clone, Copy)]
pub(crate) struct Entry {
    pub kind: Kind,
    pub stored: u8,
    pub run: u8,
}

/// The row that a code fits, and its XX (0 where it has none).
#[inline(never)]
pub(crate) fn find_code(table: PackedTable, code: i32) -> Option<(Entry, u8)> {
    find(table, |base, entry| {
        if entry.kind.has_number() {
            xx(code, base)
        } else {
            (base == code).then_some(0)
        }
    })
}

/// The row of an instruction's first stored byte.
#[inline(never)]
pub(crate) fn find_stored(table: PackedTable, byte: u8) -> Option<Entry> {
    let first = first_of(byte);
    find(table, |_, entry| (entry.stored == first).then_some(0)).map(|(entry, _)| entry)
}

#[inline(always)]
fn find(table: PackedTable, fits: impl Fn(i32, &Entry) -> Option<u8>) -> Option<(Entry, u8)> {
    let mut at = 0;
    while at < PACKED.len() {
        let mut next = || {
            let byte = table(at);
            at += 1;
            byte
        };
        let base = i32::from_le_bytes([next(), next(), next(), next()]);
        let entry = Entry {
            kind: Kind::of(next()),
            stored: next(),
            run: next(),
        };
        if let Some(xx) = fits(base, &entry) {
            return Some((entry, xx));
        }
    }
    None
}

macro_rules! kinds {
    ($($kind:ident)*) => {
        impl Kind {
            /// The kind with this discriminant.
            const fn of(byte: u8) -> Kind {
                $(if byte == Kind::$kind as u8 {
                    return Kind::$kind;
                })*
                Kind::None
            }
        }
    };
}
kinds! {
    Input Output Branch Marker System TimerQ Counter Register Analogue Pwm Reading Group Bit Time Label
    Jump Timer Count Value Move Drum Scale Filter
}
