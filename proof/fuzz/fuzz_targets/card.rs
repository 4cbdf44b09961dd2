//! A damaged card: card/tests/it/fuzzed.rs.

#![no_main]

#[allow(dead_code, reason = "the tests share more than a target uses")]
#[path = "../../../device/card/tests/it/common/mod.rs"]
mod common;
#[path = "../../../device/card/tests/it/fuzzed.rs"]
mod fuzzed;

libfuzzer_sys::fuzz_target!(|data: &[u8]| fuzzed::hold(data));
