//! What a point is from a moment on: a sample of the journal, by the name that it has here.

pub(crate) use unoclp_journal::Sample as Change;
