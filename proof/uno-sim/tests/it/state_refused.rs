//! Cards on which no STATE.TXT is kept: nothing is ever written to them.

use crate::common;
use crate::common::state::{FOLLOW, KEPT, assert_only_state_changed, template, volume};
use crate::common::{firmware, to_run, to_run_or_fault};
use fatfs::{FileSystem, FsOptions};
use std::io::{Cursor, Write};
use std::ops::Range;
use unoclp_card::image::{Fat, Image};
use unoclp_testing::cases;
use unoclp_uno_sim::sd::{At, Command, Kind, SdCard, What};
use unoclp_uno_sim::{Slot, Uno};

const UNFIT: &str = "state: STATE.TXT is read-only or under 512 B, not kept\r\n";
const UNREADABLE: &str = "state: STATE.TXT cannot be read, not kept\r\n";
/// The board says nothing of STATE.TXT.
const NOTHING: &str = "";

const READ_ONLY: u8 = 0x01;
const LABEL: u8 = 0x08;
const FOLDER: u8 = 0x10;

/// An image to be damaged.
struct Volume {
    fat: Fat,
    image: Vec<u8>,
    range: Range<usize>,
}

impl Volume {
    fn new(image: Image, fat: Fat) -> Volume {
        let image = image.build().unwrap();
        let range = volume(&image);
        Volume { fat, image, range }
    }

    /// Changes it as a PC would.
    fn on_a_pc<T>(&mut self, change: impl FnOnce(&FileSystem<Cursor<&mut [u8]>>) -> T) -> T {
        let volume = Cursor::new(&mut self.image[self.range.clone()]);
        change(&FileSystem::new(volume, FsOptions::new()).unwrap())
    }

    /// Overwrites bytes of STATE.TXT's entry in the root folder.
    fn entry(&mut self, at: usize, bytes: &[u8]) {
        let mut entries = self.image.chunks(32);
        let entry = 32
            * entries
                .position(|entry| entry.starts_with(b"STATE   TXT"))
                .unwrap();
        self.image[entry + at..][..bytes.len()].copy_from_slice(bytes);
    }

    fn attributes(&mut self, attributes: u8) {
        self.entry(11, &[attributes]);
    }

    fn first_cluster(&mut self, cluster: u32) {
        let [a, b, c, d] = cluster.to_le_bytes();
        self.entry(26, &[a, b]);
        self.entry(20, &[c, d]);
    }

    /// Puts the file to this cluster, and this into its place in both FATs.
    fn fat_entry(&mut self, cluster: u32, next: u32) {
        self.first_cluster(cluster);
        let boot = &self.image[self.range.clone()];
        let word = |at: usize| usize::from(u16::from_le_bytes([boot[at], boot[at + 1]]));
        let (reserved, width) = (word(14), if self.fat == Fat::Fat16 { 2 } else { 4 });
        let blocks = if self.fat == Fat::Fat16 {
            word(22)
        } else {
            word(36)
        };
        for fat in 0..2 {
            let at = self.range.start + (reserved + fat * blocks) * 512 + cluster as usize * width;
            self.image[at..at + width].copy_from_slice(&next.to_le_bytes()[..width]);
        }
    }

    /// The number of clusters; the last one is this plus 1.
    fn clusters(&mut self) -> u32 {
        self.on_a_pc(|volume| volume.stats().unwrap().total_clusters())
    }
}

/// What is wrong, how a sound card comes to it, and what the serial port says.
type Case = (&'static str, fn(&mut Volume), &'static str);

const DAMAGED: &[Case] = &[
    ("read-only", |card| card.attributes(READ_ONLY), UNFIT),
    ("a volume label", |card| card.attributes(LABEL), NOTHING),
    (
        "a folder with a size",
        |card| card.attributes(FOLDER),
        NOTHING,
    ),
    ("deleted", |card| card.entry(0, &[0xE5]), NOTHING),
    ("empty", |card| card.entry(28, &[0; 4]), UNFIT),
    (
        "511 bytes",
        |card| card.entry(28, &511u32.to_le_bytes()),
        UNFIT,
    ),
    ("cluster 0", |card| card.first_cluster(0), UNREADABLE),
    ("cluster 1", |card| card.first_cluster(1), UNREADABLE),
    (
        "a cluster beyond the volume",
        |card| {
            let beyond = card.clusters() + 2;
            card.first_cluster(beyond);
        },
        UNREADABLE,
    ),
    (
        "a cluster that no volume has",
        |card| card.first_cluster(!0),
        UNREADABLE,
    ),
    ("a free cluster", |card| card.fat_entry(1000, 0), UNREADABLE),
    (
        "a bad cluster",
        |card| card.fat_entry(1000, 0x0FFF_FFF7),
        UNREADABLE,
    ),
    (
        "a cluster before one beyond the volume",
        |card| {
            let beyond = card.clusters() + 2;
            card.fat_entry(1000, beyond);
        },
        UNREADABLE,
    ),
];

const ELSEWHERE: &[Case] = &[
    ("no file", |_| {}, NOTHING),
    (
        "a folder",
        |card| {
            card.on_a_pc(|volume| {
                volume.root_dir().create_dir("STATE.TXT").unwrap();
            })
        },
        NOTHING,
    ),
    (
        "in a folder",
        |card| {
            card.on_a_pc(|volume| {
                let folder = volume.root_dir().create_dir("FOLDER").unwrap();
                let mut file = folder.create_file("STATE.TXT").unwrap();
                file.write_all(&template()).unwrap();
            })
        },
        NOTHING,
    ),
    (
        "similar names",
        |card| {
            card.on_a_pc(|volume| {
                for name in ["STATE", "STATE.TX", "XSTATE.TXT", "STATE.TXT.TXT"] {
                    let mut file = volume.root_dir().create_file(name).unwrap();
                    file.write_all(&template()).unwrap();
                }
            })
        },
        NOTHING,
    ),
];

