//! Cards that no tool would write: each gets the error that says so, after few reads.

use crate::common::raw::{FILE, FOLDER, LABEL, Raw};
use crate::common::{Card, NoBlock, PROGRAM, bytes, walk, walk_image};
use unoclp_card::Error;
use unoclp_card::image::Fat;

const BLOCK: usize = 512;
const BOTH: [Fat; 2] = [Fat::Fat16, Fat::Fat32];

/// A row of clusters and what follows the last one, with what the walk makes of it.
const CHAINS: &[(&str, &[u32], u32)] = &[
    ("too short", &[10, 11], 0x0FFF_FFFF),
    ("too short, another mark", &[10, 11], 0x0FFF_FFF8),
    ("to a free cluster", &[10, 11], 0),
    ("to cluster 1", &[10, 11], 1),
    ("to a bad cluster", &[10, 11], 0x0FFF_FFF7),
    ("to a reserved number", &[10, 11], 0x0FFF_FFF0),
    ("to itself", &[10], 10),
    ("to the one before", &[10, 11], 10),
    ("back to the first", &[10, 11, 12, 13, 14, 15, 16], 10),
    ("back into the middle", &[10, 14, 13, 12, 11, 15], 12),
];

#[test]
fn a_file_that_has_fewer_clusters_than_bytes() {
    for fat in BOTH {
        let mut raw = Raw::new(fat);
        let beyond = raw.last_cluster() + 1;
        for &(what, clusters, next) in
            CHAINS
                .iter()
                .chain(&[("out of the volume", &[10, 11][..], beyond)])
        {
            raw.entry(raw.root(), PROGRAM, FILE, clusters[0], u32::MAX);
            raw.chain(clusters);
            raw.follow(clusters[clusters.len() - 1], next);
            let card = Card::new(&raw.image);
            assert_eq!(walk(&card, PROGRAM), Err(Error::Damaged), "{fat:?} {what}");
            // A circle is gone round no more than three times.
            let reads = card.reads.get();
            assert!(reads < 3 * 2 * clusters.len() + 10, "{what}: {reads} reads");
        }
    }
}

#[test]
fn a_file_that_starts_nowhere() {
    for fat in BOTH {
        let mut raw = Raw::new(fat);
        for first in [0, 1, raw.last_cluster() + 1, 0xFFF7, 0xFFFF] {
            raw.entry(raw.root(), PROGRAM, FILE, first, 1);
            assert_eq!(
                walk_image(&raw.image),
                Err(Error::Damaged),
                "{fat:?} {first}"
            );
            // An empty file needs no cluster.
            raw.entry(raw.root(), PROGRAM, FILE, first, 0);
            assert_eq!(walk_image(&raw.image), Ok(vec![]), "{fat:?} {first}");
        }
    }
}

#[test]
fn a_root_folder_whose_chain_breaks() {
    for &(what, clusters, next) in CHAINS
        .iter()
        .chain(&[("out of the volume", &[10, 11][..], 102)])
    {
        let mut raw = Raw::new(Fat::Fat32);
        raw.put(44, &clusters[0].to_le_bytes());
        raw.chain(clusters);
        raw.follow(clusters[clusters.len() - 1], next);
        // Every entry in use, so that the folder goes on.
        for &cluster in clusters {
            for entry in 0..16 {
                raw.entry(
                    raw.cluster(cluster) + 32 * entry,
                    b"OTHER   TXT",
                    FILE,
                    99,
                    1,
                );
            }
        }
        let ends = next >= 0x0FFF_FFF8;
        let expected = if ends {
            Error::NotFound
        } else {
            Error::Damaged
        };
        let card = Card::new(&raw.image);
        assert_eq!(walk(&card, PROGRAM), Err(expected), "{what}");
        let reads = card.reads.get();
        assert!(reads < 3 * 2 * clusters.len() + 10, "{what}: {reads} reads");
    }
}

#[test]
fn a_root_folder_that_starts_nowhere() {
    for first in [0, 1, 102, u32::MAX] {
        let mut raw = Raw::new(Fat::Fat32);
        raw.put(44, &first.to_le_bytes());
        let result = walk_image(&raw.image);
        // The largest numbers are marks of an end: a folder of no cluster.
        let ends = first == u32::MAX;
        let expected = if ends {
            Error::NotFound
        } else {
            Error::Damaged
        };
        assert_eq!(result, Err(expected), "{first}");
    }
}

