//! Uploading to a board, over a pseudo-terminal.

use crate::fake::{Board, FAULT, Fake, Fate, PATIENT, RUN, STOP};
use unoclp_board::client::Client;
use unoclp_board::diagnostics::Kept;
use unoclp_board::map::{BLOCK_BYTES, State};
use unoclp_board::start::find;
use unoclp_board::upload::{Behind, Broken, Pass, Progress, go_on, stop, upload};

const FOLLOW: &str = "0\n787600\n827301\n847978\n3\n7901\n";

fn client(fake: &Fake) -> Client {
    find(&fake.line(), PATIENT).unwrap().client
}

/// A program of several blocks.
fn long() -> String {
    format!("{}/{}\n", FOLLOW, "comment ".repeat(200))
}

/// Uploads without a look at the progress.
fn send(client: &mut Client, text: &str) -> Result<(), Broken> {
    let kept = Kept::of(text.as_bytes()).unwrap_or_default();
    upload(client, text.as_bytes(), kept, &mut |_| ())
}

fn is_block(request: &[u8]) -> bool {
    request.starts_with(&[1, 16, 1000_u16.to_be_bytes()[0], 1000_u16.to_be_bytes()[1]])
}

#[test]
fn a_program_is_sent_twice_and_stored() {
    for text in [FOLLOW.to_owned(), long(), "0\n877901\n/".to_owned()] {
        let fake = Fake::new(Board::default());
        let mut client = client(&fake);
        let before = stop(&mut client).unwrap();
        assert_eq!((before.state, fake.board().state), (Some(State::Run), STOP));
        let kept = Kept::of(text.as_bytes()).unwrap();
        let mut shown = Vec::new();
        upload(&mut client, text.as_bytes(), kept, &mut |step| {
            shown.push(step)
        })
        .unwrap();
        assert_eq!(fake.board().text, text.as_bytes());
        assert_eq!(fake.board().kept, kept);
        for pass in [Pass::Check, Pass::Store] {
            let (bytes, of) = (text.len(), text.len());
            assert!(shown.contains(&Progress::Sent { pass, bytes, of }));
        }
        assert!(shown.contains(&Progress::Storing));
        let behind = go_on(&mut client, State::Run, kept, false).unwrap();
        assert_eq!((behind, fake.board().state), (Behind::Run, RUN));
    }
}

#[test]
fn block_numbers_go_round() {
    let text = format!("{FOLLOW}/{}\n", "x".repeat(140 * BLOCK_BYTES));
    let fake = Fake::new(Board::in_state(STOP));
    send(&mut client(&fake), &text).unwrap();
    assert_eq!(fake.board().text.len(), text.len());
}

#[test]
fn a_block_whose_answer_is_lost_is_sent_again_and_taken_once() {
    let text = long();
    let mut blocks = 0;
    let fake = Fake::with(Board::in_state(STOP), move |_, request| {
        blocks += u32::from(is_block(request));
        match (is_block(request), blocks % 4) {
            (true, 2) => Fate::Garbled,
            _ => Fate::Answered,
        }
    });
    send(&mut client(&fake), &text).unwrap();
    assert_eq!(fake.board().text, text.as_bytes());
}

#[test]
fn an_end_that_was_stored_and_whose_answer_is_lost_is_an_upload() {
    let fake = Fake::with(Board::in_state(STOP), |board, request| {
        let end = is_block(request) && request[8] == 0;
        // The second one: the board stores, and will refuse the repetition.
        if end && request[7] == 3 && board.is_uploading() {
            Fate::Garbled
        } else {
            Fate::Answered
        }
    });
    send(&mut client(&fake), FOLLOW).unwrap();
    assert_eq!(fake.board().text, FOLLOW.as_bytes());
}

#[test]
fn the_board_tells_a_fault_with_its_line() {
    // As by a board of another version: its loader knows less than this one.
    let fault = |text: &str, board: Board| {
        let fake = Fake::new(board);
        let kept = fake.board().kept;
        let error = send(&mut client(&fake), text).unwrap_err();
        assert_eq!(fake.board().kept, kept, "it keeps what it had");
        error.to_string()
    };
    let stop = || Board::in_state(STOP);
    assert_eq!(
        fault("0\n787600\n123\n", stop()),
        "fault 24, line 3: no such code"
    );
    let late = format!("{}40\n", long());
    let line = late.lines().count();
    assert_eq!(
        fault(&late, stop()),
        format!("fault 32, line {line}: this 40 is not closed by 41 in its rung (NC-8)")
    );
    assert_eq!(fault("", stop()), "fault 21: the file holds no code");
    let differs = Board {
        second_differs: true,
        ..stop()
    };
    assert!(fault(FOLLOW, differs).starts_with("fault 57: the card gave another program"));
}

