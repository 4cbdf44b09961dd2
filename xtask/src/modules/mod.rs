//! `cargo xtask modules`: circles of modules, file by file.
//!
//! A file needs another one if a path in its code names something that the other one defines. A re-export is no
//! need of its own: whoever uses the name needs the file that defines it. A call of a method needs its type
//! alone, and tests need what they like.

mod names;
mod source;

use std::collections::BTreeMap;
use std::fmt;
use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use petgraph::algo::tarjan_scc;
use petgraph::graphmap::DiGraphMap;

use crate::shell;

/// Files that need each other, directly or by way of others among them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Circle {
    /// Which, in alphabetical order.
    pub files: Vec<PathBuf>,
    /// Why: each file of them that needs another one.
    pub needs: Vec<Need>,
}

/// A file needs another one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Need {
    /// The one that needs.
    pub from: PathBuf,
    /// The one that is needed.
    pub to: PathBuf,
    /// A path in the code that shows it.
    pub path: String,
}

/// The files, and below them why.
impl fmt::Display for Circle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let files: Vec<_> = self.files.iter().map(|file| file.display()).collect();
        write!(f, "a circular dependency of {} files:", files.len())?;
        for file in files {
            write!(f, " {file}")?;
        }
        for Need { from, to, path } in &self.needs {
            write!(f, "\n  {} → {}: {path}", from.display(), to.display())?;
        }
        Ok(())
    }
}

/// Shows the circles of each crate of the workspace.
///
/// # Errors
/// As [`circles`].
pub fn run() -> Result<()> {
    for root in roots()? {
        let circles = circles(&root)?;
        let root = root.strip_prefix(shell::root()).unwrap_or(&root);
        let number = match circles.len() {
            0 => "no circle".to_owned(),
            1 => "one circle".to_owned(),
            number => format!("{number} circles"),
        };
        println!("{}: {number}", root.display());
        for circle in circles {
            println!("{circle}");
        }
    }
    Ok(())
}

/// The root files of the libraries and programs in the folders of the workspace.
///
/// # Errors
/// If a folder cannot be read.
pub fn roots() -> Result<Vec<PathBuf>> {
    let floors = folders(shell::root())?;
    let mut rooms = floors.clone();
    for floor in floors.iter().filter(|floor| !floor.ends_with("target")) {
        rooms.extend(folders(floor)?);
    }
    let sources = rooms.iter().map(|room| room.join("src"));
    let mut roots: Vec<PathBuf> = sources
        .flat_map(|source| ["lib.rs", "main.rs"].map(|name| source.join(name)))
        .collect();
    roots.retain(|root| root.is_file());
    roots.sort();
    Ok(roots)
}

/// The folders in a folder.
fn folders(folder: &Path) -> Result<Vec<PathBuf>> {
    let entries = fs::read_dir(folder)?.map(|entry| Ok(entry?.path()));
    let mut paths = entries.collect::<Result<Vec<_>>>()?;
    paths.retain(|path| path.is_dir());
    Ok(paths)
}

/// The circles of the crate with this root file, whose folder all paths begin in.
///
/// # Errors
/// If a file of a module cannot be read, or is no Rust.
pub fn circles(root: &Path) -> Result<Vec<Circle>> {
    let parts = root.parent().zip(root.file_name());
    let (folder, file) = parts.context("a root file lies in a folder")?;
    circles_of(Path::new(file), |path| {
        fs::read_to_string(folder.join(path)).ok()
    })
}

/// The circles of a crate, by its root file and what gives the text of a file.
fn circles_of(root: &Path, read: impl Fn(&Path) -> Option<String>) -> Result<Vec<Circle>> {
    let modules = source::read(root, read)?;
    let needs: BTreeMap<(usize, usize), String> = names::needs(&modules);
    let graph: DiGraphMap<usize, ()> = needs.keys().copied().collect();
    let file = |index: usize| modules.files[index].clone();
    let mut circles: Vec<_> = tarjan_scc(&graph)
        .into_iter()
        .filter(|circle| circle.len() > 1)
        .map(|circle| {
            let mut files: Vec<_> = circle.iter().copied().map(file).collect();
            files.sort();
            let inside = needs
                .iter()
                .filter(|((from, to), _)| circle.contains(from) && circle.contains(to));
            let needs = inside
                .map(|(&(from, to), path)| Need {
                    from: file(from),
                    to: file(to),
                    path: path.clone(),
                })
                .collect();
            Circle { files, needs }
        })
        .collect();
    circles.sort_by(|a, b| a.files.cmp(&b.files));
    Ok(circles)
}

#[cfg(test)]
mod tests;
