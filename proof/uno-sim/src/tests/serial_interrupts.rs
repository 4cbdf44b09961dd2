//! The serial port: its interrupts and their flags.

use super::assembly::*;
use super::serial::{AT_9600, AT_115200, BOTH, FORM_8N1, set_up};
use super::{board, working_register};
use crate::{Line, Parity, Uno};

/// A board with this program, and these handlers of interrupts, which count at 0x200.
fn counting(control: u16, divider: u16, handlers: &[(usize, &[u16])]) -> Uno {
    let mut main = vec![ldi(20, 0), ldi(21, 0), ldi(22, 0)];
    main.extend(set_up(divider, FORM_8N1, BOTH | control));
    main.extend([SEI, HERE]);
    board(&with_interrupts(&main, handlers))
}

/// Runs until working register `r` has become `value`; when that was.
fn when(uno: &mut Uno, r: u32, value: u8) -> u64 {
    let limit = uno.cycles() + 1_000_000;
    while working_register(uno, r) != value {
        uno.step().expect("the program goes on");
        assert!(uno.cycles() < limit, "r{r} never becomes {value}");
    }
    uno.cycles()
}

#[test]
fn the_receive_interrupt_comes_in_the_stop_bit_and_as_long_as_there_is_something() {
    for ((divider, bit), baud) in [(AT_115200, 115_200), (AT_9600, 9600)] {
        let mut uno = counting(
            1 << 7, // RXCIE
            divider,
            &[(USART_RX, &[inc(20), lds(18), UDR0, RETI])],
        );
        uno.set_serial_line(Line {
            baud,
            parity: Parity::None,
        });
        uno.run_cycles(100).expect("it waits");
        let start = uno.cycles();
        let end = uno.send_serial(b"ab");
        let apart = (end - start) / 2;
        for (n, byte) in [(1, b'a'), (2, b'b')] {
            let there = start + (u64::from(n) - 1) * apart + 9 * bit + bit / 2;
            let delay = when(&mut uno, 20, n) - there;
            // rjmp, the way to the vector (4 on the chip, 0 to 4 in simavr), rjmp, inc.
            assert!((3..=10).contains(&delay), "{delay}");
            uno.run_cycles(10).expect("it goes on");
            assert_eq!(working_register(&uno, 18), byte);
        }
        uno.run_ms(1).expect("it waits");
        assert_eq!(working_register(&uno, 20), 2, "once for each");
    }
    // Enabled late, it comes at once for each of the three that stand in the port.
    let mut main = set_up(AT_115200.0, FORM_8N1, BOTH);
    main.extend([ldi(20, 0), ldi(21, 240), ldi(22, 0)]);
    main.extend([inc(22), brne(-2), inc(21), brne(-4)]); // 12 × 768 cycles and more
    main.extend([ldi(16, 0x98), sts(16), UCSR0B, SEI, HERE]);
    let handler = [inc(20), lds(18), UDR0, RETI];
    let mut uno = board(&with_interrupts(&main, &[(USART_RX, &handler)]));
    let end = uno.send_serial_at(200, b"abc");
    let first = when(&mut uno, 20, 1);
    assert!(first > end + 5000);
    let took = when(&mut uno, 20, 3) - first;
    assert!(took < 40, "{took}");
    uno.run_cycles(100).expect("it waits");
    assert_eq!(
        (working_register(&uno, 20), working_register(&uno, 18)),
        (3, b'c')
    );
}

#[test]
fn the_transmitter_buffers_a_byte_and_tells_once_that_all_has_gone() {
    for (divider, bit) in [AT_115200, AT_9600] {
        let mut uno = counting(
            1 << 5 | 1 << 6, // UDRIE and TXCIE
            divider,
            &[
                (
                    USART_UDRE,
                    &[
                        inc(20),
                        sts(20),
                        UDR0,
                        sbrs(20, 2), // the fourth is the last
                        RETI,
                        ldi(16, 0x58), // without UDRIE
                        sts(16),
                        UCSR0B,
                        RETI,
                    ],
                ),
                (USART_TX, &[inc(21), RETI]),
            ],
        );
        let told = when(&mut uno, 21, 1);
        let log = uno.serial_log();
        let bytes: Vec<u8> = log.iter().map(|sent| sent.byte).collect();
        assert_eq!(bytes, [1, 2, 3, 4]);
        let first = log[0].written;
        assert!(log[1].written - first < 30, "there is room for the second");
        for (n, sent) in (0..).zip(log) {
            assert_eq!(sent.start, first + n * 10 * bit);
            assert_eq!(sent.end, sent.start + 10 * bit);
            if n > 1 {
                let late = sent.written - log[n as usize - 1].start;
                assert!(late < 15, "as soon as the one before has begun: {late}");
            }
        }
        let late = told - log[3].end;
        assert!((3..=10).contains(&late), "{late}");
        uno.run_ms(5).expect("it waits");
        assert_eq!(working_register(&uno, 21), 1);
        assert_eq!(uno.serial_bytes().len(), 4);
    }
}

#[test]
fn the_flags_of_the_transmitter_can_be_polled() {
    let mut words = set_up(AT_115200.0, FORM_8N1, BOTH);
    words.extend([
        lds(16), // 15: UDRE and not TXC
        UCSR0A,
        sts(20), // 17: goes into the shift register
        UDR0,
        lds(17), // 19
        UCSR0A,
        sts(20), // 21: into the buffer
        UDR0,
        lds(18), // 23
        UCSR0A,
        sts(20), // 25: is ignored
        UDR0,
        lds(19), // 27: the loop
        UCSR0A,
        sbrs(19, 6), // TXC
        rjmp(-4),
        sts(19), // 31: clears it
        UCSR0A,
        lds(20),
        UCSR0A,
        HERE,
    ]);
    let mut uno = board(&words);
    assert!(uno.run_ms(1).is_err(), "it ends");
    let flags = [16, 17, 18, 19, 20].map(|r| working_register(&uno, r) & 0xE0);
    assert_eq!(flags, [0x20, 0x20, 0x00, 0x60, 0x20]);
    assert_eq!(uno.serial_bytes().len(), 2);
}
