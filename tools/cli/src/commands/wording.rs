//! The options that say in what a program is written.

use crate::messages;
use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use std::rc::Rc;
use unoclp_core::Board;
use unoclp_lang::{Dialect, Lang};
use unoclp_program::{Language, Written, WrittenIn};
use unoclp_workspace::{All, Workspace};

/// How to read a program.
#[derive(Args, Clone)]
pub struct Wording {
    /// The manufacturer of the Instruction List dialect; by default, detected from the keywords
    #[arg(long, value_parser = dialects())]
    pub(super) dialect: Option<Dialect>,
    /// The language of the program; by default, detected from the file name and the text
    #[arg(long, value_parser = languages())]
    pub(super) language: Option<WrittenIn>,
    /// The target board; by default, the board at the port, or a UNO. A Nano has no REAL numbers, a Mega has more inputs,
    /// outputs and memory, and a PC has 99 points of each kind
    #[arg(long, value_name = "BOARD", value_parser = boards())]
    board: Option<Board>,
}

fn languages() -> impl TypedValueParser<Value = WrittenIn> {
    PossibleValuesParser::new(WrittenIn::all().into_iter().map(WrittenIn::name))
        .map(|name| WrittenIn::named(&name).unwrap_or(WrittenIn::Numeric))
}

/// The boards that there are programs for.
pub fn boards() -> impl TypedValueParser<Value = Board> {
    let value = |board: Board| {
        let value = PossibleValue::new(board.id());
        match board {
            // Its boot loader is another, its firmware the same.
            Board::NANO => value.alias("nano-old"),
            _ => value,
        }
    };
    // The parser lets through no other name.
    PossibleValuesParser::new(Board::ALL.map(value)).map(|name| {
        let name = name.strip_suffix("-old").unwrap_or(&name);
        Board::named(name).unwrap_or(Board::UNO)
    })
}

fn dialects() -> impl TypedValueParser<Value = Dialect> {
    PossibleValuesParser::new(Dialect::ALL.map(Dialect::name))
        .map(|name| Dialect::named(&name).unwrap_or_default())
}

impl Wording {
    /// The board that it is for.
    pub fn board(&self) -> Board {
        self.board.unwrap_or(Board::UNO)
    }

    /// Whether somebody has said which.
    pub fn names_board(&self) -> bool {
        self.board.is_some()
    }

    /// The same for this board.
    pub fn on(&self, board: Board) -> Wording {
        Wording {
            board: Some(board),
            ..self.clone()
        }
    }

    /// A file of this name, in the language that it is said to be in or else shows.
    pub fn of(&self, name: String, bytes: Vec<u8>) -> Written {
        Written::new(name, bytes, self.board()).or_in(self.language)
    }

    /// For the texts that a command opens: each is compiled once, however often it is asked for.
    pub fn workspace(&self) -> Workspace {
        Workspace::new(Rc::new(All {
            dialect: self.dialect,
        }))
    }

    /// What a text was taken to be; nothing of numeric code.
    pub fn told(&self, language: &Language) -> Option<String> {
        match language {
            Language::Numeric => None,
            Language::Il { dialect, .. } => Some(self.dialect(*dialect)),
            Language::Xml { .. } => Some("PLCopen XML".to_owned()),
            Language::Typed { language, .. } => Some(language.title(messages::spoken()).to_owned()),
        }
    }

    /// Whose Instruction List a text was taken to be, and why.
    pub fn dialect(&self, found: Dialect) -> String {
        match self.dialect {
            Some(_) => messages::dialect(found),
            None => messages::dialect_by_words(found),
        }
    }
}

/// The languages that --lang knows.
pub fn langs() -> impl TypedValueParser<Value = Lang> {
    PossibleValuesParser::new([
        PossibleValue::new("en"),
        PossibleValue::new("pt-BR").aliases(["pt", "pt_BR", "pt-br", "pt_br"]),
    ])
    .map(|name| language(&name).unwrap_or_default())
}

/// The language of this name, as --lang and environments have it: `en`, `pt`, `pt-BR`, `pt_BR.UTF-8`.
pub fn language(name: &str) -> Option<Lang> {
    match name.to_lowercase().split(['-', '_', '.']).next() {
        Some("pt") => Some(Lang::Pt),
        Some("en") => Some(Lang::En),
        _ => None,
    }
}
