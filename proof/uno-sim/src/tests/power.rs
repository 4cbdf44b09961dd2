//! Power, resets and their causes, the switch RUN/STOP, and errors put into the program.

use super::assembly::*;
use super::{board, steps, working_register};
use crate::{CYCLES_PER_MS, Edge, Error, Halt, Pin, STALL, Uno};

/// Bits of MCUSR.
const PORF: u8 = 1 << 0;
const EXTRF: u8 = 1 << 1;
const WDRF: u8 = 1 << 3;
/// 2048 << 3 cycles of the watchdog's 128 kHz.
const WATCHDOG_128_MS: u64 = 128 * CYCLES_PER_MS;

/// Counts its starts at 0x200, keeps MCUSR in r20, and hangs. Where the watchdog was not the cause, it first sets output
/// 0, and the watchdog to this prescaler.
fn hanging(prescaler: u16) -> Vec<u16> {
    vec![
        lds(17),
        0x200,
        inc(17),
        sts(17),
        0x200,
        input(20, MCUSR),
        sbrc(20, 3),
        HERE,
        sbi(DDRD, 6),
        sbi(PORTD, 6),
        ldi(16, 0x18), // WDCE and WDE
        sts(16),
        WDTCSR,
        ldi(16, 0x08 | prescaler), // WDE
        sts(16),
        WDTCSR,
        HERE,
    ]
}

fn starts(uno: &Uno) -> u8 {
    uno.read_ram(0x200, 1).expect("RAM")[0]
}

#[test]
fn a_watchdog_reset_keeps_ram_and_lets_the_outputs_go() {
    let mut uno = board(&hanging(3));
    uno.write_ram(0x200, &[0]).expect("RAM");
    uno.run_cycles(WATCHDOG_128_MS).expect("the watchdog is on");
    assert_eq!((uno.resets(), uno.outputs(), starts(&uno)), (0, 1, 1));
    assert_eq!(working_register(&uno, 20), PORF);

    uno.run_cycles(100).expect("the watchdog is on");
    assert_eq!((uno.resets(), uno.outputs(), starts(&uno)), (1, 0, 2));
    assert_eq!(uno.read_ram(0x2A, 1).expect("DDRD"), [0]);
    assert_eq!(working_register(&uno, 20), PORF | WDRF);
    let &[on, off] = uno.edges() else {
        panic!("{:?}", uno.edges())
    };
    assert_eq!((on.pin, on.high, off.high), (Pin::Output(0), true, false));
    let took = off.cycle - on.cycle;
    let wanted = WATCHDOG_128_MS..WATCHDOG_128_MS + 20;
    assert!(wanted.contains(&took), "{took} cycles");

    // The watchdog stays on after its reset, at 16 ms, counted from the reset.
    uno.run_cycles(16 * CYCLES_PER_MS - 150).expect("still on");
    assert_eq!(uno.resets(), 1);
    for resets in 2..5 {
        uno.run_cycles(16 * CYCLES_PER_MS).expect("still on");
        assert_eq!(
            (uno.resets(), u32::from(starts(&uno))),
            (resets, resets + 1)
        );
    }
}

#[test]
fn with_the_boot_loader_all_starts_look_alike() {
    let mut uno = board(&hanging(0));
    uno.write_ram(0x200, &[0]).expect("RAM");
    uno.set_boot_loader(true);
    // The program sees no watchdog reset, so it starts as the first time.
    uno.run_ms(15).expect("the watchdog is on");
    assert_eq!((working_register(&uno, 20), uno.outputs()), (0, 1));
    for resets in 1..4 {
        uno.run_ms(16).expect("the watchdog is on");
        assert_eq!(uno.resets(), resets);
        assert_eq!(u32::from(starts(&uno)), resets + 1, "RAM is kept");
        assert_eq!((working_register(&uno, 20), uno.outputs()), (0, 1));
    }
    uno.reset();
    steps(&mut uno, 6);
    assert_eq!(working_register(&uno, 20), 0, "the button");
    uno.power_up();
    steps(&mut uno, 6);
    assert_eq!(working_register(&uno, 20), 0, "power");

    // It leaves the watchdog off: the second start, which does not set it, hangs for good.
    let mut uno = board(&[
        lds(17),
        0x200,
        inc(17),
        sts(17),
        0x200,
        sbrc(17, 1),
        HERE,
        ldi(16, 0x18), // WDCE and WDE
        sts(16),
        WDTCSR,
        ldi(16, 0x08), // WDE, 16 ms
        sts(16),
        WDTCSR,
        HERE,
    ]);
    uno.write_ram(0x200, &[0]).expect("RAM");
    uno.set_boot_loader(true);
    assert!(matches!(uno.run_ms(100), Err(Halt::Hung { .. })));
    assert_eq!((uno.resets(), starts(&uno)), (1, 2));
}

#[test]
fn mcusr_tells_and_keeps_the_causes() {
    let mut uno = board(&[input(20, MCUSR), rjmp(-2)]);
    let mut seen = Vec::new();
    for reset in [
        |_: &mut Uno| {},
        Uno::reset,
        Uno::power_up,
        Uno::reset,
        Uno::reset,
    ] {
        reset(&mut uno);
        steps(&mut uno, 1);
        seen.push(working_register(&uno, 20));
    }
    assert_eq!(seen, [PORF, PORF | EXTRF, PORF, PORF | EXTRF, PORF | EXTRF]);
}

