//! The lines in which mutants begin, as if somebody had just written them: cargo-mutants then tries none of other lines.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::fs;
use std::path::Path;

use anyhow::{Context, Result};

use super::kept::Mutant;

/// A change that adds these lines to the rest of their files.
///
/// # Errors
/// If a file cannot be read, or has no such line.
pub fn diff(mutants: &[&Mutant], source: &Path) -> Result<String> {
    let mut files: BTreeMap<&str, BTreeSet<usize>> = BTreeMap::new();
    for mutant in mutants {
        let (file, line) = begins(&mutant.name).with_context(|| mutant.name.clone())?;
        files.entry(file).or_default().insert(line);
    }
    let mut diff = String::new();
    for (file, lines) in files {
        let text = fs::read_to_string(source.join(file)).context(file.to_owned())?;
        change(file, &text, &lines, &mut diff).with_context(|| format!("lines of {file}"))?;
    }
    Ok(diff)
}

/// The file and the line of a mutant.
fn begins(name: &str) -> Option<(&str, usize)> {
    let (file, rest) = name.split_once(':')?;
    Some((file, rest.split_once(':')?.0.parse().ok()?))
}

fn change(file: &str, text: &str, lines: &BTreeSet<usize>, diff: &mut String) -> Option<()> {
    // To a string nothing fails.
    let _ = writeln!(diff, "--- a/{file}\n+++ b/{file}");
    for (before, &line) in lines.iter().enumerate() {
        let at = line.checked_sub(1)?;
        let written = text.lines().nth(at)?;
        let _ = writeln!(diff, "@@ -{},0 +{line},1 @@\n+{written}", at - before);
    }
    Some(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_those_in_which_mutants_begin() {
        assert_eq!(begins("a/b.rs:12:5: replace x"), Some(("a/b.rs", 12)));
        let mut diff = String::new();
        let made = change("f", "one\ntwo\nthree\n", &[1, 3].into(), &mut diff);
        assert_eq!(made, Some(()));
        let wanted = "--- a/f\n+++ b/f\n@@ -0,0 +1,1 @@\n+one\n@@ -1,0 +3,1 @@\n+three\n";
        assert_eq!(diff, wanted);
        assert_eq!(change("f", "one\n", &[2].into(), &mut diff), None);
    }
}
