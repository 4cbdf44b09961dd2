//! What the firmware is compared with: programs in C, compiled with avr-gcc and run on the same simulated board.

use crate::meter::{Meter, Times};
use crate::programs::{self, Rung};
use anyhow::{Context, Result, ensure};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use unoclp_uno_sim::Program;

/// Rungs from which, and to which, the cost of a rung is measured with the thesis's form: the array of 100 rungs does
/// not fit into RAM.
const THESIS_RUNGS: [usize; 2] = [10, 50];

/// A form of program to compare with.
struct Form {
    source: &'static str,
    options: &'static [&'static str],
    rungs: [usize; 2],
}

const THESIS: Form = Form {
    source: "thesis.c",
    options: &[],
    rungs: THESIS_RUNGS,
};
const DIVIDING: Form = Form {
    source: "thesis.c",
    options: &["-DDIVIDE"],
    rungs: THESIS_RUNGS,
};
const COMPILED: Form = Form {
    source: "compiled.c",
    options: &[],
    rungs: [10, programs::FULL_RUNGS],
};

/// What is measured on a yardstick, in cycles.
#[derive(Clone, Copy, Debug)]
pub struct Yardstick {
    /// A rung of four contacts and a coil.
    pub rung: Times,
    /// The whole scan of two contacts, a coil and the toggling rung.
    pub small: Times,
    /// The whole scan of the larger number of rungs.
    pub large: Times,
}

/// All of them.
#[derive(Clone, Debug)]
pub struct Yardsticks {
    /// The version of avr-gcc that has compiled them.
    pub compiler: String,
    /// The thesis's interpreter.
    pub thesis: Yardstick,
    /// The same, with the point split off by division.
    pub dividing: Yardstick,
    /// The same logic in C.
    pub compiled: Yardstick,
}

/// Compiles the yardsticks of the folder `proof/bench/` into `target/bench/`.
pub struct Workshop {
    sources: PathBuf,
    folder: PathBuf,
}

impl Workshop {
    /// In the workspace with this root.
    pub fn new(root: &Path) -> Workshop {
        Workshop {
            sources: root.join("proof/bench"),
            folder: root.join("target/bench"),
        }
    }

    /// Measures all; the logic of each must be that of the firmware, which `logic` tells for some rungs.
    pub fn measure(&self, logic: impl Fn(&[Rung]) -> Result<Vec<u8>>) -> Result<Yardsticks> {
        let measure = |form: &Form| {
            let scan = |rungs: &[Rung]| {
                let mut meter = Meter::yardstick(&self.compile(form, rungs)?)?;
                ensure!(
                    meter.logic()? == logic(rungs)?,
                    "{} {:?} does not compute what the firmware does, with {} rungs",
                    form.source,
                    form.options,
                    rungs.len()
                );
                Times::of(meter.all_inputs()?)
            };
            let [few, many] = form.rungs;
            let large = scan(&programs::rungs(many))?;
            Ok::<_, anyhow::Error>(Yardstick {
                rung: large.each(scan(&programs::rungs(few))?, many - few),
                small: scan(&programs::small())?,
                large,
            })
        };
        Ok(Yardsticks {
            compiler: compiler()?,
            thesis: measure(&THESIS)?,
            dividing: measure(&DIVIDING)?,
            compiled: measure(&COMPILED)?,
        })
    }

    fn compile(&self, form: &Form, rungs: &[Rung]) -> Result<Program> {
        let name = form.source.trim_end_matches(".c");
        let folder = self
            .folder
            .join(format!("{name}{}-{}", form.options.concat(), rungs.len()));
        let codes = programs::program(rungs).into_iter();
        let codes: String = codes.map(|code| format!("{code},\n")).collect();
        let included = [("program.inc", codes), ("rungs.inc", programs::c(rungs))];
        self.build(form.source, form.options, &folder, &included)
    }

    /// The program that does this work, statements in C.
    pub fn work(&self, statements: &str) -> Result<Program> {
        let folder = self.folder.join("work");
        self.build(
            "work.c",
            &[],
            &folder,
            &[("work.inc", statements.to_owned())],
        )
    }

    fn build(
        &self,
        source: &str,
        options: &[&str],
        folder: &Path,
        included: &[(&str, String)],
    ) -> Result<Program> {
        fs::create_dir_all(folder)
            .with_context(|| format!("cannot create the folder {}", folder.display()))?;
        for (file, text) in included {
            let file = folder.join(file);
            fs::write(&file, text).with_context(|| format!("cannot write {}", file.display()))?;
        }
        let elf = folder.join("yardstick.elf");
        let mut gcc = Command::new("avr-gcc");
        gcc.args(["-Os", "-mmcu=atmega328p", "-std=gnu11", "-Wall", "-Wextra"])
            .args(options)
            .arg("-I")
            .arg(folder)
            .arg("-o")
            .arg(&elf)
            .arg(self.sources.join(source))
            .arg("-lm");
        let status = gcc
            .status()
            .context("avr-gcc does not start; `cargo xtask setup` installs it")?;
        ensure!(status.success(), "avr-gcc failed on {}: {status}", source);
        Ok(Program::read(&elf)?)
    }
}

fn compiler() -> Result<String> {
    let output = Command::new("avr-gcc").arg("-dumpversion").output();
    let output = output.context("avr-gcc does not start; `cargo xtask setup` installs it")?;
    Ok(String::from_utf8_lossy(&output.stdout).trim().to_owned())
}
