//! Charts as diagrams.

mod drawn;
