//! `unoclp sim`: by hand in this terminal, or by a scenario.

use super::open::{Shown, check_written, open, read, running};
use super::output::{Draft, Kind, Over, cannot_write, may_write, write};
use super::wording::Wording;
use crate::outcome::Outcome;
use crate::panel::{self, App};
use crate::{ascii, messages};
use anstream::println;
use anyhow::{anyhow, bail};
use std::collections::BTreeMap;
use std::io::{BufWriter, IsTerminal, Write, stdin, stdout};
use std::path::Path;
use unoclp_core::Board;
use unoclp_exercise::diagram;
use unoclp_exercise::scenario::{
    Both, Exercise, LoadError, ProgramFile, Report, Scenario, Verdict, check,
};
use unoclp_exercise::wave::{RecordedEngine, Recorder};
use unoclp_host_sim::engine::HostEngine;
use unoclp_program::{Source, Written, WrittenIn, point_names, shown};

/// Simulates a program in this terminal.
pub fn simulate(path: &Path, vcd: Option<&Path>, over: Over, wording: &Wording) -> Outcome {
    let Some(program) = open(path, wording, Shown::Here)? else {
        return Ok(false);
    };
    if !(stdin().is_terminal() && stdout().is_terminal()) {
        bail!(messages::sim_needs_terminal());
    }
    let names = point_names(&program);
    let mut app = App::new(program);
    let draft = vcd.map(|vcd| Draft::new(vcd, Kind::Trace, &[path], over));
    let draft = draft.transpose()?;
    if let (Some(vcd), Some(draft)) = (vcd, &draft) {
        app.record_to(Recorder::new(trace(draft, vcd)?).with_names(names));
    }
    panel::run(app)?;
    draft.map_or(Ok(()), Draft::finish)?;
    Ok(true)
}

/// How a scenario is run.
#[derive(Clone, Copy)]
pub struct Run<'a> {
    /// In place of the program that it names.
    pub program: Option<&'a Path>,
    /// One of its cases, from 1; else all.
    pub case: Option<usize>,
    /// Where the trace goes.
    pub vcd: Option<&'a Path>,
    /// Where the timing diagram goes.
    pub svg: Option<&'a Path>,
    /// What may be overwritten.
    pub over: Over,
}

/// Runs a scenario.
pub fn scenario(path: &Path, run: Run<'_>, wording: &Wording) -> Outcome {
    let wrong = |error: LoadError| anyhow!(error.text(messages::spoken()));
    let exercise = Exercise::load(path, wording.board()).map_err(wrong)?;
    let wording = &wording.on(exercise.board);
    let named = exercise.program.as_deref();
    let program = match (run.program, named) {
        (Some(program), _) => Some(program),
        // Its errors are shown as `check` shows them.
        (None, Some(named)) if is_text(named, wording) => Some(named),
        (None, _) => None,
    };
    let mut source = None;
    let mut scenarios = match program {
        None => Scenario::load_all(path, wording.board()).map_err(wrong)?,
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
            exercise.scenarios(&ProgramFile { name, bytes })
        }
    };
    let count = scenarios.len();
    if let Some(case) = run.case {
        if case > count {
            bail!(messages::no_case(case, shown(path), count));
        }
        scenarios = scenarios.split_off(case - 1);
        scenarios.truncate(1);
    }
    if run.vcd.is_some() && scenarios.len() > 1 {
        bail!(messages::trace_of_one(shown(path), count));
    }
    let inputs: Vec<&Path> = [Some(path), program, named].into_iter().flatten().collect();
    if let Some(svg) = run.svg {
        may_write(svg, Kind::Drawing, &inputs, run.over)?;
    }
    let reports = match (run.vcd, &scenarios[..]) {
        (Some(vcd), [scenario]) => {
            let names = source.as_ref().map(point_names).unwrap_or_default();
            let draft = Draft::new(vcd, Kind::Trace, &inputs, run.over)?;
            let recorder = Recorder::new(trace(&draft, vcd)?).with_names(names);
            let mut engine = RecordedEngine::new(recorder, wording.board());
            let report = check(scenario, &mut engine);
            engine.finish().map_err(cannot_write(vcd))?;
            draft.finish()?;
            vec![report]
        }
        (_, all) => {
            let engine = &mut HostEngine::new(wording.board());
            all.iter().map(|scenario| check(scenario, engine)).collect()
        }
    };
    for (index, report) in reports.iter().enumerate() {
        if index > 0 {
            println!();
        }
        println!("{}", ascii::picture(&report.text(messages::spoken())));
        stopped_at(report, &scenarios[index], source.as_ref(), wording.board());
    }
    if let Some(svg) = run.svg {
        let runs = scenarios.iter().zip(&reports);
        let runs: Vec<_> = runs
            .map(|(scenario, report)| diagram::Run { scenario, report })
            .collect();
        let names = names(exercise.names, source.as_ref());
        let picture = diagram::svg(&runs, &names, messages::spoken());
        write(svg, picture.into_bytes(), Kind::Drawing, &inputs, run.over)?;
        println!("{}", messages::drawn(shown(svg)));
    }
    Ok(reports.iter().all(Report::passed))
}

/// What the points are called: by the exercise, else by the program.
fn names(names: BTreeMap<String, Both>, source: Option<&Source>) -> BTreeMap<String, Both> {
    let own = source.map(point_names).unwrap_or_default();
    let own = own
        .into_iter()
        .map(|(point, name)| (point, Both::same(&name)));
    own.chain(names).collect()
}

/// Shows where in its text a program has ended that should run on.
fn stopped_at(report: &Report, scenario: &Scenario, source: Option<&Source>, board: Board) {
    let Verdict::WrongStop {
        came: Some((_, refusal)),
        ..
    } = report.verdict
    else {
        return;
    };
    let program = scenario.program();
    let read = || Written::new(program.name.clone(), program.bytes.clone(), board).check(None);
    let own = source.is_none().then(|| read().ok()).flatten();
    if let (Some(source), Some(fault)) = (source.or(own.as_ref()), refusal.fault()) {
        println!("  {}", running(source, fault).replace('\n', "\n  "));
    }
}

/// Whether the program of a scenario is a text that is compiled.
fn is_text(path: &Path, wording: &Wording) -> bool {
    let read = || read(path).map(|file| wording.of(file.name, file.bytes));
    WrittenIn::of_name(path).is_some() || read().is_ok_and(|written| written.is_text())
}

/// What writes the trace of a run into this file.
fn trace(draft: &Draft, path: &Path) -> anyhow::Result<Box<dyn Write>> {
    let file = draft.writer().map_err(cannot_write(path))?;
    Ok(Box::new(BufWriter::new(file)))
}
