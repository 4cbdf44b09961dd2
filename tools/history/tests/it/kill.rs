//! Whoever writes may be killed at any moment: what it has committed is there once, and nothing by half.

use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Command, Stdio};
use unoclp_history::{Query, Sqlite, Store};
use unoclp_journal::{Entry, Sample};

const FILE: &str = "UNOCLP_HISTORY_FILE";
/// Samples of one commit.
const BATCH: i64 = 7;

/// Counts on from what is there, for so many commits; says after each how far it is.
fn count(path: &Path, commits: usize) {
    let mut store = Sqlite::open(path).unwrap();
    let mut next = values(path).len() as i64;
    assert_eq!(
        store.taken("s"),
        Ok(Some(next as u64).filter(|next| *next > 0))
    );
    for _ in 0..commits {
        // Some come once more.
        let batch: Vec<Entry> = ((next - 3).max(0)..next + BATCH).map(entry).collect();
        store.take("s", &batch).unwrap();
        next += BATCH;
        println!("committed {next}");
    }
}

fn entry(number: i64) -> Entry {
    Entry {
        number: number as u64 + 1,
        sample: Sample {
            board: "b".into(),
            point: "count".into(),
            at: number,
            value: Some(number as f64),
        },
    }
}

fn values(path: &Path) -> Vec<i64> {
    let query = Query {
        board: "b".into(),
        point: "count".into(),
        from: 0,
        to: i64::MAX,
        step: 0,
        most: usize::MAX,
    };
    let rows = Sqlite::read(path).unwrap().rows(&query).unwrap();
    rows.iter().map(|row| row.last.unwrap() as i64).collect()
}

/// What is killed below; by itself it counts a little.
#[test]
fn a_writer_counts() {
    match std::env::var_os(FILE) {
        Some(file) => count(Path::new(&file), usize::MAX),
        None => {
            let folder = tempfile::tempdir().unwrap();
            let file = folder.path().join("h.db");
            count(&file, 3);
            assert_eq!(values(&file), (0..3 * BATCH).collect::<Vec<_>>());
        }
    }
}

#[test]
fn each_sample_that_was_committed_is_there_once_after_thirty_kills() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("h.db");
    drop(Sqlite::open(&file).unwrap());
    for kill in 0..30_usize {
        let mut writer = Command::new(std::env::current_exe().unwrap())
            .args(["--exact", "kill::a_writer_counts", "--nocapture"])
            .env(FILE, &file)
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let lines = BufReader::new(writer.stdout.take().unwrap()).lines();
        let committed = lines.map_while(Result::ok).filter_map(|line| {
            let number = line.rsplit_once("committed ")?.1;
            number.parse::<i64>().ok()
        });
        // It is killed after another commit each time, while it is at the next one.
        let last = committed.take(1 + kill % 4).last().unwrap();
        writer.kill().unwrap();
        writer.wait().unwrap();
        let values = values(&file);
        let all: Vec<i64> = (0..values.len() as i64).collect();
        assert_eq!(values, all, "kill {kill}");
        assert!(values.len() as i64 >= last, "kill {kill}");
        assert_eq!(values.len() as i64 % BATCH, 0, "kill {kill}");
    }
}
