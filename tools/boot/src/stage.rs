//! How far the writing of a firmware is.

/// How far the writing of an image is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Stage {
    /// The boot loader is called, and asked which chip it is on.
    Meeting,
    /// Pages are written.
    Writing,
    /// They are read back.
    Comparing,
    /// The first page makes a firmware of them, and it is started.
    Finishing,
}
