//! The walk, held against other readers and against damage.

mod common;
mod damaged;
mod fuzzed;
mod image;
mod in_place;
mod mutation;
mod reads;
mod volumes;
