//! Projects in PLCopen XML (TC6, 2.01), as OpenPLC Editor and Beremiz write them: to a checked program, and from a
//! document of the ladder editor.
//!
//! Owns what the elements of such a file mean, and how a ladder is drawn in them. Must not know files, screens.
//!
//! The way in ([`import`]):
//!
//! - `bounds`: what a text may hold; `xml`: text → tree; `broken`: why there is none; `project`: POUs, variables, what runs and in which order
//! - `network`: the elements of a ladder body, and the wires between them; `numbered`: its rungs, as a person counts them
//! - `symbol`: what a variable can be; `points`, `allot`: which point of the board it gets; `scope`: what a name means in a POU
//! - `circuit`: what is in series and in parallel; `ways`: wires followed to the left rail; `flow`: the way of the power to each output
//! - `contacts`, `blocks`, `instances`, `values`: what is on that way
//! - `pins`, `unused`: wires that lead nowhere, and what they come from
//! - `outputs`: the circuits of a network; `effects`: which of them may change places; `anew`: contacts that each output reads for itself; `apart`: coils in the middle of a path that run in their own turn; `rungs`: circuits to rungs of a document; `around`: the first scan, and the numbers of timers; `program`: all of it; `checked`: the document as a board checks it
//! - `outline`: its units and their variables, as a tree; `alter`, `rows`: one of these changed in the file, put into it, taken away
//! - `shown`: the body of a unit as its file lays it out; `bodies`: changed in the file; `edges`: bytes of it, and no others
//! - `grown`: elements that come and go there
//! - `whole`: all of it as one text, for who looks for a name
//! - `adapt`: points that another PLC has, on this board; `comments`: texts without them
//! - `body`: projects as a text, which `unoclp-lang` compiles; `text`: where its pieces are in the file; `types`: types
//!   as it spells them; `lent`: those that a library lends; `repeated`: heads that bodies in ST say again; `st`: ladder bodies as statements, where no document holds them; `sfc`: charts
//!
//! The way out ([`export()`]): `export`.
//!
//! What is wrong with a file is told at its place in it, with the POU and the number of the element. Nothing is left out in
//! silence, and no file makes it panic.

#![forbid(unsafe_code)]

mod adapt;
mod allot;
mod alter;
mod anew;
mod apart;
mod around;
mod blocks;
mod bodies;
mod body;
mod bounds;
mod broken;
mod checked;
mod circuit;
mod comments;
mod contacts;
mod edges;
mod effects;
mod export;
mod flow;
mod found;
mod grown;
mod imported;
mod instances;
mod lent;
mod network;
mod numbered;
mod outline;
mod outputs;
mod pins;
mod points;
mod program;
mod project;
mod repeated;
mod rows;
mod rungs;
mod scope;
mod sfc;
mod shown;
mod st;
mod symbol;
mod text;
mod types;
mod unused;
mod values;
mod ways;
mod whole;
mod xml;

pub use adapt::adapt;
pub use alter::{Change, alter};
pub use bodies::{Charts, Touch, charts, touch, write_body, write_chart};
pub use export::{Exported, Lost, export, export_blocks, export_text};
pub use grown::{Where, draw, erase};
pub use imported::Imported;
pub use outline::{Outline, Row, Unit, outline};
pub use program::import;
pub use rows::{add, remove, retain};
pub use shown::{Piece, Shown, shown};
pub use whole::Whole;

/// Whether a text is such a project, by its first words.
pub fn is_project(text: &str) -> bool {
    let text = text.trim_start();
    let begins = text.starts_with("<?xml") || text.starts_with("<project");
    let first: String = text.chars().take(HEAD).collect();
    begins && first.contains("plcopen.org/xml")
}

/// In so many characters a project has named its namespace.
const HEAD: usize = 2_000;
