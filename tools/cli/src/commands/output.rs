//! Files that a command writes: whole or not at all, and over none that is not unoclp's own.
//!
//! A file is written beside its place, reaches the disk, and takes its place then: where that fails, on a full disk or a
//! card that is pulled out, the old file is there as it was. Owns that way, and the marks by which own files are known.

use crate::messages;
use anyhow::{anyhow, bail};
use clap::Args;
use std::fs::{self, File};
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};
use tempfile::{Builder, NamedTempFile};
use unoclp_program::{is_ours, shown};

/// What may be overwritten.
#[derive(Args, Clone, Copy)]
pub struct Over {
    /// Overwrite an existing file, even if unoclp has not written it
    #[arg(long)]
    force: bool,
}

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
    /// An animated GIF.
    Film,
}

/// The last line of a drawing and of a page: a comment in both.
const MARK: &str = "<!-- unoclp: this file is overwritten without a question -->";

/// More than this of the first and the last bytes of a file is not needed to know whose it is.
const ENDS: u64 = 1 << 10;

impl Kind {
    /// Whether unoclp has written a file that begins and ends so, as one of this kind.
    fn is_own(self, head: &str, tail: &str) -> bool {
        match self {
            Kind::Drawing | Kind::Page => {
                let is_page = head.trim_start().starts_with("<!DOCTYPE");
                tail.trim_end().ends_with(MARK) && is_page == (self == Kind::Page)
            }
            Kind::Trace => {
                let version = head.trim_start().strip_prefix("$version");
                version.is_some_and(|rest| rest.trim_start().starts_with("unoclp "))
            }
            Kind::Program => is_ours(head.as_bytes()),
            // It is made of a run again each time, and nobody writes into one.
            Kind::Film => head.starts_with("GIF89a"),
        }
    }

    fn name(self) -> String {
        match self {
            Kind::Drawing => messages::a_drawing(),
            Kind::Trace => messages::a_trace(),
            Kind::Program => messages::a_program(),
            Kind::Page => messages::a_page(),
            Kind::Film => messages::a_film(),
        }
    }

    /// The same content with the mark of this kind; a program and a trace have theirs in themselves.
    fn marked(self, content: Vec<u8>) -> Vec<u8> {
        match self {
            Kind::Drawing | Kind::Page => {
                let line_end: &[u8] = if content.ends_with(b"\n") { b"" } else { b"\n" };
                [&content, line_end, MARK.as_bytes(), b"\n"].concat()
            }
            Kind::Trace | Kind::Program | Kind::Film => content,
        }
    }
}

/// Writes a file of this kind; the command reads `inputs`.
///
/// # Errors
/// As [`may_write`], or if it cannot be written: what was there is there still.
pub fn write(
    path: &Path,
    content: Vec<u8>,
    kind: Kind,
    inputs: &[&Path],
    over: Over,
) -> anyhow::Result<()> {
    let mut draft = Draft::new(path, kind, inputs, over)?;
    draft
        .file
        .write_all(&kind.marked(content))
        .map_err(cannot_write(path))?;
    draft.finish()
}

/// Writes a file as it is, over nothing that is there.
///
/// # Errors
/// If something is there, or the file cannot be written.
pub fn write_new(path: &Path, content: &[u8]) -> anyhow::Result<()> {
    if fs::symlink_metadata(path).is_ok() {
        bail!(messages::is_there(shown(path)));
    }
    let written = (|| {
        let mut draft = Draft::beside(path)?;
        draft.file.write_all(content)?;
        draft.place()
    })();
    written.map_err(cannot_write(path))
}

/// Whether a file takes something of this kind; the command reads `inputs`.
///
/// # Errors
/// If it is there as one of the inputs, or is not unoclp's own, or cannot be read.
pub fn may_write(path: &Path, kind: Kind, inputs: &[&Path], over: Over) -> anyhow::Result<()> {
    if inputs.iter().any(|input| is_same(input, path)) {
        bail!(messages::is_read(shown(path)));
    }
    // A device or a pipe loses nothing.
    let there = fs::metadata(path).ok().filter(fs::Metadata::is_file);
    let Some(there) = there.filter(|there| there.len() > 0 && !over.force) else {
        return Ok(());
    };
    let (head, tail) = ends(path, there.len()).map_err(cannot_write(path))?;
    if !kind.is_own(&head, &tail) {
        bail!(messages::is_something_else(shown(path), kind.name()));
    }
    Ok(())
}

