//! `unoclp plant`, and `unoclp sim` with a plant: a machine alone, and one that a program controls.

use super::open::{Shown, open, read};
use super::output::{Kind, Over, may_write, write};
use super::wording::Wording;
use crate::outcome::Outcome;
use crate::{film, messages};
use anstream::println;
use anyhow::{anyhow, bail};
use clap::{Args, Subcommand};
use std::path::{Path, PathBuf};
use unoclp_core::Board;
use unoclp_exercise::machine::{First, control, with_chances};
use unoclp_host_sim::engine::HostEngine;
use unoclp_plant::{Picture, Plant, Run, Unit, Verdict, picture};
use unoclp_program::shown;

/// What may be done with a plant alone.
#[derive(Subcommand)]
pub enum OfPlant {
    /// Show the parts and goals of a machine, or every error with its line
    Check {
        /// The machine (.toml)
        #[arg(value_name = "PLANT.toml")]
        plant: PathBuf,
        #[command(flatten)]
        wording: Wording,
    },
    /// Draw a machine in its initial state
    Draw {
        /// The machine (.toml)
        #[arg(value_name = "PLANT.toml")]
        plant: PathBuf,
        /// The SVG file to write
        #[arg(value_name = "OUT.svg")]
        svg: PathBuf,
        #[command(flatten)]
        over: Over,
        #[command(flatten)]
        wording: Wording,
    },
}

/// A machine that a program is to control.
#[derive(Args)]
pub struct Machine {
    /// Let the program control this machine, and check its goals and rules
    #[arg(long, value_name = "PLANT.toml", conflicts_with = "scenario")]
    plant: Option<PathBuf>,
    /// The seed of random events, instead of the machine's own
    #[arg(long, value_name = "N", requires = "plant")]
    seed: Option<u32>,
    /// With --svg, the times to draw, instead of those at which rules were broken: 1s,2.5s,1min
    #[arg(long, value_name = "TIMES", requires = "plant")]
    at: Option<String>,
    /// Write the run of the machine as an animated GIF
    #[arg(long, value_name = "OUT.gif", requires = "plant")]
    gif: Option<PathBuf>,
    /// The part of the run that the animation shows: 0s-12s
    #[arg(long, value_name = "FROM-TO", requires = "gif")]
    span: Option<String>,
}

impl Machine {
    /// The file of the machine, if there is one.
    pub fn plant(&self) -> Option<&Path> {
        self.plant.as_deref()
    }
}

/// Does it.
pub fn plant(of: &OfPlant) -> Outcome {
    match of {
        OfPlant::Check { plant, wording } => check(plant, wording),
        OfPlant::Draw {
            plant,
            svg,
            over,
            wording,
        } => draw(plant, svg, *over, wording),
    }
}

/// The plant of a file; its mistakes are told.
pub(super) fn machine(path: &Path, board: Board) -> anyhow::Result<Option<Plant>> {
    let file = read(path)?;
    let name = file.name;
    let text = String::from_utf8(file.bytes).map_err(|_| anyhow!(messages::plant_binary(&name)))?;
    let plant = unoclp_plant::read(&text, board);
    if let Err(mistakes) = &plant {
        for mistake in mistakes {
            println!("{}", mistake.text(&name, messages::spoken()));
        }
    }
    Ok(plant.ok())
}

fn check(path: &Path, wording: &Wording) -> Outcome {
    let Some(plant) = machine(path, wording.board())? else {
        return Ok(false);
    };
    let lang = messages::spoken();
    println!("{}", plant.title.text(lang));
    let counts = (plant.parts.len(), plant.nevers.len(), plant.goals.len());
    let until = Unit::Ms.shown(plant.until as i64);
    println!(
        "{}",
        messages::plant_has(counts.0, counts.1, counts.2, until)
    );
    for never in &plant.nevers {
        println!("  {}", messages::plant_never(never.text.text(lang)));
    }
    for goal in &plant.goals {
        let within = Unit::Ms.shown(goal.within as i64);
        println!("  {}", messages::plant_goal(goal.text.text(lang), within));
    }
    Ok(true)
}

fn draw(path: &Path, svg: &Path, over: Over, wording: &Wording) -> Outcome {
    let Some(plant) = machine(path, wording.board())? else {
        return Ok(false);
    };
    let run = Run::new(&plant, plant.seed);
    let text = picture(&run, messages::spoken()).svg();
    write(svg, text.into_bytes(), Kind::Drawing, &[path], over)?;
    println!("{}", messages::drawn(shown(svg)));
    Ok(true)
}

/// A picture is wanted at each of these times, ms.
fn moments(text: &str, until: u64) -> anyhow::Result<Vec<u64>> {
    text.split(',').map(|part| moment(part, until)).collect()
}

fn moment(text: &str, until: u64) -> anyhow::Result<u64> {
    let time = Unit::Ms
        .read(text)
        .and_then(|time| u64::try_from(time).ok());
    let time = time.ok_or_else(|| anyhow!(messages::no_moment(text)))?;
    match time > until {
        true => bail!(messages::late_moment(text, Unit::Ms.shown(until as i64))),
        false => Ok(time),
    }
}

/// From when to when the animation goes, ms.
fn span(text: Option<&str>, until: u64) -> anyhow::Result<(u64, u64)> {
    let Some(text) = text else {
        return Ok((0, until));
    };
    let (from, to) = text
        .split_once('-')
        .ok_or_else(|| anyhow!(messages::no_span(text)))?;
    let (from, to) = (moment(from, until)?, moment(to, until)?);
    match from < to {
        true => Ok((from, to)),
        false => bail!(messages::no_span(text)),
    }
}

