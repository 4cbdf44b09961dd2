//! The steps of a long task: each is announced, timed, and named where it fails. After that none is begun.

use std::fmt;
use std::process::{Command, ExitStatus, Stdio};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, mpsc};
use std::thread;
use std::time::{Duration, Instant};

use anyhow::{Context, Result, anyhow, ensure};

use crate::count::Count;
use crate::shell::{self, say};

/// The steps taken so far, and how long each took.
#[derive(Default)]
pub struct Steps {
    taken: Mutex<Vec<(String, Duration)>>,
    has_failed: AtomicBool,
}

/// A step is not begun, since another has failed: that error says more.
#[derive(Debug)]
struct LeftOut;

impl fmt::Display for LeftOut {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("another step has failed")
    }
}

impl std::error::Error for LeftOut {}

impl Steps {
    /// Takes a step whose output is shown as it comes.
    ///
    /// # Errors
    /// If the step fails; the text names it. If another has failed, without a word of this one.
    pub fn take<T>(&self, name: &str, work: impl FnOnce() -> Result<T>) -> Result<T> {
        self.timed(name, || {
            say(name);
            work().with_context(|| format!("the step \"{name}\" failed"))
        })
    }

    /// Runs a command whose output is shown in one piece at its end: something else is at work beside it.
    ///
    /// # Errors
    /// As [`Steps::take`].
    pub fn run_aside(&self, name: &str, command: &mut Command) -> Result<()> {
        self.timed(name, || {
            let (_, status) = aside(name, command)?;
            ensure!(status.success(), "the step \"{name}\" failed: {status}");
            Ok(())
        })
    }

    /// Runs tests like [`Steps::run_aside`], and counts them: `counted` knows the lines of their harness. One that fails is
    /// counted, and the step is taken.
    ///
    /// # Errors
    /// As [`Steps::take`] where the command fails and no test has, and if there are none.
    pub fn count_aside(
        &self,
        name: &str,
        command: &mut Command,
        counted: fn(&str) -> Option<Count>,
    ) -> Result<Count> {
        self.timed(name, || {
            let (text, status) = aside(name, command)?;
            let count = Count::of(&text, counted);
            if count.failed > 0 {
                println!("FAILED {name}");
                return Ok(count);
            }
            ensure!(status.success(), "the step \"{name}\" failed: {status}");
            ensure!(count.passed > 0, "the step \"{name}\" ran no test");
            Ok(count)
        })
    }

    fn timed<T>(&self, name: &str, work: impl FnOnce() -> Result<T>) -> Result<T> {
        if self.has_failed.load(Ordering::Relaxed) {
            return Err(LeftOut.into());
        }
        let start = Instant::now();
        let done = work();
        match &done {
            Ok(_) => self.note(name, start.elapsed()),
            Err(_) => self.has_failed.store(true, Ordering::Relaxed),
        }
        done
    }

    fn note(&self, name: &str, time: Duration) {
        say(&format!("{name}: {:.1} s", time.as_secs_f32()));
        let mut taken = self.taken.lock().unwrap_or_else(|error| error.into_inner());
        taken.push((name.to_owned(), time));
    }

    /// A line for each step.
    pub fn table(&self) -> String {
        let taken = self.taken.lock().unwrap_or_else(|error| error.into_inner());
        let line =
            |(name, time): &(String, Duration)| format!("{:>8.1} s  {name}\n", time.as_secs_f32());
        taken.iter().map(line).collect()
    }
}

/// What a command prints, shown in one piece, and how it has ended.
fn aside(name: &str, command: &mut Command) -> Result<(String, ExitStatus)> {
    let output = command
        .stdin(Stdio::null())
        .output()
        .map_err(|error| shell::not_started(command, error))?;
    let bytes = [output.stdout, output.stderr].concat();
    let text = String::from_utf8_lossy(&bytes).into_owned();
    println!("==> {name}\n{}", text.trim_end());
    Ok((text, output.status))
}

