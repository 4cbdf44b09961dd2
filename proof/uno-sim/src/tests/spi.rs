//! The card on the SPI.

use super::assembly::*;
use super::{board, working_register};
use crate::sd::{At, Kind, SdCard, Timing, What};
use crate::{CYCLES_PER_MS, Halt, Program, Slot, Uno};

/// A program that talks to the card, built byte by byte. What comes in last stands in r20.
struct Talk(Vec<u16>);

impl Talk {
    /// Switches the SPI on, wakes the card with 80 clocks, and selects it.
    fn new() -> Talk {
        let mut talk = Talk(vec![rjmp(6)]);
        // transfer, at word 1: r16 out, r20 in.
        talk.0.extend([
            out(SPDR, 16),
            input(17, SPSR),
            sbrs(17, 7),
            rjmp(-3),
            input(20, SPDR),
            RET,
        ]);
        talk.0.extend([
            ldi(16, 0x2C),
            out(DDRB, 16),
            sbi(PORTB, 2),
            ldi(16, 0x50),
            out(SPCR, 16),
        ]);
        talk.send(&[0xFF; 10]);
        talk.0.push(cbi(PORTB, 2));
        talk
    }

    fn send(&mut self, bytes: &[u16]) {
        for &byte in bytes {
            self.0.push(ldi(16, byte));
            self.0.push(rcall(-(self.0.len() as i16)));
        }
    }

    /// A command with this CRC byte, up to its R1.
    fn command(&mut self, index: u16, argument: u16, crc: u16) {
        let [high, low] = argument.to_be_bytes().map(u16::from);
        self.send(&[0x40 | index, 0, 0, high, low, crc, 0xFF, 0xFF]);
    }

    /// The same byte 512 times.
    fn send_block(&mut self, byte: u16) {
        self.0.extend([ldi(24, 2), ldi(25, 0)]);
        self.send(&[byte]);
        self.0.extend([dec(25), brne(-4), dec(24), brne(-6)]);
    }

    /// Sends 0xFF until 0xFF comes.
    fn wait(&mut self) {
        self.send(&[0xFF]);
        self.0.extend([inc(20), brne(-4)]);
    }
}

fn cmd0_program() -> Vec<u16> {
    let mut talk = Talk::new();
    talk.command(0, 0, 0x95);
    talk.0.push(HERE);
    talk.0
}

/// Initialises a card of version 1, writes block 1, keeps the data response at 0x200, and waits while the card is busy.
fn write_program() -> Vec<u16> {
    let mut talk = Talk::new();
    for (index, argument, crc) in [(0, 0, 0x95), (55, 0, 0), (41, 0, 0), (24, 512, 0)] {
        talk.command(index, argument, crc);
    }
    talk.send(&[0xFF, 0xFE]);
    talk.send_block(0xA5);
    talk.send(&[0, 0, 0xFF]);
    talk.0.extend([sts(20), 0x200]);
    talk.wait();
    talk.0.push(HERE);
    talk.0
}

/// A board that writes block 1 of a card that holds zeros and is busy for this many cycles then.
fn writing(busy: u64) -> Uno {
    let timing = Timing {
        init_polls: 0,
        write_busy: 0,
        ..Timing::default()
    };
    let card = SdCard::new(Kind::SdV1, Vec::new()).expect("an empty image fits");
    let card = card.with_timing(timing).with_write_time(busy);
    let program = Program::from_words(&write_program());
    Uno::with_program(program, Slot::Card(card)).expect("simavr knows the chip")
}

fn block(uno: &Uno) -> &[u8] {
    &uno.card().expect("a card").image()[512..1024]
}

#[test]
fn the_card_hangs_on_the_spi_and_its_chip_select() {
    let card = SdCard::new(Kind::Sdhc, Vec::new()).expect("an empty image fits");
    let program = Program::from_words(&cmd0_program());
    let mut uno = Uno::with_program(program, Slot::Card(card)).expect("simavr knows the chip");
    assert!(matches!(uno.run_cycles(10_000), Err(Halt::Hung { .. })));
    assert_eq!(working_register(&uno, 20), 0x01, "idle");
    let log = uno.card().expect("a card").log().clone();
    assert_eq!((log.count(0), log.commands.len()), (1, 1));

    let Slot::Card(card) = uno.swap_slot(Slot::Empty) else {
        panic!("there was a card")
    };
    assert_eq!(card.log(), &log);
    uno.reset();
    assert!(matches!(uno.run_cycles(10_000), Err(Halt::Hung { .. })));
    assert_eq!(working_register(&uno, 20), 0xFF, "nobody there");
}

