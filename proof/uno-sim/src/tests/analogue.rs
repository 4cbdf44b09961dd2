//! The converter: what it reads, and when; and the inputs on its pins.

use super::assembly::*;
use super::{board, steps, working_register};
use crate::{Analogue, Uno};

/// ADMUX: against AVCC.
const AVCC: u16 = 0x40;
/// ADMUX: the chip's own reference, against AVCC.
const REFERENCE: u16 = 0x4E;
/// ADCSRA: on, a conversion, free running, interrupt, divider 128.
const ON: u16 = 0x87;
const START: u16 = 0x40;
const FREE: u16 = 0x20;
const INTERRUPT: u16 = 0x08;
/// Cycles of a conversion at the divider 128, and of the first.
const CONVERSION: u64 = 13 * 128;
const FIRST: u64 = 25 * 128;

fn write(register: u16, value: u16) -> [u16; 3] {
    [ldi(16, value), sts(16), register]
}

/// A board that converts, one after the other, the channels whose ADMUX stands at 0x200 and on: each at a call of
/// [`convert`].
fn converter() -> Uno {
    let words = [
        lds(16), // 0x00
        0x200,
        sts(16),
        ADMUX,
        ldi(16, ON | START), // 0x08
        sts(16),
        ADCSRA,
        lds(17), // 0x0E: until it is done
        ADCSRA,
        sbrc(17, 6),
        rjmp(-4),
        lds(20), // 0x16
        ADCL,
        lds(21),
        ADCH,
        rjmp(-16), // 0x1E
    ];
    board(&words)
}

/// One conversion; the result.
fn convert(uno: &mut Uno, mux: u16) -> u16 {
    uno.write_ram(0x200, &[mux as u8]).expect("RAM");
    uno.run_until(0x1E, 10_000).expect("a conversion");
    result(uno)
}

fn result(uno: &Uno) -> u16 {
    u16::from_le_bytes([working_register(uno, 20), working_register(uno, 21)])
}

#[test]
fn each_input_reads_what_it_is_connected_to() {
    let mut uno = converter();
    let all = [0, 1, 2, 3, 4].map(|channel| AVCC | channel);
    assert_eq!(all.map(|mux| convert(&mut uno, mux)), [0; 5], "open");
    for (index, analogue) in [
        Analogue::Millivolts(0),
        Analogue::Millivolts(2500),
        Analogue::Millivolts(6000),
        Analogue::Reading(1),
        Analogue::Reading(1022),
    ]
    .into_iter()
    .enumerate()
    {
        uno.set_analogue(index, analogue);
    }
    let read = all.map(|mux| convert(&mut uno, mux));
    assert_eq!(read, [0, 512, 1023, 1, 1022]);
    uno.set_supply(4000);
    let read = all.map(|mux| convert(&mut uno, mux));
    assert_eq!(
        read,
        [0, 640, 1023, 1, 1022],
        "a voltage stays, a part does not"
    );
    for reading in [0, 511, 1023] {
        uno.set_analogue(4, Analogue::Reading(reading));
        assert_eq!(convert(&mut uno, AVCC | 4), reading);
    }
    // Against 1.1 V, ground, and to the left.
    uno.set_analogue(0, Analogue::Millivolts(550));
    assert_eq!(convert(&mut uno, 0xC0), 512);
    assert_eq!(convert(&mut uno, AVCC | 15), 0);
    uno.set_analogue(0, Analogue::Reading(0x155));
    assert_eq!(convert(&mut uno, AVCC | 1 << 5), 0x5540);
    // A button that is closed.
    uno.set_input(4, true);
    assert_eq!(convert(&mut uno, AVCC), 0);
    uno.set_input(4, false);
    assert_eq!(convert(&mut uno, AVCC), 0x155);
    uno.set_analogue(0, Analogue::Open);
    assert_eq!(convert(&mut uno, AVCC), 0);
}

#[test]
fn the_reference_takes_one_conversion_to_come() {
    let mut uno = converter();
    uno.set_analogue(0, Analogue::Millivolts(5000));
    let reads = [AVCC, REFERENCE, REFERENCE, AVCC, REFERENCE, REFERENCE];
    let reads = reads.map(|mux| convert(&mut uno, mux));
    // 3050 mV.
    let between = 624;
    assert_eq!(reads, [1023, between, 225, 1023, between, 225]);
}

#[test]
fn a_conversion_takes_13_clocks_and_the_first_25() {
    let mut uno = converter();
    uno.write_ram(0x200, &[AVCC as u8]).expect("RAM");
    for clocks in [FIRST, CONVERSION, CONVERSION] {
        uno.run_until(0x08, 10_000).expect("a conversion");
        let start = uno.cycles();
        uno.run_until(0x16, 10_000).expect("a conversion");
        // The clock that it begins with is up to 128 cycles away, except for the first; the loop sees the end late.
        let took = uno.cycles() - start;
        let wait = if clocks == FIRST { 0 } else { 128 };
        assert!((clocks..clocks + wait + 12).contains(&took), "{took}");
    }
}

/// A board that converts as its ADCSRA says, and counts interrupts of the converter in r22 where it reads the result.
fn interrupted(mux: u16, control: u16) -> Uno {
    let mut main = vec![ldi(22, 0)];
    main.extend(write(ADMUX, mux));
    main.extend(write(ADCSRA, control));
    main.extend([
        SEI,
        lds(16), // the loop
        0x200,
        sts(16),
        ADMUX,
        rjmp(-5),
    ]);
    let handler = [lds(20), ADCL, lds(21), ADCH, inc(22), RETI];
    let mut uno = board(&with_interrupts(&main, &[(ADC_DONE, &handler)]));
    uno.write_ram(0x200, &[mux as u8]).expect("RAM");
    steps(&mut uno, 2);
    uno
}

