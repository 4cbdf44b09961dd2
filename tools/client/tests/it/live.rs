//! A reading that is kept up: how many requests it takes, how long they take on the line, and what is known when.

use crate::fake::Board;
use crate::line::{MS, Wire};
use std::time::Duration;
use unoclp_client::live::{Live, Parts};
use unoclp_client::map::{Command, holding, input};
use unoclp_client::watch::{Meter, Reading, Scope, Side, command, force};
use unoclp_client::{Client, Failure};

const ALL: Parts = Parts {
    markers: true,
    analogue: true,
    registers: true,
};

/// A program of some size: it uses every kind of point.
const LARGE: Scope = Scope {
    registers: 16,
    timers: 12,
    counters: 8,
};

/// A line of 115,200 baud; after each request the board hears 1.75 ms of silence, and takes some scans.
fn line(board: Board) -> Wire {
    let mut wire = Wire::new(board);
    (wire.delay, wire.byte) = (3 * MS, Duration::from_micros(87));
    wire
}

async fn rounds(
    client: &mut Client,
    live: &mut Live,
    count: usize,
    (scope, parts): (Scope, Parts),
) -> Result<Reading, Failure> {
    let mut last = Reading::default();
    for _ in 0..count {
        last = live.round(client, scope, parts).await?.clone();
        live.pause(client, || false).await?;
    }
    Ok(last)
}

/// Requests and time of each of many rounds after the first.
fn per_round(mut wire: Wire, scope: Scope, parts: Parts) -> (f64, Duration) {
    const ROUNDS: u32 = 70;
    let mut live = Live::default();
    wire.talk(async |client| rounds(client, &mut live, 1, (scope, parts)).await)
        .unwrap();
    let (sent, now) = (wire.sent.len(), wire.now);
    wire.talk(async |client| rounds(client, &mut live, ROUNDS as usize, (scope, parts)).await)
        .unwrap();
    let requests = (wire.sent.len() - sent) as f64 / f64::from(ROUNDS);
    (requests, (wire.now - now) / ROUNDS)
}

#[test]
fn bits_are_read_25_times_a_second() {
    let parts = Parts {
        markers: true,
        ..Parts::default()
    };
    for (parts, most) in [(Parts::default(), 3.4), (parts, 4.4)] {
        let (requests, time) = per_round(line(Board::default()), Scope::default(), parts);
        assert!(requests <= most, "{requests} requests");
        assert!(time <= 40 * MS, "{time:?}");
    }
}

#[test]
fn a_program_of_all_kinds_of_points_is_read_within_100_ms() {
    let (requests, time) = per_round(line(Board::default()), LARGE, ALL);
    assert!(requests <= 8.4, "{requests} requests");
    assert!(time <= 75 * MS, "{time:?}");
}

#[test]
fn between_rounds_the_line_is_left_to_others() {
    let mut wire = line(Board::default());
    let mut live = Live::default();
    wire.talk(async |client| rounds(client, &mut live, 30, (LARGE, ALL)).await)
        .unwrap();
    let inputs = wire.sent.iter().enumerate().skip(1);
    let begins = inputs.filter(|(_, (_, sent))| sent[1] == 2);
    for (index, &(at, _)) in begins {
        let before = wire.sent[index - 1].0;
        assert!(at - before >= 5 * MS, "{:?}", at - before);
    }
}

/// Every third round takes longer than a period.
#[test]
fn a_long_round_is_made_up_for() {
    let parts = Parts {
        markers: true,
        ..Parts::default()
    };
    let mut wire = line(Board::default());
    wire.delay = 4 * MS;
    let (requests, time) = per_round(wire, Scope::default(), parts);
    assert!(requests > 4.0, "{requests} requests");
    assert!(time <= 37 * MS, "{time:?}");
}

