//! NC-1 on the firmware: every kind of card and volume, and files that lie in difficult places.

use crate::common;
use unoclp_card::image::{Fat, Image};
use unoclp_testing::cases;
use unoclp_uno_sim::Slot;
use unoclp_uno_sim::engine::{Clock, UnoEngine};
use unoclp_uno_sim::sd::{Kind, SdCard};

/// A program of this many contacts and a comment on each line: 3,000 bytes and more.
fn program(contacts: usize) -> String {
    let mut text = String::from("0 / program start\r\n");
    for _ in 0..contacts {
        text += "827301 / contact: input 01\r\n";
    }
    text + "877901 / coil: output 01"
}

fn filler(bytes: usize) -> Vec<u8> {
    vec![b'5'; bytes]
}

/// What may stand around the program on a card.
type Case = (&'static str, fn(Image, &str) -> Image);

const CASES: &[Case] = &[
    ("first file", |image, text| image.file("PROGRAM.TXT", text)),
    ("lower case", |image, text| image.file("program.txt", text)),
    ("large clusters", |image, text| {
        image.cluster_blocks(2).file("PROGRAM.TXT", text)
    }),
    ("behind other files", |image, text| {
        image
            .file("FIRST.BIN", filler(5000))
            .file("PROGRAM.TXT", text)
    }),
    ("fragmented", |image, text| {
        image.fragmented_file("PROGRAM.TXT", text)
    }),
    ("deleted and long-named files before it", |image, text| {
        image
            .deleted_file("XROGRAM.TXT", "0\n877903\n")
            .file("a program with a long name.txt", "0\n877904\n")
            .file("PROGRAM.TXT.TXT", "0\n877902\n")
            .file("PROGRAM.TXT", text)
    }),
    ("a root folder of several clusters", |image, text| {
        (0..40)
            .fold(image, |image, n| {
                image.file(format!("a file with a long name, number {n}"), filler(100))
            })
            .file("PROGRAM.TXT", text)
    }),
];

#[test]
fn every_card_and_volume() {
    let mut engine = UnoEngine::new(common::firmware(), Clock::Running).unwrap();
    let text = program(120);
    let mut booted = 0;
    let kinds = [Kind::SdV1, Kind::SdscV2, Kind::Sdhc];
    let volumes = [Fat::Fat16, Fat::Fat32].map(|fat| [false, true].map(|bare| (fat, bare)));
    let all = volumes.into_iter().flatten().flat_map(|volume| {
        CASES
            .iter()
            .flat_map(move |case| kinds.map(|kind| (volume, case, kind)))
    });
    for ((fat, bare), (name, build), kind) in cases(all) {
        let image = build(Image::new(fat), &text);
        let image = if bare { image.bare() } else { image }.build().unwrap();
        let case = format!("{fat:?}, bare {bare}, {kind:?}, {name}");
        let card = SdCard::new(kind, image.clone()).unwrap();
        let started = engine
            .start(Slot::Card(card))
            .unwrap_or_else(|e| panic!("{case}: {e}"));
        assert_eq!(started, Ok(()), "{case}");
        let uno = engine.uno().unwrap();
        assert!(
            uno.serial().contains("program: 122 codes, 121 bytes"),
            "{case}: {}",
            uno.serial()
        );
        uno.set_input(0, true);
        uno.run_ms(5).unwrap();
        assert_eq!(uno.outputs(), 0b0001, "{case}");

        let card = uno.card().unwrap();
        assert!(
            card.image().starts_with(&image),
            "{case}: the card was changed"
        );
        let reading = [0, 8, 17, 41, 55, 58, 59];
        let other = card
            .log()
            .commands
            .iter()
            .find(|command| !reading.contains(&command.index));
        assert_eq!(other, None, "{case}");
        booted += 1;
    }
    println!("{booted} cards booted, none written to");
}

#[test]
fn cards_that_hold_no_program() {
    let mut engine = UnoEngine::new(common::firmware(), Clock::Running).unwrap();
    let empty_volume = Image::new(Fat::Fat16).build().unwrap();
    let similar = Image::new(Fat::Fat32)
        .file("PROGRAM.TX", "0\n")
        .file("PROGRAM.TXT.TXT", "0\n")
        .build()
        .unwrap();
    let mut exfat = vec![0; 1 << 20];
    exfat[..11].copy_from_slice(b"\xEB\x76\x90EXFAT   ");
    exfat[510..512].copy_from_slice(&[0x55, 0xAA]);
    let mut end_of_chain = Image::new(Fat::Fat16)
        .bare()
        .file("PROGRAM.TXT", program(60))
        .build()
        .unwrap();
    break_chain(&mut end_of_chain);
    for (name, image, number) in [
        ("a volume without files", empty_volume, 55),
        ("only similar names", similar, 55),
        ("nothing at all", vec![0; 1 << 20], 54),
        ("exFAT", exfat, 54),
        ("a file longer than its chain", end_of_chain, 56),
    ] {
        let card = SdCard::new(Kind::Sdhc, image).unwrap();
        let refusal = engine
            .start(Slot::Card(card))
            .unwrap_or_else(|e| panic!("{name}: {e}"))
            .unwrap_err();
        assert_eq!((refusal.number, refusal.line), (number, None), "{name}");
    }
}

/// Frees the second cluster of a bare FAT16 volume's first file, in both FATs.
fn break_chain(image: &mut [u8]) {
    let word =
        |at: usize, image: &[u8]| usize::from(u16::from_le_bytes([image[at], image[at + 1]]));
    let (reserved, fat) = (word(14, image) * 512, word(22, image) * 512);
    for start in [reserved, reserved + fat] {
        // Cluster 2 points to cluster 3, which then belongs to nobody.
        assert_eq!(word(start + 4, image), 3);
        image[start + 6..start + 8].fill(0);
    }
}
