//! The typed languages: which there are, and the way of a text in one of them to its typed tree.

use crate::diagnostics::{Found, Told};
use crate::typed::Tree;
use unoclp_core::Board;

/// A typed language.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TextLanguage {
    /// Structured Text of IEC 61131-3.
    St,
    /// Structured Text as Siemens writes it: `#name`, `"name"`.
    Scl,
    /// InterSCL, a small SCL for teaching.
    Iscl,
    /// LCE, the language of SimuPLC.
    Lce,
    /// Instruction List, where it has types and functions of the norm.
    Il,
}

impl TextLanguage {
    /// Every typed language.
    pub const ALL: [TextLanguage; 5] = [
        TextLanguage::St,
        TextLanguage::Scl,
        TextLanguage::Iscl,
        TextLanguage::Lce,
        TextLanguage::Il,
    ];

    /// Its name on a command line: `st`, `scl`, `iscl`, `lce`, `il`.
    pub const fn name(self) -> &'static str {
        match self {
            TextLanguage::St => "st",
            TextLanguage::Scl => "scl",
            TextLanguage::Iscl => "iscl",
            TextLanguage::Lce => "lce",
            TextLanguage::Il => "il",
        }
    }

    /// The language with this name.
    pub fn named(name: &str) -> Option<TextLanguage> {
        TextLanguage::ALL
            .into_iter()
            .find(|language| language.name() == name)
    }
}

/// What has come of a text.
#[derive(Debug)]
pub struct CheckedText {
    /// What it means; none where there are errors.
    pub tree: Option<Tree>,
    /// What was found in it.
    pub diagnostics: Told,
}

/// Reads a text and checks its names and types. It takes a time in proportion to the text's size.
pub fn check(text: &str, language: TextLanguage, board: Board) -> CheckedText {
    let mut found = Found::default();
    let tree = read(text, language, board, &mut found);
    CheckedText {
        tree,
        diagnostics: found.finish(),
    }
}

/// The tree of a text; none where something is wrong, which is told.
pub(crate) fn read(
    text: &str,
    language: TextLanguage,
    board: Board,
    found: &mut Found,
) -> Option<Tree> {
    let tree = match language {
        TextLanguage::St => crate::st::check(text, crate::st::Dialect::Iec, board, found),
        TextLanguage::Scl => crate::st::check(text, crate::st::Dialect::Scl, board, found),
        TextLanguage::Iscl => crate::iscl::check(text, board, found),
        TextLanguage::Lce => crate::lce::check(text, board, found),
        TextLanguage::Il => crate::il::read(text, None, board, found).tree,
    };
    tree.filter(|_| !found.has_errors())
}
