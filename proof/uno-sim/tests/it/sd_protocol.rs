//! The card model byte by byte, against the SD Physical Layer Simplified Specification, chapter 7.

use unoclp_uno_sim::sd::crc::{crc7, crc16};
use unoclp_uno_sim::sd::{At, Fault, Kind, SdCard, Timing, What};

const READY: u8 = 0x00;
const IDLE: u8 = 0x01;
const ILLEGAL: u8 = 0x04;
const CRC: u8 = 0x08;
const ADDRESS: u8 = 0x20;
const PARAMETER: u8 = 0x40;
/// HCS, in the argument of ACMD41.
const HCS: u32 = 1 << 30;

fn card(kind: Kind) -> SdCard {
    let image = (0..64 * 512).map(|at| (at / 512 + at) as u8).collect();
    SdCard::new(kind, image).expect("64 blocks fit any card")
}

/// The card after its power-up clocks, selected.
fn powered(kind: Kind) -> SdCard {
    let mut card = card(kind);
    for _ in 0..10 {
        card.exchange(0xFF);
    }
    card.select(true);
    card
}

/// Sends a frame and gives the R1, or `None` after 16 bytes of silence.
fn send(card: &mut SdCard, frame: [u8; 6]) -> Option<u8> {
    for byte in frame {
        card.exchange(byte);
    }
    (0..16)
        .map(|_| card.exchange(0xFF))
        .find(|byte| byte & 0x80 == 0)
}

fn frame(index: u8, argument: u32) -> [u8; 6] {
    let [a, b, c, d] = argument.to_be_bytes();
    let start = [0x40 | index, a, b, c, d];
    [start[0], a, b, c, d, crc7(&start) << 1 | 1]
}

fn command(card: &mut SdCard, index: u8, argument: u32) -> Option<u8> {
    send(card, frame(index, argument))
}

fn bytes<const N: usize>(card: &mut SdCard) -> [u8; N] {
    std::array::from_fn(|_| card.exchange(0xFF))
}

/// Waits for the start token, then takes `len` bytes and the CRC16, which must be right.
fn packet(card: &mut SdCard, len: usize) -> Vec<u8> {
    let token = (0..100)
        .map(|_| card.exchange(0xFF))
        .find(|&byte| byte != 0xFF);
    assert_eq!(token, Some(0xFE));
    let data: Vec<u8> = (0..len).map(|_| card.exchange(0xFF)).collect();
    assert_eq!(bytes::<2>(card), crc16(&data).to_be_bytes());
    data
}

/// CMD0, CMD8, and ACMD41 until ready.
fn initialised(kind: Kind) -> SdCard {
    let mut card = powered(kind);
    assert_eq!(command(&mut card, 0, 0), Some(IDLE));
    command(&mut card, 8, 0x1AA);
    bytes::<4>(&mut card);
    for polls in 0.. {
        assert_eq!(command(&mut card, 55, 0), Some(IDLE));
        if command(&mut card, 41, HCS) == Some(READY) {
            assert_eq!(polls, Timing::default().init_polls);
            break;
        }
    }
    assert!(card.is_ready());
    card
}

#[test]
fn a_card_keeps_silent_until_it_is_spoken_to_as_it_wants() {
    // Clocks with CS high as (bytes, MOSI), and whether CMD0 is answered then.
    for (clocks, mosi, answer) in [
        (10, 0xFF, Some(IDLE)),
        (9, 0xFF, None), // 72 clocks
        (0, 0xFF, None),
        (20, 0x00, None), // the command line was not high
    ] {
        let mut card = card(Kind::SdscV2);
        for _ in 0..clocks {
            assert_eq!(card.exchange(mosi), 0xFF);
        }
        card.select(true);
        assert_eq!(
            command(&mut card, 0, 0),
            answer,
            "{clocks} bytes of {mosi:#x}"
        );
    }

    let mut card = powered(Kind::SdscV2);
    assert_eq!(command(&mut card, 8, 0x1AA), None, "CMD8 before CMD0");
    assert_eq!(
        send(&mut card, [0x40, 0, 0, 0, 0, 0xFF]),
        None,
        "CMD0 with a wrong CRC"
    );
    card.select(false);
    assert_eq!(command(&mut card, 0, 0), None, "CS high");
    card.select(true);
    assert_eq!(command(&mut card, 0, 0), Some(IDLE));
}