#[test]
fn an_upload_does_not_begin_in_run() {
    let fake = Fake::new(Board::in_state(RUN));
    let error = send(&mut client(&fake), FOLLOW).unwrap_err();
    assert!(matches!(error, Broken::NotBegun), "{error}");
    assert!(!fake.board().is_uploading());
}

#[test]
fn an_upload_that_another_client_ends_says_so() {
    let fake = Fake::with(Board::in_state(STOP), |board, request| {
        if is_block(request) && request[7] == 2 {
            unoclp_modbus::Device::set_word(board, 400, 2);
        }
        Fate::Answered
    });
    let error = send(&mut client(&fake), &long()).unwrap_err();
    assert!(matches!(error, Broken::Ended), "{error}");
}

#[test]
fn an_upload_that_is_broken_off_says_where_and_what_the_board_keeps() {
    for (number, while_, keeps) in [
        (
            2,
            "checking, at byte 488 of ",
            "it keeps the program that it had",
        ),
        (
            9,
            "storing, at byte 244 of ",
            "it keeps the program that it had",
        ),
        (
            15,
            "storing, at byte ",
            "whether it keeps the new program is open",
        ),
    ] {
        let text = long();
        assert_eq!(text.len().div_ceil(BLOCK_BYTES), 7);
        let fake = Fake::with(Board::in_state(STOP), move |_, request| {
            if is_block(request) && request[7] == number {
                Fate::Unplugged
            } else {
                Fate::Answered
            }
        });
        let kept = fake.board().kept;
        let error = send(&mut client(&fake), &text).unwrap_err().to_string();
        let begin = format!("the upload was broken off while {while_}");
        assert!(error.starts_with(&begin), "{error}");
        assert!(error.contains("the port is gone"), "{error}");
        assert!(error.contains(keeps), "{error}");
        assert_eq!(fake.board().kept, kept);
    }
}

#[test]
fn a_board_that_keeps_something_else_is_found_out() {
    let fake = Fake::new(Board::in_state(STOP));
    let kept = Kept { bytes: 1, crc: 2 };
    let text = FOLLOW.as_bytes();
    let error = upload(&mut client(&fake), text, kept, &mut |_| ()).unwrap_err();
    assert!(
        error.to_string().contains("not the 1 bytes with 0002"),
        "{error}"
    );
}

#[test]
fn what_comes_behind_an_upload_depends_on_where_the_board_was() {
    let kept = Kept::of(FOLLOW.as_bytes()).unwrap();
    let uploaded = |board: Board, stays: bool| {
        let fake = Fake::new(board);
        let mut client = client(&fake);
        let before = stop(&mut client).unwrap().state.unwrap();
        send(&mut client, FOLLOW).unwrap();
        let behind = go_on(&mut client, before, kept, stays).unwrap();
        let state = fake.board().state;
        (behind, state)
    };
    assert_eq!(uploaded(Board::in_state(RUN), true), (Behind::Stop, STOP));
    assert_eq!(uploaded(Board::in_state(STOP), false), (Behind::Run, RUN));
    let switched = |state| Board {
        switch: true,
        ..Board::in_state(state)
    };
    assert_eq!(uploaded(switched(STOP), false), (Behind::Switch, STOP));
    assert_eq!(uploaded(Board::in_state(FAULT), false), (Behind::Run, RUN));
    assert_eq!(
        uploaded(Board::in_state(FAULT), true),
        (Behind::Faulty, FAULT)
    );
    assert_eq!(uploaded(switched(FAULT), false), (Behind::Switch, STOP));
    let card = Board {
        card: Some(b"0\n877901\n".to_vec()),
        ..Board::in_state(FAULT)
    };
    assert_eq!(uploaded(card, false), (Behind::Card, RUN));
    let broken = Board {
        fault_at_restart: 64,
        ..Board::in_state(FAULT)
    };
    let (behind, state) = uploaded(broken, false);
    let Behind::Trouble(trouble) = behind else {
        panic!("{behind:?}");
    };
    assert_eq!((trouble.number, trouble.line, state), (64, None, FAULT));
}