#[test]
fn power_up_leaves_nothing_in_ram_and_resets_the_pins() {
    let words = [sbi(DDRD, 6), sbi(PORTD, 6), push(16), HERE];
    let run = || {
        let mut uno = board(&words);
        uno.write_eeprom(5, &[6]).expect("EEPROM");
        uno.set_input(1, true);
        let mut contents = Vec::new();
        for _ in 0..3 {
            steps(&mut uno, 3);
            assert_eq!((uno.outputs(), uno.stack_peak()), (1, 1));
            let now = uno.cycles();
            uno.power_up();
            assert_eq!((uno.cycles(), uno.pc(), uno.stack_peak()), (now, 0, 0));
            assert_eq!(uno.outputs(), 0);
            let low = Edge {
                cycle: now,
                pin: Pin::Output(0),
                high: false,
            };
            assert_eq!(uno.edges().last(), Some(&low));
            contents.push(uno.read_ram(0x100, 0x800).expect("RAM").to_vec());
        }
        assert_eq!(uno.read_eeprom(5, 1).expect("EEPROM"), [6]);
        assert_eq!(uno.inputs(), 0b0010, "the button is still held");
        contents
    };
    let contents = run();
    assert_eq!(contents, run(), "the same in each run");
    let [first, second, third] = &contents[..] else {
        panic!("three")
    };
    for (one, other) in [(first, second), (second, third), (first, third)] {
        let alike = one.iter().zip(other).filter(|(a, b)| a == b).count();
        assert!(alike < 100, "{alike} of 2048 bytes are the same");
    }
}

#[test]
fn the_converter_measures_the_supply() {
    let mut uno = board(&[
        ldi(16, 0x4E), // against AVCC, the reference of 1.1 V
        sts(16),
        ADMUX,
        ldi(16, 0xC7), // on, start, divider 128
        sts(16),
        ADCSRA,
        lds(17), // 0x0C: until it is done
        ADCSRA,
        sbrc(17, 6),
        rjmp(-4),
        lds(20), // 0x14
        ADCL,
        lds(21),
        ADCH,
        rjmp(-12), // 0x1C: again
    ]);
    uno.run_until(0x1C, 100_000).expect("the first is wrong");
    for (mv, reading) in [
        (5000, 225),
        (4500, 250),
        (4310, 261),
        (4290, 262),
        (3300, 341),
        (1000, 1023),
        (5500, 204),
    ] {
        // At first it is 5 V by itself.
        if mv != 5000 {
            uno.set_supply(mv);
        }
        uno.run_until(0x1C, 100_000).expect("a conversion");
        let bytes = [working_register(&uno, 20), working_register(&uno, 21)];
        assert_eq!(u16::from_le_bytes(bytes), reading, "at {mv} mV");
    }
    uno.power_up();
    for _ in 0..2 {
        uno.run_until(0x1C, 100_000).expect("a conversion");
    }
    assert_eq!(working_register(&uno, 20), 204, "the supply is the same");
}

#[test]
fn the_switch_is_read_on_a5_with_its_pull_up() {
    let mut uno = board(&[
        sbi(PORTC, 5),
        sbi(PORTC, 0), // the loop: simavr raises the pull-ups again here
        input(17, PINC),
        rjmp(-3),
    ]);
    for closed in [false, true, false, true] {
        uno.set_stop(closed);
        steps(&mut uno, 8);
        assert_eq!(working_register(&uno, 17) >> 5 & 1 == 0, closed);
        assert_eq!((uno.stop(), uno.inputs()), (closed, 0));
    }
    for restart in [Uno::reset, Uno::power_up] {
        restart(&mut uno);
        steps(&mut uno, 8);
        assert_eq!(working_register(&uno, 17) >> 5 & 1, 0, "it is still closed");
    }
}

#[test]
fn a_stall_can_be_put_into_the_program() {
    let mut uno = board(&[NOP, NOP, rjmp(-3)]);
    uno.run_cycles(100).expect("it goes round");
    let there = uno.read_flash(2, 2).expect("the program");
    assert_eq!(there, NOP.to_le_bytes());
    uno.patch_flash(2, &STALL).expect("the program");
    let place = "0x0002".to_owned();
    assert_eq!(uno.run_cycles(100), Err(Halt::Hung { place }));
    uno.patch_flash(2, &there).expect("the program");
    uno.reset();
    assert_eq!(uno.run_cycles(100), Ok(()));

    assert_eq!(STALL, HERE.to_le_bytes());
    assert_eq!(uno.read_flash(0, 6).expect("all").len(), 6);
    for (address, len) in [(5, 2), (6, 1), (u32::MAX, 2)] {
        let refused = uno.patch_flash(address, &STALL[..len]);
        assert!(matches!(
            refused,
            Err(Error::OutOfRange {
                memory: "program",
                ..
            })
        ));
    }
}
