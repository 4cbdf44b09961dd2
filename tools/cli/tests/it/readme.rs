//! The READMEs say what the tools say of the program that they show, and the picture of the wiring shows every pin.

use crate::common::{empty_folder, outcome_in};
use std::fs;

fn read(name: &str) -> String {
    let path = format!("{}/../../{name}", env!("CARGO_MANIFEST_DIR"));
    fs::read_to_string(path).unwrap()
}

#[test]
fn the_first_program_is_saved_checked_and_drawn_as_shown() {
    for (page, name, lang) in [
        ("README.md", "lamp.txt", "C.UTF-8"),
        ("README.pt-BR.md", "lampada.txt", "pt_BR.UTF-8"),
    ] {
        let text = read(page);
        let blocks: Vec<&str> = text.split("\n```\n").collect();
        let program = blocks
            .iter()
            .find(|block| block.starts_with("0   "))
            .unwrap();
        let (before, _) = text.split_once(program).unwrap();
        assert!(
            before.trim_end().ends_with(&format!("`{name}`:\n\n```")),
            "{page}"
        );

        let path = empty_folder(&format!("readme-{name}")).join(name);
        let file = path.to_str().unwrap();
        fs::write(&path, program).unwrap();
        assert_eq!(outcome_in(&["check", file], lang).0, 0);
        let (_, ladder, _) = outcome_in(&["list", file], lang);
        assert!(
            text.contains(&format!("```\n{ladder}```")),
            "{page}: {ladder}"
        );

        fs::write(&path, program.replace("787600", "787601")).unwrap();
        let (code, out, _) = outcome_in(&["check", file], lang);
        let error = out.split("\n\n").next().unwrap().replace(file, name);
        assert_eq!(code, 1);
        assert!(
            text.contains(&format!("```\n{error}\n```")),
            "{page}: {error}"
        );
    }
}

#[test]
fn the_wiring_shows_all_inputs_the_potentiometer_and_stop() {
    let picture = read("docs/wiring.svg");
    for part in [
        "I1", "I2", "I3", "I4", "I5", "I6", "I7", "I8", "STOP", "10 kΩ",
    ] {
        assert!(picture.contains(&format!(">{part}</text>")), "{part}");
    }
}
