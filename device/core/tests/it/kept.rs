//! Numbers that a program keeps over a power cut: the room that their records need, and how old they may be (NC-21).

use unoclp_core::{Board, Cause, Loader, Plc};

/// For how many minutes, on an UNO whose program memory ends so many bytes after the program.
fn within(codes: &str, room: usize) -> Result<Option<u16>, Cause> {
    let codes = format!("0\n{codes}827301\n877901\n");
    let load = |board: Board| {
        let mut memory = [0; 2_000];
        let mut loader = Loader::new(&mut memory, board);
        for byte in codes.bytes() {
            loader.push(byte).map_err(|fault| fault.cause)?;
        }
        let program = loader.finish().map_err(|fault| fault.cause)?;
        Ok((program.stored_bytes(), program.kept_within()))
    };
    let (bytes, _) = load(Board::UNO)?;
    let stored_bytes = (bytes + room) as u16;
    let board = Board {
        stored_bytes,
        ..Board::UNO
    };
    load(board).map(|(_, minutes)| minutes)
}

#[test]
fn two_records_need_room() {
    let (one, two) = ("756801\n", "756801\n756701\n");
    assert_eq!(within(one, 14), Ok(Some(27)));
    assert_eq!(within(one, 13), Err(Cause::ProgramFull));
    assert_eq!(within(two, 22), Ok(Some(27)));
    assert_eq!(within(two, 21), Err(Cause::ProgramFull));
}

#[test]
fn more_records_are_written_more_often() {
    assert_eq!(within("756801\n", 53 * 7), Ok(Some(1)));
    assert_eq!(within("756801\n", 53 * 7 - 1), Ok(Some(2)));
    assert_eq!(within("756801\n756802\n", 53 * 11), Ok(Some(1)));
    assert_eq!(within("756801\n756802\n", 53 * 11 - 1), Ok(Some(2)));
    assert_eq!(within("", 53 * 7), Ok(None));
}

/// NC-12: a bit for each of M 57 to M 64, and none besides.
#[test]
fn retentive_markers_are_brought_back() {
    let mut memory = [0; 100];
    let mut loader = Loader::new(&mut memory, Board::UNO);
    for byte in *b"0\n" {
        loader.push(byte).unwrap();
    }
    let mut plc = Plc::new(loader.finish().unwrap());
    plc.set_marker(56, true);
    plc.set_marker(58, true);
    plc.retain(0b1000_0001);
    assert_eq!(plc.retained(), 0b1000_0001);
    assert_eq!(plc.markers(), 1 << 55 | 1 << 56 | 1 << 63);
}
