//! A board that is watched.

use crate::fake::{Board, Fate, RUN, STOP};
use crate::line::{PATIENCE, Wire};
use std::cell::RefCell;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;
use unoclp_boot::{Image, Model};
use unoclp_client::live::Parts;
use unoclp_client::lock;
use unoclp_client::map::{Command, State, holding};
use unoclp_client::order::{Order, Refusal, Undone};
use unoclp_client::session::{Away, Desk, Event, Orders, talk, watch};
use unoclp_client::upload::Upload;
use unoclp_client::watch::{Reading, Scope, Side};
use unoclp_client::{Client, Conversation, Failure, Format, Line, Next, Parity};
use unoclp_point::Address;

/// Who watches: orders one thing after each reading, and unplugs the board after so many.
struct Watcher {
    /// What is to be ordered, the first last.
    wanted: RefCell<Vec<Order>>,
    ordered: Orders,
    ends: Option<u8>,
    readings: RefCell<Vec<Reading>>,
    /// All else that was heard, in a word or two.
    heard: RefCell<Vec<String>>,
    undone: RefCell<Vec<Undone>>,
    most: usize,
    unplugged: Arc<AtomicBool>,
}

impl Desk for Watcher {
    fn wants(&self) -> (Scope, Parts) {
        (Scope::default(), Parts::ALL)
    }

    fn end_forcing(&self) -> Option<u8> {
        self.ends
    }

    fn orders(&self) -> &Orders {
        &self.ordered
    }

    fn hear(&self, event: Event<'_>) {
        let heard = match event {
            Event::Seen(reading) => {
                let mut readings = self.readings.borrow_mut();
                readings.push(reading.clone());
                let is_over = readings.len() >= self.most;
                self.unplugged.store(is_over, Ordering::Relaxed);
                let wanted = self.wanted.borrow_mut().pop();
                return self.ordered.borrow_mut().extend(wanted);
            }
            Event::Undone(undone) => {
                self.undone.borrow_mut().push(undone.clone());
                "undone".to_owned()
            }
            Event::Stopped { before, .. } => format!("stopped from {:?}", before.state.unwrap()),
            Event::Done(done) => format!("{done:?}"),
            Event::Flashing(progress) => format!("{:?}", progress.stage),
            Event::Found(_) => "found".to_owned(),
            Event::Lost(_) => "lost".to_owned(),
            Event::Stored(_) => "stored".to_owned(),
            Event::Fetched(_) => "fetched".to_owned(),
            Event::Settings(_) => "settings".to_owned(),
            Event::Released(_) => "released".to_owned(),
            Event::Sent(_) => return,
        };
        let mut all = self.heard.borrow_mut();
        if all.last() != Some(&heard) {
            all.push(heard);
        }
    }
}

