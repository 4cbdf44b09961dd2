//! The server, held against an oracle and against clients of others.

mod boundaries;
mod client;
mod common;
mod crc;
mod frames;
mod fuzzed;
mod identification;
mod lock;
mod mutation;
mod page;
mod requests;
mod slices;
