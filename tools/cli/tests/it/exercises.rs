//! Exercises: their cases run by `unoclp sim`, what it draws of them, and a class that `unoclp grade` grades.

use crate::common::{empty_folder, outcome, outcome_in};
use std::fs;
use std::path::{Path, PathBuf};

/// A lamp that follows its button, and a lamp that remembers.
const EXERCISE: &str = r#"
title = { en = "A lamp with memory", pt = "Uma lâmpada com memória" }
task = { en = "I1 lights Q1, I2 puts it out.", pt = "I1 acende Q1, I2 apaga." }
names = { I1 = { en = "on <1>", pt = "liga" }, Q1 = { en = "lamp", pt = "lâmpada" } }
scan_ms = 10
within_ms = 20
[[case]]
title = { en = "On", pt = "Liga" }
step = [
  { at = 0, expect = { Q1 = 0 } },
  { at = 100, set = { I1 = 1 }, expect = { Q1 = 1 } },
]
[[case]]
title = { en = "It stays", pt = "Continua" }
hidden = true
step = [
  { at = 0, set = { I1 = 1 } },
  { at = 100, set = { I1 = 0 }, expect = { Q1 = 1 } },
]
until = 300
"#;
const FOLLOWS: &str = "LD I1\nST Q1\n";
const REMEMBERS: &str = "LD I1\nOR Q1\nANDN I2\nST Q1\n";

/// A folder with the exercise in it.
fn folder(name: &str) -> PathBuf {
    let folder = empty_folder(name);
    fs::write(folder.join("lamp.toml"), EXERCISE).unwrap();
    folder
}

/// A file in a folder, by its path.
fn put(folder: &Path, name: &str, text: impl AsRef<[u8]>) -> String {
    let path = folder.join(name);
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    fs::write(&path, text).unwrap();
    path.to_str().unwrap().to_owned()
}

#[test]
fn sim_runs_all_cases_or_one() {
    let folder = folder("exercise-sim");
    let exercise = put(&folder, "lamp.toml", EXERCISE);
    let follows = put(&folder, "follows.il", FOLLOWS);
    let (code, out, _) = outcome(&["sim", &follows, "--scenario", &exercise]);
    assert_eq!(code, 1);
    let [first, second] = ["lamp.toml: On\n", "lamp.toml: It stays\n"].map(|title| out.find(title));
    assert!(first < second && first.is_some(), "{out}");
    assert!(out.contains("PASS") && out.contains("FAIL"), "{out}");
    let case = |number: &str| {
        let (code, out, err) =
            outcome(&["sim", &follows, "--scenario", &exercise, "--case", number]);
        (code, out + &err)
    };
    assert_eq!(case("1").0, 0);
    assert_eq!(case("2").0, 1);
    let (code, told) = case("3");
    assert!(code == 2 && told.contains("there is no case 3"), "{told}");
    let trace = folder.join("out.vcd");
    let trace = ["--vcd", trace.to_str().unwrap()];
    let (code, _, err) =
        outcome(&[&["sim", &follows, "--scenario", &exercise], &trace[..]].concat());
    assert!(code == 2 && err.contains("--case"), "{err}");
}

#[test]
fn sim_draws_what_was_pressed_expected_and_came() {
    let folder = folder("exercise-svg");
    let exercise = put(&folder, "lamp.toml", EXERCISE);
    let drawing = folder.join("out.svg");
    for (program, passes) in [(FOLLOWS, false), (REMEMBERS, true)] {
        let program = put(&folder, "program.il", program);
        let drawing = drawing.to_str().unwrap();
        let (code, _, err) = outcome(&["sim", &program, "--scenario", &exercise, "--svg", drawing]);
        assert_eq!(code, i32::from(!passes), "{err}");
        let svg = fs::read_to_string(drawing).unwrap();
        for text in [
            "I1 on &lt;1&gt;",
            "Q1 lamp",
            "expected",
            "actual",
            "It stays",
        ] {
            assert!(svg.contains(text), "{text} in {svg}");
        }
        let why = "FAIL: Q1 at 120 ms: expected 1, got 0";
        assert_eq!(svg.contains(why), !passes, "{svg}");
    }
}