#[test]
fn what_hardly_changes_comes_in_turn() {
    let mut wire = line(Board::default());
    let mut live = Live::default();
    let mut read = |wire: &mut Wire, count| {
        wire.talk(async |client| rounds(client, &mut live, count, (LARGE, Parts::default())).await)
            .unwrap()
    };
    read(&mut wire, 1);
    let (t, c) = (holding::TIMERS, holding::COUNTERS);
    let word = |table: u16, address, word| ((table, address), word);
    wire.board.words = [
        word(t.table as u16, t.first + 1, 5),
        word(c.table as u16, c.first + 3, 6),
        word(input::FREE_STACK.table as u16, input::FREE_STACK.first, 99),
        word(input::ANALOGUE.table as u16, input::ANALOGUE.first, 512),
        word(holding::FIRST_REGISTERS.table as u16, 1, 7),
        // What moves.
        word(input::TIMERS.table as u16, input::TIMERS.first + 1, 3),
    ]
    .into();
    (wire.board.markers, wire.board.inputs) = (4, 8);
    wire.board.forces = [1, 1, 0, 0, 30];
    let next = read(&mut wire, 1);
    assert_eq!((next.inputs, next.timers[0].value), (9, 3));
    assert_eq!(next.diagnostics.free_stack, 0, "its turn comes");
    let all = read(&mut wire, 3 * 6);
    assert_eq!(
        all.timers[0],
        Meter {
            value: 3,
            preset: 5
        }
    );
    assert_eq!(all.counters[1].preset, 6);
    assert_eq!((all.diagnostics.free_stack, all.analogue[0]), (99, 512));
    assert_eq!((all.registers[0], all.markers), (7, Some(4)));
    assert_eq!((all.forced_inputs.points, all.forcing_ends), (1, Some(30)));
}

/// Of a program without timers and counters two parts have a turn: what is forced, and the diagnostics.
#[test]
fn what_is_read_in_each_round_has_no_turn() {
    let mut wire = line(Board::default());
    let mut live = Live::default();
    let mut read = |wire: &mut Wire, count| {
        wire.talk(async |client| rounds(client, &mut live, count, (Scope::default(), ALL)).await)
            .unwrap()
    };
    read(&mut wire, 1);
    let stack = input::FREE_STACK;
    let place = (stack.table as u16, stack.first);
    wire.board.words.insert(place, 99);
    assert_eq!(read(&mut wire, 3).diagnostics.free_stack, 0);
    assert_eq!(read(&mut wire, 1).diagnostics.free_stack, 99);
}

#[test]
fn what_was_just_forced_is_known_in_the_next_round() {
    let mut wire = line(Board::default());
    let mut live = Live::default();
    let reading = wire.talk(async |client| {
        rounds(client, &mut live, 3, (LARGE, ALL)).await?;
        force(client, Side::Outputs, 1, Some(true), None).await?;
        live.points_have_changed();
        rounds(client, &mut live, 1, (LARGE, ALL)).await
    });
    assert_eq!(reading.unwrap().forced_outputs.get(1), Some(true));
}

#[test]
fn another_program_or_a_restart_has_everything_read() {
    let uptime = |wire: &mut Wire, ms| {
        let place = (input::UPTIME.table as u16, input::UPTIME.first + 1);
        wire.board.words.insert(place, ms);
    };
    let mut wire = line(Board::default());
    let mut live = Live::default();
    let mut read = |wire: &mut Wire, scope| {
        wire.talk(async |client| rounds(client, &mut live, 1, (scope, ALL)).await)
            .unwrap()
    };
    uptime(&mut wire, 5000);
    assert_eq!(read(&mut wire, LARGE).timers.len(), 12);
    assert_eq!(read(&mut wire, Scope::default()).timers.len(), 0);
    // While nobody looked the board has restarted, with another program.
    uptime(&mut wire, 20);
    wire.board.kept.sum = 4711;
    wire.talk(async |client| command(client, Command::Stop).await)
        .unwrap();
    let reading = read(&mut wire, Scope::default());
    assert_eq!(reading.diagnostics.program.sum, 4711);
}

/// Its firmware has four inputs, and neither markers nor registers.
#[test]
fn an_old_board_is_live_too() {
    let mut wire = line(Board {
        is_of_version_1: true,
        inputs: 5,
        ..Board::default()
    });
    let mut live = Live::default();
    let reading = wire.talk(async |client| rounds(client, &mut live, 9, (LARGE, ALL)).await);
    let reading = reading.unwrap();
    assert_eq!((reading.inputs, reading.markers), (5, None));
    assert!(reading.registers.is_empty() && reading.timers.is_empty());
}

/// Where each request of a round reads: what a program does is read before what it does it for.
#[test]
fn effects_are_read_before_their_causes() {
    let mut wire = line(Board::default());
    let mut live = Live::default();
    for _ in 0..2 {
        let begun = wire.sent.len();
        wire.talk(async |client| rounds(client, &mut live, 1, (LARGE, ALL)).await)
            .unwrap();
        let functions: Vec<u8> = wire.sent[begun..]
            .iter()
            .map(|(_, frame)| frame[1])
            .collect();
        let first = |function| functions.iter().position(|&one| one == function);
        // Read coils: outputs and markers; read discrete inputs.
        assert_eq!(first(1), Some(0), "{functions:?}");
        let inputs = first(2).unwrap();
        assert!(
            functions[inputs..].iter().all(|&one| one != 1 && one != 4),
            "{functions:?}"
        );
    }
}
