//! Instructions that the text says by their codes.
//!
//! Owns what is known of the board behind one. Must not know how a text writes them.

use unoclp_core::isa::{Class, Kind, Row, TABLE, TIMER_OPERAND};
use unoclp_point::Address;
use unoclp_text::diagnostics::Span;

/// `68XX`: where a move goes.
const MOVE_TO: i32 = 6800;
/// `77XX`: the marker that a timer drives.
const MARKER_TARGET: i32 = 7700;

/// The row of a code that has this class.
fn is(code: i32, class: Class) -> bool {
    let of = |row: &Row| row.class == class && row.code == code;
    TABLE.iter().any(of)
}

/// Whether a timer's block begins with this code, so that it takes a number.
pub(super) fn is_timer(code: i32) -> bool {
    is(code, Class::Timer)
}

/// Whether a timer's block with this last line calls another again.
pub(super) fn is_call(target: i32) -> bool {
    (TIMER_OPERAND..TIMER_OPERAND + 100).contains(&target)
}

/// The markers, registers and counters that an instruction names, so that nothing else is put there.
pub(super) fn named(codes: &[(i32, Span)]) -> Vec<Address> {
    let Some(&(code, _)) = codes.first() else {
        return Vec::new();
    };
    let of = |row: &&Row| {
        let number = code.unsigned_abs().wrapping_sub(row.code.unsigned_abs());
        let most = if row.kind.has_number() { 99 } else { 0 };
        row.code.signum() == code.signum() && number <= most
    };
    let Some(row) = TABLE.iter().find(of) else {
        return Vec::new();
    };
    let number = (code.unsigned_abs() - row.code.unsigned_abs()) as u8;
    let line = |at: usize| codes.get(at).map_or(0, |(line, _)| *line);
    let count = |at: usize| u8::try_from(line(at)).unwrap_or(0);
    let registers = |first: u8, count: u8| {
        let all = first..first.saturating_add(count);
        all.map(Address::Register).collect::<Vec<_>>()
    };
    match row.kind {
        Kind::Marker => vec![Address::Marker(number)],
        Kind::Group => (1..=8)
            .map(|bit| {
                Address::Marker(
                    number
                        .saturating_sub(1)
                        .saturating_mul(8)
                        .saturating_add(bit),
                )
            })
            .collect(),
        Kind::Counter | Kind::Count => vec![Address::Count(number)],
        Kind::Register | Kind::Value | Kind::Real | Kind::Drum => registers(number, 1),
        Kind::Table => registers(number, count(1)),
        Kind::Move => {
            let to = u8::try_from(line(1).wrapping_sub(MOVE_TO)).unwrap_or(0);
            [registers(number, count(2)), registers(to, count(2))].concat()
        }
        Kind::Timer => match u8::try_from(line(2).wrapping_sub(MARKER_TARGET)) {
            Ok(marker @ 1..=99) => vec![Address::Marker(marker)],
            _ => Vec::new(),
        },
        _ => Vec::new(),
    }
}
