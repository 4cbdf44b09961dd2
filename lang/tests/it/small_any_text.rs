//! Any text in InterSCL or LCE is read in a time in proportion to its size, and none of them makes a reader panic.

use crate::common::Random;
use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};
use unoclp_lang::run::Machine;
use unoclp_lang::{Severity, TextLanguage, check};

const MEGABYTE: usize = 1 << 20;

/// Each shape as deep or as long as it is asked for.
type Shape = fn(usize) -> String;

const ISCL: [(&str, Shape); 16] = [
    ("parentheses", |n| {
        format!(
            "BLOCO INT x; x := {}1{}; END_BLOCK",
            "(".repeat(n),
            ")".repeat(n)
        )
    }),
    ("a long sum", |n| {
        format!("BLOCO INT x; x := 1{}; END_BLOCK", " + x".repeat(n))
    }),
    ("NOT", |n| {
        format!("BLOCO BOOL x; x := {}x; END_BLOCK", "NOT ".repeat(n))
    }),
    ("minus", |n| {
        format!("BLOCO INT x; x := {}x; END_BLOCK", "- ".repeat(n))
    }),
    ("IF", |n| {
        format!("BLOCO BOOL x; {}", "IF x THEN ".repeat(n))
    }),
    ("IF, closed", |n| {
        let ifs = "IF x THEN\n".repeat(n);
        format!("BLOCO BOOL x; {ifs}{} END_BLOCK", "END_IF;\n".repeat(n))
    }),
    ("ELSE IF", |n| {
        format!("BLOCO BOOL x; IF x THEN {}", "ELSE IF x THEN ".repeat(n))
    }),
    ("ELSIF", |n| {
        let arms = "ELSIF x THEN x := x; ".repeat(n);
        format!("BLOCO BOOL x; IF x THEN {arms} END_IF END_BLOCK")
    }),
    ("WHILE", |n| "WHILE x DO ".repeat(n)),
    ("CASE", |n| format!("BLOCO {}", "CASE x OF 1: ".repeat(n))),
    ("open comments", |n| format!("BLOCO {}", "(* ".repeat(n))),
    ("open texts", |n| "PRINT('a\n".repeat(n)),
    ("names of nothing", |n| {
        let all: String = (0..n).map(|i| format!("a{i} := b{i};\n")).collect();
        format!("BLOCO {all} END_BLOCK")
    }),
    ("declarations", |n| {
        let all: String = (0..n).map(|i| format!("INT a{i};\n")).collect();
        format!("BLOCO {all} a0 := 1; END_BLOCK")
    }),
    ("END_IF", |n| {
        format!("BLOCO {} END_BLOCK", "END_IF; ".repeat(n))
    }),
    ("braces", |n| {
        format!("BLOCO {}", "IF x { y++; } ".repeat(n))
    }),
];

const LCE: [(&str, Shape); 17] = [
    ("parentheses", |n| {
        format!("V0 := {}1{};", "(".repeat(n), ")".repeat(n))
    }),
    ("a long sum", |n| format!("V0 := 1{};", " + V0".repeat(n))),
    ("!", |n| format!("V0 := {}1;", "!".repeat(n))),
    ("signs", |n| format!("V0 := {}1;", "- ".repeat(n))),
    ("se", |n| "se (V0) { ".repeat(n)),
    ("se, closed", |n| {
        format!("{} aciona V1; {}", "se (V0) {\n".repeat(n), "}\n".repeat(n))
    }),
    ("senao se", |n| {
        format!("se (V0) {{ }} {}", "senao se (V0) { } ".repeat(n))
    }),
    ("se without parentheses", |n| "se V0 { ".repeat(n)),
    ("se without braces", |n| "se (V0) ".repeat(n)),
    ("braces", |n| "{ ".repeat(n)),
    ("closing braces", |n| "} ".repeat(n)),
    ("coils in se", |n| {
        let coils: String = (0..n).map(|i| format!("aciona V{i}; ")).collect();
        format!("{}{coils}{}", "se (I0.0) { ".repeat(90), "}".repeat(90))
    }),
    ("mixed kinds", |n| {
        (0..n)
            .map(|i| format!("V{i} R:= V{} + 1;\nV{i} := 1;\n", i / 2))
            .collect()
    }),
    ("names", |n| {
        let all: String = (0..n).map(|i| format!("V{i} = a{i};\n")).collect();
        format!("var {all} a0 := 1;")
    }),
    ("names of nothing", |n| {
        (0..n).map(|i| format!("a{i} := b{i};\n")).collect()
    }),
    ("networks", |n| "rede \"x\n".repeat(n)),
    ("types without spaces", |n| {
        format!("V0 R:= V1{};", "R+V1".repeat(n))
    }),
];

