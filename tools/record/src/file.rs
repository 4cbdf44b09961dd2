//! One file: two tables that SQLite itself lets only grow.

use crate::row::{Asked, Deed, Happening, Row};
use rusqlite::{Connection, OpenFlags, params};
use std::path::Path;
use std::time::Duration;
use unoclp_journal::Failure;

/// Marks the file as one of these: `uncr`.
const OURS: i64 = 0x756e_6372;
/// The version of the form. A later one is rejected and left as it is.
const VERSION: i64 = 1;
/// How long another process may hold the file.
const PATIENCE: Duration = Duration::from_secs(5);

const FORM: &str = "
    CREATE TABLE alarm (n INTEGER PRIMARY KEY, at INTEGER NOT NULL, alarm TEXT NOT NULL, change TEXT NOT NULL,
        state TEXT NOT NULL, who TEXT);
    CREATE INDEX alarm_of ON alarm (alarm, n);
    CREATE INDEX alarm_at ON alarm (at);
    CREATE TABLE deed (n INTEGER PRIMARY KEY, at INTEGER NOT NULL, who TEXT NOT NULL, origin TEXT, of TEXT NOT NULL,
        what TEXT NOT NULL, detail TEXT NOT NULL);
    CREATE INDEX deed_at ON deed (at);
    CREATE TRIGGER alarm_stays BEFORE UPDATE ON alarm BEGIN SELECT raise(ABORT, 'this only grows'); END;
    CREATE TRIGGER alarm_is_kept BEFORE DELETE ON alarm BEGIN SELECT raise(ABORT, 'this only grows'); END;
    CREATE TRIGGER deed_stays BEFORE UPDATE ON deed BEGIN SELECT raise(ABORT, 'this only grows'); END;
    CREATE TRIGGER deed_is_kept BEFORE DELETE ON deed BEGIN SELECT raise(ABORT, 'this only grows'); END;
";

/// A file of what happened.
#[derive(Debug)]
pub(crate) struct File(Connection);

impl File {
    /// Opens this file, and creates it if it does not exist.
    ///
    /// # Errors
    /// [`Failure`]; the file is then as it was.
    pub fn open(path: &Path) -> Result<File, Failure> {
        let mut file = Connection::open(path)?;
        file.busy_timeout(PATIENCE)?;
        let is_new = !is_made(&file)?;
        // Nobody who reads waits for who writes; what is committed outlasts a power cut.
        file.pragma_update(None, "journal_mode", "WAL")?;
        file.pragma_update(None, "synchronous", "FULL")?;
        if is_new {
            make(&mut file, &[])?;
        }
        // Says now whether it may be written, not once something has happened.
        file.execute_batch("BEGIN IMMEDIATE; ROLLBACK")?;
        Ok(File(file))
    }

    /// Creates this file as the successor of another, whose last changes of each alarm these are.
    ///
    /// # Errors
    /// [`Failure`].
    pub fn make(path: &Path, before: &[Happening]) -> Result<(), Failure> {
        let mut file = Connection::open(path)?;
        make(&mut file, before)
    }

    /// The same, for reading only, while another process writes.
    ///
    /// # Errors
    /// [`Failure`].
    pub fn read(path: &Path) -> Result<File, Failure> {
        let file = Connection::open_with_flags(path, OpenFlags::SQLITE_OPEN_READ_ONLY)?;
        file.busy_timeout(PATIENCE)?;
        match is_made(&file)? {
            true => Ok(File(file)),
            false => Err(Failure::Foreign),
        }
    }

    /// How large it is, bytes.
    ///
    /// # Errors
    /// [`Failure`].
    pub fn bytes(&self) -> Result<u64, Failure> {
        let number = |name| {
            self.0
                .pragma_query_value(None, name, |row| row.get::<_, i64>(0))
        };
        Ok(u64::try_from(number("page_count")? * number("page_size")?).unwrap_or(0))
    }

    /// How many rows it has.
    ///
    /// # Errors
    /// [`Failure`].
    pub fn count(&self) -> Result<u64, Failure> {
        // None is ever removed, so the last number counts them.
        let sql = "SELECT max(0, ifnull((SELECT max(n) FROM alarm), 0)) + ifnull((SELECT max(n) FROM deed), 0)";
        let count: i64 = self.0.query_row(sql, [], |row| row.get(0))?;
        Ok(u64::try_from(count).unwrap_or(0))
    }

    /// Writes these rows, all or none of them.
    ///
    /// # Errors
    /// [`Failure`]; then nothing has changed.
    pub fn append(&mut self, rows: &[Row]) -> Result<(), Failure> {
        let all = self.0.transaction()?;
        for row in rows {
            match row {
                Row::Alarm(of) => all
                    .prepare_cached("INSERT INTO alarm (at, alarm, change, state, who) VALUES (?, ?, ?, ?, ?)")?
                    .execute(params![of.at, of.alarm, of.change, of.state, of.who])?,
                Row::Deed(of) => all
                    .prepare_cached("INSERT INTO deed (at, who, origin, of, what, detail) VALUES (?, ?, ?, ?, ?, ?)")?
                    .execute(params![of.at, of.who, of.from, of.of, of.what, of.detail])?,
            };
        }
        all.commit()?;
        Ok(())
    }

    /// The last change of each alarm.
    ///
    /// # Errors
    /// [`Failure`].
    pub fn last(&self) -> Result<Vec<Happening>, Failure> {
        let mut rows = self.0.prepare(
            "SELECT at, alarm, change, state, who FROM alarm WHERE n IN (SELECT max(n) FROM alarm GROUP BY alarm) ORDER BY n",
        )?;
        let rows = rows.query_map([], happening)?;
        Ok(rows.collect::<Result<_, _>>()?)
    }

