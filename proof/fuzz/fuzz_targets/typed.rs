//! A text in Structured Text, SCL, InterSCL or LCE: lang/tests/it/fuzzed_typed.rs.

#![no_main]

#[path = "../../../language/lang/tests/it/fuzzed_typed.rs"]
mod fuzzed_typed;

libfuzzer_sys::fuzz_target!(|data: &[u8]| fuzzed_typed::hold(data));
