//! What a card has seen: kept by the model, for tests to look at.

/// One command frame that reached the card.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Command {
    /// Command index, 0 to 63.
    pub index: u8,
    /// True where a CMD55 came before, so that `index` names an application command (ACMD).
    pub app: bool,
    /// The 32-bit argument.
    pub argument: u32,
    /// The first byte of the response (R1), or `None` where the card kept silent.
    pub answer: Option<u8>,
    /// When the frame was complete, on the clock of [`SdCard::set_time`](super::SdCard::set_time), cycles.
    pub time: u64,
}

/// One block of the memory that the host has written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Write {
    /// Which block, counted in 512 bytes from the start of the memory.
    pub block: usize,
    /// When its packet was complete, on the clock of [`SdCard::set_time`](super::SdCard::set_time), cycles.
    pub time: u64,
}

/// Everything that reached a card since it was powered, in order.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct CardLog {
    /// Every complete command frame of 6 bytes, answered or not.
    pub commands: Vec<Command>,
    /// Blocks of the memory sent to the host (registers do not count).
    pub blocks_read: u64,
    /// Blocks of the memory changed by the host.
    pub blocks_written: u64,
    /// Each of them.
    pub writes: Vec<Write>,
    /// How often the host has selected the card: CS fell.
    pub selections: u64,
}

impl CardLog {
    /// How often the plain command `index` came (CMD, not ACMD).
    pub fn count(&self, index: u8) -> usize {
        self.commands
            .iter()
            .filter(|command| !command.app && command.index == index)
            .count()
    }
}
