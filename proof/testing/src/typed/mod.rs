//! Random programs in Structured Text, of all types that the board has.
//!
//! What is written compiles; what constants alone come to may be told as an error of its own, and so may be what a
//! board has no room for.

mod statements;
mod values;

use crate::Random;
use std::fmt::Write;

/// The whole numbers, and how names of their variables begin.
const NUMBERS: [(&str, &str); 9] = [
    ("SINT", "si"),
    ("INT", "i"),
    ("DINT", "d"),
    ("USINT", "us"),
    ("UINT", "u"),
    ("UDINT", "ud"),
    ("BYTE", "by"),
    ("WORD", "w"),
    ("DWORD", "dw"),
];

/// Times and dates, alike.
const MOMENTS: [(&str, &str); 4] = [("TIME", "t"), ("TOD", "tod"), ("DATE", "day"), ("DT", "dt")];

const COLORS: [&str; 3] = ["Red", "Green", "Blue"];

/// Functions, blocks and types that the program uses.
const UNITS: &str = "\
FUNCTION Twice : INT
VAR_INPUT x : INT; END_VAR
VAR n : INT := 2; END_VAR
IF x > 1000 THEN Twice := 7; RETURN; END_IF;
Twice := x * n;
END_FUNCTION
FUNCTION Mean : REAL
VAR_INPUT a, b : REAL; END_VAR
Mean := (a + b) / 2.0;
END_FUNCTION
FUNCTION_BLOCK Own
VAR_INPUT up : BOOL; step : INT; END_VAR
VAR_OUTPUT sum : INT; END_VAR
VAR edge : R_TRIG; END_VAR
edge(CLK := up);
IF edge.Q THEN sum := sum + step; END_IF;
END_FUNCTION_BLOCK
FUNCTION_BLOCK Outer
VAR_INPUT go : BOOL; END_VAR
VAR_OUTPUT seen : INT; done : BOOL; END_VAR
VAR inner : Own; wait : TON; END_VAR
inner(up := go, step := 3);
wait(IN := go, PT := T#40ms);
seen := inner.sum;
done := wait.Q;
END_FUNCTION_BLOCK
FUNCTION_BLOCK Total
VAR_INPUT more : DINT; END_VAR
VAR_OUTPUT calls : USINT; END_VAR
VAR_IN_OUT total : DINT; END_VAR
VAR_TEMP was : DINT; END_VAR
was := total;
total := total + more;
IF total < was THEN calls := calls + 2; ELSE calls := calls + 1; END_IF;
END_FUNCTION_BLOCK
TYPE
Color : (Red, Green, Blue) := Green;
Pair : STRUCT x : DINT; on : BOOL; END_STRUCT;
Deep : STRUCT pair : Pair; r : REAL := 0.5; v : ARRAY[0..1] OF SINT; END_STRUCT;
END_TYPE
";

/// Variables beside those of the plain types.
const VARIABLES: &str = "\
  r0 : REAL := 1.5; r1 : REAL; b0, b1 : BOOL; b2 : BOOL := TRUE; b3, e0, e1 : BOOL; c0, c1 : Color;
  a : ARRAY[0..2] OF INT := [1, 2, 3]; m : ARRAY[-1..1, 0..1] OF INT; f : ARRAY[0..3] OF BOOL;
  ra : ARRAY[0..2] OF REAL := [3(0.25)]; p : ARRAY[0..1] OF Pair; q : Deep; narrow : INT(-5..100);
  k0, k1, c : INT; lamp AT %QX1 : BOOL; horn AT %QX2 : BOOL; level AT %QW4 : INT; totals : ARRAY[0..1] OF Total;
";

/// Blocks that have one call each.
const BLOCKS: [&str; 12] = [
    "TON", "TOF", "TP", "CTU", "CTD", "CTUD", "SR", "RS", "R_TRIG", "F_TRIG", "Own", "Outer",
];

/// Writes a text.
struct Author {
    random: Random,
    text: String,
    depth: usize,
    /// Loops so far: each has a variable of its own.
    loops: usize,
    /// Blocks that are still to be called.
    blocks: Vec<&'static str>,
    /// Blocks that have been.
    called: Vec<&'static str>,
}

/// The program of this seed, of about so many statements outside of others.
pub fn typed_program(seed: u64, statements: usize) -> String {
    let mut author = Author {
        random: Random(seed),
        text: String::new(),
        depth: 0,
        loops: 0,
        blocks: BLOCKS.to_vec(),
        called: Vec::new(),
    };
    for at in (1..BLOCKS.len()).rev() {
        let other = author.random.below(at + 1);
        author.blocks.swap(at, other);
    }
    let mut head = format!("{UNITS}PROGRAM main\nVAR\n");
    for (ty, prefix) in NUMBERS.into_iter().chain(MOMENTS) {
        let first = author.literal(ty);
        let _ = writeln!(head, "  {prefix}0 : {ty} := {first}; {prefix}1 : {ty};");
    }
    head.push_str(VARIABLES);
    for block in BLOCKS {
        let _ = writeln!(head, "  x{} : {block};", block.to_lowercase());
    }
    for _ in 0..statements {
        author.statement();
    }
    // What a board tells of a scan's arithmetic it forgets at its end.
    format!("{head}END_VAR\n{}e1 := %S4;\nEND_PROGRAM\n", author.text)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn together_the_programs_use_everything() {
        let all: String = (0..500).map(|seed| body(&typed_program(seed, 8))).collect();
        let prefixes = NUMBERS.iter().chain(&MOMENTS).map(|(_, prefix)| *prefix);
        let names = prefixes.map(|prefix| format!("{prefix}1 := "));
        let calls = BLOCKS.map(|block| format!("x{}(", block.to_lowercase()));
        let words = [
            "r1 := ",
            "c1 := ",
            "e0 := %S4",
            "level := ",
            "lamp := ",
            "narrow := ",
            "f[k",
            "a[k",
            "m[k",
            "ra[k",
            "p[k",
            "q.v[k",
            "q.pair.x",
            "q.r",
            "totals[1](",
            "a[DINT_TO_",
            "ra[UINT_TO_",
            "p[INT_TO_",
            "MUX(UDINT_TO_",
            "CASE DINT_TO_INT(",
            "USINT_TO_TIME(",
            "_TO_TOD(",
            "_TO_DATE(",
            "FOR ",
            "WHILE ",
            "REPEAT",
            "CASE ",
            "ELSIF ",
            "EXIT;",
            "CONTINUE;",
            "Twice(",
            "Mean(",
            "MUX(",
            "SEL(",
            "LIMIT(",
            "SQRT(",
            "EXPT(",
            "ROL(",
            "ROR(",
            "SHL(",
            "SHR(",
            "TRUNC(",
            " MOD ",
            "%IX",
            "%IW4",
            "%S1",
            "%S2",
            "%S3",
        ];
        let words = words.map(str::to_owned).into_iter();
        for word in words.chain(names).chain(calls) {
            assert!(all.contains(&word), "{word} never occurs");
        }
    }

    /// After the declarations.
    fn body(text: &str) -> String {
        let program = text.split_once("PROGRAM main").unwrap().1;
        program.split_once("END_VAR").unwrap().1.to_owned()
    }

    #[test]
    fn the_seed_decides_the_program() {
        assert_eq!(typed_program(7, 5), typed_program(7, 5));
        assert_ne!(typed_program(7, 5), typed_program(8, 5));
    }
}