/// What a class hands in: two that pass, and one of each thing that can be wrong.
fn class(folder: &Path) -> PathBuf {
    let class = folder.join("class");
    put(&class, "ana/lamp.il", REMEMBERS);
    put(
        &class,
        "bia/lamp.st",
        "PROGRAM p\nVAR\n a AT %IX1 : BOOL;\n b AT %IX2 : BOOL;\n q AT %QX1 : BOOL;\nEND_VAR\nq := (a OR q) AND NOT b;\nEND_PROGRAM\n",
    );
    put(&class, "bits.il", [0_u8, 159, 255]);
    put(&class, "empty.txt", "");
    put(&class, "follows, only.il", FOLLOWS);
    put(&class, "large.il", "LD I1\nST M1\n".repeat(2_000));
    put(
        &class,
        "loops.st",
        "PROGRAM p\nVAR\n i : INT;\nEND_VAR\nWHILE TRUE DO\n i := 1;\nEND_WHILE;\nEND_PROGRAM\n",
    );
    put(&class, "notes.pdf", "no program");
    put(&class, "point.il", "LD I9\nST Q1\n");
    put(&class, "zero.txt", "0\n827309\n");
    class
}

#[test]
fn a_class_is_graded_in_the_dialect_that_is_said() {
    let folder = folder("exercise-dialect");
    let exercise = put(&folder, "lamp.toml", EXERCISE);
    let program = put(&folder, "ana.il", "LD X0\nOR Y0\nANI X1\nOUT Y0\n");
    let (code, out, err) = outcome(&["grade", &exercise, &program]);
    assert_eq!(code, 0, "{out}{err}");
    // In IEC's words X0 is no input.
    for (dialect, is_passed) in [("mitsubishi", true), ("iec", false)] {
        let (code, out, _) = outcome(&["grade", &exercise, &program, "--dialect", dialect]);
        assert_eq!(code == 0, is_passed, "{dialect}: {out}");
    }
}

#[test]
fn a_class_is_graded_and_what_is_wrong_is_a_row() {
    let folder = folder("grade-class");
    let exercise = folder.join("lamp.toml");
    let class = class(&folder);
    let (exercise, class) = (exercise.to_str().unwrap(), class.to_str().unwrap());
    let (code, out, err) = outcome(&["grade", exercise, class]);
    assert_eq!(code, 1, "{err}");
    let rows: Vec<&str> = out.lines().collect();
    #[rustfmt::skip]
    let due = [
        ("file", "first failing case"),
        ("ana/lamp.il", "2/2    passed"),
        ("bia/lamp.st", "2/2    passed"),
        ("bits.il", "0/2    does not compile: the file is binary, not text"),
        ("empty.txt", "0/2    does not compile: the file is empty"),
        ("follows, only.il", "1/2    It stays: Q1 at 120 ms: expected 1, got 0 (until 300 ms)"),
        ("large.il", "0/2    does not compile: line "),
        ("loops.st", "0/2    On: line 5: fault 75: too many backward jumps in one scan (NC-19)"),
        ("point.il", "0/2    does not compile: line 1: there is no point `I9` on this board"),
        ("zero.txt", "0/2    does not compile: line 2: this board has no such input"),
        ("A lamp with memory: 2 of 9 passed", ""),
    ];
    assert_eq!(rows.len(), due.len(), "{out}");
    for (row, (file, told)) in rows.iter().zip(due) {
        assert!(row.contains(file) && row.contains(told), "{row}");
    }
    assert!(err.contains("notes.pdf"), "{err}");

    let both = ["ana/lamp.il", "bia/lamp.st"].map(|file| format!("{class}/{file}"));
    let (code, _, err) = outcome(&["grade", exercise, &both[0], &both[1]]);
    assert_eq!((code, err.as_str()), (0, ""));
}

