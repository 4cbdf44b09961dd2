//! A card in memory that counts what is done to it, the walk over it, and the reference.

pub mod raw;
pub mod small;

use std::cell::Cell;
use std::fmt;

use embedded_sdmmc::{
    Block, BlockCount, BlockDevice, BlockIdx, Mode, TimeSource, Timestamp, VolumeIdx, VolumeManager,
};
use unoclp_card::{Device, Error, File};

pub const PROGRAM: &[u8; 11] = b"PROGRAM TXT";

/// Why [`Card`] gives no block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoBlock {
    /// The card ends before it.
    Beyond,
    /// The test asked for this read to fail.
    Asked,
}

impl fmt::Display for NoBlock {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{self:?}")
    }
}

impl std::error::Error for NoBlock {}

/// A card. Writing to it is counted, and changes nothing.
pub struct Card<'a> {
    image: &'a [u8],
    /// Blocks read so far.
    pub reads: Cell<usize>,
    /// Calls of `write` so far.
    pub writes: Cell<usize>,
    /// The read that fails, counted from 0.
    pub fails_at: Option<usize>,
}

impl<'a> Card<'a> {
    pub fn new(image: &'a [u8]) -> Card<'a> {
        Card {
            image,
            reads: Cell::new(0),
            writes: Cell::new(0),
            fails_at: None,
        }
    }
}

impl BlockDevice for Card<'_> {
    type Error = NoBlock;

    fn read(&self, blocks: &mut [Block], start: BlockIdx) -> Result<(), NoBlock> {
        for (index, block) in (start.0 as usize..).zip(blocks) {
            if self.fails_at == Some(self.reads.get()) {
                return Err(NoBlock::Asked);
            }
            self.reads.set(self.reads.get() + 1);
            let bytes = self.image.chunks_exact(Block::LEN).nth(index);
            block
                .contents
                .copy_from_slice(bytes.ok_or(NoBlock::Beyond)?);
        }
        Ok(())
    }

    fn write(&self, _: &[Block], _: BlockIdx) -> Result<(), NoBlock> {
        self.writes.set(self.writes.get() + 1);
        Ok(())
    }

    fn num_blocks(&self) -> Result<BlockCount, NoBlock> {
        Ok(BlockCount((self.image.len() / Block::LEN) as u32))
    }
}

/// A card, and room for a block of it.
pub struct Reader<'a> {
    card: &'a Card<'a>,
    block: Block,
}

impl<'a> Reader<'a> {
    pub fn new(card: &'a Card<'a>) -> Reader<'a> {
        let block = Block::new();
        Reader { card, block }
    }
}

impl Device for Reader<'_> {
    type Error = NoBlock;

    fn read(&mut self, number: u32) -> Result<(), NoBlock> {
        let blocks = std::slice::from_mut(&mut self.block);
        self.card.read(blocks, BlockIdx(number))
    }

    fn block(&self) -> &[u8; 512] {
        &self.block
    }
}

/// What the walk reads of a file. The device holds other bytes before each call, every block
/// but the last must be full, and nothing may be written.
pub fn walk(card: &Card, name: &[u8; 11]) -> Result<Vec<u8>, Error<NoBlock>> {
    let result = walk_inner(card, name);
    assert_eq!(card.writes.get(), 0, "the walk wrote to the card");
    result
}

fn walk_inner(card: &Card, name: &[u8; 11]) -> Result<Vec<u8>, Error<NoBlock>> {
    let mut reader = Reader::new(card);
    reader.block.fill(0xA5);
    let mut file = File::default();
    file.open(&mut reader, name.iter().copied())?;
    let mut bytes = Vec::new();
    loop {
        reader.block.fill(0x5A);
        match file.next_block(&mut reader)? {
            Some(part) => {
                assert_eq!(bytes.len() % Block::LEN, 0, "a short block before the last");
                assert!(!part.is_empty());
                bytes.extend_from_slice(part);
            }
            None => return Ok(bytes),
        }
    }
}

/// The walk over a card image.
pub fn walk_image(image: &[u8]) -> Result<Vec<u8>, Error<NoBlock>> {
    walk(&Card::new(image), PROGRAM)
}

/// What embedded-sdmmc's own volume manager reads of a file. It refuses volumes without a
/// partition table, so those get one in front.
pub fn reference(image: &[u8], bare: bool, name: &str) -> Vec<u8> {
    let card = Card::new(image);
    let partitioned = InPartition { card, bare };
    let manager = VolumeManager::new(partitioned, NoTime);
    let volume = manager.open_volume(VolumeIdx(0)).unwrap();
    let root = volume.open_root_dir().unwrap();
    let file = root.open_file_in_dir(name, Mode::ReadOnly).unwrap();
    let mut bytes = vec![0; file.length() as usize];
    let mut read = 0;
    while read < bytes.len() {
        read += file.read(&mut bytes[read..]).unwrap();
    }
    bytes
}

struct InPartition<'a> {
    card: Card<'a>,
    bare: bool,
}

impl BlockDevice for InPartition<'_> {
    type Error = NoBlock;

    fn read(&self, blocks: &mut [Block], start: BlockIdx) -> Result<(), NoBlock> {
        match start {
            _ if !self.bare => self.card.read(blocks, start),
            BlockIdx(0) => {
                let blocks_of_card = self.card.num_blocks()?.0;
                blocks[0].copy_from_slice(&raw::partition_table(&[(0x0C, 1, blocks_of_card)]));
                Ok(())
            }
            BlockIdx(index) => self.card.read(blocks, BlockIdx(index - 1)),
        }
    }

    fn write(&self, blocks: &[Block], start: BlockIdx) -> Result<(), NoBlock> {
        self.card.write(blocks, start)
    }

    fn num_blocks(&self) -> Result<BlockCount, NoBlock> {
        self.card.num_blocks()
    }
}

struct NoTime;

impl TimeSource for NoTime {
    fn get_timestamp(&self) -> Timestamp {
        Timestamp::from_calendar(1980, 1, 1, 0, 0, 0).unwrap()
    }
}

/// A row of numbers that only looks random: xorshift64*, which repeats from its seed.
pub struct Random(pub u64);

impl Random {
    /// A number in `0..below`.
    pub fn below(&mut self, below: usize) -> usize {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        let number = self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 32;
        number as usize % below
    }
}

/// Bytes that differ from block to block.
pub fn bytes(length: usize) -> Vec<u8> {
    let mut random = Random(length as u64 + 1);
    (0..length).map(|_| random.below(256) as u8).collect()
}
