//! Any text in a typed language is read, told in few words, and run, and none of them makes a reader panic. That the
//! work for it grows as the text does is held by `work.rs`.

use crate::board::large;
use crate::common::Random;
use crate::shapes::{ISCL, LCE, ST, Shape, TYPED_IL};
use std::fs;
use std::path::Path;
use unoclp_lang::run::Machine;
use unoclp_lang::{Diagnostic, Severity, TextLanguage, check, compile_text};

/// Shapes of which each piece is a mistake of its own.
const MANY_IN_ST: [&str; 13] = [
    "names of nothing",
    "open texts",
    "large arrays",
    "types in a row",
    "blocks in blocks",
    "blocks in blocks, each behind what it holds",
    "functions in functions",
    "units without their words",
    "units without their ends",
    "names of one length",
    "THEN alone",
    "END_VAR alone",
    "ELSE IF in IF",
];
/// Those of the other languages.
const MANY_ELSEWHERE: [&str; 12] = [
    "open texts",
    "names of nothing",
    "END_IF",
    "braces",
    "closing braces",
    "networks",
    "se without parentheses",
    "se without braces",
    "operators of nothing",
    "closing parentheses",
    "ELSE",
    "IF",
];

fn shapes() -> impl Iterator<Item = (TextLanguage, &'static str, Shape)> {
    let of = |language, shapes: &'static [(&'static str, Shape)]| {
        shapes
            .iter()
            .map(move |(name, shape)| (language, *name, *shape))
    };
    of(TextLanguage::St, &ST)
        .chain(of(TextLanguage::Iscl, &ISCL))
        .chain(of(TextLanguage::Lce, &LCE))
        .chain(of(TextLanguage::Il, &TYPED_IL))
}

fn is_error(diagnostic: &Diagnostic) -> bool {
    diagnostic.severity() == Severity::Error
}

#[test]
fn a_hundred_thousand_of_anything_is_one_error_or_few() {
    for (language, name, shape) in shapes() {
        let told = check(&shape(100_000), language, unoclp_core::Board::UNO).diagnostics;
        let many = match language == TextLanguage::St {
            true => MANY_IN_ST.contains(&name),
            false => MANY_ELSEWHERE.contains(&name),
        };
        let codes: Vec<String> = told.iter().map(|d| d.code.to_string()).collect();
        let errors = told.iter().filter(|d| is_error(d)).count();
        assert!(many || errors <= 2, "{language:?} {name}: {codes:?}");
    }
}

#[test]
fn anything_is_compiled_for_the_board_or_told_why_not() {
    for (language, name, shape) in shapes() {
        for size in [10, 150, 10_000] {
            let made = compile_text(&shape(size), language, large());
            let told = made.diagnostics.iter().any(is_error);
            assert_eq!(made.program.is_none(), told, "{language:?} {name} {size}");
        }
    }
}

/// Whatever its shape, and however deep: a thread of this test has the stack that a page's module has.
#[test]
fn any_shape_is_compiled_on_a_stack_of_a_megabyte() {
    let compiled = || {
        for (language, name, shape) in shapes() {
            for size in [190, 809, 26_000] {
                // Shown where the stack is too small, which ends the test without a word of its own.
                println!("{language:?} {name} {size}");
                let made = compile_text(&shape(size), language, large());
                if let Some(tree) = &made.tree {
                    let _ = Machine::new(tree).with_steps(100_000).scan(0);
                }
            }
        }
    };
    let thread = std::thread::Builder::new().stack_size(1 << 20);
    thread.spawn(compiled).unwrap().join().unwrap();
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
                let checked = check(&text, TextLanguage::St, unoclp_core::Board::UNO);
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

/// The texts of the cases, those with mistakes and the others.
fn texts_of_st() -> (Vec<String>, Vec<String>) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/typed");
    let mut all = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let text = fs::read_to_string(path).unwrap();
        let parts = text.split("\nst = '''\n").skip(1);
        all.extend(parts.filter_map(|part| part.split("'''").next().map(str::to_owned)));
    }
    all.into_iter().partition(|text| {
        check(text, TextLanguage::St, unoclp_core::Board::UNO)
            .tree
            .is_none()
    })
}

