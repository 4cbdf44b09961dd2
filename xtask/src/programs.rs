//! The test programs of the workspace: compiled at once, and run test by test, as many at a time as there
//! are processors.
//!
//! Each test is a process of its own. So its time is known, the longest come first, what it prints stays
//! together, and no processor waits while another program has tests left. `cargo test` runs the same tests.

use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Mutex;
use std::thread;
use std::time::{Duration, Instant};

use anyhow::{Context, Result, ensure};
use serde_json::Value;

use crate::long;
use crate::shell::{self, cargo};

/// The variable that names the firmware to the tests.
pub const FIRMWARE: &str = "UNOCLP_FIRMWARE";
/// How long each test took in the last run.
const TIMES: &str = "target/test-times";
/// How long one takes that is not among the long ones.
const GUESS: Duration = Duration::from_secs(1);

/// A program with the tests of one part of a package.
struct Program {
    /// The package and the part: `unoclp-card it`.
    name: String,
    /// The folder of the package, in which its tests run.
    folder: PathBuf,
    path: PathBuf,
}

/// A test of a [`Program`].
struct Test<'p> {
    program: &'p Program,
    name: String,
}

impl Test<'_> {
    fn full_name(&self) -> String {
        format!("{} {}", self.program.name, self.name)
    }
}

/// How the tests are run.
pub struct Round {
    /// Percent of the rounds of random tests.
    pub percent: u32,
    /// The firmware that the suite runs on, in place of the one that was built.
    pub firmware: Option<PathBuf>,
}

impl Default for Round {
    fn default() -> Round {
        Round {
            percent: 100,
            firmware: None,
        }
    }
}

/// What a test came to.
struct Outcome {
    name: String,
    passed: bool,
    time: Duration,
}

/// Test programs that have been compiled.
pub struct Programs(Vec<Program>);

/// Whether a test is of a package that looks at the firmware that was built, or at what Node runs of the page.
pub fn needs_firmware(name: &str) -> bool {
    ["unoclp-uno-sim ", "xtask "]
        .iter()
        .any(|package| name.starts_with(package))
}

/// Compiles the tests of all that runs on a PC. Those of the packages in `without` are left out.
///
/// # Errors
/// If something does not compile.
pub fn compile() -> Result<Programs> {
    let mut build = cargo();
    build.args([
        "test",
        "--no-run",
        "--message-format=json-render-diagnostics",
    ]);
    build.args(["--workspace", "--exclude=unoclp-firmware"]);
    build.args(["--features=xtask/avr-tools"]);
    let output = build
        .stderr(std::process::Stdio::inherit())
        .output()
        .map_err(|error| shell::not_started(&build, error))?;
    ensure!(output.status.success(), "the tests do not compile");
    let text = String::from_utf8_lossy(&output.stdout);
    let programs: Vec<_> = text.lines().filter_map(program).collect();
    ensure!(!programs.is_empty(), "cargo names no test program");
    Ok(Programs(programs))
}

/// The test program that a line of cargo's messages tells of, if it does.
fn program(line: &str) -> Option<Program> {
    let message: Value = serde_json::from_str(line).ok()?;
    if message["reason"] != "compiler-artifact" || message["profile"]["test"] != true {
        return None;
    }
    let folder = Path::new(message["manifest_path"].as_str()?).parent()?;
    let package = message["package_id"].as_str()?.rsplit(['#', '/']).next()?;
    // `unoclp-card@0.1.0`, or `0.1.0` where the folder has the package's name.
    let package = match package.split_once('@') {
        Some((package, _)) => package,
        None => folder.file_name()?.to_str()?,
    };
    let target = &message["target"];
    let part = match target["kind"][0].as_str()? {
        "lib" => "lib",
        _ => target["name"].as_str()?,
    };
    Some(Program {
        name: format!("{package} {part}"),
        folder: folder.to_owned(),
        path: message["executable"].as_str()?.into(),
    })
}

