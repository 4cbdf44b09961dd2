//! Files that commands write: whole or not at all, and what they do not overwrite.

use crate::common::{empty_folder, file, outcome, outcome_in};
use std::fs;
use std::path::{Path, PathBuf};

const LAMP: &str = "0\n827301\n877901\n";
const SCENARIO: &str =
    "about = \"\"\nprogram = \"lamp.txt\"\n[[step]]\nat = 0\nexpect = { Q1 = 0 }\n";

/// A folder with a program, and what to call a file in it.
fn folder(name: &str) -> (PathBuf, impl Fn(&str, &str) -> String) {
    let folder = empty_folder(name);
    let at = folder.clone();
    let put = move |name: &str, text: &str| {
        let path = at.join(name);
        fs::write(&path, text).unwrap();
        path.to_str().unwrap().to_owned()
    };
    (folder, put)
}

/// Every command that writes a file, with the name of the file left out at its end.
fn writers(put: &impl Fn(&str, &str) -> String) -> Vec<Vec<String>> {
    let (lamp, il) = (put("lamp.txt", LAMP), put("lamp.il", "LD I1\nST Q1\n"));
    let scenario = put("lamp.toml", SCENARIO);
    let exercise = put(
        "exercise.toml",
        &SCENARIO.replace("about = \"\"", "title = \"Lamp\""),
    );
    let all: [&[&str]; 5] = [
        &["list", &lamp, "--svg"],
        &["sim", "--scenario", &scenario, "--svg"],
        &["sim", "--scenario", &scenario, "--vcd"],
        &["grade", &exercise, &il, "--html"],
        &["compile", &il, "-o"],
    ];
    let owned = |words: &&[&str]| words.iter().map(|&word| word.to_owned()).collect();
    all.iter().map(owned).collect()
}

fn run(command: &[String], more: &[&str]) -> (i32, String, String) {
    let words: Vec<&str> = command
        .iter()
        .map(String::as_str)
        .chain(more.iter().copied())
        .collect();
    outcome(&words)
}

#[test]
fn no_file_is_overwritten_that_unoclp_has_not_written() {
    let (folder, put) = folder("outputs");
    let writers = writers(&put);
    // Of the kinds that are written, too: somebody else's work.
    let others = [
        put("notes.txt", "Call the electrician at 10.\n"),
        put(
            "PROGRAM.TXT",
            "0 is a good number\n12/03: called the electrician\n",
        ),
        put("by-hand.txt", LAMP),
        put(
            "inkscape.svg",
            "<?xml version=\"1.0\"?>\n<svg xmlns:inkscape=\"x\"></svg>\n",
        ),
        put(
            "index.html",
            "<!DOCTYPE html>\n<html><title>Mine</title></html>\n",
        ),
        put("other.vcd", "$version\n Icarus Verilog\n$end\n"),
    ];
    let own: Vec<String> = (0..writers.len())
        .map(|n| folder.join(format!("own-{n}")).to_str().unwrap().to_owned())
        .collect();
    for (command, own) in writers.iter().zip(&own) {
        assert_eq!(run(command, &[own]).0, 0, "{command:?}");
        assert_eq!(
            run(command, &[own]).0,
            0,
            "{command:?}: again, over its own"
        );
        assert_eq!(
            run(command, &[&put("empty", "")]).0,
            0,
            "{command:?}: over nothing"
        );
    }
    for (at, command) in writers.iter().enumerate() {
        for other in others.iter().chain(
            own.iter()
                .enumerate()
                .filter(|(of, _)| *of != at)
                .map(|(_, path)| path),
        ) {
            let before = fs::read(other).unwrap();
            let (code, out, err) = run(command, &[other]);
            let drawings = command.contains(&"--svg".to_owned()) && other.ends_with(['0', '1']);
            if drawings {
                // Both are drawings of its own.
                continue;
            }
            assert_eq!((code, out.as_str()), (2, ""), "{command:?} {other}: {err}");
            assert!(err.contains("--force"), "{command:?} {other}: {err}");
            assert_eq!(fs::read(other).unwrap(), before, "{command:?} {other}");
        }
    }
    for (command, other) in writers.iter().zip(&others) {
        let (code, _, err) = run(command, &[other, "--force"]);
        assert_eq!(code, 0, "{command:?} {other}: {err}");
    }
    let diary = put("PROGRAM.TXT", "A diary.\n");
    let card = |more: &[&str]| {
        outcome(
            &[
                &["card", folder.to_str().unwrap(), &put("a.txt", LAMP)],
                more,
            ]
            .concat(),
        )
    };
    let (code, _, err) = card(&[]);
    assert!(code == 2 && err.contains("--force"), "{err}");
    assert_eq!(fs::read_to_string(&diary).unwrap(), "A diary.\n");
    assert_eq!([card(&["--force"]).0, card(&[]).0], [0, 0]);
}

