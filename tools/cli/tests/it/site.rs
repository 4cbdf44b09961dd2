//! `unoclp site check`.

use crate::common::{empty_folder, outcome, outcome_in};
use std::fs;

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
            "page: http://127.0.0.1:8420/, for this PC alone\nline /dev/ttyACM0: 115200"
        ),
        "{said}"
    );
    assert!(
        said.contains("    program lamp.st: its names (1) hold while the board keeps check sum "),
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
