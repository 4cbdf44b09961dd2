//! How long a millisecond of each shipped plant takes, its rules among it.

use divan::{Bencher, black_box};
use std::fs;
use std::path::Path;
use unoclp_core::{Board, Image};
use unoclp_plant::{Outputs, Run, picture, read};
use unoclp_words::Lang;

fn main() {
    divan::main();
}

/// The names of the shipped plants.
fn names() -> Vec<String> {
    let entries = fs::read_dir(folder()).into_iter().flatten().flatten();
    let names = entries.filter_map(|entry| {
        Some(
            entry
                .file_name()
                .to_str()?
                .strip_suffix(".toml")?
                .to_owned(),
        )
    });
    let mut names: Vec<String> = names.collect();
    names.sort();
    names
}

fn folder() -> &'static Path {
    Path::new(concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../programs/plants"
    ))
}

fn text(name: &str) -> String {
    fs::read_to_string(folder().join(name).with_extension("toml")).unwrap_or_default()
}

/// A thousand steps.
#[divan::bench(args = names())]
fn thousand_steps(bencher: Bencher, name: &str) {
    let Ok(plant) = read(&text(name), Board::UNO) else {
        return;
    };
    let mut run = Run::new(&plant, 1);
    let outputs = Outputs {
        points: Image(0b0101),
        ..Outputs::default()
    };
    bencher.bench_local(|| {
        for _ in 0..1000 {
            black_box(run.step(black_box(&outputs)));
        }
    });
}

#[divan::bench(args = names())]
fn drawn(bencher: Bencher, name: &str) {
    let Ok(plant) = read(&text(name), Board::UNO) else {
        return;
    };
    let run = Run::new(&plant, 1);
    bencher.bench_local(|| picture(black_box(&run), Lang::En));
}
