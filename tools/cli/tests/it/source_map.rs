//! Where the steps of programs stand: held against the text itself, for every program of the repository.

use std::fs;
use std::path::{Path, PathBuf};
use unoclp_checked::Place;
use unoclp_core::Board;
use unoclp_host_sim::random::{Random, random_program};
use unoclp_program::{Source, Written};
use unoclp_testing::held;

fn check(name: &str, text: &[u8]) -> Source {
    let on = |board| Written::new(name.to_owned(), text.into(), board).check(None);
    // Some are for the points of a Mega.
    let source = on(Board::UNO).or_else(|_| on(Board::MEGA));
    source.unwrap_or_else(|refused| panic!("{name}: {refused:?}"))
}

/// The programs of a folder that end so, and its folders'.
fn programs(folder: &str, extension: &str) -> Vec<PathBuf> {
    let mut folders = vec![Path::new(env!("CARGO_MANIFEST_DIR")).join(folder)];
    let mut programs = Vec::new();
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let is_program = path.extension().is_some_and(|end| end == extension);
            if path.is_dir() {
                folders.push(path);
            } else if is_program && path.file_name().is_some_and(|name| name != "STATE.TXT") {
                programs.push(path);
            }
        }
    }
    programs.sort();
    programs
}

/// The text from the place on, to the end of its line.
fn text_at<'t>(lines: &[&'t str], place: &Place) -> &'t str {
    let line = lines[place.line - 1];
    let (byte, _) = line.char_indices().nth(place.column - 1).unwrap();
    &line[byte..]
}

/// The code that a line of numeric code begins with.
fn code(line: &str) -> i32 {
    let end = line.find(|c: char| c != '-' && !c.is_ascii_digit());
    line[..end.unwrap_or(line.len())].parse().unwrap()
}

fn assert_numeric(name: &str, file: &[u8]) {
    let source = check(name, file);
    let text = source.text.trim_start_matches('\u{FEFF}');
    let lines: Vec<&str> = text.split('\n').collect();
    let mut behind = 0;
    assert_eq!(source.map.steps.len(), source.program().steps().count());
    for (step, place) in source.program().steps().zip(&source.map.steps) {
        let codes: Vec<i32> = step.codes().collect();
        assert_eq!(code(text_at(&lines, place)), codes[0], "{name}: {place:?}");
        let last = lines[place.last - 1].trim_start();
        assert_eq!(Some(&code(last)), codes.last(), "{name}: {place:?}");
        // Between its first line and its last stand its codes, and nothing else that is a code.
        let own = lines[place.line - 1..place.last].iter();
        let own = own.filter(|line| !line.split('/').next().unwrap_or_default().trim().is_empty());
        assert_eq!(own.count(), codes.len(), "{name}: {place:?}");
        assert_eq!(place.codes, place.line as u32..=place.last as u32);
        assert!(place.line > behind, "{name}: {place:?}");
        behind = place.last;
        for comment in place.comments.iter().filter(|comment| !comment.is_empty()) {
            assert!(text.contains(comment.as_str()), "{name}: {comment}");
        }
    }
}

#[test]
fn each_step_of_numeric_code_stands_at_its_code() {
    let programs = programs("../../programs", "txt");
    assert!(programs.len() > 30, "{}", programs.len());
    for path in programs {
        assert_numeric(&path.display().to_string(), &fs::read(&path).unwrap());
    }
    // Written in all the ways that numeric code may be: blanks, comments, marks, line ends.
    let run = |seed: u64| {
        let file = random_program(&mut Random::new(seed));
        assert_numeric(&format!("program {seed}.txt"), file.as_bytes());
    };
    (0..300).for_each(|seed| held(|| run(seed)));
}

