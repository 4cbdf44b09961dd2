//! Both serial ports of a Mega at once: tools at USB, a master at the bus.

use crate::common::line::{meet, talk};
use crate::common::modbus::{serving, with_crc, words, write};
use crate::common::ms_until;
use unoclp_client::Order;
use unoclp_client::start::find;
use unoclp_client::watch::{Reading, Scope, Side};
use unoclp_modbus::Crc;
use unoclp_uno_sim::{CYCLES_PER_MS, Uno};

/// Output 01 follows input 01.
const FOLLOW: &str = "0\n827301\n877901\n";
/// The outputs, and what is answered where the first alone is on.
const COILS: [u8; 6] = [1, 1, 0, 0, 0, 8];
const FIRST_IS_ON: [u8; 4] = [1, 1, 1, 1];

/// A master asks so often for this, from now on, each so many ms.
fn poll(mega: &mut Uno, request: &[u8], times: u64, each_ms: u64) {
    let begun = mega.cycles();
    for n in 0..times {
        let at = begun + n * each_ms * CYCLES_PER_MS;
        mega.send_bus_at(at, &with_crc(request));
    }
}

/// What has been answered to it, frame by frame, without the checksums.
fn answers(mega: &mut Uno) -> Vec<Vec<u8>> {
    let (mut frames, mut last) = (Vec::<Vec<u8>>::new(), 0);
    for sent in mega.take_bus_log() {
        if frames.is_empty() || sent.start > last + CYCLES_PER_MS {
            frames.push(Vec::new());
        }
        frames.last_mut().unwrap().push(sent.byte);
        last = sent.end;
    }
    for frame in &mut frames {
        assert_eq!(Crc::of(frame).value(), 0, "{frame:02x?}");
        frame.truncate(frame.len() - 2);
    }
    frames
}

/// Every request of the master is answered while a tool finds the board, reads all that there is, and forces.
#[test]
fn tools_and_a_master_are_served_at_the_same_time() {
    const TIMES: u64 = 300;
    let mut mega = serving(FOLLOW);
    mega.set_inputs(1);
    mega.run_ms(5).unwrap();
    let begun = mega.cycles();
    poll(&mut mega, &COILS, TIMES, 8);
    meet(&mut mega);
    let outputs = talk(&mut mega, async |client| {
        find(client, false).await.unwrap();
        let mut outputs = Vec::new();
        for force in [Some(false), Some(true)] {
            let order = Order::Force(Side::Inputs, 23, force);
            order.fulfil(client, None, &mut |_| ()).await.unwrap();
            let reading = Reading::read(client, Scope::default()).await.unwrap();
            outputs.push((reading.outputs, reading.forced().to_string()));
        }
        outputs
    });
    assert_eq!(outputs, [(1, "I24=0".to_owned()), (1, "I24=1".to_owned())]);
    let of_tool = (mega.cycles() - begun) / CYCLES_PER_MS;
    mega.run_ms((TIMES * 8 + 20).saturating_sub(of_tool))
        .unwrap();
    let answers = answers(&mut mega);
    println!("the tool took {of_tool} ms, beside {TIMES} answers");
    assert_eq!(answers.len() as u64, TIMES);
    assert!(answers.iter().all(|answer| *answer == FIRST_IS_ON));
    assert!(of_tool > 100, "{of_tool}");
}

/// A master may ask for all that a tool may; both see what either has written.
#[test]
fn each_line_sees_what_the_other_has_written() {
    let mut mega = serving(FOLLOW);
    for register in [0x92, 0x93] {
        let request = [1, 6, 1, register, 0, 1];
        poll(&mut mega, &request, 1, 10);
        mega.run_ms(20).unwrap();
        assert_eq!(answers(&mut mega), [request]);
    }
    assert_eq!(words(&mut mega, 3, 402, 2), [1, 1]);
    assert_eq!(mega.outputs(), 1);
    write(&mut mega, 402, 0).unwrap();
    poll(&mut mega, &COILS, 1, 10);
    mega.run_ms(20).unwrap();
    assert_eq!(answers(&mut mega), [[1, 1, 1, 0]]);
}

/// What a tool has forced ends with its silence, however often a master asks; and the other way round.
#[test]
fn forcing_ends_with_the_silence_of_who_has_forced() {
    let mut mega = serving(FOLLOW);
    for (address, value) in [(406, 2), (403, 1), (402, 1)] {
        write(&mut mega, address, value).unwrap();
    }
    poll(&mut mega, &COILS, 50, 100);
    mega.run_ms(1000).unwrap();
    assert_eq!(mega.outputs(), 1);
    mega.run_ms(3000).unwrap();
    assert_eq!(mega.outputs(), 0);
    mega.run_ms(1100).unwrap();

    poll(&mut mega, &[1, 16, 1, 0x92, 0, 2, 4, 0, 1, 0, 1], 1, 10);
    for _ in 0..10 {
        mega.run_ms(80).unwrap();
        assert_eq!(words(&mut mega, 3, 406, 1), [2]);
    }
    assert_eq!(mega.outputs(), 1);
    for _ in 0..30 {
        mega.run_ms(80).unwrap();
        assert_eq!(words(&mut mega, 3, 406, 1), [2]);
    }
    assert_eq!(mega.outputs(), 0);
}

/// A tool restarts the board while something that is no request comes over the bus.
#[test]
fn a_line_that_hears_does_not_hold_up_a_restart() {
    let mut mega = serving(FOLLOW);
    mega.send_bus(&[9, 4]);
    mega.run_ms(1).unwrap();
    mega.take_serial();
    let noise = mega.cycles();
    for n in 0..40 {
        mega.send_bus_at(noise + n * CYCLES_PER_MS, &[9, 4, 0]);
    }
    write(&mut mega, 400, 4).unwrap();
    let said = ms_until(&mut mega, &["RUN\r\n"]).1;
    assert!(said.contains("by command"), "{said:?}");
}
