//! How a front end makes a tree.
//!
//! A front end reads its text into a syntax tree of its own and then tells a [`Builder`] what stands there, in this
//! order; types hold it to that order. Each step tells what is wrong in it, once, in the words that all languages share; what came of something
//! wrong is a [`ExprKind::Wrong`](crate::ExprKind::Wrong), of which nothing more is told.
//!
//! 1. **Types**, if the language derives any: `builder.tree.types.add(…)`, then [`Builder::name_type`].
//! 2. **Units**: [`Builder::unit`] makes one that is [`Declaring`], and [`Builder::enter`] goes into it.
//!    [`Builder::declare`] declares a variable ([`Section`] says of which kind). [`Builder::close`] ends the declarations:
//!    the unit is [`Closed`], and a block's has a type for instances, [`Builder::block_type`]. [`Builder::back`] goes back
//!    to where it was [`Before`]; [`Builder::outside`] of all units, `declare` declares globals.
//! 3. **Expressions**, inside out: [`Builder::whole`], [`Builder::literal`], [`Builder::name`] with
//!    [`Builder::member`] and [`Builder::subscript`] and then [`Builder::read`]; [`Builder::arithmetic`],
//!    [`Builder::logic`], [`Builder::compare`], [`Builder::negate`], [`Builder::not`]; [`Builder::function`] (of the
//!    norm) and [`Builder::call`] (of the text). They find the common type, put in conversions and fold constants.
//!    [`Builder::explicit`] converts as a language asks, [`Builder::coerce`] as a place needs it.
//! 4. **Statements**: [`Builder::assign`], [`Builder::condition`] for IF, WHILE and REPEAT, [`Builder::counting`]
//!    for FOR, [`Builder::selector`] and [`Builder::labels`] for CASE, [`Builder::print`], [`Builder::call`], [`Builder::block`]. Others are made as they are.
//! 5. [`Builder::body`] gives a closed unit its statements, once, and [`Builder::finish`] gives the tree.
//!
//! A variable of the front end's own is `unseen`, or [`Section::Temp`] if it need not last; what holds a symbol in one
//! of two cells is pushed to `builder.tree.symbols` as [`Holds::Either`](super::Holds). `%` before a name makes
//! [`Builder::name`] take it for an address. A declaration that is wrong is followed by [`Builder::hide`], so that
//! nothing more is told of its name.
//!
//! A program of a language without types and units takes a few lines:
//!
//! ```text
//! let mut builder = Builder::new(text, Letters::Alike, board, &mut found);
//! let main = builder.unit("main", UnitKind::Program, span);
//! let outside = builder.enter(&main);
//! builder.declare("x", span, TypeId::of(Base::Int), Section::Var, Traits::default());
//! let main = builder.close(main);
//! let one = builder.whole(1, span);
//! let to = builder.name("x", span);              // a Target, or None: told
//! let statement = to.and_then(|to| builder.assign(to, one, span));
//! builder.back(outside);
//! builder.body(main, statement.into_iter().collect());
//! let tree = builder.finish();                   // None where there are errors
//! ```

mod arguments;
mod bits;
mod blocks;
mod builder;
mod calls;
mod cells;
mod coerce;
mod counted;
mod declare;
mod edges;
mod finish;
mod functions;
mod inputs;
mod members;
mod named;
mod names;
mod operations;
mod operators;
mod passing;
mod places;
pub mod points;
mod remedies;
mod stages;
mod statements;
mod symbols;
mod turns;
mod words;

pub use arguments::{Argument, Given};
pub use builder::{Builder, MOST_CELLS};
pub use edges::{Edge, EdgeInput};
pub use functions::{functions, is_function, usual};
pub use named::{Letters, Named, Section, Traits};
pub use places::Target;
pub use stages::{Before, Closed, Declaring, Enter};
pub use turns::{leaves, turns};
pub use words::both;
