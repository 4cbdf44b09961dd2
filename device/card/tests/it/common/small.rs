//! A small card that is worth damaging.

use super::PROGRAM;
use super::raw::{FILE, Raw, partition_table};
use std::ops::Range;
use unoclp_card::image::Fat;

const BLOCK: usize = 512;

/// An image, and the bytes of it that describe the volume and the file.
pub struct Small {
    pub image: Vec<u8>,
    pub places: Vec<Range<usize>>,
}

/// The most blocks that may be read of an image of this size, whatever stands in it. A walk enters a
/// cluster three times at most, and reads a block of the FAT for each. There are two walks, the folder's
/// and the file's, and ten blocks for finding the volume.
pub fn most_reads(image: &[u8]) -> usize {
    2 * 3 * 2 * (image.len() / BLOCK) + 10
}

/// A small card with a file whose chain jumps about, and the places that describe it.
pub fn card(fat: Fat, bare: bool) -> Small {
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
        return Small {
            image: raw.image,
            places,
        };
    }
    let mut card = vec![0; 4 * BLOCK];
    card[..BLOCK].copy_from_slice(&partition_table(&[(0x83, 9, 9), (0x06, 4, 100)]));
    card.extend(raw.image);
    for place in &mut places {
        *place = place.start + 4 * BLOCK..place.end + 4 * BLOCK;
    }
    places.push(446..512);
    Small {
        image: card,
        places,
    }
}
