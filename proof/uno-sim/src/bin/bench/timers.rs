//! The cost of a timer in each of its states, and in the scans in which it starts and expires.

use crate::meter::{Meter, Scan, Times};
use crate::programs::{self, FULL_TIMERS};
use anyhow::Result;
use unoclp_uno_sim::Program;

const TON: i64 = 847_978;
const TOF: i64 = 847_970;
/// A preset that does not come to its end, ms.
const LONG: u32 = 2_000_000_000;
/// One that does, ms.
const SHORT: u32 = 5;
/// How long a state is measured, ms.
const WINDOW: u64 = 300;
/// How often the timers are started.
const EVENTS: u64 = 150;
/// Output 03, which a third of the timers drive, and which is on the port of the toggling output.
const SEEN: u8 = 1 << 2;

/// What a timer costs in a state, cycles for each of 32 timers.
#[derive(Clone, Copy, Debug)]
pub struct State {
    /// The state, or the event.
    pub name: &'static str,
    /// Cycles of one of 32 timers which are all in this state, in scans without a millisecond interrupt where there are
    /// such.
    pub cycles: Times,
}

/// What is measured of the timers.
#[derive(Clone, Debug)]
pub struct Timers {
    /// On-delay.
    pub ton: Vec<State>,
    /// Off-delay.
    pub tof: Vec<State>,
    /// The longest scan of a run in which 32 TONs start, run and expire together.
    pub longest_of_run: f64,
    /// The longest while all of them are timing.
    pub longest_timing: f64,
}

impl Timers {
    /// The most that a timer adds to a scan, in any state: of the shortest scans, since the longest have other work in
    /// them, with timers and without.
    pub fn most(&self) -> f64 {
        let states = self.ton.iter().chain(&self.tof);
        states.map(|state| state.cycles.least).fold(0.0, f64::max)
    }
}

/// A state that lasts: how to come to it.
struct Lasting {
    name: &'static str,
    preset: u32,
    /// Inputs, each held for 50 ms; the last is held on.
    inputs: &'static [u8],
}

const fn lasting(name: &'static str, preset: u32, inputs: &'static [u8]) -> Lasting {
    Lasting {
        name,
        preset,
        inputs,
    }
}

const TON_STATES: [Lasting; 3] = [
    lasting("idle", LONG, &[0]),
    lasting("timing", LONG, &[1]),
    lasting("done", SHORT, &[1]),
];
const TOF_STATES: [Lasting; 4] = [
    lasting("idle", LONG, &[0]),
    lasting("on", LONG, &[1]),
    lasting("timing", LONG, &[1, 0]),
    lasting("done", SHORT, &[1, 0]),
];

/// Measures it all.
pub fn measure(firmware: &Program) -> Result<Timers> {
    let bench = Bench { firmware };
    let mut ton = bench.states(TON, &TON_STATES)?;
    let mut tof = bench.states(TOF, &TOF_STATES)?;
    let run = bench.events(TON)?;
    // IN = 1 starts a TON, and IN = 0 a TOF.
    ton.push(bench.event("starts", 1, &run.risen)?);
    ton.push(bench.end("expires", 1, &run.risen_later)?);
    ton.push(bench.event("goes off", 0, &run.fallen)?);
    let longest_of_run = run.all.most;
    let run = bench.events(TOF)?;
    tof.push(bench.event("goes on", 1, &run.risen)?);
    tof.push(bench.event("starts", 0, &run.fallen)?);
    tof.push(bench.end("expires", 0, &run.fallen_later)?);
    let timing = bench.run(Some((TON, LONG)), &[1])?;
    Ok(Timers {
        ton,
        tof,
        longest_of_run,
        longest_timing: Times::of(timing)?.most,
    })
}

/// The scans of a run in which the input goes on and off, and the timers follow.
struct Run {
    all: Times,
    /// The scans that saw the input change.
    risen: Vec<Scan>,
    fallen: Vec<Scan>,
    /// The scans in which the outputs followed later, at the end of the preset.
    risen_later: Vec<Scan>,
    fallen_later: Vec<Scan>,
}

struct Bench<'f> {
    firmware: &'f Program,
}

impl Bench<'_> {
    fn meter(&self, timer: Option<(i64, u32)>) -> Result<Meter> {
        Meter::firmware(self.firmware, &programs::timer_rungs(FULL_TIMERS, timer))
    }

    /// Scans in a state that lasts.
    fn run(&self, timer: Option<(i64, u32)>, inputs: &[u8]) -> Result<Vec<Scan>> {
        let mut meter = self.meter(timer)?;
        for &inputs in inputs {
            meter.uno().set_inputs(inputs);
            meter.run_ms(50)?;
        }
        meter.run_ms(WINDOW)
    }

    fn steady(&self, timer: Option<(i64, u32)>, inputs: &[u8]) -> Result<Times> {
        quiet(&self.run(timer, inputs)?)
    }

    fn states(&self, timer: i64, states: &[Lasting]) -> Result<Vec<State>> {
        let state = |state: &Lasting| {
            let with = self.steady(Some((timer, state.preset)), state.inputs)?;
            let without = self.steady(None, state.inputs)?;
            Ok(State {
                name: state.name,
                cycles: with.each(without, FULL_TIMERS),
            })
        };
        states.iter().map(state).collect()
    }

    /// An event, against scans without timers.
    fn event(&self, name: &'static str, inputs: u8, scans: &[Scan]) -> Result<State> {
        let without = self.steady(None, &[inputs])?;
        Ok(State {
            name,
            cycles: quiet(scans)?.each(without, FULL_TIMERS),
        })
    }

    /// The end of a preset, which comes with a new millisecond: against scans that do what is done once in each, too.
    fn end(&self, name: &'static str, inputs: u8, scans: &[Scan]) -> Result<State> {
        let without = self.run(None, &[inputs])?;
        let behind = without.windows(2).filter_map(|pair| match pair {
            [before, scan] if before.ticks > 0 => Some(*scan),
            _ => None,
        });
        let without = quiet(&behind.collect::<Vec<_>>())?;
        Ok(State {
            name,
            cycles: quiet(scans)?.each(without, FULL_TIMERS),
        })
    }

    fn events(&self, timer: i64) -> Result<Run> {
        let mut meter = self.meter(Some((timer, SHORT)))?;
        let (mut all, mut risen, mut fallen) = (Vec::new(), Vec::new(), Vec::new());
        let (mut risen_later, mut fallen_later) = (Vec::new(), Vec::new());
        meter.run_ms(20)?;
        for n in 0..EVENTS {
            for inputs in [1, 0] {
                let seen = meter.change(inputs)?;
                let mut last = seen;
                all.push(seen);
                let (changed, later) = match inputs {
                    1 => (&mut risen, &mut risen_later),
                    _ => (&mut fallen, &mut fallen_later),
                };
                changed.push(seen);
                for scan in meter.run_ms(u64::from(SHORT) * 3)? {
                    if (scan.outputs ^ last.outputs) & SEEN != 0 {
                        later.push(scan);
                    }
                    all.push(scan);
                    last = scan;
                }
                // Each change comes at another moment of the millisecond.
                meter.run_cycles(n * 397)?;
            }
        }
        Ok(Run {
            all: Times::of(all)?,
            risen,
            fallen,
            risen_later,
            fallen_later,
        })
    }
}

/// The scans without a millisecond interrupt; all, where each has one.
fn quiet(scans: &[Scan]) -> Result<Times> {
    let quiet = scans.iter().copied().filter(|scan| scan.ticks == 0);
    Times::of(quiet).or_else(|_| Times::of(scans.iter().copied()))
}
