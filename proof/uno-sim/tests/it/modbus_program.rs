//! The program that a board keeps, read back over Modbus.

use crate::common::card;
use crate::common::line::talk;
use crate::common::modbus::{ask, input, serving, to_serving, words};
use unoclp_checked::Checked;
use unoclp_client::download::{Unread, download};
use unoclp_core::Board;
use unoclp_host_sim::random::{Random, random_program};
use unoclp_testing::{cases, held};
use unoclp_uno_sim::{Program, Slot, Uno, nano_file};

/// A program with constants of each size, and a jump whose line is stored with it.
const JUMPS: &str = "0\n\n/ the line of a jump is stored with it\n827301\n\n74778003\n787600\n766800\n-70000\n838401\n787600\n766603\n877901\n";
/// The words that the longest program takes, and where they begin.
const PROGRAM: u16 = 1000;
const WORDS: u16 = 450;

fn stored(text: &str) -> Vec<u8> {
    let checked =
        Checked::read(text.as_bytes(), Board::UNO).unwrap_or_else(|e| panic!("{e:?}\n{text}"));
    checked.program().stored().to_vec()
}

#[test]
fn the_program_of_a_board_is_read_back_as_it_keeps_it() {
    let kept = |text: &str| {
        let mut uno = serving(text);
        let code = talk(&mut uno, async |client| download(client, Board::UNO).await);
        let code = code.unwrap_or_else(|why| panic!("{why:?}\n{text}"));
        assert_eq!(stored(&code), stored(text), "{text}\nwas read as\n{code}");
        // It goes on meanwhile.
        assert_eq!(input(&mut uno, 16), 1, "{text}");
    };
    kept(JUMPS);
    cases(0..20).for_each(|seed| held(|| kept(&random_program(&mut Random::new(seed)))));
}

#[test]
fn what_lies_beyond_the_longest_program_is_not_told() {
    let mut uno = serving("0\n877901\n");
    let refused = |uno: &mut Uno, first: u16, count: u8| {
        let [high, low] = first.to_be_bytes();
        ask(uno, &[1, 4, high, low, 0, count]).expect("a reply")[1..3] == [0x84, 2]
    };
    let last = PROGRAM + WORDS - 1;
    assert!(!refused(&mut uno, last, 1) && !refused(&mut uno, last - 124, 125));
    for (first, count) in [
        (last, 2),
        (last + 1, 1),
        (PROGRAM - 1, 1),
        (PROGRAM - 1, 2),
        (last - 123, 125),
        (u16::MAX, 1),
    ] {
        assert!(refused(&mut uno, first, count), "{count} from {first}");
    }
    // A request may begin and end anywhere.
    let all: Vec<u16> = (0..9)
        .flat_map(|at| words(&mut uno, 4, PROGRAM + 50 * at, 50))
        .collect();
    for (first, count) in [(3, 8), (7, 9), (100, 125), (449, 1)] {
        let some = words(&mut uno, 4, PROGRAM + first, count);
        assert_eq!(
            some,
            all[usize::from(first)..usize::from(first + count)],
            "{count} from {first}"
        );
    }
}

#[test]
fn a_nano_says_that_it_does_not_tell_its_program() {
    let program = Program::read(&nano_file().unwrap()).unwrap();
    let mut nano = Uno::with_program(program, Slot::Card(card(JUMPS))).unwrap();
    to_serving(&mut nano);
    let code = talk(&mut nano, async |client| download(client, Board::UNO).await);
    assert_eq!(code, Err(Unread::Untold));
}
