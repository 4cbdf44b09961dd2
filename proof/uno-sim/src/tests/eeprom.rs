//! The EEPROM: the time of a write, and what a power cut leaves of it.

use super::assembly::*;
use super::{board, steps, working_register};
use crate::{EEPROM_WRITE_CYCLES, EepromWrite, Halt, Uno};

/// Bits of EECR.
const EERE: u16 = 0;
const EEPE: u16 = 1;
const EEMPE: u16 = 2;

/// Puts address and data into their registers.
fn select(address: u16, data: u16) -> [u16; 6] {
    [
        ldi(16, address & 0xFF),
        out(EEARL, 16),
        ldi(16, address >> 8),
        out(EEARH, 16),
        ldi(16, data),
        out(EEDR, 16),
    ]
}

const START: [u16; 2] = [sbi(EECR, EEMPE), sbi(EECR, EEPE)];
const WAIT: [u16; 2] = [sbic(EECR, EEPE), rjmp(-2)];

/// Writes bytes one after the other, waits for each, and stops.
fn writer(bytes: &[(u16, u16)]) -> Vec<u16> {
    let mut words = Vec::new();
    for &(address, data) in bytes {
        words.extend(select(address, data));
        words.extend(START);
        words.extend(WAIT);
    }
    words.push(HERE);
    words
}

fn eeprom(uno: &Uno, address: u16) -> u8 {
    uno.read_eeprom(address, 1).expect("an address")[0]
}

fn to_the_end(uno: &mut Uno) {
    assert!(matches!(uno.run_ms(100), Err(Halt::Hung { .. })));
}

#[test]
fn a_byte_takes_its_time_in_every_mode() {
    const BEFORE: u8 = 0b1100_1010;
    const DATA: u8 = 0b1010_0110;
    for (mode, cycles, after) in [
        (0, 54_400, DATA),
        (1, 28_800, 0xFF),
        (2, 28_800, BEFORE & DATA),
    ] {
        let mut words = vec![ldi(16, mode << 4), out(EECR, 16)];
        words.extend(select(0x3FE, DATA.into()));
        words.extend(START);
        words.push(input(20, EECR));
        words.extend(WAIT);
        words.extend([input(21, EECR), HERE]);
        let mut uno = board(&words);
        uno.write_eeprom(0x3FE, &[BEFORE]).expect("EEPROM");

        steps(&mut uno, 9);
        let start = uno.cycles();
        steps(&mut uno, 1);
        assert_eq!(uno.cycles(), start + 4, "sbi, and the CPU stands for two");
        uno.run_cycles(cycles - 5).expect("it waits");
        assert_eq!(eeprom(&uno, 0x3FE), BEFORE, "mode {mode}: not yet");
        assert_eq!(uno.eeprom_writes(), []);
        to_the_end(&mut uno);
        assert_eq!(eeprom(&uno, 0x3FE), after, "mode {mode}");
        let write = EepromWrite {
            cycle: start + cycles,
            address: 0x3FE,
            before: BEFORE,
            after,
        };
        assert_eq!(uno.eeprom_writes(), [write], "mode {mode}");
        let over = uno.cycles() - write.cycle;
        assert!(over < 10, "mode {mode}: EEPE is seen {over} cycles late");
        let mode = u8::try_from(mode << 4).expect("two bits");
        assert_eq!(working_register(&uno, 20), mode | 1 << EEPE);
        assert_eq!(working_register(&uno, 21), mode);
    }

    let mut words = vec![ldi(16, 3 << 4), out(EECR, 16)];
    words.extend(writer(&[(0, 0)]));
    let mut uno = board(&words);
    to_the_end(&mut uno);
    assert_eq!(uno.eeprom_writes(), [], "a mode that does not exist");
}

#[test]
fn a_byte_that_is_being_written_keeps_the_rest_waiting() {
    let mut words = Vec::from(select(0x10, 1));
    words.extend(START);
    words.extend(select(0x120, 2));
    words.extend(START);
    words.extend([sbi(EECR, EERE), input(20, EEDR), input(21, EEARL)]);
    words.extend(WAIT);
    words.extend([sbi(EECR, EERE), input(22, EEDR), HERE]);
    let mut uno = board(&words);
    to_the_end(&mut uno);
    let [write] = uno.eeprom_writes() else {
        panic!("{:?}", uno.eeprom_writes())
    };
    assert_eq!((write.address, write.before, write.after), (0x10, 0xFF, 1));
    assert_eq!(working_register(&uno, 20), 2, "nothing was read");
    assert_eq!(working_register(&uno, 21), 0x10, "EEAR is kept");
    assert_eq!(working_register(&uno, 22), 1, "read when it was over");
    assert!(uno.cycles() < EEPROM_WRITE_CYCLES + 50, "one write only");
}

