//! STATE.TXT: its template, what a board wrote into it, and all else that is on a card.

use super::{firmware, to_run};
use fatfs::{Dir, FileSystem, FsOptions};
use std::collections::BTreeMap;
use std::io::{Cursor, ErrorKind, Read};
use std::ops::Range;
use std::path::Path;
use std::process::Command;
use std::sync::atomic::{AtomicUsize, Ordering};
use unoclp_card::image::{Fat, Image};
use unoclp_uno_sim::sd::{Kind, SdCard};
use unoclp_uno_sim::{Slot, Uno};

pub const BLOCK: usize = 512;

/// Outputs 01 to 04 follow inputs 01 to 04.
pub const FOLLOW: &str =
    "0\n827301\n877901\n787600\n827302\n877902\n787600\n827303\n877903\n787600\n827304\n877904\n";

/// What the serial port says of a STATE.TXT that is kept.
pub const KEPT: &str = "state: kept in STATE.TXT\r\n";

/// The file that users copy to their cards. Each `#` stands for a digit.
pub fn template() -> Vec<u8> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../programs/STATE.TXT");
    let template = std::fs::read(&path).unwrap_or_else(|error| panic!("{path:?}: {error}"));
    assert_eq!(template.len(), BLOCK);
    template
}

/// A FAT16 volume in a partition with this program and the template.
pub fn image(text: &str) -> Image {
    Image::new(Fat::Fat16)
        .file("PROGRAM.TXT", text)
        .file("STATE.TXT", template())
}

/// The card of [`image`].
pub fn state_card(text: &str) -> SdCard {
    SdCard::new(Kind::Sdhc, image(text).build().unwrap()).unwrap()
}

/// A board that has just begun to run the program of this card, and keeps STATE.TXT.
pub fn running(card: SdCard) -> Uno {
    let mut uno = Uno::with_program(firmware(), Slot::Card(card)).unwrap();
    let said = to_run(&mut uno);
    assert!(said.contains(KEPT), "{said:?}");
    uno
}

/// How many blocks have been written to the card in the slot.
pub fn saves(uno: &Uno) -> usize {
    uno.card().unwrap().log().writes.len()
}

/// Runs until a block has come to the card, and the card has been asked for its status: until the
/// save is over.
pub fn run_to_save(uno: &mut Uno) -> Saved {
    let done = |uno: &Uno| uno.card().unwrap().log().count(13);
    let before = done(uno);
    for _ in 0..2000 {
        uno.run_ms(1).unwrap();
        if done(uno) > before {
            return Saved::last(uno.card().unwrap());
        }
    }
    panic!("no save within 2 s: {:?}", uno.serial());
}

/// What the block says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Saved {
    /// Bit n is point n + 1.
    pub inputs: u8,
    pub outputs: u8,
    /// Seconds.
    pub uptime: u64,
    /// Microseconds.
    pub last: u64,
    pub least: u64,
    pub most: u64,
}

impl Saved {
    /// What the block says that was written last.
    pub fn last(card: &SdCard) -> Saved {
        let write = card.log().writes.last().expect("nothing was written");
        Saved::parse(&card.image()[write.block * BLOCK..][..BLOCK])
    }

    /// Reads a block, which must be the template with numbers for `#`, right-aligned.
    pub fn parse(block: &[u8]) -> Saved {
        let mut expected = template();
        let mut values = Vec::new();
        for field in fields(&expected) {
            let text = String::from_utf8_lossy(&block[field.clone()]);
            let value: u64 = text.trim_start().parse().unwrap_or_else(|error| {
                panic!("{text:?}: {error} in {:?}", String::from_utf8_lossy(block))
            });
            let width = field.len();
            expected[field].copy_from_slice(format!("{value:width$}").as_bytes());
            values.push(value);
        }
        assert_eq!(
            String::from_utf8_lossy(block),
            String::from_utf8_lossy(&expected)
        );
        let [i1, i2, i3, i4, o1, o2, o3, o4, uptime, last, least, most] = values[..] else {
            panic!("the template has {} fields", values.len())
        };
        Saved {
            inputs: bits([i1, i2, i3, i4]),
            outputs: bits([o1, o2, o3, o4]),
            uptime,
            last,
            least,
            most,
        }
    }
}

/// Where the `#` of each number stand.
fn fields(template: &[u8]) -> Vec<Range<usize>> {
    let mut end = 0;
    template
        .chunk_by(|a, b| (*a == b'#') == (*b == b'#'))
        .filter_map(|run| {
            end += run.len();
            (run[0] == b'#').then_some(end - run.len()..end)
        })
        .collect()
}

