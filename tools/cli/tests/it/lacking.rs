//! Points of a Mega in a program for a UNO, in every language: told with what the board has, and which board has more.

use std::path::Path;
use std::process::Command;

/// Each in its language: input 24 is output 16.
const FAR: [(&str, &str); 5] = [
    ("far.il", "LD I24\nST Q16\n"),
    (
        "far.st",
        "PROGRAM p VAR far AT %IX2.7 : BOOL; lamp AT %QX1.7 : BOOL; END_VAR lamp := far; END_PROGRAM\n",
    ),
    (
        "far.iscl",
        "BLOCO\n  BOOL far AT %IX24;\n  BOOL lamp AT %QX16;\n  lamp := far;\nEND_BLOCK\n",
    ),
    (
        "far.lce",
        "clp longe\nvar\n  I2.7 = far;\n  Q1.7 = lamp;\nrede A\n  se (far) { aciona lamp; }\nfim\n",
    ),
    ("far.txt", "0\n827324\n877916\n"),
];

/// Whether a program fits a board, and what is said of it in a language.
fn checked(board: &str, file: &Path, lang: &str) -> (bool, String) {
    let output = Command::new(env!("CARGO_BIN_EXE_unoclp"))
        .args(["check", "--board", board])
        .arg(file)
        .env("LC_ALL", lang)
        .output()
        .unwrap();
    let said = [output.stdout, output.stderr].concat();
    (output.status.success(), String::from_utf8(said).unwrap())
}

#[test]
fn a_point_that_the_board_lacks_is_told_with_what_it_has() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    let mut files: Vec<_> = FAR
        .iter()
        .map(|(name, text)| {
            let file = folder.join(name);
            std::fs::write(&file, text).unwrap();
            file
        })
        .collect();
    files.push(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/far.xml"));
    for file in &files {
        let name = file.display();
        let (fits, said) = checked("mega", file, "C");
        assert!(fits, "{name}: {said}");
        assert!(said.contains("pins: I24 Q16"), "{name}: {said}");
        for (lang, has, other) in [
            ("C", "inputs 01 to 08", "the Mega has"),
            ("pt_BR.UTF-8", "entradas 01 a 08", "a placa Mega tem"),
        ] {
            let (fits, said) = checked("uno", file, lang);
            assert!(!fits, "{name}: {said}");
            for part in [has, other] {
                assert!(said.contains(part), "{name}: {said}");
            }
        }
    }
}
