//! The trace of each machine with its model solution, for ten minutes: a number for all that it is in each millisecond. The
//! page's module gives the same (`page/web/test/page/traces.test.mjs`).

use crate::exercises::files;
use std::fmt::Write;
use std::fs;
use std::path::Path;
use std::thread;
use unoclp_core::Board;
use unoclp_exercise::machine::trace;
use unoclp_host_sim::engine::HostEngine;
use unoclp_plant::read;
use unoclp_program::Written;

/// Ten minutes, ms.
const SPAN: u64 = 600_000;

#[test]
fn each_machine_has_its_trace() {
    let all = files("plants", &["toml"]);
    assert_eq!(all.len(), 20);
    let traced = |file: &Path| {
        let plant = read(&fs::read_to_string(file).unwrap(), Board::UNO).unwrap();
        let model = file.with_extension("st");
        let name = file.file_stem().unwrap().to_str().unwrap();
        let written = Written::new(name.to_owned(), fs::read(model).unwrap(), plant.board);
        let code = written
            .check(None)
            .unwrap_or_else(|_| panic!("{name}"))
            .code;
        let traced = trace(&plant, &code, &mut HostEngine::new(plant.board), SPAN);
        format!("{name} {:016x}", traced.unwrap())
    };
    let (first, second) = all.split_at(all.len() / 2);
    let lines: Vec<String> = thread::scope(|scope| {
        let part = |files: &[std::path::PathBuf]| -> Vec<String> {
            files.iter().map(|file| traced(file)).collect()
        };
        let other = scope.spawn(move || part(second));
        let mut lines = part(first);
        lines.extend(other.join().unwrap());
        lines
    });
    let mut now = String::new();
    for line in lines {
        writeln!(now, "{line}").unwrap();
    }
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/traces.txt");
    if std::env::var_os("UPDATE").is_some() {
        fs::write(&path, &now).unwrap();
    }
    assert_eq!(
        fs::read_to_string(path).unwrap_or_default(),
        now,
        "UPDATE=1 writes it"
    );
}
