//! Every command in Portuguese: with what is right, what is wrong, what is missing, and nothing at all.

use crate::common::{empty_folder, outcome_in};
use std::fs;

/// Words that English cannot do without, and Portuguese does not have.
const ENGLISH: &[&str] = &[
    "the",
    "is",
    "are",
    "of",
    "not",
    "cannot",
    "with",
    "and",
    "or",
    "file",
    "line",
    "lines",
    "fault",
    "faults",
    "error",
    "warning",
    "help",
    "it",
    "there",
    "this",
    "board",
    "usage",
    "options",
    "arguments",
    "expected",
    "got",
    "rung",
    "input",
    "output",
    "at",
    "address",
    "parity",
    "sum",
    "stored",
    "program",
    "bytes_of",
    "by",
    "such",
    "read",
    "written",
    "needs",
    "already",
    "directory",
    "value",
    "required",
    "possible",
    "found",
    "must",
];

/// The words of a text, but not what stands in backticks, in quotation marks, or in names of files and options.
fn words(text: &str) -> Vec<String> {
    let outside = |mark: char, text: &str| -> String { text.split(mark).step_by(2).collect() };
    let line = |line: &str| outside('`', &outside('\'', line));
    let text: String = text.lines().map(|text| line(text) + "\n").collect();
    let is_name = |word: &&str| !word.contains(['/', '-', '=', '[', '_']) && !word.contains(".t");
    text.split_whitespace()
        .filter(is_name)
        .map(|word| word.trim_matches(|c: char| !c.is_alphabetic()).to_owned())
        .collect()
}

/// Sees that a text has no word of English.
#[track_caller]
pub fn assert_portuguese(said: &str) {
    let mut words = words(said).into_iter();
    if let Some(word) = words.find(|word| ENGLISH.contains(&word.as_str())) {
        panic!("{word:?} in\n{said}");
    }
}

/// What `unoclp` says, which is no English.
#[track_caller]
fn is_portuguese(arguments: &[&str], lang: &str) -> String {
    let (_, out, err) = outcome_in(arguments, lang);
    // Numeric code is the same file whatever is spoken.
    let out = match arguments.first() {
        Some(&"compile") if out.starts_with("0 ") => String::new(),
        _ => out,
    };
    let said = out + &err;
    assert!(!said.is_empty(), "{arguments:?} says nothing");
    assert_portuguese(&format!("{arguments:?}\n{said}"));
    said
}