#[test]
fn only_some_commands_are_legal_before_initialisation() {
    let v2 = [Kind::SdscV2, Kind::Sdhc];
    for kind in [Kind::SdV1, Kind::SdscV2, Kind::Sdhc] {
        let legal: &[u8] = if v2.contains(&kind) {
            &[0, 1, 8, 55, 58, 59]
        } else {
            &[0, 1, 55, 58, 59]
        };
        for index in 0..64 {
            let mut card = powered(kind);
            command(&mut card, 0, 0);
            let expected = if legal.contains(&index) {
                IDLE
            } else {
                IDLE | ILLEGAL
            };
            assert_eq!(
                command(&mut card, index, 0x1AA),
                Some(expected),
                "{kind:?}, CMD{index}"
            );
        }
        let legal = [0, 1, 9, 10, 13, 16, 17, 18, 24, 55, 58, 59];
        for index in 0..64 {
            let mut card = initialised(kind);
            let expected = match index {
                0 => IDLE,
                _ if legal.contains(&index) => READY,
                _ => ILLEGAL,
            };
            let argument = if index == 16 { 512 } else { 0 };
            assert_eq!(
                command(&mut card, index, argument),
                Some(expected),
                "{kind:?}, CMD{index}"
            );
        }
    }
}

#[test]
fn the_host_must_show_that_it_can_handle_high_capacity() {
    // The kind, whether CMD8 is sent, the argument of ACMD41, and whether the card gets ready.
    for (kind, cmd8, argument, ready) in [
        (Kind::SdV1, false, 0, true),
        (Kind::SdscV2, false, 0, true),
        (Kind::SdscV2, true, HCS, true),
        (Kind::Sdhc, true, HCS, true),
        (Kind::Sdhc, true, 0, false),
        (Kind::Sdhc, false, HCS, false),
    ] {
        let mut card = powered(kind);
        command(&mut card, 0, 0);
        if cmd8 {
            assert_eq!(command(&mut card, 8, 0x1AA), Some(IDLE));
            assert_eq!(bytes(&mut card), [0, 0, 1, 0xAA]);
        }
        for _ in 0..20 {
            command(&mut card, 55, 0);
            command(&mut card, 41, argument);
        }
        assert_eq!(
            card.is_ready(),
            ready,
            "{kind:?}, CMD8 {cmd8}, ACMD41 {argument:#x}"
        );
        assert_eq!(
            command(&mut card, 58, 0),
            Some(if ready { READY } else { IDLE })
        );
        let [ocr, ..] = bytes::<4>(&mut card);
        let expected = match (ready, kind) {
            (false, _) => 0x00,
            (true, Kind::Sdhc) => 0xC0,
            (true, _) => 0x80,
        };
        assert_eq!(ocr & 0xC0, expected, "{kind:?}: OCR bits 31 and 30");
    }
}

#[test]
fn cmd8_of_another_voltage_is_not_accepted() {
    let mut card = powered(Kind::Sdhc);
    command(&mut card, 0, 0);
    assert_eq!(command(&mut card, 8, 0x255), Some(IDLE));
    assert_eq!(bytes(&mut card), [0, 0, 0, 0x55]);
}

#[test]
fn crc_is_checked_where_it_must_be() {
    let wrong = |index, argument| {
        let mut frame = frame(index, argument);
        frame[5] ^= 0x02;
        frame
    };
    let mut card = powered(Kind::SdscV2);
    command(&mut card, 0, 0);
    assert_eq!(
        send(&mut card, wrong(8, 0x1AA)),
        Some(IDLE | CRC),
        "CMD8, CRC off"
    );
    assert_eq!(
        send(&mut card, wrong(0, 0)),
        Some(IDLE | CRC),
        "CMD0, CRC off"
    );
    assert_eq!(send(&mut card, wrong(58, 0)), Some(IDLE), "CMD58, CRC off");
    bytes::<4>(&mut card);
    assert_eq!(command(&mut card, 59, 1), Some(IDLE));
    assert_eq!(
        send(&mut card, wrong(58, 0)),
        Some(IDLE | CRC),
        "CMD58, CRC on"
    );
    assert_eq!(command(&mut card, 59, 0), Some(IDLE));
    assert_eq!(
        send(&mut card, wrong(58, 0)),
        Some(IDLE),
        "CMD58, CRC off again"
    );
}

#[test]
fn addresses_are_checked() {
    use Kind::{SdV1, Sdhc, SdscV2};
    let blocks = |kind| card(kind).image().len() as u32 / 512;
    for (kind, index, argument, r1) in [
        (SdV1, 17, 512, READY),
        (SdV1, 17, 1, ADDRESS),
        (SdscV2, 17, 511, ADDRESS),
        (SdscV2, 24, 256, ADDRESS),
        (SdscV2, 17, blocks(SdscV2) * 512 - 512, READY),
        (SdscV2, 17, blocks(SdscV2) * 512, PARAMETER),
        (SdscV2, 17, 0xFFFF_FE00, PARAMETER),
        (SdscV2, 24, blocks(SdscV2) * 512, PARAMETER),
        (Sdhc, 17, 511, READY),
        (Sdhc, 17, blocks(Sdhc) - 1, READY),
        (Sdhc, 17, blocks(Sdhc), PARAMETER),
        (Sdhc, 18, u32::MAX, PARAMETER),
        (Sdhc, 24, blocks(Sdhc), PARAMETER),
    ] {
        let mut card = initialised(kind);
        assert_eq!(
            command(&mut card, index, argument),
            Some(r1),
            "{kind:?}, CMD{index}, {argument:#x}"
        );
    }
}

