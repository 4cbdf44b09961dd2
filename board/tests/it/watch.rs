//! A board that is watched.

use crate::fake::{Board, Fate, STOP};
use crate::line::{MS, Wire};
use unoclp_board::map::{Command, State};
use unoclp_board::watch::{Reading, Scope, Seen, Side, Wish, Wishes, watch};
use unoclp_board::{Client, Failure};
use unoclp_modbus::Exception;

/// Watches until the line fails, which it does behind so many requests; says what was seen, and when.
fn watched(
    board: Board,
    requests: u32,
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
        watch(client, Scope::default(), &wishes, &mut see).await
    });
    (wire, seen, failure)
}

/// Requests of one reading.
const READING: u32 = 8;

fn readings(seen: &[Seen]) -> Vec<&Reading> {
    let readings = seen.iter().map(|seen| match seen {
        Seen::Reading(reading) => &**reading,
        Seen::Refused(wish, ..) => panic!("{wish:?} was refused"),
    });
    readings.collect()
}

#[test]
fn a_board_is_read_over_and_over_until_it_is_lost() {
    let (wire, seen, failure) = watched(Board::default(), 3 * READING, |_, _| ());
    assert_eq!(readings(&seen).len(), 3);
    assert_eq!(failure, Failure::Lost("unplugged".to_owned()));
    // The line is left to others for a while behind a reading.
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
    let (wire, seen, _) = watched(Board::default(), 27, |_, wishes| {
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

#[test]
fn a_wish_that_is_refused_comes_back_with_how_the_board_stands() {
    let run = Wish::Command(Command::Run);
    let switched = Board {
        switch: true,
        ..Board::in_state(STOP)
    };
    let mut wished = false;
    let (_, seen, _) = watched(switched, 2 * READING + 2, |_, wishes| {
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
