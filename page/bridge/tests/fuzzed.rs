//! Whatever bytes a page asks with, one ask a line: each is answered, and the answer says one thing.

#![cfg(feature = "full")]

use serde_json::Value;
use unoclp_bridge::{Boards, answer};

/// What holds of all bytes; the target `asks` of `proof/fuzz/` looks for those of which it does not.
pub fn hold(bytes: &[u8]) {
    let mut boards = Boards::default();
    for request in bytes.split(|&byte| byte == b'\n').take(16) {
        let told = answer(request, &mut boards);
        let told: Value = serde_json::from_str(&told).expect("an answer is JSON");
        let keys: Vec<&String> = told.as_object().expect("an object").keys().collect();
        assert!(matches!(keys[..], [key] if key == "ok" || key == "error"));
    }
}

#[test]
fn the_corpus_holds() {
    unoclp_testing::each_of_corpus("asks", hold);
}
