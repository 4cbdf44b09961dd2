//! What the tests on the firmware share.
#![allow(dead_code, reason = "each test uses its part")]

use std::path::{Path, PathBuf};
use unoclp_uno_sim::{Program, firmware_elf};

/// The firmware under test.
pub fn firmware() -> Program {
    let elf = firmware_elf().unwrap_or_else(|error| panic!("{error}"));
    Program::read(&elf).unwrap_or_else(|error| panic!("{error}"))
}

/// All scenario files in these folders of the project, in order.
pub fn scenarios(folders: &[&str]) -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
    let mut files = Vec::new();
    for folder in folders {
        let before = files.len();
        collect(&root.join(folder), &mut files);
        assert!(files.len() > before, "no scenarios in {folder}");
    }
    files.sort();
    files
}

fn collect(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            collect(&path, files);
        } else if path
            .extension()
            .is_some_and(|extension| extension == "toml")
        {
            files.push(path);
        }
    }
}
