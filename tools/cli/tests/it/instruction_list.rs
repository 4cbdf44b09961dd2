//! The program `unoclp` on Instruction List: compiled, checked, listed, and run.

use crate::common::{empty_folder, file, folder, outcome, outcome_in};
use std::fs;

const LAMP: &str = "\
(* Lamp with two switches *)
VAR
    hall   AT %IX1 : BOOL;
    stairs AT %IX2 : BOOL;
    lamp   AT %QX1 : BOOL;
END_VAR

(* On where the switches differ *)
LD   hall
XOR  stairs
ST   lamp
";

/// A name that nothing declares is a warning, a second one of its line an error.
const WARNED: &str = "LD I1\nST seen\nLD seen\nST Q1\n";
const WRONG: &str = "LD I1\nAND I9\nST Q1\n";

/// The codes of a program file, without its comments.
fn codes(file: &str) -> Vec<i32> {
    let codes = file
        .lines()
        .map(|line| line.split('/').next().unwrap().trim());
    let codes = codes.filter(|code| !code.is_empty());
    codes.map(|code| code.parse().unwrap()).collect()
}

#[test]
fn each_code_names_its_word_and_its_line() {
    let lamp = file("lamp.il", LAMP);
    let numeric = folder().join("lamp-compiled.txt");
    let (code, out, err) = outcome(&["compile", &lamp, "-o", numeric.to_str().unwrap()]);
    assert_eq!((code, out.as_str()), (0, ""));
    assert_eq!(
        err,
        format!("{lamp}: dialect iec, detected from its keywords; codes: 4, warnings: 0\n")
    );
    let numeric = fs::read_to_string(numeric).unwrap();
    assert!(
        numeric.contains("\n827301    / RI 01    hall, line 9\n"),
        "{numeric}"
    );
    assert!(
        numeric.contains("\n877901    / WO 01    lamp, line 11\n"),
        "{numeric}"
    );
    for arguments in [&["compile", &lamp][..], &["compile", &lamp, "-o", "-"]] {
        assert_eq!(outcome(arguments).1, numeric);
    }
    assert!(!folder().join("-").exists());
}

#[test]
fn what_is_read_back_compiles_to_the_same_codes() {
    for name in [
        "motor",
        "stardelta",
        "traffic",
        "twohand",
        "stairs",
        "timers",
    ] {
        let first = format!("{}/../../programs/{name}.txt", env!("CARGO_MANIFEST_DIR"));
        let (code, il, _) = outcome(&["list", &first, "--as", "il"]);
        assert_eq!(code, 0, "{il}");
        let il = file(&format!("{name}-back.il"), &il);
        let (code, numeric, err) = outcome(&["compile", &il]);
        assert_eq!(code, 0, "{err}");
        assert_eq!(
            codes(&numeric),
            codes(&fs::read_to_string(&first).unwrap()),
            "{name}"
        );
        // And once more, from Instruction List itself.
        let (_, again, _) = outcome(&["list", &il, "--as", "il"]);
        assert_eq!(again, fs::read_to_string(&il).unwrap());
    }
}

#[test]
fn errors_are_told_in_the_language_that_is_asked_for() {
    let wrong = file("wrong.il", WRONG);
    let english = [
        "error[IL-",
        "wrong.il:2:5",
        "1 error; there is no program\n",
    ];
    let portuguese = ["erro[IL-", "wrong.il:2:5", "1 erro; não há programa\n"];
    let cases: [(&[&str], &str, [&str; 3]); 6] = [
        (&[], "C", english),
        (&[], "en_US.UTF-8", english),
        (&[], "pt_BR.UTF-8", portuguese),
        (&[], "", english),
        (&["--lang", "pt-BR"], "C", portuguese),
        (&["--lang", "en"], "pt_BR.UTF-8", english),
    ];
    for (options, lang, parts) in cases {
        for command in ["check", "list", "sim"] {
            let arguments = [&[command, &wrong], options].concat();
            let (code, out, err) = outcome_in(&arguments, lang);
            assert_eq!((code, err.as_str()), (1, ""), "{arguments:?}");
            for part in parts {
                assert!(
                    out.contains(part),
                    "{arguments:?}: {part} is missing in\n{out}"
                );
            }
        }
        // What is compiled goes to standard output, so nothing else does.
        let (code, out, err) = outcome_in(&[&["compile", &wrong], options].concat(), lang);
        assert_eq!((code, out.as_str()), (1, ""));
        assert!(parts.iter().all(|part| err.contains(part)), "{err}");
    }
}

