//! The compiler, from text to what the program does.

mod any_text;
mod blocks;
#[allow(dead_code, reason = "each test uses its part")]
mod board;
mod cases;
mod common;
mod documents;
mod examples;
mod fuzzed;
mod grammars;
mod limits;
mod places;
mod random_programs;
mod random_typed;
mod round_trip;
mod sizes;
mod small_any_text;
mod twins;
mod typed;
mod typed_any_text;
mod typed_pages;
mod typed_random;
mod typed_slips;
mod typed_tree;
mod words;
