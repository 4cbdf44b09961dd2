//! Faults that a test can give a card: where ([`At`]) and what happens there ([`What`]).

/// One fault. A card may carry several; at one place the first that was added counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fault {
    /// Where it strikes.
    pub at: At,
    /// What happens.
    pub what: What,
}

/// The place where a fault strikes, counted from 0 since the card was made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum At {
    /// The n-th command frame, as numbered by [`CardLog::commands`](super::CardLog::commands).
    Command(usize),
    /// The n-th block of memory that is moved, read or written alike.
    Block(usize),
}

/// What goes wrong. All of them last for the one command or block, except where it says "from here on".
///
/// A fault of data at a command ([`What::WrongToken`], [`What::Garbage`]) strikes the first data
/// packet which that command causes, also the one of a register; where it causes none, nothing happens.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum What {
    /// A command: it is lost, and the line stays high. A block: the token, or the data response, never comes.
    NoAnswer,
    /// A command arrives damaged: R1 says "CRC error", and nothing is done. A block read: its CRC16 is wrong.
    /// A block written: the data response says "CRC error", and nothing is stored.
    WrongCrc,
    /// A block read: a data error token ("card ECC failed") comes instead of the data. A block written: the data
    /// response says "write error", and nothing is stored.
    WrongToken,
    /// Other bytes than the memory holds, with a right CRC16. A block written is stored as such bytes.
    Garbage,
    /// The card is pulled out, from here on. A block read breaks off in its middle; a block written is lost.
    Removed,
    /// Busy (line low) for so many more bytes after the command or the block written. Where a data packet is read, so
    /// many more bytes of 0xFF before its token instead.
    Busy(u32),
    /// Busy (line low) from here on, whatever the host does. A command is not answered; a block written still gets its
    /// data response.
    Stuck,
    /// The card never leaves its idle state, from here on.
    NeverReady,
}

/// `len` bytes that no card holds by accident, the same each time: the data of [`What::Garbage`].
pub(super) fn garbage(len: usize) -> Vec<u8> {
    let mut state = 0x2545_F491u32;
    std::iter::repeat_with(|| {
        state ^= state << 13;
        state ^= state >> 17;
        state ^= state << 5;
        state.to_be_bytes()[0]
    })
    .take(len)
    .collect()
}
