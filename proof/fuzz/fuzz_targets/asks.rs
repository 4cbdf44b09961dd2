//! What a page asks, one ask a line: page/bridge/tests/fuzzed.rs.

#![no_main]

#[path = "../../../page/bridge/tests/fuzzed.rs"]
#[allow(dead_code)]
mod fuzzed;

libfuzzer_sys::fuzz_target!(|data: &[u8]| fuzzed::hold(data));