/// The texts of the cases in this language.
fn texts_of(language: TextLanguage) -> Vec<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/typed");
    let name = language.name();
    let mut all = Vec::new();
    for file in [format!("{name}.toml"), format!("{name}-mistakes.toml")] {
        let text = fs::read_to_string(folder.join(file)).unwrap();
        let table: toml::Table = toml::from_str(&text).unwrap();
        let cases = table["case"].as_array().unwrap();
        all.extend(
            cases
                .iter()
                .map(|case| case[name].as_str().unwrap().to_owned()),
        );
    }
    all
}

/// A text in which a few words are lost, doubled, replaced or exchanged.
fn mutated(text: &str, words: &[&str], random: &mut Random) -> String {
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
    parts.concat()
}

/// Whether it is a program; if so, it is run, and compiled for the board as far as that can do it.
fn runs(text: &str, language: TextLanguage) -> bool {
    let checked = check(text, language, unoclp_core::Board::UNO);
    let wrong = checked.diagnostics.iter().any(is_error);
    assert_eq!(checked.tree.is_none(), wrong, "{text}");
    let Some(tree) = checked.tree else {
        return false;
    };
    assert_eq!(crate::typed_tree::faults(&tree), [""; 0], "{text}");
    let mut machine = Machine::new(&tree).with_steps(2_000);
    for scan in 0..3 {
        let _ = machine.scan(scan * 40);
    }
    compile_text(text, language, large());
    true
}

#[test]
fn mutated_texts_are_read_and_run() {
    let (wrong, right) = texts_of_st();
    let kinds = [wrong, right];
    let words: Vec<&str> = words(kinds.iter().flatten());
    let mut random = Random(7);
    let ran = (0..20_000).filter(|turn| {
        let texts = &kinds[turn % 2];
        let text = &texts[random.below(texts.len())];
        runs(&mutated(text, &words, &mut random), TextLanguage::St)
    });
    let ran = ran.count();
    assert!(ran > 500, "{ran}");
}

#[test]
fn mutated_texts_of_the_other_languages_are_read_and_run() {
    // A text of many lines is seldom left right.
    for (language, rounds) in [
        (TextLanguage::Iscl, 10_000),
        (TextLanguage::Lce, 10_000),
        (TextLanguage::Il, 20_000),
    ] {
        let texts = texts_of(language);
        let words = words(texts.iter());
        let mut random = Random(5);
        let ran = (0..rounds).filter(|_| {
            let text = &texts[random.below(texts.len())];
            runs(&mutated(text, &words, &mut random), language)
        });
        let ran = ran.count();
        assert!(ran > 300, "{language:?}: {ran}");
    }
}

fn words<'t>(texts: impl Iterator<Item = &'t String>) -> Vec<&'t str> {
    texts.flat_map(|text| text.split_whitespace()).collect()
}

#[test]
fn bytes_at_random_are_read() {
    let mut random = Random(11);
    let signs: Vec<char> = "()[]{}:=;,.'\"$#%&+-*/<>xT1ä→\n\t ".chars().collect();
    for _ in 0..5_000 {
        let length = random.below(60);
        let text: String = (0..length).map(|_| random.pick(&signs)).collect();
        check(&text, TextLanguage::St, unoclp_core::Board::UNO);
        check(&text, TextLanguage::Scl, unoclp_core::Board::UNO);
    }
}

#[test]
fn signs_at_random_are_read() {
    let mut random = Random(11);
    let signs: Vec<char> = "()[]{}:=;,.'\"$#%&|^!+-*/<>xV0RI1äé→\n\t "
        .chars()
        .collect();
    for _ in 0..5_000 {
        let length = random.below(60);
        let text: String = (0..length).map(|_| random.pick(&signs)).collect();
        check(&text, TextLanguage::Iscl, unoclp_core::Board::UNO);
        check(
            &format!("BLOCO {text}"),
            TextLanguage::Iscl,
            unoclp_core::Board::UNO,
        );
        check(&text, TextLanguage::Lce, unoclp_core::Board::UNO);
        check(
            &format!("se (V0 {text}"),
            TextLanguage::Lce,
            unoclp_core::Board::UNO,
        );
        check(
            &format!("rede {text}"),
            TextLanguage::Lce,
            unoclp_core::Board::UNO,
        );
        check(&text, TextLanguage::Il, unoclp_core::Board::UNO);
        check(
            &format!("VAR r : REAL; END_VAR\nLD {text}"),
            TextLanguage::Il,
            unoclp_core::Board::UNO,
        );
    }
}