/// A full disk or card: each file may get 512 bytes, and what has to hold more of them is not begun.
#[cfg(unix)]
#[test]
fn where_no_room_is_left_the_old_file_stays() {
    let (folder, put) = folder("outputs-full");
    let long = put("long.il", &"LD I1\nAND I2\nST Q1\n".repeat(60));
    let scenario = put(
        "long.toml",
        &format!(
            "title = \"Lamp\"\nprogram = \"long.il\"\nuntil = 99\n{}",
            (0..99)
                .map(|at| format!("[[step]]\nat = {at}\nset = {{ I1 = {} }}\n", at % 2))
                .collect::<String>()
        ),
    );
    let commands: [&[&str]; 6] = [
        &["compile", &long, "-o"],
        &["list", &long, "--svg"],
        &["sim", "--scenario", &scenario, "--svg"],
        &["sim", "--scenario", &scenario, "--vcd"],
        &["grade", &scenario, &long, &long, &long, "--html"],
        &["card"],
    ];
    let target = folder.join("PROGRAM.TXT");
    for command in commands {
        let words = match command {
            ["card"] => ["card", folder.to_str().unwrap(), &long].to_vec(),
            words => [words, &[target.to_str().unwrap()]].concat(),
        };
        let _ = fs::remove_file(&target);
        assert_eq!(outcome(&words).0, 0, "{words:?}");
        let old = fs::read(&target).unwrap();
        assert!(old.len() > 1024, "{words:?}: {}", old.len());
        let files = fs::read_dir(&folder).unwrap().count();
        // The signal of a file that grows too large would end the program before it could say so.
        let limited = std::process::Command::new("sh")
            .args([
                "-c",
                "trap '' XFSZ; ulimit -f 1; exec \"$@\"",
                "sh",
                env!("CARGO_BIN_EXE_unoclp"),
            ])
            .args(&words)
            .env("LC_ALL", "C")
            .output()
            .unwrap();
        let err = String::from_utf8_lossy(&limited.stderr);
        assert_eq!(limited.status.code(), Some(2), "{words:?}: {err}");
        assert!(
            err.contains("PROGRAM.TXT cannot be written"),
            "{words:?}: {err}"
        );
        assert_eq!(fs::read(&target).unwrap(), old, "{words:?}");
        assert_eq!(
            fs::read_dir(&folder).unwrap().count(),
            files,
            "{words:?}: nothing is left beside"
        );
    }
}

#[cfg(unix)]
#[test]
fn a_file_that_is_written_anew_keeps_its_rights_and_links() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let (folder, put) = folder("outputs-rights");
    let il = put("lamp.il", "LD I1\nST Q1\n");
    let (out, link) = (folder.join("out.txt"), folder.join("link.txt"));
    assert_eq!(outcome(&["compile", &il, "-o", out.to_str().unwrap()]).0, 0);
    let mode = |path: &Path| fs::metadata(path).unwrap().permissions().mode() & 0o777;
    assert_eq!(mode(&out), mode(Path::new(&il)), "as any new file");
    fs::set_permissions(&out, fs::Permissions::from_mode(0o640)).unwrap();
    symlink("out.txt", &link).unwrap();
    assert_eq!(
        outcome(&["compile", &il, "-o", link.to_str().unwrap()]).0,
        0
    );
    assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
    assert_eq!(mode(&out), 0o640);
}

