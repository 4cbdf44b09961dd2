//! The compiler, from text to what the program does.

mod any_text;
mod blocks;
mod board;
mod cases;
mod common;
mod documents;
mod examples;
mod fuzzed;
mod fuzzed_typed;
mod grammars;
mod limits;
mod places;
mod random_programs;
mod random_typed;
mod round_trip;
mod shapes;
mod sizes;
mod to_st;
mod twins;
mod typed;
mod typed_any_text;
mod typed_pages;
mod typed_random;
mod typed_slips;
mod typed_tree;
mod words;
