//! Reading the program back that a board keeps.

use crate::fake::{Board, kept};
use crate::line::Wire;
use unoclp_client::diagnostics::Kept;
use unoclp_client::download::{Unread, download};
use unoclp_client::map::input;
use unoclp_core::{Board as Facts, Loader};

const JUMPS: &str = "0\n\n/ the line of a jump is stored with it\n827301\n\n74778003\n787600\n766800\n-70000\n838401\n787600\n766603\n877901\n";

/// A board that keeps the program of this text.
fn keeping(text: &str) -> Board {
    let mut memory = vec![0; Facts::UNO.linked_bytes.into()];
    let mut loader = Loader::new(&mut memory, Facts::UNO);
    text.bytes().for_each(|byte| loader.push(byte).unwrap());
    let mut board = Board {
        kept: kept(text),
        ..Board::default()
    };
    for (pair, address) in loader
        .finish()
        .unwrap()
        .stored()
        .chunks(2)
        .zip(input::PROGRAM.first..)
    {
        let word = u16::from_be_bytes([pair[0], pair.get(1).copied().unwrap_or(0xEE)]);
        board
            .words
            .insert((input::PROGRAM.table as u16, address), word);
    }
    board
}

fn read(board: Board) -> Result<String, Unread> {
    Wire::new(board).talk(async |client| download(client, Facts::UNO).await)
}

#[test]
fn what_is_read_is_kept_as_the_same_again() {
    let long = format!("0\n{}", "787600\n827301\n877901\n".repeat(200));
    for text in ["0\n877901\n", JUMPS, &long] {
        let code = read(keeping(text)).unwrap();
        assert_eq!(kept(&code), kept(text), "{code}");
    }
    assert_eq!(
        read(keeping("0\n/ no comment\n877901\n")).unwrap(),
        "0\n877901\n"
    );
}

#[test]
fn a_request_reads_as_much_as_an_answer_holds() {
    let mut wire = Wire::new(keeping(&format!("0\n{}", "827301\n877901\n".repeat(200))));
    let bytes = usize::from(wire.board.kept.bytes);
    wire.talk(async |client| download(client, Facts::UNO).await.map(drop))
        .unwrap();
    // One more has read how many bytes there are.
    assert_eq!(wire.sent.len(), 1 + bytes.div_ceil(240));
}

#[test]
fn what_is_no_program_of_this_board_is_not_shown() {
    let board = keeping(JUMPS);
    let with = |kept: Kept| Board {
        kept,
        ..keeping(JUMPS)
    };
    let sum = board.kept.sum ^ 1;
    for sum in [sum, 0] {
        assert_eq!(read(with(Kept { sum, ..board.kept })), Err(Unread::Other));
    }
    assert_eq!(
        read(with(Kept {
            bytes: 901,
            ..board.kept
        })),
        Err(Unread::Other)
    );
    assert_eq!(
        read(with(Kept {
            bytes: 0,
            sum: 0,
            ..board.kept
        })),
        Err(Unread::Empty)
    );
    let old = Board {
        is_of_version_1: true,
        ..board
    };
    assert_eq!(read(old), Err(Unread::Untold));
}

#[test]
fn a_program_may_fill_its_board() {
    let read = |stored_bytes| {
        let facts = Facts {
            stored_bytes,
            ..Facts::UNO
        };
        Wire::new(keeping(JUMPS)).talk(async |client| download(client, facts).await)
    };
    let bytes = kept(JUMPS).bytes;
    assert_eq!(read(bytes).map(|code| kept(&code)), Ok(kept(JUMPS)));
    assert_eq!(read(bytes - 1), Err(Unread::Other));
}
