//! Why a run of the program ended without getting where it should.

/// The program went no further. Every place is an address in flash with the symbol it belongs to.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Halt {
    /// It did not get to the awaited place in time.
    #[error("the program was not there after {cycles} cycles; it is at {place}")]
    Timeout {
        /// The cycles it was given.
        cycles: u64,
        /// Where it is now.
        place: String,
    },
    /// It sleeps with interrupts off: only a reset can wake it.
    #[error("the program sleeps with interrupts off at {place}")]
    AsleepForEver {
        /// Where.
        place: String,
    },
    /// It jumps to itself with interrupts and watchdog off, as a panic or abort does.
    #[error("the program has stopped for good at {place}, as it does on a panic")]
    Hung {
        /// Where.
        place: String,
    },
    /// It left the code that was loaded.
    #[error("the program left its code after {place}")]
    LeftCode {
        /// The last instruction inside.
        place: String,
    },
    /// It came to an opcode that the chip does not have.
    #[error("the program met the invalid opcode {opcode:#06x} at {place}")]
    InvalidOpcode {
        /// The opcode.
        opcode: u16,
        /// Where.
        place: String,
    },
    /// The power went at a write to the EEPROM, as a test had asked for.
    #[error("the power was cut at a write to the EEPROM; Uno::power_up turns it on again")]
    PowerCut,
    /// The simulator itself went no further, or has ended.
    #[error("the simulator went no further: {reason}")]
    Simulator {
        /// What it said, or what its process ended with.
        reason: String,
    },
}
