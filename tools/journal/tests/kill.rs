//! Whoever writes may be killed at any moment: what it has committed is there once, in order, and nothing by half.

use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Command, Stdio};
use unoclp_journal::{File, Sample};

const FILE: &str = "UNOCLP_JOURNAL_FILE";
/// Samples of one commit.
const BATCH: u64 = 7;

/// Counts on from what is there, for so many commits; says after each how far it is. A reader takes half of it.
fn count(path: &Path, commits: usize) {
    let mut file = File::open(path).unwrap();
    file.set_readers(&["half"]).unwrap();
    for _ in 0..commits {
        let next = file.last() + 1;
        let batch: Vec<Sample> = (next..next + BATCH).map(sample).collect();
        let taken = ("half".to_owned(), next / 2);
        file.commit(&batch, &[taken], u64::MAX).unwrap();
        println!("committed {}", file.last());
    }
}

fn sample(number: u64) -> Sample {
    Sample {
        board: "b".into(),
        point: "count".into(),
        at: 0,
        value: Some(number as f64),
    }
}

/// The last number, once all of the file was looked at.
fn looked_at(path: &Path) -> u64 {
    let file = File::open(path).unwrap();
    let entries = file.read(0, usize::MAX).unwrap();
    let numbers: Vec<u64> = entries.iter().map(|entry| entry.number).collect();
    let first = file.place("half").number + 1;
    assert_eq!(numbers, (first..=file.last()).collect::<Vec<_>>());
    let of_itself = |entry: &unoclp_journal::Entry| entry.sample == sample(entry.number);
    assert!(entries.iter().all(of_itself));
    assert_eq!(file.last() % BATCH, 0);
    file.last()
}

/// What is killed below; by itself it counts a little.
#[test]
fn a_writer_counts() {
    match std::env::var_os(FILE) {
        Some(file) => count(Path::new(&file), usize::MAX),
        None => {
            let folder = tempfile::tempdir().unwrap();
            let file = folder.path().join("j");
            count(&file, 3);
            assert_eq!(looked_at(&file), 3 * BATCH);
        }
    }
}

#[test]
fn each_sample_that_was_committed_is_there_once_after_thirty_kills() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("j");
    for kill in 0..30_usize {
        let mut writer = Command::new(std::env::current_exe().unwrap())
            .args(["--exact", "a_writer_counts", "--nocapture"])
            .env(FILE, &file)
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let lines = BufReader::new(writer.stdout.take().unwrap()).lines();
        let committed = lines.map_while(Result::ok).filter_map(|line| {
            let number = line.rsplit_once("committed ")?.1;
            number.parse::<u64>().ok()
        });
        // It is killed after another commit each time, while it is at the next one.
        let last = committed.take(1 + kill % 4).last().unwrap();
        writer.kill().unwrap();
        writer.wait().unwrap();
        assert!(looked_at(&file) >= last, "kill {kill}");
    }
}
