//! `unoclp site`.

use crate::common::{empty_folder, outcome, outcome_in};
use std::fs;
use std::time::{SystemTime, UNIX_EPOCH};
use unoclp_history::{Sample, Sqlite};

#[test]
fn a_site_file_is_told_or_its_mistakes_are() {
    let folder = empty_folder("site");
    let at = |name: &str| folder.join(name).to_str().unwrap().to_owned();
    fs::write(
        at("lamp.st"),
        "PROGRAM p VAR lamp AT %QX0.0 : BOOL; END_VAR lamp := TRUE; END_PROGRAM\n",
    )
    .unwrap();
    let file = at("site.toml");
    let board = "[[line]]\nport = \"/dev/ttyACM0\"\n[[line.board]]\nname = \"estufa\"\nprogram = \"lamp.st\"\n";
    fs::write(&file, board).unwrap();
    let (code, said, _) = outcome(&["site", "check", &file]);
    assert_eq!(code, 0, "{said}");
    assert!(
        said.starts_with(
            "page: http://127.0.0.1:8420/, for this PC only\nline /dev/ttyACM0: 115200"
        ),
        "{said}"
    );
    assert!(
        said.contains("    program lamp.st: its names (1) apply while the board has the program with checksum "),
        "{said}"
    );

    fs::write(&file, board.replace("lamp.st", "none.st") + "rate = 9600\n").unwrap();
    let (code, said, _) = outcome(&["site", "check", &file]);
    assert_eq!(code, 1);
    let lines: Vec<&str> = said.lines().collect();
    assert!(
        lines[0].starts_with(&format!("{file}:5: the program none.st cannot be read (")),
        "{said}"
    );
    assert!(
        lines[1].starts_with(&format!("{file}:6: there is no key `rate` here")),
        "{said}"
    );
    let (_, said, _) = outcome_in(&["site", "check", &file], "pt_BR.UTF-8");
    assert!(
        said.contains("não foi possível ler o programa none.st (não existe)"),
        "{said}"
    );

    let (code, _, told) = outcome(&["site", "check", &at("none.toml")]);
    assert_eq!(code, 2);
    assert!(told.contains("none.toml cannot be read"), "{told}");
    fs::write(&file, [0xFF, 0xFE]).unwrap();
    let (code, _, told) = outcome_in(&["site", "check", &file], "pt_BR.UTF-8");
    assert_eq!(code, 2);
    assert!(told.contains("não é texto em UTF-8"), "{told}");
    let (code, _, told) = outcome_in(&["site"], "pt_BR.UTF-8");
    assert_eq!(code, 2);
    assert!(
        told.contains("Comandos:") || told.contains("falta indicar"),
        "{told}"
    );
}

#[test]
fn the_history_of_a_point_is_printed_for_a_spreadsheet() {
    let folder = empty_folder("site_history");
    let at = |name: &str| folder.join(name).to_str().unwrap().to_owned();
    let file = at("site.toml");
    let board = "[[line]]\nport = \"/dev/ttyACM0\"\n[[line.board]]\nname = \"estufa\"\n";
    fs::write(&file, board).unwrap();
    let asked = |more: &[&str], lang: &str| {
        outcome_in(
            &[&["site", "history", &file, "estufa.level"], more].concat(),
            lang,
        )
    };
    let (code, _, told) = asked(&[], "C");
    assert_eq!(code, 2);
    assert!(
        told.contains("this site keeps no history; add [history]"),
        "{told}"
    );

    fs::write(
        &file,
        board.to_owned() + "[history]\nstore = \"history.db\"\n",
    )
    .unwrap();
    let (code, _, told) = asked(&[], "C");
    assert_eq!(code, 2);
    assert!(told.contains("history.db cannot be used: "), "{told}");
    let now = SystemTime::now().duration_since(UNIX_EPOCH).unwrap();
    let now = i64::try_from(now.as_millis()).unwrap();
    let sample = |ago: i64, value| Sample {
        board: "estufa".into(),
        point: "level".into(),
        at: now - ago,
        value,
    };
    let mut store = Sqlite::open(&folder.join("history.db")).unwrap();
    let samples = [(7_200_000, Some(1.5)), (1_000, Some(-2.0)), (500, None)];
    store
        .append(&samples.map(|(ago, value)| sample(ago, value)))
        .unwrap();
    let (code, said, _) = asked(&[], "C");
    assert_eq!(code, 0, "{said}");
    let values: Vec<&str> = said
        .lines()
        .map(|line| line.split_once(',').unwrap().1)
        .collect();
    assert_eq!(values, ["least,most,last", "1.5,1.5,1.5", "-2,-2,-2", ",,"]);
    let (_, said, _) = asked(&["--last", "3h", "--step", "30d"], "C");
    assert!(said.ends_with(",-2,1.5,\n"), "{said}");
    let (code, _, told) = asked(&["--last", "soon"], "pt_BR.UTF-8");
    assert_eq!(code, 2);
    assert!(told.contains("soon não é um tempo"), "{told}");
    let (code, _, told) = outcome(&["site", "history", &file, "estufa.flow"]);
    assert_eq!(code, 2);
    assert!(
        told.contains("the history has no point estufa.flow; it has estufa.level"),
        "{told}"
    );
    drop(store);

    fs::write(at("history.db"), "my notes, which are no history").unwrap();
    let (code, _, told) = asked(&[], "pt_BR.UTF-8");
    assert_eq!(code, 2);
    assert!(told.contains("não é um histórico do unoclp"), "{told}");
}

#[test]
fn a_key_is_made_for_a_user_and_the_token_is_shown_once() {
    let (code, said, _) = outcome(&["site", "key", "ana"]);
    assert_eq!(code, 0);
    let token = said.lines().next().unwrap().rsplit_once(' ').unwrap().1;
    assert!(token.starts_with("ana.") && token.len() == 36, "{said}");
    let of_file = said.split_once("\n\n").unwrap().1;
    assert!(
        of_file.contains("role = \"operate\"\nkey = \"$argon2id$"),
        "{said}"
    );
    assert!(!of_file.contains(token));
    let folder = empty_folder("key");
    let file = folder.join("site.toml");
    let board = "[[line]]\nport = \"/dev/ttyACM0\"\n[[line.board]]\nname = \"estufa\"\n";
    fs::write(&file, format!("{board}{of_file}")).unwrap();
    let (code, said, _) = outcome(&["site", "check", file.to_str().unwrap()]);
    assert_eq!(code, 0, "{said}");
    assert!(
        said.contains("user ana: operates, and acknowledges alarms"),
        "{said}"
    );
    let (code, _, told) = outcome(&["site", "key", "a.b"]);
    assert_eq!(code, 2);
    assert!(told.contains("a.b is not a valid user name"), "{told}");
    let (code, _, _) = outcome(&["site", "key", "ana", "--role", "root"]);
    assert_eq!(code, 2);
}
