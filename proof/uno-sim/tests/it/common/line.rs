//! A conversation with the simulated board, over its serial port: the board's clock is the clock of both.

use std::time::Duration;
use unoclp_boot::{self as boot, Image, Writer};
use unoclp_client::start::find;
use unoclp_client::{Client, Conversation, Line, Next, Patience};
use unoclp_uno_sim::{CYCLES_PER_MS, Uno};

/// How often it is looked whether the board has said something, cycles.
const LOOK: u64 = CYCLES_PER_MS / 10;

/// The time on the board.
fn now(uno: &Uno) -> Duration {
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

/// Which way a byte goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    ToBoard,
    FromBoard,
}

/// What comes of a byte on its way, and how much later; none: nothing.
type Fate<'a> = &'a mut dyn FnMut(Way, u8) -> Option<(u8, Duration)>;

/// Writes an image through the board's boot loader, on a line with this fate; the reset button is pressed where the
/// writer asks for a reset.
pub fn write(uno: &mut Uno, image: &Image, fate: Fate<'_>) -> Result<(), boot::Failure> {
    let mut writer = Writer::new(image);
    uno.take_serial();
    let mut came = Vec::new();
    // What is on its way, and when it comes.
    let mut coming: Vec<(Duration, u8)> = Vec::new();
    loop {
        let step = writer.step(now(uno), &came);
        came.clear();
        if step.reset {
            uno.reset();
            uno.take_serial();
            coming.clear();
        }
        for byte in step.send {
            if let Some((byte, late)) = fate(Way::ToBoard, byte) {
                let cycles = late.as_millis() as u64 * CYCLES_PER_MS;
                uno.send_serial_at(uno.cycles() + cycles, &[byte]);
            }
        }
        let until = match step.next {
            boot::Next::Done(outcome) => return outcome,
            boot::Next::Wait(until) => until,
        };
        while came.is_empty() && now(uno) < until {
            uno.run_cycles(LOOK).unwrap();
            for sent in uno.take_serial_log() {
                let fate = fate(Way::FromBoard, sent.byte);
                coming.extend(fate.map(|(byte, late)| (now(uno) + late, byte)));
            }
            while coming.first().is_some_and(|&(at, _)| at <= now(uno)) {
                came.push(coming.remove(0).1);
            }
        }
    }
}

/// Finds the board that has just been powered.
pub fn meet(uno: &mut Uno) {
    let identity = talk(uno, async |client| find(client, true).await).unwrap();
    assert_eq!(identity.product, format!("unoclp {}", crate::BOARD.name));
}
