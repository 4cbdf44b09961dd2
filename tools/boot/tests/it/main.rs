//! Files, and a boot loader in memory, on a line on which time passes only while one waits.

mod bench;
mod files;
mod line;
mod words;
