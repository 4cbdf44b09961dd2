//! Files that would take a tool down: each ends with a message or with a row of its own.

use crate::common::{empty_folder, outcome};
use std::fs;
use std::path::Path;

const EXERCISE: &str =
    "title = \"Lamp\"\n[[step]]\nat = 0\nset = { I1 = 1 }\nexpect = { Q1 = 1 }\n";

fn put(folder: &Path, name: &str, text: &str) -> String {
    let path = folder.join(name);
    fs::write(&path, text).unwrap();
    path.to_str().unwrap().to_owned()
}

#[test]
fn one_file_does_not_stop_a_class() {
    let folder = empty_folder("hostile-class");
    let exercise = put(&folder, "lamp.toml", EXERCISE);
    let class = folder.join("class");
    fs::create_dir(&class).unwrap();
    let structs: String = (1..25_600)
        .map(|n| format!("T{n} : STRUCT a : T{}; END_STRUCT;\n", n - 1))
        .collect();
    #[rustfmt::skip]
    let files = [
        ("elsif.st", format!("VAR x : INT; END_VAR IF x = 1 THEN x := 2;\n{}END_IF;", "ELSIF x = 2 THEN x := 3;\n".repeat(15_400))),
        ("structs.st", format!("TYPE T0 : STRUCT a : INT; END_STRUCT;\n{structs}END_TYPE\nVAR x : T25599; END_VAR\n")),
        ("parentheses.il", format!("LD I1\n{}", "AND( I2\n".repeat(20_000))),
        ("endless.st", "VAR x : INT; END_VAR WHILE TRUE DO x := 1; END_WHILE;\n".to_owned()),
        ("long.il", "LD I1\n".repeat(20_000)),
    ];
    for (name, text) in &files {
        put(&class, name, text);
    }
    put(&class, "right.il", "LD I1\nST Q1\n");
    #[cfg(unix)]
    {
        let mkfifo = std::process::Command::new("mkfifo")
            .arg(class.join("pipe.st"))
            .status();
        assert!(mkfifo.unwrap().success());
        std::os::unix::fs::symlink("/dev/zero", class.join("zero.st")).unwrap();
        std::os::unix::fs::symlink("nowhere", class.join("broken.st")).unwrap();
    }
    let (code, out, err) = outcome(&["grade", &exercise, class.to_str().unwrap()]);
    assert_eq!(code, 1, "{err}");
    let mut names: Vec<&str> = files
        .iter()
        .map(|(name, _)| *name)
        .chain(["right.il"])
        .collect();
    if cfg!(unix) {
        names.extend(["pipe.st", "zero.st", "broken.st"]);
    }
    for name in &names {
        let row = out.lines().find(|row| row.contains(name));
        let row = row.unwrap_or_else(|| panic!("no row for {name}: {out}"));
        assert_eq!(row.contains("passed"), *name == "right.il", "{row}");
    }
    assert!(
        out.contains(&format!("1 of {} passed", names.len())),
        "{out}"
    );
}

#[test]
fn what_would_run_for_ever_is_refused_or_stopped() {
    let folder = empty_folder("hostile-time");
    let il = put(&folder, "lamp.il", "LD I1\nST Q1\n");
    for exercise in [
        format!("{}until = 1000000000\n", "title = \"Lamp\"\n") + "[[step]]\nat = 0\nexpect = { Q1 = 0 }\n",
        "title = \"Lamp\"\n".to_owned() + &"[[case]]\ntitle = \"One\"\nuntil = 1000000\nstep = [{ at = 0, expect = { Q1 = 0 } }]\n".repeat(3),
    ] {
        let exercise = put(&folder, "long.toml", &exercise);
        for words in [&["grade", &exercise, &il][..], &["sim", &il, "--scenario", &exercise]] {
            let (code, _, err) = outcome(words);
            assert!(code == 2 && err.contains("long.toml:") && err.contains("scans, but all cases of a file together may take 2000000"), "{err}");
        }
    }
    let folder = folder.to_str().unwrap();
    for (file, told) in [
        ("/dev/zero", "is a device or a pipe"),
        (folder, "is a folder"),
    ] {
        if cfg!(not(unix)) {
            continue;
        }
        for words in [
            &["check", file][..],
            &["grade", file, &il],
            &["sim", "--scenario", file],
            &["flash", file, "--port", "x"],
        ] {
            let (code, _, err) = outcome(words);
            // A folder of exercises may be graded; the only one of this folder is too long.
            let is_course = file == folder && words[0] == "grade";
            let told = if is_course { "long.toml:" } else { told };
            assert!(code == 2 && err.contains(told), "{words:?}: {err}");
        }
    }
    let (code, _, err) = outcome(&["run", &il, "--scans", "1000000000"]);
    assert!(
        code == 2 && err.contains("Set fewer scans with --scans"),
        "{err}"
    );
}

