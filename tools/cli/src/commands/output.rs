//! Files that a command writes. What stands there already is overwritten only if it is of the same kind, and never if
//! the command reads it.

use anyhow::{anyhow, bail};
use std::fs::{self, File};
use std::io::{self, Read};
use std::path::Path;
use unoclp_cli::messages;
use unoclp_source::is_numeric;

/// What a file holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A drawing as SVG.
    Drawing,
    /// A trace as VCD.
    Trace,
    /// A program in numeric code.
    Program,
    /// A page for a browser.
    Page,
}

/// As much of a file as tells its kind.
const HEAD: u64 = 1 << 16;

impl Kind {
    /// Whether a file that begins so is of this kind. One that holds nothing is of every kind.
    fn is_of(self, head: &[u8]) -> bool {
        let text = String::from_utf8_lossy(head);
        let text = text.trim_start_matches('\u{FEFF}').trim_start();
        text.is_empty()
            || match self {
                Kind::Drawing => {
                    text.starts_with("<svg") || text.starts_with("<?xml") && text.contains("<svg")
                }
                // All that a trace begins with (IEEE 1364, section 18.2.3).
                Kind::Trace => ["$version", "$date", "$comment", "$timescale"]
                    .iter()
                    .any(|word| text.starts_with(word)),
                Kind::Program => is_numeric(head),
                Kind::Page => {
                    let start = text.get(..15).unwrap_or(text).to_ascii_lowercase();
                    start.starts_with("<!doctype html") || start.starts_with("<html")
                }
            }
    }

    fn name(self) -> String {
        match self {
            Kind::Drawing => messages::a_drawing(),
            Kind::Trace => messages::a_trace(),
            Kind::Program => messages::a_program(),
            Kind::Page => messages::a_page(),
        }
    }
}

/// Opens a file to write something of this kind; the command reads `inputs`.
///
/// # Errors
/// As [`may_write`], or if it cannot be written.
pub fn create(path: &Path, kind: Kind, inputs: &[&Path]) -> anyhow::Result<File> {
    may_write(path, kind, inputs)?;
    File::create(path).map_err(cannot_write(path))
}

/// Whether a file takes something of this kind; the command reads `inputs`.
///
/// # Errors
/// If it stands there as one of the inputs or as something else, or cannot be read.
pub fn may_write(path: &Path, kind: Kind, inputs: &[&Path]) -> anyhow::Result<()> {
    if inputs.iter().any(|input| is_same(input, path)) {
        bail!(messages::is_read(path.display()));
    }
    // A device or a pipe loses nothing.
    if fs::metadata(path).is_ok_and(|there| there.is_file()) {
        let mut head = Vec::new();
        let there = File::open(path).map_err(cannot_write(path))?;
        there
            .take(HEAD)
            .read_to_end(&mut head)
            .map_err(cannot_write(path))?;
        if !kind.is_of(&head) {
            bail!(messages::is_something_else(path.display(), kind.name()));
        }
    }
    Ok(())
}

/// The error of a file that cannot be written.
pub fn cannot_write(path: &Path) -> impl Fn(io::Error) -> anyhow::Error {
    let name = path.display().to_string();
    move |error| anyhow!(messages::cannot_write(&name, messages::io(&error)))
}

/// Whether two names are those of one file.
pub fn is_same(one: &Path, other: &Path) -> bool {
    same_file::is_same_file(one, other).unwrap_or(false)
}
