//! Any text in a typed language is read in a time in proportion to its size, and none of them makes the reader panic.

use crate::board::large;
use crate::common::Random;
use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};
use unoclp_lang::run::Machine;
use unoclp_lang::{Severity, TextLanguage, check, compile_text};

const MEGABYTE: usize = 1 << 20;

/// Each shape as deep or as long as it is asked for.
type Shape = fn(usize) -> String;

const SHAPES: [(&str, Shape); 33] = [
    ("parentheses", |n| {
        format!("x := {}1{};", "(".repeat(n), ")".repeat(n))
    }),
    ("open parentheses", |n| format!("x := {}", "(".repeat(n))),
    ("a long sum", |n| {
        format!("VAR x : INT; END_VAR x := 1{};", " + x".repeat(n))
    }),
    ("powers", |n| {
        format!("VAR x : INT; END_VAR x := 1{};", " ** 2".repeat(n))
    }),
    ("NOT", |n| format!("x := {}TRUE;", "NOT ".repeat(n))),
    ("minus", |n| format!("x := {}1;", "- ".repeat(n))),
    ("IF", |n| "IF x THEN ".repeat(n)),
    ("IF, closed", |n| {
        format!("{}{}", "IF TRUE THEN\n".repeat(n), "END_IF;\n".repeat(n))
    }),
    ("ELSE IF", |n| {
        format!("IF x THEN {}", "ELSE IF y THEN ".repeat(n))
    }),
    ("CASE", |n| "CASE x OF 1: ".repeat(n)),
    ("calls in calls", |n| {
        format!("x := {}1{};", "ABS(".repeat(n), ")".repeat(n))
    }),
    ("subscripts", |n| {
        format!("x := {}1{};", "a[".repeat(n), "]".repeat(n))
    }),
    ("members", |n| {
        format!("VAR a : INT; END_VAR x := a{};", ".b".repeat(n))
    }),
    ("arrays of arrays", |n| {
        format!("VAR a : {}INT; END_VAR", "ARRAY[1..1] OF ".repeat(n))
    }),
    ("structures", |n| {
        format!("TYPE t : {}", "STRUCT a : ".repeat(n))
    }),
    ("first values", |n| {
        format!("VAR a : ARRAY[1..2] OF INT := {}", "[".repeat(n))
    }),
    ("open comments", |n| "(* ".repeat(n)),
    ("closed comments", |n| {
        format!("{}{}", "(* ".repeat(n), "*) ".repeat(n))
    }),
    ("open texts", |n| "x := 'a\n".repeat(n)),
    ("operands of a function", |n| {
        format!("VAR x : INT; END_VAR x := ADD(x{});", ", x".repeat(n))
    }),
    ("names of nothing", |n| {
        (0..n).map(|i| format!("a{i} := b{i};\n")).collect()
    }),
    ("types in a row", |n| {
        let types: String = (1..n).map(|i| format!("T{} : T{};\n", i, i - 1)).collect();
        format!("TYPE {types} END_TYPE VAR x : T5; END_VAR x := x;")
    }),
    ("blocks in blocks", |n| {
        let block = |i: usize| {
            format!(
                "FUNCTION_BLOCK B{i} VAR b : B{}; END_VAR b(); END_FUNCTION_BLOCK\n",
                i + 1
            )
        };
        (0..n).map(block).collect::<String>() + "PROGRAM p VAR b : B0; END_VAR b(); END_PROGRAM"
    }),
    ("functions in functions", |n| {
        let f = |i: usize| format!("FUNCTION F{i} : INT F{i} := F{}(); END_FUNCTION\n", i + 1);
        let all: String = (0..n).map(f).collect();
        format!(
            "{all}FUNCTION F{n} : INT F{n} := 1; END_FUNCTION PROGRAM p VAR x : INT; END_VAR x := F0(); END_PROGRAM"
        )
    }),
    ("large arrays", |n| {
        let all: String = (0..n)
            .map(|i| format!("a{i} : ARRAY[1..99999] OF LREAL;\n"))
            .collect();
        format!("VAR {all} END_VAR a0[1] := 1.0;")
    }),
    ("times in a sum", |n| {
        format!("VAR t : TIME; END_VAR t := t{};", " + T#1s".repeat(n))
    }),
    ("declarations without VAR", |n| "x : INT;\n".repeat(n)),
    ("units without their words", |n| {
        "Scale : REAL VAR_INPUT x : INT; END_VAR\n".repeat(n)
    }),
    ("names of one length", |n| {
        let all: String = (0..n).map(|i| format!("name{i:06} : INT;\n")).collect();
        format!("VAR {all} END_VAR\n") + &"nome000001 := 1; nqme000002 := 1;\n".repeat(20)
    }),
    ("THEN alone", |n| "x THEN y := 1;\n".repeat(n)),
    ("END_VAR alone", |n| "END_VAR ".repeat(n)),
    ("ELSE IF in IF", |n| {
        "IF x THEN y := 1; ELSE IF x THEN y := 2; END_IF;\n".repeat(n)
    }),
    ("braces", |n| "IF x { y++; } ".repeat(n)),
];

/// The time it takes, the least of a few.
fn time(text: &str) -> Duration {
    let mut least = Duration::MAX;
    for language in [TextLanguage::St, TextLanguage::Scl] {
        let begin = Instant::now();
        check(text, language);
        least = least.min(begin.elapsed());
    }
    least
}

