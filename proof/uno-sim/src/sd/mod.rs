//! A virtual SD card in SPI mode.
//!
//! [`SdCard`] is a state machine that swaps one byte with its host at a time, as the card does on the bus; it knows
//! nothing of simavr. It follows the SD Physical Layer Simplified Specification, chapter 7 (SPI mode):
//!
//! - Power-up: no answer before at least 74 clocks with CS high and MOSI high (section 6.4.1), then CMD0 with CS low
//!   and a right CRC7 enters SPI mode. Anything else meets silence.
//! - CRC: CMD0 and CMD8 are always checked; every command and every written block once CMD59 has turned CRC on. What
//!   the card sends always carries a right CRC.
//! - In the idle state only CMD0, CMD1, CMD8, CMD55 with ACMD41, CMD58 and CMD59 are legal. Initialising takes some
//!   rounds of ACMD41 ([`Timing::init_polls`]). High capacity leaves idle only for a host that sent CMD8 and sets HCS.
//! - Then CMD9, CMD10, CMD12, CMD13, CMD16, CMD17, CMD18 and CMD24 work too. The rest, erasing and CMD25 among it, is
//!   answered as illegal.
//! - Standard capacity takes byte addresses, which must not cross a block; high capacity takes block addresses.
//! - While CS is high the card leaves MISO alone (0xFF) and ignores the bus. Raising CS drops a command frame that is
//!   not complete; everything else pauses and goes on when CS falls, except that writing goes on meanwhile. So a host
//!   may hold CS low for a whole session, or lower it for each transfer.
//! - A written block is stored once all of it and its CRC have come. Then the card is busy for so many bytes on the bus
//!   ([`Timing::write_busy`]), and besides for a time ([`SdCard::with_write_time`]).

mod command;
pub mod crc;
mod exchange;
mod fault;
mod log;
mod registers;

pub use fault::{At, Fault, What};
pub use log::{CardLog, Command, Write};

use crate::Error;
use exchange::Phase;
use registers::Geometry;
use std::collections::VecDeque;

/// What kind of card it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Standard capacity, version 1: does not know CMD8. Byte addresses.
    SdV1,
    /// Standard capacity, version 2. Byte addresses.
    SdscV2,
    /// High or extended capacity (SDHC, SDXC). Block addresses. The model allows it to be smaller than 2 GB.
    Sdhc,
}

/// How long the card takes, counted in bytes on the bus. For the time of a write, see [`SdCard::with_write_time`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Timing {
    /// Bytes of 0xFF before a response (N<sub>CR</sub>); the specification allows 1 to 8.
    pub response_delay: u32,
    /// How many ACMD41 are answered "still idle" before the first "ready".
    pub init_polls: u32,
    /// Bytes of 0xFF before the token of a data packet (N<sub>AC</sub>).
    pub data_delay: u32,
    /// Busy bytes after a written block.
    pub write_busy: u32,
    /// Busy bytes after CMD12.
    pub stop_busy: u32,
}

impl Default for Timing {
    fn default() -> Timing {
        Timing {
            response_delay: 1,
            init_polls: 3,
            data_delay: 8,
            write_busy: 16,
            stop_busy: 4,
        }
    }
}

/// A virtual SD card: its memory, and the state of its SPI interface. See the [module](self).
#[derive(Clone, Debug)]
pub struct SdCard {
    kind: Kind,
    geometry: Geometry,
    timing: Timing,
    /// Cycles of [`SdCard::with_write_time`].
    write_time: u64,
    faults: Vec<Fault>,
    image: Vec<u8>,
    log: CardLog,

    mode: Mode,
    phase: Phase,
    selected: bool,
    crc_on: bool,
    /// CMD8 has come since the last CMD0: the host knows cards of version 2.
    host_is_v2: bool,
    /// The last command was CMD55.
    app: bool,
    /// Length set with CMD16, bytes.
    block_len: u32,
    /// ACMD41 answered "still idle" since the last CMD0.
    polls: u32,
    /// The command frame so far.
    frame: Vec<u8>,
    /// What goes to the host next.
    out: VecDeque<u8>,
    /// Bytes for which the line is held low once `out` is empty.
    busy: u32,
    /// The time, cycles.
    now: u64,
    /// The time until which the line is held low, too.
    busy_until: u64,
    /// Blocks moved so far, for [`At::Block`].
    blocks: usize,
    presence: Presence,
    never_ready: bool,
}

