//! The typed tree: what a program means, whichever language it is written in.
//!
//! Owns types, variables as places in cells, expressions whose every conversion is a node, and statements. Must not know
//! how a language is written, how a board does it, nor where a text comes from.
//!
//! It is a tree of its own and not a syntax tree with types added, so that what runs it or lowers it asks no question of
//! types again.
//!
//! The way to it and from it:
//!
//! ```text
//! parser of a language ─► its syntax tree ─► its front end ─► Builder ─► Tree ─┬─► run (the interpreter)
//!                                                                             └─► lowering
//! ```
//!
//! - `base`, `types`, `value`: elementary types, derived types, values
//! - `standard`: the function blocks of the standard and their cells
//! - `tree`: units and their cells; `statement`; `expression`: expressions and places
//! - `literal`: what literals are worth; `codes`: instructions that a text says by their codes
//! - `ops`, `conversions`: what each operation gives, for folding and for the interpreter alike, in the `width` of types
//! - `build`: how a front end makes a tree; see there. `front`: what else a language is
//!
//! **Cells.** A variable without parts takes one cell. Members and elements stand in a row, so each constant
//! subscript and each member is an offset. A [`Place`] is a root (the program's cells, the block's own, the
//! call's, or those the caller lends), an offset, and [`Index`]es, one for each subscript that is computed.
//!
//! **Positions.** A node has its [`Span`](unoclp_text::diagnostics::Span); [`Lines`](unoclp_text::diagnostics::Lines) turns it into line and column, and
//! the unit is the one whose body it stands in.
//!
//! **Calls.** A function's cells are new at each call, a block's are its instance's. No unit calls itself, so a
//! lowering may put a body in place of each call, with the instance's offset for [`Root::Own`] and the caller's
//! places for [`Root::Lent`].
//!
//! **Arithmetic.** It is 32 bits wide (64 for the types of the PC alone); a value is narrowed where it is
//! stored ([`Store`]) or converted ([`Convert`]).
//!
//! **Order.** Operands are computed from left to right, all of them: AND and OR leave none out, and neither do
//! [`ExprKind::Select`] and [`ExprKind::Mux`]. An assignment computes its value before the subscripts of its place;
//! a call computes all that it gives before the callee's cells are made.

#![forbid(unsafe_code)]

mod base;
pub mod build;
pub mod codes;
mod conversions;
mod enumeration;
mod expression;
mod front;
mod given;
pub mod literal;
pub mod ops;
pub mod run;
mod standard;
mod statement;
mod tree;
mod types;
mod value;
mod width;

pub use base::{Base, Generic, Width};
pub use build::{functions, is_function, usual};
pub use enumeration::Enumeration;
pub use expression::{
    Binary, Call, Compare, Convert, Expr, ExprKind, Extra, Index, Input, Output, Place, Root,
    Store, Unary,
};
pub use front::{FrontEnd, Options, Painted, Read, Units, Written};
pub use given::given;
pub use standard::{Part, Role, Standard, counter};
pub use statement::{Arm, Codes, For, Order, Stmt, StmtKind};
pub use tree::{Cell, Declared, Holds, Symbol, Tree, Unit, UnitKind};
pub use types::{Initial, Kind, Member, Type, TypeId, Types};
pub use value::{Value, days};
pub use width::narrow;
