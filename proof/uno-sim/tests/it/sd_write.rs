//! Writing a block (CMD24), byte by byte and with the time (SD Physical Layer Simplified Specification, sections 4.6.2.2
//! and 7.2.4).

use unoclp_uno_sim::sd::crc::crc7;
use unoclp_uno_sim::sd::{Kind, SdCard, Timing};

const READY: u8 = 0x00;
const ACCEPTED: u8 = 0x05;
const DATA: [u8; 512] = [0xA5; 512];
/// The block that is written.
const BLOCK: std::ops::Range<usize> = 512..1024;

fn command(card: &mut SdCard, index: u8, argument: u32) -> Option<u8> {
    let [a, b, c, d] = argument.to_be_bytes();
    let start = [0x40 | index, a, b, c, d];
    for byte in start.into_iter().chain([crc7(&start) << 1 | 1]) {
        card.exchange(byte);
    }
    (0..16)
        .map(|_| card.exchange(0xFF))
        .find(|byte| byte & 0x80 == 0)
}

/// Powers a card up to ready.
fn start(card: &mut SdCard) {
    card.select(false);
    for _ in 0..10 {
        card.exchange(0xFF);
    }
    card.select(true);
    command(card, 0, 0);
    for _ in 0..=Timing::default().init_polls {
        command(card, 55, 0);
        command(card, 41, 0);
    }
    assert!(card.is_ready());
}

fn card() -> SdCard {
    let mut card = SdCard::new(Kind::SdV1, Vec::new()).expect("an empty image fits");
    start(&mut card);
    card
}

/// Sends CMD24 for the block, the token, and so many bytes of the packet of 514.
fn send(card: &mut SdCard, count: usize) {
    assert_eq!(command(card, 24, BLOCK.start as u32), Some(READY));
    card.exchange(0xFF);
    card.exchange(0xFE);
    let packet = DATA.iter().chain(&[0, 0]);
    for &byte in packet.take(count) {
        assert_eq!(card.exchange(byte), 0xFF);
    }
}

#[test]
fn the_card_is_busy_until_bytes_and_time_are_over() {
    const TIME: u64 = 4_000_000;
    let busy_bytes = Timing::default().write_busy as usize;
    let mut card = card().with_write_time(TIME);
    card.set_time(1000);
    send(&mut card, 514);
    assert_eq!(card.exchange(0xFF) & 0x1F, ACCEPTED);
    for now in [1000, 1000 + TIME / 2, 1000 + TIME - 1] {
        card.set_time(now);
        let low = (0..10 * busy_bytes).all(|_| card.exchange(0xFF) == 0x00);
        assert!(low, "at {now}");
        for byte in [0x4D, 0, 0, 0, 0, 0xFF, 0xFF, 0xFF] {
            assert_eq!(card.exchange(byte), 0x00, "CMD13 is not heard");
        }
    }
    card.select(false);
    assert_eq!(card.exchange(0xFF), 0xFF, "it leaves the line alone");
    card.select(true);
    assert_eq!(card.exchange(0xFF), 0x00, "and is still busy");
    card.set_time(1000 + TIME);
    assert_eq!(card.exchange(0xFF), 0xFF);
    assert_eq!(command(&mut card, 13, 0), Some(READY));
    assert_eq!(card.exchange(0xFF), 0x00, "the second byte of R2: no error");

    // The time alone is not enough: bytes count too.
    card.set_write_time(1);
    send(&mut card, 514);
    assert_eq!(card.exchange(0xFF) & 0x1F, ACCEPTED);
    card.set_time(1000 + 2 * TIME);
    let low = (0..1000)
        .take_while(|_| card.exchange(0xFF) == 0x00)
        .count();
    assert_eq!(low, busy_bytes);
}

#[test]
fn cmd0_and_power_end_the_busy_time() {
    for power in [false, true] {
        let mut card = card().with_write_time(u64::MAX);
        send(&mut card, 514);
        assert_eq!(card.exchange(0xFF) & 0x1F, ACCEPTED);
        assert_eq!(command(&mut card, 13, 0), Some(0x00), "the line is low");
        if power {
            card.power_cycle();
            start(&mut card);
        } else {
            for byte in [0x40, 0, 0, 0, 0, 0x95] {
                card.exchange(byte);
            }
            assert_eq!(card.exchange(0xFF), 0xFF);
            assert_eq!(card.exchange(0xFF), 0x01, "idle");
        }
        assert_eq!(card.exchange(0xFF), 0xFF);
        assert_eq!(card.image()[BLOCK], DATA);
    }
}

#[test]
fn a_block_that_has_not_come_to_its_end_is_not_stored() {
    for count in [0, 1, 256, 511, 512, 513, 514] {
        let mut card = card();
        send(&mut card, count);
        card.power_cycle();
        assert_eq!(card.image()[BLOCK] == DATA, count == 514, "{count} bytes");
        assert_eq!(card.log().blocks_written, u64::from(count == 514));

        assert!(!card.is_ready());
        start(&mut card);
        let old = count != 514;
        let unchanged = card.image()[BLOCK] == [0; 512];
        assert_eq!(unchanged, old, "{count} bytes");
        send(&mut card, 514);
        assert_eq!(card.exchange(0xFF) & 0x1F, ACCEPTED);
        assert_eq!(card.image()[BLOCK], DATA, "{count} bytes: the next write");
    }
}

#[test]
fn a_token_before_r1_is_none() {
    let mut card = card();
    let [a, b, c, d] = (BLOCK.start as u32).to_be_bytes();
    for byte in [0x58, a, b, c, d, 0xFF] {
        card.exchange(byte);
    }
    // The card's R1 comes one byte after this one.
    assert_eq!(card.exchange(0xFE), 0xFF);
    assert_eq!(card.exchange(0xFF), READY);
    for byte in DATA.into_iter().chain([0; 10]) {
        assert_eq!(card.exchange(byte), 0xFF, "no data response");
    }
    assert_eq!(card.log().blocks_written, 0);
}
