//! The page `docs/benchmarks.md`. Its text is here, its figures come from the measurement; it says nothing of when and
//! where, so that the same firmware gives the same page.

use crate::jobs::{self, Jobs, Saving};
use crate::mega::{self, Mega};
use crate::meter::{self, Times};
use crate::modes::Modes;
use crate::polling::Polled;
use crate::programs::{FULL_RUNGS, FULL_TIMERS};
use crate::scans::{Scans, Whole};
use crate::table::{Table, micros, number, ratio, verdict};
use crate::targets;
use crate::timers::Timers;
use crate::work::Done;
use crate::yardsticks::Yardsticks;

/// All that was measured.
pub struct Figures {
    /// The programs in C.
    pub yardsticks: Yardsticks,
    /// Pieces of work, each beside C.
    pub work: Vec<Done>,
    /// Rungs, instructions, whole scans.
    pub scans: Scans,
    /// Timers.
    pub timers: Timers,
    /// What runs beside the program.
    pub jobs: Jobs,
    /// What a Modbus client costs.
    pub polling: Vec<Polled>,
    /// Stack, memories, start.
    pub modes: Modes,
    /// The Mega.
    pub mega: Mega,
}

/// What a saving may add to a scan, cycles: 0.5 ms.
const SAVING: f64 = 8_000.0;
/// A rung of 4 contacts and a coil in LDmicro's bytecode, cycles: measured with avr-gcc -Os in simavr, and not here.
const LDMICRO_RUNG: f64 = 205.0;

/// The page.
pub fn page(figures: &Figures) -> String {
    let Figures {
        yardsticks,
        work,
        scans,
        timers,
        jobs,
        polling,
        modes,
        mega,
    } = figures;
    let opening = include_str!("text/opening.md").replace("VERSION", env!("CARGO_PKG_VERSION"));
    [
        opening,
        targets::table(figures),
        include_str!("text/targets.md").to_owned(),
        whole_scans(scans, yardsticks),
        include_str!("text/instructions.md").to_owned(),
        instructions(scans),
        include_str!("text/work.md").to_owned(),
        pieces(work),
        include_str!("text/timers.md").to_owned(),
        timer_states(timers),
        include_str!("text/jobs.md")
            .replace("SCANNED", &jobs::RUNGS.to_string())
            .replace("RESPONSE", &meter::RESPONSE.to_string()),
        longest_scans(jobs, scans),
        include_str!("text/polling.md").to_owned(),
        polled(polling),
        include_str!("text/stack.md").to_owned(),
        stack(modes),
        memories(modes),
        include_str!("text/mega.md").to_owned(),
        of_mega(*mega),
        include_str!("text/yardsticks.md").replace("COMPILER", &yardsticks.compiler),
        c_programs(yardsticks),
        include_str!("text/closing.md").to_owned(),
    ]
    .map(|part| part.trim_end().to_owned() + "\n")
    .join("\n")
}

fn whole_scans(scans: &Scans, yardsticks: &Yardsticks) -> String {
    let mut table = Table::new(&[
        "whole scan",
        "minimum",
        "mean",
        "maximum",
        "maximum without a ms interrupt",
        "mean, µs",
    ]);
    let quiet = |quiet: Option<Times>| quiet.map_or("–".to_owned(), |quiet| number(quiet.most));
    let mut row = |what: &str, Whole { all, quiet: calm }: Whole| {
        table.row([
            what.to_owned(),
            number(all.least),
            number(all.mean),
            number(all.most),
            quiet(calm),
            micros(all.mean),
        ]);
    };
    row("2 contacts and a coil", scans.small);
    row("100 rungs of 4 contacts and a coil", scans.large);
    row("the same and 32 timers", scans.full);
    let Times { least, mean, most } = scans.rung;
    format!(
        "{table}\nThe rung of 4 contacts and a coil takes {} cycles computed from the minimum, {} from the mean and {} from the \
         maximum.\nFor the same rung, LDmicro's bytecode takes {} cycles ({}), and the thesis's interpreter with division \
         takes {} ({}).\n",
        number(least),
        number(mean),
        number(most),
        number(LDMICRO_RUNG),
        ratio(LDMICRO_RUNG, mean),
        number(yardsticks.dividing.rung.mean),
        ratio(yardsticks.dividing.rung.mean, mean),
    )
}

fn of_mega(mega: Mega) -> String {
    let mut table = Table::new(&["what", "unoclp", "µs", "target", ""]);
    let [near, far] = mega.rungs;
    let large = format!("whole scan: {} such rungs", mega::MANY);
    for (what, cycles, target) in [
        (
            "rung of 4 contacts and a coil, points of a UNO, worst case",
            near,
            20,
        ),
        ("the same with other points, worst case", far, 30),
        ("whole scan: 2 contacts and a coil", mega.small, mega::SMALL),
        (&large, mega.large, mega::LARGE),
    ] {
        table.row([
            what.to_owned(),
            number(cycles as f64),
            micros(cycles as f64),
            format!("≤ {}", number(target as f64)),
            verdict(cycles <= target),
        ]);
    }
    table.row([
        "first instruction to RUN, program of 3,500 B".to_owned(),
        format!("{} ms", mega.start),
        "–".to_owned(),
        format!("≤ {} ms", number(mega::START as f64)),
        verdict(mega.start <= mega::START),
    ]);
    table.to_string()
}

