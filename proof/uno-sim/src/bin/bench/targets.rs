//! The figures that have a target.

use crate::modes;
use crate::programs::{FULL_RUNGS, FULL_TIMERS};
use crate::report::Figures;
use crate::table::{Table, micros, number, ratio, verdict};
use crate::yardsticks::Yardsticks;

/// Targets, cycles.
const RUNG: f64 = 32.0;
const SMALL: f64 = 160.0;
const TIMER: f64 = 80.0;
const LARGE: f64 = 3_400.0;
const INTERRUPT: f64 = 35.0;
/// Targets, ms and bytes.
const TO_RUN: f64 = 350.0;
const FREE: i32 = 96;

/// Figures of others, cycles: measured with avr-gcc -Os in simavr, and not measured here.
const OPENPLC_RUNG: f64 = 42.0;
const OPENPLC_SMALL: f64 = 416.0;
const OPENPLC_TIMER: f64 = 1_081.0;
const OPENPLC_LARGE: f64 = 4_260.0;

/// They, beside those of the yardsticks and of others.
pub fn table(figures: &Figures) -> String {
    let Figures {
        yardsticks: Yardsticks {
            thesis, compiled, ..
        },
        scans,
        timers,
        modes,
        ..
    } = figures;
    let none = || "–".to_owned();
    let beside = |own: f64, other: f64| format!("{} ({})", number(other), ratio(other, own));
    let mut table = Table::new(&[
        "what",
        "unoclp",
        "µs",
        "target",
        "",
        "thesis's interpreter",
        "compiled C",
        "OpenPLC",
    ]);
    let mut row = |what: &str, own: f64, target: f64, others: [Option<f64>; 3]| {
        let [thesis, compiled, openplc] =
            others.map(|other| other.map_or_else(none, |other| beside(own, other)));
        table.row([
            what.to_owned(),
            number(own),
            micros(own),
            format!("≤ {}", number(target)),
            verdict(own <= target),
            thesis,
            compiled,
            openplc,
        ]);
    };
    row(
        "rung of 4 contacts and a coil",
        scans.rung.mean,
        RUNG,
        [
            Some(thesis.rung.mean),
            Some(compiled.rung.mean),
            Some(OPENPLC_RUNG),
        ],
    );
    row(
        "whole scan: 2 contacts and a coil, and the toggling rung",
        scans.small.all.mean,
        SMALL,
        [
            Some(thesis.small.mean),
            Some(compiled.small.mean),
            Some(OPENPLC_SMALL),
        ],
    );
    row(
        "a TON or TOF, maximum in any state",
        timers.most(),
        TIMER,
        [None, None, Some(OPENPLC_TIMER)],
    );
    row(
        "whole scan: 100 rungs of 4 contacts and a coil",
        scans.large.all.mean,
        LARGE,
        [None, Some(compiled.large.mean), Some(OPENPLC_LARGE)],
    );
    row(
        "millisecond interrupt, each ms",
        scans.interrupt.mean,
        INTERRUPT,
        [None; 3],
    );
    let mut other = |what: String, own: String, target: String, met: bool, openplc: &str| {
        table.row([
            what,
            own,
            none(),
            target,
            verdict(met),
            none(),
            none(),
            openplc.to_owned(),
        ]);
    };
    // Had they not run, there would be no figures at all.
    other(
        format!("{FULL_RUNGS} such rungs and {FULL_TIMERS} timers at once"),
        "run".into(),
        "run".into(),
        true,
        "6 timers with Modbus",
    );
    other(
        "… and the stack that remains free".into(),
        format!("{} B", number(modes.free_in_run.into())),
        format!("≥ {FREE} B"),
        modes.free_in_run >= FREE,
        "–",
    );
    let to_run = modes::ms(modes.reset_to_run);
    other(
        "reset to RUN without a card, program of 900 B".into(),
        format!("{to_run:.1} ms"),
        format!("≤ {TO_RUN} ms"),
        to_run <= TO_RUN,
        "–",
    );
    table.to_string()
}