#[test]
fn a_hundred_thousand_of_anything_is_one_diagnostic_or_few() {
    for (name, shape) in SHAPES {
        let text = shape(100_000);
        let told = check(&text, TextLanguage::St).diagnostics;
        let errors = told.iter().filter(|d| d.severity() == Severity::Error);
        let few = matches!(
            name,
            "names of nothing"
                | "open texts"
                | "large arrays"
                | "types in a row"
                | "blocks in blocks"
                | "functions in functions"
                | "units without their words"
                | "names of one length"
                | "THEN alone"
                | "END_VAR alone"
                | "ELSE IF in IF"
        );
        assert!(
            few || errors.count() <= 2,
            "{name}: {:?}",
            told.iter().map(|d| d.code.to_string()).collect::<Vec<_>>()
        );
    }
}

#[test]
fn a_megabyte_of_anything_takes_less_than_a_second() {
    for (name, shape) in SHAPES {
        let one = shape(1000).len().max(1);
        let text = shape(1000 * MEGABYTE / one);
        let took = time(&text);
        assert!(
            took < Duration::from_secs(1),
            "{name}: {} bytes, {took:?}",
            text.len()
        );
    }
}

/// As deep as may be, on the stack that WebAssembly has.
#[test]
fn what_is_read_runs_on_a_stack_of_a_megabyte() {
    let deep = [
        format!("VAR x : INT; END_VAR x := {}x{};", "(".repeat(190), ")".repeat(190)),
        format!("VAR x : INT; END_VAR x := x{};", " + x".repeat(290)),
        format!("VAR x : INT; END_VAR x := {}x{};", "ABS(1 + ".repeat(60), ")".repeat(60)),
        format!("VAR x : INT; END_VAR {} x := x + 1; {}", "IF x = 0 THEN ".repeat(180), "END_IF; ".repeat(180)),
        format!("VAR x : INT; END_VAR {} x := x + 1; {}", "REPEAT ".repeat(180), "UNTIL TRUE END_REPEAT; ".repeat(180)),
        (0..55)
            .map(|i| {
                let next = if i == 54 { "x".to_owned() } else { format!("F{}(x)", i + 1) };
                format!("FUNCTION F{i} : INT VAR_INPUT x : INT; END_VAR {} F{i} := 1{} + {next}; {} END_FUNCTION\n", "IF TRUE THEN ".repeat(20), " + 1".repeat(60), "END_IF; ".repeat(20))
            })
            .collect::<String>()
            + "PROGRAM p VAR x : INT; END_VAR x := F0(x); END_PROGRAM",
    ];
    for text in deep {
        let thread = std::thread::Builder::new()
            .stack_size(1 << 20)
            .spawn(move || {
                let checked = check(&text, TextLanguage::St);
                let told: Vec<_> = checked
                    .diagnostics
                    .iter()
                    .map(|d| d.message(unoclp_lang::Lang::En))
                    .collect();
                let tree = checked
                    .tree
                    .unwrap_or_else(|| panic!("{told:?}: {text:.60}"));
                Machine::new(&tree).scan(0)
            });
        let ran = thread.unwrap().join().unwrap();
        assert!(
            !matches!(ran, Err(unoclp_lang::run::Stop::Endless(_))),
            "{ran:?}"
        );
    }
}

#[test]
fn anything_is_compiled_for_the_board_in_time() {
    for (name, shape) in SHAPES {
        for size in [10, 150, 10_000] {
            let begin = Instant::now();
            compile_text(&shape(size), TextLanguage::St, large());
            let took = begin.elapsed();
            assert!(took < Duration::from_secs(1), "{name} {size}: {took:?}");
        }
    }
}

/// The texts of the cases, those of the mistakes or the others.
fn texts(wrong: bool) -> Vec<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/typed");
    let mut all = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.ends_with("mistakes.toml") != wrong {
            continue;
        }
        let text = fs::read_to_string(path).unwrap();
        let parts = text.split("\nst = '''\n").skip(1);
        all.extend(parts.filter_map(|part| part.split("'''").next().map(str::to_owned)));
    }
    all
}

#[test]
fn mutated_texts_are_read_and_run() {
    let kinds = [texts(true), texts(false)];
    let all = kinds.iter().flatten();
    let words: Vec<&str> = all.flat_map(|text| text.split_whitespace()).collect();
    let mut random = Random(7);
    let mut ran = 0;
    for turn in 0..20_000 {
        let texts = &kinds[turn % 2];
        let text = &texts[random.below(texts.len())];
        let mut parts: Vec<&str> = text.split_inclusive([' ', '\n', ';', '(', ')']).collect();
        for _ in 0..=random.below(2) {
            let at = random.below(parts.len());
            match random.below(4) {
                0 => {
                    parts.remove(at);
                }
                1 => parts.insert(at, words[random.below(words.len())]),
                2 => parts[at] = words[random.below(words.len())],
                _ => {
                    let other = random.below(parts.len());
                    parts.swap(at, other);
                }
            }
            if parts.is_empty() {
                break;
            }
        }
        let text = parts.concat();
        let checked = check(&text, TextLanguage::St);
        if let Some(tree) = checked.tree {
            assert_eq!(crate::typed_tree::faults(&tree), [""; 0], "{text}");
            let mut machine = Machine::new(&tree).with_steps(2_000);
            for scan in 0..3 {
                let _ = machine.scan(scan * 40);
            }
            // For the board too, as far as it can do it.
            compile_text(&text, TextLanguage::St, large());
            ran += 1;
        }
    }
    assert!(ran > 500, "{ran}");
}

#[test]
fn bytes_at_random_are_read() {
    let mut random = Random(11);
    let signs: Vec<char> = "()[]{}:=;,.'\"$#%&+-*/<>xT1ä→\n\t ".chars().collect();
    for _ in 0..5_000 {
        let length = random.below(60);
        let text: String = (0..length).map(|_| random.pick(&signs)).collect();
        check(&text, TextLanguage::St);
        check(&text, TextLanguage::Scl);
    }
}