#[test]
fn the_spi_takes_eight_times_its_divider_for_a_byte() {
    // SPR and SPI2X, and the divider (datasheet, table 19-5).
    for (spr, double, divider) in [
        (0, 0, 4),
        (0, 1, 2),
        (1, 0, 16),
        (1, 1, 8),
        (2, 0, 64),
        (3, 0, 128),
    ] {
        let mut uno = board(&[
            ldi(16, 0x50 | spr),
            out(SPCR, 16),
            ldi(16, double),
            out(SPSR, 16),
            out(SPDR, 16), // ends after cycle 5
            input(17, SPSR),
            sbrs(17, 7),
            rjmp(-3),
            HERE,
        ]);
        assert!(matches!(uno.run_cycles(5_000), Err(Halt::Hung { .. })));
        // The loop takes four cycles a round, and the last instructions three.
        let took = uno.cycles() - 5;
        let byte = 8 * divider;
        assert!(
            (byte..byte + 10).contains(&took),
            "divider {divider}: {took} cycles"
        );
    }
}

#[test]
fn a_written_block_keeps_the_card_busy_for_a_time() {
    let took = |busy| {
        let mut uno = writing(busy);
        assert!(matches!(uno.run_ms(1000), Err(Halt::Hung { .. })));
        assert_eq!(block(&uno), [0xA5; 512]);
        assert_eq!(uno.card().expect("a card").log().blocks_written, 1);
        let response = uno.read_ram(0x200, 1).expect("RAM")[0];
        assert_eq!(response & 0x1F, 0x05, "accepted");
        uno.cycles()
    };
    let at_once = took(0);
    for ms in [1, 250] {
        let busy = ms * CYCLES_PER_MS;
        let waited = took(busy) - at_once;
        assert!(
            (busy - 100..busy + 100).contains(&waited),
            "{ms} ms: {waited} cycles"
        );
    }
}

#[test]
fn a_power_cut_leaves_a_block_old_or_new() {
    let mut whole = writing(0);
    assert!(matches!(whole.run_ms(1000), Err(Halt::Hung { .. })));
    let end = whole.cycles();
    let mut seen = [0, 0];
    for cut in (0..end).step_by(499).chain((end - 400..end).step_by(20)) {
        let mut uno = writing(0);
        uno.run_cycles(cut).expect("not yet at its end");
        uno.power_up();
        let new = uno.card().expect("a card").log().blocks_written == 1;
        assert_eq!(block(&uno), [if new { 0xA5 } else { 0 }; 512], "at {cut}");
        seen[usize::from(new)] += 1;
        assert!(matches!(uno.run_ms(1000), Err(Halt::Hung { .. })));
        assert_eq!(block(&uno), [0xA5; 512], "at {cut}: the next start");
    }
    assert!(seen[0] > 10 && seen[1] > 1, "{seen:?}");
}

#[test]
fn a_card_that_was_pulled_out_stays_out_when_power_comes() {
    for (what, there) in [(What::Removed, false), (What::Stuck, true)] {
        let card = SdCard::new(Kind::SdV1, Vec::new()).expect("an empty image fits");
        let card = card.with_fault(At::Command(0), what);
        let program = Program::from_words(&cmd0_program());
        let mut uno = Uno::with_program(program, Slot::Card(card)).expect("the chip");
        assert!(matches!(uno.run_cycles(10_000), Err(Halt::Hung { .. })));
        assert_ne!(working_register(&uno, 20), 0x01, "{what:?}");
        uno.power_up();
        assert!(matches!(uno.run_cycles(10_000), Err(Halt::Hung { .. })));
        assert_eq!(working_register(&uno, 20) == 0x01, there, "{what:?}");
    }
}