/// The faults of a running program name lines of numeric code: each of them leads to the step that has
/// become it, and the compiler's own comments say where that stands.
#[test]
fn each_step_of_instruction_list_stands_at_its_instruction() {
    let programs = programs("../../programs", "il");
    assert!(programs.len() > 30, "{}", programs.len());
    let (mut symbols, mut names) = (0, 0);
    for path in programs {
        let name = path.display().to_string();
        let source = check(&name, &fs::read(&path).unwrap());
        let has_types = !source.variables.is_empty();
        let lines: Vec<&str> = source.text.lines().collect();
        let code_lines: Vec<&str> = str::from_utf8(&source.code).unwrap().lines().collect();
        let mut next = 2;
        for (step, place) in source.program().steps().zip(&source.map.steps) {
            let codes: Vec<i32> = step.codes().collect();
            assert_eq!(*place.codes.start(), next, "{name}: {place:?}");
            next = place.codes.end() + 1;
            for (line, expected) in place.codes.clone().zip(&codes) {
                let line_of_code = code_lines[line as usize - 1];
                assert_eq!(code(line_of_code), *expected, "{name}: {place:?}");
                assert_eq!(source.map.of_code(line), Some(place));
            }
            assert_eq!(
                place.codes.clone().count(),
                codes.len(),
                "{name}: {place:?}"
            );

            // A word begins there.
            let at = text_at(&lines, place);
            let line = lines[place.line - 1];
            let before = line[..line.len() - at.len()].chars().next_back();
            let of_word = |c: char| c.is_alphanumeric() || matches!(c, '_' | '%');
            assert!(before.is_none_or(|c| !of_word(c)), "{name}: {place:?}");
            assert!(!at.starts_with(char::is_whitespace), "{name}: {place:?}");
            // The name of its point stands in it; where lines became one expression, in one of them.
            if let Some(point) = &place.name {
                let stands = match has_types {
                    true => names_of(point).any(|name| source.text.contains(name)),
                    false => at.contains(point.as_str()),
                };
                assert!(stands, "{name}: {place:?}: {at}");
                names += 1;
            }
            // The comment after a code tells its words and its line.
            let comment = code_lines[*place.codes.start() as usize - 1];
            if let Some((_, line)) = comment.rsplit_once("line ") {
                assert_eq!(line.parse(), Ok(place.line), "{name}: {comment}");
            }
            if let Some(symbol) = comment.split_once('/').and_then(|(_, said)| symbol(said)) {
                let stands = match has_types {
                    true => names_of(symbol).any(|name| source.text.contains(name)),
                    false => at.starts_with(symbol),
                };
                assert!(stands, "{name}: {comment}: {at}");
                symbols += 1;
            }
        }
        assert_eq!(next as usize, code_lines.len() + 1, "{name}");
    }
    assert!(symbols > 300 && names > 50, "{symbols} {names}");
}

/// A name, and that of the block or array which it belongs to: a call names the block alone, a computed subscript the array.
fn names_of(name: &str) -> impl Iterator<Item = &str> {
    [Some(name), name.split(['.', '[']).next()]
        .into_iter()
        .flatten()
}

/// The words of the text in a comment such as ` RI 01   start, line 3`.
fn symbol(said: &str) -> Option<&str> {
    let words = said.get(10..)?.trim();
    let words = match words.rsplit_once("line ") {
        Some((words, _)) => words.trim_end().trim_end_matches(','),
        None => words,
    };
    (!words.is_empty()).then_some(words)
}