#[test]
fn warnings_stand_beside_what_was_asked_for() {
    let warned = file("warned.il", WARNED);
    for command in ["compile", "check", "list"] {
        let (code, out, err) = outcome(&[command, &warned]);
        assert_eq!(code, 0);
        assert!(
            err.starts_with("warning[IL-") && !out.contains("warning"),
            "{err}{out}"
        );
    }
    let (_, _, err) = outcome_in(&["compile", &warned], "pt_BR");
    assert!(err.starts_with("aviso[IL-"), "{err}");
    assert!(
        err.ends_with("dialeto iec, detectado pelas palavras-chave; códigos: 6, avisos: 1\n"),
        "{err}"
    );
}

#[test]
fn the_dialect_is_found_or_said() {
    let text = "LD X0\nANI X1\nOUT Y0\n";
    let file = file("maker.il", text);
    let (code, out, _) = outcome(&["check", &file]);
    assert_eq!(code, 0, "{out}");
    assert!(
        out.ends_with("pins: I1 I2 Q1\n  dialect mitsubishi, detected from its keywords\n"),
        "{out}"
    );
    let (code, out, _) = outcome(&["check", &file, "--dialect", "mitsubishi"]);
    assert_eq!(code, 0);
    assert!(out.ends_with("\n  dialect mitsubishi\n"), "{out}");
    let (code, _, err) = outcome(&["check", &file, "--dialect", "klingon"]);
    assert_eq!(code, 2);
    assert!(
        err.contains("[possible values: iec, mitsubishi, omron, s7-200, twido]"),
        "{err}"
    );
}

#[test]
fn instruction_list_is_known_by_its_text_too() {
    let lamp = file("lamp-il.txt", LAMP);
    let (code, out, _) = outcome(&["check", &lamp]);
    assert_eq!(code, 0, "{out}");
    assert!(out.contains("dialect iec"), "{out}");
    // A letter in a numeric code stays a fault of its own.
    let typo = file("typo.txt", "0\n8273O1\n877901\n");
    let (code, out, _) = outcome(&["check", &typo]);
    assert_eq!(code, 1);
    assert!(out.starts_with("error[12]"), "{out}");
}

#[test]
fn a_listing_shows_names_lines_and_comments_of_the_text() {
    let lamp = file("lamp-listed.il", LAMP);
    let (code, out, _) = outcome(&["list", &lamp]);
    assert_eq!(code, 0);
    let heading = "Lamp with two switches\n\nRung 1, lines 9 to 11: On where the switches differ\n";
    assert!(out.starts_with(heading), "{out}");
    for name in ["hall", "stairs", "lamp"] {
        assert!(out.contains(name), "{name} is missing in\n{out}");
    }
    let (_, out, _) = outcome(&["list", &lamp, "--as", "numeric"]);
    assert!(out.starts_with("/ Lamp with two switches\n"), "{out}");
    let svg = empty_folder("listed").join("lamp.svg");
    let (code, _, _) = outcome(&["list", &lamp, "--svg", svg.to_str().unwrap()]);
    assert_eq!(code, 0);
    assert!(fs::read_to_string(svg).unwrap().contains("stairs"));
}

#[test]
fn a_scenario_runs_on_instruction_list() {
    let lamp = file("lamp-run.il", LAMP);
    let scenario = file(
        "lamp-run.toml",
        "about = \"Q1 is on where I1 and I2 differ.\"\ntext = \"0\"\n\
         [[step]]\nat = 0\nset = { I1 = 1 }\nexpect = { Q1 = 1 }\n\
         [[step]]\nat = 1\nset = { I2 = 1 }\nexpect = { Q1 = 0 }\n",
    );
    let (code, out, _) = outcome(&["sim", &lamp, "--scenario", &scenario]);
    assert_eq!(code, 0, "{out}");
    let wrong = file("wrong-run.il", WRONG);
    let (code, out, _) = outcome(&["sim", &wrong, "--scenario", &scenario]);
    assert_eq!(code, 1, "{out}");
    assert!(out.contains("error[IL-"), "{out}");
}

