//! Uploading to a board.

use crate::fake::{Board, FAULT, Fate, RUN, STOP, is_block, kept};
use crate::line::{PATIENCE, Wire};
use std::time::Duration;
use unoclp_client::diagnostics::{Kept, Trouble};
use unoclp_client::event::Undone;
use unoclp_client::map::{BLOCK_BYTES, Command, State, flag, holding};
use unoclp_client::upload::{
    Behind, Broken, Codes, FIRST_SCANS, Pass, Progress, Upload, end, go_on, needs, stop, upload,
};
use unoclp_client::watch::command;
use unoclp_client::{Failure, Patience, lock};
use unoclp_core::{Loader, Program};
use unoclp_modbus::eeprom::program::FORM;
use unoclp_modbus::{Exception, Points};

pub const FOLLOW: &str = "0\n787600\n827301\n847978\n3\n7901\n";

/// A program of several blocks.
fn long() -> String {
    format!("{}/{}\n", FOLLOW, "comment ".repeat(200))
}

/// Uploads a text as what it is kept as, without a look at the progress.
fn send_as(wire: &mut Wire, text: &str, sent: Kept) -> Result<Kept, Broken> {
    wire.talk(async |client| upload(client, text.as_bytes(), sent, &mut |_| ()).await)
}

/// Uploads a program.
fn send(wire: &mut Wire, text: &str) -> Result<Kept, Broken> {
    send_as(wire, text, kept(text))
}

/// Lets the board run what it has taken, or not.
fn then(wire: &mut Wire, before: State, kept: Kept, stays: bool) -> Behind {
    wire.talk(async |client| go_on(client, before, kept, stays).await)
        .unwrap()
}

#[test]
fn a_program_is_sent_twice_and_stored() {
    for text in [FOLLOW.to_owned(), long(), "0\n877901\n/".to_owned()] {
        let mut wire = Wire::new(Board::default());
        let before = wire.talk(stop).unwrap();
        assert_eq!((before.state, wire.board.state), (Some(State::Run), STOP));
        let sent = kept(&text);
        let mut shown = Vec::new();
        let mut show = |step| shown.push(step);
        let stored =
            wire.talk(async |client| upload(client, text.as_bytes(), sent, &mut show).await);
        assert_eq!(stored.unwrap(), sent);
        assert_eq!(wire.board.text, text.as_bytes());
        assert_eq!(wire.board.kept, sent);
        for pass in [Pass::Check, Pass::Store] {
            let (bytes, of) = (text.len(), text.len());
            assert!(shown.contains(&Progress::Sent { pass, bytes, of }));
        }
        assert!(shown.contains(&Progress::Storing));
        let behind = then(&mut wire, State::Run, sent, false);
        assert_eq!((behind, wire.board.state), (Behind::Run, RUN));
    }
}

