//! What others wrote and unoclp hands out: the npm packages in the page, and the crates in the firmware, the page and
//! the program. `NOTICE` names them with their licences; a test holds it to what is linked and bundled.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, ensure};
use serde_json::Value;

use crate::node;
use crate::shell::{self, cargo, root, say};

/// What people write in `NOTICE` stands before this line.
const MARK: &str = "The lists below are written by `cargo xtask notice`.\n";

/// A package of somebody else's that is part of what is handed out.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Part {
    name: String,
    version: String,
    licence: String,
    folder: PathBuf,
}

/// Where a part is published.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// The registry of Rust's crates.
    Crate,
    /// That of npm's packages.
    Package,
}

/// All of them.
pub struct Parts {
    packages: BTreeSet<Part>,
    crates: BTreeSet<Part>,
}

impl Parts {
    /// Asks esbuild and cargo.
    ///
    /// # Errors
    /// If one of them does not answer, or a package does not say its licence.
    pub fn find() -> Result<Parts> {
        let packages = packages()?;
        let crates = crates()?;
        Ok(Parts { packages, crates })
    }

    /// The lists of `NOTICE`: names and licences. Versions are left to [`Parts::texts`].
    pub fn lists(&self) -> String {
        let mut text = MARK.to_owned();
        text += "\nThe page contains these npm packages:\n\n";
        text += &list(&self.packages);
        text += "\nThe firmware, the page and the program `unoclp` contain Rust's standard library (MIT OR Apache-2.0) and\n";
        text += "these crates, some of them on some systems only:\n\n";
        text += &list(&self.crates);
        text
    }

    /// Of each part where it is published, its name, its version and its licence.
    pub fn all(&self) -> impl Iterator<Item = (Kind, &str, &str, &str)> {
        let packages = self.packages.iter().map(|part| (Kind::Package, part));
        let crates = self.crates.iter().map(|part| (Kind::Crate, part));
        let all = packages.chain(crates);
        all.map(|(kind, part)| (kind, &*part.name, &*part.version, &*part.licence))
    }

    /// Names and licences.
    pub fn licences(&self) -> impl Iterator<Item = (&str, &str)> {
        let all = self.packages.iter().chain(&self.crates);
        all.map(|part| (&*part.name, &*part.licence))
    }

    /// The licences' own texts, as each package brings them.
    ///
    /// # Errors
    /// If a file cannot be read.
    pub fn texts(&self) -> Result<String> {
        let mut text = String::from(
            "The third-party code in unoclp. The source of each part is in the registry of npm or on crates.io, under this\n\
             name and version.\n",
        );
        // A text that many bring stands once.
        let mut told = std::collections::BTreeMap::new();
        for part in self.packages.iter().chain(&self.crates) {
            let Part {
                name,
                version,
                licence,
                folder,
            } = part;
            let line = "=".repeat(78);
            let _ = write!(text, "\n{line}\n{name} {version}: {licence}\n{line}\n");
            for file in licences(folder)? {
                let read = fs::read(&file);
                let bytes = read.with_context(|| format!("cannot read {}", file.display()))?;
                let own = String::from_utf8_lossy(&bytes).trim().replace("\r\n", "\n");
                if let Some(of) = told.get(&own) {
                    let _ = write!(text, "\nThe same text as that of {of}.\n");
                    continue;
                }
                let _ = write!(text, "\n{own}\n");
                told.insert(own, format!("{name} {version}"));
            }
        }
        Ok(text.replace("\r\n", "\n"))
    }
}

/// `cargo xtask notice`: writes the lists in `NOTICE` again.
///
/// # Errors
/// As [`Parts::find`], or if the file cannot be written.
pub fn run() -> Result<()> {
    let file = root().join("NOTICE");
    fs::write(&file, expected(&Parts::find()?)?).context("cannot write NOTICE")?;
    say("wrote NOTICE");
    Ok(())
}

/// `NOTICE` as it has to be: what people wrote in it, and the lists.
///
/// # Errors
/// If there is none.
pub fn expected(parts: &Parts) -> Result<String> {
    let text = fs::read_to_string(root().join("NOTICE")).context("cannot read NOTICE")?;
    let own = text.split_once(MARK).map_or(&*text, |(own, _)| own);
    Ok(format!("{own}{}", parts.lists()))
}

