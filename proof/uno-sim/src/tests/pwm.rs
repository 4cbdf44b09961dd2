//! Pulse-width modulation of D6 and D9.

use super::assembly::*;
use super::{board, working_register};
use crate::{Edge, Pin, Pwm};

fn write(register: u16, value: u16) -> [u16; 3] {
    [ldi(16, value), sts(16), register]
}

#[test]
fn d6_has_its_pulses_from_timer_0() {
    for (control_a, control_b, compare, expected) in [
        (0x83, 0x03, 63, Some((64 * 64, 256 * 64))),
        (0x83, 0x03, 255, Some((256 * 64, 256 * 64))),
        (0x83, 0x01, 0, Some((1, 256))),
        (0xC3, 0x02, 63, Some((192 * 8, 256 * 8))),
        (0x03, 0x03, 63, None), // not connected
        (0x83, 0x00, 63, None), // no clock
        (0x81, 0x03, 63, None), // another mode
        (0x83, 0x0B, 63, None),
    ] {
        let mut words = vec![sbi(DDRD, 6)];
        for (io, value) in [(OCR0A, compare), (TCCR0A, control_a), (TCCR0B, control_b)] {
            words.extend([ldi(16, value), out(io, 16)]);
        }
        words.extend([SEI, HERE]);
        let mut uno = board(&words);
        uno.run_ms(3).expect("it waits");
        let expected = expected.map(|(high, period)| Pwm { high, period });
        assert_eq!(uno.pwm(0), expected, "{control_a:#x} {control_b:#x}");
        assert_eq!([1, 2, 3, 4].map(|index| uno.pwm(index)), [None; 4]);
        assert_eq!((uno.outputs(), uno.edges()), (0, &[][..]));
        let port = uno.read_ram(0x2B, 1).expect("PORTD")[0];
        assert_eq!(port, 0, "the program's own level stays");
    }
    let pwm = Pwm {
        high: 64,
        period: 256,
    };
    assert_eq!(pwm.duty(), 0.25);
}

#[test]
fn d9_has_its_pulses_beside_the_clock_of_timer_1() {
    // As the millisecond clock has it: mode 14, 2000 counts of 8 cycles, an interrupt at the end of each.
    let mut main = vec![ldi(20, 0), sbi(DDRB, 1)];
    main.extend(
        [
            write(ICR1H, 0x07),
            write(ICR1L, 0xCF),
            write(OCR1AH, 0x01),
            write(OCR1AL, 0xF3),
            write(TCCR1A, 0x02),
            write(TCCR1B, 0x1A),
            write(TIMSK1, 0x01),
        ]
        .concat(),
    );
    // The loop: OCR1AL and COM1A as 0x200 and 0x201 say.
    main.extend([
        SEI,
        lds(16),
        0x200,
        sts(16),
        OCR1AL,
        lds(16),
        0x201,
        sts(16),
        TCCR1A,
        rjmp(-9),
    ]);
    let handler = [inc(20), RETI];
    let mut uno = board(&with_interrupts(&main, &[(TIMER1_OVF, &handler)]));
    uno.write_ram(0x200, &[0xF3, 0x02]).expect("RAM");
    uno.run_ms(1).expect("it goes on");
    assert_eq!(uno.pwm(3), None);

    let mut ticks = Vec::new();
    for (low, control_a, expected) in [
        (0xF3, 0x82, Some(0x1F4)),
        (0x00, 0x82, Some(0x101)),
        (0xFF, 0x82, Some(0x200)),
        (0x80, 0xC2, Some(2000 - 0x181)),
        (0x80, 0x02, None),
    ] {
        uno.write_ram(0x200, &[low, control_a]).expect("RAM");
        for _ in 0..3 {
            let count = working_register(&uno, 20);
            while working_register(&uno, 20) == count {
                uno.step().expect("it goes on");
            }
            ticks.push(uno.cycles());
        }
        let expected = expected.map(|high: u64| Pwm {
            high: 8 * high,
            period: 16_000,
        });
        assert_eq!(uno.pwm(3), expected);
    }
    for pair in ticks.windows(2) {
        assert!(pair[1].abs_diff(pair[0] + 16_000) < 6, "{ticks:?}");
    }
    let first = ticks[0];
    let last = ticks[ticks.len() - 1];
    assert!(
        last.abs_diff(first + 14 * 16_000) < 6,
        "the clock does not drift"
    );
    assert_eq!((uno.outputs(), uno.edges()), (0, &[][..]));
    // Nor after a reset, at which simavr connects its timers again.
    uno.reset();
    uno.write_ram(0x201, &[0x82]).expect("RAM");
    uno.run_ms(5).expect("it goes on");
    assert!(uno.pwm(3).is_some());
    assert_eq!((uno.outputs(), uno.edges()), (0, &[][..]));
}

#[test]
fn the_direction_of_the_driver_is_seen_on_a4() {
    const DDRC: u16 = 0x07;
    let mut uno = board(&[
        sbi(PORTC, 4), // a pull-up only
        sbi(DDRC, 4),
        cbi(PORTC, 4),
        HERE,
    ]);
    assert!(uno.run_cycles(100).is_err(), "it ends");
    assert!(!uno.direction());
    let edge = |cycle, high| Edge {
        cycle,
        pin: Pin::Direction,
        high,
    };
    assert_eq!(uno.edges(), [edge(4, true), edge(6, false)]);
}
