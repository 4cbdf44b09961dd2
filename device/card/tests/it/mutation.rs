//! Random damage to what describes a volume: no panic, no write, and no walk without end.

use crate::common::small::{self, Small};
use crate::common::{Card, PROGRAM, Random, bytes, walk};
use unoclp_card::Error;
use unoclp_card::image::Fat;
use unoclp_testing::rounds;

const BLOCK: usize = 512;
/// On each kind of card.
const ROUNDS: u32 = 40_000;

fn mutate(fat: Fat, bare: bool) {
    let Small { mut image, places } = small::card(fat, bare);
    let right = walk(&Card::new(&image), PROGRAM).unwrap();
    assert_eq!(right.len(), 5 * 512 + 9);

    let most_reads = small::most_reads(&image);
    let mut seen = [0; 5];
    let mut random = Random(0x5EED ^ u64::from(bare) << 32 ^ fat as u64);
    let rounds = rounds(ROUNDS);
    for round in 0..rounds {
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
        assert!(times > rounds / 50, "{seen:?}");
    }
    assert!(walk(&Card::new(&image), PROGRAM) == Ok(right));
}

#[test]
fn random_damage_to_fat16_in_a_partition() {
    mutate(Fat::Fat16, false);
}

#[test]
fn random_damage_to_fat16_bare() {
    mutate(Fat::Fat16, true);
}

#[test]
fn random_damage_to_fat32_in_a_partition() {
    mutate(Fat::Fat32, false);
}

#[test]
fn random_damage_to_fat32_bare() {
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
        assert!(card.reads.get() <= small::most_reads(&image));
    }
}