#[test]
fn reading_takes_what_is_there() {
    let mut words = Vec::from(select(0x123, 0));
    words.extend([sbi(EECR, EERE), input(20, EEDR), input(21, EECR), HERE]);
    let mut uno = board(&words);
    uno.write_eeprom(0x122, &[1, 2, 3]).expect("EEPROM");
    steps(&mut uno, 6);
    let start = uno.cycles();
    steps(&mut uno, 1);
    assert_eq!(uno.cycles(), start + 6, "sbi, and the CPU stands for four");
    to_the_end(&mut uno);
    assert_eq!(
        (working_register(&uno, 20), working_register(&uno, 21)),
        (2, 0)
    );
}

#[test]
fn a_write_must_be_enabled_just_before() {
    for (name, start, written) in [
        ("at once", &START[..], 1),
        ("a cycle later", &[START[0], NOP, START[1]], 1),
        ("too late", &[START[0], NOP, NOP, START[1]], 0),
        ("never", &[START[1]], 0),
        ("both bits at once", &[ldi(16, 6), out(EECR, 16)], 0),
    ] {
        let mut words = Vec::from(select(0, 0));
        words.extend(start);
        words.extend(WAIT);
        words.push(HERE);
        let mut uno = board(&words);
        to_the_end(&mut uno);
        assert_eq!(uno.eeprom_writes().len(), written, "{name}");
    }
}

#[test]
fn a_reset_does_not_break_a_write_off() {
    // After the button it only waits.
    let mut words = vec![input(20, MCUSR), sbrc(20, 1), rjmp(8)];
    words.extend(select(7, 0x55));
    words.extend(START);
    words.extend(WAIT);
    words.push(HERE);
    let mut uno = board(&words);
    uno.run_cycles(30_000).expect("it waits");
    uno.reset();
    assert_eq!(eeprom(&uno, 7), 0xFF);
    to_the_end(&mut uno);
    assert_eq!((eeprom(&uno, 7), uno.resets()), (0x55, 1));
    let [write] = uno.eeprom_writes() else {
        panic!("{:?}", uno.eeprom_writes())
    };
    let start = write.cycle - EEPROM_WRITE_CYCLES;
    assert!(start < 20, "it has begun before the reset: {start}");
    assert!(uno.cycles() - write.cycle < 10, "and is waited for");
}

#[test]
fn a_write_ends_though_the_program_does_not_wait() {
    let mut words = Vec::from(select(0, 3));
    words.extend(START);
    words.push(HERE);
    let mut uno = board(&words);
    to_the_end(&mut uno);
    assert_eq!(eeprom(&uno, 0), 3);
}

#[test]
fn the_power_goes_at_any_write() {
    const BYTES: [(u16, u16); 3] = [(0, 0x11), (0x3FF, 0x22), (0, 0x33)];
    let words = [&[sbi(DDRD, 6), sbi(PORTD, 6)][..], &writer(&BYTES)].concat();
    let mut cuts = 0;
    for nth in 1..=BYTES.len() {
        for during in [false, true] {
            let case = format!("write {nth}, during {during}");
            let mut uno = board(&words);
            if during {
                uno.cut_power_during_eeprom_write(nth);
            } else {
                uno.cut_power_after_eeprom_write(nth);
            }
            assert_eq!(uno.run_ms(100), Err(Halt::PowerCut), "{case}");
            let cut = uno.cycles();
            assert_eq!(uno.outputs(), 0, "{case}: no power, no output");

            let mut expected = [0xFF; 0x400];
            for &(address, data) in &BYTES[..nth] {
                expected[usize::from(address)] = data as u8;
            }
            if during {
                expected[usize::from(BYTES[nth - 1].0)] = 0xFF;
            }
            assert_eq!(uno.read_eeprom(0, 0x400).expect("all"), expected, "{case}");
            assert_eq!(uno.eeprom_writes().len(), nth, "{case}");
            let last = uno.eeprom_writes()[nth - 1];
            assert_eq!(last.after, expected[usize::from(last.address)], "{case}");
            assert!(cut - last.cycle < 4, "{case}: at {last:?}, cut at {cut}");
            let whole = EEPROM_WRITE_CYCLES * nth as u64;
            let half = if during { EEPROM_WRITE_CYCLES / 2 } else { 0 };
            assert!((whole - half..whole - half + 100).contains(&cut), "{case}");

            uno.reset();
            assert_eq!(uno.step(), Err(Halt::PowerCut), "{case}: a button");
            uno.power_up();
            assert_eq!((uno.pc(), uno.cycles(), uno.resets()), (0, cut, 0));
            to_the_end(&mut uno);
            assert_eq!(uno.eeprom_writes().len(), nth + BYTES.len(), "{case}");
            assert_eq!((eeprom(&uno, 0), eeprom(&uno, 0x3FF)), (0x33, 0x22));
            cuts += 1;
        }
    }
    assert_eq!(cuts, 6);
}