/// A program of this text.
pub fn program<T>(text: &str, see: impl FnOnce(&Program<'_>) -> T) -> T {
    let mut memory = [0; 2_000];
    let mut loader = Loader::new(&mut memory, unoclp_core::Board::UNO);
    text.bytes().for_each(|byte| loader.push(byte).unwrap());
    see(&loader.finish().unwrap())
}

#[test]
fn of_a_program_the_codes_are_sent() {
    let plain = "/ about\n\n0 / start\n787600\n\t827301\r\n/ lamp\n877901\n\n/ end";
    // A jump is stored with the number of its line.
    let jumps = "/ about\n0\n\n766601 / again\n827301\n/ lamp\n877901\n74778001\n/ end";
    for (text, sent) in [
        (plain.to_owned(), "0\n787600\n827301\n877901\n"),
        (
            jumps.to_owned(),
            "\n0\n\n766601\n827301\n\n877901\n74778001\n",
        ),
    ] {
        let text = text.as_str();
        let codes = program(text, |program| Codes::of(program, text.as_bytes()));
        assert_eq!(codes.bytes(), sent.as_bytes());
        // Where the board finds a fault, the text has that code.
        for (number, line) in (1..).zip(sent.lines()) {
            let found = codes.in_text(Trouble {
                number: 24,
                line: Some(number),
            });
            let at = found.line.unwrap() as usize - 1;
            assert!(text.lines().nth(at).unwrap().contains(line), "{found:?}");
        }
        let mut wire = Wire::new(Board::in_state(STOP));
        let kept = program(text, |program| {
            wire.talk(async |client| {
                let upload = Upload::of(program, text.as_bytes());
                upload.send(client, &mut |_| ()).await
            })
        });
        assert_eq!(wire.board.text, sent.as_bytes());
        assert_eq!(kept, Ok(self::kept(text)));
    }
}

#[test]
fn block_numbers_go_round() {
    let text = format!("{FOLLOW}/{}\n", "x".repeat(140 * usize::from(BLOCK_BYTES)));
    let mut wire = Wire::new(Board::in_state(STOP));
    send(&mut wire, &text).unwrap();
    assert_eq!(wire.board.text.len(), text.len());
}

#[test]
fn a_block_whose_answer_is_lost_is_sent_again_and_taken_once() {
    for fate in [Fate::Garbled, Fate::AnswerLost, Fate::Lost] {
        let text = long();
        let mut blocks = 0;
        let mut wire = Wire::with(Board::in_state(STOP), move |_, request| {
            blocks += u32::from(is_block(request));
            match (is_block(request), blocks % 4) {
                (true, 2) => fate,
                _ => Fate::Answered,
            }
        });
        send(&mut wire, &text).unwrap();
        assert_eq!(wire.board.text, text.as_bytes());
    }
}

#[test]
fn the_answer_to_the_end_may_take_as_long_as_storing_does() {
    // The second end, and any other block.
    for (number, is_waited_for) in [(3, true), (2, false)] {
        let mut wire = Wire::with(Board::in_state(STOP), move |_, request| {
            match is_block(request) && request[7] == number {
                true => Fate::Slow,
                false => Fate::Answered,
            }
        });
        let sent = send(&mut wire, FOLLOW);
        assert_eq!(sent.is_ok(), is_waited_for, "{sent:?}");
    }
}

/// The board answers the second end after 4 s: each byte of the program takes some ms more than patience has.
#[test]
fn a_long_program_may_take_longer_to_store() {
    let is_end = |request: &[u8]| is_block(request) && request[8] == 0;
    for (program, most) in [(FOLLOW.to_owned(), 3), (long(), 3), (rungs(), 2)] {
        let mut ends = 0;
        let mut wire = Wire::with(Board::in_state(STOP), move |_, request| {
            ends += u32::from(is_end(request));
            match is_end(request) && ends == 2 {
                true => Fate::Slow,
                false => Fate::Answered,
            }
        });
        let patience = Patience {
            store: Duration::from_millis(3_500),
            ..PATIENCE
        };
        let sent = kept(&program);
        wire.talk_with(patience, async |client| {
            upload(client, program.as_bytes(), sent, &mut |_| {}).await
        })
        .unwrap();
        let ends = wire.sent.iter();
        let ends = ends.filter(|(_, request)| is_end(&request[..request.len() - 2]));
        assert_eq!(ends.count(), most, "{} bytes", sent.bytes);
    }
}

/// A program that takes some hundred bytes.
fn rungs() -> String {
    format!("0\n{}", "827301\n877901\n".repeat(200))
}

#[test]
fn an_end_that_was_stored_and_whose_answer_is_lost_is_an_upload() {
    let mut wire = Wire::with(Board::in_state(STOP), |board, request| {
        let end = is_block(request) && request[8] == 0;
        // The second one: the board stores, and will refuse the repetition.
        if end && request[7] == 3 && board.is_uploading() {
            Fate::Garbled
        } else {
            Fate::Answered
        }
    });
    send(&mut wire, FOLLOW).unwrap();
    assert_eq!(wire.board.text, FOLLOW.as_bytes());
}

#[test]
fn the_board_tells_a_fault_with_its_line() {
    // As by a board of another version: its loader knows less than this one.
    let fault = |text: &str, board: Board| {
        let mut wire = Wire::new(board);
        let before = wire.board.kept;
        let error = send_as(&mut wire, text, Kept::default()).unwrap_err();
        assert_eq!(wire.board.kept, before, "it keeps what it had");
        error
    };
    let told = |number, line| Broken::Fault(Trouble { number, line });
    let stop = || Board::in_state(STOP);
    assert_eq!(fault("0\n787600\n123\n", stop()), told(24, Some(3)));
    let late = format!("{}40\n", long());
    let line = late.lines().count() as u32;
    assert_eq!(fault(&late, stop()), told(32, Some(line)));
    assert_eq!(fault("", stop()), told(21, None));
    let differs = Board {
        second_differs: true,
        ..stop()
    };
    assert_eq!(fault(FOLLOW, differs), told(57, None));
}

#[test]
fn an_upload_does_not_begin_in_run() {
    let mut wire = Wire::new(Board::in_state(RUN));
    let error = send(&mut wire, FOLLOW).unwrap_err();
    assert_eq!(error, Broken::NotBegun);
    assert!(!wire.board.is_uploading());
}

#[test]
fn a_locked_board_takes_no_upload() {
    let mut wire = Wire::new(locked(lock::UPLOAD, Board::in_state(STOP)));
    assert_eq!(send(&mut wire, FOLLOW), Err(Broken::Locked));
    assert!(!wire.board.is_uploading());
}

/// A board with this lock.
fn locked(lock: u8, board: Board) -> Board {
    Board {
        settings: [1, 1152, 0, 0, lock.into()],
        ..board
    }
}

/// An upload is no command of those that are locked.
#[test]
fn a_board_whose_commands_are_locked_takes_an_upload() {
    let board = |state, switch| {
        let board = Board::in_state(state);
        locked(lock::COMMANDS, Board { switch, ..board })
    };
    let mut wire = Wire::new(board(STOP, true));
    let stored = send(&mut wire, FOLLOW).unwrap();
    // Once A5 is opened it runs.
    assert_eq!(then(&mut wire, State::Stop, stored, false), Behind::Switch);
    for state in [State::Stop, State::Fault] {
        let mut wire = Wire::new(board(state as u16, false));
        let stored = send(&mut wire, FOLLOW).unwrap();
        let behind = wire.talk(async |client| go_on(client, state, stored, false).await);
        let refused = Failure::Refused(Exception::IllegalFunction);
        assert_eq!(behind, Err(refused));
    }
    let mut wire = Wire::new(board(STOP, false));
    wire.talk(async |client| command(client, Command::Upload).await)
        .unwrap();
    let left = wire.talk(end).unwrap();
    assert!(left.has(flag::UPLOAD), "it is left to end by itself");
}

#[test]
fn an_upload_that_another_client_ends_says_so() {
    let mut wire = Wire::with(Board::in_state(STOP), |board, request| {
        if is_block(request) && request[7] == 2 {
            board.set_word(holding::COMMAND.first, Command::Stop as u16);
        }
        Fate::Answered
    });
    let error = send(&mut wire, &long()).unwrap_err();
    assert_eq!(error, Broken::Ended);
}

#[test]
fn an_upload_that_is_broken_off_says_where_and_what_the_board_keeps() {
    let text = long();
    let of = text.len();
    for (number, pass, bytes, stored) in [
        (2, Pass::Check, 488, false),
        (9, Pass::Store, 244, false),
        (15, Pass::Store, of, true),
    ] {
        assert_eq!(text.len().div_ceil(BLOCK_BYTES.into()), 7);
        let mut wire = Wire::with(Board::in_state(STOP), move |_, request| {
            if is_block(request) && request[7] == number {
                Fate::Unplugged
            } else {
                Fate::Answered
            }
        });
        let before = wire.board.kept;
        let off = Broken::Off {
            pass,
            bytes,
            of,
            stored,
            failure: Failure::Lost("unplugged".to_owned()),
        };
        assert_eq!(send(&mut wire, &text), Err(off));
        assert_eq!(wire.board.kept, before);
    }
}

#[test]
fn a_board_that_keeps_something_else_is_found_out() {
    let mut wire = Wire::new(Board::in_state(STOP));
    let sent = Kept {
        bytes: 1,
        sum: 2,
        ..Kept::default()
    };
    let kept = kept(FOLLOW);
    assert_eq!(
        send_as(&mut wire, FOLLOW, sent),
        Err(Broken::Other { kept, sent })
    );
}

#[test]
fn a_board_whose_firmware_is_older_than_an_instruction_is_left_alone() {
    let pushes = "0\n766801\n808372\n766800\n3\n83856699\n838401\n";
    let put = |text: &str, version| {
        let board = Board {
            state: RUN,
            ..Board::default()
        };
        let mut wire = Wire::new(Board::of_version(version, board));
        let ordered = program(text, |program| Upload::of(program, text.as_bytes()));
        let done = wire.talk(async |client| ordered.put(client, &mut |_| ()).await);
        (done, wire.board.state)
    };
    let old = Broken::TooOld { board: 1, needs: 2 };
    assert_eq!(put(pushes, 1), (Err(Undone::Broken(old)), RUN));
    assert_eq!(put(pushes, 2), (Ok(Behind::Run), RUN));
    assert_eq!(put(FOLLOW, 1), (Ok(Behind::Run), RUN));
}

/// A firmware may keep programs in another form than this client knows: that is no failure.
#[test]
fn a_board_with_another_stored_form_takes_an_upload() {
    let other = |board| Board::of_version(FORM + 1, board);
    for (board, before) in [
        (Board::default(), State::Run),
        (Board::in_state(STOP), State::Stop),
        (Board::in_state(FAULT), State::Fault),
    ] {
        // The answer to the second end, too, may be lost.
        for lost in [false, true] {
            let mut wire = Wire::with(
                other(Board {
                    state: board.state,
                    ..Board::default()
                }),
                move |board, request| {
                    let end = is_block(request) && request[8..] == [0];
                    match lost && end && request[7] == 3 && board.is_uploading() {
                        true => Fate::AnswerLost,
                        false => Fate::Answered,
                    }
                },
            );
            wire.talk(stop).unwrap();
            let stored = send(&mut wire, FOLLOW).unwrap();
            assert_eq!(
                stored, wire.board.kept,
                "what the board tells, not what was sent"
            );
            assert!(stored.version != kept(FOLLOW).version && stored.sum != kept(FOLLOW).sum);
            assert_eq!(then(&mut wire, before, stored, false), Behind::Run);
            assert_eq!(wire.board.text, FOLLOW.as_bytes());
        }
    }
    let mut wire = Wire::new(other(Board {
        card: Some(b"0\n877901\n".to_vec()),
        ..Board::in_state(FAULT)
    }));
    let stored = send(&mut wire, FOLLOW).unwrap();
    let behind = then(&mut wire, State::Fault, stored, false);
    assert_eq!(behind, Behind::Card, "its card is still found out");
}

#[test]
fn what_comes_behind_an_upload_depends_on_where_the_board_was() {
    let uploaded = |board: Board, stays: bool| {
        let mut wire = Wire::new(board);
        let before = wire.talk(stop).unwrap().state.unwrap();
        let stored = send(&mut wire, FOLLOW).unwrap();
        let behind = then(&mut wire, before, stored, stays);
        (behind, wire.board.state)
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

#[test]
fn a_board_that_restarts_is_waited_for() {
    let mut silent = 0;
    let mut wire = Wire::with(Board::in_state(FAULT), move |board, _| {
        match board.restarts > 0 && silent < 12 {
            true => {
                silent += 1;
                Fate::Lost
            }
            false => Fate::Answered,
        }
    });
    let stored = send(&mut wire, FOLLOW).unwrap();
    assert_eq!(then(&mut wire, State::Fault, stored, false), Behind::Run);
}

#[test]
fn a_board_that_does_not_start_is_given_up() {
    let mut wire = Wire::with(Board::in_state(FAULT), |board, _| match board.restarts {
        0 => Fate::Answered,
        _ => Fate::Lost,
    });
    let stored = send(&mut wire, FOLLOW).unwrap();
    let begun = wire.now;
    let started = wire.talk(async |client| go_on(client, State::Fault, stored, false).await);
    assert_eq!(started, Err(Failure::Silent));
    assert!(wire.now - begun >= PATIENCE.start);
}

#[test]
fn a_board_that_fails_in_its_first_second_does_not_run() {
    for state in [RUN, STOP, FAULT] {
        let mut wire = Wire::new(Board {
            fault_in_run: Some((75, 6)),
            ..Board::in_state(state)
        });
        let before = wire.talk(stop).unwrap().state.unwrap();
        let stored = send(&mut wire, FOLLOW).unwrap();
        let begun = wire.now;
        let behind = then(&mut wire, before, stored, false);
        let Behind::Failing(Some(trouble)) = behind else {
            panic!("{behind:?}");
        };
        assert_eq!((trouble.number, trouble.line), (75, Some(6)));
        // One that was in FAULT is restarted, and says so before it is in RUN at all.
        assert!(state == FAULT || wire.now - begun >= FIRST_SCANS);
    }
}

#[test]
fn an_upload_that_is_broken_off_ends_in_order() {
    let mut wire = Wire::new(Board::in_state(STOP));
    wire.talk(async |client| command(client, Command::Upload).await)
        .unwrap();
    assert!(wire.board.is_uploading());
    let board = wire.talk(end).unwrap();
    assert_eq!(
        (board.state, wire.board.is_uploading()),
        (Some(State::Stop), false)
    );
    // Without one nothing is asked of the board.
    let mut wire = Wire::new(Board::in_state(RUN));
    assert_eq!(wire.talk(end).unwrap().state, Some(State::Run));
    assert_eq!(wire.board.state, RUN);
}

#[test]
fn the_first_form_that_has_all_instructions_is_needed() {
    let programs = [
        (FOLLOW, 1),
        ("0\n766800\n7\n838432\n", 1),
        ("0\n766800\n7\n838433\n", 2),
        ("0\n766832\n838401\n", 1),
        ("0\n766833\n838401\n", 2),
        ("0\n766801\n808372\n766800\n3\n83856699\n838401\n", 2),
    ];
    for (text, form) in programs {
        assert_eq!(program(text, needs), form, "{text}");
    }
}
