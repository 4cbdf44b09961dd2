//! The volume, and the row of its blocks that is being read.

use crate::{Block, Device, Error, read};

/// A volume's layout, and how far a row of its blocks has been read: a chain of clusters, or the
/// root folder of FAT16, which lies in a region of its own.
///
/// Layout and position are one value, filled in place: on AVR, two that are handed from function
/// to function take half as much code again.
///
/// Block numbers count from the start of the card and wrap: one that needs more than 32 bits
/// comes from a boot sector that lies, and leads to a wrong block instead of a panic.
///
/// A chain that runs in a circle is found by Brent's method: one of its clusters is kept and
/// compared with those that follow, and is replaced after 1, 2, 4, 8 … of them. That takes no
/// memory, and no circle is followed more than three times.
#[derive(Debug, Default)]
pub(crate) struct Walk {
    fat32: bool,
    /// Blocks of a cluster: a power of two once a volume has been found.
    cluster_blocks: u8,
    /// The first block of the first FAT.
    fat: u32,
    /// The first block of cluster 2, the first cluster.
    data: u32,
    /// How many clusters there are.
    clusters: u32,

    /// The next block, where one is left.
    block: u32,
    /// Blocks left in this cluster or region.
    left: u16,
    /// What the FAT says to follow this cluster or region: a claim until it is entered.
    next: u32,
    /// The cluster kept.
    kept: u32,
    /// Clusters entered so far.
    entered: u16,
}

/// What the FAT says of the last cluster of a chain: this or more, on FAT16 0xFFF8 or more (FAT,
/// "FAT Data Structure").
const END: u32 = 0x0FFF_FFF8;

impl Walk {
    /// Finds the first volume and stands before its root folder: the one that starts at block 0,
    /// or else the first that a primary partition holds.
    ///
    /// Block 0 is taken for a boot sector first, since tools (mtools) write partition entries
    /// also into the boot sector of a volume without a partition table.
    pub fn find<D: Device>(&mut self, device: &mut D) -> Result<(), Error<D::Error>> {
        for place in 0..5 {
            let mut start = 0;
            if place > 0 {
                read(device, 0)?;
                match fat_partition(device.block(), place - 1) {
                    Some(first) => start = first,
                    None => continue,
                }
            }
            read(device, start)?;
            if self.parse(device.block(), start).is_some() {
                return Ok(());
            }
        }
        Err(Error::NoVolume)
    }

    /// Takes a block for the boot sector of a volume that starts there, and stands before its
    /// root folder; `None` where it makes no sense as one (FAT, "Boot Sector and BPB Structure").
    // Inlined on AVR, it runs out of registers and takes 600 bytes more.
    #[inline(never)]
    fn parse(&mut self, block: &Block, start: u32) -> Option<()> {
        let reserved = u16_at::<14>(block);
        let fats = block[16];
        self.cluster_blocks = block[13];
        if !signed(block)
            || u16_at::<11>(block) != 512
            || !self.cluster_blocks.is_power_of_two()
            || reserved == 0
            || !(fats == 1 || fats == 2)
        {
            return None;
        }

        // Windows and Linux tell FAT32 by this 0, the specification by the number of clusters. They
        // differ for a small volume that was formatted as FAT32 all the same: a PC reads it.
        let mut fat_blocks = u32::from(u16_at::<22>(block));
        self.fat32 = fat_blocks == 0;
        if self.fat32 {
            // A FAT of 2^24 blocks or more is longer than 28-bit cluster numbers allow.
            fat_blocks = u32_at::<36>(block) & 0x00FF_FFFF;
        }
        let root_blocks = u16_at::<17>(block) / 16;

        self.fat = start.wrapping_add(reserved.into());
        let mut before = u32::from(reserved) + fat_blocks;
        if fats == 2 {
            before += fat_blocks;
        }
        self.block = start.wrapping_add(before);
        before += u32::from(root_blocks);
        self.data = start.wrapping_add(before);

        let mut total = u32::from(u16_at::<19>(block));
        if total == 0 {
            total = u32_at::<32>(block);
        }
        let mut clusters = total.checked_sub(before)?;
        let mut factor = self.cluster_blocks;
        while factor > 1 {
            clusters >>= 1;
            factor >>= 1;
        }
        self.clusters = clusters;

        if self.fat32 {
            self.enter_later(u32_at::<44>(block));
        } else {
            self.left = root_blocks;
            self.next = END;
            // Fewer are FAT12, more are no FAT16 (FAT, "FAT Type Determination").
            if !(4085..65525).contains(&clusters) {
                return None;
            }
        }
        Some(())
    }

