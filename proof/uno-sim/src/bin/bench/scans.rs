//! The cost of rungs and instructions, of whole scans, and of the millisecond interrupt.

use crate::meter::{Meter, Scan, Times};
use crate::programs::{self, Codes, INPUT, NEW_RUNG};
use anyhow::{Result, ensure};
use unoclp_uno_sim::Program;

/// Between these numbers of rungs the slope is taken.
const FEW: usize = 10;
const MANY: usize = 100;
/// And to this number of groups of instructions: as many as fit.
const MANY_GROUPS: usize = 60;

/// Millisecond interrupts that are timed: four times round the low byte of the clock.
const INTERRUPTS: usize = 1024;

/// A cost of one instruction.
#[derive(Clone, Debug)]
pub struct Cost {
    /// What it is.
    pub name: &'static str,
    /// Cycles.
    pub cycles: Times,
}

/// A whole scan.
#[derive(Clone, Copy, Debug)]
pub struct Whole {
    /// All scans.
    pub all: Times,
    /// Those into which no millisecond interrupt fell, where there are any.
    pub quiet: Option<Times>,
}

/// What is measured of scans.
#[derive(Clone, Debug)]
pub struct Scans {
    /// A rung of four contacts and a coil.
    pub rung: Times,
    /// The whole scan of two contacts, a coil and the toggling rung.
    pub small: Whole,
    /// The whole scan of 100 rungs.
    pub large: Whole,
    /// The whole scan of 100 rungs and 32 timers.
    pub full: Whole,
    /// Single instructions.
    pub costs: Vec<Cost>,
    /// The millisecond interrupt.
    pub interrupt: Times,
}

/// Instructions that are measured as groups, to be repeated in one rung.
struct Group {
    name: &'static str,
    codes: &'static [i64],
    /// How many of the instruction there are in a group.
    count: usize,
    /// The instruction that stands beside each of them, and is taken off.
    beside: Option<&'static str>,
}

const COIL: &str = "coil";
const CONTACT: &str = "contact, alone between two coils";
const GROUPS: [Group; 7] = [
    Group {
        name: COIL,
        codes: &[877_901, 877_902, 877_903],
        count: 3,
        beside: None,
    },
    Group {
        name: CONTACT,
        codes: &[
            INPUT + 1,
            877_901,
            -(INPUT + 2),
            877_902,
            827_903,
            877_903,
            -827_901,
            877_901,
        ],
        count: 4,
        beside: Some(COIL),
    },
    Group {
        name: "one more contact in series",
        codes: &[INPUT + 1, -(INPUT + 2), 827_903, -827_901],
        count: 4,
        beside: None,
    },
    Group {
        name: "set or reset coil",
        codes: &[83_877_901, 82_877_902, 83_877_903, 82_877_901],
        count: 4,
        beside: None,
    },
    Group {
        name: "branch `40 … 41`",
        codes: &[40, INPUT + 3, 41],
        count: 1,
        beside: Some(CONTACT),
    },
    Group {
        name: "branch from a branch point, `40 4041XX … 41`",
        codes: &[40, 404_101, INPUT + 3, 41],
        count: 1,
        beside: Some(CONTACT),
    },
    Group {
        name: "rung of 4 contacts, 2 of them in parallel, and a coil",
        codes: &[
            NEW_RUNG,
            INPUT + 3,
            404_101,
            INPUT + 1,
            40,
            404_101,
            INPUT + 2,
            41,
            -(INPUT + 4),
            877_901,
        ],
        count: 1,
        beside: None,
    },
];
/// What stands in front of the groups.
const OPENING: [i64; 3] = [NEW_RUNG, INPUT + 4, 404_101];

/// Measures it all.
pub fn measure(firmware: &Program) -> Result<Scans> {
    let run = |codes: Codes| Meter::firmware(firmware, &codes)?.all_inputs();
    let rungs = |count| run(programs::program(&programs::rungs(count)));
    let large = rungs(MANY)?;
    let small = programs::program(&programs::small());
    Ok(Scans {
        rung: times(&large)?.each(times(&rungs(FEW)?)?, MANY - FEW),
        large: whole(&large)?,
        full: whole(&run(programs::full())?)?,
        small: whole(&run(small.clone())?)?,
        costs: costs(firmware)?,
        interrupt: Meter::firmware(firmware, &small)?.interrupts(INTERRUPTS)?,
    })
}

fn costs(firmware: &Program) -> Result<Vec<Cost>> {
    let scan = |codes: &[i64], count: usize| {
        let groups = std::iter::repeat_n(codes, count).flatten();
        let codes = programs::toggled(OPENING.iter().chain(groups).copied());
        times(&Meter::firmware(firmware, &codes)?.all_inputs()?)
    };
    let mut costs: Vec<Cost> = Vec::new();
    for group in &GROUPS {
        let many = scan(group.codes, MANY_GROUPS)?;
        let cycles = many.each(scan(group.codes, FEW)?, (MANY_GROUPS - FEW) * group.count);
        let beside = costs.iter().find(|cost| Some(cost.name) == group.beside);
        costs.push(Cost {
            name: group.name,
            cycles: beside.map_or(cycles, |beside| cycles.each(beside.cycles, 1)),
        });
    }
    Ok(costs)
}

/// The outputs 01 to 03 of these rungs for every pattern of inputs.
pub fn logic(firmware: &Program, rungs: &[programs::Rung]) -> Result<Vec<u8>> {
    let logic = Meter::firmware(firmware, &programs::program(rungs))?.logic()?;
    ensure!(logic.len() == 16);
    Ok(logic)
}

fn times(scans: &[Scan]) -> Result<Times> {
    Times::of(scans.iter().copied())
}

fn whole(scans: &[Scan]) -> Result<Whole> {
    let quiet = scans.iter().copied().filter(|scan| scan.ticks == 0);
    Ok(Whole {
        all: times(scans)?,
        quiet: Times::of(quiet).ok(),
    })
}