impl Programs {
    /// Runs the tests that are asked for by their full names, as `unoclp-card it reads::everything`.
    ///
    /// # Errors
    /// If one cannot be run. A test that fails is counted.
    pub fn run(&self, round: &Round, wanted: impl Fn(&str) -> bool) -> Result<Tally> {
        let times = Times::load();
        let mut tests = Vec::new();
        for program in &self.0 {
            tests.extend(program.tests()?);
        }
        for long in long::all() {
            let known = tests.iter().any(|test| test.full_name().ends_with(long));
            ensure!(known, "xtask/src/long.rs names {long}, which is not a test");
        }
        tests.retain(|test| wanted(&test.full_name()));
        // Taken from the end: the longest first.
        tests.sort_by_key(|test| times.of(&test.full_name()));
        let queue = Mutex::new(tests);
        let next = || queue.lock().ok()?.pop();
        let outcomes = Mutex::new(Vec::new());
        let work = || -> Result<()> {
            while let Some(test) = next() {
                let outcome = run(&test, round)?;
                if let Ok(mut outcomes) = outcomes.lock() {
                    outcomes.push(outcome);
                }
            }
            Ok(())
        };
        thread::scope(|scope| -> Result<()> {
            let processors = thread::available_parallelism().map_or(2, usize::from);
            let workers: Vec<_> = (0..processors).map(|_| scope.spawn(work)).collect();
            for worker in workers {
                worker.join().expect("no worker panics")?;
            }
            Ok(())
        })?;
        let outcomes = outcomes.into_inner().unwrap_or_default();
        if round.percent == 100 {
            times.store(&outcomes)?;
        }
        Ok(Tally(outcomes))
    }
}

impl Program {
    fn command(&self) -> Command {
        let mut command = Command::new(&self.path);
        command.current_dir(&self.folder);
        command.env("CARGO_MANIFEST_DIR", &self.folder);
        command
    }

    fn tests(&self) -> Result<Vec<Test<'_>>> {
        let list = shell::output(self.command().args(["--list", "--format=terse"]))
            .with_context(|| format!("{} does not list its tests", self.name))?;
        let names = list.lines().filter_map(|line| line.strip_suffix(": test"));
        let test = |name: &str| Test {
            program: self,
            name: name.to_owned(),
        };
        Ok(names.map(test).collect())
    }
}

/// Runs a test, and shows what it prints.
fn run(test: &Test<'_>, round: &Round) -> Result<Outcome> {
    let mut command = test.program.command();
    command.args(["--exact", &test.name, "--show-output"]);
    command.env("UNOCLP_ROUNDS", round.percent.to_string());
    command.envs(round.firmware.iter().map(|file| (FIRMWARE, file)));
    let start = Instant::now();
    let output = command
        .output()
        .map_err(|error| shell::not_started(&command, error))?;
    let time = start.elapsed();
    let name = test.full_name();
    let stdout = String::from_utf8_lossy(&output.stdout);
    // A name that the program does not know is no failure to it.
    let passed = output.status.success() && stdout.contains("test result: ok. 1 passed");
    let seconds = time.as_secs_f32();
    if passed {
        let printed: String = printed(&stdout)
            .map(|line| format!("                 {line}\n"))
            .collect();
        print!("ok     {seconds:>8.2} s {name}\n{printed}");
    } else {
        let stderr = String::from_utf8_lossy(&output.stderr);
        println!(
            "FAILED {seconds:>8.2} s {name}: {}\n{stdout}{stderr}",
            output.status
        );
    }
    Ok(Outcome { name, passed, time })
}

/// What a test has printed that passed, without the words around it.
fn printed(stdout: &str) -> impl Iterator<Item = &str> {
    stdout
        .lines()
        .skip_while(|line| !line.starts_with("---- "))
        .skip(1)
        .take_while(|line| *line != "successes:")
        .filter(|line| !line.is_empty())
}

/// What all tests came to.
pub struct Tally(Vec<Outcome>);

impl Tally {
    /// With what came later.
    pub fn and(mut self, later: Tally) -> Tally {
        self.0.extend(later.0);
        self
    }

