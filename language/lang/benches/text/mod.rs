//! The text that is measured.

use std::fmt::Write;

/// Structured Text of so many lines, in function blocks as a person would write them.
pub fn structured(lines: usize) -> String {
    let mut text = String::new();
    for block in 0..lines / 10 {
        write!(
            text,
            "FUNCTION_BLOCK Drive{block}\nVAR_INPUT go : BOOL; level : INT; END_VAR\nVAR_OUTPUT run : BOOL; END_VAR\n\
             VAR i : INT; END_VAR\nIF go AND level > 100 OR run THEN\n  run := go;\n\
             ELSIF level MOD 7 = 3 THEN\n  i := i + level * 3 / (i + 1);\nEND_IF;\nEND_FUNCTION_BLOCK\n"
        )
        .unwrap_or_default();
    }
    text + "PROGRAM main\nVAR d : Drive0; END_VAR\nd(level := 5);\nEND_PROGRAM\n"
}