#[test]
fn a_card_without_a_fit_file_is_never_written_to() {
    let firmware = firmware();
    let mut cards = 0;
    for fat in [Fat::Fat16, Fat::Fat32] {
        let without = Image::new(fat).file("PROGRAM.TXT", FOLLOW);
        let with = without.clone().file("STATE.TXT", template());
        let elsewhere = ELSEWHERE.iter().map(|case| (&without, case));
        for (image, (name, change, expected)) in
            cases(elsewhere.chain(DAMAGED.iter().map(|case| (&with, case))))
        {
            let case = format!("{fat:?}, {name}");
            let mut volume = Volume::new(image.clone(), fat);
            change(&mut volume);
            let card = SdCard::new(Kind::Sdhc, volume.image.clone()).unwrap();
            let mut uno = Uno::with_program(firmware.clone(), Slot::Card(card)).unwrap();
            let said = to_run(&mut uno);
            let told: String = said
                .lines()
                .filter(|line| line.starts_with("state"))
                .collect();
            assert_eq!(told, expected.trim_end(), "{case}");
            // The first save would come at once, and the next after a second.
            let ms = if fat == Fat::Fat16 { 600 } else { 60 };
            expect_untouched(&mut uno, &volume.image, ms, &case);
            cards += 1;
        }
    }
    println!("{cards} cards without a fit STATE.TXT, none written to");
}

/// In RUN the card is left alone, and keeps what it had; the program runs.
fn expect_untouched(uno: &mut Uno, image: &[u8], ms: u64, case: &str) {
    uno.run_ms(2).unwrap();
    let selections = uno.card().unwrap().log().selections;
    assert!(uno.led(), "{case}");
    for inputs in [0b0101, 0b1010] {
        uno.set_inputs(inputs);
        uno.run_ms(ms).unwrap();
        assert_eq!(uno.outputs(), inputs, "{case}");
    }
    let card = uno.card().unwrap();
    assert_eq!(card.log().selections, selections, "{case}");
    assert_eq!(
        (card.log().count(24), card.log().count(25)),
        (0, 0),
        "{case}"
    );
    assert_eq!(card.log().writes, [], "{case}");
    assert!(
        card.image().starts_with(image),
        "{case}: the card was changed"
    );
}

#[test]
fn a_fault_writes_nothing() {
    let image = Image::new(Fat::Fat16)
        .file("PROGRAM.TXT", FOLLOW.replace("877904", "877917"))
        .file("STATE.TXT", template())
        .build()
        .unwrap();
    let card = SdCard::new(Kind::Sdhc, image.clone()).unwrap();
    let mut uno = common::uno(Slot::Card(card));
    let said = to_run_or_fault(&mut uno);
    assert!(said.contains("fault 26"), "{said:?}");
    uno.set_inputs(0b1111);
    uno.run_ms(1500).unwrap();
    let card = uno.card().unwrap();
    assert_eq!(card.log().count(24), 0);
    assert!(card.image() == image);
}

/// Where the card fails while STATE.TXT is looked for, the program runs all the same.
#[test]
fn a_card_that_fails_over_state_txt_runs_its_program() {
    let card = |image: &Image| SdCard::new(Kind::Sdhc, image.build().unwrap()).unwrap();
    let image = Image::new(Fat::Fat16)
        .file("PROGRAM.TXT", FOLLOW)
        .file("STATE.TXT", template());
    let mut healthy = common::uno(Slot::Card(card(&image)));
    to_run(&mut healthy);
    let card_seen = healthy.card().unwrap();
    let commands = &card_seen.log().commands;
    // From the last reading of a block of PROGRAM.TXT on, all commands concern STATE.TXT, up to the
    // first save.
    let reads_program = |command: &Command| {
        let block = command.argument as usize * 512;
        command.index == 17 && card_seen.image()[block..].starts_with(FOLLOW.as_bytes())
    };
    let first = commands.iter().rposition(reads_program).unwrap() + 1;
    let saves = |command: &Command| command.index == 24;
    let end = commands.iter().position(saves).unwrap_or(commands.len());
    assert!(first + 2 < end, "commands {first} to {end}");

    let (mut runs, mut kept) = (0, 0);
    for at in (first..end).map(At::Command) {
        for what in [
            What::NoAnswer,
            What::WrongCrc,
            What::WrongToken,
            What::Garbage,
            What::Removed,
            What::Stuck,
            What::NeverReady,
        ] {
            let case = format!("{what:?} at {at:?}");
            let before = image.build().unwrap();
            let mut uno = common::uno(Slot::Card(card(&image).with_fault(at, what)));
            let said = to_run(&mut uno);
            let dead = matches!(what, What::Removed | What::Stuck);
            assert!(!dead || said.contains(UNREADABLE), "{case}: {said:?}");
            kept += usize::from(said.contains(KEPT));
            uno.set_inputs(0b1001);
            uno.run_ms(50).unwrap();
            assert_eq!(uno.outputs(), 0b1001, "{case}");
            assert_only_state_changed(&before, uno.card().unwrap(), &case);
            runs += 1;
        }
    }
    println!("{runs} card faults over STATE.TXT: all in RUN, {kept} overcome");
    assert!(0 < kept && kept < runs);
}
