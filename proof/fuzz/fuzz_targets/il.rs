//! A text in Instruction List: lang/tests/it/fuzzed.rs.

#![no_main]

#[allow(dead_code, reason = "the tests share more than a target uses")]
#[path = "../../../language/lang/tests/it/common/mod.rs"]
mod common;
#[path = "../../../language/lang/tests/it/fuzzed.rs"]
mod fuzzed;

libfuzzer_sys::fuzz_target!(|data: &[u8]| fuzzed::hold(data));
