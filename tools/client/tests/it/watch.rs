//! A board that is watched.

use crate::fake::{Board, Fate, STOP};
use crate::line::{MS, Wire};
use unoclp_client::map::{Command, State, holding};
use unoclp_client::watch::{Reading, Scope, Seen, Side, Wish, Wishes, watch};
use unoclp_client::{Client, Failure};
use unoclp_modbus::Exception;

/// Watches until the line fails, which it does after so many requests; says what was seen, and when.
fn watched(
    board: Board,
    requests: u32,
    end_forcing: Option<u8>,
    mut act: impl FnMut(&Seen, &Wishes),
) -> (Wire, Vec<Seen>, Failure) {
    let mut count = 0;
    let mut wire = Wire::with(board, move |_, _| {
        count += 1;
        if count > requests {
            Fate::Unplugged
        } else {
            Fate::Answered
        }
    });
    let wishes = Wishes::default();
    let mut seen = Vec::new();
    let failure = wire.talk(async |client: &mut Client| {
        let mut see = |what: Seen| {
            act(&what, &wishes);
            seen.push(what);
        };
        watch(client, Scope::default(), end_forcing, &wishes, &mut see).await
    });
    (wire, seen, failure)
}

/// Requests of one reading.
const READING: u32 = 7;

fn readings(seen: &[Seen]) -> Vec<&Reading> {
    let readings = seen.iter().map(|seen| match seen {
        Seen::Reading(reading) => &**reading,
        Seen::Refused(wish, ..) => panic!("{wish:?} was refused"),
    });
    readings.collect()
}

#[test]
fn a_board_is_read_over_and_over_until_it_is_lost() {
    let (wire, seen, failure) = watched(Board::default(), 3 * READING, None, |_, _| ());
    assert_eq!(readings(&seen).len(), 3);
    assert_eq!(failure, Failure::Lost("unplugged".to_owned()));
    // The line is left to others for a while after a reading.
    let pause = wire.sent[READING as usize].0 - wire.sent[READING as usize - 1].0;
    assert!(pause > 50 * MS, "{pause:?}");
}

#[test]
fn a_board_does_what_is_wished() {
    let mut wished = [
        Wish::Force(Side::Inputs, 0, Some(true)),
        Wish::Command(Command::Stop),
    ]
    .into_iter();
    let (wire, seen, _) = watched(Board::default(), 3 * READING + 3, None, |_, wishes| {
        if let Some(wish) = wished.next() {
            wishes.push(wish);
        }
    });
    let states: Vec<_> = readings(&seen)
        .iter()
        .map(|reading| (reading.inputs, reading.diagnostics.state))
        .collect();
    let (run, stop) = (Some(State::Run), Some(State::Stop));
    assert_eq!(states, [(0, run), (1, run), (1, stop)]);
    // A wish is not kept waiting: the request before it was answered 3 ms after it was sent.
    let at = READING as usize;
    assert_eq!(wire.sent[at].0 - wire.sent[at - 1].0, 5 * MS);
}

/// Wishes this once, and gives what was seen after it.
fn wishing(board: Board, end_forcing: Option<u8>, wish: Wish) -> (Wire, Vec<Seen>) {
    let mut wished = Some(wish);
    let (wire, seen, _) = watched(board, 4 * READING, end_forcing, |_, wishes| {
        if let Some(wish) = wished.take() {
            wishes.push(wish);
        }
    });
    (wire, seen)
}

#[test]
fn what_is_forced_ends_where_nobody_asks() {
    let forced = |to| Wish::Force(Side::Inputs, 0, to);
    let ends = |end_forcing, wish| {
        let (wire, seen) = wishing(Board::default(), end_forcing, wish);
        let ends = readings(&seen).last().unwrap().forcing_ends;
        assert_eq!(ends, Some(wire.board.forces[4] as u8));
        (wire.board.forces[0], ends.unwrap())
    };
    assert_eq!(ends(Some(10), forced(Some(true))), (1, 10));
    assert_eq!(ends(None, forced(Some(true))), (1, 0));
    // What is let go needs no end.
    assert_eq!(ends(Some(10), forced(None)), (0, 0));
    assert_eq!(ends(Some(10), Wish::Release), (0, 0));
}

#[test]
fn no_point_is_forced_before_its_end_is_set() {
    let (wire, _) = wishing(
        Board::default(),
        Some(10),
        Wish::Force(Side::Outputs, 1, Some(true)),
    );
    let written = wire
        .sent
        .iter()
        .filter(|(_, sent)| matches!(sent[1], 6 | 16));
    let written: Vec<u16> = written
        .map(|(_, sent)| u16::from_be_bytes([sent[2], sent[3]]))
        .collect();
    let (end, points) = (holding::FORCING_ENDS.first, holding::FORCED_OUTPUTS.first);
    assert_eq!(written, [end, points]);
}

#[test]
fn a_board_without_an_end_of_forcing_is_forced_all_the_same() {
    let old = Board {
        is_of_version_1: true,
        ..Board::default()
    };
    let (wire, seen) = wishing(old, Some(10), Wish::Force(Side::Inputs, 0, Some(true)));
    let last = readings(&seen).last().unwrap().forced();
    assert_eq!((last.ends, last.inputs.get(0)), (None, Some(true)));
    assert_eq!(wire.board.forces, [1, 1, 0, 0, 0]);
}

#[test]
fn a_wish_that_is_refused_comes_back_with_how_the_board_stands() {
    let run = Wish::Command(Command::Run);
    let switched = Board {
        switch: true,
        ..Board::in_state(STOP)
    };
    let mut wished = false;
    let (_, seen, _) = watched(switched, 2 * READING + 2, None, |_, wishes| {
        if !std::mem::replace(&mut wished, true) {
            wishes.push(run);
        }
    });
    let [_, Seen::Refused(wish, exception, board), _] = &seen[..] else {
        panic!("{seen:?}");
    };
    assert_eq!((*wish, *exception), (run, Exception::ServerDeviceFailure));
    assert!(board.is_switched_off());
}
