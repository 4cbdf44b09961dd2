//! `unoclp sim`: by hand in this terminal, or by a scenario.

use super::open::{Shown, checked, open, read, running};
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
use unoclp_core::Fault;
use unoclp_exercise::diagram;
use unoclp_exercise::scenario::{
    Both, Exercise, LoadError, ProgramFile, Report, Scenario, Verdict, check,
};
use unoclp_exercise::wave::{RecordedEngine, Recorder};
use unoclp_host_sim::engine::HostEngine;
use unoclp_program::{Written, WrittenIn, shown};
use unoclp_workspace::{Ready, Workspace};

/// Simulates a program in this terminal.
pub fn simulate(path: &Path, vcd: Option<&Path>, over: Over, wording: &Wording) -> Outcome {
    let Some(program) = open(path, wording, Shown::Here)? else {
        return Ok(false);
    };
    if !(stdin().is_terminal() && stdout().is_terminal()) {
        bail!(messages::sim_needs_terminal());
    }
    let mut app =
        App::new(program.clone()).map_err(|fault| anyhow!(messages::fault(fault.cause)))?;
    let draft = vcd.map(|vcd| Draft::new(vcd, Kind::Trace, &[path], over));
    let draft = draft.transpose()?;
    if let (Some(vcd), Some(draft)) = (vcd, &draft) {
        app.record_to(Recorder::new(trace(draft, vcd)?).with_names(program.symbols().clone()));
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
    let mut texts = wording.workspace();
    let mut source: Option<Ready> = None;
    let mut scenarios = match program {
        None => Scenario::load_all(path, wording.board()).map_err(wrong)?,
        Some(program) => {
            let ProgramFile { name, bytes } = read(program)?;
            let written = wording.of(name.clone(), bytes.clone());
            // Numeric code is run as it is: a scenario may expect a fault of it.
            let bytes = match written.language {
                Ok(WrittenIn::Numeric) => bytes,
                _ => match checked(&texts.open(written), wording, Shown::Here)? {
                    Some(ready) => source.insert(ready).code.clone(),
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
            let names = source.as_ref().map(|source| source.symbols().clone());
            let names = names.unwrap_or_default();
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
        let fault = wrong_stop(report);
        let own = || opened(&scenarios[index], &mut texts, wording);
        if let Some(fault) = fault
            && let Some(program) = source.clone().or_else(own)
        {
            println!("  {}", running(&program, fault).replace('\n', "\n  "));
        }
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
fn names(names: BTreeMap<String, Both>, source: Option<&Ready>) -> BTreeMap<String, Both> {
    let own = source.map(Ready::symbols).into_iter().flatten();
    let own = own.map(|(point, name)| (point.clone(), Both::same(name)));
    own.chain(names).collect()
}

/// The fault that has ended a program that should run on.
fn wrong_stop(report: &Report) -> Option<Fault> {
    match report.verdict {
        Verdict::WrongStop {
            came: Some((_, refusal)),
            ..
        } => refusal.fault(),
        _ => None,
    }
}

/// The program of a scenario, if it is one.
fn opened(scenario: &Scenario, texts: &mut Workspace, wording: &Wording) -> Option<Ready> {
    let ProgramFile { name, bytes } = scenario.program();
    let written = Written::new(name.clone(), bytes.clone(), wording.board());
    texts.open(written).ready()
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
