//! Card images for tools and tests: a FAT16 or FAT32 volume in memory, with or without a
//! partition table.
//!
//! ```
//! use unoclp_card::image::{Fat, Image};
//!
//! let image = Image::new(Fat::Fat16).file("PROGRAM.TXT", "0\n").build()?;
//! assert_eq!(image.len() % unoclp_card::image::UNIT, 0);
//! # Ok::<(), std::io::Error>(())
//! ```
//!
//! The crate `fatfs` lays out and fills the volume, so what the walk of this crate reads was
//! written by code it shares nothing with. The same image is built from the same calls, to the
//! byte: files carry a fixed date.

use std::format;
use std::io::{self, Cursor, Write};
use std::string::String;
use std::vec;
use std::vec::Vec;

use fatfs::{Date, DateTime, FileSystem, FormatVolumeOptions, FsOptions, Time, TimeProvider};

/// Bytes that every image is a multiple of: 512 KiB, the unit in which an SDHC card states its
/// size (SD Physical Layer Simplified Specification, 5.3.3, C_SIZE).
pub const UNIT: usize = 512 * 1024;

/// The block at which the partition starts where there is a partition table: 1 MiB into the card,
/// as partitioning tools place it.
pub const PARTITION_START: u32 = 2048;

const BLOCK: usize = 512;
/// Entries of a FAT16 root folder, the usual number. A file takes one and one more per 13
/// characters of its name.
const FAT16_ROOT_ENTRIES: u16 = 512;
/// More than fatfs reserves in front of the first FAT on either type (1 and 8 blocks).
const RESERVED: u32 = 8;

/// The kind of FAT volume.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fat {
    /// 16-bit entries: an image of 2.5 MiB or more.
    Fat16,
    /// 32-bit entries: an image of 33 MiB or more, since fewer clusters would make it FAT16.
    Fat32,
}

impl Fat {
    /// The clusters of the smallest image. The type follows from this number alone (under 4,085
    /// FAT12, under 65,525 FAT16); Microsoft's specification says to keep 16 away from either.
    const fn fewest_clusters(self) -> u32 {
        match self {
            Fat::Fat16 => 4_085 + 64,
            Fat::Fat32 => 65_525 + 64,
        }
    }

    const fn most_clusters(self) -> u32 {
        match self {
            Fat::Fat16 => 65_524 - 64,
            // Far below the type's limit: these images live in memory.
            Fat::Fat32 => 1 << 20,
        }
    }

    const fn entry_bytes(self) -> u32 {
        match self {
            Fat::Fat16 => 2,
            Fat::Fat32 => 4,
        }
    }

    const fn partition_type(self) -> u8 {
        match self {
            Fat::Fat16 => 0x0E,
            Fat::Fat32 => 0x0C,
        }
    }
}

/// An image to build. Files are written in the order they are named in.
#[derive(Clone, Debug)]
pub struct Image {
    fat: Fat,
    partitioned: bool,
    cluster_blocks: u8,
    entries: Vec<Entry>,
}

#[derive(Clone, Debug)]
struct Entry {
    name: String,
    bytes: Vec<u8>,
    kind: Kind,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Whole,
    Fragmented,
    Deleted,
}

impl Image {
    /// An empty volume in a partition, with clusters of one block (512 bytes).
    pub const fn new(fat: Fat) -> Image {
        Image {
            fat,
            partitioned: true,
            cluster_blocks: 1,
            entries: Vec::new(),
        }
    }

    /// No partition table: the volume starts at block 0.
    pub fn bare(mut self) -> Image {
        self.partitioned = false;
        self
    }

    /// Clusters of this many blocks of 512 bytes: a power of two, 1 to 64. The image grows with
    /// it, since the type sets the number of clusters.
    pub fn cluster_blocks(mut self, blocks: u8) -> Image {
        self.cluster_blocks = blocks;
        self
    }