fn instructions(scans: &Scans) -> String {
    let mut table = Table::new(&[
        "instruction",
        "shortest scans",
        "mean",
        "longest scans",
        "mean, µs",
    ]);
    for cost in &scans.costs {
        row_of_times(&mut table, cost.name.to_owned(), cost.cycles);
    }
    table.to_string()
}

fn pieces(work: &[Done]) -> String {
    let mut table = Table::new(&["work", "unoclp", "µs", "target", "", "compiled C"]);
    for done in work {
        let Done {
            cycles,
            compiled,
            target,
            ..
        } = *done;
        table.row([
            done.name.to_owned(),
            number(cycles),
            micros(cycles),
            format!("≤ {}", number(target)),
            verdict(cycles <= target),
            format!("{} ({})", number(compiled), ratio(compiled, cycles)),
        ]);
    }
    table.to_string()
}

fn timer_states(timers: &Timers) -> String {
    let mut table = Table::new(&["timer", "shortest scans", "longest scans", "longest, µs"]);
    for (block, states) in [("TON", &timers.ton), ("TOF", &timers.tof)] {
        for state in states {
            let Times { least, most, .. } = state.cycles;
            table.row([
                format!("{block} {}", state.name),
                number(least),
                number(most),
                micros(most),
            ]);
        }
    }
    format!(
        "{table}\nIn a run where {FULL_TIMERS} TONs start, time, expire and go off together, the longest scan takes {} cycles. \
         While all of\nthem are timing, the longest takes {} cycles.\n",
        number(timers.longest_of_run),
        number(timers.longest_timing),
    )
}

fn row_of_times(table: &mut Table, what: String, Times { least, mean, most }: Times) {
    table.row([
        what,
        number(least),
        number(mean),
        number(most),
        micros(mean),
    ]);
}

fn longest_scans(jobs: &Jobs, scans: &Scans) -> String {
    let mut table = Table::new(&["scan with", "minimum", "maximum", "maximum, µs"]);
    let mut row = |what: String, times: Times| {
        table.row([
            what,
            number(times.least),
            number(times.most),
            micros(times.most),
        ]);
    };
    row("nothing else".into(), jobs.quiet);
    row("the ms interrupt".into(), jobs.ticked);
    row("the jobs of each ms".into(), jobs.beside);
    row("saving STATE.TXT, all together".into(), jobs.saving.scans);
    row(
        format!(
            "all together, {} rungs and {FULL_TIMERS} timers",
            FULL_RUNGS
        ),
        jobs.full.scans,
    );
    let Times { least, mean, most } = scans.interrupt;
    format!(
        "{table}\nThe millisecond interrupt alone takes at least {} cycles, {} on average, and at most {}.\n\n{}",
        number(least),
        number(mean),
        number(most),
        savings(jobs)
    )
}

fn polled(polling: &[Polled]) -> String {
    let mut table = Table::new(&[
        "the client reads",
        "answers per second",
        "scans per second",
        "",
        "longest scan, µs",
    ]);
    let idle = polling.first().map_or(0.0, |first| first.scans);
    for polled in polling {
        table.row([
            polled.what.to_owned(),
            number(polled.answers),
            number(polled.scans),
            format!("{:+.0} %", 100.0 * (polled.scans / idle - 1.0)),
            micros(polled.most as f64),
        ]);
    }
    table.to_string()
}

fn savings(jobs: &Jobs) -> String {
    if jobs.saving.blocks == 0 {
        return "This firmware does not save STATE.TXT, so the last rows do not include it.\n"
            .into();
    }
    let added = |Saving { scans, without, .. }: Saving| scans.most - without.most;
    let most = added(jobs.saving).max(added(jobs.full));
    format!(
        "Saving lengthens the longest scan by {} cycles with the small program and by {} with the largest\n\
         (target: ≤ {}, 0.5 ms): {}.\n",
        number(added(jobs.saving)),
        number(added(jobs.full)),
        number(SAVING),
        verdict(most <= SAVING),
    )
}

fn stack(modes: &Modes) -> String {
    let mut table = Table::new(&["mode", "peak of the stack, B", "free, B"]);
    for mode in &modes.stack {
        let bytes = |bytes: Option<i32>| bytes.map_or("not in use".into(), |b| number(b.into()));
        table.row([
            mode.name.to_owned(),
            bytes(mode.peak.map(i32::from)),
            bytes(mode.free),
        ]);
    }
    table.to_string()
}

fn memories(modes: &Modes) -> String {
    let mut table = Table::new(&["memory", "used, B", "available, B"]);
    for (name, used, of) in [
        (
            "flash, without the boot loader of 512 B",
            modes.flash as f64,
            32_256.0,
        ),
        ("static RAM", f64::from(modes.static_ram), 2_048.0),
    ] {
        table.row([name.to_owned(), number(used), number(of)]);
    }
    table.to_string()
}

fn c_programs(yardsticks: &Yardsticks) -> String {
    let mut table = Table::new(&[
        "program in C",
        "rung of 4 contacts and a coil",
        "2 contacts and a coil, whole scan",
    ]);
    for (name, yardstick) in [
        ("the thesis's interpreter", yardsticks.thesis),
        ("the same, with division", yardsticks.dividing),
        ("the compiled C", yardsticks.compiled),
    ] {
        table.row([
            name.to_owned(),
            number(yardstick.rung.mean),
            number(yardstick.small.mean),
        ]);
    }
    table.to_string()
}
