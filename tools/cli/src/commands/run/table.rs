//! The result of a run, for a person: what was printed, and the symbols in columns.

use super::ran::Ran;
use crate::messages;
use unoclp_lang::typed::{Base, Value};

/// What was printed, a line for each.
pub(super) fn lines(all: &[(Value, Base)]) -> String {
    let mut text = String::new();
    for (value, base) in all {
        let shown = match value {
            Value::Text(text) => text.clone(),
            value => value.shown(*base),
        };
        text += &format!("{shown}\n");
    }
    text
}

/// The symbols in columns.
pub(super) fn table(ran: &Ran) -> String {
    let mut text = String::new();
    if ran.symbols.is_empty() {
        return text;
    }
    let heads = [
        messages::symbol_name(),
        messages::symbol_type(),
        messages::symbol_value(),
        messages::symbol_place(),
    ];
    let mut rows = vec![heads];
    for row in &ran.symbols {
        rows.push([
            row.name.clone(),
            row.type_name.clone(),
            row.shown(),
            row.place.clone().unwrap_or_else(|| "-".to_owned()),
        ]);
    }
    let mut widths = [0; 4];
    for row in &rows {
        for (width, cell) in widths.iter_mut().zip(row) {
            *width = (*width).max(cell.chars().count());
        }
    }
    for row in &rows {
        let cells = row.iter().zip(widths);
        let line: String = cells
            .map(|(cell, width)| format!("{cell:width$}  "))
            .collect();
        text += line.trim_end();
        text.push('\n');
    }
    text
}
