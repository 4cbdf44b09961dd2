//! Where the steps of a program stand in its text.

use unoclp_checked::{Place, SourceMap};
use unoclp_core::isa::Opcode;
use unoclp_lang::{TextLanguage, compile_text};

/// The map of a text that must be a program, and the opcodes of its steps.
fn map(text: &str) -> (SourceMap, Vec<Opcode>) {
    let compiled = compile_text(text, TextLanguage::Il, unoclp_core::Board::UNO);
    let (checked, map) = compiled
        .program
        .unwrap_or_else(|| panic!("{:#?}", compiled.diagnostics));
    let steps = checked.program().steps();
    let opcodes: Vec<Opcode> = steps.map(|step| step.opcode).collect();
    assert_eq!(opcodes.len(), map.steps.len());
    (map, opcodes)
}

const TEXT: &str = "\
(* A gate,
   and its lamp *) // all of it
PROGRAM gate
VAR
  open AT %IX1 : BOOL; (* the button *)
  lamp AT %QX1 : BOOL;
  left, right : Blink;
  delay : TON := T#5s;
END_VAR

(* Wait *)
LD open
(* a little *) (* or more *)
TON delay
ST lamp
(* Both blocks *)
CAL left(go := open)
\t CAL right(go := lamp)
END_PROGRAM

FUNCTION_BLOCK Blink
VAR_INPUT go : BOOL; END_VAR
VAR was : BOOL; END_VAR
// As it was
LD go
ST was
END_FUNCTION_BLOCK
";

#[test]
fn a_step_has_its_unit_line_column_comments_and_name() {
    let (map, opcodes) = map(TEXT);
    assert_eq!(map.title, ["A gate,", "and its lamp  all of it"]);
    let find = |line: usize| -> Vec<&Place> {
        let places = map.steps.iter();
        places.filter(|place| place.line == line).collect()
    };
    let [open] = find(12)[..] else {
        panic!("{map:#?}")
    };
    assert_eq!((open.column, open.last), (4, 12));
    assert_eq!(open.unit, None);
    assert_eq!(open.comments, ["Wait"]);
    assert_eq!(open.name.as_deref(), Some("open"));
    // Its preset and its output are lines of numeric code too.
    let [delay] = find(14)[..] else {
        panic!("{map:#?}")
    };
    assert_eq!(delay.codes, 3..=5);
    assert_eq!(delay.comments, ["a little  or more"]);
    assert_eq!(delay.name.as_deref(), Some("delay"));
    assert_eq!(map.of_code(5), Some(delay));
    assert_eq!(map.of_code(1), None, "program start is no step");
    assert_eq!(map.of_code(1_000), None);
    assert_eq!(find(17)[0].comments, ["Both blocks"]);
    // Parameters stand in the call, the body in its own unit, each time that it is called.
    assert!(find(18).iter().all(|place| place.unit.is_none()));
    let bodies = find(25);
    assert!(bodies.len() >= 2, "{map:#?}");
    let unit = |place: &&Place| place.unit.as_deref() == Some("Blink");
    assert!(bodies.iter().all(unit) && find(26).iter().all(unit));
    let comments: Vec<&String> = bodies.iter().flat_map(|place| &place.comments).collect();
    assert_eq!(comments, ["As it was"], "a comment is given once");
    assert_eq!(opcodes.iter().filter(|&&o| o == Opcode::OnDelay).count(), 1);
}

/// Columns count characters, tabs and accents among them; a mark at the head of the text is none.
#[test]
fn a_column_is_a_character() {
    let (map, _) = map("(* é *)\t LD I1\r\n  ST Q1");
    let places: Vec<_> = map.steps.iter().map(|p| (p.line, p.column)).collect();
    assert_eq!(places, [(1, 13), (2, 6)]);
}

/// What a later step of the program has to say does not take the comments of those before it in the text.
#[test]
fn a_body_that_stands_below_takes_no_comments_from_above() {
    let (map, _) = map(TEXT
        .replace(
            "CAL right(go := lamp)\n",
            "CAL right(go := lamp)\n// End\nLD lamp\nST %QX2\n",
        )
        .as_str());
    let end = map.steps.iter().find(|place| place.comments == ["End"]);
    assert_eq!(end.map(|place| place.line), Some(20), "{map:#?}");
}

/// What is kept stands where it is declared. The register that tells whether anything has been kept has no name.
#[test]
fn what_is_kept_stands_in_its_declaration() {
    let text = "(* Parts *)\nVAR RETAIN\n  parts : CTU;\n  total : INT := 100;\nEND_VAR\n\
        (* The counter *)\nCAL parts(CU:=I1, PV:=20, Q=>Q1)\nLD total\nADD 1\nST total\n";
    let (map, opcodes) = map(text);
    let step = |opcode, line, name: Option<&str>| {
        let steps = map.steps.iter().zip(&opcodes);
        let mut found = steps.filter(|(place, of)| place.line == line && **of == opcode);
        found.any(|(place, _)| place.name.as_deref() == name)
    };
    assert!(step(Opcode::KeepCounter, 3, None), "{map:#?}");
    assert!(step(Opcode::KeepRegister, 4, None), "{map:#?}");
    // Its first value is given to `total` and to nothing else.
    assert!(step(Opcode::Store, 4, Some("total")), "{map:#?}");
    assert!(step(Opcode::Store, 4, None), "{map:#?}");
    assert!(step(Opcode::Equal, 4, None), "{map:#?}");
    assert!(!step(Opcode::Equal, 4, Some("total")), "{map:#?}");
    let counter = map.steps.iter().find(|place| place.line == 7).unwrap();
    assert_eq!(counter.comments, ["The counter"]);
}
