//! Random damage to what describes a volume: no panic, no write, and no walk without end.

use std::ops::Range;

use crate::common::raw::{FILE, Raw, partition_table};
use crate::common::{Card, PROGRAM, Random, bytes, walk};
use unoclp_card::Error;
use unoclp_card::image::Fat;

const BLOCK: usize = 512;
const ROUNDS: usize = 40_000;

/// A small card with a file whose chain jumps about, and the places that describe it.
fn card(fat: Fat, bare: bool) -> (Vec<u8>, Vec<Range<usize>>) {
    let mut raw = Raw::new(fat);
    // The file's clusters, and those of FAT32's root folder, which on FAT16 hold nothing.
    let chain = [40, 20, 21, 22, 90, 10];
    let clusters = [2, 30, 4];
    raw.chain(&clusters);
    let entry = |raw: &Raw, n: usize| match fat {
        Fat::Fat16 => raw.root() + 32 * n,
        Fat::Fat32 => raw.cluster(clusters[n / 16]) + 32 * (n % 16),
    };
    let last = match fat {
        Fat::Fat16 => 2 * 16 - 1,
        Fat::Fat32 => 3 * 16 - 1,
    };
    // Every entry is in use, and the last one is the file's.
    for n in 0..last {
        raw.entry(entry(&raw, n), b"OTHER   TXT", FILE, 60, 1);
    }
    raw.entry(entry(&raw, last), PROGRAM, FILE, 40, 5 * 512 + 9);
    raw.chain(&chain);

    // The boot sector, the FAT entries of both chains, an entry of the folder, and the file's.
    let mut places = vec![11..48, 510..512];
    places.extend([0, last].map(|n| entry(&raw, n)..entry(&raw, n) + 32));
    let entry_bytes = match fat {
        Fat::Fat16 => 2,
        Fat::Fat32 => 4,
    };
    for cluster in chain.into_iter().chain(clusters) {
        let at = BLOCK + entry_bytes * cluster as usize;
        places.push(at..at + entry_bytes);
    }
    if bare {
        return (raw.image, places);
    }
    let mut card = vec![0; 4 * BLOCK];
    card[..BLOCK].copy_from_slice(&partition_table(&[(0x83, 9, 9), (0x06, 4, 100)]));
    card.extend(raw.image);
    for place in &mut places {
        *place = place.start + 4 * BLOCK..place.end + 4 * BLOCK;
    }
    places.push(446..512);
    (card, places)
}

fn mutate(fat: Fat, bare: bool) {
    let (mut image, places) = card(fat, bare);
    let right = walk(&Card::new(&image), PROGRAM).unwrap();
    assert_eq!(right.len(), 5 * 512 + 9);

    // A walk enters a cluster three times at most, and reads a block of the FAT for each. There
    // are two walks, the folder's and the file's, and ten blocks for finding the volume.
    let most_reads = 2 * 3 * 2 * (image.len() / BLOCK) + 10;
    let mut seen = [0_usize; 5];
    let mut random = Random(0x5EED ^ u64::from(bare) << 32 ^ fat as u64);
    for round in 0..ROUNDS {
        let undo: Vec<(usize, u8)> = (0..1 + random.below(6))
            .map(|_| {
                let place = places[random.below(places.len())].clone();
                let at = place.start + random.below(place.len());
                let old = image[at];
                image[at] = match random.below(4) {
                    0 => 0,
                    1 => 0xFF,
                    2 => old ^ 1 << random.below(8),
                    _ => random.below(256) as u8,
                };
                (at, old)
            })
            .collect();

        let card = Card::new(&image);
        let result = walk(&card, PROGRAM);
        let reads = card.reads.get();
        assert!(
            reads <= most_reads,
            "round {round}: {reads} reads after {undo:?}"
        );
        seen[match result {
            Ok(_) => 0,
            Err(Error::Device(_)) => 1,
            Err(Error::NoVolume) => 2,
            Err(Error::NotFound) => 3,
            Err(Error::Damaged) => 4,
        }] += 1;

        for (at, old) in undo.into_iter().rev() {
            image[at] = old;
        }
    }
    // The damage was of every kind, and some of it did none. Few places lead off the card.
    let [read, _, no_volume, not_found, damaged] = seen;
    for times in [read, no_volume, not_found, damaged] {
        assert!(times > ROUNDS / 50, "{seen:?}");
    }
    assert!(walk(&Card::new(&image), PROGRAM) == Ok(right));
}

#[test]
fn fat16_in_a_partition() {
    mutate(Fat::Fat16, false);
}

#[test]
fn fat16_bare() {
    mutate(Fat::Fat16, true);
}

#[test]
fn fat32_in_a_partition() {
    mutate(Fat::Fat32, false);
}

#[test]
fn fat32_bare() {
    mutate(Fat::Fat32, true);
}

/// Blocks of nothing but random bytes, as boot sector and as everything else.
#[test]
fn noise() {
    let mut random = Random(2);
    for length in 0..200 {
        let mut image = bytes(length % 7 * BLOCK);
        image.resize(64 * BLOCK, random.below(256) as u8);
        image[510..512].copy_from_slice(&[0x55, 0xAA]);
        let card = Card::new(&image);
        assert!(walk(&card, PROGRAM).is_err());
        assert!(card.reads.get() <= 2 * 3 * 2 * 64 + 10);
    }
}