    /// Stands before a chain, given by its first cluster as an entry of a folder has it: FAT16
    /// knows no upper half.
    pub fn start(&mut self, high: u16, low: u16) {
        let high = if self.fat32 { high } else { 0 };
        self.enter_later(u32::from(high) << 16 | u32::from(low));
    }

    fn enter_later(&mut self, cluster: u32) {
        self.left = 0;
        self.next = cluster;
    }

    /// Reads the next block.
    ///
    /// # Errors
    /// [`Error::Device`]; [`Error::NotFound`] where the row has ended; [`Error::Damaged`] where
    /// its chain leads to a cluster that is free, bad or outside the volume, runs in a circle, or
    /// is longer than 65,535 clusters.
    pub fn read_next<D: Device>(&mut self, device: &mut D) -> Result<(), Error<D::Error>> {
        if self.left == 0 {
            if self.next >= END {
                return Err(Error::NotFound);
            }
            self.enter(device)?;
        }
        let block = self.block;
        self.block = block.wrapping_add(1);
        self.left -= 1;
        read(device, block)
    }

    /// Enters the chain that this stands before, and gives the place of its first block.
    ///
    /// # Errors
    /// [`Error::Device`]; [`Error::Damaged`] where the chain's first cluster is outside the volume,
    /// or the FAT does not hold it for taken: by the end of the chain, or another cluster.
    pub fn first_place<D: Device>(&mut self, device: &mut D) -> Result<u32, Error<D::Error>> {
        self.enter(device)?;
        let taken = self.next >= END || self.next.wrapping_sub(2) < self.clusters;
        if taken {
            Ok(self.block)
        } else {
            Err(Error::Damaged)
        }
    }

    /// Enters the cluster that follows: where its blocks are, and what comes after it. The FAT is
    /// asked that now and not on leaving, so that a chain starts as it goes on.
    ///
    /// # Errors
    /// [`Error::Device`]; [`Error::Damaged`] where the cluster is none, or ends Brent's search.
    #[inline(never)]
    fn enter<D: Device>(&mut self, device: &mut D) -> Result<(), Error<D::Error>> {
        let cluster = self.next;
        let mut index = cluster.wrapping_sub(2);
        if index >= self.clusters || cluster == self.kept || self.entered == u16::MAX {
            return Err(Error::Damaged);
        }
        self.entered += 1;
        if self.entered.is_power_of_two() {
            self.kept = cluster;
        }
        self.left = self.cluster_blocks.into();
        let mut factor = self.cluster_blocks;
        while factor > 1 {
            index <<= 1;
            factor >>= 1;
        }
        self.block = self.data.wrapping_add(index);

        // The FAT in words: on FAT32 two for a cluster, the lower one first.
        let word = if self.fat32 { cluster << 1 } else { cluster };
        read(device, self.fat.wrapping_add(word >> 8))?;
        let words = device.block().as_chunks().0;
        let word = word as u8;
        let low = u16::from_le_bytes(words[usize::from(word)]);
        let high = match low {
            _ if self.fat32 => u16::from_le_bytes(words[usize::from(word | 1)]) & 0x0FFF,
            0xFFF8.. => (END >> 16) as u16,
            _ => 0,
        };
        self.next = u32::from(high) << 16 | u32::from(low);
        Ok(())
    }
}

/// The first block of one of an MBR's four partitions, where it is of a FAT type.
fn fat_partition(block: &Block, entry: usize) -> Option<u32> {
    let entry = &block[446..510].as_chunks::<16>().0[entry];
    // FAT16 under 32 MB, FAT16, FAT16 by block numbers; FAT32, FAT32 by block numbers.
    let fat = matches!(entry[4], 0x04 | 0x06 | 0x0E | 0x0B | 0x0C);
    (fat && signed(block)).then(|| u32::from_le_bytes([entry[8], entry[9], entry[10], entry[11]]))
}

/// The mark that ends a boot sector and an MBR.
fn signed(block: &Block) -> bool {
    u16_at::<510>(block) == 0xAA55
}

fn u16_at<const AT: usize>(block: &Block) -> u16 {
    u16::from_le_bytes([block[AT], block[AT + 1]])
}

fn u32_at<const AT: usize>(block: &Block) -> u32 {
    u32::from_le_bytes([block[AT], block[AT + 1], block[AT + 2], block[AT + 3]])
}