#[test]
fn power_that_goes_by_itself_leaves_a_byte_erased() {
    let mut uno = board(&writer(&[(0, 0x11), (1, 0x22)]));
    uno.write_eeprom(0, &[0xAA, 0xBB]).expect("EEPROM");
    uno.run_cycles(EEPROM_WRITE_CYCLES + 1000)
        .expect("it waits");
    uno.power_up();
    assert_eq!(uno.read_eeprom(0, 2).expect("EEPROM"), [0x11, 0xFF]);
    // A cut that is asked for in the middle of a write does not count that one.
    uno.run_cycles(1000).expect("it waits");
    uno.cut_power_after_eeprom_write(1);
    assert_eq!(uno.run_ms(100), Err(Halt::PowerCut));
    let after: Vec<u8> = uno
        .eeprom_writes()
        .iter()
        .map(|write| write.after)
        .collect();
    assert_eq!(after, [0x11, 0xFF, 0x11, 0x22]);

    // One that has not come when the power goes is forgotten.
    uno.power_up();
    uno.cut_power_after_eeprom_write(2);
    uno.run_cycles(1000).expect("it waits");
    uno.power_up();
    to_the_end(&mut uno);
}

#[test]
fn the_wear_of_each_byte_is_counted() {
    let mut uno = board(&writer(&[(5, 1), (0x3FF, 2), (5, 1), (5, 3)]));
    uno.write_eeprom(0, &[0; 8]).expect("EEPROM");
    to_the_end(&mut uno);
    let wear = uno.eeprom_wear();
    assert_eq!((wear.len(), wear[5], wear[0x3FF]), (0x400, 3, 1));
    assert_eq!(wear.iter().sum::<u32>(), 4);
}

/// Time goes through a loop that only waits at once; a board that is asked for each instruction goes round by round. Both
/// are alike at every moment, with an interrupt that comes meanwhile.
#[test]
fn a_loop_that_only_waits_takes_its_cycles() {
    let loops: [&[u16]; 5] = [
        &[HERE],
        &WAIT,
        &[input(20, EECR), andi(20, 1 << EEPE), brne(-3)],
        &[input(20, EECR), andi(20, 1 << EEPE), cpi(20, 0), brne(-4)],
        &[input(20, EECR), NOP, andi(20, 1 << EEPE), brne(-4)],
    ];
    for wait in loops {
        for late in 0..6 {
            let mut main = vec![
                ldi(16, 1),
                sts(16),
                TIMSK1,
                sts(16),
                TCCR1B,
                ldi(26, 0),
                ldi(27, 2),
                SEI,
            ];
            main.extend(select(7, 1));
            main.extend(START);
            main.extend(vec![NOP; late]);
            main.extend(wait);
            main.push(HERE);
            let words = with_interrupts(&main, &[(TIMER1_OVF, &[st_x(16), RETI])]);
            let (mut quick, mut slow) = (board(&words), board(&words));
            quick.write_ram(0x200, &[0; 8]).expect("RAM");
            slow.write_ram(0x200, &[0; 8]).expect("RAM");
            let counted = |uno: &Uno| uno.read_ram(0x200, 8).expect("RAM").to_vec();
            for cycles in [100, 1, 2, 3, 7, 4_000, 30_000, 20_000, 20_000, 70_000] {
                quick.run_cycles(cycles).expect("it runs");
                while slow.cycles() < quick.cycles() {
                    slow.step().expect("it runs");
                }
                let case = format!("{wait:x?}, {late} cycles late, at {}", quick.cycles());
                assert_eq!(
                    (quick.cycles(), quick.pc()),
                    (slow.cycles(), slow.pc()),
                    "{case}"
                );
                assert_eq!(quick.eeprom_writes(), slow.eeprom_writes(), "{case}");
                assert_eq!(
                    working_register(&quick, 20),
                    working_register(&slow, 20),
                    "{case}"
                );
                assert_eq!(counted(&quick), counted(&slow), "{case}");
            }
            assert_eq!(quick.eeprom_writes().len(), 1);
            assert_eq!(counted(&quick), [1, 1, 0, 0, 0, 0, 0, 0], "two overflows");
        }
    }
}
