//! Finding a board.

use crate::fake::{Board, Fate};
use crate::line::{MS, PATIENCE, Wire};
use std::time::Duration;
use unoclp_client::identity::Identity;
use unoclp_client::start::{NotFound, find};
use unoclp_client::{Failure, Patience};

const TEXT: &[u8] = b"\r\nunoclp 0.1.0\r\n3 bytes\r\nRUN\r\n";

fn search(wire: &mut Wire, may_be_reset: bool) -> Result<Identity, NotFound> {
    wire.talk(async |client| find(client, may_be_reset).await)
}

#[test]
fn a_board_says_what_it_is() {
    let identity = search(&mut Wire::new(Board::default()), false).unwrap();
    assert_eq!(identity.to_string(), "unoclp UNO 0.1.0");
    assert_eq!(identity.vendor, "unoclp");
}

#[test]
fn a_board_that_was_reset_is_not_disturbed_until_it_has_said_its_text() {
    let mut wire = Wire::new(Board::default());
    let begun = wire.now;
    for (n, part) in TEXT.chunks(5).enumerate() {
        wire.say(2 * Duration::from_secs(1) + 10 * n as u32 * MS, part);
    }
    search(&mut wire, true).unwrap();
    let asked = wire.sent[0].0 - begun;
    // Its last part comes then.
    assert_eq!(asked, 2050 * MS + 2 * MS);
}

#[test]
fn a_board_without_a_text_is_asked_after_a_while() {
    let mut wire = Wire::new(Board::default());
    let begun = wire.now;
    search(&mut wire, true).unwrap();
    assert_eq!(wire.sent[0].0 - begun, 2502 * MS);
}

#[test]
fn a_board_that_starts_is_asked_until_it_answers() {
    let mut requests = 0;
    let mut wire = Wire::with(Board::default(), move |_, _| {
        requests += 1;
        // As long as that it is still starting.
        if requests < 8 {
            Fate::Lost
        } else {
            Fate::Answered
        }
    });
    wire.say(MS, TEXT);
    search(&mut wire, true).unwrap();
    assert_eq!(wire.sent.len(), 8);

    let mut nobody = Wire::with(Board::default(), |_, _| Fate::Lost);
    let begun = nobody.now;
    assert_eq!(search(&mut nobody, true), Err(NotFound::Silent));
    let waited = nobody.now - begun;
    assert!((PATIENCE.start..PATIENCE.start + Duration::from_secs(1)).contains(&waited));
}

#[test]
fn what_is_no_board_is_told_apart() {
    let found = |fate| search(&mut Wire::with(Board::default(), move |_, _| fate), false);
    assert_eq!(found(Fate::Lost), Err(NotFound::Silent));
    assert_eq!(found(Fate::Garbled), Err(NotFound::Garbled));
    assert_eq!(found(Fate::Mistaken), Err(NotFound::Garbled));
    let lost = Failure::Lost("unplugged".to_owned());
    assert_eq!(found(Fate::Unplugged), Err(NotFound::Failed(lost)));

    let foreign = |board| search(&mut Wire::new(board), false);
    let meter = foreign(Board {
        identity: ["ACME", "Meter", "3"],
        ..Board::default()
    });
    let Err(NotFound::Foreign(Some(identity))) = meter else {
        panic!("{meter:?}");
    };
    assert_eq!((&*identity.vendor, &*identity.product), ("ACME", "Meter"));
    let other = foreign(Board {
        identifies: false,
        ..Board::default()
    });
    assert_eq!(other, Err(NotFound::Foreign(None)));
}

#[test]
fn patience_for_a_start_bounds_the_wait_for_its_text() {
    let patience = Patience {
        start: 20 * MS,
        attempts: 1,
        ..PATIENCE
    };
    let mut wire = Wire::new(Board::default());
    let begun = wire.now;
    let found = wire.talk_with(patience, async |client| find(client, true).await);
    assert!(found.is_ok());
    assert_eq!(wire.sent[0].0 - begun, 22 * MS);
}

/// A request that comes while the Mega's boot loader waits for its own language keeps it waiting.
#[test]
fn a_mega_that_does_not_answer_is_left_alone_until_its_boot_loader_gives_up() {
    for (product, pause) in [("unoclp Mega", 6000), ("unoclp UNO", 150)] {
        let mut requests = 0;
        let identity = ["unoclp", product, "0.2.0"];
        let board = Board {
            identity,
            ..Board::default()
        };
        let mut wire = Wire::with(board, move |_, _| {
            requests += 1;
            match requests {
                2..5 => Fate::Lost,
                _ => Fate::Answered,
            }
        });
        let found = wire.talk(async |client| {
            client.identify().await.unwrap();
            assert_eq!(client.identify().await, Err(Failure::Silent));
            client.identify().await
        });
        assert!(found.is_ok(), "{product}");
        let [.., last, next] = &wire.sent[..] else {
            panic!("{product}: {} requests", wire.sent.len());
        };
        let waited = next.0 - last.0;
        let wanted = Duration::from_millis(pause);
        assert!(
            (wanted..wanted + 100 * MS).contains(&waited),
            "{product}: {waited:?}"
        );
    }
}
