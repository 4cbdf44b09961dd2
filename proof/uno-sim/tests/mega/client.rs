//! What a client sees and changes of the points that a Mega has and an UNO has not.

use crate::BOARD;
use crate::common::line::{meet, talk};
use crate::common::uno;
use unoclp_checked::Checked;
use unoclp_client::Order;
use unoclp_client::start::find;
use unoclp_client::upload::{Behind, Upload};
use unoclp_client::watch::{Forces, Reading, Scope, Side};
use unoclp_uno_sim::{Slot, Uno};

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
