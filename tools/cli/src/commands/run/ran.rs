//! The result of a run.

use unoclp_lang::typed::{Base, Value};

/// The result of a run.
pub struct Ran {
    pub scans: u32,
    pub printed: Vec<(Value, Base)>,
    pub symbols: Vec<Row>,
}

/// A variable at the end of a run.
pub struct Row {
    pub name: String,
    pub type_name: String,
    pub value: Value,
    pub base: Base,
    /// The name of the value of an enumeration.
    pub named: Option<String>,
    /// Where the board keeps it.
    pub place: Option<String>,
}

impl Row {
    /// The value as a person reads it.
    pub fn shown(&self) -> String {
        let shown = || self.value.shown(self.base);
        self.named.clone().unwrap_or_else(shown)
    }
}
