//! Which cards hold a volume, and where it is found.

use std::io::Cursor;

use crate::common::raw::{Raw, partition_table};
use crate::common::{PROGRAM, walk_image};
use unoclp_card::Error;
use unoclp_card::image::Fat;

const BLOCK: usize = 512;
const BOTH: [Fat; 2] = [Fat::Fat16, Fat::Fat32];
const TEXT: &[u8] = b"program";

fn volume(fat: Fat) -> Raw {
    let mut raw = Raw::new(fat);
    raw.file(PROGRAM, &[20], TEXT);
    raw
}

/// A card with a partition table and a volume from block 8 on.
fn partitioned(entries: &[(u8, u32, u32)], fat: Fat) -> Vec<u8> {
    let mut card = vec![0; 8 * BLOCK];
    card[..BLOCK].copy_from_slice(&partition_table(entries));
    card.extend(volume(fat).image);
    card
}

#[test]
fn a_bare_volume_with_partition_entries() {
    for fat in BOTH {
        let mut raw = volume(fat);
        let table = partition_table(&[(0x06, 1, 100), (0x0C, 2, 100)]);
        raw.put(446, &table[446..]);
        assert_eq!(walk_image(&raw.image), Ok(TEXT.into()), "{fat:?}");
    }
}

#[test]
fn every_entry_of_the_table_and_every_type() {
    for fat in BOTH {
        for slot in 0..4 {
            for kind in 0..=0xFF {
                let mut entries = [(0, 0, 0); 4];
                entries[slot] = (kind, 8, 100);
                let expected = match kind {
                    0x04 | 0x06 | 0x0B | 0x0C | 0x0E => Ok(TEXT.into()),
                    _ => Err(Error::NoVolume),
                };
                let card = partitioned(&entries, fat);
                assert_eq!(walk_image(&card), expected, "{slot} {kind:#x}");
            }
        }
    }
}

#[test]
fn the_first_partition_that_is_a_volume() {
    // Before it one of another kind, one that is empty, and one that is block 0 itself.
    let card = partitioned(
        &[(0x83, 8, 1), (0x06, 3, 1), (0x0E, 0, 1), (0x0C, 8, 100)],
        Fat::Fat32,
    );
    assert_eq!(walk_image(&card), Ok(TEXT.into()));
    // A table without its mark is none.
    let mut card = partitioned(&[(0x0C, 8, 100)], Fat::Fat32);
    card[511] = 0;
    assert_eq!(walk_image(&card), Err(Error::NoVolume));
}

#[test]
fn no_volume() {
    let mut exfat = vec![0; 64 * BLOCK];
    exfat[..11].copy_from_slice(b"\xEB\x76\x90EXFAT   ");
    exfat[108..112].copy_from_slice(&[9, 3, 1, 0x80]);
    exfat[510..512].copy_from_slice(&[0x55, 0xAA]);
    let in_partition = [
        partition_table(&[(0x07, 1, 64)]).to_vec(),
        partition_table(&[(0x0C, 1, 64)]).to_vec(),
    ]
    .map(|mut card| {
        card.extend(&exfat);
        card
    });

    let mut ntfs = Raw::new(Fat::Fat16).image;
    ntfs[3..11].copy_from_slice(b"NTFS    ");
    ntfs[14..21].fill(0);

    let gpt = partition_table(&[(0xEE, 1, u32::MAX)]);

    let mut fat12 = vec![0; 2880 * BLOCK];
    let options = fatfs::FormatVolumeOptions::new();
    fatfs::format_volume(Cursor::new(&mut fat12), options).unwrap();
    fatfs::FileSystem::new(Cursor::new(&mut fat12), fatfs::FsOptions::new())
        .unwrap()
        .root_dir()
        .create_file("PROGRAM.TXT")
        .unwrap();

    for (what, card) in [
        ("zeros", &vec![0; 64 * BLOCK]),
        ("an erased card", &vec![0xFF; 64 * BLOCK]),
        ("exFAT", &exfat),
        ("exFAT in a partition", &in_partition[0]),
        ("exFAT in a partition that says FAT32", &in_partition[1]),
        ("NTFS", &ntfs),
        ("GPT", &gpt.to_vec()),
        ("FAT12", &fat12),
    ] {
        assert_eq!(walk_image(card), Err(Error::NoVolume), "{what}");
    }
}

/// Each field of the boot sector that can rule a volume out, with values that do.
#[test]
fn boot_sectors_that_make_no_sense() {
    let fields: &[(&str, usize, &[&[u8]])] = &[
        (
            "bytes of a block",
            11,
            &[&[0, 0], &[0, 4], &[0, 16], &[1, 2]],
        ),
        ("blocks of a cluster", 13, &[&[0], &[3], &[6], &[0xFF]]),
        ("reserved blocks", 14, &[&[0, 0], &[0xFF, 0xFF]]),
        ("FATs", 16, &[&[0], &[3], &[0xFF]]),
        ("root entries", 17, &[&[0xFF, 0xFF]]),
        ("blocks in all", 19, &[&[0, 0], &[1, 0], &[17, 0]]),
        ("the mark", 510, &[&[0, 0], &[0xAA, 0x55], &[0x55, 0]]),
    ];
    for fat in BOTH {
        for &(field, at, values) in fields {
            for value in values {
                // FAT32 with few clusters is a volume all the same.
                let mut raw = volume(fat);
                raw.put(at, value);
                let result = walk_image(&raw.image);
                let small = fat == Fat::Fat32 && matches!(field, "blocks in all");
                let expected = if small && value[0] == 17 {
                    // 15 clusters; the file is in the 19th.
                    Error::Damaged
                } else {
                    Error::NoVolume
                };
                assert_eq!(result, Err(expected), "{fat:?} {field} {value:?}");
            }
        }
    }
}

#[test]
fn fat16_has_4085_to_65524_clusters() {
    for (clusters, found) in [(4084, false), (4085, true), (65_524, true), (65_525, false)] {
        let mut raw = volume(Fat::Fat16);
        raw.put(19, &[0, 0]);
        raw.put(32, &(1 + 17 + 2 + clusters as u32).to_le_bytes());
        let expected = if found {
            Ok(TEXT.into())
        } else {
            Err(Error::NoVolume)
        };
        assert_eq!(walk_image(&raw.image), expected, "{clusters}");
    }
}

/// Sizes near the limits of 32 bits add up to a wrong place at worst.
#[test]
fn sizes_of_the_largest_kind() {
    let mut raw = volume(Fat::Fat32);
    raw.put(19, &[0, 0]);
    raw.put(32, &u32::MAX.to_le_bytes());
    assert_eq!(walk_image(&raw.image), Ok(TEXT.into()));
    raw.put(36, &u32::MAX.to_le_bytes());
    assert!(matches!(walk_image(&raw.image), Err(Error::Device(_))));

    let card = partitioned(&[(0x0C, u32::MAX, u32::MAX)], Fat::Fat32);
    assert!(matches!(walk_image(&card), Err(Error::Device(_))));
}