fn watcher(readings: usize, ends: Option<u8>, wanted: &[Order]) -> Watcher {
    Watcher {
        wanted: RefCell::new(wanted.iter().rev().cloned().collect()),
        ordered: Orders::default(),
        ends,
        readings: RefCell::default(),
        heard: RefCell::default(),
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

/// Watches a board for so many readings, with an order after each of the first.
fn watched(
    board: Board,
    readings: usize,
    ends: Option<u8>,
    orders: &[Order],
) -> (Wire, Watcher, Failure) {
    let watcher = watcher(readings, ends, orders);
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
    let orders = [
        Order::Force(Side::Inputs, 0, Some(true)),
        Order::Command(Command::Stop),
    ];
    let (_, watcher, _) = watched(Board::default(), 3, None, &orders);
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
    let stop = Order::Command(Command::Stop);
    let watcher = watcher(1, None, &[stop]);
    let mut wire = wire(Board::default(), &watcher);
    wire.talk(async |client: &mut Client| talk(client, &watcher, false).await);
    assert_eq!(watcher.readings.borrow().len(), 1);
    assert_eq!(wire.board.state, RUN);
    let undone = watcher.undone.borrow();
    assert!(
        matches!(&undone[..], [Undone::Lost(_) | Undone::Away(Away::Gone(_))]),
        "{undone:?}"
    );
}

#[test]
fn what_is_ordered_of_a_board_that_is_not_found_is_not_done() {
    let watcher = watcher(usize::MAX, None, &[]);
    let stop = Order::Command(Command::Stop);
    watcher.ordered.borrow_mut().push_back(stop);
    let mut sought = 0;
    // It would answer all but who it is.
    let mut wire = Wire::with(Board::default(), move |_, request| {
        sought += u32::from(request[1] == 43);
        match request[1] == 43 {
            true if sought > 99 => Fate::Unplugged,
            true => Fate::Lost,
            false => Fate::Answered,
        }
    });
    wire.talk(async |client: &mut Client| talk(client, &watcher, false).await);
    assert_eq!(wire.board.state, RUN);
    let undone = watcher.undone.take();
    assert!(
        matches!(undone[..], [Undone::Away(Away::NotFound(_))]),
        "{undone:?}"
    );
}

#[test]
fn a_board_that_refuses_an_upload_is_watched_on() {
    let text = crate::upload::FOLLOW;
    let upload = crate::upload::program(text, |of| Upload::of(of, text.as_bytes()));
    let mut board = Board::default();
    board.settings[4] = lock::COMMANDS.into();
    let (_, watcher, failure) = watched(board, 3, None, &[Order::Upload(Box::new(upload))]);
    let undone = watcher.undone.take();
    assert!(
        matches!(undone[..], [Undone::NotStopped(Failure::Refused(_))]),
        "{undone:?}"
    );
    assert_eq!(watcher.readings.borrow().len(), 3);
    assert_eq!(failure, Failure::Lost("unplugged".to_owned()));
}

#[test]
fn what_is_forced_ends_where_nobody_asks() {
    let forced = |to| Order::Force(Side::Inputs, 0, to);
    let ends = |end_forcing, order| {
        let (wire, watcher, _) = watched(Board::default(), 3, end_forcing, &[order]);
        let ends = watcher.readings.borrow().last().unwrap().forcing_ends;
        assert_eq!(ends, Some(wire.board.forces[4] as u8));
        (wire.board.forces[0], ends.unwrap())
    };
    assert_eq!(ends(Some(10), forced(Some(true))), (1, 10));
    assert_eq!(ends(None, forced(Some(true))), (1, 0));
    // What is let go needs no end.
    assert_eq!(ends(Some(10), forced(None)), (0, 0));
    assert_eq!(ends(Some(10), Order::Release), (0, 0));
}

#[test]
fn no_point_is_forced_before_its_end_is_set() {
    let force = Order::Force(Side::Outputs, 1, Some(true));
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
    let force = Order::Force(Side::Inputs, 0, Some(true));
    let (wire, watcher, _) = watched(old, 2, Some(10), &[force]);
    let last = watcher.readings.borrow().last().unwrap().forced();
    assert_eq!((last.ends, last.inputs.get(0)), (None, Some(true)));
    assert_eq!(wire.board.forces, [1, 1, 0, 0, 0]);
}

#[test]
fn a_wish_that_is_refused_is_told_with_how_the_board_stands() {
    let run = Order::Command(Command::Run);
    let switched = Board {
        switch: true,
        ..Board::in_state(STOP)
    };
    let (_, watcher, _) = watched(switched, 2, None, &[run]);
    assert_eq!(watcher.undone.take(), [Undone::Refused(Refusal::Switch)]);
}

#[test]
fn a_point_that_no_client_may_write_is_not_asked_for() {
    let input = Address::Input(1);
    let (_, watcher, _) = watched(Board::default(), 2, None, &[Order::Set(input, 1)]);
    assert_eq!(watcher.undone.take(), [Undone::NoPoint(input)]);
}

#[test]
fn all_that_happens_to_a_board_is_heard_in_its_order() {
    let program = crate::upload::FOLLOW;
    let upload = crate::upload::program(program, |of| Upload::of(of, program.as_bytes()));
    let orders = [Order::Settings, Order::Upload(Box::new(upload))];
    let watcher = watcher(3, None, &orders);
    let mut wire = wire(Board::default(), &watcher);
    wire.talk(async |client: &mut Client| talk(client, &watcher, false).await);
    let heard = [
        "found",
        "settings",
        "Plainly",
        "stopped from Run",
        "stored",
        "Uploaded(Run)",
        "lost",
    ];
    assert_eq!(watcher.heard.take()[..heard.len()], heard);
}

#[test]
fn a_firmware_is_written_without_a_board_that_answers() {
    const HEX: &[u8] = include_bytes!("../../../boot/tests/stall.hex");
    let image = Image::read(HEX, Model::Nano).unwrap();
    let watcher = watcher(1, None, &[]);
    watcher
        .ordered
        .borrow_mut()
        .push_back(Order::Flash(Box::new(image)));
    let desk = &watcher;
    let talk = async move |client: &mut Client| talk(client, desk, true).await;
    let line = Line {
        rate: 9_600,
        ..Line::default()
    };
    let mut conversation = Conversation::new(line, PATIENCE, talk);
    let (mut now, mut resets) = (Duration::ZERO, 0);
    // No boot loader answers either.
    while watcher.undone.borrow().is_empty() {
        let step = conversation.step(now, &[]);
        let format = match step.send.is_empty() && !step.reset {
            true => step.format,
            false => Format {
                rate: Model::Nano.rate(),
                parity: Parity::None,
            },
        };
        assert_eq!(step.format, format);
        resets += u32::from(step.reset);
        let Next::Wait(until) = step.next else {
            panic!()
        };
        now = until;
    }
    let undone = watcher.undone.take();
    assert!(matches!(undone[..], [Undone::NotFlashed(_)]), "{undone:?}");
    assert!(resets > 1);
    // It is sought again as it is spoken to usually.
    assert_eq!(conversation.step(now, &[]).format, line.format());
}