    /// A file in the root folder. The name is any FAT name, long ones too. Its clusters lie one
    /// after the other, after those of the files before it.
    pub fn file(self, name: impl Into<String>, bytes: impl Into<Vec<u8>>) -> Image {
        self.entry(name, bytes, Kind::Whole)
    }

    /// A file of which no two clusters lie side by side: between them lie those of a file
    /// `SPACER.n`, n being the number of files named before it.
    pub fn fragmented_file(self, name: impl Into<String>, bytes: impl Into<Vec<u8>>) -> Image {
        self.entry(name, bytes, Kind::Fragmented)
    }

    /// A file that is deleted at the end: its entry stays, marked as deleted, before those of the
    /// files named after it, and its bytes stay in what is then free space.
    pub fn deleted_file(self, name: impl Into<String>, bytes: impl Into<Vec<u8>>) -> Image {
        self.entry(name, bytes, Kind::Deleted)
    }

    /// Builds it: the whole card, a multiple of [`UNIT`] bytes.
    ///
    /// # Errors
    /// Where the cluster size is none, a name is no FAT name or is used twice, or the files need
    /// more than the type can hold (65,460 clusters of FAT16, 2^20 here of FAT32, 512 entries in
    /// the root folder of FAT16). The text names the file.
    pub fn build(&self) -> io::Result<Vec<u8>> {
        if !self.cluster_blocks.is_power_of_two() || self.cluster_blocks > 64 {
            return Err(invalid(format!(
                "a cluster has 1, 2, 4, 8, 16, 32 or 64 blocks, not {}",
                self.cluster_blocks
            )));
        }
        let start = if self.partitioned { PARTITION_START } else { 0 };
        let blocks = self.volume_blocks()?;
        let volume = start as usize * BLOCK..(start + blocks) as usize * BLOCK;

        let mut card = vec![0; volume.end.next_multiple_of(UNIT)];
        self.format(&mut card[volume.clone()])?;
        self.fill(&mut card[volume.clone()])?;
        if self.partitioned {
            set_hidden_blocks(&mut card[volume], self.fat, start);
            write_partition_table(&mut card[..BLOCK], self.fat.partition_type(), start, blocks);
        }
        Ok(card)
    }

    fn entry(mut self, name: impl Into<String>, bytes: impl Into<Vec<u8>>, kind: Kind) -> Image {
        self.entries.push(Entry {
            name: name.into(),
            bytes: bytes.into(),
            kind,
        });
        self
    }

    fn cluster_bytes(&self) -> usize {
        usize::from(self.cluster_blocks) * BLOCK
    }

    /// Blocks of a volume that holds the entries and has clusters enough for its type.
    fn volume_blocks(&self) -> io::Result<u32> {
        let cluster = self.cluster_bytes();
        let mut needed = 0;
        let mut root_entries = 0;
        for entry in &self.entries {
            // A spacer takes as many clusters again, and an entry with a name of its own.
            let files = if entry.kind == Kind::Fragmented { 2 } else { 1 };
            needed += files * entry.bytes.len().div_ceil(cluster);
            root_entries += files * (1 + entry.name.len().max(13).div_ceil(13));
        }
        needed += (root_entries * 32).div_ceil(cluster);

        let needed = u32::try_from(needed + 64).unwrap_or(u32::MAX);
        let clusters = needed.max(self.fat.fewest_clusters());
        if clusters > self.fat.most_clusters() {
            return Err(invalid(format!(
                "the files need {needed} clusters of {cluster} bytes, more than {:?} has here; \
                 take larger clusters",
                self.fat
            )));
        }
        let fat_blocks = ((clusters + 2) * self.fat.entry_bytes()).div_ceil(BLOCK as u32);
        let root_blocks = u32::from(FAT16_ROOT_ENTRIES) * 32 / BLOCK as u32;
        Ok(RESERVED + 2 * fat_blocks + root_blocks + clusters * u32::from(self.cluster_blocks))
    }

