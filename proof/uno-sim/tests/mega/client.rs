//! What a client sees and changes of the points that a Mega has and a UNO has not; and what becomes of an upload that meets an
//! UNO in its place.

use crate::BOARD;
use crate::common::line::{LOOK, meet, now, talk};
use crate::common::{card, to_run, uno};
use unoclp_checked::Checked;
use unoclp_client::diagnostics::Kept;
use unoclp_client::map::{Command, State, holding};
use unoclp_client::order::Undone;
use unoclp_client::start::find;
use unoclp_client::upload::{Behind, Broken, Upload, end};
use unoclp_client::watch::{Forces, Reading, Scope, Side, command};
use unoclp_client::{Client, Conversation, Line, Next, Order, Patience};
use unoclp_core::Board;
use unoclp_uno_sim::{Program, Slot, Uno, firmware_file};

/// What a client of one conversation reads, once it knows the board, after it has done these.
fn read(mega: &mut Uno, orders: &[Order]) -> Reading {
    talk(mega, async |client| {
        find(client, false).await.unwrap();
        assert_eq!(client.board(), BOARD);
        for order in orders {
            order.fulfil(client, None, &mut |_| ()).await.unwrap();
        }
        Reading::read(client, Scope::default()).await.unwrap()
    })
}

/// A program of 3,500 bytes, each output with the input of its number, is uploaded to a board without one and runs.
#[test]
fn a_program_of_full_size_is_uploaded_and_all_points_are_forced() {
    let rungs: String = (1..=BOARD.outputs)
        .map(|n| format!("787600\n8273{:02}\n8779{n:02}\n", n + 8))
        .collect();
    let begun = format!("0\n{rungs}");
    let bytes = |text: &str| {
        let checked = Checked::read(text.as_bytes(), BOARD).unwrap();
        checked.program().stored_bytes()
    };
    let more = usize::from(BOARD.stored_bytes) - bytes(&begun);
    let text = begun + &"787600\n".repeat(more);
    assert_eq!(bytes(&text), usize::from(BOARD.stored_bytes));

    let mut mega = uno(Slot::Empty);
    meet(&mut mega);
    let checked = Checked::read(text.as_bytes(), BOARD).unwrap();
    let program = checked.program();
    let upload = Upload::of(program, text.as_bytes());
    let outcome = talk(&mut mega, async |client| {
        find(client, false).await.unwrap();
        upload.put(client, &mut |_| ()).await
    });
    assert_eq!(outcome, Ok(Behind::Run));

    mega.set_all_inputs(1 << 23 | 1 << 16 | 1 << 4);
    mega.run_ms(5).unwrap();
    let reading = read(&mut mega, &[]);
    assert_eq!(reading.inputs, 1 << 23 | 1 << 16 | 1 << 4);
    assert_eq!(reading.outputs, 1 << 15 | 1 << 8);
    assert_eq!(reading.analogue.len(), usize::from(BOARD.analogue));

    let orders = [
        Order::Force(Side::Inputs, 23, Some(false)),
        Order::Force(Side::Inputs, 12, Some(true)),
        Order::Force(Side::Outputs, 15, Some(true)),
    ];
    let reading = read(&mut mega, &orders);
    let inputs = Forces {
        points: 1 << 23 | 1 << 12,
        to: 1 << 12,
    };
    assert_eq!(reading.forced_inputs, inputs);
    assert_eq!(reading.forced().to_string(), "I13=1 I24=0 Q16=1");
    mega.run_ms(5).unwrap();
    assert_eq!(mega.all_outputs(), 1 << 15 | 1 << 8 | 1 << 4);

    let reading = read(&mut mega, &[Order::Release]);
    assert!(!reading.forced().any());
    mega.run_ms(5).unwrap();
    assert_eq!(mega.all_outputs(), 1 << 15 | 1 << 8);
}

/// Output 01 follows input 01.
const NEAR: &str = "0\n827301\n877901\n";

/// A UNO that runs this.
fn running_uno(text: &str) -> Uno {
    let firmware = Program::read(&firmware_file().unwrap()).unwrap();
    let mut uno = Uno::with_program(firmware, Slot::Card(card(text))).unwrap();
    to_run(&mut uno);
    uno
}

/// A Mega that runs this.
fn running_mega(text: &str) -> Uno {
    let mut mega = uno(Slot::Card(card(text)));
    to_run(&mut mega);
    mega
}

