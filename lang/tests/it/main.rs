//! The compiler, from text to what the program does.

mod any_text;
mod blocks;
mod common;
mod documents;
mod examples;
mod fuzzed;
mod places;
mod random_programs;
mod retain;
mod round_trip;
mod twins;
mod words;
