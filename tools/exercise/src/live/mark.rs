//! What is shown beside a line.

/// What a line has come to in the last scan; none: the scan has not come there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Mark {
    /// acc after it, what it tests, or the bit that it stores.
    Power(Option<bool>),
    /// The number that it works on, as a literal of its type.
    Value(Option<String>),
}