#[test]
fn a_program_file_without_its_end_is_refused_and_a_changed_one_told() {
    let (folder, put) = folder("outputs-sealed");
    let il = put("lamp.il", "LD I1\nST Q1\nLD I2\nST Q2\n");
    let out = folder.join("PROGRAM.TXT");
    assert_eq!(outcome(&["compile", &il, "-o", out.to_str().unwrap()]).0, 0);
    let whole = fs::read_to_string(&out).unwrap();
    assert!(
        whole.lines().last().unwrap().starts_with("/ unoclp: "),
        "{whole}"
    );
    let upload = |file: &str| outcome(&["upload", file, "--port", "no-such-port"]);
    let file = put("whole.txt", &whole);
    assert_eq!(outcome(&["check", &file]).2, "");
    // Valid numeric code, and a part of the program alone.
    let cut = whole.find("877901").unwrap();
    let cut = cut + whole[cut..].find('\n').unwrap() + 1;
    let file = put("cut.txt", &whole[..cut]);
    for (code, out, err) in [
        outcome(&["check", &file]),
        upload(&file),
        outcome(&["card", folder.to_str().unwrap(), &file]),
    ] {
        assert_eq!(code, 1, "{out}{err}");
        assert!(
            out.contains("the end of this file is missing"),
            "{out}{err}"
        );
    }
    let (code, said, _) = outcome_in(&["check", &file], "pt");
    assert!(
        code == 1 && said.contains("falta o fim deste arquivo"),
        "{said}"
    );
    // By hand: told, and taken as it is.
    let file = put("changed.txt", &whole.replace("827302", "827303"));
    for (code, due) in [(outcome(&["check", &file]), 0), (upload(&file), 2)] {
        assert_eq!(code.0, due, "{code:?}");
        assert!(
            code.2.contains("warning: ") && code.2.contains("this file was changed after"),
            "{code:?}"
        );
    }
}

#[test]
fn what_a_command_reads_is_not_overwritten_by_another_name_either() {
    let folder = empty_folder("outputs-linked");
    let lamp = folder.join("lamp.il");
    fs::write(&lamp, "LD I1\nST Q1\n").unwrap();
    fs::hard_link(&lamp, folder.join("link")).unwrap();
    let [lamp, link] = [lamp, folder.join("link")].map(|path| path.to_str().unwrap().to_owned());
    for arguments in [
        ["compile", &lamp, "-o", &link],
        ["list", &lamp, "--svg", &link],
    ] {
        let (code, _, err) = outcome_in(&arguments, "pt");
        assert_eq!(code, 2);
        assert!(err.contains("indique outro"), "{err}");
    }
    let card = folder.join("PROGRAM.TXT");
    fs::write(&card, "LD I1\nST Q1\n").unwrap();
    let (code, _, err) = outcome(&["card", folder.to_str().unwrap(), card.to_str().unwrap()]);
    assert_eq!(code, 2);
    assert!(err.contains("is the input file"), "{err}");
    assert_eq!(fs::read_to_string(&card).unwrap(), "LD I1\nST Q1\n");
}

#[cfg(unix)]
#[test]
fn a_device_is_written_to() {
    let lamp = file("device.txt", LAMP);
    let outcome = outcome(&["list", &lamp, "--svg", "/dev/null"]);
    assert_eq!(outcome, (0, "/dev/null: drawn\n".to_owned(), String::new()));
}

/// Nobody reads the output: that is no fault of the program, and none of its user.
#[cfg(unix)]
#[test]
fn a_closed_pipe_ends_a_command_quietly() {
    let lamp = file("pipe.txt", LAMP);
    for arguments in [
        &["list", &lamp][..],
        &["check", &lamp],
        &["--help"],
        &["list", &lamp, "--as", "il"],
    ] {
        let (reader, writer) = std::io::pipe().unwrap();
        drop(reader);
        let output = std::process::Command::new(env!("CARGO_BIN_EXE_unoclp"))
            .args(arguments)
            .stdin(std::process::Stdio::null())
            .stdout(writer)
            .output()
            .unwrap();
        assert_eq!(String::from_utf8_lossy(&output.stderr), "", "{arguments:?}");
    }
}