    fn format(&self, volume: &mut [u8]) -> io::Result<()> {
        let options = FormatVolumeOptions::new()
            .bytes_per_cluster(self.cluster_bytes() as u32)
            .max_root_dir_entries(FAT16_ROOT_ENTRIES);
        fatfs::format_volume(Cursor::new(&mut *volume), options)?;

        let fs = mount(volume)?;
        let made = fs.fat_type();
        match (self.fat, made) {
            (Fat::Fat16, fatfs::FatType::Fat16) | (Fat::Fat32, fatfs::FatType::Fat32) => Ok(()),
            _ => Err(io::Error::other(format!(
                "the volume came out as {made:?}, not {:?}",
                self.fat
            ))),
        }
    }

    fn fill(&self, volume: &mut [u8]) -> io::Result<()> {
        let fs = mount(volume)?;
        let root = fs.root_dir();
        for (number, Entry { name, bytes, kind }) in self.entries.iter().enumerate() {
            // fatfs would open what is there already.
            if root.open_file(name).is_ok() {
                return Err(invalid(format!("{name} is twice on the card image")));
            }
            let write = || -> io::Result<()> {
                let mut file = root.create_file(name)?;
                if *kind != Kind::Fragmented {
                    return file.write_all(bytes);
                }
                let mut spacer = root.create_file(&format!("SPACER.{number}"))?;
                let gap = vec![b'/'; self.cluster_bytes()];
                bytes.chunks(gap.len()).try_for_each(|part| {
                    file.write_all(part)?;
                    spacer.write_all(&gap)
                })
            };
            write().map_err(|error| in_entry(name, &error))?;
        }
        // Only now, or the files that follow would take the entries over.
        for Entry { name, kind, .. } in &self.entries {
            if *kind == Kind::Deleted {
                root.remove(name).map_err(|error| in_entry(name, &error))?;
            }
        }
        drop(root);
        fs.unmount()
    }
}

type Volume<'a> = FileSystem<Cursor<&'a mut [u8]>>;

fn mount(volume: &mut [u8]) -> io::Result<Volume<'_>> {
    FileSystem::new(Cursor::new(volume), FsOptions::new().time_provider(&FIXED))
}

/// The date of every file: the first that FAT knows.
#[derive(Debug)]
struct FixedTime;

static FIXED: FixedTime = FixedTime;

impl TimeProvider for FixedTime {
    fn get_current_date(&self) -> Date {
        Date {
            year: 1980,
            month: 1,
            day: 1,
        }
    }

    fn get_current_date_time(&self) -> DateTime {
        DateTime {
            date: self.get_current_date(),
            time: Time {
                hour: 0,
                min: 0,
                sec: 0,
                millis: 0,
            },
        }
    }
}

fn invalid(text: String) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidInput, text)
}

fn in_entry(name: &str, error: &io::Error) -> io::Error {
    io::Error::new(error.kind(), format!("{name} on the card image: {error}"))
}

/// Writes the blocks before the volume into its boot sector (offset 28, BPB_HiddSec), and into
/// FAT32's copy of it in block 6. fatfs always writes 0.
fn set_hidden_blocks(volume: &mut [u8], fat: Fat, blocks: u32) {
    let boot_sectors: &[usize] = match fat {
        Fat::Fat16 => &[0],
        Fat::Fat32 => &[0, 6],
    };
    for sector in boot_sectors {
        let at = sector * BLOCK + 28;
        volume[at..at + 4].copy_from_slice(&blocks.to_le_bytes());
    }
}

/// Writes a partition table (MBR) of one entry into block 0. The places in cylinders, heads and
/// sectors say "beyond what they can express", as is usual where the block numbers count.
fn write_partition_table(block: &mut [u8], kind: u8, start: u32, blocks: u32) {
    let entry = &mut block[446..462];
    entry[..8].copy_from_slice(&[0, 0xFE, 0xFF, 0xFF, kind, 0xFE, 0xFF, 0xFF]);
    entry[8..12].copy_from_slice(&start.to_le_bytes());
    entry[12..].copy_from_slice(&blocks.to_le_bytes());
    block[510..].copy_from_slice(&[0x55, 0xAA]);
}
