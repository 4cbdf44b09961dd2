//! A plant controlled by a program, on any engine: a scan each millisecond, and a step of the plant behind each.
//!
//! Owns how the two are tied together. Must not know what either does.

use std::fmt;
use unoclp_core::Millis;
use unoclp_host_sim::engine::{Engine, Refusal};
use unoclp_plant::{Outputs, Plant, Run, Verdict};

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
    let broken = |error: E::Error| Ended::Broken(error.to_string());
    engine
        .load(program)
        .map_err(broken)?
        .map_err(Ended::Refused)?;
    let mut run = Run::new(plant, seed);
    watch(&run);
    let mut outputs = Outputs::default();
    while run.now() < plant.until {
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
        watch(&run);
    }
    Ok(run.verdict().clone())
}
