//! A request on the line: silence, garbage, what comes late, and when it is sent again.

use crate::fake::{Board, Fate, RUN};
use crate::line::{MS, PATIENCE, Wire};
use std::cell::Cell;
use std::rc::Rc;
use std::time::Duration;
use unoclp_client::map::{Command, holding, input};
use unoclp_client::watch::{Forced, command};
use unoclp_client::{Client, Conversation, Failure, Line, Next, Patience, Step};
use unoclp_modbus::Crc;

/// The state, as any request.
async fn state(client: &mut Client) -> Result<u16, Failure> {
    let span = input::STATE;
    let words = client.words(span.table, span.first, 1).await?;
    Ok(words[0])
}

/// The answer to it: RUN.
fn reply() -> Vec<u8> {
    let mut reply = vec![1, 4, 2, 0, RUN as u8];
    reply.extend(Crc::of(&reply).to_bytes());
    reply
}

/// The longest request and the longest answer at 115200 baud.
const TRANSIT: Duration = Duration::from_nanos(95_486 * 512);

#[test]
fn a_board_that_is_silent_is_asked_as_often_as_patience_says() {
    let mut wire = Wire::with(Board::default(), |_, _| Fate::Lost);
    let begun = wire.now;
    assert_eq!(wire.talk(state), Err(Failure::Silent));
    let times: Vec<_> = wire.sent.iter().map(|(at, _)| *at - begun).collect();
    let each = 2 * MS + PATIENCE.answer + TRANSIT;
    assert_eq!(times, [0, 1, 2].map(|n| n * each + 2 * MS));
    assert_eq!(wire.now - begun, 3 * each);
}

#[test]
fn an_answer_may_come_byte_by_byte() {
    let mut wire = Wire::new(Board::default());
    wire.byte = MS;
    assert_eq!(wire.talk(state), Ok(RUN));
    assert_eq!(wire.sent.len(), 1);
}

#[test]
fn an_answer_counts_until_patience_ends() {
    for (late, asked) in [(0, 1), (1, 2)] {
        let mut first = true;
        let mut wire = Wire::with(Board::default(), move |_, _| {
            match std::mem::take(&mut first) {
                true => Fate::AnswerLost,
                false => Fate::Answered,
            }
        });
        // What the first request is answered, by hand.
        let reply = reply();
        let wait = 2 * MS + PATIENCE.answer + TRANSIT;
        wire.say(wait + late * MS, &reply);
        assert_eq!(wire.talk(state), Ok(RUN), "{late}");
        // An answer that comes late, while nothing is said, is not the answer to the next request.
        assert_eq!(wire.sent.len(), asked, "{late}");
    }
}

#[test]
fn an_answer_that_is_lost_or_garbled_is_asked_for_again() {
    let mut requests = 0;
    let mut wire = Wire::with(Board::default(), move |_, _| {
        requests += 1;
        // No request fails twice in a row.
        match requests % 6 {
            1 => Fate::Garbled,
            3 => Fate::Mistaken,
            5 => Fate::AnswerLost,
            _ => Fate::Answered,
        }
    });
    for _ in 0..20 {
        assert_eq!(wire.talk(state), Ok(RUN));
    }
}

#[test]
fn what_comes_back_tells_silence_from_garbage() {
    let mut requests = 0;
    let mut wire = Wire::with(Board::default(), move |_, _| {
        requests += 1;
        match requests % 2 {
            1 => Fate::Lost,
            _ => Fate::AnswerLost,
        }
    });
    assert_eq!(wire.talk(state), Err(Failure::Silent));
    // One answer that is none in three attempts is enough to know that somebody is there.
    for garbled in 1..=3 {
        let mut requests = 0;
        let mut wire = Wire::with(Board::default(), move |_, _| {
            requests += 1;
            if requests == garbled {
                Fate::Garbled
            } else {
                Fate::Lost
            }
        });
        assert_eq!(wire.talk(state), Err(Failure::Garbled), "{garbled}");
        assert_eq!(wire.sent.len(), 3);
    }
}

#[test]
fn garbage_is_over_before_the_next_attempt() {
    let mut first = true;
    let mut wire = Wire::with(Board::default(), move |_, _| {
        match std::mem::take(&mut first) {
            true => Fate::Garbled,
            false => Fate::Answered,
        }
    });
    let begun = wire.now;
    // It goes on for a while after the answer: 50 bytes, 10 ms from one to the next.
    for n in 1..=50 {
        wire.say(10 * n * MS, &[0x55]);
    }
    assert_eq!(wire.talk(state), Ok(RUN));
    let second = wire.sent[1].0 - begun;
    assert!(second > 500 * MS, "{second:?}");
}

#[test]
fn what_was_on_the_line_before_is_no_answer() {
    for text in [&b"\r\nunoclp 0.1.0\r\nRUN\r\n"[..], b"\x01", b"\x01\x2b"] {
        let mut wire = Wire::new(Board::default());
        wire.say(Duration::ZERO, text);
        wire.say(MS, text);
        let identity = wire.talk(async |client| client.identify().await);
        assert_eq!(identity.unwrap().vendor, "unoclp");
        assert_eq!(wire.sent.len(), 1);
    }
}

