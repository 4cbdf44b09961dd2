//! What came of a scenario, as text that a student can read.

use super::Refusal;
use std::fmt;
use unoclp_core::{Cause, Image, Millis, Point};

/// What came of a scenario on an engine. Its `Display` is the timeline, then `PASS` or `FAIL`.
#[derive(Clone, Debug)]
pub struct Report {
    /// The path of the scenario.
    pub scenario: String,
    /// What the scenario shows.
    pub about: String,
    /// What the program is called.
    pub program: String,
    /// The scans at which an input or output changed; the first scan is always among them.
    pub changes: Vec<Change>,
    /// Whether the engine did as expected.
    pub verdict: Verdict,
}

/// Inputs and outputs from this scan on, until the next change.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Change {
    /// ms after the first scan.
    pub at: Millis,
    /// The inputs that the scan saw.
    pub inputs: Image,
    /// The outputs as the scan left them.
    pub outputs: Image,
}

/// How an engine did in a scenario.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Every expectation was met in every scan.
    Met {
        /// How many times an output was compared with what was expected of it.
        comparisons: u64,
    },
    /// The program was refused as expected.
    Refused(Refusal),
    /// Some expectations were not met, in the order of time.
    Unmet(Vec<Unmet>),
    /// The program was refused, or run, against what was expected.
    WrongRefusal {
        /// The refusal expected; none where the program should run.
        expected: Option<Refusal>,
        /// The engine's refusal; none where the program ran.
        came: Option<Refusal>,
    },
    /// The engine itself could not go on.
    Broken {
        /// The scan, in ms after the first; none while the program was loaded.
        at: Option<Millis>,
        /// What the engine says.
        reason: String,
    },
}

/// An output that was not as expected, in one scan or several that follow each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Unmet {
    /// The output.
    pub output: Point,
    /// What was expected of it; the other came.
    pub expected: bool,
    /// The first of the scans, in ms after the first scan of all.
    pub from: Millis,
    /// The last of them.
    pub to: Millis,
}

impl Unmet {
    pub(super) fn new(output: Point, expected: bool, at: Millis) -> Unmet {
        Unmet {
            output,
            expected,
            from: at,
            to: at,
        }
    }
}

/// More expectations that were not met than this are only counted.
const UNMET_SHOWN: usize = 8;

impl Report {
    /// Whether the engine did everything as expected.
    pub fn passed(&self) -> bool {
        matches!(self.verdict, Verdict::Met { .. } | Verdict::Refused(_))
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}: {}", self.scenario, self.about)?;
        writeln!(f, "program: {}", self.program)?;
        if !self.changes.is_empty() {
            writeln!(f)?;
            timeline(f, &self.changes)?;
            writeln!(f)?;
        }
        self.verdict.fmt(f)
    }
}

/// One line for each change, under the names of the points.
fn timeline(f: &mut fmt::Formatter<'_>, changes: &[Change]) -> fmt::Result {
    write!(f, "{:>10}", "ms")?;
    super::inputs().try_for_each(|point| write!(f, "  I{}", point.number()))?;
    f.write_str("  ")?;
    super::outputs().try_for_each(|point| write!(f, "  Q{}", point.number()))?;
    writeln!(f, "    1 = closed, on; · = open, off")?;
    for change in changes {
        write!(f, "{:>10}", change.at)?;
        super::inputs().try_for_each(|point| state(f, change.inputs.get(point)))?;
        f.write_str("  ")?;
        super::outputs().try_for_each(|point| state(f, change.outputs.get(point)))?;
        writeln!(f)?;
    }
    Ok(())
}

fn state(f: &mut fmt::Formatter<'_>, state: bool) -> fmt::Result {
    f.write_str(if state { "   1" } else { "   ·" })
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Verdict::Met { comparisons: 0 } => write!(f, "PASS: it ran; nothing was expected"),
            Verdict::Met { .. } => write!(f, "PASS"),
            Verdict::Refused(refusal) => write!(f, "PASS: refused as expected: {}", told(*refusal)),
            Verdict::Unmet(unmet) => {
                write!(f, "FAIL")?;
                for unmet in unmet.iter().take(UNMET_SHOWN) {
                    write!(f, "\n  {unmet}")?;
                }
                match unmet.len().saturating_sub(UNMET_SHOWN) {
                    0 => Ok(()),
                    more => write!(f, "\n  … and {more} more"),
                }
            }
            Verdict::WrongRefusal { expected, came } => {
                let said = |refusal: &Option<Refusal>| match refusal {
                    Some(refusal) => told(*refusal),
                    None => "that the program runs".to_owned(),
                };
                write!(f, "FAIL\n  expected {}", said(expected))?;
                match came {
                    Some(came) => write!(f, "\n  came     {}", told(*came)),
                    None => write!(f, "\n  but the program was accepted"),
                }
            }
            Verdict::Broken { at: None, reason } => {
                write!(f, "FAIL\n  while the program was loaded: {reason}")
            }
            Verdict::Broken {
                at: Some(at),
                reason,
            } => write!(f, "FAIL\n  at {at} ms: {reason}"),
        }
    }
}

impl fmt::Display for Unmet {
    /// `Q1 at 5000 ms: expected 0, came 1 (until 5020 ms)`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "Q{} at {} ms: expected {}, came {}",
            self.output.number(),
            self.from,
            u8::from(self.expected),
            u8::from(!self.expected)
        )?;
        if self.to > self.from {
            write!(f, " (until {} ms)", self.to)?;
        }
        Ok(())
    }
}

/// A refusal with the text of its fault.
fn told(refusal: Refusal) -> String {
    let cause = Cause::ALL
        .iter()
        .find(|cause| cause.number() == refusal.number);
    match cause {
        Some(cause) => format!("{refusal}: {}", cause.text()),
        None => refusal.to_string(),
    }
}