const IL: [(&str, Shape); 14] = [
    ("a long sum", |n| {
        format!("VAR r : REAL; END_VAR\nLD r\n{}ST r", "ADD r\n".repeat(n))
    }),
    ("operands", |n| {
        format!(
            "VAR r : REAL; END_VAR\nLD r\nADD r{}\nST r",
            ", r".repeat(n)
        )
    }),
    ("parentheses", |n| {
        format!("VAR r : REAL; END_VAR\nLD r\n{}", "ADD( r\n".repeat(n))
    }),
    ("parentheses of operands", |n| {
        format!("VAR r : REAL; END_VAR\nLD {}r", "(".repeat(n))
    }),
    ("closing parentheses", |n| {
        format!("VAR r : REAL; END_VAR\nLD r\n{}", ")\n".repeat(n))
    }),
    ("labels and jumps", |n| {
        let all: String = (0..n)
            .map(|i| format!("a{i}: ADD r\nJMP a{}\n", i + 1))
            .collect();
        format!("VAR r : REAL; END_VAR\nLD r\n{all}a{n}: ST r")
    }),
    ("jumps back", |n| {
        let all: String = (0..n).map(|i| format!("LD x\nJMPC a{}\n", i / 2)).collect();
        let labels: String = (0..n).map(|i| format!("a{i}: LD x\nST x\n")).collect();
        format!("VAR x : BOOL; r : REAL; END_VAR\n{labels}{all}")
    }),
    ("IF", |n| {
        format!(
            "VAR x : BOOL; r : REAL; END_VAR\n{}",
            "LD x\nIF\n".repeat(n)
        )
    }),
    ("ELSE", |n| {
        format!("VAR x : BOOL; r : REAL; END_VAR\n{}", "ELSE\n".repeat(n))
    }),
    ("MPS", |n| {
        format!(
            "VAR x : BOOL; r : REAL; END_VAR\nLD x\n{}",
            "MPS\nANDN x\n".repeat(n)
        )
    }),
    ("edges", |n| {
        format!(
            "VAR x : BOOL; r : REAL; END_VAR\n{}",
            "LDP x\nST x\n".repeat(n)
        )
    }),
    ("names of nothing", |n| {
        let all: String = (0..n).map(|i| format!("LD a{i}\nST b{i}\n")).collect();
        format!("VAR r : REAL; END_VAR\n{all}")
    }),
    ("operators of nothing", |n| {
        let all: String = (0..n).map(|i| format!("op{i} r\n")).collect();
        format!("VAR r : REAL; END_VAR\n{all}")
    }),
    ("conversions", |n| {
        format!(
            "VAR r : REAL; END_VAR\nLD r\n{}ST r",
            "REAL_TO_DINT\nDINT_TO_REAL\n".repeat(n)
        )
    }),
];

fn shapes() -> impl Iterator<Item = (TextLanguage, &'static str, Shape)> {
    let iscl = ISCL
        .iter()
        .map(|(name, shape)| (TextLanguage::Iscl, *name, *shape));
    let lce = LCE
        .iter()
        .map(|(name, shape)| (TextLanguage::Lce, *name, *shape));
    let il = IL
        .iter()
        .map(|(name, shape)| (TextLanguage::Il, *name, *shape));
    iscl.chain(lce).chain(il)
}

#[test]
fn a_hundred_thousand_of_anything_is_one_error_or_few() {
    for (language, name, shape) in shapes() {
        let text = shape(100_000);
        let told = check(&text, language).diagnostics;
        let errors = told.iter().filter(|d| d.severity() == Severity::Error);
        let few = matches!(
            name,
            "open texts"
                | "names of nothing"
                | "END_IF"
                | "braces"
                | "closing braces"
                | "networks"
                | "operators of nothing"
                | "closing parentheses"
                | "ELSE"
                | "IF"
                | "se without parentheses"
                | "se without braces"
        );
        assert!(
            few || errors.count() <= 2,
            "{language:?} {name}: {:?}",
            told.iter().map(|d| d.code.to_string()).collect::<Vec<_>>()
        );
    }
}

#[test]
fn a_megabyte_of_anything_takes_less_than_a_second() {
    for (language, name, shape) in shapes() {
        let one = shape(1000).len().max(1);
        let mut text = shape(1000 * MEGABYTE / one);
        text.truncate(MEGABYTE);
        let least = (0..2).map(|_| {
            let begin = Instant::now();
            check(&text, language);
            begin.elapsed()
        });
        let took = least.min().unwrap_or_default();
        assert!(
            took < Duration::from_secs(1),
            "{language:?} {name}: {} bytes, {took:?}",
            text.len()
        );
    }
}

/// The texts of the cases in this language.
fn texts(language: TextLanguage) -> Vec<String> {
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

#[test]
fn mutated_texts_are_read_and_run() {
    for language in [TextLanguage::Iscl, TextLanguage::Lce, TextLanguage::Il] {
        let texts = texts(language);
        let words: Vec<&str> = texts
            .iter()
            .flat_map(|text| text.split_whitespace())
            .collect();
        let (mut random, mut ran) = (Random(5), 0);
        // A text of many lines is seldom left right.
        let rounds = match language {
            TextLanguage::Il => 20_000,
            _ => 10_000,
        };
        for _ in 0..rounds {
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
            let checked = check(&text, language);
            let error = |d: &unoclp_lang::Diagnostic| d.severity() == Severity::Error;
            assert_eq!(
                checked.tree.is_none(),
                checked.diagnostics.iter().any(error),
                "{text}"
            );
            if let Some(tree) = checked.tree {
                assert_eq!(crate::typed_tree::faults(&tree), [""; 0], "{text}");
                let mut machine = Machine::new(&tree).with_steps(2_000);
                for scan in 0..3 {
                    let _ = machine.scan(scan * 40);
                }
                ran += 1;
            }
        }
        assert!(ran > 300, "{ran}");
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
        check(&text, TextLanguage::Iscl);
        check(&format!("BLOCO {text}"), TextLanguage::Iscl);
        check(&text, TextLanguage::Lce);
        check(&format!("se (V0 {text}"), TextLanguage::Lce);
        check(&format!("rede {text}"), TextLanguage::Lce);
        check(&text, TextLanguage::Il);
        check(
            &format!("VAR r : REAL; END_VAR\nLD {text}"),
            TextLanguage::Il,
        );
    }
}