/// The first and the last bytes of a file of this length.
fn ends(path: &Path, length: u64) -> io::Result<(String, String)> {
    use io::{Seek, SeekFrom};
    let mut file = File::open(path)?;
    let mut read = |from| -> io::Result<String> {
        let mut bytes = Vec::new();
        file.seek(SeekFrom::Start(from))?;
        (&file).take(ENDS).read_to_end(&mut bytes)?;
        Ok(String::from_utf8_lossy(&bytes).into_owned())
    };
    Ok((read(0)?, read(length.saturating_sub(ENDS))?))
}

/// A file that is being written. Without [`Draft::finish`] nothing has happened.
pub struct Draft {
    /// What the command was asked to write.
    path: PathBuf,
    file: File,
    /// Where it stands until then, and the place that it takes; none of a device, which is written to as it is.
    beside: Option<(NamedTempFile, PathBuf)>,
}

impl Draft {
    /// Begins a file of this kind; the command reads `inputs`.
    ///
    /// # Errors
    /// As [`may_write`], or if nothing can be written there.
    pub fn new(path: &Path, kind: Kind, inputs: &[&Path], over: Over) -> anyhow::Result<Draft> {
        may_write(path, kind, inputs, over)?;
        Draft::beside(path).map_err(cannot_write(path))
    }

    fn beside(path: &Path) -> io::Result<Draft> {
        let there = fs::metadata(path).ok();
        if there.as_ref().is_some_and(|there| !there.is_file()) {
            return Ok(Draft {
                path: path.to_owned(),
                file: File::options().write(true).open(path)?,
                beside: None,
            });
        }
        // A link stays one: what it leads to is written again.
        let place = match there {
            Some(_) => fs::canonicalize(path)?,
            None => path.to_owned(),
        };
        let folder = place.parent().filter(|folder| *folder != Path::new(""));
        let mut builder = Builder::new();
        builder.prefix(".unoclp-").suffix(".tmp");
        #[cfg(unix)]
        {
            // As any new file, less what the user's mask takes.
            use std::os::unix::fs::PermissionsExt;
            builder.permissions(fs::Permissions::from_mode(0o666));
        }
        let folder = folder.unwrap_or(Path::new("."));
        fs::metadata(folder)?;
        // Told without the name of the file beside, which nobody knows.
        let beside = builder.tempfile_in(folder);
        let beside = beside.map_err(|error| io::Error::from(error.kind()))?;
        let file = beside.as_file().try_clone()?;
        if let Some(there) = there {
            // A card has none to be kept.
            let _ = file.set_permissions(there.permissions());
        }
        Ok(Draft {
            path: path.to_owned(),
            file,
            beside: Some((beside, place)),
        })
    }

    /// What writes into it.
    ///
    /// # Errors
    /// Those of the system.
    pub fn writer(&self) -> io::Result<File> {
        self.file.try_clone()
    }

    /// Puts the file into its place, once all of it has reached the disk.
    ///
    /// # Errors
    /// If it cannot be written: what was there is there still.
    pub fn finish(self) -> anyhow::Result<()> {
        let path = self.path.clone();
        self.place().map_err(cannot_write(&path))
    }

    fn place(mut self) -> io::Result<()> {
        self.file.flush()?;
        let Some((beside, place)) = self.beside else {
            return Ok(());
        };
        self.file.sync_all()?;
        drop(self.file);
        beside.persist(&place)?;
        // That it has its name now reaches the disk too, where a folder can be told to; the card may be pulled out then.
        if let Some(folder) = place.parent().and_then(|folder| File::open(folder).ok()) {
            let _ = folder.sync_all();
        }
        Ok(())
    }
}

/// The error of a file that cannot be written.
pub fn cannot_write(path: &Path) -> impl Fn(io::Error) -> anyhow::Error {
    let name = shown(path);
    move |error| anyhow!(messages::cannot_write(&name, messages::io(&error)))
}

/// Whether two names are those of one file.
pub fn is_same(one: &Path, other: &Path) -> bool {
    same_file::is_same_file(one, other).unwrap_or(false)
}
