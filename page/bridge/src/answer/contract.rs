//! The answers in TypeScript, which the page is compiled with.

use super::Types;
use crate::ask::{First, More};
use std::path::Path;
use std::{env, fs};

const HEAD: &str = "// What Rust answers. Made of the types of page/bridge: do not edit it; the test of\n\
                    // page/bridge/src/answer/contract.rs writes it where UPDATE=1 is set.\n\n\
                    import type { LanguageName, Place, Rectangle } from \"./said\";\n\n\
                    export type * from \"./said\";\n\n";

/// The types of all answers.
pub fn answers() -> Types {
    let mut all = Types::default();
    First::answers(&mut all);
    More::answers(&mut all);
    all
}

/// Compares a file of the page with what it shall be, or writes it where UPDATE=1 is set.
pub fn compare(file: &str, written: String) {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../web/src/tools");
    let file = page.join(file);
    if env::var_os("UPDATE").is_some() {
        return fs::write(file, written).unwrap();
    }
    let known = fs::read_to_string(file).unwrap();
    assert_eq!(known, written, "UPDATE=1 writes it");
}

#[test]
fn the_page_is_compiled_with_the_answers_of_rust() {
    compare("answers.ts", format!("{HEAD}{}", answers().written()));
}
