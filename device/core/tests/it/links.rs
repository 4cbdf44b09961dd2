//! Each link of a page leads to a file that is there, and to a heading that it has.

use std::fs;
use std::path::{Path, PathBuf};

/// The pages: in the repository's own folder, in `docs/`, and the README of each other folder.
fn pages() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"))
        .ancestors()
        .nth(2)
        .unwrap();
    let inside = |folder: &Path| {
        let entries = fs::read_dir(folder).unwrap();
        entries.map(|entry| entry.unwrap().path()).collect()
    };
    let all: Vec<PathBuf> = inside(root);
    let floors = all
        .iter()
        .filter(|path| path.is_dir() && !path.ends_with("target"));
    let rooms = all
        .iter()
        .cloned()
        .chain(floors.flat_map(|floor| inside(floor)));
    let readmes = rooms.map(|folder| folder.join("README.md"));
    let mut pages: Vec<PathBuf> = readmes.filter(|page| page.is_file()).collect();
    pages.extend(all.iter().cloned().chain(inside(&root.join("docs"))));
    pages.retain(|page| page.extension().is_some_and(|end| end == "md"));
    pages
}

/// The lines of a page that are no listing.
fn prose(text: &str) -> impl Iterator<Item = &str> {
    let mut listing = false;
    text.lines().filter(move |line| {
        let fence = line.trim_start().starts_with("```");
        listing ^= fence;
        !listing && !fence
    })
}

/// Where the links of a page lead that stay in the repository: file and heading, either may be empty.
fn links(text: &str) -> Vec<(&str, &str)> {
    let ends = prose(text).flat_map(|line| line.split("](").skip(1));
    let targets = ends.filter_map(|rest| Some(rest.split_once(')')?.0));
    let ours = targets.filter(|target| !target.contains(':') && !target.contains(' '));
    ours.map(|target| target.split_once('#').unwrap_or((target, "")))
        .collect()
}

/// Whether a page has what a link calls `heading`: the words of the heading in small letters, with `-` between.
fn has(text: &str, heading: &str) -> bool {
    let heading = heading.to_lowercase();
    let by_name = [format!("id=\"{heading}\""), format!("name=\"{heading}\"")];
    prose(text).any(|line| {
        let words = line.trim_start_matches('#').trim().to_lowercase();
        let kept = words.replace(' ', "-");
        let kept = kept
            .chars()
            .filter(|c| c.is_alphanumeric() || "-_".contains(*c));
        let small = line.to_lowercase();
        (line.starts_with('#') && kept.eq(heading.chars()))
            || by_name.iter().any(|name| small.contains(name))
    })
}

#[test]
fn every_link_between_pages_leads_somewhere() {
    let pages = pages();
    let (mut dead, mut count) = (Vec::new(), 0);
    for page in &pages {
        let text = fs::read_to_string(page).unwrap();
        for (file, heading) in links(&text) {
            let to = match file {
                "" => page.clone(),
                _ => page.parent().unwrap().join(file),
            };
            let target = fs::read_to_string(&to);
            let is_page = to.extension().is_some_and(|end| end == "md");
            let leads = to.exists()
                && (heading.is_empty() || !is_page || has(&target.unwrap_or_default(), heading));
            count += 1;
            if !leads {
                dead.push(format!("{}: {file}#{heading}", page.display()));
            }
        }
    }
    assert!(dead.is_empty(), "these lead nowhere:\n{}", dead.join("\n"));
    assert!(
        pages.len() > 40 && count > 400,
        "{} pages, {count} links",
        pages.len()
    );
}

#[test]
fn a_dead_link_is_found() {
    let text = "# The one page\n[a](b.md#c) ![p](p.svg)\n```\n[x](y)\n```\n[w](https://w) [i](#the-one-page)";
    assert_eq!(
        links(text),
        [("b.md", "c"), ("p.svg", ""), ("", "the-one-page")]
    );
    assert!(has(text, "the-one-page") && !has(text, "the-one"));
}