#[test]
fn a_spreadsheet_has_its_columns_and_a_name_may_hold_a_comma() {
    let folder = folder("grade-csv");
    let exercise = folder.join("lamp.toml");
    let class = class(&folder);
    let (exercise, class) = (exercise.to_str().unwrap(), class.to_str().unwrap());
    let (code, out, _) = outcome(&["grade", exercise, class, "--csv"]);
    assert_eq!(code, 1);
    let rows: Vec<&str> = out.lines().collect();
    assert_eq!(
        rows[0],
        "file,exercise,passed,cases passed,cases,first failing case"
    );
    assert_eq!(rows[1], format!("{class}/ana/lamp.il,{exercise},yes,2,2,"));
    assert_eq!(
        rows[5],
        format!("\"{class}/follows, only.il\",{exercise},no,1,2,It stays")
    );
    assert_eq!(rows.len(), 10);
}

/// A case that is hidden from students is not hidden from their teacher.
#[test]
fn a_page_shows_each_first_failing_case() {
    let folder = folder("grade-html");
    let exercise = folder.join("lamp.toml");
    let class = class(&folder);
    put(&class, "a&b.il", FOLLOWS);
    let page = folder.join("class.html");
    let arguments = [&exercise, &class, &page].map(|path| path.to_str().unwrap());
    let [exercise, class, page] = arguments;
    let (code, _, err) = outcome(&["grade", exercise, class, "--html", page]);
    assert_eq!(code, 1, "{err}");
    let text = fs::read_to_string(page).unwrap();
    let ladders = text.matches("<figure class=\"ladder\">").count();
    assert_eq!(ladders, 3, "those in Instruction List that ran");
    let diagrams = text.matches("<svg").count() - ladders;
    assert_eq!(diagrams, 3, "those that ran and failed");
    assert!(text.contains("It stays") && text.contains("expected"));
    assert!(text.contains("there is no point `I9` on this board"));
    assert!(text.contains("a&amp;b.il") && !text.contains("a&b.il"));
    let links = text.matches("http").count();
    assert_eq!(links, text.matches("http://www.w3.org/2000/svg").count());
    // Written again, and nothing else overwritten.
    assert_eq!(outcome(&["grade", exercise, class, "--html", page]).0, 1);
    let (code, out, err) = outcome(&["grade", exercise, class, "--html", exercise]);
    assert_eq!((code, out.as_str()), (2, ""), "{err}");
    assert_eq!(fs::read_to_string(exercise).unwrap(), EXERCISE);
}

#[test]
fn wrong_arguments_are_told_in_both_languages() {
    let folder = folder("grade-wrong");
    let exercise = put(&folder, "lamp.toml", EXERCISE);
    let program = put(&folder, "lamp.il", REMEMBERS);
    let empty = folder.join("empty");
    fs::create_dir(&empty).unwrap();
    let empty = empty.to_str().unwrap();
    #[rustfmt::skip]
    let cases: [(&[&str], &str, &str); 6] = [
        (&["grade"], "required", "falta indicar"),
        (&["grade", &exercise], "required", "falta indicar"),
        (&["grade", "no.toml", &program], "no.toml: the file cannot be read", "no.toml: o arquivo não pode ser lido"),
        (&["grade", &program, &program], "lamp.il:1: ", "lamp.il:1: isto não é TOML válido"),
        (&["grade", &exercise, "no.il"], "no.il cannot be read", "não foi possível ler no.il"),
        (&["grade", &exercise, empty], "contains no program", "não tem nenhum programa"),
    ];
    for (arguments, en, pt) in cases {
        for (lang, told) in [("en_US.UTF-8", en), ("pt_BR.UTF-8", pt)] {
            let (code, out, err) = outcome_in(arguments, lang);
            assert_eq!((code, out.as_str()), (2, ""), "{arguments:?}");
            assert!(err.contains(told), "{arguments:?}: {err}");
        }
    }
}