    /// Changes of alarms: the latest, in the order of writing.
    ///
    /// # Errors
    /// [`Failure`].
    pub fn alarms(&self, asked: &Asked) -> Result<Vec<Happening>, Failure> {
        let mut rows = self.0.prepare_cached(
            "SELECT at, alarm, change, state, who FROM
             (SELECT * FROM alarm WHERE n > 0 AND at >= ? AND at < ? ORDER BY n DESC LIMIT ?)
             ORDER BY n",
        )?;
        let rows = rows.query_map(params![asked.from, asked.to, most(asked)], happening)?;
        Ok(rows.collect::<Result<_, _>>()?)
    }

    /// Actions: the latest, in the order of writing.
    ///
    /// # Errors
    /// [`Failure`].
    pub fn deeds(&self, asked: &Asked) -> Result<Vec<Deed>, Failure> {
        let mut rows = self.0.prepare_cached(
            "SELECT at, who, origin, of, what, detail FROM (SELECT * FROM deed WHERE at >= ? AND at < ? ORDER BY n DESC LIMIT ?)
             ORDER BY n",
        )?;
        let rows = rows.query_map(params![asked.from, asked.to, most(asked)], |row| {
            Ok(Deed {
                at: row.get(0)?,
                who: row.get(1)?,
                from: row.get(2)?,
                of: row.get(3)?,
                what: row.get(4)?,
                detail: row.get(5)?,
            })
        })?;
        Ok(rows.collect::<Result<_, _>>()?)
    }
}

/// The tables of a new file. Earlier states of the alarms have numbers below 1.
fn make(file: &mut Connection, before: &[Happening]) -> Result<(), Failure> {
    let form = file.transaction()?;
    form.execute_batch(FORM)?;
    for (n, of) in (0..).map(|at: i64| -at).zip(before.iter().rev()) {
        form.execute(
            "INSERT INTO alarm VALUES (?, ?, ?, ?, ?, ?)",
            params![n, of.at, of.alarm, of.change, of.state, of.who],
        )?;
    }
    form.pragma_update(None, "application_id", OURS)?;
    form.pragma_update(None, "user_version", VERSION)?;
    form.commit()?;
    Ok(())
}

fn happening(row: &rusqlite::Row<'_>) -> Result<Happening, rusqlite::Error> {
    Ok(Happening {
        at: row.get(0)?,
        alarm: row.get(1)?,
        change: row.get(2)?,
        state: row.get(3)?,
        who: row.get(4)?,
    })
}

fn most(asked: &Asked) -> i64 {
    i64::try_from(asked.most).unwrap_or(i64::MAX)
}

/// Whether it is one of these; no: it is empty.
fn is_made(file: &Connection) -> Result<bool, Failure> {
    let tables: i64 = file.query_row("SELECT count(*) FROM sqlite_schema", [], |row| row.get(0))?;
    if tables == 0 {
        return Ok(false);
    }
    let number = |name| file.pragma_query_value(None, name, |row| row.get::<_, i64>(0));
    if number("application_id")? != OURS {
        return Err(Failure::Foreign);
    }
    match number("user_version")? {
        VERSION => Ok(true),
        other => Err(Failure::Version(other)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn deed(at: i64) -> Deed {
        Deed {
            at,
            who: "ana".into(),
            from: Some("10.0.0.7".into()),
            of: "estufa".into(),
            what: "stop".into(),
            detail: String::new(),
        }
    }

    const ALL: Asked = Asked {
        from: i64::MIN,
        to: i64::MAX,
        most: usize::MAX,
    };

    #[test]
    fn what_is_written_stays_whoever_opens_the_file() {
        let folder = tempfile::tempdir().unwrap();
        let mut file = File::open(&folder.path().join("r")).unwrap();
        let came = Happening {
            at: 1,
            alarm: "hot".into(),
            change: "came".into(),
            state: "active".into(),
            who: None,
        };
        file.append(&[Row::Alarm(came), Row::Deed(deed(1))])
            .unwrap();
        for change in [
            "UPDATE deed SET who = 'eva'",
            "DELETE FROM deed",
            "UPDATE alarm SET at = 0",
            "DELETE FROM alarm",
            "INSERT OR REPLACE INTO deed SELECT n, at, 'eva', origin, of, what, detail FROM deed",
        ] {
            file.0
                .pragma_update(None, "recursive_triggers", true)
                .unwrap();
            assert!(file.0.execute_batch(change).is_err(), "{change}");
        }
        assert_eq!(file.deeds(&ALL).unwrap(), [deed(1)]);
    }

    #[test]
    fn where_the_disk_is_full_nothing_is_written_by_half() {
        let folder = tempfile::tempdir().unwrap();
        let mut file = File::open(&folder.path().join("r")).unwrap();
        file.append(&[Row::Deed(deed(1))]).unwrap();
        let limit = |file: &File, pages: i64| {
            let set = format!("PRAGMA max_page_count({pages})");
            file.0.query_row(&set, [], |_| Ok(())).unwrap();
        };
        limit(&file, 1);
        let many: Vec<Row> = (2..3_000).map(|at| Row::Deed(deed(at))).collect();
        assert_eq!(file.append(&many), Err(Failure::Full));
        assert_eq!(file.deeds(&ALL).unwrap().len(), 1);
        limit(&file, 1_000_000);
        file.append(&many).unwrap();
        let last = file.deeds(&Asked { most: 2, ..ALL }).unwrap();
        assert_eq!(last, [deed(2_998), deed(2_999)]);
    }
}
