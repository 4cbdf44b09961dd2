//! Programs take no more of the board than they did: bytes of program memory, and of run memory.
//!
//! A table has a row for each of them. Where it does not hold, the test writes the one that would.

use crate::board::large;
use crate::typed;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use unoclp_core::Board;
use unoclp_lang::{TextLanguage, compile_text};
use unoclp_testing::typed_program;

/// What a program takes.
type Bytes = (usize, usize);

/// None of what does not compile.
fn bytes(text: &str, language: TextLanguage, board: Board) -> Option<Bytes> {
    let (checked, _) = compile_text(text, language, board).program?;
    let program = checked.program();
    Some((program.stored_bytes(), program.linked_bytes()))
}

/// No program takes more than its row says. A few may have none, and a few rows may be of programs that have another name now.
fn hold(table: &str, programs: impl Iterator<Item = (String, Bytes)>) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests");
    let text = fs::read_to_string(path.join(table)).unwrap();
    let (head, rows) = text.split_once('\n').unwrap();
    let rows: BTreeMap<&str, Bytes> = rows.lines().map(row).collect();
    let programs: Vec<(String, Bytes)> = programs.collect();
    let held = programs.iter().filter_map(|(name, found)| {
        let most = rows.get(name.as_str())?;
        Some((name, found, most))
    });
    let held: Vec<_> = held.collect();
    let more = held
        .iter()
        .filter(|(_, found, most)| found.0 > most.0 || found.1 > most.1);
    let more = more.map(|(name, found, most)| format!("{name}: {found:?}, not {most:?}"));
    let wrong: Vec<String> = more.collect();
    let all = programs.len().max(rows.len());
    if !wrong.is_empty() || held.len() * 10 < all * 9 {
        let rows = programs
            .iter()
            .map(|(name, (stored, run))| format!("{stored} {run} {name}\n"));
        let written = Path::new(env!("CARGO_TARGET_TMPDIR")).join(table);
        fs::write(&written, format!("{head}\n{}", rows.collect::<String>())).unwrap();
        let written = written.display();
        panic!(
            "{} of {all} have a row; {written} holds\n{}",
            held.len(),
            wrong.join("\n")
        );
    }
}

fn row(row: &str) -> (&str, Bytes) {
    let mut words = row.splitn(3, ' ');
    let mut number = || words.next().and_then(|word| word.parse().ok()).expect(row);
    let bytes = (number(), number());
    (words.next().expect(row), bytes)
}

/// Each program in Instruction List.
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
        let bytes = bytes(&text, TextLanguage::Il, Board::UNO);
        let holds = bytes.is_some_and(|(stored, _)| stored <= least);
        (!holds).then(|| format!("{name} {bytes:?}, not {least}"))
    });
    assert_eq!(larger.collect::<Vec<_>>(), [""; 0]);
}

/// Each case of `typed/` that compiles for the board.
#[test]
fn no_case_takes_more_bytes() {
    let cases = typed::all().into_iter().filter_map(|(file, case)| {
        let (text, language) = case.text()?;
        let bytes = bytes(text, language, large())?;
        Some((format!("{file}: {}", case.name), bytes))
    });
    hold("sizes-cases.txt", cases);
}

/// Random programs in Structured Text, by their seeds.
#[test]
fn no_random_program_takes_more_bytes() {
    let programs = (1..=300).filter_map(|seed| {
        let text = typed_program(seed, 4 + seed as usize % 9);
        let bytes = bytes(&text, TextLanguage::St, large())?;
        Some((seed.to_string(), bytes))
    });
    hold("sizes-random.txt", programs);
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