/// A line for each name and licence.
fn list(parts: &BTreeSet<Part>) -> String {
    let lines: BTreeSet<_> = parts
        .iter()
        .map(|part| format!("{:<32} {}\n", part.name, part.licence))
        .collect();
    lines.into_iter().collect()
}

/// What esbuild puts into the page.
fn packages() -> Result<BTreeSet<Part>> {
    node::install()?;
    let mut build = Command::new("node");
    let build = build.current_dir(node::folder());
    let text = shell::output(build.args(["build.mjs", "--packages"]));
    let text = text.context("`node build.mjs --packages` fails in page/web/")?;
    let all: Value = serde_json::from_str(&text).context("packages of the page")?;
    let all = all.as_array().context("packages of the page")?;
    all.iter()
        .map(|part| {
            let folder = node::folder().join(word(part, "folder")?);
            named(part, "licence", folder)
        })
        .collect()
}

/// What is compiled into the firmware, the page's module, and the program with the page in it, on any system: cargo's
/// tree has the features that are on, its metadata the licences.
fn crates() -> Result<BTreeSet<Part>> {
    let mut tree = cargo();
    tree.args(["tree", "--quiet", "--locked", "--target", "all"]);
    tree.args(["--edges", "normal,no-proc-macro", "--prefix", "none"]);
    tree.args(["--format", "{p}", "--features", "unoclp-cli/page"]);
    for package in ["unoclp-cli", "unoclp-bridge", "unoclp-firmware"] {
        tree.args(["--package", package]);
    }
    let tree = shell::output(&mut tree).context("cargo tree fails")?;
    let known = known_crates()?;
    let mut found = BTreeSet::new();
    for line in tree.lines() {
        let mut words = line.split(' ');
        let (Some(name), Some(version)) = (words.next(), words.next()) else {
            continue;
        };
        let version = version.trim_start_matches('v').to_owned();
        found.extend(known.get(&(name.to_owned(), version)).cloned());
    }
    ensure!(!found.is_empty(), "cargo tree names no crate");
    Ok(found)
}

/// The crates of the lock file that are not this workspace's, by name and version.
fn known_crates() -> Result<BTreeMap<(String, String), Part>> {
    let mut metadata = cargo();
    metadata.args(["metadata", "--quiet", "--locked", "--format-version", "1"]);
    metadata.args(["--features", "unoclp-cli/page"]);
    let text = shell::output(&mut metadata).context("cargo metadata fails")?;
    let all: Value = serde_json::from_str(&text).context("cargo metadata")?;
    let all = all["packages"].as_array().context("cargo metadata")?;
    let mut known = BTreeMap::new();
    for part in all.iter().filter(|part| !part["source"].is_null()) {
        let manifest = Path::new(word(part, "manifest_path")?);
        let folder = manifest.parent().context("cargo metadata")?.to_owned();
        let part = named(part, "license", folder)?;
        known.insert((part.name.clone(), part.version.clone()), part);
    }
    Ok(known)
}

fn named(part: &Value, licence: &str, folder: PathBuf) -> Result<Part> {
    let word = |key| word(part, key).map(str::to_owned);
    let (name, version) = (word("name")?, word("version")?);
    let licence = word(licence).with_context(|| format!("{name} does not name its licence"))?;
    Ok(Part {
        name,
        version,
        licence,
        folder,
    })
}

fn word<'a>(part: &'a Value, key: &str) -> Result<&'a str> {
    part[key]
        .as_str()
        .with_context(|| format!("no {key} in {part:.80}"))
}

/// The files of a package that have the text of its licence, in order.
fn licences(folder: &Path) -> Result<Vec<PathBuf>> {
    let entries =
        fs::read_dir(folder).with_context(|| format!("cannot read {}", folder.display()))?;
    let mut found = Vec::new();
    for entry in entries {
        let path = entry?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let name = name.to_lowercase();
        let begins = ["licen", "copying", "copyright", "notice", "unlicense"];
        if path.is_file() && begins.iter().any(|begin| name.starts_with(begin)) {
            found.push(path);
        }
    }
    found.sort();
    Ok(found)
}
