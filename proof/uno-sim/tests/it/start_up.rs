//! Times and signs of start-up: the slot, the serial port, LED L, the clock.

use crate::BOARD;
use crate::common::{card, ms_until, to_run, uno};
use unoclp_testing::cases;
use unoclp_uno_sim::sd::{At, What};
use unoclp_uno_sim::{CYCLES_PER_MS, Edge, Pin, Slot, Uno};

#[test]
fn an_empty_slot_is_known_within_300_ms() {
    let mut uno = uno(Slot::Empty);
    let (ms, _) = ms_until(&mut uno, &["fault 51: no card answers"]);
    println!("an empty slot is known after {ms} ms");
    assert!(ms <= 300, "{ms} ms");
}

/// Each command and block of a start-up dies in turn, each in every way of dying.
#[test]
fn a_dead_card_is_given_up_within_2_s() {
    let text = "0\n".to_string() + &"827301\n".repeat(200);
    let mut healthy = uno(Slot::Card(card(&text)));
    to_run(&mut healthy);
    let log = healthy.card().unwrap().log();
    let (commands, blocks) = (log.commands.len(), log.blocks_read as usize);

    let places = (0..commands)
        .map(At::Command)
        .chain((0..blocks).map(At::Block));
    let (mut runs, mut slowest) = (0, 0);
    for at in places {
        for what in [What::NoAnswer, What::Stuck, What::Removed, What::NeverReady] {
            let mut uno = uno(Slot::Card(card(&text).with_fault(at, what)));
            uno.set_inputs(0b1111);
            let mut ms = 0;
            while ms <= 2000
                && !["\r\nfault 5", "RUN\r\n"]
                    .iter()
                    .any(|end| uno.serial().contains(end))
            {
                uno.run_ms(1).unwrap();
                ms += 1;
            }
            // A card that dies after its last block was read is not missed.
            let serial = uno.serial().into_owned();
            assert!(ms <= 2000, "{what:?} at {at:?}: {serial:?} after {ms} ms");
            if serial.contains("fault") {
                assert_eq!(uno.outputs(), 0, "{what:?} at {at:?}");
                assert!(
                    !uno.edges().iter().any(|edge| edge.pin != Pin::Led),
                    "{what:?} at {at:?}"
                );
            } else {
                assert!(
                    serial.contains("program: 201 codes, 200 bytes"),
                    "{what:?} at {at:?}: {serial:?}"
                );
            }
            runs += 1;
            slowest = slowest.max(ms);
        }
    }
    println!("{runs} dying cards, the slowest given up after {slowest} ms");
}

/// One disturbance in a start-up does not keep the right program from running.
#[test]
fn a_disturbance_is_overcome() {
    let text = "0\n".to_string() + &"827301\n".repeat(200);
    let mut healthy = uno(Slot::Card(card(&text)));
    to_run(&mut healthy);
    let blocks = healthy.card().unwrap().log().blocks_read as usize;

    let damaged = (0..blocks).flat_map(|block| {
        [What::WrongCrc, What::WrongToken, What::NoAnswer].map(|what| (At::Block(block), what))
    });
    let silent = [(At::Command(0), What::NoAnswer)];
    let mut runs = 0;
    for (at, what) in cases(damaged.chain(silent)) {
        let mut uno = uno(Slot::Card(card(&text).with_fault(at, what)));
        let said = to_run(&mut uno);
        let end = format!(
            "program: 201 codes, 200 bytes used, {} free, 0 timers\r\nRUN\r\n",
            BOARD.stored_bytes - 200
        );
        assert!(said.ends_with(&end), "{what:?} at {at:?}: {said:?}");
        runs += 1;
    }
    println!("{runs} disturbances overcome");
}

#[test]
fn the_serial_port_says_what_was_loaded() {
    let text = "0\n827301\n847978\n500\n7901\n787600\n-827302\n877902\n";
    let mut uno = uno(Slot::Card(card(text)));
    assert_eq!(
        to_run(&mut uno),
        format!(
            "\r\nunoclp {}\r\nprogram: 6 codes, 10 bytes used, {} free, 1 timer\r\nRUN\r\n",
            env!("CARGO_PKG_VERSION"),
            BOARD.stored_bytes - 10
        )
    );
}

#[test]
fn the_serial_port_says_a_fault_with_number_line_and_text() {
    let mut uno = uno(Slot::Card(card("0\n\n/ a comment\n827301\n827399\n")));
    let said = ms_until(&mut uno, &["input\r\n"]).1;
    assert!(
        said.ends_with("\r\nfault 25, line 5: this board has no such input\r\n"),
        "{said:?}"
    );
}

/// Numbers of up to ten digits come out right on the chip.
#[test]
fn large_line_numbers_are_printed() {
    let text = "0\n".to_string() + &"\n".repeat(100_007) + "5\n";
    let mut uno = uno(Slot::Card(card(&text)));
    for _ in 0..60 {
        uno.run_ms(500).unwrap();
        if uno.serial().contains("such code") {
            break;
        }
    }
    assert!(
        uno.serial().contains("fault 24, line 100009: no such code"),
        "{}",
        uno.serial()
    );
}

/// The lengths in ms for which LED L is on, in order.
fn flashes(edges: &[Edge]) -> Vec<u64> {
    let led: Vec<&Edge> = edges.iter().filter(|edge| edge.pin == Pin::Led).collect();
    led.windows(2)
        .filter(|pair| pair[0].high)
        .map(|pair| (pair[1].cycle - pair[0].cycle).div_ceil(CYCLES_PER_MS))
        .collect()
}

#[test]
fn led_l_flashes_the_fault_number() {
    let mut uno = uno(Slot::Card(card("0\n41\n")));
    ms_until(&mut uno, &["fault 31"]);
    uno.take_edges();
    uno.run_ms(9000).unwrap();
    let long: Vec<bool> = flashes(uno.edges()).iter().map(|ms| *ms > 500).collect();
    // Three long ones, one short one, and the same again.
    assert_eq!(long.get(..5), Some(&[true, true, true, false, true][..]));
}

#[test]
fn led_l_is_steady_in_run() {
    let mut uno = uno(Slot::Card(card("0\n827301\n877901\n")));
    to_run(&mut uno);
    uno.run_ms(2).unwrap();
    assert!(uno.led());
    uno.take_edges();
    uno.run_ms(1000).unwrap();
    assert_eq!(uno.edges(), []);
}

/// The clock of the board is exact: 1,000 readings of it in 1,000 ms of the chip.
#[test]
fn a_millisecond_is_16000_cycles() {
    let mut uno = uno(Slot::Card(card("0\n")));
    to_run(&mut uno);
    let millis = uno.symbol("MILLIS").unwrap().address;
    // Its low byte, which changes with every reading, and in one instruction.
    let read = |uno: &Uno| uno.read_ram(millis, 1).unwrap()[0];
    let mut changes = Vec::new();
    let mut last = read(&uno);
    while changes.len() <= 1000 {
        uno.step().unwrap();
        let now = read(&uno);
        if now != last {
            assert_eq!(now, last.wrapping_add(1));
            changes.push(uno.cycles());
            last = now;
        }
    }
    let cycles = changes[1000] - changes[0];
    // The interrupt may wait for a few cycles, for the instruction that is under way.
    assert!(cycles.abs_diff(1000 * CYCLES_PER_MS) < 40, "{cycles}");
}
