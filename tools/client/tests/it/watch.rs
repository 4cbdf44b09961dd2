//! A board that is watched.

use crate::fake::{Board, Fate, RUN, STOP};
use crate::line::Wire;
use std::cell::RefCell;
use std::collections::VecDeque;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use unoclp_client::diagnostics::Diagnostics;
use unoclp_client::live::Parts;
use unoclp_client::map::{Command, State, holding};
use unoclp_client::session::{Away, Change, Desk, Event, talk, watch};
use unoclp_client::watch::{Reading, Scope, Side, Wish};
use unoclp_client::{Client, Failure};
use unoclp_modbus::Exception;

/// Who watches: orders one wish after each reading, and unplugs the board after so many.
struct Watcher {
    wishes: RefCell<VecDeque<Wish>>,
    ordered: RefCell<VecDeque<Wish>>,
    ends: Option<u8>,
    readings: RefCell<Vec<Reading>>,
    refused: RefCell<Vec<(Wish, Exception, Diagnostics)>>,
    undone: RefCell<Vec<Wish>>,
    most: usize,
    unplugged: Arc<AtomicBool>,
}

impl Desk for Watcher {
    type Order = Wish;

    fn wants(&self) -> (Scope, Parts) {
        (Scope::default(), Parts::ALL)
    }

    fn hear(&self, event: Event<'_>) {
        if let Event::Seen(reading) = event {
            let mut readings = self.readings.borrow_mut();
            readings.push(reading.clone());
            let is_over = readings.len() >= self.most;
            self.unplugged.store(is_over, Ordering::Relaxed);
            self.ordered
                .borrow_mut()
                .extend(self.wishes.borrow_mut().pop_front());
        }
    }

    fn has_orders(&self) -> bool {
        !self.ordered.borrow().is_empty()
    }

    fn next(&self) -> Option<Wish> {
        self.ordered.borrow_mut().pop_front()
    }

    fn change(&self, _: &Wish) -> Change {
        Change::All
    }

    async fn fulfil(&self, client: &mut Client, wish: Wish) -> Result<(), Failure> {
        match wish.fulfil_until(client, self.ends).await {
            Err(Failure::Refused(exception)) => {
                let board = Diagnostics::read(client).await?;
                self.refused.borrow_mut().push((wish, exception, board));
                Ok(())
            }
            other => other,
        }
    }

    fn undone(&self, wish: Wish, _: &Away) {
        self.undone.borrow_mut().push(wish);
    }
}

fn watcher(readings: usize, ends: Option<u8>, wishes: &[Wish]) -> Watcher {
    Watcher {
        wishes: RefCell::new(wishes.iter().copied().collect()),
        ordered: RefCell::default(),
        ends,
        readings: RefCell::default(),
        refused: RefCell::default(),
        undone: RefCell::default(),
        most: readings,
        unplugged: Arc::default(),
    }
}

fn wire(board: Board, watcher: &Watcher) -> Wire {
    let unplugged = watcher.unplugged.clone();
    Wire::with(board, move |_, _| match unplugged.load(Ordering::Relaxed) {
        true => Fate::Unplugged,
        false => Fate::Answered,
    })
}

/// Watches a board for so many readings, with a wish after each of the first.
fn watched(
    board: Board,
    readings: usize,
    ends: Option<u8>,
    wishes: &[Wish],
) -> (Wire, Watcher, Failure) {
    let watcher = watcher(readings, ends, wishes);
    let mut wire = wire(board, &watcher);
    let failure = wire.talk(async |client: &mut Client| watch(client, &watcher).await);
    (wire, watcher, failure)
}

#[test]
fn a_board_is_read_over_and_over_until_it_is_lost() {
    let (_, watcher, failure) = watched(Board::default(), 3, None, &[]);
    assert_eq!(watcher.readings.borrow().len(), 3);
    assert_eq!(failure, Failure::Lost("unplugged".to_owned()));
}

#[test]
fn a_board_does_what_is_wished() {
    let wishes = [
        Wish::Force(Side::Inputs, 0, Some(true)),
        Wish::Command(Command::Stop),
    ];
    let (_, watcher, _) = watched(Board::default(), 3, None, &wishes);
    let readings = watcher.readings.borrow();
    let states = readings.iter();
    let states: Vec<_> = states
        .map(|reading| (reading.inputs, reading.diagnostics.state))
        .collect();
    let (run, stop) = (Some(State::Run), Some(State::Stop));
    assert_eq!(states, [(0, run), (1, run), (1, stop)]);
}

#[test]
fn what_is_ordered_of_a_board_that_is_lost_is_not_done_later() {
    let stop = Wish::Command(Command::Stop);
    let watcher = watcher(1, None, &[stop]);
    let mut wire = wire(Board::default(), &watcher);
    wire.talk(async |client: &mut Client| talk(client, &watcher, false).await);
    assert_eq!(watcher.readings.borrow().len(), 1);
    assert_eq!(wire.board.state, RUN);
    assert!(watcher.ordered.borrow().is_empty());
}

#[test]
fn what_is_forced_ends_where_nobody_asks() {
    let forced = |to| Wish::Force(Side::Inputs, 0, to);
    let ends = |end_forcing, wish| {
        let (wire, watcher, _) = watched(Board::default(), 3, end_forcing, &[wish]);
        let ends = watcher.readings.borrow().last().unwrap().forcing_ends;
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
    let force = Wish::Force(Side::Outputs, 1, Some(true));
    let (wire, ..) = watched(Board::default(), 2, Some(10), &[force]);
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
    let force = Wish::Force(Side::Inputs, 0, Some(true));
    let (wire, watcher, _) = watched(old, 2, Some(10), &[force]);
    let last = watcher.readings.borrow().last().unwrap().forced();
    assert_eq!((last.ends, last.inputs.get(0)), (None, Some(true)));
    assert_eq!(wire.board.forces, [1, 1, 0, 0, 0]);
}

#[test]
fn a_wish_that_is_refused_is_told_with_how_the_board_stands() {
    let run = Wish::Command(Command::Run);
    let switched = Board {
        switch: true,
        ..Board::in_state(STOP)
    };
    let (_, watcher, _) = watched(switched, 2, None, &[run]);
    let refused = watcher.refused.borrow();
    let [(wish, exception, board)] = &refused[..] else {
        panic!("{refused:?}");
    };
    assert_eq!((*wish, *exception), (run, Exception::ServerDeviceFailure));
    assert!(board.is_switched_off());
}
