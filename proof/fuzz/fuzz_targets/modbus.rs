//! A request to the Modbus server: modbus/tests/it/fuzzed.rs.

#![no_main]

#[allow(dead_code, reason = "the tests share more than a target uses")]
#[path = "../../../device/modbus/tests/it/common/mod.rs"]
mod common;
#[path = "../../../device/modbus/tests/it/fuzzed.rs"]
mod fuzzed;

libfuzzer_sys::fuzz_target!(|data: &[u8]| fuzzed::hold(data));