#[test]
fn the_block_length_of_standard_capacity_can_be_set() {
    let mut card = initialised(Kind::SdscV2);
    for (len, r1) in [(0, PARAMETER), (513, PARAMETER), (16, READY)] {
        assert_eq!(command(&mut card, 16, len), Some(r1), "CMD16 with {len}");
    }
    assert_eq!(command(&mut card, 17, 512 + 496), Some(READY));
    assert_eq!(packet(&mut card, 16), &card.image()[512 + 496..1024]);
    assert_eq!(
        command(&mut card, 17, 512 + 497),
        Some(ADDRESS),
        "crosses a block"
    );
    assert_eq!(
        command(&mut card, 24, 512),
        Some(PARAMETER),
        "writing takes whole blocks"
    );

    let mut card = initialised(Kind::Sdhc);
    assert_eq!(command(&mut card, 16, 16), Some(READY));
    assert_eq!(command(&mut card, 17, 1), Some(READY));
    assert_eq!(packet(&mut card, 512), &card.image()[512..1024]);
}

#[test]
fn a_read_of_many_blocks_ends_with_cmd12_or_at_the_end_of_the_card() {
    let mut card = initialised(Kind::SdscV2);
    assert_eq!(command(&mut card, 12, 0), Some(ILLEGAL), "nothing to stop");
    assert_eq!(command(&mut card, 18, 62 * 512), Some(READY));
    packet(&mut card, 512);
    assert_eq!(packet(&mut card, 512), &card.image()[63 * 512..]);
    let token = (0..100)
        .map(|_| card.exchange(0xFF))
        .find(|&byte| byte != 0xFF);
    assert_eq!(token, Some(0x08), "out of range");
    assert_eq!(command(&mut card, 12, 0), Some(READY));
    assert_eq!(card.exchange(0xFF), 0x00, "busy");
    let busy = (0..100).take_while(|_| card.exchange(0xFF) == 0).count() as u32;
    assert_eq!(busy, Timing::default().stop_busy - 1);

    // In the middle of a block: six bytes of it go out during CMD12, and one more as the stuff byte.
    assert_eq!(command(&mut card, 18, 0), Some(READY));
    let token = (0..100).find(|_| card.exchange(0xFF) == 0xFE);
    assert_eq!(token, Some(8));
    for (at, byte) in frame(12, 0).into_iter().enumerate() {
        assert_eq!(card.exchange(byte), card.image()[at]);
    }
    assert_eq!(card.exchange(0xFF), card.image()[6]);
    assert_eq!(bytes(&mut card), [0xFF, READY, 0x00]);
    assert_eq!(card.log().blocks_read, 3);
}

/// Writes a block with the CRC16 given and returns the data response.
fn write(card: &mut SdCard, argument: u32, data: &[u8; 512], crc: u16) -> u8 {
    assert_eq!(command(card, 24, argument), Some(READY));
    card.exchange(0xFF);
    card.exchange(0xFE);
    for &byte in data.iter().chain(&crc.to_be_bytes()) {
        assert_eq!(card.exchange(byte), 0xFF);
    }
    card.exchange(0xFF) & 0x1F
}

#[test]
fn a_written_block_is_checked_while_crc_is_on() {
    let data = [0x40; 512]; // bytes that look like the start of a command
    let crc = crc16(&data);
    for (crc_on, crc, response) in [
        (0, crc, 0x05),
        (0, !crc, 0x05),
        (1, crc, 0x05),
        (1, !crc, 0x0B),
    ] {
        let mut card = initialised(Kind::SdscV2);
        command(&mut card, 59, crc_on);
        assert_eq!(write(&mut card, 512, &data, crc), response);
        let stored = response == 0x05;
        assert_eq!(card.image()[512..1024] == data, stored);
        assert_eq!(card.log().blocks_written, u64::from(stored));
        let busy = (0..100).take_while(|_| card.exchange(0xFF) == 0).count() as u32;
        assert_eq!(
            busy,
            if stored {
                Timing::default().write_busy
            } else {
                0
            }
        );
        assert_eq!(command(&mut card, 13, 0), Some(READY));
        assert_eq!(bytes(&mut card), [0x00, 0xFF]);
    }
}

