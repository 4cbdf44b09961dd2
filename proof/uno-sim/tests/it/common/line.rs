//! A conversation with the simulated board, over its serial port: the board's clock is the clock of both.

use std::time::Duration;
use unoclp_client::start::find;
use unoclp_client::{Client, Conversation, Line, Next, Patience};
use unoclp_uno_sim::{CYCLES_PER_MS, Uno};

/// How often it is looked whether the board has said something, cycles.
pub const LOOK: u64 = CYCLES_PER_MS / 10;

/// The time on the board.
pub fn now(uno: &Uno) -> Duration {
    Duration::from_nanos(uno.cycles() * 1_000_000 / CYCLES_PER_MS)
}

/// Has a conversation with the board as it is by default.
pub fn talk<T>(uno: &mut Uno, talk: impl AsyncFnOnce(&mut Client) -> T) -> T {
    talk_at(uno, Line::default(), talk)
}

/// Has a conversation on this line.
pub fn talk_at<T>(uno: &mut Uno, line: Line, talk: impl AsyncFnOnce(&mut Client) -> T) -> T {
    let mut conversation = Conversation::new(line, Patience::default(), talk);
    let mut came = Vec::new();
    loop {
        let step = conversation.step(now(uno), &came);
        came.clear();
        if !step.send.is_empty() {
            uno.send_serial(&step.send);
        }
        let until = match step.next {
            Next::Done(outcome) => return outcome,
            Next::Wait(until) => until,
        };
        while came.is_empty() && now(uno) < until {
            uno.run_cycles(LOOK).unwrap();
            came.extend(uno.take_serial_log().iter().map(|sent| sent.byte));
        }
    }
}

/// Finds the board that has just been powered.
pub fn meet(uno: &mut Uno) {
    let identity = talk(uno, async |client| find(client, true).await).unwrap();
    assert_eq!(identity.product, format!("unoclp {}", crate::BOARD.name));
}
