//! Conversations with a board in memory, on a line on which time passes only while a conversation waits.

mod download;
#[path = "../fake/mod.rs"]
mod fake;
mod find;
mod line;
mod live;
mod read;
mod requests;
mod upload;
mod watch;
mod words;