/// The file that the pages show is right, the same in both, and they count the exercises.
#[test]
fn the_pages_show_an_exercise_that_works() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let files = fs::read_dir(root.join("programs/exercises")).unwrap();
    let names = files.map(|file| file.unwrap().file_name().into_string().unwrap());
    let count = names.filter(|name| name.ends_with(".toml")).count();
    let folder = empty_folder("exercise-page");
    let bell = put(&folder, "bell.il", "LD I1\nANDN I2\nST Q1\n");
    let mut shown = Vec::new();
    for (page, has) in [
        ("docs/exercises.md", "has"),
        ("docs/exercises.pt-BR.md", "tem"),
        ("README.md", ""),
        ("README.pt-BR.md", ""),
        ("docs/lab.md", ""),
        ("docs/lab.pt-BR.md", ""),
    ] {
        let text = fs::read_to_string(root.join(page)).unwrap();
        assert!(text.contains(format!("{has} {count}").trim()), "{page}");
        if let Some((_, block)) = text.split_once("```toml\n") {
            shown.push(block.split("```").next().unwrap().to_owned());
        }
    }
    assert_eq!(shown.len(), 2);
    assert_eq!(shown[0], shown[1]);
    let exercise = put(&folder, "bell.toml", &shown[0]);
    let (code, out, err) = outcome(&["grade", &exercise, &bell]);
    assert_eq!(code, 0, "{out}{err}");
    assert_eq!(outcome(&["sim", "--scenario", &exercise]).0, 0);
}

/// Where a fault is to be found, an answer is a text whose lines are tries; where a program is to be written again, its
/// language counts.
#[test]
fn grade_reads_answers_and_asks_for_a_language() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../programs/exercises");
    let of = |name: &str| root.join(name).to_str().unwrap().to_owned();
    let folder = empty_folder("exercise-find");
    let found = put(&folder, "found.txt", "ol stuck\nk1 welded\n");
    let not = put(&folder, "not.txt", "ol stuck\n");
    let (code, out, _) = outcome(&["grade", &of("find/01-motor.toml"), &found, &not]);
    assert_eq!(code, 1);
    let line = |text: &str, name: &str| {
        let line = text.lines().find(|line| line.contains(name)).unwrap();
        line.split_whitespace()
            .skip(1)
            .collect::<Vec<_>>()
            .join(" ")
    };
    assert_eq!(line(&out, "found.txt"), "2 passed");
    assert_eq!(line(&out, "not.txt"), "1 not found; tries: 1");

    let again = of("write/01-into-text.toml");
    let model = of("write/01-into-text.st");
    assert_eq!(outcome(&["grade", &again, &model]).0, 0);
    let ladder = put(&folder, "ladder.il", "LD I1\nST Q1\n");
    let (code, out, _) = outcome(&["grade", &again, &ladder]);
    assert_eq!(code, 1);
    assert!(out.contains("asks for a program in `st`"), "{out}");
}

/// A+ B+ B− A− as a chart does what the cases of its exercise and its machine ask.
#[test]
fn a_chart_drives_two_cylinders_in_turn() {
    let class = empty_folder("exercise-chart");
    put(&class, "ana.st", include_str!("cylinders.st"));
    let exercise =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../../programs/exercises/24-step-by-step.toml");
    let (exercise, class) = (exercise.to_str().unwrap(), class.to_str().unwrap());
    let (code, out, errors) = outcome(&["grade", exercise, class]);
    assert_eq!((code, errors.as_str()), (0, ""), "{out}");
    let row = out.lines().find(|line| line.contains("ana"));
    assert!(row.is_some_and(|row| row.contains("5/5")), "{out}");
    assert!(out.contains("1 of 1 passed"), "{out}");
}
