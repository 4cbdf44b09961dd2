//! Instruction List by its own lowering and by way of the typed tree: the same verdict, the same first message, no more
//! bytes, the same outputs. What still differs stands in `tests/one-list.txt`, and may only become less.

use crate::common::{LARGE, Random, large, plc};
use serde::Deserialize;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use unoclp_core::Image;
use unoclp_lang::{Compiled, Lang, compile_by_tree, compile_older as compile, has_types};

#[derive(Deserialize)]
struct Cases {
    case: Vec<Case>,
}

#[derive(Deserialize)]
struct Case {
    name: String,
    il: String,
}

/// Every text in Instruction List without types that the repository has, by its name.
fn texts() -> BTreeMap<String, String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut texts = BTreeMap::new();
    for path in files(&root.join("tests/cases"), "toml") {
        let file = path.file_stem().unwrap().to_string_lossy().into_owned();
        let cases: Cases = toml::from_str(&fs::read_to_string(&path).unwrap()).unwrap();
        for case in cases.case {
            texts.insert(format!("{file}: {}", case.name), case.il);
        }
    }
    let programs = root.join("../../programs");
    for path in files(&programs, "il") {
        let name = path.strip_prefix(&programs).unwrap().to_string_lossy();
        texts.insert(name.into_owned(), fs::read_to_string(&path).unwrap());
    }
    texts.retain(|_, text| !has_types(text));
    texts
}

fn files(folder: &Path, ending: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            found.extend(files(&path, ending));
        } else if path.extension().is_some_and(|end| end == ending) {
            found.push(path);
        }
    }
    found
}

fn messages(compiled: &Compiled) -> Vec<String> {
    let told = compiled.diagnostics.iter();
    told.map(|d| format!("{} at {}: {}", d.code, d.span.start, d.message(Lang::En)))
        .collect()
}

/// What differs; none of a text of which both say the same.
fn difference(text: &str) -> Option<String> {
    let (old, new) = (compile(text, &large()), compile_by_tree(text, &large()));
    let (before, now) = (messages(&old), messages(&new));
    if old.has_errors() != new.has_errors() || before.first() != now.first() {
        return Some(format!("says {now:?}, not {before:?}"));
    }
    if before != now {
        return Some(format!("also says {now:?}, not {before:?}"));
    }
    let bytes = |of: &Compiled| of.program.as_ref().map(|(p, _)| p.program().stored_bytes());
    if let (Some(before), Some(now)) = (bytes(&old), bytes(&new))
        && now > before
    {
        return Some(format!("takes {now} bytes, not {before}"));
    }
    let (old, new) = (old.file()?, new.file()?);
    let (mut first, mut second) = (vec![0; 6000], vec![0; 6000]);
    let (mut old, mut new) = (plc(&old, &mut first, LARGE), plc(&new, &mut second, LARGE));
    let mut random = Random(7);
    let (mut now, mut inputs) = (0, 0);
    for _ in 0..1500 {
        let expected = old.scan(Image(inputs), now).map(|image| image.0).ok();
        let came = new.scan(Image(inputs), now).map(|image| image.0).ok();
        if expected != came {
            return Some(format!("gives {came:?}, not {expected:?}, after {now} ms"));
        }
        now += random.pick(&[1, 5, 50, 500, 2000]);
        if random.percent(40) {
            inputs ^= 1 << random.below(8);
        }
    }
    None
}

/// The texts that differ still.
fn known() -> Vec<String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let known = fs::read_to_string(root.join("tests/one-list.txt")).unwrap();
    let lines = known.lines().filter(|line| !line.starts_with('#'));
    lines.map(str::to_owned).collect()
}

#[test]
fn both_ways_come_to_the_same() {
    let known = known();
    let texts = texts();
    assert!(texts.len() >= 250, "{}", texts.len());
    let (mut more, mut less) = (Vec::new(), Vec::new());
    for (name, text) in &texts {
        match (difference(text), known.contains(name)) {
            (Some(difference), false) => more.push(format!("{name} {difference}")),
            (None, true) => less.push(name.as_str()),
            _ => {}
        }
    }
    assert!(
        more.is_empty(),
        "{} of {}:\n{}",
        more.len(),
        texts.len(),
        more.join("\n")
    );
    assert!(
        less.is_empty(),
        "take from tests/one-list.txt:\n{}",
        less.join("\n")
    );
}

/// A text that breaks off anywhere has the same verdict both ways, but for what the tree cannot say.
#[test]
fn a_text_that_breaks_off_is_told_the_same() {
    let known = known();
    let mut random = Random(11);
    let mut wrong = Vec::new();
    for (name, text) in texts() {
        if known.contains(&name) {
            continue;
        }
        for _ in 0..6 {
            let ends: Vec<usize> = text.char_indices().map(|(at, _)| at).collect();
            let part = ends.get(random.below(ends.len().max(1))).copied();
            let part = text.get(..part.unwrap_or(0)).unwrap_or_default();
            if has_types(part) {
                continue;
            }
            let (old, new) = (compile(part, &large()), compile_by_tree(part, &large()));
            let lacks = |of: &Compiled| {
                let mut told = of.diagnostics.iter();
                told.any(|d| d.code.to_string() == "ST-117")
            };
            if old.has_errors() != new.has_errors() && !lacks(&new) {
                wrong.push(format!(
                    "{name}: {:?}, not {:?}",
                    messages(&new),
                    messages(&old)
                ));
            }
        }
    }
    assert!(wrong.is_empty(), "{}:\n{}", wrong.len(), wrong.join("\n"));
}