/// Order and marks that tools do not write but the specification allows.
#[test]
fn odd_chains_that_are_right() {
    let put_in = bytes(4 * BLOCK + 17);
    for fat in BOTH {
        let mut raw = Raw::new(fat);
        let last = raw.last_cluster();
        raw.file(PROGRAM, &[last, 40, 60, 12, 90], &put_in);
        assert_eq!(walk_image(&raw.image), Ok(put_in.clone()), "{fat:?}");

        // A chain longer than the file.
        raw.follow(90, 50);
        assert_eq!(walk_image(&raw.image), Ok(put_in.clone()), "{fat:?}");

        // The upper four bits of FAT32 say nothing; FAT16 has no upper half of a first cluster.
        match fat {
            Fat::Fat32 => raw.follow(40, 0xF000_0000 | 60),
            Fat::Fat16 => raw.put(raw.root() + 20, &[0x12, 0x34]),
        }
        assert_eq!(walk_image(&raw.image), Ok(put_in.clone()), "{fat:?}");
    }
}

#[test]
fn entries_that_are_not_the_file() {
    for fat in BOTH {
        let mut raw = Raw::new(fat);
        raw.file(PROGRAM, &[20], b"program");
        assert_eq!(walk_image(&raw.image), Ok(b"program".into()), "{fat:?}");
        let root = raw.root();
        for attributes in [LABEL, FOLDER, 0x0F, FILE | FOLDER, FILE | LABEL] {
            raw.put(root + 11, &[attributes]);
            assert_eq!(
                walk_image(&raw.image),
                Err(Error::NotFound),
                "{attributes:#x}"
            );
            // It hides no file after it.
            let mut both = raw.clone();
            both.entry(root + 32, PROGRAM, 0, 20, 7);
            assert_eq!(
                walk_image(&both.image),
                Ok(b"program".into()),
                "{attributes:#x}"
            );
        }
        for attributes in [0, 0x01, 0x02, 0x04, FILE, 0x27] {
            raw.put(root + 11, &[attributes]);
            assert_eq!(
                walk_image(&raw.image),
                Ok(b"program".into()),
                "{attributes:#x}"
            );
        }
        // Small letters in the stored name, which some tools write.
        raw.put(root, b"Program txt");
        assert_eq!(walk_image(&raw.image), Ok(b"program".into()));
        // Deleted.
        raw.put(root, &[0xE5]);
        assert_eq!(walk_image(&raw.image), Err(Error::NotFound));
        // After the end of the folder.
        raw.put(root, &[0]);
        raw.entry(root + 32, PROGRAM, FILE, 20, 7);
        assert_eq!(walk_image(&raw.image), Err(Error::NotFound));
    }
}

/// A root folder of which every entry is in use ends with its last block.
#[test]
fn a_full_root_folder() {
    for fat in BOTH {
        let mut raw = Raw::new(fat);
        let entries = match fat {
            Fat::Fat16 => 32,
            Fat::Fat32 => 16,
        };
        for entry in 0..entries {
            raw.entry(raw.root() + 32 * entry, b"OTHER   TXT", FILE, 99, 1);
        }
        // What lies after it is no entry.
        raw.entry(raw.root() + 32 * entries, PROGRAM, FILE, 20, 7);
        assert_eq!(walk_image(&raw.image), Err(Error::NotFound), "{fat:?}");
        raw.entry(raw.root() + 32 * (entries - 1), PROGRAM, FILE, 20, 7);
        raw.put(raw.cluster(20), b"program");
        assert_eq!(walk_image(&raw.image), Ok(b"program".into()), "{fat:?}");
    }
}

/// Whichever read fails, the card's own error comes out.
#[test]
fn a_card_that_fails() {
    for fat in BOTH {
        let mut raw = Raw::new(fat);
        raw.file(PROGRAM, &[20, 21, 22], &bytes(2 * BLOCK + 1));
        let card = Card::new(&raw.image);
        walk(&card, PROGRAM).unwrap();
        for read in 0..card.reads.get() {
            let mut card = Card::new(&raw.image);
            card.fails_at = Some(read);
            assert_eq!(
                walk(&card, PROGRAM),
                Err(Error::Device(NoBlock::Asked)),
                "{read}"
            );
        }
        // A card smaller than its volume says.
        let cut = &raw.image[..raw.cluster(22)];
        assert_eq!(walk_image(cut), Err(Error::Device(NoBlock::Beyond)));
    }
}