#[test]
fn a_name_forges_neither_rows_nor_formulas() {
    let folder = empty_folder("hostile-names");
    let exercise = put(&folder, "lamp.toml", &EXERCISE.replace("Lamp", "=1+1"));
    let passes = "LD I1\nST Q1\n";
    let mut names = vec!["=cmd.il", "+1.il", "-1.il", "@a.il", "plain.il"];
    if cfg!(unix) {
        names.extend([
            "\t=tab.il",
            "a\nforged.il  1 of 1  passed.il",
            "a\r\u{1b}[2K.il",
            "\u{202e}li.il",
        ]);
    }
    for name in &names {
        put(&folder, name, passes);
    }
    put(&folder, "wrong.il", "LD I1\n\u{1b}[31mFOO\r\u{7}\n");
    let graded = |more: &[&str]| {
        let run = std::process::Command::new(env!("CARGO_BIN_EXE_unoclp"))
            .args(["grade", "lamp.toml"])
            .args(names.iter().chain(&["wrong.il"]).map(|name| {
                format!("./{name}")
                    .replace("./=", "=")
                    .replace("./+", "+")
                    .replace("./@", "@")
            }))
            .args(more)
            .env("LC_ALL", "C")
            .current_dir(&folder)
            .output()
            .unwrap();
        String::from_utf8(run.stdout).unwrap()
    };
    let table = graded(&[]);
    assert_eq!(table.lines().count(), names.len() + 3, "{table}");
    let csv = graded(&["--csv"]);
    assert_eq!(csv.lines().count(), names.len() + 2, "{csv}");
    for text in [&table, &csv] {
        assert!(
            !text.contains(['\u{1b}', '\r', '\t', '\u{7}', '\u{202e}']),
            "{}",
            text.escape_debug()
        );
    }
    for (name, cell) in [
        ("=cmd.il", "'=cmd.il"),
        ("+1.il", "'+1.il"),
        ("@a.il", "'@a.il"),
    ] {
        assert!(
            csv.lines()
                .any(|line| line.starts_with(&format!("{cell},"))),
            "{name}: {csv}"
        );
    }
    // Where one file is named, too.
    if cfg!(unix) {
        for command in ["check", "list", "run"] {
            let name = folder.join("a\r\u{1b}[2K.il");
            let (_, out, err) = outcome(&[command, name.to_str().unwrap()]);
            assert!(!(out + &err).contains(['\u{1b}', '\r']), "{command}");
            let (_, out, err) = outcome(&[command, "no\u{1b}[2J.il"]);
            assert!(!(out + &err).contains('\u{1b}'), "{command}");
        }
    }
    let _ = exercise;
}

/// What stands in a program or an exercise does not act on the terminal that shows it.
#[test]
fn words_of_a_file_do_not_act_on_a_terminal() {
    let folder = empty_folder("hostile-words");
    let il = put(
        &folder,
        "lamp.il",
        "(* \u{1b}[2J \u{202e}t *)\nLD I1 (* \u{7} *)\nST Q1\n",
    );
    let st = put(
        &folder,
        "print.st",
        "VAR s : STRING := '$1B[2J'; END_VAR\ns := CONCAT(s, s);\n",
    );
    let words = "title = \"a\\u001b[2J\\nforged.il  1/1  passed\"\n";
    let exercise = put(
        &folder,
        "words.toml",
        &EXERCISE.replace("title = \"Lamp\"\n", words),
    );
    for (words, lines) in [
        (&["list", &il][..], None),
        (&["list", &il, "--as", "numeric"], None),
        (&["list", &il, "--as", "il"], None),
        (&["run", &st], Some(2)),
        (&["grade", &exercise, &il], Some(3)),
        (&["sim", &il, "--scenario", &exercise], None),
    ] {
        let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_unoclp"));
        // As to a terminal: elsewhere escape codes are left out.
        let command = command
            .args(words)
            .env("CLICOLOR_FORCE", "1")
            .env("LC_ALL", "C.UTF-8");
        let out = String::from_utf8(command.output().unwrap().stdout).unwrap();
        assert!(!out.is_empty(), "{words:?}");
        assert!(
            !out.contains(['\u{1b}', '\u{7}', '\u{202e}']),
            "{words:?}: {}",
            out.escape_debug()
        );
        assert!(
            lines.is_none_or(|lines| out.lines().count() == lines),
            "{words:?}: {out}"
        );
    }
}
