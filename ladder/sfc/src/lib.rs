//! Charts (SFC, GRAFCET) as diagrams: the document of one, its drawing, and what a person may do to it.
//!
//! Owns how a chart stands on paper, and how it is changed there. Must not know files, screens, what a board does. What a
//! chart is and does, `unoclp-chart` knows; what its conditions and bodies say, the language that they are written in.
//!
//! ```text
//! text ─Document::all─► Document ─Outline::of─► Outline ─Sheet::of─► Sheet ─► svg, picture
//!   ▲                      │ edit
//!   └──Document::text──────┘
//! ```
//!
//! - `document`: a chart with its text; what nobody changes stays as it was written
//! - `net`: its names as numbers; `outline`: sequences, selections and simultaneous sequences, and what is a jump
//! - `sheet`: where all of it stands; `svg`, `picture`: drawn, as an SVG and of characters; `look`: the words of both norms
//! - `live`: what is active, and for how long; `origin`: which part an instruction comes from
//! - `edit`: operations, each from a document to a document
//!
//! Any chart can be drawn: where lines would cross, a jump names its step, and a transition the steps that it waits for.

#![forbid(unsafe_code)]

mod document;
pub mod edit;
mod grid;
mod live;
mod look;
mod measure;
mod net;
mod origin;
mod outline;
mod picture;
mod sheet;
mod svg;

pub use document::{Action, Document, Does, Places, Step, Transition};
pub use live::{Live, State};
pub use look::Look;
pub use origin::Origin;
pub use outline::{Branch, Fork, Outline, Part};
pub use picture::picture;
pub use sheet::{Area, Id, Sheet};
pub use svg::svg;
pub use unoclp_chart::Qualifier;
