//! One mistake in a text of Structured Text is told in at most two places: each word of a right text is spoilt in turn.

use std::collections::BTreeSet;
use unoclp_lang::{Severity, TextLanguage, check};

static TEXT: &str = "\
TYPE
  Mode : (Off, Slow, Fast) := Slow;
  Limits : STRUCT low, high : INT := 5; END_STRUCT;
END_TYPE
FUNCTION Scale : REAL
VAR_INPUT raw : INT; gain : REAL := 1.5; END_VAR
Scale := raw * gain + 0.5;
END_FUNCTION
FUNCTION_BLOCK Valve
VAR_INPUT open : BOOL; END_VAR
VAR_OUTPUT moves : INT; END_VAR
VAR edge : R_TRIG; END_VAR
edge(CLK := open);
IF edge.Q THEN
  moves := moves + 1;
END_IF;
END_FUNCTION_BLOCK
PROGRAM main
VAR
  start AT %IX1 : BOOL;
  lamp AT %QX1 : BOOL;
  wait : TON := (PT := T#2s);
  list : ARRAY[1..4] OF INT := [1, 2(3), 4];
  bounds : Limits;
  mode : Mode;
  valve : Valve;
  i, n : INT;
  r : REAL;
END_VAR
wait(IN := start AND NOT lamp, Q => lamp);
FOR i := 1 TO 4 DO
  n := n + list[i] * 2;
END_FOR;
CASE mode OF
  Off: n := 0;
  Slow, Fast: n := n - bounds.low;
ELSE
  n := 1;
END_CASE;
WHILE n > 100 DO
  n := n / 2;
END_WHILE;
valve(open := n = 7);
r := Scale(raw := n, gain := 2.0) + INT_TO_REAL(valve.moves);
IF r > 10.0 OR start THEN
  mode := Mode#Fast;
ELSIF lamp THEN
  mode := Off;
END_IF;
END_PROGRAM
";

#[test]
fn one_mistake_is_told_at_most_twice() {
    assert_eq!(
        check(TEXT, TextLanguage::St, unoclp_core::Board::UNO)
            .diagnostics
            .listed,
        []
    );
    let words: Vec<(usize, &str)> = TEXT
        .split([' ', '\n'])
        .map(|word| (word.as_ptr() as usize - TEXT.as_ptr() as usize, word))
        .filter(|(_, word)| !word.is_empty())
        .collect();
    let (mut cascades, mut silent, mut all) = (BTreeSet::new(), 0, 0);
    for (at, word) in words {
        let (before, behind) = (&TEXT[..at], &TEXT[at + word.len()..]);
        let plain = word.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
        let slip: String = match plain {
            true => word.chars().rev().collect(),
            false => word.chars().skip(1).collect(),
        };
        let doubled = format!("{word} {word}");
        for wrong in [
            "",
            "?",
            "Zz9",
            &slip,
            &doubled,
            word.trim_end_matches([';', ',', ')']),
        ] {
            let text = format!("{before}{wrong}{behind}");
            let told = check(&text, TextLanguage::St, unoclp_core::Board::UNO).diagnostics;
            let errors = told.iter().filter(|d| d.severity() == Severity::Error);
            all += 1;
            silent += usize::from(errors.clone().count() == 0);
            if errors.clone().count() > 2 {
                let line = before.lines().count();
                let codes: Vec<String> = errors.map(|d| d.code.to_string()).collect();
                cascades.insert((line, format!("{word:?} as {wrong:?}: {codes:?}")));
            }
        }
    }
    assert!(silent < all / 3, "{silent} of {all}");
    assert!(
        cascades.is_empty(),
        "{} of {all}: {cascades:#?}",
        cascades.len()
    );
}