/// Uploads a program that was checked for one board to the board at hand, as a tool that asks nobody would.
fn upload(board: &mut Uno, text: &str, checked_for: Board) -> Result<Behind, Undone> {
    let checked = Checked::read(text.as_bytes(), checked_for).unwrap();
    let upload = Upload::of(checked.program(), text.as_bytes());
    talk(board, async |client| {
        find(client, false).await.unwrap();
        upload.put(client, &mut |_| ()).await
    })
}

/// What a board keeps, and whether it follows its input once it is in RUN.
fn kept(board: &mut Uno) -> (Kept, bool) {
    let kept = talk(board, async |client| {
        let board = end(client).await.unwrap();
        if board.state != Some(State::Run) {
            command(client, Command::Run).await.unwrap();
        }
        board.program
    });
    let follows = [1, 0].map(|inputs| {
        board.set_inputs(inputs);
        board.run_ms(5).unwrap();
        board.outputs() & 1 == inputs
    });
    (kept, follows == [true; 2])
}

#[test]
fn an_uno_that_is_sent_a_program_for_a_mega_says_where_and_keeps_its_own() {
    let long = "0\n".to_owned() + &"827301\n".repeat(1000) + "877901\n";
    for (text, fault, line) in [
        ("0\n827301\n877916\n", 26, 3),
        ("0\n827324\n877901\n", 25, 2),
        (&*long, 41, 902),
    ] {
        let mut uno = running_uno(NEAR);
        let (before, _) = kept(&mut uno);
        let Err(Undone::Broken(Broken::Fault(trouble))) = upload(&mut uno, text, BOARD) else {
            panic!("{text}");
        };
        assert_eq!((trouble.number, trouble.line), (fault, Some(line)));
        assert_eq!(kept(&mut uno), (before, true), "{text}");
        let mut mega = running_mega(NEAR);
        assert_eq!(upload(&mut mega, text, BOARD), Ok(Behind::Run), "{text}");
    }
    // The other way round it is the same program.
    let mut mega = running_mega("0\n877916\n");
    assert_eq!(upload(&mut mega, NEAR, Board::UNO), Ok(Behind::Run));
    assert_eq!(kept(&mut mega), kept(&mut running_uno(NEAR)));
}

/// Has a conversation with the first board, and from the third block of an upload on with the second one.
fn moved<T>(boards: &mut [Uno; 2], talk: impl AsyncFnOnce(&mut Client) -> T) -> T {
    let mut conversation = Conversation::new(Line::default(), Patience::default(), talk);
    let (mut came, mut blocks) = (Vec::new(), 0);
    let [ahead, behind] = [0, 1].map(|n| boards[n].cycles());
    let late = usize::from(ahead > behind);
    boards[late].run_cycles(ahead.abs_diff(behind)).unwrap();
    loop {
        let step = conversation.step(now(&boards[0]), &came);
        came.clear();
        let [high, low] = holding::UPLOAD.first.to_be_bytes();
        blocks += u32::from(step.send.get(1..4) == Some(&[16, high, low]));
        let at = usize::from(blocks >= 3);
        if !step.send.is_empty() {
            boards[at].send_serial(&step.send);
        }
        let until = match step.next {
            Next::Done(outcome) => return outcome,
            Next::Wait(until) => until,
        };
        while came.is_empty() && now(&boards[0]) < until {
            for (n, board) in boards.iter_mut().enumerate() {
                board.run_cycles(LOOK).unwrap();
                let said = board.take_serial_log();
                came.extend(said.iter().map(|sent| sent.byte).filter(|_| n == at));
            }
        }
    }
}

#[test]
fn an_upload_that_goes_on_at_another_board_ends_and_both_keep_their_programs() {
    let text = "0\n".to_owned() + &"827301\n".repeat(200) + "877904\n";
    for uno_first in [true, false] {
        let mut boards = [running_uno(NEAR), running_mega(NEAR)];
        if !uno_first {
            boards.reverse();
        }
        let before = boards.each_mut().map(kept);
        let checked = Checked::read(text.as_bytes(), Board::UNO).unwrap();
        let upload = Upload::of(checked.program(), text.as_bytes());
        let outcome = moved(&mut boards, async |client| {
            find(client, false).await.unwrap();
            upload.put(client, &mut |_| ()).await
        });
        assert_eq!(outcome, Err(Undone::Broken(Broken::Ended)));
        assert_eq!(boards.each_mut().map(kept), before);
        assert!(before.iter().all(|(_, follows)| *follows));
    }
}