#[test]
fn what_cannot_be_compiled_is_exit_code_2_and_says_why() {
    let lamp = file("lamp-whole.il", LAMP);
    let numeric = file("numeric.txt", "0\n827301\n877901\n");
    #[rustfmt::skip]
    let cases: &[(&[&str], &str)] = &[
        (&["compile"], "error: the following required arguments were not provided:\n  <FILE>"),
        (&["compile", "no-such.il"], "error: no-such.il cannot be read ("),
        (&["compile", &numeric], "error: "),
        (&["compile", &lamp, "-o", "no-such/p.txt"], "error: no-such/p.txt cannot be written: "),
        (&["compile", &lamp, "-o", &lamp], "error: "),
        (&["compile", &lamp, "--lang", "fr"], "error: invalid value 'fr' for '--lang <LANG>'"),
        (&["sim", &lamp], "error: the simulator needs a terminal"),
        (&["monitor", &lamp, "--port", "no-such"], "error: the monitor needs a terminal"),
    ];
    for (arguments, message) in cases {
        let (code, out, err) = outcome(arguments);
        assert_eq!((code, out.as_str()), (2, ""), "{arguments:?}");
        assert!(err.starts_with(message), "{arguments:?}: {err}");
    }
    assert_eq!(fs::read_to_string(&lamp).unwrap(), LAMP, "it is as it was");
    let already = |lang| outcome_in(&["compile", &numeric], lang).2;
    assert!(already("C").ends_with("is numeric code; there is nothing to compile\n"));
    assert!(already("pt").ends_with("já é código numérico; não há o que compilar\n"));
}

#[test]
fn faults_of_the_text_keep_it_from_a_board() {
    let wrong = file("wrong-upload.il", "LD I1\nAND I99\nST Q1\n");
    let (code, out, _) = outcome(&["upload", &wrong, "--port", "no-such"]);
    assert_eq!(code, 1);
    assert!(out.contains("error[IL-"), "{out}");
    let lamp = file("lamp-upload.il", LAMP);
    let (code, out, err) = outcome(&["upload", &lamp, "--port", "no-such"]);
    assert_eq!(code, 2, "{out}{err}");
    assert!(out.contains("4 codes"), "{out}");
}

#[test]
fn a_mounted_card_gets_the_program_and_nothing_else_changes() {
    let lamp = file("lamp-card.il", LAMP);
    let card = empty_folder("card");
    let path = card.to_str().unwrap();
    fs::write(card.join("NOTES.TXT"), "mine").unwrap();
    fs::write(
        card.join("PROGRAM.TXT"),
        "old, and longer than what comes\n".repeat(99),
    )
    .unwrap();
    let (code, out, err) = outcome(&["card", path, &lamp, "--force"]);
    assert_eq!((code, err.as_str()), (0, ""), "{out}");
    assert!(
        out.starts_with(&format!("{lamp}: on {path} as PROGRAM.TXT, ")),
        "{out}"
    );
    let read = |name: &str| fs::read_to_string(card.join(name)).unwrap();
    let compiled = outcome(&["compile", &lamp]).1;
    assert_eq!(read("PROGRAM.TXT"), compiled);
    assert_eq!(read("NOTES.TXT"), "mine");
    assert_eq!(fs::read_dir(&card).unwrap().count(), 2, "no STATE.TXT");

    // Numeric code is copied as it is, with a seal.
    let text = "/ as it is\r\n0\r\n827301\r\n877901\r\n";
    let numeric = file("card.txt", text);
    assert_eq!(outcome(&["card", path, &numeric, "--state"]).0, 0);
    let sealed = read("PROGRAM.TXT");
    let sealed: Vec<&str> = sealed.split_inclusive("\r\n").collect();
    assert_eq!(
        sealed[0],
        "/ as it is [unoclp: length and check sum in the last line]\r\n"
    );
    assert_eq!(sealed[1..4].concat(), "0\r\n827301\r\n877901\r\n");
    assert!(
        sealed[4].starts_with("/ unoclp: ") && sealed.len() == 5,
        "{sealed:?}"
    );
    let sealed = sealed.concat();
    assert!(
        read("STATE.TXT").starts_with("unoclp state"),
        "{}",
        read("STATE.TXT")
    );
    fs::write(card.join("STATE.TXT"), "kept").unwrap();
    let (code, out, _) = outcome(&["card", path, &numeric, "--state"]);
    assert_eq!(code, 0);
    assert!(out.starts_with("STATE.TXT: exists, not changed\n"), "{out}");
    assert_eq!(read("STATE.TXT"), "kept");

    // A program that is wrong leaves the card as it was.
    let wrong = file("wrong-card.il", WRONG);
    assert_eq!(outcome(&["card", path, &wrong]).0, 1);
    assert_eq!(read("PROGRAM.TXT"), sealed);
}

