//! What may have been meant by a name that nothing declares.

use crate::ast::{Instr, Param};
use crate::operators::Op;
use std::collections::HashSet;
use unoclp_text::diagnostics::Word;
use unoclp_text::near::nearest;

/// For more names than this, no near one is looked for: the board has not so many markers.
const MOST: u32 = 64;

/// The names of a text.
#[derive(Debug, Default)]
pub(super) struct Near {
    /// As they are written where they are declared.
    declared: Vec<String>,
    /// What the text stores to, in upper case.
    stored: HashSet<String>,
    asked: u32,
}

impl Near {
    pub(super) fn declare(&mut self, name: String) {
        self.declared.push(name);
    }

    /// Whether the text stores to a name in upper case, with or without `%`.
    pub(super) fn is_stored(&self, name: &str) -> bool {
        self.stored.contains(name) || self.stored.contains(&format!("%{name}"))
    }

    pub(super) fn note_stores(&mut self, instr: &Instr) {
        let stores = matches!(instr.op, Op::Store | Op::Set | Op::Reset);
        let operands = instr.operands.iter().filter(|_| stores);
        let outputs = instr.params.iter().filter(|param| param.out);
        let stored = operands.chain(outputs.map(|Param { value, .. }| value));
        let names = stored.filter_map(|operand| operand.name());
        self.stored.extend(names.map(str::to_owned));
        // A preset that one call gives is there for the others.
        let block = instr.operands.first().and_then(|block| block.name());
        let named = instr.params.iter().filter_map(|param| param.name.as_ref());
        for preset in named.filter(|name| matches!(name.text.as_str(), "PT" | "PV")) {
            self.stored
                .extend(block.map(|block| format!("{block}.{}", preset.text)));
        }
    }

    /// How a name may be declared, or which declared one was meant.
    pub(super) fn declaration(&mut self, written: &str) -> Word {
        let point = match self.stored.contains(&written.to_uppercase()) {
            true => "%QX1",
            false => "%IX1",
        };
        let declare = format!("VAR {written} AT {point} : BOOL; END_VAR");
        match self.nearest(written) {
            Some(near) => Word::Both(
                format!("did you mean `{near}`? if not, declare it: {declare}"),
                format!("você quis dizer `{near}`? se não, declare-o: {declare}"),
            ),
            None => Word::Both(
                format!("declare it: {declare}"),
                format!("declare-o: {declare}"),
            ),
        }
    }

    /// What can be called, or which declared name was meant.
    pub(super) fn callable(&mut self, written: &str) -> Word {
        match self.nearest(written) {
            Some(near) => Word::Near(near.to_string()),
            None => (
                "CAL takes a timer, a counter, or a FUNCTION or FUNCTION_BLOCK of this file",
                "CAL aceita um temporizador, um contador, ou uma FUNCTION ou FUNCTION_BLOCK deste arquivo",
            )
                .into(),
        }
    }

    fn nearest(&mut self, written: &str) -> Option<&str> {
        self.asked += 1;
        let names = self.declared.iter().map(String::as_str);
        nearest(written, names.filter(|_| self.asked <= MOST))
    }
}
