//! CRC-16/MODBUS against its definition, and against published frames.

use crate::common::bytes;
use crate::common::random::Random;
use unoclp_modbus::Crc;

/// Bit by bit, as the specification of the serial line has it (MODBUS over Serial Line V1.02, 6.2.2).
fn by_the_book(bytes: &[u8]) -> u16 {
    let mut register = 0xFFFF;
    for byte in bytes {
        register ^= u16::from(*byte);
        for _ in 0..8 {
            let carry = register & 1;
            register >>= 1;
            if carry == 1 {
                register ^= 0xA001;
            }
        }
    }
    register
}

#[test]
fn the_check_value_is_the_published_one() {
    assert_eq!(Crc::of(b"123456789").value(), 0x4B37);
    assert_eq!(Crc::of(b"").value(), 0xFFFF);
    assert_eq!(Crc::default(), Crc::of(b""));
}

#[test]
fn published_frames() {
    for frame in [
        // MODBUS over Serial Line V1.02, 6.2.2: address 2, function 7.
        "02 07 41 12",
        // The examples of modbustools.com/modbus.html.
        "04 01 00 0A 00 0D DD 98",
        "04 01 02 0A 11 B3 50",
        "01 03 00 00 00 02 C4 0B",
        "01 03 04 00 06 00 05 DA 31",
        "11 05 00 AC FF 00 4E 8B",
        "11 10 00 01 00 02 04 00 0A 01 02 C6 F0",
    ] {
        let frame = bytes(frame);
        let (message, crc) = frame.split_at(frame.len() - 2);
        assert_eq!(Crc::of(message).to_bytes(), crc, "{frame:02x?}");
        assert_eq!(Crc::of(&frame).value(), 0, "{frame:02x?}");
    }
}

#[test]
fn all_messages_of_two_bytes() {
    for first in 0..=255 {
        for second in 0..=255 {
            let message = [first, second];
            assert_eq!(Crc::of(&message).value(), by_the_book(&message));
        }
    }
}

#[test]
fn long_messages() {
    let mut random = Random::new(1);
    for length in 0..=254 {
        let message: Vec<u8> = (0..length).map(|_| random.byte()).collect();
        let crc = Crc::of(&message);
        assert_eq!(crc.value(), by_the_book(&message), "{length}");
        assert_eq!(crc.to_bytes(), crc.value().to_le_bytes());

        let mut pushed = Crc::default();
        for byte in &message {
            pushed.push(*byte);
        }
        assert_eq!(pushed, crc);
        pushed.extend(&crc.to_bytes());
        assert_eq!(pushed.value(), 0, "{length}");
    }
}
