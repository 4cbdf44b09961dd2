//! Each file and folder that a page about the house names in `backticks` is there, from the root or at the end of a path:
//! `device/core/src/isa/table.rs`, `rung.rs`, `tools/exercise/src/*/words.rs`, `src/{words,edit}.rs`.

use std::fs;
use std::path::Path;
use xtask::shell::root;

/// Pages beside the READMEs of floors and rooms.
const PAGES: [&str; 4] = [
    "ARCHITECTURE.md",
    "docs/decisions.md",
    "docs/avr-codegen.md",
    "docs/words.md",
];
/// What is made, and not kept.
const MADE: [&str; 3] = ["target", "node_modules", ".git"];
/// How the names of files end that the pages mean when they name no folder.
const ENDS: [&str; 8] = ["rs", "s", "md", "toml", "ts", "mjs", "c", "hex"];

/// All files and folders from the root, as `device/core/src`, but for what is made.
fn all(folder: &Path, inside: &str, into: &mut Vec<String>) {
    for entry in fs::read_dir(folder).expect("the folder is there") {
        let entry = entry.expect("it can be listed");
        let name = entry.file_name().to_string_lossy().into_owned();
        if MADE.contains(&&*name) {
            continue;
        }
        let inside = match inside {
            "" => name,
            inside => format!("{inside}/{name}"),
        };
        if entry.path().is_dir() {
            all(&entry.path(), &inside, into);
        }
        into.push(inside);
    }
}

/// Whether it names a file or a folder, and not only how names end.
fn is_path(word: &str) -> bool {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "_-./{},*".contains(c);
    let end = word.rsplit_once('.').map(|(_, end)| end);
    let is_file = !word.starts_with('.') && end.is_some_and(|end| ENDS.contains(&end));
    word.chars().all(is_plain)
        && (word.ends_with('/') || is_file)
        && !MADE.iter().any(|made| word.starts_with(made))
}

/// `src/{a,b}.rs` as `src/a.rs` and `src/b.rs`.
fn spelt_out(path: &str) -> Vec<String> {
    match (path.find('{'), path.find('}')) {
        (Some(open), Some(close)) if open < close => path[open + 1..close]
            .split(',')
            .flat_map(|one| spelt_out(&format!("{}{one}{}", &path[..open], &path[close + 1..])))
            .collect(),
        _ => vec![path.trim_end_matches('/').to_owned()],
    }
}

/// Whether a path ends in this one, part by part; `*` is anything within a part.
fn ends_in(path: &str, end: &str) -> bool {
    let is_like = |own: &str, part: &str| match part.split_once('*') {
        Some((first, last)) => own.starts_with(first) && own.ends_with(last),
        None => own == part,
    };
    let mut path = path.rsplit('/');
    end.rsplit('/')
        .all(|part| path.next().is_some_and(|own| is_like(own, part)))
}

/// The paths that a page names.
fn named(page: &str) -> Vec<String> {
    let text = fs::read_to_string(root().join(page)).expect("the page is there");
    let outside: String = text.split("```").step_by(2).collect();
    let words = outside.split('`').skip(1).step_by(2);
    words
        .filter(|word| is_path(word))
        .flat_map(spelt_out)
        .collect()
}

#[test]
fn paths_are_told_from_other_words() {
    for path in ["a/", "b.rs", "a/*/b.rs", "a/{b,c}.s"] {
        assert!(is_path(path), "{path}");
    }
    for other in [
        ".rs",
        "Program",
        "a b/",
        "target/lab/",
        "PROGRAM.TXT",
        "NC-1",
    ] {
        assert!(!is_path(other), "{other}");
    }
    assert_eq!(spelt_out("a/{b,c/d}.s"), ["a/b.s", "a/c/d.s"]);
    assert!(ends_in("a/b/c.rs", "*/c.rs") && !ends_in("ab.rs", "b.rs"));
    assert!(ends_in("a/b.toml", "a/*.toml") && !ends_in("a/b.toml", "c/*"));
}

#[test]
fn each_path_that_a_page_names_is_there() {
    let mut files = Vec::new();
    all(root(), "", &mut files);
    let readmes = files.iter().filter(|file| {
        let is_deep = file.split('/').count() > 3;
        ends_in(file, "README.md") && file.contains('/') && !is_deep
    });
    let pages = readmes
        .map(String::as_str)
        .filter(|page| !page.starts_with("programs/"))
        .chain(PAGES);
    let mut count = 0;
    let mut missing = Vec::new();
    for page in pages {
        for path in named(page) {
            count += 1;
            if !files.iter().any(|file| ends_in(file, &path)) {
                missing.push(format!("{page}: {path}"));
            }
        }
    }
    assert!(count > 150, "{count}");
    assert!(missing.is_empty(), "nowhere: {missing:#?}");
}
