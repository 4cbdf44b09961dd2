//! The language of a program, in every command: by its name, by its first words, by `--language`; and what is none.

use crate::common::{empty_folder, file, outcome, outcome_in};
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use unoclp_lang::TextLanguage;
use unoclp_program::{Lang, WrittenIn};

const LAMP: [(&str, &str, &str); 5] = [
    (
        "st",
        "VAR i AT %IX1 : BOOL; q AT %QX1 : BOOL; END_VAR\nq := i;\n",
        "Structured Text",
    ),
    (
        "scl",
        "VAR i AT %IX1 : BOOL; q AT %QX1 : BOOL; END_VAR\n#q := #i;\n",
        "SCL",
    ),
    (
        "iscl",
        "BLOCO\nBOOL i AT %IX1; BOOL q AT %QX1;\nq := i;\nEND_BLOCK\n",
        "InterSCL",
    ),
    ("lce", "clp lamp\naciona Q0.0;\nfim\n", "LCE"),
    ("il", "LD I1\nST Q1\n", "dialect iec"),
];

/// Runs `unoclp` with this on its standard input.
fn fed(arguments: &[&str], input: &str) -> (i32, String) {
    let mut child = Command::new(env!("CARGO_BIN_EXE_unoclp"))
        .args(arguments)
        .env("LC_ALL", "C")
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let mut stdin = child.stdin.take().unwrap();
    stdin.write_all(input.as_bytes()).unwrap();
    drop(stdin);
    let output = child.wait_with_output().unwrap();
    (
        output.status.code().unwrap(),
        String::from_utf8(output.stdout).unwrap(),
    )
}

#[test]
fn every_language_is_known_by_its_words_in_every_command() {
    let folder = empty_folder("by-words");
    for (end, text, told) in LAMP {
        let program = file(&format!("words-{end}.txt"), text);
        let (code, out, err) = outcome(&["check", &program]);
        assert_eq!((code, err.as_str()), (0, ""), "{out}");
        assert!(out.contains(&format!("\n  {told}")), "{end}: {out}");
        let (code, out, _) = outcome(&["compile", &program]);
        assert!(code == 0 && out.starts_with("0 "), "{end}: {out}");
        let (code, out, _) = outcome(&["list", &program]);
        assert!(code == 0 && out.contains("Rung 1"), "{end}: {out}");
        let (code, out, _) = outcome(&["card", folder.to_str().unwrap(), &program]);
        assert!(code == 0 && out.contains("PROGRAM.TXT"), "{end}: {out}");
        let (code, _, err) = outcome(&["sim", &program]);
        assert!(code == 2 && err.contains("terminal"), "{end}: {err}");
        for command in ["upload", "monitor"] {
            let (code, _, err) = outcome(&[command, &program, "--port", "/dev/no-such-port"]);
            let told = err.contains("no port") || err.contains("terminal");
            assert!(code == 2 && told, "{end}: {command}: {err}");
        }
        let scenario = file(
            &format!("words-{end}.toml"),
            &format!(
                "about = \"\"\nprogram = \"words-{end}.txt\"\n[[step]]\nat = 1\nexpect = {{ Q2 = 0 }}\n"
            ),
        );
        let (code, out, _) = outcome(&["sim", "--scenario", &scenario]);
        assert_eq!(code, 0, "{end}: {out}");
    }
}

#[test]
fn standard_input_is_a_program_for_every_command_that_shows_one() {
    for (end, text, _) in LAMP {
        let (code, out) = fed(&["check", "-"], text);
        assert!(
            code == 0 && out.starts_with("standard input: OK: "),
            "{end}: {out}"
        );
        let (code, out) = fed(&["compile", "-"], text);
        assert!(code == 0 && out.starts_with("0 "), "{end}: {out}");
        let (code, out) = fed(&["list", "-"], text);
        assert!(code == 0 && out.contains("Rung 1"), "{end}: {out}");
    }
    let (code, out) = fed(&["check", "-"], "0\n827301\n877901\n");
    assert!(code == 0 && out.contains("OK: 3 codes"), "{out}");
}