/// A line more above each line, and a blank before it: every step goes down and to the right with its line,
/// and the first step of a line takes the comment above.
#[test]
fn places_move_with_the_text() {
    let (mut texts, mut comments) = (0, 0);
    for path in programs("../../programs", "il") {
        let name = path.display().to_string();
        let text = fs::read_to_string(&path).unwrap();
        // A comment of more lines cannot have another within.
        if text.matches("(*").count() != text.lines().filter(|line| line.contains("*)")).count() {
            continue;
        }
        let moved: Vec<String> = (1..)
            .zip(text.lines())
            .map(|(number, line)| format!("// line {number}\n  {line}\n"))
            .collect();
        let (before, behind) = (
            check(&name, text.as_bytes()),
            check(&name, moved.concat().as_bytes()),
        );
        assert_eq!(before.program().stored(), behind.program().stored());
        for (before, behind) in before.map.steps.iter().zip(&behind.map.steps) {
            assert_eq!(behind.line, before.line * 2, "{name}");
            assert_eq!(behind.column, before.column + 2, "{name}");
            assert_eq!((&behind.unit, &behind.name), (&before.unit, &before.name));
        }
        texts += 1;
        let mut told = Vec::new();
        for place in &behind.map.steps {
            let own = format!("line {}", place.line / 2);
            // First values stand where they are declared, and come in an order of their own.
            let mut before_it = text.lines().take(place.line / 2 - 1);
            let is_declared = !before_it.any(|line| line.trim() == "END_VAR")
                && text.lines().any(|line| line.trim() == "END_VAR");
            if is_declared && place.comments.is_empty() {
                continue;
            }
            if place.line / 2 > before.map.title.len() + 1 && !told.contains(&place.line) {
                assert_eq!(place.comments.last(), Some(&own), "{name}: {place:?}");
                comments += 1;
            } else if told.contains(&place.line) {
                assert_eq!(place.comments, [""; 0], "{name}: {place:?}");
            }
            told.push(place.line);
        }
    }
    assert!(texts > 25 && comments > 200, "{texts} {comments}");
}

/// The steps of a typed text stand in its lines, with the names, comments and units that it gives them.
#[test]
fn each_step_of_a_typed_text_stands_at_its_statement() {
    let text = "\
// The whole.
FUNCTION_BLOCK Valve
VAR_INPUT open : BOOL; END_VAR
VAR_OUTPUT moved : INT; END_VAR
VAR edge : R_TRIG; END_VAR
(* how often it opens *)
edge(CLK := open);
IF edge.Q THEN moved := moved + 1; END_IF;
END_FUNCTION_BLOCK

PROGRAM main
VAR go AT %IX1 : BOOL; lamp AT %QX1 : BOOL; v : Valve; n : INT := 5; END_VAR
/* the valve */
v(open := go);
lamp := n > 3; // no line of its own
END_PROGRAM
";
    let source = check("valve.st", text.as_bytes());
    assert_eq!(source.map.title, ["The whole."]);
    let lines: Vec<&str> = text.lines().collect();
    let mut seen = Vec::new();
    for place in &source.map.steps {
        let in_valve = (6..=9).contains(&place.line);
        let unit = place.unit.as_deref();
        assert_eq!(unit, in_valve.then_some("Valve"), "{place:?}");
        text_at(&lines, place);
        seen.extend(place.name.as_deref());
    }
    for name in ["go", "v.open", "v.moved", "v.edge.Q", "n", "lamp"] {
        assert!(seen.contains(&name), "{name}: {seen:?}");
    }
    let comments = |line: usize| -> Vec<&str> {
        let places = source.map.steps.iter().filter(|place| place.line == line);
        places
            .flat_map(|place| &place.comments)
            .map(String::as_str)
            .collect()
    };
    assert_eq!(comments(14), ["the valve"]);
    assert_eq!(comments(7), ["how often it opens"]);
    // A first value stands where it is declared.
    assert_eq!(source.map.steps[0].line, 12);
}

/// A fault of a running program leads to the statement.
#[test]
fn a_line_of_code_leads_to_its_statement_in_every_typed_language() {
    for (name, text, line) in [
        ("loop.st", "VAR n : INT; END_VAR\n\nn := n + 1;\n", 3),
        ("loop.iscl", "BLOCO\nINT n;\nn := n + 1;\nEND_BLOCK\n", 3),
        ("loop.lce", "// a\n\nV0 := V0 + 1;\n", 3),
    ] {
        let source = check(name, text.as_bytes());
        let codes = source.code.iter().filter(|&&byte| byte == b'\n').count() as u32;
        for code in 2..=codes {
            let (at, statement) = source.line_of(code).unwrap();
            assert_eq!(at, line, "{name}");
            assert!(statement.ends_with("+ 1;"), "{statement}");
        }
    }
}
