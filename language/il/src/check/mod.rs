//! Instruction List as a front end of the typed tree: from its syntax tree to units, variables and statements.
//!
//! A body is run line by line on expressions in place of values, so that `LD a`, `ADD b`, `ST c` come to `c := a + b`. What a
//! name means and what is wrong with it, `names` says, whoever's way of writing points it is.
//!
//! - `used`: what the text does with its timers and counters, wherever they are declared
//! - `declare`: units and variables; `first`: what they begin with
//! - `operands`: what an operand means and what it is worth; `said`: words of messages
//! - `typed`: values of other types than bits and whole numbers; `norm`: the functions of the standard
//! - `front`: what is known of the whole text; `walk`: what is known of a body, `run`: what is held on the way through it
//! - `lines`: what each line does; `labels`: where jumps lead, and which lines need the accumulator; `flow`: jumps, RET, IF
//! - `accumulator`: the accumulator, and what is put aside of it; `bits`, `numbers`, `stores`, `edges`: what works on it
//! - `defer`: what waits from `(` to `)`; `stack`: ALD, OLD, PUSH, POP; `branches`: MPS, MRD, MPP
//! - `decide`: what is done where the accumulator is 1; `tables`: registers in a row
//! - `circles`: calls without end; `calls`, `units`, `timers`, `counters`: what is called
//! - `makers`, `blocks`: what the makers write in their own ways; `push`, `codes`: what the board's own words do
//!
//! Must not know what a statement costs.

mod accumulator;
mod bits;
mod blocks;
mod branches;
mod calls;
mod circles;
mod codes;
mod counters;
mod decide;
mod declare;
mod defer;
mod edges;
mod first;
mod flow;
mod front;
mod labels;
mod latches;
mod lines;
mod makers;
mod norm;
mod numbers;
mod operands;
mod push;
mod run;
mod said;
mod stack;
mod stores;
mod tables;
mod timers;
mod typed;
mod units;
mod used;
mod walk;

use crate::names::Names;
use crate::parser::{self, Parsed};
use crate::whole;
use crate::written::written;
use front::Front;
use std::collections::{HashMap, HashSet};
use unoclp_core::Board;
use unoclp_st::Checker;
use unoclp_text::Dialect;
use unoclp_text::diagnostics::Found;
use unoclp_tree::build::{Builder, Letters};
use unoclp_tree::{Options, Read, Tree};
use used::Used;

/// Reads a text in this maker's Instruction List, or in that which its words look like.
pub fn read(text: &str, options: &Options, found: &mut Found) -> Read {
    let parsed = parser::parse(text, found);
    let dialect = options.dialect.unwrap_or_else(|| parsed.signs.dialect());
    let readable = whole::is_readable(found) && !parsed.wrong_declarations;
    let tree = match readable {
        true => tree(text, dialect, options.board, &parsed, found),
        false => None,
    };
    Read {
        tree,
        written: Some(written(text, parsed, dialect)),
    }
}

fn tree(
    text: &str,
    dialect: Dialect,
    board: Board,
    parsed: &Parsed,
    found: &mut Found,
) -> Option<Tree> {
    let units = parsed.units.as_slice();
    let mut builder = Builder::new(text, Letters::Alike, board, found);
    builder.is_list = true;
    builder.is_wide = true;
    builder.divides_by_zero = true;
    builder.may_do_nothing();
    let mut front = Front {
        units,
        names: Names::new(text, dialect, board, units),
        c: Checker::of_list(builder, &parsed.pieces.types, dialect.maker()),
        pieces: &parsed.pieces,
        has_types: parsed.pieces.declares(),
        used: Used::of(units, dialect),
        numbers: Vec::new(),
        instances: Vec::new(),
        stages: Vec::new(),
        edge_inputs: Vec::new(),
        aliases: HashMap::new(),
        functions: HashMap::new(),
        coils: HashMap::new(),
        timed: HashSet::new(),
        timers: vec![None; units.len()],
        instance_calls: Vec::new(),
        called: vec![false; units.len()],
        within: 0,
        writes: false,
    };
    front.declare_all();
    let is_endless = front.refuse_circles();
    for unit in 0..units.len() {
        front.body(unit);
    }
    front.timers_again();
    front.never_used();
    whole::check(text, units, front.writes, front.c.builder.found);
    if is_endless || front.c.builder.found.has_errors() {
        return None;
    }
    front.c.builder.finish()
}
