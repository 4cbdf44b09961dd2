//! What is in the journal reaches the history once, though its database is killed again and again.
#![cfg(unix)]

use crate::server::Server;
use std::path::Path;
use std::sync::mpsc::channel;
use std::time::Duration;
use unoclp_history::{Database, Failure, Keeper, Query, Sqlite, Store};
use unoclp_journal::{File, Journal, Policy, Sample};

const POLICY: Policy = Policy {
    every: Duration::from_millis(5),
    bound: u64::MAX,
};
/// It is thinned in another test.
const KEEP: Duration = Duration::from_secs(1 << 40);

fn sample(number: u64) -> Sample {
    Sample {
        board: "b".into(),
        point: "count".into(),
        at: number as i64,
        value: Some(number as f64),
    }
}

fn journal(folder: &Path) -> Journal {
    let file = File::open(&folder.join("j")).unwrap();
    Journal::begin(file, POLICY, &["history"], Box::new(|_| ())).unwrap()
}

fn keeper(
    journal: &Journal,
    database: &Database,
    tell: impl Fn(Option<&Failure>) + Send + 'static,
) -> Keeper {
    let database = database.clone();
    let open = Box::new(move || database.open());
    Keeper::begin(None, open, journal.reader("history"), KEEP, Box::new(tell)).unwrap()
}

fn numbers(store: &mut dyn Store) -> Vec<u64> {
    let query = Query {
        board: "b".into(),
        point: "count".into(),
        from: 0,
        to: i64::MAX,
        step: 0,
        most: usize::MAX,
    };
    let rows = store.rows(&query).unwrap();
    rows.iter().map(|row| row.last.unwrap() as u64).collect()
}

#[test]
fn a_database_that_is_killed_again_and_again_has_each_sample_once() {
    let mut server = Server::new();
    let database = Database::Server(server.database("a"));
    let folder = tempfile::tempdir().unwrap();
    let journal = journal(folder.path());
    let (told, hears) = channel();
    let keeper = keeper(&journal, &database, move |why| {
        // After the end of the test nobody listens.
        let _ = told.send(why.cloned());
    });
    let reader = journal.reader("history");
    let mut next = 0;
    for kill in 0..3 {
        let taken = keeper.state().taken;
        // It is killed while it takes them.
        while keeper.state().taken < taken + 50 {
            // As many as the thread takes.
            if next < reader.last() + 500 {
                journal.put(vec![sample(next)]);
                next += 1;
            }
            std::thread::yield_now();
        }
        server.kill();
        journal.put((next..next + 1_000).map(sample).collect());
        next += 1_000;
        assert!(hears.recv().unwrap().is_some(), "kill {kill}");
        server.begin();
        assert_eq!(hears.recv().unwrap(), None, "kill {kill}");
    }
    journal.end();
    keeper.end();
    let mut store = database.open().unwrap();
    assert_eq!(journal.state().dropped, 0);
    assert!(numbers(&mut *store).into_iter().eq(0..next));
    assert_eq!(store.taken(reader.source()), Ok(Some(next)));
    assert_eq!(reader.dropped(), 0);
}

#[test]
fn a_database_without_room_is_waited_for_and_has_each_sample_once() {
    let server = Server::tight(32);
    let database = Database::Server(server.database("a"));
    let folder = tempfile::tempdir().unwrap();
    let journal = journal(folder.path());
    let (told, hears) = channel();
    let keeper = keeper(&journal, &database, move |why| {
        let _ = told.send(why.cloned());
    });
    journal.put((0..100).map(sample).collect());
    while keeper.state().taken < 100 {
        std::thread::yield_now();
    }
    server.psql(
        "a",
        "CREATE TABLE ballast (t text) WITH (autovacuum_enabled = off)",
    );
    let fills = "DO $$ BEGIN LOOP INSERT INTO ballast SELECT repeat(md5(i::text), 50) FROM generate_series(1, 100) AS i; END LOOP;
        EXCEPTION WHEN disk_full THEN NULL; END $$";
    server.psql("a", fills);
    journal.put((100..20_000).map(sample).collect());
    assert_eq!(hears.recv().unwrap(), Some(Failure::Full));
    assert_eq!(keeper.state().failure, Some(Failure::Full));
    assert!(journal.reader("history").place() < 20_000);
    server.psql("a", "DROP TABLE ballast");
    assert_eq!(hears.recv().unwrap(), None);
    journal.end();
    keeper.end();
    assert_eq!(
        numbers(&mut *database.open().unwrap()),
        (0..20_000).collect::<Vec<_>>()
    );
}

#[test]
fn what_waits_in_the_journal_outlasts_a_restart_of_the_gateway() {
    let folder = tempfile::tempdir().unwrap();
    let away = Database::File(folder.path().join("none/h.db"));
    let first = journal(folder.path());
    let (told, hears) = channel();
    let waiting = keeper(&first, &away, move |why| {
        let _ = told.send(why.cloned());
    });
    first.put((0..500).map(sample).collect());
    assert!(hears.recv().unwrap().is_some());
    first.end();
    waiting.end();
    drop(first);
    std::fs::create_dir(folder.path().join("none")).unwrap();
    let second = journal(folder.path());
    let keeping = keeper(&second, &away, |_| ());
    second.put((500..600).map(sample).collect());
    second.end();
    keeping.end();
    let mut store = away.read().unwrap();
    assert_eq!(numbers(&mut *store), (0..600).collect::<Vec<_>>());
}

#[test]
fn a_journal_that_is_older_than_the_history_loses_nothing_that_comes() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("h.db");
    let first = journal(folder.path());
    let source = first.reader("history").source().to_owned();
    let mut store = Sqlite::open(&path).unwrap();
    let entries: Vec<_> = (0..40)
        .map(|number| unoclp_journal::Entry {
            number: number + 1,
            sample: sample(number),
        })
        .collect();
    store.take(&source, &entries).unwrap();
    drop(store);
    // The journal was put back as it was before it had any of them.
    let keeping = keeper(&first, &Database::File(path.clone()), |_| ());
    let reader = first.reader("history");
    while reader.last() < 40 {
        std::thread::yield_now();
    }
    first.put((40..50).map(sample).collect());
    first.end();
    keeping.end();
    let mut store = Sqlite::read(&path).unwrap();
    assert_eq!(numbers(&mut store), (0..50).collect::<Vec<_>>());
}
