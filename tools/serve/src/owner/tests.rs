//! Whom the owner of a line asks, and when.

use super::*;
use crate::line::Line;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use unoclp_modbus::Table;

/// Counts what it is asked, and answers with the count.
struct Counter(u8);

impl Board for Counter {
    fn find(&mut self, _: u8) -> Result<(), String> {
        Ok(())
    }

    fn ask(&mut self, _: &Request) -> Result<Vec<u8>, NoAnswer> {
        self.0 += 1;
        Ok(vec![self.0])
    }
}

#[test]
fn what_many_ask_at_once_the_board_is_asked_once() {
    let (_, queue) = mpsc::channel();
    let mut owner = Owner::new(Counter(0), queue);
    let begin = Instant::now();
    let coils = Request::read(1, Table::Coils, 0, 4);
    let inputs = Request::read(1, Table::DiscreteInputs, 0, 4);
    let stop = Request::write_word(1, 400, 2);
    for (request, after, expected) in [
        (&coils, 0, 1),
        (&coils, 49, 1),
        (&inputs, 49, 2),
        (&coils, 50, 3),
        (&inputs, 60, 2),
        (&stop, 61, 4),
        (&stop, 62, 5),
        (&coils, 63, 6),
        (&inputs, 64, 7),
    ] {
        let now = begin + Duration::from_millis(after);
        assert_eq!(
            owner.answer(request, now),
            Ok(vec![expected]),
            "after {after} ms"
        );
    }
}

/// Says when it is asked something, and answers when it is let.
struct Gate {
    asked: mpsc::Sender<Vec<u8>>,
    let_go: mpsc::Receiver<()>,
}

impl Board for Gate {
    fn find(&mut self, _: u8) -> Result<(), String> {
        Ok(())
    }

    fn ask(&mut self, request: &Request) -> Result<Vec<u8>, NoAnswer> {
        // After the end of the test nobody is left.
        let _ = self.asked.send(request.bytes().to_vec());
        let _ = self.let_go.recv();
        Ok(Vec::new())
    }
}

#[tokio::test]
async fn at_most_one_reading_goes_before_a_write_whoever_watches() {
    let (asked, asks) = mpsc::channel();
    let (let_go, gate) = mpsc::channel();
    let board = Gate {
        asked,
        let_go: gate,
    };
    let line = Line::begin(board, 1);
    let visit = async |request: Request, role: Role| {
        let line = line.clone();
        tokio::spawn(async move { line.ask(request, role).await });
        // It is in the queue before the next one.
        tokio::task::yield_now().await;
    };
    let watched: Vec<Request> = (0..60)
        .map(|first| Request::read(1, Table::HoldingRegisters, first, 2))
        .collect();
    for request in &watched {
        visit(request.clone(), Role::Watch).await;
    }
    // The board is asked the first one when the others come.
    assert_eq!(asks.recv().unwrap(), watched[0].bytes());
    let own = Request::read(1, Table::Coils, 0, 4);
    let write = Request::write_coil(1, 0, true);
    let stop = Request::write_word(1, 400, 2);
    for request in [&own, &write, &stop] {
        visit(request.clone(), Role::Control).await;
    }
    for expected in [&stop, &write, &own].into_iter().chain(&watched[1..]) {
        let_go.send(()).unwrap();
        assert_eq!(asks.recv().unwrap(), expected.bytes());
    }
}

/// A line of two boards, of which the second answers as it is told.
struct Two(Arc<AtomicBool>);

impl Board for Two {
    fn find(&mut self, address: u8) -> Result<(), String> {
        match address == 1 || self.0.load(Ordering::Relaxed) {
            true => Ok(()),
            false => Err("silent".into()),
        }
    }

    fn ask(&mut self, request: &Request) -> Result<Vec<u8>, NoAnswer> {
        match request.server() {
            1 => Ok(vec![1]),
            _ => Err(NoAnswer::Silent),
        }
    }
}

#[tokio::test]
async fn a_board_that_stays_silent_is_away_and_the_others_of_its_line_are_not() {
    let answers = Arc::new(AtomicBool::new(true));
    let lines = Line::begin_shared(Two(answers.clone()), &[1, 2]);
    let mut presence: Vec<_> = lines.iter().map(Line::presence).collect();
    for presence in &mut presence {
        presence.wait_for(Result::is_ok).await.unwrap();
    }
    answers.store(false, Ordering::Relaxed);
    let ask = |at: usize| {
        let request = Request::read(at as u8 + 1, Table::Coils, 0, 4);
        lines[at].ask(request, Role::Watch)
    };
    for _ in 0..SILENT {
        assert_eq!(ask(1).await[2], Exception::GatewayTargetSilent as u8);
        assert_eq!(ask(0).await, [1]);
    }
    let gone = presence[1].wait_for(Result::is_err).await.unwrap().clone();
    assert_eq!(gone, Err("silent".into()));
    assert_eq!(ask(0).await, [1]);
    assert_eq!(*presence[0].borrow(), Ok(()));
    // It is looked for, and found again.
    answers.store(true, Ordering::Relaxed);
    presence[1].wait_for(Result::is_ok).await.unwrap();
}

#[tokio::test]
async fn a_board_alone_on_its_line_that_stays_silent_is_away_too() {
    let answers = Arc::new(AtomicBool::new(true));
    let lines = Line::begin_shared(Two(answers.clone()), &[2]);
    let mut presence = lines[0].presence();
    presence.wait_for(Result::is_ok).await.unwrap();
    answers.store(false, Ordering::Relaxed);
    for _ in 0..SILENT {
        let request = Request::read(2, Table::Coils, 0, 4);
        let answer = lines[0].ask(request, Role::Watch).await;
        assert_eq!(answer[2], Exception::GatewayTargetSilent as u8);
    }
    presence.wait_for(Result::is_err).await.unwrap();
    answers.store(true, Ordering::Relaxed);
    presence.wait_for(Result::is_ok).await.unwrap();
}

#[test]
fn the_longer_a_board_is_away_the_less_the_others_wait_for_it() {
    let (_jobs, queue) = mpsc::sync_channel(1);
    let mut owner = Owner::new(Two(Arc::default()), queue);
    let _presence = [1, 2].map(|address| owner.seat(address));
    let long_after = |owner: &mut Owner<Two>| owner.look(Instant::now() + 2 * RARELY);
    long_after(&mut owner);
    let pauses: Vec<u64> = (0..7)
        .map(|_| {
            long_after(&mut owner);
            owner.seats[1].pause.as_secs()
        })
        .collect();
    assert_eq!(pauses, [2, 4, 8, 16, 32, 32, 32]);
}
