//! How an element looks in characters.

use crate::pins::Pins;
use crate::style::Medium;
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
    /// A box with pins: the columns before it and after it.
    pub(crate) pins: Option<(usize, usize)>,
    /// Columns, of the widest of these.
    pub(crate) width: usize,
}

impl Face {
    /// As it looks in a drawing for this.
    pub(crate) fn new(element: &Element, names: &Names, medium: Medium<'_>) -> Face {
        let live = match medium {
            Medium::Text(live) => element.steps.last().and_then(|&step| live(step)),
            Medium::Paper | Medium::Screen => None,
        };
        let pins = element.pins.as_ref().and_then(|pins| match medium {
            Medium::Text(_) => None,
            Medium::Paper => Some((pins.before(), 0)),
            Medium::Screen => Some((pins.before(), pins.behind())),
        });
        let mut notes = Vec::new();
        let symbol = match &element.symbol {
            Symbol::Contact { closed, text } => {
                format!("┤{}{text} ├", if *closed { '/' } else { ' ' })
            }
            Symbol::Inline(text) => format!("┤{text}├"),
            Symbol::Coil { letter: '/', text } => format!("(/{text} )"),
            Symbol::Coil { letter: ' ', text } => format!("( {text} )"),
            Symbol::Coil { letter, text } => format!("({letter} {text})"),
            Symbol::Box { .. } if pins.is_some() => Pins::text(),
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
        let beside = pins.map_or(0, |(before, behind)| before + Pins::BOX + behind);
        let width = texts.chain(indented).max().unwrap_or(0).max(beside);
        Face {
            name,
            symbol,
            notes,
            pins,
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
