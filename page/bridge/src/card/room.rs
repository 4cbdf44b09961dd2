//! How much room is left on a card: what its FAT says, whatever stands in it.

use unoclp_card::{Block, Device};

/// Bytes of a block.
pub(super) const BLOCK: usize = 512;
/// Clusters from which on a volume is FAT32, and below which it is FAT12, which no board reads.
const FAT32: u32 = 65_525;
const FAT16: u32 = 4_085;
/// Clusters that are counted at most: these cards live in memory.
const MOST: u32 = 1 << 20;

/// Where a volume has what.
struct Volume {
    /// The first block of the first FAT.
    fat: u32,
    clusters: u32,
    /// Bytes of a cluster.
    cluster: u64,
    /// Bytes of an entry of the FAT.
    entry: u32,
}

/// Bytes that are free; none where this is no card with FAT16 or FAT32.
pub(super) fn free<D: Device>(card: &mut D) -> Option<u64> {
    let volume = volume(card)?;
    let each = BLOCK as u32 / volume.entry;
    let mut free = 0;
    for block in 0..=(volume.clusters + 1) / each {
        card.read(volume.fat.checked_add(block)?).ok()?;
        let first = block * each;
        let entries = card.block().chunks(volume.entry as usize);
        // The first two stand for no cluster.
        let ours = (first..)
            .zip(entries)
            .filter(|&(number, _)| (2..volume.clusters + 2).contains(&number));
        free += ours
            .filter(|(_, entry)| entry.iter().all(|&byte| byte == 0))
            .count() as u64;
    }
    Some(free * volume.cluster)
}

/// The volume at block 0, or that of the first partition.
fn volume<D: Device>(card: &mut D) -> Option<Volume> {
    card.read(0).ok()?;
    if let Some(volume) = at(card.block(), 0) {
        return Some(volume);
    }
    let start = four(card.block(), 454);
    card.read(start).ok()?;
    at(card.block(), start)
}

/// The volume that begins with this block.
fn at(boot: &Block, start: u32) -> Option<Volume> {
    let sectors = u32::from(boot[13]);
    if two(boot, 510) != 0xAA55 || two(boot, 11) != BLOCK as u32 || sectors == 0 {
        return None;
    }
    let (reserved, fats) = (two(boot, 14), u32::from(boot[16]));
    let root = (two(boot, 17) * 32).div_ceil(BLOCK as u32);
    let length = first_not_0(two(boot, 22), four(boot, 36));
    let all = first_not_0(two(boot, 19), four(boot, 32));
    let before = fats.checked_mul(length)?.checked_add(reserved + root)?;
    let clusters = all.checked_sub(before)? / sectors;
    let entry = if clusters < FAT32 { 2 } else { 4 };
    let is_whole = u64::from(length) * BLOCK as u64 >= (u64::from(clusters) + 2) * u64::from(entry);
    ((FAT16..=MOST).contains(&clusters) && is_whole).then_some(Volume {
        fat: start.checked_add(reserved)?,
        clusters,
        cluster: u64::from(sectors) * BLOCK as u64,
        entry,
    })
}

fn first_not_0(first: u32, other: u32) -> u32 {
    if first == 0 { other } else { first }
}

fn two(block: &Block, at: usize) -> u32 {
    u32::from(u16::from_le_bytes([block[at], block[at + 1]]))
}

fn four(block: &Block, at: usize) -> u32 {
    two(block, at) | two(block, at + 2) << 16
}
