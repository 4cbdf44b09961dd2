//! Whatever a text holds, it is compiled or told what is wrong, and nothing panics.

use crate::common::Random;
use std::fs;
use std::path::Path;
use unoclp_lang::{Code, Lang, Severity, TextLanguage, compile_text, show};
use unoclp_testing::rounds;

/// Words that the parser looks out for, and what stands between them.
const WORDS: [&str; 96] = [
    "LD",
    "LDN",
    "ST",
    "STN",
    "S",
    "R",
    "AND",
    "ANDN",
    "OR",
    "ORN",
    "XOR",
    "NOT",
    "ADD",
    "SUB",
    "DIV",
    "GT",
    "EQ",
    "JMP",
    "JMPC",
    "JMPCN",
    "CAL",
    "CALC",
    "RET",
    "RETC",
    "TON",
    "TOF",
    "TP",
    "CTU",
    "CTD",
    "CTUD",
    "LDI",
    "OUT",
    "A",
    "O",
    "ON",
    "ALD",
    "OLD",
    "BLK",
    "OUT_BLK",
    "END_BLK",
    "IN",
    "CU",
    "CODE",
    "EU",
    "NEG",
    "SHL",
    "VAR",
    "VAR_INPUT",
    "END_VAR",
    "AT",
    "BOOL",
    "INT",
    "FUNCTION",
    "END_FUNCTION",
    "FUNCTION_BLOCK",
    "END_FUNCTION_BLOCK",
    "PROGRAM",
    "N",
    "Q",
    "T",
    "F",
    "I1",
    "I.2",
    "%IX3",
    "% IX1",
    "%I0.0",
    "Q1",
    "%QX2",
    "M1",
    "M64",
    "M65",
    "IW4",
    "D1",
    "D33",
    "T1",
    "T1.Q",
    "T1.ET",
    "C2",
    "C2.CV",
    "QW1",
    "start",
    "L1",
    "L1:",
    "T#20s",
    "T#1h2m",
    "16#FF",
    "2#",
    "20",
    "-1",
    "0.00",
    "TRUE",
    "PT",
    "PV",
    "Í",
    "\u{FEFF}",
    "'",
];
const BETWEEN: [&str; 17] = [
    " ", " ", " ", "\n", "\n", "\n", "\n", "(", ")", ",", ":", ":=", "=>", ";", "(*x*)", "(*", "=",
];

fn hold(text: &str) {
    let compiled = compile_text(text, TextLanguage::Il, unoclp_core::Board::UNO);
    for diagnostic in compiled.diagnostics.iter() {
        assert!(
            text.get(diagnostic.span.range()).is_some(),
            "{text:?} {diagnostic:?}"
        );
        for lang in [Lang::En, Lang::Pt] {
            assert!(!diagnostic.message(lang).is_empty());
        }
    }
    assert_eq!(compiled.file().is_none(), compiled.has_errors());
    // Only codes of the text's own can break a rule of the numeric code.
    if !text.to_uppercase().contains("CODE") {
        let refused = |d: &unoclp_lang::Diagnostic| d.code == Code::Refused;
        assert!(!compiled.diagnostics.iter().any(refused), "{text:?}");
    }
    // Program start, at least.
    assert!(
        compiled.has_errors() || !compiled.lines.is_empty(),
        "{text:?}"
    );
}

#[test]
fn random_words() {
    let mut random = Random(1);
    let mut text = String::new();
    for _ in 0..rounds(500_000) {
        text.clear();
        for _ in 0..random.below(14) {
            text.push_str(random.pick(&WORDS));
            text.push_str(random.pick(&BETWEEN));
        }
        hold(&text);
    }
}

