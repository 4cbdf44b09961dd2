//! The texts that the tests look at: every program of the repository in a language that is compiled.

use std::fs;
use std::path::{Path, PathBuf};
use unoclp_core::Board;
use unoclp_plcopen::export_text;
use unoclp_program::Written;
use unoclp_testing::chart::sketch;

/// A file of the repository as a program for the UNO.
pub fn written(path: &Path) -> Written {
    let name = path.file_name().unwrap().to_string_lossy().into_owned();
    Written::new(name, fs::read(path).unwrap(), Board::UNO)
}

/// A text by the ending of its language.
pub fn text(end: &str, text: &str) -> Written {
    Written::new(format!("text.{end}"), text.as_bytes().to_vec(), Board::UNO)
}

/// All of them.
pub fn all() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../programs");
    let mut found = Vec::new();
    let mut folders = vec![root];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
                continue;
            }
            let end = path.extension().unwrap_or_default();
            if ["st", "scl", "il", "iscl", "lce"]
                .iter()
                .any(|own| end == *own)
            {
                found.push(path);
            }
        }
    }
    found.sort();
    assert!(found.len() > 150, "{}", found.len());
    found
}

/// Projects in PLCopen XML, each with where it is from: those of files, and texts of all kinds as projects.
pub fn projects() -> Vec<(String, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut found = Vec::new();
    for folder in ["tests/it", "../../ladder/plcopen/tests/alike"] {
        for entry in fs::read_dir(root.join(folder)).unwrap() {
            let path = entry.unwrap().path();
            if path.extension().is_some_and(|end| end == "xml") {
                let text = fs::read_to_string(&path).unwrap();
                found.push((path.display().to_string(), text));
            }
        }
    }
    let texts = all()
        .into_iter()
        .filter(|path| path.extension().is_some_and(|end| end == "st"));
    for path in texts.step_by(5) {
        let text = fs::read_to_string(&path).unwrap();
        found.push((path.display().to_string(), export_text(&text, "text")));
    }
    assert!(found.len() > 20, "{}", found.len());
    found
}

/// A random chart as such a project.
pub fn chart(seed: u64) -> (String, String) {
    let text = sketch(seed).text(seed.is_multiple_of(2));
    (format!("chart {seed}"), export_text(&text, "chart"))
}

/// Whether both are the same program, or none.
pub fn alike(one: &Written, other: &Written) -> bool {
    match (one.clone().check(None), other.clone().check(None)) {
        (Ok(one), Ok(other)) => one.program().stored() == other.program().stored(),
        (one, other) => one.is_ok() == other.is_ok(),
    }
}
