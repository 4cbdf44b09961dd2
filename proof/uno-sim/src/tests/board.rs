//! Pins, stack, ends of a program, memory and watchdog.

use super::assembly::*;
use super::{board, steps, working_register};
use crate::{Edge, Halt, Pin};

#[test]
fn edges_are_stamped_with_the_end_of_their_instruction() {
    let mut uno = board(&[
        sbi(PORTD, 6),  // cycles 0 to 2: a pull-up only
        sbi(DDRD, 6),   // 4
        sbi(DDRD, 7),   // 6: low
        sbi(PORTD, 7),  // 8
        cbi(DDRD, 6),   // 10: let go
        ldi(16, 0x23),  // 11
        out(DDRB, 16),  // 12
        out(PORTB, 16), // 13: outputs 2 and 3 and L at once
        ldi(16, 0x50),  // 14
        out(SPCR, 16),  // 15: the SPI takes D13
        sbi(PORTD, 0),  // 17: no output of ours
        HERE,
    ]);
    steps(&mut uno, 11);
    let edge = |cycle, pin, high| Edge { cycle, pin, high };
    assert_eq!(
        uno.edges(),
        [
            edge(4, Pin::Output(0), true),
            edge(8, Pin::Output(1), true),
            edge(10, Pin::Output(0), false),
            edge(13, Pin::Output(2), true),
            edge(13, Pin::Output(3), true),
            edge(13, Pin::Led, true),
            edge(15, Pin::Led, false),
        ]
    );
    assert_eq!(
        (uno.outputs(), uno.led(), uno.cycles()),
        (0b1110, false, 17)
    );
    assert_eq!(uno.take_edges().len(), 7);
    assert!(uno.edges().is_empty());
}

#[test]
fn buttons_are_read_with_pull_ups_and_survive_writes_to_the_port() {
    let mut uno = board(&[
        ldi(16, 0x3C),
        out(PORTD, 16),
        sbi(PORTD, 6), // the loop: simavr raises the pull-ups again here
        input(17, PIND),
        rjmp(-3),
    ]);
    for closed in [0b0000, 0b0001, 0b1010, 0b1111, 0b0100] {
        uno.set_inputs(closed);
        steps(&mut uno, 8);
        assert_eq!(!working_register(&uno, 17) >> 2 & 0x0F, closed);
        assert_eq!(uno.inputs(), closed);
    }
    uno.set_input(2, false);
    uno.set_input(0, true);
    steps(&mut uno, 8);
    assert_eq!(!working_register(&uno, 17) >> 2 & 0x0F, 0b0001);
    uno.reset();
    steps(&mut uno, 8);
    assert_eq!(
        !working_register(&uno, 17) >> 2 & 0x0F,
        0b0001,
        "the button is still held"
    );

    let mut uno = board(&[input(17, PIND), rjmp(-2)]);
    uno.set_input(1, true);
    uno.set_input(1, false);
    steps(&mut uno, 4);
    assert_eq!(
        !working_register(&uno, 17) >> 2 & 0x0F,
        0b1111,
        "no pull-up, no high level"
    );
}

#[test]
fn the_deepest_stack_is_found_though_sp_is_written_in_halves() {
    let mut uno = board(&[
        ldi(28, 0x01),
        ldi(29, 0x08),
        out(SPH, 29),
        out(SPL, 28), // SP = 0x801
        ldi(28, 0xF0),
        ldi(29, 0x07),
        out(SPH, 29), // 0x701 for a moment
        NOP,
        out(SPL, 28), // SP = 0x7F0
        push(16),     // 0x7EF
        ldi(29, 0x06),
        out(SPH, 29), // a frame of 256 bytes
        out(SPL, 28),
        HERE,
    ]);
    assert_eq!(
        (uno.sp(), uno.min_sp(), uno.stack_peak()),
        (0x8FF, 0x8FF, 0)
    );
    for (count, min) in [
        (4, 0x801),
        (3, 0x801),
        (1, 0x801),
        (1, 0x7F0),
        (1, 0x7EF),
        (2, 0x7EF),
        (1, 0x6F0),
    ] {
        steps(&mut uno, count);
        assert_eq!(uno.min_sp(), min, "at {:#x}", uno.pc());
    }
    assert_eq!(uno.stack_peak(), 0x8FF - 0x6F0);
    assert_eq!(uno.stack_free(), 0x6F1 - 0x100);
    uno.reset_min_sp();
    assert_eq!(uno.min_sp(), 0x6F0);
}