/// Before a rule breaks, this is seen too, ms.
const BEFORE: u64 = 2000;

/// Whether a board has all points that another one has.
fn has_points_of(board: Board, other: Board) -> bool {
    let points = |board: Board| [board.inputs, board.outputs, board.analogue];
    points(board)
        .iter()
        .zip(points(other))
        .all(|(has, needs)| *has >= needs)
}

/// Lets a program control a machine.
pub fn drive(
    program: &Path,
    machine_of: &Machine,
    svg: Option<&Path>,
    over: Over,
    wording: &Wording,
) -> Outcome {
    let Some(path) = machine_of.plant() else {
        bail!(messages::nothing_to_simulate());
    };
    let Some(plant) = machine(path, wording.board())? else {
        return Ok(false);
    };
    // A machine that names a board is driven by a program for that.
    let wording = &match wording.names_board() {
        true => wording.clone(),
        false => wording.on(plant.board),
    };
    if !has_points_of(wording.board(), plant.board) {
        bail!(messages::plant_board(shown(path), plant.board.id()));
    }
    let Some(source) = open(program, wording, Shown::Here)? else {
        return Ok(false);
    };
    let inputs = [program, path];
    let until = plant.until;
    let wanted = machine_of
        .at
        .as_deref()
        .map(|at| moments(at, until))
        .transpose()?;
    let (from, to) = span(machine_of.span.as_deref(), until)?;
    if let Some(svg) = svg {
        may_write(svg, Kind::Drawing, &inputs, over)?;
    }
    if let Some(gif) = &machine_of.gif {
        may_write(gif, Kind::Film, &inputs, over)?;
    }
    let seed = machine_of.seed.map_or(plant.seed, u64::from);
    let engine = &mut HostEngine::new(wording.board());
    let mut film = machine_of.gif.as_ref().map(|_| film::Film::new());
    let mut failed = None;
    let every = film::every(to - from);
    let verdict = control(&plant, seed, &source.code, engine, |run| {
        let now = run.now();
        if let Some(film) = film.as_mut()
            && (from..=to).contains(&now)
            && (now - from).is_multiple_of(every)
            && failed.is_none()
        {
            failed = film.add(&picture(run, messages::spoken())).err();
        }
    });
    let verdict = match verdict {
        Ok(verdict) => verdict,
        Err(ended) => {
            println!("{}", ended.text(messages::spoken()));
            return Ok(false);
        }
    };
    if let Some(why) = failed {
        bail!(messages::no_film(why));
    }
    say_verdict(&plant, &verdict);
    if let Some(svg) = svg {
        let at = wanted.unwrap_or_else(|| broken_at(&verdict, until));
        let mut pictures: Vec<Picture> = Vec::new();
        // The same run again, since only now is known when rules broke.
        let again = control(&plant, seed, &source.code, engine, |run| {
            if at.contains(&run.now()) {
                pictures.push(picture(run, messages::spoken()));
            }
        });
        again.map_err(|ended| anyhow!(ended.text(messages::spoken())))?;
        let strip = Picture::strip(&pictures);
        write(svg, strip.into_bytes(), Kind::Drawing, &inputs, over)?;
        println!("{}", messages::drawn(shown(svg)));
    }
    if let (Some(gif), Some(film)) = (&machine_of.gif, film) {
        let bytes = film
            .finish(every)
            .map_err(|why| anyhow!(messages::no_film(why)))?;
        write(gif, bytes, Kind::Film, &inputs, over)?;
        println!("{}", messages::drawn(shown(gif)));
    }
    Ok(verdict.is_passed())
}

/// The moments around what went wrong first; begin and end, where nothing did.
fn broken_at(verdict: &Verdict, until: u64) -> Vec<u64> {
    match verdict.first() {
        // A step later the state shows it.
        Some(at) => vec![
            at.saturating_sub(BEFORE),
            at.saturating_sub(BEFORE / 2),
            (at + 1).min(until),
        ],
        None => vec![0, until / 2, until],
    }
}

/// Which rules broke, and which goals were met.
fn say_verdict(plant: &Plant, verdict: &Verdict) {
    let lang = messages::spoken();
    println!("{}", plant.title.text(lang));
    let broken = verdict.broken.iter().copied().map(First::Broken);
    let missed = verdict.missed.iter().copied().map(First::Missed);
    for wrong in broken.chain(missed) {
        println!("  {}", wrong.text(plant, lang));
    }
    let kept = plant.nevers.len() - verdict.broken.len().min(plant.nevers.len());
    let met = plant.goals.len() - verdict.missed.len().min(plant.goals.len());
    println!(
        "  {}",
        messages::rules_kept(kept, plant.nevers.len(), met, plant.goals.len())
    );
    println!(
        "{}",
        if verdict.is_passed() {
            messages::machine_passed()
        } else {
            messages::machine_failed()
        }
    );
}

/// What went wrong first with a machine that this program controls; nothing, where all is well.
pub(super) fn what_first(
    plant: &Plant,
    seeds: &[u32],
    program: &[u8],
    board: Board,
) -> Option<String> {
    let lang = messages::spoken();
    match with_chances(plant, seeds, program, &mut HostEngine::new(board)) {
        Ok(first) => Some(first?.text(plant, lang)),
        Err(ended) => Some(ended.text(lang)),
    }
}