#[test]
fn an_option_says_the_language_where_the_text_does_not() {
    let text = file("open.txt", "nivel := 5;\n");
    let (code, out, _) = outcome(&["check", &text]);
    assert!(code == 1 && out.contains("error[ST-130]"), "{out}");
    let (code, out, _) = outcome(&["check", "--language", "lce", &text]);
    assert!(code == 1 && out.contains("error[LCE-"), "{out}");
    let (code, _, err) = outcome(&["check", "--language", "basic", &text]);
    assert!(
        code == 2 && err.contains("st, scl, iscl, lce, il, xml, numeric"),
        "{err}"
    );
}

#[test]
fn what_is_no_program_is_told_what_it_is_in_every_command() {
    let image = empty_folder("no-program").join("card.img");
    let image = image.to_str().unwrap();
    let page = file("page.md", "# A page\n\nAnd a sentence. A lamp is lit.\n");
    let empty = file("empty.txt", "\n");
    let binary = file("binary.txt", "PNG\0\0");
    for (lang, none, nothing, bytes, which) in [
        (
            "C",
            " is not a program: its first lines match none",
            " is empty",
            "not text",
            "use --language",
        ),
        (
            "pt_BR",
            " não é um programa: as primeiras linhas não são de nenhuma",
            " está vazio",
            "não um texto",
            "use --language",
        ),
    ] {
        for (path, told) in [(&page, none), (&empty, nothing), (&binary, bytes)] {
            let commands: [&[&str]; 8] = [
                &["check", path],
                &["compile", path],
                &["list", path],
                &["sim", path],
                &["run", path],
                &["card", image, path],
                &["upload", path, "--port", "/dev/null"],
                &["monitor", path, "--port", "/dev/null"],
            ];
            for command in commands {
                let (code, out, err) = outcome_in(command, lang);
                assert_eq!((code, out.as_str()), (2, ""), "{command:?}");
                assert!(
                    err.contains(told) && err.contains(which),
                    "{command:?}: {err}"
                );
                for end in [".txt", ".il", ".st", ".scl", ".iscl", ".lce"] {
                    assert!(err.contains(end), "{err}");
                }
            }
        }
    }
}

/// The pages and scenarios of the repository hold programs, and are none.
#[test]
fn no_page_of_the_repository_is_a_program() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let pages = |folder: &str| -> Vec<PathBuf> {
        let all = fs::read_dir(root.join(folder)).unwrap();
        let all = all.map(|entry| entry.unwrap().path());
        all.filter(|path| {
            path.extension()
                .is_some_and(|end| end == "md" || end == "toml")
        })
        .collect()
    };
    let all: Vec<PathBuf> = ["", "docs", "programs", "proof/suite"]
        .iter()
        .flat_map(|folder| pages(folder))
        .collect();
    assert!(all.len() > 40, "{}", all.len());
    for path in all {
        let written = unoclp_program::WrittenIn::of(&path, &fs::read(&path).unwrap());
        assert_eq!(
            written,
            Err(unoclp_program::NoProgram::Other),
            "{}",
            path.display()
        );
    }
}

/// The sentences that name the languages are made of the registry.
#[test]
fn help_and_mistakes_name_every_language() {
    let nothing = file("nothing.txt", "\n");
    let pages = [
        (outcome(&["check", "--help"]).1, Lang::En),
        (outcome_in(&["check", "--help"], "pt_BR").1, Lang::Pt),
        (outcome(&["check", &nothing]).2, Lang::En),
        (outcome_in(&["check", &nothing], "pt_BR").2, Lang::Pt),
    ];
    for (page, lang) in pages {
        let page: Vec<&str> = page.split_whitespace().collect();
        let page = page.join(" ");
        assert!(page.contains(&WrittenIn::programs(lang)), "{page}");
    }
    for language in TextLanguage::all() {
        let written = WrittenIn::named(language.name());
        assert!(written.is_some(), "{language:?} is no file's");
    }
}
