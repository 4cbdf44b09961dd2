//! What a lock refuses, at every address of the map and at all others.

use crate::common::{request, write};
use unoclp_modbus::map::{ALL, Command, Rights, Span, has, holding, input};
use unoclp_modbus::{FRAME_BYTES, Table, lock};

/// What refuses the writing of a span, by what stands there. The page says the same in words.
fn refused_by(span: &Span) -> u8 {
    const ROWS: [(&str, u8); 12] = [
        ("output", lock::WRITING),
        ("marker", lock::WRITING),
        ("register D", lock::WRITING),
        ("timer", lock::WRITING),
        ("counter", lock::WRITING),
        ("inputs forced", lock::WRITING),
        ("outputs forced", lock::WRITING),
        ("values of the forced", lock::WRITING),
        ("end of forcing", lock::WRITING),
        ("command", lock::COMMANDS),
        ("[settings]", lock::SETTINGS),
        ("[upload]", lock::UPLOAD),
    ];
    let row = ROWS.iter().find(|(begin, _)| span.name.starts_with(begin));
    row.unwrap_or_else(|| panic!("what refuses {span:?}?")).1
}

/// Whether a board that has this lock refuses the request.
fn refuses(request: &[u8], lock: u8) -> bool {
    let mut frame = [0; FRAME_BYTES];
    frame[..request.len()].copy_from_slice(request);
    lock::refuses(&frame, lock)
}

/// Requests of a server that write at an address of a table, one value and several.
fn writes(server: u8, table: Table, first: u16) -> [Vec<u8>; 2] {
    let (one, several) = match table {
        Table::Coils => (5, 15),
        _ => (6, 16),
    };
    [
        request(server, one, [first, 0]),
        write(server, several, first, 1),
    ]
}

fn is_written(span: &Span) -> bool {
    span.rights != Rights::Read
}

#[test]
fn each_address_is_refused_by_its_bit_and_by_no_other() {
    for span in ALL.iter().filter(|span| is_written(span)) {
        let bit = refused_by(span);
        assert_eq!(span.rights.lock(), bit, "{span:?}");
        for first in span.first..span.end() {
            for request in writes(1, span.table, first) {
                for lock in 0..=lock::ALL {
                    let refused = refuses(&request, lock);
                    assert_eq!(refused, lock & bit != 0, "{request:02x?}, lock {lock:04b}");
                }
            }
        }
    }
}

#[test]
fn a_broadcast_is_refused_settings_and_uploads_alone() {
    for span in ALL.iter().filter(|span| is_written(span)) {
        let never = refused_by(span) & (lock::SETTINGS | lock::UPLOAD) != 0;
        for first in span.first..span.end() {
            for request in writes(0, span.table, first) {
                assert_eq!(refuses(&request, 0), never, "{request:02x?}");
            }
        }
    }
}

/// A row of addresses falls under the bit of its first: so where spans join, they have the same.
#[test]
fn spans_that_join_fall_under_one_bit() {
    for pair in ALL.windows(2) {
        let joins = pair[0].table == pair[1].table && pair[0].end() == pair[1].first;
        assert!(
            !joins || pair[0].rights.lock() == pair[1].rights.lock(),
            "{pair:?}"
        );
    }
}

#[test]
fn of_the_commands_one_is_an_upload() {
    let command = holding::COMMAND.first;
    for value in 0..=0xFFFF_u16 {
        let bit = match value {
            5 => lock::UPLOAD,
            _ => lock::COMMANDS,
        };
        let mut several = write(1, 16, command, 1);
        several[7..9].copy_from_slice(&value.to_be_bytes());
        for request in [request(1, 6, [command, value]), several] {
            assert!(refuses(&request, bit), "{value}");
            assert!(!refuses(&request, lock::ALL & !bit), "{value}");
        }
    }
    assert_eq!(Command::Upload as u16, 5);
}

#[test]
fn reading_is_never_refused() {
    for function in (0..=255).filter(|function| !matches!(function, 5 | 6 | 15 | 16)) {
        for span in ALL {
            let request = request(1, function, [span.first, 1]);
            assert!(!refuses(&request, lock::ALL), "{request:02x?}");
        }
    }
}

/// The firmware's short way to [`has`]: a request lies in an area where all of its addresses are there. The program is looked
/// at by itself.
#[test]
fn every_request_that_exists_lies_in_an_area() {
    use unoclp_modbus::map::{AREA, AREAS};
    let lies_in_an_area = |table: Table, first: u16, count: u16| {
        AREAS.as_chunks::<AREA>().0.iter().any(|area| {
            let [its_table, low, high, addresses] = *area;
            let offset = first.wrapping_sub(u16::from_le_bytes([low, high]));
            let addresses = u16::from(addresses);
            its_table == table as u8 && offset < addresses && count <= addresses - offset
        })
    };
    for span in ALL.iter().filter(|span| **span != input::PROGRAM) {
        let most = match span.table.has_words() {
            true => 125,
            false => 2000,
        };
        let edges = [span.first, span.end()];
        let around = edges.map(|edge| edge.saturating_sub(most + 1)..=edge.saturating_add(2));
        for first in around.into_iter().flatten() {
            for count in (1..=most.min(130)).chain([most]) {
                let expected = has(span.table, first, count);
                let is = lies_in_an_area(span.table, first, count);
                assert_eq!(is, expected, "{:?} {first} {count}", span.table);
            }
        }
    }
}
