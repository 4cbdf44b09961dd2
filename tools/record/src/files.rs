//! The files of a record: one that grows, and the one before it. What is older goes, whole.
//!
//! The first has the name of the record; those after it a number more: `site.record`, `site.record.2`, `site.record.3`.

use crate::file::File;
use crate::row::{Asked, Deed, Happening, Row};
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};
use unoclp_journal::Failure;

/// A record that is open to write.
#[derive(Debug)]
pub(crate) struct Files {
    path: PathBuf,
    /// Of the one that grows.
    number: u32,
    file: File,
    /// How large all files may become, bytes.
    bound: u64,
}

impl Files {
    /// Opens the record at this path, and creates it if it does not exist.
    ///
    /// # Errors
    /// [`Failure`]; the files are then as they were.
    pub fn open(path: &Path, bound: u64) -> Result<Files, Failure> {
        let number = last(path);
        Ok(Files {
            path: path.to_owned(),
            number,
            file: File::open(&numbered(path, number))?,
            bound,
        })
    }

    /// Writes these rows, all or none of them. Where the file is then half as large as all may be, another one begins, and
    /// the one before goes. Gives how many rows went with it.
    ///
    /// # Errors
    /// [`Failure`]; then nothing has changed.
    pub fn append(&mut self, rows: &[Row]) -> Result<u64, Failure> {
        self.file.append(rows)?;
        // The rows are written: where there is no room for another file, this one goes on until there is.
        Ok(self.turn().unwrap_or(0))
    }

    /// How large the files are, bytes.
    pub fn bytes(&self) -> u64 {
        let before = before(self.number).map(|at| numbered(&self.path, at));
        let before = before.and_then(|before| fs::metadata(before).ok());
        let grown = self.file.bytes().unwrap_or(0);
        grown.saturating_add(before.map_or(0, |before| before.len()))
    }

    fn turn(&mut self) -> Result<u64, Failure> {
        if self.file.bytes()? < self.bound / 2 {
            return Ok(0);
        }
        let other = |why: std::io::Error| Failure::Other(why.to_string());
        // It gets its name once it is whole.
        let new = with(&self.path, ".new");
        match fs::remove_file(&new) {
            Err(why) if why.kind() != std::io::ErrorKind::NotFound => return Err(other(why)),
            _ => File::make(&new, &self.file.last()?)?,
        }
        let next = numbered(&self.path, self.number + 1);
        fs::rename(&new, &next).map_err(other)?;
        self.file = File::open(&next)?;
        self.number += 1;
        Ok(forget(&self.path, self.number))
    }

    /// The same, for reading only, while another process writes.
    ///
    /// # Errors
    /// [`Failure`].
    pub fn read(path: &Path) -> Result<Reading, Failure> {
        let number = last(path);
        Ok(Reading {
            file: File::read(&numbered(path, number))?,
            // It may go at any moment.
            before: before(number).and_then(|at| File::read(&numbered(path, at)).ok()),
        })
    }
}

/// A record that is read.
#[derive(Debug)]
pub(crate) struct Reading {
    file: File,
    before: Option<File>,
}

impl Reading {
    /// The last change of each alarm.
    ///
    /// # Errors
    /// [`Failure`].
    pub fn last(&self) -> Result<Vec<Happening>, Failure> {
        self.file.last()
    }

    /// Changes of alarms: the latest, in the order of writing.
    ///
    /// # Errors
    /// [`Failure`].
    pub fn alarms(&self, asked: &Asked) -> Result<Vec<Happening>, Failure> {
        self.latest(asked, File::alarms)
    }

    /// Actions: the latest, in the order of writing.
    ///
    /// # Errors
    /// [`Failure`].
    pub fn deeds(&self, asked: &Asked) -> Result<Vec<Deed>, Failure> {
        self.latest(asked, File::deeds)
    }

    fn latest<T>(
        &self,
        asked: &Asked,
        of: impl Fn(&File, &Asked) -> Result<Vec<T>, Failure>,
    ) -> Result<Vec<T>, Failure> {
        let rows = of(&self.file, asked)?;
        let most = asked.most.saturating_sub(rows.len());
        let Some(before) = self.before.as_ref().filter(|_| most > 0) else {
            return Ok(rows);
        };
        let mut all = of(before, &Asked { most, ..*asked })?;
        all.extend(rows);
        Ok(all)
    }
}

/// The number of the last file; 1 where there is none.
fn last(path: &Path) -> u32 {
    numbers(path).max().unwrap_or(1)
}

/// The numbers of the files after the first.
fn numbers(path: &Path) -> impl Iterator<Item = u32> {
    let folder = path
        .parent()
        .filter(|folder| !folder.as_os_str().is_empty());
    let files = fs::read_dir(folder.unwrap_or(Path::new("."))).into_iter();
    let begin = path
        .file_name()
        .map(|name| format!("{}.", name.to_string_lossy()));
    files.flatten().flatten().filter_map(move |file| {
        let name = file.file_name();
        name.to_string_lossy()
            .strip_prefix(begin.as_ref()?)?
            .parse()
            .ok()
    })
}

