//! What a request with a checksum writes, and who may.

use std::ops::Range;
use unoclp_modbus::client::Request;
use unoclp_modbus::map::{Command, Span, holding};
use unoclp_modbus::{Exception, Table};
use unoclp_site::Role as May;

/// The addresses that a request writes.
///
/// # Errors
/// The exception that refuses what writes none, or is not whole.
pub(crate) fn written(request: &Request) -> Result<(Table, Range<u16>), Exception> {
    let frame = request.bytes();
    let &[_, function, a, b, c, d, ref rest @ ..] = frame else {
        return Err(Exception::IllegalDataValue);
    };
    let [first, count] = [[a, b], [c, d]].map(u16::from_be_bytes);
    let (table, is_several) = match function {
        5 => (Table::Coils, false),
        6 => (Table::HoldingRegisters, false),
        15 => (Table::Coils, true),
        16 => (Table::HoldingRegisters, true),
        _ => return Err(Exception::IllegalFunction),
    };
    let bytes = match table {
        Table::Coils => count.div_ceil(8),
        _ => count.saturating_mul(2),
    };
    let is_whole = match (is_several, rest) {
        (false, rest) => rest.len() == 2,
        (true, &[told, ref data @ ..]) => {
            u16::from(told) == bytes && data.len() == usize::from(told) + 2
        }
        (true, []) => false,
    };
    let count = if is_several { count } else { 1 };
    let end = first.checked_add(count);
    match end {
        Some(end) if is_whole && count > 0 => Ok((table, first..end)),
        _ => Err(Exception::IllegalDataValue),
    }
}

/// What somebody must be allowed to who sends this request.
pub(crate) fn needs(request: &Request) -> May {
    if request.only_reads() {
        return May::Watch;
    }
    match written(request) {
        Ok((Table::HoldingRegisters, range)) => {
            let is_engineers = [holding::SETTINGS, holding::UPLOAD]
                .iter()
                .any(|span| overlaps(*span, &range));
            match is_engineers || command(request) == Some(Command::Upload) {
                true => May::Engineer,
                false => May::Operate,
            }
        }
        Ok(_) => May::Operate,
        // What is not understood may be anything.
        Err(_) => May::Engineer,
    }
}

/// The command that a request gives, if it does.
pub(crate) fn command(request: &Request) -> Option<Command> {
    Command::of(request.written(holding::COMMAND)?)
}

/// Whether a request writes into this span.
pub(crate) fn overlaps(span: Span, range: &Range<u16>) -> bool {
    span.first < range.end && range.start < span.end()
}

#[cfg(test)]
mod tests {
    use super::*;
    use unoclp_modbus::Crc;

    #[test]
    fn programs_and_settings_are_the_engineers() {
        let words = |first, words: &[u16]| Request::write_words(1, first, words).unwrap();
        for (request, may) in [
            (
                Request::read(1, Table::HoldingRegisters, 400, 20),
                May::Watch,
            ),
            (Request::identify(1), May::Watch),
            (Request::write_word(1, 400, 1), May::Operate),
            (Request::write_word(1, 400, 2), May::Operate),
            (Request::write_word(1, 400, 4), May::Operate),
            (Request::write_word(1, 400, 5), May::Engineer),
            (words(400, &[5]), May::Engineer),
            (words(399, &[0, 5]), May::Engineer),
            (Request::write_word(1, 402, 1), May::Operate),
            (words(402, &[1, 1, 0, 0, 30]), May::Operate),
            (words(409, &[0, 7]), May::Engineer),
            (Request::write_word(1, 410, 7), May::Engineer),
            (words(1000, &[0x0001, 0x3100]), May::Engineer),
            (words(999, &[0, 1]), May::Engineer),
            (Request::write_word(1, 2000, 7), May::Operate),
            (Request::write_coil(1, 400, true), May::Operate),
        ] {
            assert_eq!(needs(&request), may, "{:?}", request.bytes());
        }
        let mut mask = vec![1, 22, 0, 0, 0, 0, 0, 0];
        mask.extend(Crc::of(&mask).to_bytes());
        let mask = Request::forwarded(&mask).unwrap();
        assert_eq!(needs(&mask), May::Engineer);
    }
}