/// Runs until the next interrupt; when it was.
fn next(uno: &mut Uno) -> u64 {
    let count = working_register(uno, 22);
    let limit = uno.cycles() + 10_000;
    while working_register(uno, 22) == count {
        uno.step().expect("it goes on");
        assert!(uno.cycles() < limit, "no interrupt comes");
    }
    uno.cycles()
}

#[test]
fn free_running_goes_on_without_a_gap_and_takes_a_channel_when_it_begins() {
    let mut uno = interrupted(AVCC, ON | START | FREE | INTERRUPT);
    for index in 0..3 {
        uno.set_analogue(index, Analogue::Reading(100 * (index as u16 + 1)));
    }
    let mut last = next(&mut uno);
    for _ in 0..5 {
        let now = next(&mut uno);
        assert!((now - last).abs_diff(CONVERSION) < 10, "{}", now - last);
        assert_eq!(result(&uno), 100);
        last = now;
    }
    for channel in [1, 2, 0] {
        let before = result(&uno);
        uno.run_cycles(500).expect("a conversion is going on");
        uno.write_ram(0x200, &[(AVCC | channel) as u8])
            .expect("RAM");
        next(&mut uno);
        assert_eq!(result(&uno), before, "it had begun before");
        next(&mut uno);
        assert_eq!(result(&uno), 100 * (channel + 1));
    }
    // The voltage is taken 1.5 clocks from the start.
    next(&mut uno);
    uno.run_cycles(400).expect("it has been taken");
    uno.set_analogue(0, Analogue::Reading(7));
    next(&mut uno);
    assert_eq!(result(&uno), 100);
    next(&mut uno);
    assert_eq!(result(&uno), 7);
}

#[test]
fn a_single_conversion_asks_for_its_interrupt_once() {
    let mut uno = interrupted(AVCC, ON | START | INTERRUPT);
    let end = next(&mut uno);
    assert!((FIRST..FIRST + 50).contains(&end), "{end}");
    uno.run_ms(2).expect("it goes on");
    assert_eq!(working_register(&uno, 22), 1);
    let control = uno.read_ram(u32::from(ADCSRA), 1).expect("a register")[0];
    assert_eq!(u16::from(control), ON | INTERRUPT, "neither ADSC nor ADIF");
}

#[test]
fn a_result_is_held_while_half_of_it_is_read() {
    let mut words = [write(ADMUX, AVCC), write(ADCSRA, ON | START | FREE)].concat();
    words.extend([
        ldi(18, 0),
        dec(18), // the loop
        brne(-2),
        lds(20), // 0x12
        ADCL,
        lds(18), // 0x16: until there is a 1 at 0x200
        0x200,
        sbrs(18, 0),
        rjmp(-4),
        lds(21), // 0x1E
        ADCH,
        lds(22),
        ADCL,
        lds(23),
        ADCH,
        HERE,
    ]);
    let mut uno = board(&words);
    uno.write_ram(0x200, &[0]).expect("RAM");
    uno.set_analogue(0, Analogue::Reading(0x155));
    // The first conversion is not over as ADCL is read, so what is held is 0.
    uno.run_ms(1).expect("it waits");
    uno.write_ram(0x200, &[1]).expect("RAM");
    assert!(uno.run_ms(1).is_err(), "it ends");
    let halves = [20, 21, 22, 23].map(|r| working_register(&uno, r));
    assert_eq!(halves, [0, 0, 0, 0]);
    assert_eq!(
        uno.read_ram(u32::from(ADMUX), 1).expect("a register"),
        [0x40]
    );
}

#[test]
fn eight_inputs_are_read_with_pull_ups() {
    let mut uno = board(&[
        ldi(16, 0x3C),
        out(PORTD, 16),
        ldi(16, 0x0F),
        out(PORTC, 16),
        sbi(PORTC, 0), // the loop: simavr raises the pull-ups again here
        input(17, PIND),
        input(18, PINC),
        rjmp(-4),
    ]);
    let read = |uno: &mut Uno| {
        steps(uno, 12);
        let (d, c) = (working_register(uno, 17), working_register(uno, 18));
        !d >> 2 & 0x0F | !c << 4
    };
    for closed in [0, 0xFF, 0b0101_1010, 0b1000_0000, 0b0001_0000, 0] {
        uno.set_inputs(closed);
        assert_eq!(read(&mut uno), closed);
        assert_eq!(uno.inputs(), closed);
    }
    for index in 0..8 {
        uno.set_input(index, true);
        assert_eq!(read(&mut uno), 1 << index);
        uno.set_stop(true);
        assert_eq!(read(&mut uno), 1 << index, "A5 is another pin");
        uno.set_stop(false);
        uno.set_input(index, false);
    }
    // A voltage has a level too.
    uno.set_analogue(1, Analogue::Millivolts(1000));
    uno.set_analogue(2, Analogue::Millivolts(4000));
    assert_eq!(read(&mut uno), 1 << 5);
    uno.set_analogue(1, Analogue::Open);
    assert_eq!(read(&mut uno), 0);
}
