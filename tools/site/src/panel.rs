//! A panel: what a person sees of boards on one sheet, and writes there.

use crate::alarm::Text;
use crate::grant::Grant;

/// A panel.
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// What it is called in addresses, as no other panel of the site is.
    pub name: String,
    /// What stands above it.
    pub title: Text,
    /// Columns of its grid.
    pub columns: u8,
    /// A drawing in SVG above the grid, if there is one.
    pub drawing: Option<String>,
    /// What is on the grid, in this order.
    pub items: Vec<Item>,
    /// What moves in the drawing.
    pub binds: Vec<Bind>,
    /// It is made of a board's names, and of no file.
    pub is_made: bool,
}

/// Something on a panel.
#[derive(Clone, Debug, PartialEq)]
pub struct Item {
    /// What it is.
    pub look: Look,
    /// The board.
    pub board: String,
    /// The point.
    pub point: String,
    /// What stands beside it.
    pub label: Text,
    /// The unit of the value, as it is shown: `°C`.
    pub unit: String,
    /// The least value and the most: of a bar, and of what may be set.
    pub range: [f64; 2],
    /// Its column and row, from 1; without them the next free place.
    pub at: Option<[u8; 2]>,
    /// How many columns and rows it takes.
    pub size: [u8; 2],
    /// How it is written; none where nobody may.
    pub grant: Option<Grant>,
}

/// What an item is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Look {
    /// A lamp, lit while the value is not 0.
    Lamp,
    /// The value as a number.
    Value,
    /// The value as a bar.
    Bar,
    /// What the value was.
    Trend,
    /// Writes 1 while it is pressed, and 0 then.
    Button,
    /// Turns 0 into 1, and 1 into 0.
    Switch,
    /// Takes a number.
    Set,
}

impl Look {
    /// All of them.
    pub const ALL: [Look; 7] = [
        Look::Lamp,
        Look::Value,
        Look::Bar,
        Look::Trend,
        Look::Button,
        Look::Switch,
        Look::Set,
    ];

    /// As the file has it, and the page is told.
    pub fn word(self) -> &'static str {
        match self {
            Look::Lamp => "lamp",
            Look::Value => "value",
            Look::Bar => "bar",
            Look::Trend => "trend",
            Look::Button => "button",
            Look::Switch => "switch",
            Look::Set => "set",
        }
    }

    /// Whether it writes.
    pub fn writes(self) -> bool {
        matches!(self, Look::Button | Look::Switch | Look::Set)
    }

    /// The usual columns and rows.
    pub(crate) fn size(self) -> [u8; 2] {
        match self {
            Look::Trend => [2, 2],
            _ => [1, 1],
        }
    }
}

/// What a point does to an element of a drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct Bind {
    /// The `id` of the element.
    pub id: String,
    /// The board.
    pub board: String,
    /// The point.
    pub point: String,
    /// What it does.
    pub does: Does,
    /// The values that are nothing and all of it.
    pub range: [f64; 2],
}

/// What becomes of an element of a drawing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Does {
    /// It is seen while the value is not 0.
    Show,
    /// It has the colour of power while the value is not 0.
    Light,
    /// Its text is the value.
    Text,
    /// It is as high as the value, from below.
    Level,
    /// It is turned, from 0 to 360 degrees.
    Turn,
}

impl Does {
    /// All of them.
    pub const ALL: [Does; 5] = [Does::Show, Does::Light, Does::Text, Does::Level, Does::Turn];

    /// As the file has it, and the page is told.
    pub fn word(self) -> &'static str {
        match self {
            Does::Show => "show",
            Does::Light => "light",
            Does::Text => "text",
            Does::Level => "level",
            Does::Turn => "turn",
        }
    }
}

/// The same text in both languages.
pub(crate) fn plain(text: &str) -> Text {
    Text {
        en: text.to_owned(),
        pt: text.to_owned(),
    }
}
