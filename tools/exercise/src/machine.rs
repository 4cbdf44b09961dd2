//! A plant controlled by a program, on any engine: a scan each millisecond, and a step of the plant behind each.
//!
//! Owns how the two are tied together. Must not know what either does.

use std::fmt;
use unoclp_core::Millis;
use unoclp_host_sim::engine::{Engine, Refusal};
use unoclp_plant::{Broken, Missed, Outputs, Plant, Run, Verdict};

/// Why a program has not controlled a plant to the end.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Ended {
    /// The program was refused.
    Refused(Refusal),
    /// It ended in a fault, at this time in ms after the first scan.
    Stopped(u64, Refusal),
    /// The engine did not do its work.
    Broken(String),
}

impl fmt::Display for Ended {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Ended::Refused(refusal) => write!(f, "{refusal}"),
            Ended::Stopped(at, refusal) => write!(f, "{refusal}, at {at} ms"),
            Ended::Broken(why) => f.write_str(why),
        }
    }
}

/// Lets a program control a plant through its script; `watch` sees the plant before the first step and after each.
///
/// # Errors
/// [`Ended`], where the program does not come to the end.
pub fn control<E: Engine>(
    plant: &Plant,
    seed: u64,
    program: &[u8],
    engine: &mut E,
    mut watch: impl FnMut(&Run<'_>),
) -> Result<Verdict, Ended> {
    let run = Run::new(plant, seed);
    controlled(run, program, engine, |run| {
        watch(run);
        true
    })
}

/// What goes wrong first with a machine.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum First {
    /// A rule.
    Broken(Broken),
    /// A goal.
    Missed(Missed),
}

/// What goes wrong first with a plant that a program controls, which runs no further; nothing, where all is well to the
/// end of its script.
///
/// # Errors
/// [`Ended`], where the program does not come so far.
pub fn first_wrong<E: Engine>(
    plant: &Plant,
    seed: u64,
    program: &[u8],
    engine: &mut E,
) -> Result<Option<First>, Ended> {
    let run = Run::new(plant, seed);
    let verdict = controlled(run, program, engine, |run| run.verdict().is_passed())?;
    let broken = verdict.broken.into_iter().next().map(First::Broken);
    let missed = verdict.missed.into_iter().next().map(First::Missed);
    Ok(broken.or(missed))
}

/// Lets a program control a plant until its script ends, or `goes_on` says that it shall not.
fn controlled<E: Engine>(
    mut run: Run<'_>,
    program: &[u8],
    engine: &mut E,
    mut goes_on: impl FnMut(&Run<'_>) -> bool,
) -> Result<Verdict, Ended> {
    let plant = run.plant();
    let broken = |error: E::Error| Ended::Broken(error.to_string());
    engine
        .load(program)
        .map_err(broken)?
        .map_err(Ended::Refused)?;
    let mut outputs = Outputs::default();
    while goes_on(&run) && run.now() < plant.until {
        let now = run.now();
        let scanned = engine.scan(run.inputs(), now as Millis).map_err(broken)?;
        outputs.points = scanned.map_err(|refusal| Ended::Stopped(now, refusal))?;
        for output in plant.board.pwm_outputs() {
            let duty = engine.pwm(output).map_err(broken)?;
            if let Some(place) = outputs.pwm.get_mut(usize::from(output)) {
                *place = duty;
            }
        }
        run.step(&outputs);
    }
    Ok(run.verdict().clone())
}