/// What the card takes itself for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Mode {
    /// Just powered: not in SPI mode yet. Clocks seen with CS and MOSI high.
    Native { clocks: u32 },
    /// In SPI mode, not initialised.
    Idle,
    /// Initialised.
    Ready,
}

/// Whether the card is there at all.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Presence {
    Present,
    /// Gone as soon as `out` is empty.
    Leaving,
    Removed,
    /// There, but dead: line low forever.
    Stuck,
}

impl SdCard {
    /// A card that has just been powered, with `image` as its memory, filled up with zeros to a size that its CSD can
    /// say (a multiple of 4 blocks or more for standard capacity, of 512 KiB for high capacity).
    ///
    /// # Errors
    /// [`Error::ImageTooLarge`] where no card of this kind could be so large.
    pub fn new(kind: Kind, mut image: Vec<u8>) -> Result<SdCard, Error> {
        let geometry = Geometry::holding(kind, image.len())?;
        image.resize(geometry.bytes(), 0);
        Ok(SdCard {
            kind,
            geometry,
            timing: Timing::default(),
            write_time: 0,
            faults: Vec::new(),
            image,
            log: CardLog::default(),
            mode: Mode::Native { clocks: 0 },
            phase: Phase::Waiting,
            selected: false,
            crc_on: false,
            host_is_v2: false,
            app: false,
            block_len: registers::BLOCK as u32,
            polls: 0,
            frame: Vec::new(),
            out: VecDeque::new(),
            busy: 0,
            now: 0,
            busy_until: 0,
            blocks: 0,
            presence: Presence::Present,
            never_ready: false,
        })
    }

    /// The same card with other timing.
    pub fn with_timing(mut self, timing: Timing) -> SdCard {
        self.timing = timing;
        self
    }

    /// The same card, busy for so many cycles after each block written, whatever the host clocks meanwhile. The
    /// specification allows 250 ms (section 4.6.2.2).
    pub fn with_write_time(mut self, cycles: u64) -> SdCard {
        self.set_write_time(cycles);
        self
    }

    /// Changes the time that a block written takes, from the next block on: see [`SdCard::with_write_time`].
    pub fn set_write_time(&mut self, cycles: u64) {
        self.write_time = cycles;
    }

    /// Tells the card the time, in cycles of any clock that only goes forward. The board does so before each byte; for
    /// a host that never does, time stands still.
    pub fn set_time(&mut self, cycles: u64) {
        self.now = cycles;
    }

    /// The same card with one more fault.
    pub fn with_fault(mut self, at: At, what: What) -> SdCard {
        self.add_fault(Fault { at, what });
        self
    }

    /// Gives the card one more fault, at a place that is still to come.
    pub fn add_fault(&mut self, fault: Fault) {
        self.faults.push(fault);
    }

    /// Takes the power away and gives it back: the memory, the faults and the log stay, all other state is lost.
    pub fn power_cycle(&mut self) {
        self.mode = Mode::Native { clocks: 0 };
        self.crc_on = false;
        self.never_ready = false;
        self.presence = Presence::Present;
        self.go_idle();
    }

    /// The kind of card.
    pub fn kind(&self) -> Kind {
        self.kind
    }

    /// What the card has seen so far.
    pub fn log(&self) -> &CardLog {
        &self.log
    }

    /// The memory of the card, with its padding.
    pub fn image(&self) -> &[u8] {
        &self.image
    }

    /// The memory of the card, with its padding, when the card is no longer needed.
    pub fn into_image(self) -> Vec<u8> {
        self.image
    }

    /// True once [`What::Removed`] has struck; [`SdCard::power_cycle`] puts the card back.
    pub fn is_removed(&self) -> bool {
        matches!(self.presence, Presence::Removed | Presence::Leaving)
    }

    /// True while the card holds the line low.
    fn is_busy(&self) -> bool {
        self.busy > 0 || self.now < self.busy_until
    }

    /// True once a host has initialised the card (it answers without the idle bit).
    pub fn is_ready(&self) -> bool {
        self.mode == Mode::Ready
    }

    fn fault_at(&self, at: At) -> Option<What> {
        self.faults
            .iter()
            .find(|fault| fault.at == at)
            .map(|fault| fault.what)
    }

    /// The state after CMD0: nothing pending, nothing initialised. CRC and presence are not touched.
    fn go_idle(&mut self) {
        self.phase = Phase::Waiting;
        self.host_is_v2 = false;
        self.app = false;
        self.block_len = registers::BLOCK as u32;
        self.polls = 0;
        self.frame.clear();
        self.out.clear();
        self.busy = 0;
        self.busy_until = 0;
    }
}