/// The file before this one, if there was one.
fn before(number: u32) -> Option<u32> {
    number.checked_sub(1).filter(|at| *at > 0)
}

fn numbered(path: &Path, number: u32) -> PathBuf {
    match number {
        0 | 1 => path.to_owned(),
        _ => with(path, &format!(".{number}")),
    }
}

fn with(path: &Path, end: &str) -> PathBuf {
    let mut name = OsString::from(path);
    name.push(end);
    name.into()
}

/// Removes the files that are older than the one before this; gives how many rows they had.
fn forget(path: &Path, number: u32) -> u64 {
    let old = numbers(path).chain([1]).filter(|at| *at + 1 < number);
    let mut rows = 0;
    for old in old.map(|at| numbered(path, at)).collect::<Vec<_>>() {
        let count = File::read(&old).and_then(|file| file.count()).unwrap_or(0);
        // One that cannot be removed now goes with the next.
        if fs::remove_file(&old).is_ok() {
            rows += count;
            // What SQLite has left beside it where somebody was reading it.
            for end in ["-wal", "-shm"] {
                let _ = fs::remove_file(with(&old, end));
            }
        }
    }
    rows
}

#[cfg(test)]
mod tests {
    use super::*;

    fn alarm(at: i64, alarm: &str) -> Row {
        Row::Alarm(Happening {
            at,
            alarm: alarm.into(),
            change: "came".into(),
            state: "active".into(),
            who: None,
        })
    }

    fn deed(at: i64) -> Row {
        Row::Deed(Deed {
            at,
            who: "ana".into(),
            from: Some("10.0.0.7".into()),
            of: "estufa".into(),
            what: "write".into(),
            detail: "target = 25".into(),
        })
    }

    const ALL: Asked = Asked {
        from: i64::MIN,
        to: i64::MAX,
        most: usize::MAX,
    };

    /// The size of the folder, bytes.
    fn bytes(folder: &Path) -> u64 {
        let files = fs::read_dir(folder).unwrap().flatten();
        files.map(|file| file.metadata().unwrap().len()).sum()
    }

    #[test]
    fn all_of_it_stays_in_its_bound_and_the_oldest_goes_and_is_counted() {
        const BOUND: u64 = 400_000;
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("r");
        let mut files = Files::open(&path, BOUND).unwrap();
        files.append(&[alarm(0, "hot")]).unwrap();
        let (mut next, mut gone) = (1, 0);
        while files.number < 6 {
            let rows: Vec<Row> = (next..next + 100).map(deed).collect();
            gone += files.append(&rows).unwrap();
            next += 100;
            assert!(files.bytes() <= BOUND + 30_000, "{}", files.bytes());
            // SQLite has a thousand pages beside it.
            assert!(bytes(folder.path()) <= BOUND + (5 << 20));
            // A process that comes after this one goes on with it.
            if next % 1_000 == 1 {
                drop(files);
                files = Files::open(&path, BOUND).unwrap();
            }
        }
        let read = Files::read(&path).unwrap();
        let deeds = read.deeds(&ALL).unwrap();
        // With the alarm, which was the first.
        assert_eq!(deeds.len() as u64 + gone, next as u64);
        let moments: Vec<i64> = deeds.iter().map(|deed| deed.at).collect();
        assert!(moments.into_iter().eq(gone as i64..next));
        let few = read.deeds(&Asked { most: 3, ..ALL }).unwrap();
        assert_eq!(few.len(), 3);
        // How an alarm stands is known when its row is gone.
        assert_eq!(read.alarms(&ALL).unwrap(), []);
        let last = read.last().unwrap();
        assert_eq!((&*last[0].alarm, &*last[0].state), ("hot", "active"));
    }

    #[test]
    fn a_kill_between_two_files_leaves_a_record_that_goes_on() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("r");
        let mut files = Files::open(&path, 100_000).unwrap();
        // As it was killed before the next file had its name.
        fs::write(folder.path().join("r.new"), "half").unwrap();
        let many = |from: i64, to: i64| (from..to).map(deed).collect::<Vec<_>>();
        for at in 0..30 {
            files.append(&many(at * 100, at * 100 + 100)).unwrap();
        }
        assert!(files.number > 2, "{}", files.number);
        let number = files.number;
        drop(files);
        // And before the oldest was gone.
        File::make(&path, &[]).unwrap();
        let mut files = Files::open(&path, 100_000).unwrap();
        assert_eq!(files.number, number);
        for at in 30..40 {
            files.append(&many(at * 100, at * 100 + 100)).unwrap();
        }
        let deeds = Files::read(&path).unwrap().deeds(&ALL).unwrap();
        assert_eq!(deeds.last().map(|deed| deed.at), Some(3_999));
        assert!(!path.exists());
    }
}
