//! Why Structured Text cannot say a step.
//!
//! Owns the reasons. Must not know what is done about them.

/// Why Structured Text cannot say a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Why {
    /// No words for it.
    NoWords,
    /// A jump into a part of an IF.
    IntoPart,
    /// A timer in a loop: in a text it has one call, and not in a loop.
    TimerInLoop,
    /// An elapsed time that is read where its timer has not been called in this scan.
    EarlyTime,
    /// No register is left for it.
    NoRegister,
    /// A part of an array is kept.
    PartOfArray,
}
