//! A site file of this PC, and the programs that it names.
//!
//! Owns where they are. Must not know what they say.

use crate::messages;
use anyhow::anyhow;
use std::path::{Path, PathBuf};
use unoclp_exercise::scenario::{ProgramFile, Unreadable};
use unoclp_program::shown;
use unoclp_site::{Files, Mistake, Site, read};
use unoclp_words::system;

/// The folder in which a site file stands.
struct Folder(PathBuf);

impl Files for Folder {
    fn bytes(&self, name: &str) -> Result<Vec<u8>, String> {
        let file = ProgramFile::read(&self.0.join(name));
        file.map(|file| file.bytes).map_err(|why| told(&why))
    }
}

fn told(why: &Unreadable) -> String {
    match why {
        Unreadable::System { kind, told } => system(messages::spoken(), *kind, told),
        other => other.text(messages::spoken()),
    }
}

/// The file of this name beside a site file.
pub fn beside(site: &Path, name: &str) -> PathBuf {
    site.parent().unwrap_or(Path::new("")).join(name)
}

/// The site of a file, or all that is wrong with it, in words.
///
/// # Errors
/// Where the file cannot be read.
pub fn open(path: &Path) -> anyhow::Result<Result<Site, Vec<String>>> {
    let name = shown(path);
    let unread = |why: &Unreadable| anyhow!(messages::cannot_read(&name, told(why)));
    let file = ProgramFile::read(path).map_err(|why| unread(&why))?;
    let text = String::from_utf8(file.bytes)
        .map_err(|error| std::io::Error::new(std::io::ErrorKind::InvalidData, error))
        .map_err(|error| unread(&error.into()))?;
    let folder = path.parent().unwrap_or(Path::new(""));
    let site = read(&text, &Folder(folder.to_owned()));
    let told = |mistake: Mistake| mistake.text(&name, messages::spoken());
    Ok(site.map_err(|mistakes| mistakes.into_iter().map(told).collect()))
}
