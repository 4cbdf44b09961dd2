//! The steps of a long task: each is announced, timed, and named where it fails.

use std::process::{Command, Stdio};
use std::sync::Mutex;
use std::thread;
use std::time::{Duration, Instant};

use anyhow::{Context, Result, anyhow, bail, ensure};

use crate::count::Count;
use crate::shell::{self, say};

/// The steps taken so far, and how long each took.
#[derive(Default)]
pub struct Steps {
    taken: Mutex<Vec<(String, Duration)>>,
}

impl Steps {
    /// Takes a step whose output is shown as it comes.
    ///
    /// # Errors
    /// If the step fails; the text names it.
    pub fn take<T>(&self, name: &str, work: impl FnOnce() -> Result<T>) -> Result<T> {
        say(name);
        let start = Instant::now();
        let done = work().with_context(|| format!("the step \"{name}\" failed"))?;
        self.note(name, start.elapsed());
        Ok(done)
    }

    /// Runs a command whose output is shown in one piece at its end: something else is at work beside it.
    ///
    /// # Errors
    /// As [`Steps::take`].
    pub fn run_aside(&self, name: &str, command: &mut Command) -> Result<()> {
        self.aside(name, command).map(drop)
    }

    /// Runs tests like [`Steps::run_aside`], and counts them: `counted` knows the lines of their harness.
    ///
    /// # Errors
    /// As [`Steps::take`], and if there are none.
    pub fn count_aside(
        &self,
        name: &str,
        command: &mut Command,
        counted: fn(&str) -> Option<Count>,
    ) -> Result<Count> {
        let count = Count::of(&self.aside(name, command)?, counted);
        ensure!(count.passed > 0, "the step \"{name}\" ran no test");
        Ok(count)
    }

    /// What a command prints.
    fn aside(&self, name: &str, command: &mut Command) -> Result<String> {
        let start = Instant::now();
        let output = command
            .stdin(Stdio::null())
            .output()
            .map_err(|error| shell::not_started(command, error))?;
        let bytes = [output.stdout, output.stderr].concat();
        let text = String::from_utf8_lossy(&bytes).into_owned();
        println!("==> {name}\n{}", text.trim_end());
        if !output.status.success() {
            bail!("the step \"{name}\" failed: {}", output.status);
        }
        self.note(name, start.elapsed());
        Ok(text)
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

/// Does two things at the same time.
///
/// # Errors
/// That of the first, else that of the second; both have come to their end then.
pub fn both<T, U: Send>(
    first: impl FnOnce() -> Result<T>,
    second: impl FnOnce() -> Result<U> + Send,
) -> Result<(T, U)> {
    thread::scope(|scope| {
        let second = scope.spawn(second);
        let first = first();
        let second = second.join().map_err(|_| anyhow!("a step panicked"));
        Ok((first?, second??))
    })
}
