//! The serial port: times on the line, its buffers and flaws.

use super::assembly::*;
use super::board;
use crate::{Flaw, Line, Parity, Uno};

/// Bits of UCSR0A.
const FE: u8 = 1 << 4;
const DOR: u8 = 1 << 3;
const UPE: u8 = 1 << 2;
/// UCSR0B: transmitter and receiver.
pub const BOTH: u16 = 0x18;
/// UCSR0C.
pub const FORM_8N1: u16 = 0x06;
const FORM_8E1: u16 = 0x26;
const FORM_8O1: u16 = 0x36;
/// UBRR0 with U2X, and the cycles of a bit.
pub const AT_115200: (u16, u64) = (16, 136);
pub const AT_9600: (u16, u64) = (207, 1664);

/// Sets the port up, with these bits of UCSR0B.
pub fn set_up(divider: u16, form: u16, control: u16) -> Vec<u16> {
    let registers = [
        (UBRR0H, divider >> 8),
        (UBRR0L, divider & 0xFF),
        (UCSR0A, 1 << 1), // U2X
        (UCSR0C, form),
        (UCSR0B, control),
    ];
    let write = |(register, value)| [ldi(16, value), sts(16), register];
    registers.into_iter().flat_map(write).collect()
}

/// A board whose program waits until there is something but 0 at 0x200, and then reads the port over and over while
/// there is something to read: UCSR0A and UDR0 go to 0x210 and on.
fn late_reader(divider: u16, form: u16) -> Uno {
    let mut words = set_up(divider, form, BOTH);
    words.extend([
        ldi(26, 0x10),
        ldi(27, 0x02),
        lds(16), // the loop
        0x200,
        inc(16),
        dec(16),
        breq(-5),
        lds(17),
        UCSR0A,
        sbrs(17, 7), // RXC
        rjmp(-9),
        lds(18),
        UDR0,
        st_x(17),
        st_x(18),
        rjmp(-14),
    ]);
    let mut uno = board(&words);
    uno.write_ram(0x200, &[0]).expect("RAM");
    uno.write_ram(0x210, &[0; 32]).expect("RAM");
    uno.run_cycles(100).expect("it waits");
    uno
}

/// Lets the program read now; the errors in UCSR0A and the byte of each character.
fn read(uno: &mut Uno, count: usize) -> Vec<(u8, u8)> {
    uno.write_ram(0x200, &[1]).expect("RAM");
    uno.run_cycles(1000).expect("it reads");
    let bytes = uno.read_ram(0x210, 2 * count + 1).expect("RAM");
    assert_eq!(bytes[2 * count], 0, "there is no more");
    let pairs = bytes.chunks_exact(2);
    pairs
        .map(|pair| (pair[0] & (FE | DOR | UPE), pair[1]))
        .collect()
}

/// A program that sends back what it receives.
fn echo(divider: u16, form: u16) -> Uno {
    board(&echo_program(divider, form))
}

pub fn echo_program(divider: u16, form: u16) -> Vec<u16> {
    let mut words = set_up(divider, form, BOTH);
    words.extend([
        lds(17), // the loop
        UCSR0A,
        sbrs(17, 7), // RXC
        rjmp(-4),
        lds(18),
        UDR0,
        sts(18),
        UDR0,
        rjmp(-9),
    ]);
    words
}

#[test]
fn the_line_goes_both_ways_at_its_rate() {
    let mut uno = echo(AT_115200.0, FORM_8N1);
    uno.run_cycles(100).expect("it goes on");
    let text: Vec<u8> = (0..200).collect();
    let start = uno.cycles();
    let end = uno.send_serial(&text);
    let took = end - start;
    assert_eq!(took, 200 * 1389);
    uno.run_cycles(took + 3000).expect("it goes on");
    assert_eq!(uno.serial_bytes(), text);
    let log = uno.serial_log();
    assert_eq!(log.len(), 200);
    for (n, sent) in log.iter().enumerate() {
        // A byte is there in the middle of its stop bit, as the program counts bits: 9.5 × 136 cycles.
        let there = start + Line::default().cycles(n as u64) + 9 * 136 + 68;
        let delay = sent.written - there;
        assert!(delay < 20, "byte {n}: {delay}");
        assert_eq!((sent.start, sent.end), (sent.written, sent.written + 1360));
    }
    assert_eq!(uno.take_serial(), text);
    assert_eq!(uno.serial(), "");
    uno.send_serial("água".as_bytes());
    uno.run_ms(1).expect("it goes on");
    assert_eq!(uno.serial(), "água");
    assert!(
        uno.serial_log()
            .iter()
            .all(|sent| sent.parity == Parity::None)
    );
}