#[test]
fn a_port_that_goes_ends_what_is_said() {
    let mut wire = Wire::with(Board::default(), |_, _| Fate::Unplugged);
    let lost = Failure::Lost("unplugged".to_owned());
    assert_eq!(wire.talk(state), Err(lost));
    assert_eq!(wire.sent.len(), 1, "nobody asks again");
}

#[test]
fn a_step_too_many_does_no_harm() {
    let mut conversation = Conversation::new(Line::default(), PATIENCE, state);
    let at = |ms: u32| ms * MS;
    let Step { send, next, .. } = conversation.step(at(0), &[]);
    assert_eq!((send, next), (Vec::new(), Next::Wait(at(2))));
    let Step { send, next, .. } = conversation.step(at(1), &[]);
    assert_eq!((send, next), (Vec::new(), Next::Wait(at(2))));
    let sent = conversation.step(at(2), &[]);
    assert_eq!(sent.send.len(), 8);
    let until = at(2) + TRANSIT + PATIENCE.answer;
    let reply = reply();
    let (last, begin) = reply.split_last().unwrap();
    for (ms, came) in [
        (3, &begin[..2]),
        (3, &[]),
        (4, &begin[2..4]),
        (9, &begin[4..]),
    ] {
        let Step { send, next, .. } = conversation.step(at(ms), came);
        assert_eq!((send, next), (Vec::new(), Next::Wait(until)));
    }
    let done = conversation.step(at(10), &[*last]);
    assert_eq!(done.next, Next::Done(Ok(RUN)));
    let behind = conversation.step(at(11), &[1, 2, 3]);
    let nothing = Step {
        format: Line::default().format(),
        reset: false,
        send: Vec::new(),
        next: Next::Wait(Duration::MAX),
    };
    assert_eq!(behind, nothing);
}

#[test]
fn a_conversation_that_is_dropped_is_over() {
    let alive = Rc::new(Cell::new(true));
    struct Guard(Rc<Cell<bool>>);
    impl Drop for Guard {
        fn drop(&mut self) {
            self.0.set(false);
        }
    }
    let guard = Guard(alive.clone());
    let mut conversation = Conversation::new(Line::default(), PATIENCE, async move |client| {
        let _guard = guard;
        state(client).await
    });
    conversation.step(Duration::ZERO, &[]);
    assert!(alive.get());
    drop(conversation);
    assert!(!alive.get());
}

#[test]
fn a_slow_line_is_given_its_time() {
    let line = Line {
        rate: 2400,
        ..Line::default()
    };
    let mut conversation = Conversation::new(line, Patience::default(), state);
    let character = Duration::from_secs(11) / 2400;
    assert_eq!(
        conversation.step(Duration::ZERO, &[]).next,
        Next::Wait(4 * character)
    );
    let sent = conversation.step(4 * character, &[]);
    let until = 4 * character + 512 * character + Duration::from_secs(1);
    assert_eq!(sent.next, Next::Wait(until));
}

/// A Mega that has said what it is.
fn mega() -> Wire {
    let mut wire = Wire::new(Board {
        identity: ["unoclp", "unoclp Mega", "0.3.0"],
        ..Board::default()
    });
    wire.talk(async |client| client.identify().await).unwrap();
    wire
}

async fn restart(client: &mut Client) {
    command(client, Command::Restart).await.unwrap();
}

/// Its boot loader would take a request for its own language, in this conversation and in the next one.
#[test]
fn a_mega_that_begins_again_is_left_alone_for_a_while() {
    let mut wire = mega();
    wire.talk(restart);
    let begun = wire.now;
    assert_eq!(wire.talk(state), Ok(RUN));
    let (asked, _) = wire.sent.last().unwrap();
    assert!(
        *asked - begun >= Duration::from_secs(6),
        "{:?}",
        *asked - begun
    );
}

#[test]
fn a_mega_that_begins_again_says_all_of_its_text_before_it_is_asked() {
    let mut wire = mega();
    wire.talk(restart);
    let begun = wire.now;
    let text = b"\r\nunoclp 0.3.0\r\n3 bytes\r\nRUN\r\n";
    // Its first part comes just before the boot loader has given up.
    for (n, part) in (0..).zip(text.chunks(5)) {
        wire.say(5_950 * MS + 20 * MS * n, part);
    }
    assert_eq!(wire.talk(state), Ok(RUN));
    let (asked, _) = wire.sent.last().unwrap();
    assert!(*asked - begun > 6_050 * MS, "{:?}", *asked - begun);
}

#[test]
fn what_is_forced_of_a_mega_is_read_with_the_inputs_that_a_uno_lacks() {
    let mut wire = mega();
    // The board in memory has none: it refuses.
    let _ = wire.talk(Forced::read);
    let asked = wire.sent.iter().map(|(_, sent)| (sent[1], sent[5]));
    let all = holding::MORE_TO.first + 1 - holding::FORCED_INPUTS.first;
    assert!(asked.collect::<Vec<_>>().contains(&(3, all as u8)));
}
