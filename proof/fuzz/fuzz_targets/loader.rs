//! A program file, and a stored program: core/tests/it/fuzzed.rs.

#![no_main]

#[path = "../../../device/core/tests/it/fuzzed.rs"]
mod fuzzed;

libfuzzer_sys::fuzz_target!(|data: &[u8]| fuzzed::hold(data));
