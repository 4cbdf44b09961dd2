//! Files that commands write: what they do not overwrite.

use crate::common::{empty_folder, file, outcome, outcome_in};
use std::fs;

const LAMP: &str = "0\n827301\n877901\n";
const SCENARIO: &str =
    "about = \"\"\nprogram = \"lamp.txt\"\n[[step]]\nat = 0\nexpect = { Q1 = 0 }\n";

/// The arguments of a command that writes this file.
type Writes<'a> = &'a dyn Fn(&str) -> Vec<String>;

#[test]
fn nothing_of_another_kind_is_overwritten() {
    let folder = empty_folder("outputs");
    let put = |name: &str, text: &str| {
        let path = folder.join(name);
        fs::write(&path, text).unwrap();
        path.to_str().unwrap().to_owned()
    };
    let (lamp, il) = (put("lamp.txt", LAMP), put("lamp.il", "LD I1\nST Q1\n"));
    let scenario = put("lamp.toml", SCENARIO);
    let notes = put("notes.txt", "Call the electrician at 10.\n");
    let (drawing, trace) = (
        put("lamp.svg", "<svg></svg>"),
        put("lamp.vcd", "$version 1 $end"),
    );
    let texts = [&lamp, &il, &scenario, &notes, &drawing, &trace];
    let is = |path: &&String, own: &str| **path != own;
    let list = |out: &str| {
        vec![
            "list".to_owned(),
            lamp.clone(),
            "--svg".to_owned(),
            out.to_owned(),
        ]
    };
    let sim = |out: &str| {
        ["sim", "--scenario", &scenario, "--vcd", out]
            .map(str::to_owned)
            .to_vec()
    };
    let diagram = |out: &str| {
        ["sim", "--scenario", &scenario, "--svg", out]
            .map(str::to_owned)
            .to_vec()
    };
    let compile = |out: &str| ["compile", &il, "-o", out].map(str::to_owned).to_vec();
    let commands: [(Writes<'_>, &str); 4] = [
        (&list, &drawing),
        (&diagram, &drawing),
        (&sim, &trace),
        (&compile, &lamp),
    ];
    for (command, own) in commands {
        for other in texts.iter().filter(|path| is(path, own)) {
            let before = fs::read_to_string(other).unwrap();
            let arguments = command(other);
            let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
            let (code, out, err) = outcome(&arguments);
            assert_eq!((code, out.as_str()), (2, ""), "{arguments:?}: {err}");
            let says = "is there already, and is not";
            assert!(
                err.contains(says) || err.contains("is what"),
                "{arguments:?}: {err}"
            );
            assert_eq!(
                &fs::read_to_string(other).unwrap(),
                &before,
                "{arguments:?}"
            );
        }
        // Its own kind is written anew, and what is not there yet, and what is empty.
        for good in [own, &put("empty", ""), folder.join("new").to_str().unwrap()] {
            let arguments = command(good);
            let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
            let (code, out, err) = outcome(&arguments);
            assert_eq!(code, 0, "{arguments:?}: {out}{err}");
        }
        fs::remove_file(folder.join("new")).unwrap();
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
    assert!(err.contains("is what the command reads"), "{err}");
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
