//! What a text can have much of: errors are counted, functions are not mistaken for one another.

use std::collections::BTreeSet;
use unoclp_lang::{Code, Lang, Severity, TextLanguage, compile_text, show};

#[test]
fn errors_beyond_a_hundred_are_only_counted() {
    let text = "LD I9\nST Q1\n".repeat(11_666);
    let compiled = compile_text(&text, TextLanguage::Il, unoclp_core::Board::UNO);
    let errors = compiled.diagnostics.iter();
    let errors = errors.filter(|d| d.severity() == Severity::Error);
    assert_eq!(errors.count(), 100);
    // The other errors, and warnings that Q1 is written again.
    assert_eq!(
        compiled.diagnostics.len() + compiled.diagnostics.more,
        11_666 + 11_665
    );
    let renderer = annotate_snippets::Renderer::plain();
    for (lang, last) in [(Lang::En, "… and 23311 more"), (Lang::Pt, "… e mais 23311")] {
        let shown = show("x.il", &text, &compiled.diagnostics, lang, &renderer);
        assert_eq!(shown.lines().last(), Some(last));
        assert!(shown.lines().count() < 200, "{}", shown.lines().count());
    }
}

/// Where not all is shown, errors are.
#[test]
fn warnings_hide_no_error() {
    let text = format!("{}LD I9\nST Q2\n", "LD I1\nST Q1\n".repeat(200));
    let compiled = compile_text(&text, TextLanguage::Il, unoclp_core::Board::UNO);
    let renderer = annotate_snippets::Renderer::plain();
    let shown = show("x.il", &text, &compiled.diagnostics, Lang::En, &renderer);
    assert!(
        shown.contains("there is no point `I9` on this board"),
        "{shown}"
    );
}

/// As many functions as a library has: those that are not called take nothing from the board.
#[test]
fn many_functions() {
    let function = |n: usize| {
        format!("FUNCTION f{n} : BOOL\nVAR_INPUT a : BOOL; END_VAR\nLD a\nST f{n}\nEND_FUNCTION\n")
    };
    let functions: String = (0..1_000).map(function).collect();
    let text = format!("LD I1\nf7\nST Q1\nCAL f900 (a:=I2)\nST Q2\n{functions}");
    let compiled = compile_text(&text, TextLanguage::Il, unoclp_core::Board::UNO);
    assert_eq!(*compiled.diagnostics.listed, []);
}

/// One mistake is told in at most two places: each word of a text that is right is spoilt in turn.
#[test]
fn one_mistake_is_told_at_most_twice() {
    let text = "\
VAR
  start AT %IX1 : BOOL;
  stop AT %IX2 : BOOL;
  motor AT %QX1 : BOOL;
  lamp AT %QX2 : BOOL;
  wait : TON := T#2s;
  parts : CTU := (PV := 5);
  n : INT := 7;
  x : Latch;
END_VAR
LD start
OR motor
ANDN stop
ST motor
CAL wait (IN:=motor)
LD wait.Q
AND( n
GT 5
)
ST lamp
LD motor
JMPCN rest
CAL x (on:=start, off:=stop)
rest: LD x.state
S Q3
LD start
Both stop
R Q3
CAL parts (CU:=start, R:=stop)
LD parts.CV
ADD n
ST n
FUNCTION Both : BOOL
VAR_INPUT
  a : BOOL;
  b : BOOL;
END_VAR
LD a
AND b
ST Both
END_FUNCTION
FUNCTION_BLOCK Latch
VAR_INPUT on, off : BOOL; END_VAR
VAR_OUTPUT state : BOOL; END_VAR
LD on
S state
LD off
R state
END_FUNCTION_BLOCK
";
    assert_eq!(
        compile_text(text, TextLanguage::Il, unoclp_core::Board::UNO)
            .diagnostics
            .listed,
        []
    );
    let words: Vec<(usize, &str)> = text
        .split([' ', '\n'])
        .map(|word| (word.as_ptr() as usize - text.as_ptr() as usize, word))
        .filter(|(_, word)| !word.is_empty())
        .collect();
    let mut cascades = BTreeSet::new();
    for (at, word) in words {
        let (before, behind) = (&text[..at], &text[at + word.len()..]);
        let plain = word.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
        let slip: String = match plain {
            true => word.chars().rev().collect(),
            false => word.chars().skip(1).collect(),
        };
        for wrong in ["", "?", "Zz9", &slip, &format!("{word} {word}")] {
            let text = format!("{before}{wrong}{behind}");
            let told = compile_text(&text, TextLanguage::Il, unoclp_core::Board::UNO).diagnostics;
            let errors = told.iter().filter(|d| d.severity() == Severity::Error);
            if errors.clone().count() > 2 {
                let line = before.lines().count();
                let codes: Vec<String> = errors.map(|d| d.code.to_string()).collect();
                cascades.insert((line, format!("{word:?} as {wrong:?}: {codes:?}")));
            }
        }
    }
    assert!(cascades.is_empty(), "{}: {cascades:#?}", cascades.len());
}

#[test]
fn parentheses_too_deep_are_one_error() {
    let text = format!(
        "LD I1\n{}{}ST Q1\n",
        "AND( I2\n".repeat(5_000),
        ")\n".repeat(5_000)
    );
    let told = compile_text(&text, TextLanguage::Il, unoclp_core::Board::UNO).diagnostics;
    let codes: Vec<Code> = told.iter().map(|d| d.code).collect();
    assert_eq!(codes, [Code::TooDeep]);
}

/// Blocks, each of which holds an instance of the one before it.
#[test]
fn blocks_that_hold_blocks_are_told_where_they_are_too_many() {
    // A block that is lent one of another does not hold it.
    let told = |count: usize, section: &str| {
        let blocks = (0..count).map(|at| match at.checked_sub(1) {
            None => "FUNCTION_BLOCK B0 VAR q : BOOL; END_VAR q := TRUE; END_FUNCTION_BLOCK\n".into(),
            Some(of) => format!(
                "FUNCTION_BLOCK B{at} {section} b : B{of}; END_VAR VAR q : BOOL; END_VAR q := TRUE; END_FUNCTION_BLOCK\n"
            ),
        });
        let blocks: String = blocks.collect();
        let last = count - 1;
        let text = format!(
            "{blocks}PROGRAM main VAR all : B{last}; q : BOOL; END_VAR q := TRUE; END_PROGRAM\n"
        );
        let came = compile_text(&text, TextLanguage::St, unoclp_core::Board::PC);
        let codes: Vec<Code> = came.diagnostics.iter().map(|d| d.code).collect();
        codes
    };
    assert_eq!(told(40, "VAR"), []);
    assert_eq!(told(41, "VAR"), [Code::StTooDeep]);
    assert_eq!(told(60, "VAR_IN_OUT"), []);
}