#[test]
fn a_program_that_ends_says_why_and_where() {
    let place = |pc: u32| format!("{pc:#06x}");
    for (words, halt) in [
        (&[NOP, HERE][..], Halt::Hung { place: place(2) }),
        (&[SLEEP, NOP], Halt::AsleepForEver { place: place(0) }),
        (
            &[NOP, 0x9404, NOP],
            Halt::InvalidOpcode {
                opcode: 0x9404,
                place: place(2),
            },
        ),
        (&[NOP, NOP], Halt::LeftCode { place: place(2) }),
        (&[rjmp(0x100)], Halt::LeftCode { place: place(0) }),
    ] {
        let mut uno = board(words);
        assert_eq!(uno.run_cycles(100), Err(halt.clone()), "{words:04x?}");
        let cycles = uno.cycles();
        assert_eq!(uno.step(), Err(halt.clone()), "it stays so");
        assert_eq!(uno.run_until(0, 100), Err(halt.clone()));
        assert_eq!(uno.cycles(), cycles, "time stands still");
        uno.reset();
        assert_eq!(uno.run_cycles(100), Err(halt), "a reset starts it again");
    }
}

#[test]
fn waiting_for_an_interrupt_is_no_end() {
    for words in [&[SEI, HERE][..], &[SEI, SLEEP, rjmp(-2)]] {
        let mut uno = board(words);
        assert_eq!(uno.run_cycles(100_000), Ok(()), "{words:04x?}");
        assert!(uno.cycles() >= 100_000);
    }
}

#[test]
fn a_run_stops_at_an_address_once_round_each_time() {
    let mut uno = board(&[NOP, NOP, rjmp(-2)]);
    assert_eq!(uno.run_until(2, 10), Ok(()));
    assert_eq!((uno.pc(), uno.cycles()), (2, 1));
    assert_eq!(uno.run_until(2, 10), Ok(()));
    assert_eq!((uno.pc(), uno.cycles()), (2, 4));
    let late = uno.run_until(0, 9);
    assert_eq!(
        late,
        Err(Halt::Timeout {
            cycles: 9,
            place: "0x0004".into()
        })
    );
    assert_eq!(uno.run_until(2, 10), Ok(()), "a timeout is no end");
}

#[test]
fn the_watchdog_resets_the_chip_and_time_goes_on() {
    let mut uno = board(&[
        sbi(DDRD, 6),
        sbi(PORTD, 6),
        ldi(16, 0x18), // WDCE and WDE
        sts(16),
        WDTCSR,
        ldi(16, 0x08), // WDE, 16 ms
        sts(16),
        WDTCSR,
        HERE,
    ]);
    assert_eq!(uno.run_ms(15), Ok(()));
    assert_eq!((uno.resets(), uno.outputs()), (0, 1));
    assert_eq!(uno.run_ms(2), Ok(()));
    assert_eq!((uno.resets(), uno.outputs()), (1, 1));
    assert!(uno.cycles() >= 17 * 16_000);
    let [on, off, on_again] = uno.edges() else {
        panic!("{:?}", uno.edges())
    };
    assert_eq!([on.high, off.high, on_again.high], [true, false, true]);
    // 2048 cycles of the watchdog's 128 kHz after it was set.
    assert!((256_000..256_020).contains(&off.cycle), "{off:?}");
    assert_eq!(on_again.cycle, off.cycle + on.cycle);
}

#[test]
fn the_reset_button_keeps_ram_and_eeprom() {
    let mut uno = board(&[sbi(DDRD, 6), sbi(PORTD, 6), HERE]);
    uno.write_ram(0x200, &[1, 2, 3]).expect("RAM");
    uno.write_eeprom(0x3FE, &[4, 5]).expect("EEPROM");
    steps(&mut uno, 2);
    uno.reset();
    assert_eq!(
        (uno.pc(), uno.cycles(), uno.resets(), uno.outputs()),
        (0, 4, 1, 0)
    );
    assert_eq!(
        uno.edges().last(),
        Some(&Edge {
            cycle: 4,
            pin: Pin::Output(0),
            high: false
        })
    );
    assert_eq!(uno.read_ram(0x200, 3).expect("RAM"), [1, 2, 3]);
    assert_eq!(uno.read_eeprom(0x3FE, 2).expect("EEPROM"), [4, 5]);
    assert_eq!(
        uno.read_ram(0x54, 1).expect("MCUSR")[0] & 0x02,
        0x02,
        "EXTRF"
    );
}

#[test]
fn memory_outside_the_chip_is_refused() {
    let mut uno = board(&[HERE]);
    assert!(uno.read_ram(0x8FF, 1).is_ok());
    assert!(uno.read_ram(0x8FF, 2).is_err());
    assert!(uno.read_ram(u32::MAX, usize::MAX).is_err());
    assert!(uno.write_ram(0x8FE, &[0, 0]).is_ok());
    assert!(uno.write_ram(0xFF, &[0]).is_err(), "a register");
    assert!(uno.write_ram(0x8FF, &[0, 0]).is_err());
    assert!(uno.read_eeprom(0x3FF, 2).is_err());
    assert!(uno.write_eeprom(0x400, &[0]).is_err());
    assert_eq!(
        uno.read_eeprom(0, 2).expect("EEPROM"),
        [0xFF, 0xFF],
        "as from the factory"
    );
    let ram = uno.read_ram(0x100, 0x800).expect("RAM");
    assert!(
        ram.iter().any(|&byte| byte != ram[0]),
        "RAM is not cleared at power-up"
    );
}
