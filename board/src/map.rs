//! What the addresses stand for: the tables of `docs/modbus.md`.

/// Coils.
pub mod coil {
    /// Output 01.
    pub const OUTPUTS: u16 = 0;
    /// Marker M 01.
    pub const MARKERS: u16 = 16;
}

/// Discrete inputs.
pub mod discrete {
    /// Input 01.
    pub const INPUTS: u16 = 0;
}

/// Input registers.
pub mod input {
    /// Analogue input A 00.
    pub const ANALOGUE: u16 = 0;
    /// The first register of the diagnostics: those that follow here are read together.
    pub const STATE: u16 = 16;
    /// See [`flag`](super::flag).
    pub const FLAGS: u16 = 17;
    /// The number of the fault.
    pub const FAULT: u16 = 18;
    /// The cause of the start.
    pub const CAUSE: u16 = 19;
    /// The line of the fault, 32 bits.
    pub const LINE: u16 = 20;
    /// ms since the start, 32 bits.
    pub const UPTIME: u16 = 22;
    /// The last scan time, µs; the least and the most follow.
    pub const SCAN_TIME: u16 = 24;
    /// Bytes that the stack has never used.
    pub const FREE_STACK: u16 = 27;
    /// Bytes of the stored form of the program.
    pub const PROGRAM_BYTES: u16 = 28;
    /// The check sum of the program.
    pub const PROGRAM_CRC: u16 = 29;
    /// The reading of the 1.1 V reference.
    pub const SUPPLY: u16 = 30;
    /// Restarts since power-up.
    pub const RESTARTS: u16 = 31;
    /// Faults since power-up; the last register of the diagnostics.
    pub const FAULTS: u16 = 32;
    /// Elapsed time of timer T 01, 32 bits.
    pub const TIMERS: u16 = 128;
    /// Value of counter C 01, 32 bits.
    pub const COUNTERS: u16 = 320;
}

/// Holding registers.
pub mod holding {
    /// Register D 01, 32 bits.
    pub const REGISTERS: u16 = 0;
    /// Preset of timer T 01, 32 bits.
    pub const TIMERS: u16 = 128;
    /// Preset of counter C 01, 32 bits.
    pub const COUNTERS: u16 = 320;
    /// Takes a [`Command`](super::Command).
    pub const COMMAND: u16 = 400;
    /// The inputs that are forced, and behind it to what.
    pub const FORCED_INPUTS: u16 = 402;
    /// The outputs that are forced, and behind it to what.
    pub const FORCED_OUTPUTS: u16 = 404;
    /// The address; rate, parity and direction pin follow.
    pub const SETTINGS: u16 = 410;
    /// The window for blocks of an upload.
    pub const UPLOAD: u16 = 1000;
}

/// Bits of [`input::FLAGS`].
pub mod flag {
    /// A5 is closed.
    pub const STOP_SWITCH: u16 = 1 << 0;
    /// STOP by command.
    pub const STOPPED: u16 = 1 << 1;
    /// Something is forced.
    pub const FORCED: u16 = 1 << 2;
    /// An upload is under way.
    pub const UPLOAD: u16 = 1 << 3;
    /// The card failed.
    pub const CARD_FAILED: u16 = 1 << 4;
}

/// What may be written to [`holding::COMMAND`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u16)]
pub enum Command {
    /// RUN, from the beginning.
    Run = 1,
    /// STOP; ends an upload.
    Stop = 2,
    /// One single scan, in STOP.
    Scan = 3,
    /// The whole start-up anew.
    Restart = 4,
    /// Begin an upload.
    Upload = 5,
}

/// What a board does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum State {
    /// It scans.
    Run,
    /// It does not; all outputs are off.
    Stop,
    /// It shows a fault; all outputs are off.
    Fault,
}

impl State {
    /// The state of a value of [`input::STATE`]. A later firmware's would be none of these.
    pub const fn of(word: u16) -> Option<State> {
        match word {
            1 => Some(State::Run),
            2 => Some(State::Stop),
            3 => Some(State::Fault),
            _ => None,
        }
    }

    /// The state's name.
    pub const fn name(self) -> &'static str {
        match self {
            State::Run => "RUN",
            State::Stop => "STOP",
            State::Fault => "FAULT",
        }
    }
}

/// The cause of a start ([`input::CAUSE`]) in words.
pub const fn cause(word: u16) -> &'static str {
    match word {
        1 => "power",
        2 => "reset",
        3 => "watchdog",
        4 => "no reset",
        5 => "command",
        _ => "unknown",
    }
}

/// The number that two words hold, the high one first.
pub const fn number(high: u16, low: u16) -> u32 {
    (high as u32) << 16 | low as u32
}

/// The most text that a block of an upload holds, bytes.
pub const BLOCK_BYTES: usize = 244;