/// The listings of the course with a few bytes changed, lost, doubled or moved.
#[test]
fn mutated_listings() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../programs/il");
    let mut paths: Vec<_> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .collect();
    paths.sort();
    let texts: Vec<Vec<u8>> = paths
        .iter()
        .filter(|path| path.extension().is_some_and(|extension| extension == "il"))
        .map(|path| fs::read(path).unwrap())
        .filter(|text| text.len() < 400)
        .collect();
    let mut random = Random(2);
    for _ in 0..rounds(500_000) {
        let mut bytes = texts[random.below(texts.len())].clone();
        for _ in 0..random.below(4) + 1 {
            if bytes.is_empty() {
                break;
            }
            let at = random.below(bytes.len());
            let to = (at + random.below(12)).min(bytes.len());
            match random.below(5) {
                0 => bytes[at] = random.bits() as u8 & 0x7F,
                1 => drop(bytes.drain(at..to)),
                2 => {
                    let part = bytes[at..to].to_vec();
                    let behind = random.below(bytes.len());
                    bytes.splice(behind..behind, part);
                }
                3 => bytes.insert(at, random.pick(b"()*:;,%.#\n N=")),
                _ => bytes.truncate(at),
            }
        }
        hold(&String::from_utf8_lossy(&bytes));
    }
}

/// Random bytes, as text where they are none.
#[test]
fn random_bytes() {
    let mut random = Random(3);
    for _ in 0..rounds(50_000) {
        let bytes: Vec<u8> = (0..random.below(80)).map(|_| random.bits() as u8).collect();
        hold(&String::from_utf8_lossy(&bytes));
    }
}

/// What is told can be shown, wherever it stands.
#[test]
fn everything_can_be_shown() {
    let mut random = Random(4);
    let renderer = annotate_snippets::Renderer::plain();
    for _ in 0..rounds(3_000) {
        let mut text = String::new();
        for _ in 0..random.below(20) {
            text.push_str(random.pick(&WORDS));
            text.push_str(random.pick(&BETWEEN));
        }
        let compiled = compile_text(&text, TextLanguage::Il, unoclp_core::Board::UNO);
        for lang in [Lang::En, Lang::Pt] {
            let shown = show("x.il", &text, &compiled.diagnostics, lang, &renderer);
            assert_eq!(
                shown.is_empty(),
                compiled.diagnostics.is_empty(),
                "{text:?}"
            );
        }
    }
}

/// Texts whose shape is a trap: each is large, and done in no more time than its size asks for.
#[test]
fn large_texts() {
    let many = |part: &str| part.repeat(20_000);
    let texts = [
        many("LD I1\nST Q1\n"),
        many("("),
        many(")\n"),
        many("AND( I1\n"),
        format!("LD I1\n{}{}", many("AND( I1\n"), many(")\n")),
        format!("LD I1\n{}ST Q1\n", many("AND I2\nNOT\nOR I3\n")),
        format!("LD D1\n{}ST D1\n", many("ADD D2\nMUL 3\n")),
        format!("LD I1\n{}ST Q1\n", many("OR I2\n")),
        format!("LD I1\n{}ST Q1\n", many("OR(\nNOT\n)\n")),
        many("(* * ) "),
        many("(*"),
        many("* * "),
        many("x "),
        many("x:\n"),
        many("JMP x\nx:\n"),
        many("CAL T1(IN:=I1, PT:=T#1s)\n"),
        many("VAR x : BOOL; END_VAR\n"),
        many("FUNCTION f\nCAL f\n"),
        many("BLK %TM1\n"),
        (0..5_000).map(|n| format!("LD a{n}\nST b{n}\n")).collect(),
    ];
    for text in texts {
        let compiled = compile_text(&text, TextLanguage::Il, unoclp_core::Board::UNO);
        assert!(compiled.has_errors() || compiled.file().is_some());
    }
}

/// Functions that call the next one twice would be 2 to the power of 30 bodies, with or without anything in
/// them; and a long chain of calls would be deep.
#[test]
fn calls_do_not_explode() {
    let chain = |functions: usize, body: &str, calls: usize| {
        let mut text = "CAL f0\n".to_owned();
        for n in 0..functions {
            let call = format!("CAL f{}\n", n + 1).repeat(calls);
            text += &format!("FUNCTION f{n} : BOOL\n{body}{call}END_FUNCTION\n");
        }
        text + &format!("FUNCTION f{functions} : BOOL\nLD I1\nST M1\nEND_FUNCTION\n")
    };
    for text in [
        chain(30, "LD I1\nST M1\n", 2),
        chain(15, "", 10),
        chain(30, "", 2),
        chain(5_000, "", 1),
    ] {
        let compiled = compile_text(&text, TextLanguage::Il, unoclp_core::Board::UNO);
        let told = |d: &unoclp_lang::Diagnostic| d.severity() == Severity::Error;
        assert!(compiled.diagnostics.iter().any(told));
    }
}