#[test]
fn no_command_says_anything_in_english() {
    let folder = empty_folder("portuguese");
    let put = |name: &str, text: &str| {
        let path = folder.join(name);
        fs::write(&path, text).unwrap();
        path.to_str().unwrap().to_owned()
    };
    let good = put(
        "a.txt",
        "0\n787600\n827301\n847978\n3\n7901\n787600\n766800\n-5\n838403\n",
    );
    let bad = put("b.txt", "0\n827309\n827401\n8273\nx\n77\n");
    let good_il = put("a.il", "LD I1\nST Q1\nLD 5\nADD D1\nST D1\n");
    let doubtful_il = put("c.il", "LD I1\nST lamp\n");
    let bad_il = put("b.il", "LD I9\nST Q1\n");
    let good_st = put("a.st", "VAR n : INT; END_VAR\nn := n + 1;\n");
    let bad_st = put("b.st", "VAR n : INT; END_VAR\nn := m;\n");
    let good_iscl = put("a.iscl", "BLOCO INT n; n := n / 2; PRINT(n); END_BLOCK\n");
    let bad_iscl = put("b.iscl", "BLOCO INT n; n := 1.5; END_BLOCK\n");
    let good_lce = put("a.lce", "clp x\nV0 := V0 + 1;\nfim\n");
    let bad_lce = put("b.lce", "5 := V0;\n");
    let page = put("a.md", "# Uma lista\n\nE uma frase.\n");
    let empty = put("c.txt", "");
    let binary = put("d.txt", "a\0b");
    let missing = folder.join("no.txt").to_str().unwrap().to_owned();
    let here = folder.to_str().unwrap().to_owned();
    for file in [
        &good,
        &bad,
        &good_il,
        &doubtful_il,
        &bad_il,
        &good_st,
        &bad_st,
        &good_iscl,
        &bad_iscl,
        &good_lce,
        &bad_lce,
        &page,
        &empty,
        &binary,
        &missing,
        &here,
    ] {
        let image = folder.join("card.img");
        let _ = fs::remove_file(&image);
        let image = image.to_str().unwrap();
        #[rustfmt::skip]
        let commands: &[&[&str]] = &[
            &["run", file], &["run", file, "--scans", "2"], &["run", file, "--set", "x"], &["run", file, "--set", "x=1"],
            &["check", file], &["list", file], &["list", file, "--as", "numeric"], &["compile", file], &["sim", file],
            &["list", file, "--svg", &missing.replace("no.txt", "no/no.svg")], &["list", file, "--svg", &good],
            &["list", file, "--as", "il", "--svg", "x.svg"], &["compile", file, "-o", &here], &["compile", file, "-o", file],
            &["card", image, file], &["card", &here, file, "--state"], &["card", &here, file, "--state"],
            &["card", &good, file], &["card", "/dev/null", file], &["card", &missing, file],
            &["upload", file, "--port", "/dev/no-such-port"], &["monitor", file, "--port", "/dev/no-such-port"],
            &["upload", file, "--port", "/dev/null"],
            &["flash", file, "--port", "/dev/null"], &["flash", "--port", "/dev/no-such-port", "--board", "nano"],
        ];
        for command in commands {
            is_portuguese(&[command, &["--lang", "pt"][..]].concat(), "C.UTF-8");
        }
    }
    let step = "[[step]]\nat = 0\nexpect = { Q1 = 1 }\n";
    #[rustfmt::skip]
    let scenarios = [
        format!("about = \"\"\nprogram = \"a.txt\"\n{step}"), format!("about = \"\"\nprogram = \"a.il\"\n{step}"),
        format!("about = \"\"\nprogram = \"b.txt\"\n{step}"), format!("about = \"\"\nprogram = \"b.il\"\n{step}"),
        format!("about = \"\"\nprogram = \"no.txt\"\n{step}"), format!("about = \"\"\n{step}"),
        format!("about = \"\"\nprogram = \"a.txt\"\n{}", step.replace('1', "0")),
        "about = \"\"\nprogram = \"b.txt\"\nfault = { number = 25, line = 2 }".to_owned(),
        "about = \"\"\nprogram = \"a.txt\"\nfault = { number = 25 }".to_owned(),
        "about = \"\"\nprogram = \"a.txt\"\nstops = { at = 3, number = 75 }".to_owned(),
        "about = ".to_owned(), "speed = 1".to_owned(), String::new(), "about = 1".to_owned(),
    ];
    for (index, text) in scenarios.iter().enumerate() {
        let scenario = put(&format!("{index}.toml"), text);
        for more in [
            &[][..],
            &[&*good],
            &[&*bad_il],
            &["--vcd", &good],
            &["--vcd", &here],
        ] {
            let sim = ["sim", "--lang", "pt", "--scenario", &scenario];
            is_portuguese(&[&sim, more].concat(), "C.UTF-8");
        }
    }
    is_portuguese(&["sim", "--scenario", &missing], "pt_BR.UTF-8");
    is_portuguese(&["sim", "--scenario", &here], "pt_BR.UTF-8");
}

#[test]
fn no_argument_is_refused_in_english() {
    let said = |arguments: &[&str]| {
        is_portuguese(arguments, "pt_BR.UTF-8");
        is_portuguese(&[arguments, &["--lang", "pt"]].concat(), "C.UTF-8")
    };
    said(&[]);
    said(&["fly"]);
    said(&["--fly"]);
    said(&["help"]);
    for command in [
        "check", "compile", "list", "run", "sim", "card", "upload", "monitor", "settings", "flash",
    ] {
        said(&[command]);
        said(&["help", command]);
        let help = said(&[command, "--help"]);
        assert!(
            help.contains(&format!("Uso: unoclp {command} [OPÇÕES]")),
            "{help}"
        );
        said(&[command, "--fly"]);
        said(&[command, "a", "b", "c"]);
        said(&[command, "--dialect", "x"]);
        said(&[command, "a", "--language", "x"]);
        said(&[command, "--port"]);
        for (option, value) in [
            ("--address", "0"),
            ("--rate", "1"),
            ("--parity", "x"),
            ("--width", "x"),
            ("--as", "x"),
            ("--lock", "x"),
            ("--end-forcing", "0"),
            ("--board", "mega"),
        ] {
            said(&[command, "a", "--port", "/dev/no-such-port", option, value]);
        }
        said(&[command, "--port", "/dev/no-such-port", "--set-rate", "1234"]);
    }
    let refused = said(&["list", "a.txt", "--width", "20"]);
    assert!(
        refused
            .starts_with("erro: valor inválido '20' para '--width <N>'; use um valor de 56 a 1000"),
        "{refused}"
    );
    let usage = said(&["list"]);
    assert!(
        usage.contains("falta indicar: <ARQUIVO>\n\nUso: unoclp list "),
        "{usage}"
    );
}
