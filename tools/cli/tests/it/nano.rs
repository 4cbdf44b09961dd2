//! Programs for a Nano: what its firmware does not have is named, in every language.

use crate::common::{file, outcome, outcome_in};

/// Name and text, and the instruction that is refused.
const PROGRAMS: [(&str, &str, &str); 3] = [
    (
        "nano.txt",
        "0\n766801\n82656800\n1065353216\n838402\n",
        "RAD",
    ),
    ("nano.il", "LD D1\nREAL_ADD 1.0\nST D2\n", "RAD 00"),
    (
        "nano.st",
        "PROGRAM p\nVAR a : REAL; END_VAR\na := a + 1.5;\nEND_PROGRAM\n",
        "RAD 00",
    ),
];

#[test]
fn a_program_with_real_numbers_is_refused_by_the_instruction() {
    for (name, text, instruction) in PROGRAMS {
        let path = file(name, text);
        assert_eq!(outcome(&["check", &path]).0, 0, "{name}");
        for board in ["nano", "nano-old"] {
            let (code, out, _) = outcome(&["check", &path, "--board", board]);
            assert!(code == 1 && out.contains("24"), "{name}: {out}");
            assert!(out.contains(instruction), "{name}: {out}");
            assert!(out.contains("the firmware of a Nano"), "{name}: {out}");
            let portuguese = ["check", &path, "--board", board];
            let (code, out, _) = outcome_in(&portuguese, "pt_BR.UTF-8");
            assert!(
                code == 1 && out.contains("o firmware de um Nano não tem"),
                "{out}"
            );
        }
    }
}

#[test]
fn all_else_is_taken_for_a_nano() {
    let path = file("nano-follow.il", "LD I1\nTON T1, 500\nST Q1\n");
    let (code, out, err) = outcome(&["check", &path, "--board", "nano"]);
    assert_eq!(code, 0, "{out}{err}");
}