/// Does two things at the same time.
///
/// # Errors
/// That of the first, else that of the second, or of the one that failed by itself; both have come to their end then.
pub fn both<T, U: Send>(
    first: impl FnOnce() -> Result<T>,
    second: impl FnOnce() -> Result<U> + Send,
) -> Result<(T, U)> {
    thread::scope(|scope| {
        let second = scope.spawn(second);
        let first = first();
        let second = second.join();
        let second = second.unwrap_or_else(|_| Err(anyhow!("a step panicked")));
        match (first, second) {
            (Ok(first), Ok(second)) => Ok((first, second)),
            (Err(first), Err(second)) if first.is::<LeftOut>() => Err(second),
            (Err(error), _) | (_, Err(error)) => Err(error),
        }
    })
}

/// What one of [`both`] tells the other, once: that something is there.
pub fn gate() -> (Gate, Opened) {
    let (sender, receiver) = mpsc::channel();
    (Gate(sender), Opened(receiver))
}

/// The side that opens it. A gate that is dropped shut never opens.
pub struct Gate(mpsc::Sender<()>);

impl Gate {
    /// Lets the other go on.
    pub fn open(self) {
        // Who has failed waits no longer.
        let _ = self.0.send(());
    }
}

/// The side that waits.
pub struct Opened(mpsc::Receiver<()>);

impl Opened {
    /// Waits until it is open.
    ///
    /// # Errors
    /// If the other side has come to its end without opening it.
    pub fn pass(self) -> Result<()> {
        self.0.recv().map_err(|_| LeftOut.into())
    }
}

#[cfg(test)]
mod tests {
    use std::process::Command;
    use std::sync::atomic::Ordering;

    use anyhow::{Result, bail};

    use super::{Steps, both, gate};
    use crate::count::{self, Count};

    #[test]
    fn what_failed_is_told_and_nothing_is_begun_after_it() {
        let steps = Steps::default();
        let (built, is_built) = gate();
        let done: Result<((), ())> = both(
            || {
                is_built.pass()?;
                steps.take("tests", || panic!("begun"))
            },
            || {
                steps.take("building", || bail!("no compiler"))?;
                built.open();
                Ok(())
            },
        );
        let told = format!("{:#}", done.unwrap_err());
        assert_eq!(told, "the step \"building\" failed: no compiler");
        let more: Result<()> = steps.take("more", || panic!("begun"));
        assert_eq!(more.unwrap_err().to_string(), "another step has failed");
        assert_eq!(steps.table(), "");
    }

    #[test]
    fn a_test_that_fails_is_counted_and_a_command_that_does_is_an_error() {
        let steps = Steps::default();
        let run = |script: &str| {
            let mut shell = Command::new("sh");
            steps.count_aside("tests", shell.args(["-c", script]), count::by_node)
        };
        let counted = |passed, failed| Count { passed, failed };
        assert_eq!(run("echo 'ℹ pass 7'").unwrap(), counted(7, 0));
        let some = run("echo 'ℹ pass 7'; echo 'ℹ fail 2'; exit 1").unwrap();
        assert_eq!(some, counted(7, 2));
        assert_eq!(run("echo 'ℹ pass 1'").unwrap(), counted(1, 0));
        for script in ["true", "echo 'ℹ pass 7'; exit 1"] {
            assert!(run(script).is_err(), "{script}");
            steps.has_failed.store(false, Ordering::Relaxed);
        }
    }

    #[test]
    fn one_waits_for_the_other() {
        let (built, is_built) = gate();
        let order = std::sync::Mutex::new(Vec::new());
        let note = |what| order.lock().unwrap().push(what);
        both(
            || {
                is_built.pass()?;
                note("tests");
                Ok(())
            },
            || {
                note("building");
                built.open();
                Ok(())
            },
        )
        .unwrap();
        assert_eq!(*order.lock().unwrap(), ["building", "tests"]);
    }
}