#[test]
fn a_busy_card_listens_to_cmd0_alone_and_goes_on_while_deselected() {
    let data = [0; 512];
    let timing = Timing {
        write_busy: 1000,
        ..Timing::default()
    };
    let mut card = initialised(Kind::SdscV2).with_timing(timing);
    write(&mut card, 0, &data, 0);
    for byte in frame(13, 0) {
        assert_eq!(card.exchange(byte), 0x00);
    }
    assert_eq!(
        card.log().commands.last().map(|command| command.answer),
        Some(None)
    );
    card.select(false);
    for _ in 0..1000 {
        assert_eq!(card.exchange(0xFF), 0xFF, "MISO is let go");
    }
    card.select(true);
    assert_eq!(card.exchange(0xFF), 0xFF);
    assert_eq!(command(&mut card, 13, 0), Some(READY));

    write(&mut card, 0, &data, 0);
    card.exchange(0xFF);
    for byte in frame(0, 0) {
        card.exchange(byte);
    }
    assert_eq!(bytes(&mut card), [0xFF, IDLE, 0xFF]);
}

#[test]
fn deselecting_pauses_a_read_and_drops_half_a_command() {
    let mut card = initialised(Kind::SdscV2);
    assert_eq!(command(&mut card, 17, 0), Some(READY));
    assert_eq!((0..100).find(|_| card.exchange(0xFF) == 0xFE), Some(8));
    assert_eq!(bytes::<2>(&mut card), card.image()[..2]);
    card.select(false);
    assert_eq!(bytes(&mut card), [0xFF; 3]);
    card.select(true);
    assert_eq!(bytes::<2>(&mut card), card.image()[2..4]);

    let mut card = initialised(Kind::SdscV2);
    for byte in &frame(13, 0)[..3] {
        card.exchange(*byte);
    }
    card.select(false);
    card.select(true);
    assert_eq!(command(&mut card, 13, 0), Some(READY));
    assert_eq!(card.log().count(13), 1);
}

#[test]
fn registers_come_as_packets() {
    for kind in [Kind::SdV1, Kind::SdscV2, Kind::Sdhc] {
        let mut card = initialised(kind);
        assert_eq!(command(&mut card, 9, 0), Some(READY));
        let csd = packet(&mut card, 16);
        assert_eq!(csd[0] >> 6, u8::from(kind == Kind::Sdhc), "CSD_STRUCTURE");
        assert_eq!(command(&mut card, 10, 0), Some(READY));
        assert_eq!(packet(&mut card, 16)[3..8], *b"UNOCL");
        assert_eq!(card.log().blocks_read, 0);
    }
}

#[test]
fn cmd0_forgets_the_initialisation() {
    let mut card = initialised(Kind::Sdhc);
    command(&mut card, 59, 1);
    assert_eq!(command(&mut card, 0, 0), Some(IDLE));
    let mut damaged = frame(58, 0);
    damaged[5] ^= 0x02;
    assert_eq!(send(&mut card, damaged), Some(IDLE), "CRC is off again");
    bytes::<4>(&mut card);
    let initialise = |card: &mut SdCard| {
        for _ in 0..=Timing::default().init_polls {
            assert!(!card.is_ready());
            command(card, 55, 0);
            command(card, 41, HCS);
        }
        card.is_ready()
    };
    assert!(!initialise(&mut card), "without a new CMD8");
    command(&mut card, 8, 0x1AA);
    assert!(initialise(&mut card));

    let mut card = initialised(Kind::SdscV2);
    command(&mut card, 16, 16);
    command(&mut card, 0, 0);
    command(&mut card, 8, 0x1AA);
    assert!(initialise(&mut card));
    assert_eq!(command(&mut card, 17, 0), Some(READY));
    assert_eq!(
        packet(&mut card, 512),
        &card.image()[..512],
        "blocks are whole again"
    );
}

#[test]
fn a_stuck_card_holds_the_line_low_whatever_the_host_does() {
    let mut card = initialised(Kind::SdscV2);
    let next = card.log().commands.len();
    card.add_fault(Fault {
        at: At::Command(next),
        what: What::Stuck,
    });
    for index in [13, 13, 0] {
        for byte in frame(index, 0) {
            card.exchange(byte);
        }
        assert_eq!(bytes(&mut card), [0x00; 16]);
    }
    card.select(false);
    assert_eq!(
        card.exchange(0xFF),
        0xFF,
        "but leaves it alone when deselected"
    );
    assert_eq!(card.log().commands.len(), next + 1, "and is deaf");
    card.power_cycle();
    (0..10).for_each(|_| {
        card.exchange(0xFF);
    });
    card.select(true);
    assert_eq!(command(&mut card, 0, 0), Some(IDLE), "power helps");
}