#[test]
fn an_image_of_a_card_is_made_new() {
    let numeric = file("image.txt", "0\n827301\n877901\n");
    let folder = empty_folder("images");
    let path = |name: &str| folder.join(name).to_str().unwrap().to_owned();
    for (name, options) in [("plain.img", &[][..]), ("state.IMG", &["--state"])] {
        let image = path(name);
        let (code, out, err) = outcome(&[&["card", &image, &numeric], options].concat());
        assert_eq!(code, 0, "{out}{err}");
        let mut expected = unoclp_card::image::Image::new(unoclp_card::image::Fat::Fat16).file(
            "PROGRAM.TXT",
            unoclp_program::sealed(&fs::read(&numeric).unwrap()),
        );
        if !options.is_empty() {
            let state = concat!(env!("CARGO_MANIFEST_DIR"), "/../../programs/STATE.TXT");
            expected = expected.file("STATE.TXT", fs::read(state).unwrap());
        }
        assert!(
            fs::read(&image).unwrap() == expected.build().unwrap(),
            "{name}"
        );
    }
    let plain = path("plain.img");
    let before = fs::read(&plain).unwrap();
    let (code, _, err) = outcome(&["card", &plain, &numeric]);
    assert_eq!(code, 2);
    assert!(
        err.contains("exists, but unoclp overwrites only PROGRAM.TXT on a card"),
        "{err}"
    );
    assert!(fs::read(&plain).unwrap() == before);
}

#[test]
fn a_card_that_is_not_there_is_told() {
    let numeric = file("nowhere.txt", "0\n827301\n877901\n");
    let folder = empty_folder("no-card");
    let odd = empty_folder("odd-card");
    fs::create_dir(odd.join("PROGRAM.TXT")).unwrap();
    let path = |name: &str| folder.join(name).to_str().unwrap().to_owned();
    let (unmounted, nowhere) = (path("CARD"), path("no/such.img"));
    #[rustfmt::skip]
    let cases: &[(&[&str], &str)] = &[
        (&["card"], "error: the following required arguments were not provided:\n  <CARD>\n  <FILE>"),
        (&["card", folder.to_str().unwrap()], "error: the following required arguments were not provided:\n  <FILE>"),
        (&["card", folder.to_str().unwrap(), "no-such.txt"], "error: no-such.txt cannot be read ("),
        (&["card", &unmounted, &numeric], "error: the folder "),
        (&["card", &nowhere, &numeric], "error: "),
        (&["card", odd.to_str().unwrap(), &numeric], "error: "),
    ];
    for (arguments, message) in cases {
        let (code, out, err) = outcome(arguments);
        assert_eq!((code, out.as_str()), (2, ""), "{arguments:?}");
        assert!(err.starts_with(message), "{arguments:?}: {err}");
    }
    assert_eq!(
        fs::read_dir(&folder).unwrap().count(),
        0,
        "nothing was made"
    );
    if cfg!(unix) {
        let (code, _, err) = outcome(&["card", "/dev/null", &numeric]);
        assert_eq!(code, 2);
        assert!(
            err.starts_with("error: /dev/null is a device; mount the card"),
            "{err}"
        );
    }
}
