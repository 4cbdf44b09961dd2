//! The programs in Instruction List take no more of the board than they did.

use std::fs;
use std::path::Path;
use unoclp_lang::{TextLanguage, compile_text};

/// Each program with the bytes of program memory that it has come to take.
#[test]
fn no_program_takes_more_bytes() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let table = fs::read_to_string(root.join("tests/sizes.txt")).unwrap();
    let rows: Vec<(&str, usize)> = table
        .lines()
        .filter(|line| !line.starts_with('#'))
        .map(|line| line.rsplit_once(' ').unwrap())
        .map(|(name, bytes)| (name, bytes.parse().unwrap()))
        .collect();
    assert!(rows.len() >= 200, "{}", rows.len());
    let larger = rows.into_iter().filter_map(|(name, least)| {
        let text = fs::read_to_string(root.join("../../programs").join(name)).unwrap();
        let program = compile_text(&text, TextLanguage::Il, unoclp_core::Board::UNO).program;
        let bytes = program.map(|(checked, _)| checked.program().stored_bytes());
        let holds = bytes.is_some_and(|bytes| bytes <= least);
        (!holds).then(|| format!("{name} {bytes:?}, not {least}"))
    });
    assert_eq!(larger.collect::<Vec<_>>(), [""; 0]);
}

/// A call of a timer that the board calls again, beside one that it has already (NC-30).
#[test]
fn a_second_call_of_a_timer_takes_twelve_bytes_at_most() {
    let bytes = |calls: &str| {
        let text =
            format!("VAR t : TON; u : TOF; v : TP; x, y : BOOL; e : TIME; END_VAR\n{calls}\n");
        let program = compile_text(&text, TextLanguage::St, unoclp_core::Board::UNO).program;
        let (checked, _) = program.unwrap_or_else(|| panic!("{text}"));
        checked.program().stored_bytes()
    };
    let first = "t(IN := %IX1, PT := T#5s); %QX1 := t.Q;
        u(IN := %IX1, PT := T#5s); %QX2 := u.Q;
        v(IN := %IX1, PT := T#5s); %QX3 := v.Q; ";
    let one = bytes(first);
    for second in [
        "t(IN := %IX2, PT := T#5s); %QX4 := t.Q;",
        "t(IN := TRUE, PT := T#5s); x := t.Q; %QX4 := x;",
        "t(IN := FALSE, PT := T#1s);",
        "u(IN := %IX2 AND NOT %IX3, PT := T#5s);",
        "v(IN := %IX2, PT := T#5s); %QX4 := v.Q;",
    ] {
        let two = bytes(&format!("{first}{second}"));
        assert!(two <= one + 12, "{} bytes: {second}", two - one);
    }
}