fn bits(points: [u64; 4]) -> u8 {
    (0..).zip(points).fold(0, |bits, (n, point)| {
        assert!(point <= 1, "a point is 0 or 1, not {point}");
        bits | (point as u8) << n
    })
}

/// The volume of an image: after the partition table, where there is one.
pub fn volume(image: &[u8]) -> Range<usize> {
    let word =
        |at: usize| u32::from_le_bytes([image[at], image[at + 1], image[at + 2], image[at + 3]]);
    // A boot sector begins with a jump.
    if matches!(image[0], 0xE9 | 0xEB) {
        return 0..image.len();
    }
    let (start, blocks) = (word(446 + 8) as usize, word(446 + 12) as usize);
    start * BLOCK..(start + blocks) * BLOCK
}

/// Every file of a card by its path, as the crate `fatfs` reads them.
pub fn files(image: &[u8]) -> BTreeMap<String, Vec<u8>> {
    let volume = Cursor::new(image[volume(image)].to_vec());
    let volume = FileSystem::new(volume, FsOptions::new()).unwrap();
    let mut files = BTreeMap::new();
    collect(&volume.root_dir(), "", &mut files);
    files
}

fn collect(folder: &Dir<'_, Cursor<Vec<u8>>>, path: &str, files: &mut BTreeMap<String, Vec<u8>>) {
    for entry in folder.iter() {
        let entry = entry.unwrap();
        let name = entry.file_name();
        if entry.is_file() {
            let mut bytes = Vec::new();
            entry.to_file().read_to_end(&mut bytes).unwrap();
            files.insert(format!("{path}{name}"), bytes);
        } else if !matches!(name.as_str(), "." | "..") {
            collect(&entry.to_dir(), &format!("{path}{name}/"), files);
        }
    }
}

/// Holds a card against the image that it had: all that was written went to the first block of
/// STATE.TXT, and nothing else has changed.
pub fn assert_only_state_changed(before: &[u8], card: &SdCard, case: &str) {
    let (after, padding) = card.image().split_at(before.len());
    assert!(
        padding.iter().all(|&byte| byte == 0),
        "{case}: behind the image"
    );
    let writes = &card.log().writes;
    let place = writes.first().map(|write| write.block);
    assert!(
        writes.iter().all(|write| Some(write.block) == place),
        "{case}: {writes:?}"
    );
    let blocks = before.chunks(BLOCK).zip(after.chunks(BLOCK));
    for (n, (old, new)) in blocks.enumerate() {
        assert!(
            old == new || Some(n) == place,
            "{case}: block {n} was changed"
        );
    }

    let (old, mut new) = (files(before), files(after));
    for (name, old) in &old {
        let new = new.remove(name).unwrap_or_default();
        let kept = match place {
            Some(place) if name.eq_ignore_ascii_case("STATE.TXT") => {
                assert!(new.starts_with(&after[place * BLOCK..][..BLOCK]), "{case}");
                BLOCK
            }
            _ => 0,
        };
        assert!(
            old.len() == new.len() && old[kept..] == new[kept..],
            "{case}: {name}"
        );
    }
    assert!(new.is_empty(), "{case}: {:?}", new.keys());
}

/// Has `fsck.fat` look at the volume of an image; it must find nothing.
pub fn assert_sound(image: &[u8], case: &str) {
    static NUMBER: AtomicUsize = AtomicUsize::new(0);
    let number = NUMBER.fetch_add(1, Ordering::Relaxed);
    let file = Path::new(env!("CARGO_TARGET_TMPDIR"))
        .join(format!("volume-{}-{number}.img", std::process::id()));
    std::fs::write(&file, &image[volume(image)]).unwrap();
    let output = fsck(&file);
    std::fs::remove_file(&file).unwrap();
    assert!(
        output.status.success(),
        "{case}: {}{}",
        String::from_utf8_lossy(&output.stdout),
        String::from_utf8_lossy(&output.stderr)
    );
}

fn fsck(file: &Path) -> std::process::Output {
    // Debian keeps it in a folder that is in the PATH of root alone.
    for program in ["fsck.fat", "/usr/sbin/fsck.fat"] {
        match Command::new(program).arg("-n").arg(file).output() {
            Err(error) if error.kind() == ErrorKind::NotFound => {}
            output => return output.unwrap_or_else(|error| panic!("{program}: {error}")),
        }
    }
    panic!("there is no fsck.fat: `cargo xtask setup` installs it (Debian's package dosfstools)");
}
