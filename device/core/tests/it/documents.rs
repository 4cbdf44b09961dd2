//! The documents say what the code says.

use std::fs;
use std::path::Path;
use unoclp_core::isa::{Kind, Line, Row, TABLE, holds_point};
use unoclp_core::{Board, Cause, Fault, Loader};

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .ancestors()
        .nth(2)
        .unwrap()
}

fn document(name: &str) -> String {
    fs::read_to_string(root().join(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// The rows of the table between two marks, as their cells.
fn table(text: &str, name: &str) -> Vec<Vec<String>> {
    let begin = format!("<!-- {name}:begin -->");
    let end = format!("<!-- {name}:end -->");
    let (_, rest) = text.split_once(&begin).expect(&begin);
    let (table, _) = rest.split_once(&end).expect(&end);
    table
        .lines()
        .filter(|line| line.starts_with('|'))
        .skip(2)
        .map(|row| {
            let cells = row.trim_matches('|').split('|');
            cells.map(|cell| cell.trim().replace('`', "")).collect()
        })
        .collect()
}

#[test]
fn instruction_table() {
    let page = "docs/numeric-code.md";
    let text = document(page);
    let (_, rest) = text.split_once("<!-- isa:begin -->").expect(page);
    let (table, _) = rest.split_once("<!-- isa:end -->").expect(page);
    let written: Vec<&str> = table.lines().filter(|line| line.starts_with('|')).collect();
    let rows: Vec<String> = TABLE.iter().map(table_row).collect();
    for (row, written) in rows.iter().zip(written.iter().skip(2)) {
        assert_eq!(row, written, "{page}: this row is to be\n{row}");
    }
    let missing = rows.get(written.len() - 2..).unwrap_or_default();
    assert!(
        missing.is_empty(),
        "{page}: missing\n{}",
        missing.join("\n")
    );
    assert_eq!(written.len() - 2, rows.len(), "{page}: rows of nothing");
}

/// The row of the page's table that says this instruction.
fn table_row(row: &Row) -> String {
    let Row {
        letters, stored, ..
    } = row;
    let (mut code, mut xx) = (row.code.to_string(), "");
    if row.kind.has_number() {
        code.truncate(code.len() - 2);
        code += "XX";
        xx = " XX";
    }
    let (effect, bytes) = (row.effect, stored_bytes(row));
    format!("| `{code}` | {letters}{xx} | {effect} | `{stored:02X}` | {bytes} |")
}

/// How many bytes store an instruction of this row, as the table says it.
fn stored_bytes(row: &Row) -> String {
    let lines: &[Line] = match row.kind {
        Kind::Timer => &[Line::TimerPreset, Line::Target],
        Kind::Count => &[Line::CounterPreset],
        Kind::Move => &[Line::MoveTo, Line::Count],
        Kind::Scale => &[Line::FromLow, Line::FromHigh, Line::ToLow, Line::ToHigh],
        Kind::Filter => &[Line::FilterTime],
        Kind::Table => &[Line::Count],
        // The line of the file.
        Kind::Jump => return "4".to_owned(),
        Kind::Drum => return "3, plus 1 per step".to_owned(),
        Kind::Value => return "2, constant 3, 4 or 6".to_owned(),
        // A constant of REAL has 1 or 2 bytes only as 0 or the least numbers.
        Kind::Real => return "2, constant 3, 4 or 6".to_owned(),
        Kind::None | Kind::Input | Kind::Output | Kind::Branch | Kind::Marker => &[],
        Kind::System | Kind::TimerQ | Kind::Counter | Kind::Register | Kind::Analogue => &[],
        Kind::Pwm | Kind::Reading | Kind::Group | Kind::Bit | Kind::Time | Kind::Label => &[],
    };
    let number = row.kind.has_number() && !holds_point(row.stored);
    let lines: u8 = lines.iter().map(|line| line.bytes()).sum();
    (1 + u8::from(number) + lines).to_string()
}

#[test]
fn fault_table() {
    let expected: Vec<Vec<String>> = Cause::ALL
        .iter()
        .map(|cause| vec![cause.number().to_string(), cause.text().to_string()])
        .collect();
    assert_eq!(table(&document("docs/numeric-code.md"), "faults"), expected);
}

/// A page that explains the faults, and the words it does so with.
struct FaultPage {
    name: &'static str,
    what_to_do: &'static str,
    wrong: &'static str,
    right: &'static str,
    fault: &'static str,
    translated: bool,
}

const FAULT_PAGES: [FaultPage; 2] = [
    FaultPage {
        name: "docs/faults.md",
        what_to_do: "- **What to do:**",
        wrong: "wrong",
        right: "right",
        fault: "fault",
        translated: false,
    },
    FaultPage {
        name: "docs/faults.pt-BR.md",
        what_to_do: "- **O que fazer:**",
        wrong: "errado",
        right: "certo",
        fault: "falha",
        translated: true,
    },
];

/// The lines of a page's entry for each fault, without its heading. Checks on the way that the
/// headings are the numbers and texts of core's table, in order, each below its anchor.
fn fault_entries(page: &FaultPage) -> Vec<(Cause, Vec<String>)> {
    let text = document(page.name);
    let starting = |start: &str| -> Vec<&str> {
        let lines = text.lines();
        lines.filter(|line| line.starts_with(start)).collect()
    };
    let all = Cause::ALL.iter();
    let headings: Vec<String> = all
        .clone()
        .map(|cause| format!("## {} — {}", cause.number(), cause.text()))
        .collect();
    assert_eq!(starting("## "), headings, "{}", page.name);
    let anchors: Vec<String> = all
        .clone()
        .map(|cause| format!("<a id=\"{}\"></a>", cause.number()))
        .collect();
    assert_eq!(starting("<a "), anchors, "{}", page.name);

    let lines: Vec<&str> = text.lines().collect();
    let entries = lines.split(|line| line.starts_with("<a ")).skip(1);
    all.zip(entries)
        .map(|(&cause, entry)| {
            let [blank, heading, body @ ..] = entry else {
                panic!("{}: {cause:?} is empty", page.name);
            };
            assert_eq!(*blank, "", "{}: {cause:?}", page.name);
            assert!(heading.starts_with("## "), "{}: {cause:?}", page.name);
            (cause, body.iter().map(|line| line.to_string()).collect())
        })
        .collect()
}

#[test]
fn every_fault_is_explained() {
    for page in &FAULT_PAGES {
        for (cause, entry) in fault_entries(page) {
            let place = format!("{}: {}", page.name, cause.number());
            let what_to_do = entry
                .iter()
                .find_map(|line| line.strip_prefix(page.what_to_do))
                .unwrap_or_else(|| panic!("{place} does not say what to do"));
            assert!(what_to_do.contains(char::is_alphabetic), "{place}");

            // The translation of the text stands directly below the heading, in italics.
            let below = entry.get(1).map(String::as_str).unwrap_or_default();
            let italic = below.starts_with('*')
                && below.ends_with('*')
                && below.contains(char::is_alphabetic);
            assert_eq!(italic, page.translated, "{place}: {below}");

            let limit = match cause {
                Cause::ProgramFull => Board::UNO.stored_bytes,
                Cause::RunMemoryFull => Board::UNO.linked_bytes,
                _ => continue,
            };
            let says = entry.join(" ").contains(&format!(" {limit} bytes"));
            assert!(says, "{place} does not say {limit} bytes");
        }
    }
}

/// Of each example, the left column has the fault on just the lines that are marked with it, and
/// the right column is a program.
#[test]
fn examples_of_faults() {
    for page in &FAULT_PAGES {
        for (cause, entry) in fault_entries(page) {
            let number = cause.number();
            let place = format!("{}: {number}", page.name);
            let mut blocks = entry.split(|line| line == "```").skip(1);
            let Some([head, rows @ ..]) = blocks.next() else {
                // It cannot be seen in a line, takes a long file, or is no fault of a file.
                let hidden = matches!(cause, Cause::Utf16 | Cause::StrayCarriageReturn);
                assert!(hidden || number > 40, "{place} has no example");
                continue;
            };
            let width = head.find(page.right).unwrap_or_else(|| panic!("{place}"));
            assert_eq!(head[..width].trim(), page.wrong, "{place}");
            let wrong: Vec<String> = rows
                .iter()
                .map(|row| row.chars().take(width).collect::<String>())
                .collect();
            let right: Vec<String> = rows
                .iter()
                .map(|row| row.chars().skip(width).collect())
                .collect();

            let faults = faults_of(&wrong.join("\n"));
            assert_eq!(
                faults.first().map(|first| first.cause),
                Some(cause),
                "{place}"
            );
            let told: Vec<u32> = faults
                .iter()
                .filter(|fault| fault.cause == cause)
                .filter_map(|fault| fault.line)
                .collect();
            let mark = format!("{} {number}", page.fault);
            let marked: Vec<u32> = (1..)
                .zip(&wrong)
                .filter(|(_, line)| line.trim_end().ends_with(&mark))
                .map(|(line, _)| line)
                .collect();
            assert_eq!(told, marked, "{place}");
            assert_eq!(faults_of(&right.join("\n")), [], "{place}");
        }
    }
}

/// All the faults of a program that can be told.
fn faults_of(program: &str) -> Vec<Fault> {
    let mut memory = [0; Board::UNO.linked_bytes as usize];
    let mut loader = Loader::new(&mut memory, Board::UNO);
    let bytes = program.bytes();
    let mut faults: Vec<Fault> = bytes.filter_map(|byte| loader.push(byte).err()).collect();
    while let Err(fault) = loader.end() {
        faults.push(fault);
    }
    faults
}

/// The translated page has the same codes in the same order, each with its letters, its byte and how many bytes store it;
/// the same faults; and the same rulings.
#[test]
fn the_translation_has_the_same_rows() {
    let pages = ["docs/numeric-code.md", "docs/numeric-code.pt-BR.md"].map(document);
    let [english, portuguese] = pages.each_ref().map(|page| table(page, "isa"));
    assert_eq!(english.len(), portuguese.len());
    for (one, other) in english.iter().zip(&portuguese) {
        assert_eq!(
            [&one[0], &one[1], &one[3]],
            [&other[0], &other[1], &other[3]]
        );
        assert_eq!(digits(&one[4]), digits(&other[4]), "{}", one[0]);
    }
    let numbers = |page: &str| -> Vec<String> {
        let rows = table(page, "faults").into_iter();
        rows.map(|row| row[0].clone()).collect()
    };
    assert_eq!(numbers(&pages[0]), numbers(&pages[1]));
    let rulings = |page: &str| -> Vec<String> {
        let lines = page.lines().filter(|line| line.starts_with("- NC-"));
        lines
            .map(|line| line.split(' ').nth(1).unwrap_or_default().to_owned())
            .collect()
    };
    assert_eq!(rulings(&pages[0]), rulings(&pages[1]));
    assert_eq!(rulings(&pages[0]).len(), 30);
}

/// The numbers of a text, without its words.
fn digits(text: &str) -> Vec<String> {
    let numbers = text.split(|c: char| !c.is_ascii_digit());
    numbers
        .filter(|number| !number.is_empty())
        .map(str::to_owned)
        .collect()
}

#[test]
fn limits_of_the_uno() {
    let Board {
        inputs,
        outputs,
        stored_bytes,
        linked_bytes,
        ..
    } = Board::UNO;
    for name in [
        "README.md",
        "README.pt-BR.md",
        "docs/numeric-code.md",
        "docs/numeric-code.pt-BR.md",
    ] {
        let rows = table(&document(name), "profile");
        let numbers: Vec<&str> = rows.iter().map(|row| row[1].as_str()).collect();
        assert_eq!(
            numbers,
            [
                inputs.to_string(),
                outputs.to_string(),
                stored_bytes.to_string(),
                linked_bytes.to_string()
            ],
            "{name}"
        );
    }
}
