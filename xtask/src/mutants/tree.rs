//! The source in which mutants stand: a copy, always in one place. So a batch finds compiled what the one before it has compiled,
//! and nobody meets a changed line in his own source.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result};

use crate::shell::output;

/// Brings the copy up to date: the files that git knows, and new ones that it does not ignore. One that is the same is left
/// alone, so that cargo sees no change.
///
/// # Errors
/// If git lists nothing, or a file cannot be copied.
pub fn refresh(from: &Path, to: &Path) -> Result<()> {
    let mut list = Command::new("git");
    list.args(["ls-files", "-z", "--cached", "--others"]);
    list.arg("--exclude-standard").current_dir(from);
    let listed = output(&mut list).context("git lists no files")?;
    let names = listed.split('\0').filter(|name| !name.is_empty());
    let names: BTreeSet<PathBuf> = names.map(PathBuf::from).collect();
    copy(&names, from, to)
}

fn copy(names: &BTreeSet<PathBuf>, from: &Path, to: &Path) -> Result<()> {
    fs::create_dir_all(to)?;
    for old in files(to)? {
        let name = old.strip_prefix(to)?;
        if !names.contains(name) || !from.join(name).is_file() {
            fs::remove_file(&old).with_context(|| format!("{}", old.display()))?;
        }
    }
    for name in names {
        let (source, copy) = (from.join(name), to.join(name));
        // One that git knows may be gone.
        if !source.is_file() {
            continue;
        }
        let text = fs::read(&source).with_context(|| format!("{}", source.display()))?;
        if fs::read(&copy).is_ok_and(|old| old == text) {
            continue;
        }
        fs::create_dir_all(copy.parent().unwrap_or(to))?;
        fs::copy(&source, &copy).with_context(|| format!("{}", copy.display()))?;
    }
    Ok(())
}

/// All files under a folder.
fn files(folder: &Path) -> Result<Vec<PathBuf>> {
    let mut all = Vec::new();
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        match entry.file_type()?.is_dir() {
            true => all.extend(files(&entry.path())?),
            false => all.push(entry.path()),
        }
    }
    Ok(all)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_copy_is_what_the_source_has_become_and_the_same_file_keeps_its_time() {
        let folder = std::env::temp_dir().join(format!("mutants-{}", std::process::id()));
        let [from, to] = ["from", "to"].map(|name| folder.join(name));
        fs::create_dir_all(from.join("a")).expect("a folder");
        let names = ["a/same", "changed", "gone"].map(PathBuf::from);
        for name in &names {
            fs::write(from.join(name), "1").expect("a file");
        }
        let names = BTreeSet::from(names);
        copy(&names, &from, &to).expect("a copy");
        let time = || fs::metadata(to.join("a/same")).and_then(|data| data.modified());
        let before = time().expect("a time");
        fs::write(from.join("changed"), "2").expect("a file");
        fs::remove_file(from.join("gone")).expect("no file");
        copy(&names, &from, &to).expect("a copy");
        let text = |name: &str| fs::read_to_string(to.join(name)).ok();
        assert_eq!(text("changed").as_deref(), Some("2"));
        assert_eq!(text("gone"), None);
        assert_eq!(time().expect("a time"), before);
        fs::remove_dir_all(&folder).expect("no folder");
    }
}
