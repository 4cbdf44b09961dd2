//! `unoclp sim`: by hand in this terminal, or by a scenario.

use super::open::{Shown, check_written, open, read, running};
use super::output::{Kind, cannot_write, create};
use super::wording::Wording;
use crate::Outcome;
use anstream::println;
use anyhow::{anyhow, bail};
use std::io::{BufWriter, IsTerminal, Write, stdin, stdout};
use std::path::Path;
use unoclp_cli::panel::{self, App};
use unoclp_cli::{ascii, messages};
use unoclp_host_sim::engine::HostEngine;
use unoclp_host_sim::scenario::{LoadError, ProgramFile, Scenario, Verdict, check};
use unoclp_host_sim::wave::{RecordedEngine, Recorder};
use unoclp_source::{Written, WrittenIn, point_names};

/// Simulates a program in this terminal.
pub fn simulate(path: &Path, vcd: Option<&Path>, wording: &Wording) -> Outcome {
    let Some(program) = open(path, wording, Shown::Here)? else {
        return Ok(false);
    };
    if !(stdin().is_terminal() && stdout().is_terminal()) {
        bail!(messages::sim_needs_terminal());
    }
    let names = point_names(&program);
    let mut app = App::new(program);
    if let Some(vcd) = vcd {
        app.record_to(Recorder::new(trace(vcd, &[path])?).with_names(names));
    }
    panel::run(app)?;
    Ok(true)
}

/// Runs a scenario, with this program in place of its own where there is one.
pub fn scenario(
    path: &Path,
    program: Option<&Path>,
    vcd: Option<&Path>,
    wording: &Wording,
) -> Outcome {
    let wrong = |error: LoadError| anyhow!(error.text(messages::spoken()));
    let named = Scenario::program_of(path).map_err(wrong)?;
    let program = match (program, &named) {
        (Some(program), _) => Some(program),
        // Its errors are shown as `check` shows them.
        (None, Some(named)) if is_text(named) => Some(named.as_path()),
        (None, _) => None,
    };
    let mut source = None;
    let scenario = match program {
        None => Scenario::load(path).map_err(wrong)?,
        Some(program) => {
            let ProgramFile { name, bytes } = read(program)?;
            let written = wording.of(name.clone(), bytes.clone());
            // Numeric code is run as it is: a scenario may expect a fault of it.
            let bytes = match written.language {
                Ok(WrittenIn::Numeric) => bytes,
                _ => match check_written(written, wording, Shown::Here)? {
                    Some(checked) => source.insert(checked).code.clone(),
                    None => return Ok(false),
                },
            };
            Scenario::load_for(path, ProgramFile { name, bytes }).map_err(wrong)?
        }
    };
    let report = match vcd {
        None => check(&scenario, &mut HostEngine::default()),
        Some(vcd) => {
            let inputs = [Some(path), program, named.as_deref()];
            let inputs: Vec<&Path> = inputs.into_iter().flatten().collect();
            let names = source.as_ref().map(point_names).unwrap_or_default();
            let recorder = Recorder::new(trace(vcd, &inputs)?).with_names(names);
            let mut engine = RecordedEngine::new(recorder);
            let report = check(&scenario, &mut engine);
            engine.finish().map_err(cannot_write(vcd))?;
            report
        }
    };
    println!("{}", ascii::picture(&report.text(messages::spoken())));
    if let Verdict::WrongStop {
        came: Some((_, refusal)),
        ..
    } = report.verdict
        && let Some(fault) = refusal.fault()
    {
        let program = scenario.program();
        let read = || Written::new(program.name.clone(), program.bytes.clone());
        if let Some(source) = source.or_else(|| read().check(None).ok()) {
            println!("  {}", running(&source, fault).replace('\n', "\n  "));
        }
    }
    Ok(report.passed())
}

/// Whether the program of a scenario is a text that is compiled.
fn is_text(path: &Path) -> bool {
    let read = || read(path).map(|file| Written::new(file.name, file.bytes));
    WrittenIn::of_name(path).is_some() || read().is_ok_and(|written| written.is_text())
}

/// Opens a file for the trace of a run; the command reads `inputs`.
fn trace(path: &Path, inputs: &[&Path]) -> anyhow::Result<Box<dyn Write>> {
    let file = create(path, Kind::Trace, inputs)?;
    Ok(Box::new(BufWriter::new(file)))
}
