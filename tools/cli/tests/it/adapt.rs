//! `unoclp adapt`: points of another PLC get a place on this board.

use crate::common::{empty_folder, file, outcome, outcome_in};
use std::fs;

const OTHER: &str = "PROGRAM main\nVAR a AT %QX1.3 : BOOL; b AT %IX2.0 : BOOL; n AT %MW400 : INT; END_VAR\n\
                     IF b THEN n := n + 1; END_IF;\na := n > 3;\nEND_PROGRAM\n";

#[test]
fn a_text_of_another_plc_compiles_after_it() {
    let folder = empty_folder("adapt");
    let text = file("other.st", OTHER);
    assert_eq!(outcome(&["check", &text]).0, 1);
    let copy = folder.join("mine.st");
    let copy = copy.to_str().unwrap();
    let (code, out, err) = outcome(&["adapt", &text, "-o", copy]);
    assert_eq!((code, out.as_str()), (0, ""));
    assert_eq!(err, "%QX1.3 -> %QX0.0\n%IX2.0 -> %IX0.0\n%MW400 -> %MW1\n");
    assert_eq!(outcome(&["check", copy]).0, 0);
    // The text is as it was, and no copy is written over.
    assert_eq!(fs::read_to_string(&text).unwrap(), OTHER);
    for there in [copy, &text] {
        let (code, _, err) = outcome(&["adapt", &text, "-o", there]);
        assert!(code == 2 && err.contains("already exists"), "{err}");
    }
    let (code, out, _) = outcome(&["adapt", &text]);
    assert_eq!((code, out), (0, fs::read_to_string(copy).unwrap()));
}

#[test]
fn what_it_cannot_do_is_told() {
    let five: String = (0..5).map(|bit| format!("%QX1.{bit} := TRUE;\n")).collect();
    for (name, text, code, english, portuguese) in [
        (
            "five.st",
            five.as_str(),
            1,
            "the UNO has no free point for %QX1.4; they stay as they are",
            "o UNO não tem ponto livre para %QX1.4; eles ficam como estão",
        ),
        (
            "none.st",
            "%QX0.0 := %IX0.0;\n",
            0,
            "the UNO has all points of this text; no copy was written",
            "o UNO tem todos os pontos deste texto; nenhuma cópia foi gravada",
        ),
        (
            "codes.txt",
            "0\n827301\n877901\n",
            2,
            "is not Instruction List, Structured Text, SCL or PLCopen XML, which are the languages that adapt can change",
            "não é Lista de Instruções, Texto Estruturado, SCL nem PLCopen XML, que são as linguagens que adapt pode alterar",
        ),
        ("empty.st", "", 2, "is empty", "está vazio"),
    ] {
        let path = file(name, text);
        for (lang, words) in [("C", english), ("pt_BR.UTF-8", portuguese)] {
            let (found, _, err) = outcome_in(&["adapt", &path], lang);
            assert!(
                found == code && err.contains(words),
                "{name}: {found} {err}"
            );
        }
    }
}
