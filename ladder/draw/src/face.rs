//! How an element looks in characters.

use crate::{Element, Names, Symbol};
use unicode_width::{UnicodeWidthChar, UnicodeWidthStr};

/// The longest name that is shown whole, in columns.
const LONGEST_NAME: usize = 20;

/// How far notes stand in.
pub(crate) const INDENT: usize = 2;

/// An element in characters.
#[derive(Clone, Debug)]
pub(crate) struct Face {
    /// The name of its point, above.
    pub(crate) name: Option<String>,
    /// The symbol, on the wire.
    pub(crate) symbol: String,
    /// Below.
    pub(crate) notes: Vec<String>,
    /// Columns, of the widest of these.
    pub(crate) width: usize,
}

impl Face {
    /// `live` replaces the text of a box.
    pub(crate) fn new(element: &Element, names: &Names, live: Option<String>) -> Face {
        let mut notes = Vec::new();
        let symbol = match &element.symbol {
            Symbol::Contact { closed, text } => {
                format!("┤{}{text} ├", if *closed { '/' } else { ' ' })
            }
            Symbol::Inline(text) => format!("┤{text}├"),
            Symbol::Coil { letter: '/', text } => format!("(/{text} )"),
            Symbol::Coil { letter: ' ', text } => format!("( {text} )"),
            Symbol::Coil { letter, text } => format!("({letter} {text})"),
            Symbol::Box { text, notes: below } => {
                notes.clone_from(below);
                format!("[ {} ]", live.as_ref().unwrap_or(text))
            }
            Symbol::Leave { inverted, text } => {
                format!("{}{text}", if *inverted { "┤NOT├──" } else { "" })
            }
        };
        let name = element.point.and_then(|point| names.get(&point));
        let name = name.map(|name| shorten(name, LONGEST_NAME));
        let indented = notes.iter().map(|note| INDENT + note.width());
        let texts = name.iter().chain([&symbol]).map(|text| text.width());
        let width = texts.chain(indented).max().unwrap_or(0);
        Face {
            name,
            symbol,
            notes,
            width,
        }
    }
}

/// The text, or so much of it that it fits with an ellipsis. Control characters are left out.
fn shorten(text: &str, columns: usize) -> String {
    let text: String = text.chars().filter(|c| !c.is_control()).collect();
    if text.width() <= columns {
        return text;
    }
    let mut short = String::new();
    let mut width = 1;
    for character in text.chars() {
        width += character.width().unwrap_or(0);
        if width > columns {
            break;
        }
        short.push(character);
    }
    short + "…"
}