#[test]
fn bytes_come_when_they_are_told_to() {
    let mut uno = echo(AT_9600.0, FORM_8E1);
    uno.set_serial_line(Line {
        baud: 9600,
        parity: Parity::Even,
    });
    let first = uno.send_serial_at(100_000, b"ab");
    // 11 bits of 1666.67 cycles each.
    assert_eq!(first, 100_000 + 2 * 18_333);
    let second = uno.send_serial_at(200_000, b"c");
    // Before the line is free.
    let third = uno.send_serial_at(150_000, b"d");
    assert_eq!(third - second, second - 200_000);
    uno.run_ms(20).expect("it goes on");
    assert_eq!(uno.serial(), "abcd");
    let there = 10 * AT_9600.1 + AT_9600.1 / 2;
    for (sent, start) in uno
        .serial_log()
        .iter()
        .zip([100_000, 118_333, 200_000, 218_333])
    {
        assert!(
            (0..20).contains(&(sent.written - start - there)),
            "{sent:?}"
        );
        assert_eq!(sent.end - sent.start, 11 * AT_9600.1);
        assert_eq!(sent.parity, Parity::Even);
    }
    let now = uno.cycles();
    assert_eq!(uno.take_serial_log().len(), 4);
    uno.send_serial(b"e");
    uno.run_cycles(there + 20).expect("it goes on");
    assert_eq!(uno.serial(), "e");
    assert_eq!(uno.take_serial_log().len(), 0, "it is going out");
    uno.run_cycles(11 * AT_9600.1).expect("it goes on");
    let [sent] = uno.take_serial_log()[..] else {
        panic!("one byte has gone out")
    };
    assert!(sent.byte == b'e' && sent.start > now && sent.end <= uno.cycles());
}

#[test]
fn what_is_not_read_in_time_is_lost() {
    for (sent, expected) in [
        (&b"ab"[..], &[(0, b'a'), (0, b'b')][..]),
        (b"abc", &[(0, b'a'), (0, b'b'), (0, b'c')]),
        (b"abcdefg", &[(0, b'a'), (0, b'b'), (DOR, b'g')]),
    ] {
        let mut uno = late_reader(AT_115200.0, FORM_8N1);
        uno.send_serial(sent);
        uno.run_ms(1).expect("it waits");
        assert_eq!(read(&mut uno, expected.len()), expected);
        // From then on nothing is missing.
        uno.write_ram(0x200, &[0]).expect("RAM");
        uno.send_serial(b"x");
        uno.run_ms(1).expect("it waits");
        assert_eq!(read(&mut uno, expected.len() + 1).last(), Some(&(0, b'x')));
    }
    // The start bit of the fourth has come as the first is read: the third is lost.
    let mut uno = late_reader(AT_115200.0, FORM_8N1);
    let end = uno.send_serial(b"abc");
    uno.send_serial_at(end + 1000, b"d");
    uno.run_cycles(end + 1200 - uno.cycles()).expect("it waits");
    assert_eq!(read(&mut uno, 2), [(0, b'a'), (0, b'b')]);
    uno.run_ms(1).expect("it goes on");
    assert_eq!(read(&mut uno, 3)[2], (DOR, b'd'));
}

#[test]
fn a_flawed_or_foreign_character_is_seen_to() {
    for (form, parity) in [
        (FORM_8N1, Parity::None),
        (FORM_8E1, Parity::Even),
        (FORM_8O1, Parity::Odd),
    ] {
        let mut uno = late_reader(AT_115200.0, form);
        uno.set_serial_line(Line {
            parity,
            ..Line::default()
        });
        uno.send_serial(&[0x57]);
        let start = uno.cycles();
        let end = uno.send_serial_flawed(&[0x57], Flaw::Framing);
        let line = uno.serial_line();
        assert_eq!(end - start, line.cycles(2));
        // Without a gap there would be no edge to its start bit.
        uno.send_serial_at(end + 200, &[0x60]);
        uno.run_ms(1).expect("it waits");
        assert_eq!(read(&mut uno, 3), [(0, 0x57), (FE, 0x57), (0, 0x60)]);

        let mut uno = late_reader(AT_115200.0, form);
        uno.set_serial_line(Line {
            parity,
            ..Line::default()
        });
        uno.send_serial_flawed(&[0x57], Flaw::Parity);
        uno.run_ms(1).expect("it waits");
        let flawed = match parity {
            Parity::None => (0, 0xD7),
            _ => (UPE, 0x57),
        };
        assert_eq!(read(&mut uno, 1), [flawed]);
    }
    // The other parity.
    let mut uno = late_reader(AT_115200.0, FORM_8E1);
    uno.set_serial_line(Line {
        parity: Parity::Odd,
        ..Line::default()
    });
    uno.send_serial(&[0x57]);
    uno.run_ms(1).expect("it waits");
    assert_eq!(read(&mut uno, 1), [(UPE, 0x57)]);
    // Half the rate: the start bit and 0xF0 are 10 zeros and 8 ones there.
    let mut uno = late_reader(AT_115200.0, FORM_8N1);
    uno.set_serial_line(Line {
        baud: 57_600,
        ..Line::default()
    });
    uno.send_serial(&[0xF0]);
    uno.run_ms(1).expect("it waits");
    assert_eq!(read(&mut uno, 1), [(FE, 0)]);
}

#[test]
fn a_receiver_that_is_switched_on_late_waits_for_a_start_bit() {
    let mut words = vec![ldi(20, 0), dec(20), brne(-2)]; // 768 cycles
    words.extend(echo_program(AT_115200.0, FORM_8N1));
    let mut uno = board(&words);
    // Its one falling edge, that of 0x03, is over then; it is low until the stop bit.
    uno.send_serial(&[0x03]);
    uno.run_ms(1).expect("it goes on");
    uno.send_serial(b"x");
    uno.run_ms(1).expect("it goes on");
    assert_eq!(uno.serial(), "x");
    // A reset does not hold up what is on the line, but breaks off what is half received.
    uno.take_serial();
    uno.send_serial(&[0x03]);
    uno.send_serial(b"yz");
    uno.run_cycles(500).expect("it goes on");
    uno.reset();
    uno.run_ms(1).expect("it goes on");
    assert_eq!(uno.serial(), "yz");
}
