//! A request to the Modbus server: modbus/tests/it/fuzzed.rs.

#![no_main]

#[allow(dead_code, reason = "the tests share more than a target uses")]
#[path = "../../modbus/tests/it/common/mod.rs"]
mod common;
#[path = "../../modbus/tests/it/fuzzed.rs"]
mod fuzzed;

libfuzzer_sys::fuzz_target!(|data: &[u8]| fuzzed::hold(data));
