//! Volumes laid out by hand, for what no tool writes: chains in any order, damage, odd numbers.

use unoclp_card::image::Fat;

const BLOCK: usize = 512;

/// Attributes of an entry of a folder.
pub const FILE: u8 = 0x20;
pub const FOLDER: u8 = 0x10;
pub const LABEL: u8 = 0x08;

/// A bare volume with one FAT and clusters of one block, as many as the FAT has entries for.
///
/// FAT16: boot sector, 17 blocks of FAT, 2 blocks of root folder, 4,200 clusters.
/// FAT32: boot sector, 1 block of FAT, 100 clusters, of which cluster 2 begins the root folder.
/// So few are none by the specification, yet PCs read it, and the tests stay fast.
#[derive(Clone)]
pub struct Raw {
    pub fat: Fat,
    pub image: Vec<u8>,
}

impl Raw {
    pub fn new(fat: Fat) -> Raw {
        let (clusters, fat_blocks, root_entries) = match fat {
            Fat::Fat16 => (4200, 17, 32),
            Fat::Fat32 => (100, 1, 0),
        };
        let blocks = 1 + fat_blocks + root_entries / 16 + clusters;
        let mut raw = Raw {
            fat,
            image: vec![0; blocks * BLOCK],
        };
        raw.put(0, &[0xEB, 0x58, 0x90]);
        raw.put(3, b"BY HAND ");
        raw.put(11, &512_u16.to_le_bytes());
        raw.put(13, &[1]);
        raw.put(14, &1_u16.to_le_bytes());
        raw.put(16, &[1]);
        raw.put(17, &(root_entries as u16).to_le_bytes());
        raw.put(19, &(blocks as u16).to_le_bytes());
        raw.put(21, &[0xF8]);
        raw.put(510, &[0x55, 0xAA]);
        match fat {
            Fat::Fat16 => raw.put(22, &(fat_blocks as u16).to_le_bytes()),
            Fat::Fat32 => {
                raw.put(36, &(fat_blocks as u32).to_le_bytes());
                raw.put(44, &2_u32.to_le_bytes());
                raw.follow(2, 0x0FFF_FFFF);
            }
        }
        raw
    }

    /// The highest cluster number.
    pub fn last_cluster(&self) -> u32 {
        match self.fat {
            Fat::Fat16 => 4201,
            Fat::Fat32 => 101,
        }
    }

    /// Overwrites bytes of the image.
    pub fn put(&mut self, at: usize, bytes: &[u8]) {
        self.image[at..at + bytes.len()].copy_from_slice(bytes);
    }

    /// Writes the FAT entry of a cluster.
    pub fn follow(&mut self, cluster: u32, next: u32) {
        match self.fat {
            Fat::Fat16 => self.put(BLOCK + 2 * cluster as usize, &(next as u16).to_le_bytes()),
            Fat::Fat32 => self.put(BLOCK + 4 * cluster as usize, &next.to_le_bytes()),
        }
    }

    /// Chains clusters, and ends the chain.
    pub fn chain(&mut self, clusters: &[u32]) {
        for pair in clusters.windows(2) {
            self.follow(pair[0], pair[1]);
        }
        self.follow(clusters[clusters.len() - 1], 0x0FFF_FFFF);
    }

    /// The byte where a cluster starts.
    pub fn cluster(&self, cluster: u32) -> usize {
        let first = match self.fat {
            Fat::Fat16 => 20,
            Fat::Fat32 => 2,
        };
        (first + cluster as usize - 2) * BLOCK
    }

    /// The byte where the first block of the root folder starts.
    pub fn root(&self) -> usize {
        match self.fat {
            Fat::Fat16 => 18 * BLOCK,
            Fat::Fat32 => self.cluster(2),
        }
    }

    /// Writes an entry of a folder.
    pub fn entry(&mut self, at: usize, name: &[u8; 11], attributes: u8, cluster: u32, size: u32) {
        self.put(at, name);
        self.put(at + 11, &[attributes]);
        self.put(at + 20, &((cluster >> 16) as u16).to_le_bytes());
        self.put(at + 26, &(cluster as u16).to_le_bytes());
        self.put(at + 28, &size.to_le_bytes());
    }

    /// Writes a file: its entry first in the root folder, its bytes along the clusters.
    pub fn file(&mut self, name: &[u8; 11], clusters: &[u32], bytes: &[u8]) {
        self.entry(self.root(), name, FILE, clusters[0], bytes.len() as u32);
        self.chain(clusters);
        for (&cluster, part) in clusters.iter().zip(bytes.chunks(BLOCK)) {
            self.put(self.cluster(cluster), part);
        }
    }
}

/// A partition table (MBR) of up to four entries: type, first block, blocks.
pub fn partition_table(entries: &[(u8, u32, u32)]) -> [u8; BLOCK] {
    let mut block = [0; BLOCK];
    for (&(kind, start, blocks), entry) in entries.iter().zip(block[446..510].chunks_exact_mut(16))
    {
        entry[4] = kind;
        entry[8..12].copy_from_slice(&start.to_le_bytes());
        entry[12..].copy_from_slice(&blocks.to_le_bytes());
    }
    block[510..].copy_from_slice(&[0x55, 0xAA]);
    block
}