    /// How many tests have passed.
    pub fn passed(&self) -> usize {
        self.0.iter().filter(|outcome| outcome.passed).count()
    }

    /// The names of those that have failed.
    pub fn failed(&self) -> Vec<&str> {
        let failed = self.0.iter().filter(|outcome| !outcome.passed);
        failed.map(|outcome| outcome.name.as_str()).collect()
    }

    /// A line for each of the slowest.
    pub fn slowest(&self, count: usize) -> String {
        let mut times: Vec<_> = self.0.iter().map(|test| (test.time, &test.name)).collect();
        times.sort();
        let slowest = times.iter().rev().take(count);
        slowest
            .map(|(time, name)| format!("{:>8.1} s  {name}\n", time.as_secs_f32()))
            .collect()
    }
}

/// How long tests took, by their full names.
pub struct Times(HashMap<String, Duration>);

impl Times {
    /// Those of the last whole run; none where they cannot be read.
    pub fn load() -> Times {
        let text = fs::read_to_string(shell::root().join(TIMES)).unwrap_or_default();
        let line = |line: &str| {
            let (ms, name) = line.split_once(' ')?;
            Some((name.to_owned(), Duration::from_millis(ms.parse().ok()?)))
        };
        Times(text.lines().filter_map(line).collect())
    }

    /// Whether a test took so long, or longer. Of one that nobody has timed that is not known.
    pub fn took(&self, name: &str, time: Duration) -> bool {
        self.0.get(name).is_some_and(|took| *took >= time)
    }

    /// That of a test that nobody has timed is guessed.
    fn of(&self, name: &str) -> Duration {
        let is_long = || long::all().any(|long| name.ends_with(long));
        let guess = || if is_long() { Duration::MAX } else { GUESS };
        self.0.get(name).copied().unwrap_or_else(guess)
    }

    fn store(mut self, outcomes: &[Outcome]) -> Result<()> {
        self.0
            .extend(outcomes.iter().map(|test| (test.name.clone(), test.time)));
        let line = |(name, time): (&String, &Duration)| format!("{} {name}\n", time.as_millis());
        let text: String = self.0.iter().map(line).collect();
        fs::write(shell::root().join(TIMES), text).with_context(|| format!("cannot write {TIMES}"))
    }
}

#[cfg(test)]
mod tests {
    use super::{printed, program};

    #[test]
    fn a_test_program_has_the_name_of_its_package_and_part() {
        let message = |id: &str, kind: &str, test: bool| {
            format!(
                r#"{{"reason":"compiler-artifact","package_id":"{id}","manifest_path":"/w/card/Cargo.toml",
                "target":{{"kind":["{kind}"],"name":"it"}},"profile":{{"test":{test}}},"executable":"/t/it-1"}}"#
            )
        };
        let named = |line: String| program(&line).map(|program| program.name);
        let id = "path+file:///w/card#unoclp-card@0.1.0";
        assert_eq!(named(message(id, "test", true)).unwrap(), "unoclp-card it");
        assert_eq!(named(message(id, "lib", true)).unwrap(), "unoclp-card lib");
        let id = "path+file:///w/card#0.1.0";
        assert_eq!(named(message(id, "test", true)).unwrap(), "card it");
        assert_eq!(named(message(id, "test", false)), None);
        assert_eq!(named("Compiling unoclp-card".into()), None);
        assert_eq!(named(r#"{"reason":"build-finished"}"#.into()), None);
    }

    #[test]
    fn what_a_test_prints_is_found() {
        let stdout = "\nrunning 1 test\ntest a ... ok\n\nsuccesses:\n\n---- a stdout ----\n3 cases\n4 more\n\n\n\
             successes:\n    a\n\ntest result: ok. 1 passed\n";
        assert_eq!(printed(stdout).collect::<Vec<_>>(), ["3 cases", "4 more"]);
        let silent = "\nrunning 1 test\ntest a ... ok\n\nsuccesses:\n\nsuccesses:\n    a\n";
        assert_eq!(printed(silent).count(), 0);
    }
}
