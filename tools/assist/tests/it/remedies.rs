//! What can be done about a mistake takes it away.

use crate::texts::text;
use unoclp_assist::{edited, remedies};
use unoclp_lang::Lang;
use unoclp_program::{Refused, Written};

fn told(written: &Written) -> Vec<unoclp_lang::Diagnostic> {
    match written.clone().check(None) {
        Ok(source) => source
            .language
            .warnings()
            .map_or(Vec::new(), |told| told.to_vec()),
        Err(Refused::Text { diagnostics, .. }) => diagnostics.to_vec(),
        Err(_) => Vec::new(),
    }
}

/// The language, the mistake, the first remedy, and the text after it.
const MENDED: [(&str, &str, &str, &str); 9] = [
    (
        "st",
        "PROGRAM p VAR lamp AT %QX1 : BOOL; END_VAR lamb := TRUE; END_PROGRAM",
        "Write `lamp`",
        "lamp := TRUE",
    ),
    (
        "st",
        "PROGRAM p VAR lamp AT %QX1 : BOOL; END_VAR lamp = TRUE; END_PROGRAM",
        "Write `:=`",
        "lamp := TRUE",
    ),
    (
        "st",
        "PROGRAM p VAR x AT %QX1 : BOOL; END_VAR IF x := TRUE THEN x := FALSE; END_IF; END_PROGRAM",
        "Write `=`",
        "IF x = TRUE",
    ),
    (
        "st",
        "PROGRAM p VAR x AT %QX1 : BOOL; END_VAR IF x == TRUE THEN x := FALSE; END_IF; END_PROGRAM",
        "Write `=`",
        "IF x = TRUE",
    ),
    (
        "st",
        "PROGRAM p VAR x AT %QX1 : BOOL; END_VAR x := TRUE ? ; END_PROGRAM",
        "Delete `?`",
        "x := TRUE  ;",
    ),
    (
        "st",
        "PROGRAM p\nVAR\n  x AT %QX1 : BOOL;\nEND_VAR\nx := button;\nEND_PROGRAM",
        "Declare `button` as BOOL",
        "  x AT %QX1 : BOOL;\n  button : BOOL;\nEND_VAR",
    ),
    (
        "iscl",
        "BLOCO\n  BOOL x AT %QX1;\n  x := ready;\nEND_BLOCK",
        "Declare `ready` as BOOL",
        "  BOOL ready;\n  x := ready",
    ),
    (
        "il",
        "VAR lamp AT %QX1 : BOOL; END_VAR\nLD I1\nJMPC next\nnest: ST lamp",
        "Write `nest`",
        "JMPC nest",
    ),
    ("il", "LD I1\nTON T1, 5s\nST Q1", "Write `T#5s`", "T1, T#5s"),
];

#[test]
fn a_remedy_mends() {
    for (end, wrong, title, right) in MENDED {
        let before = text(end, wrong);
        let all: Vec<_> = told(&before)
            .into_iter()
            .flat_map(|about| {
                let code = about.code;
                remedies(&before, &about, Lang::En)
                    .into_iter()
                    .map(move |remedy| (code, remedy))
            })
            .collect();
        let (code, remedy) = all
            .iter()
            .find(|(_, remedy)| remedy.title == title)
            .unwrap_or_else(|| panic!("{wrong}: {all:?}, {:?}", told(&before)));
        let after = edited(wrong, &remedy.edits);
        assert!(after.contains(right), "{after}");
        let left = told(&text(end, &after));
        assert!(
            left.iter().all(|about| about.code != *code),
            "{after}: {left:?}"
        );
    }
}
