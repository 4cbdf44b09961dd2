//! Pieces of work in numeric code, each beside the same in C: logic, arithmetic, REAL numbers, a loop over a table.

use crate::meter::{Meter, Times};
use crate::programs::{self, Codes, INPUT, NEW_RUNG};
use crate::yardsticks::Workshop;
use anyhow::Result;
use unoclp_uno_sim::Program;

/// A piece of work, measured.
#[derive(Clone, Debug)]
pub struct Done {
    /// What it is.
    pub name: &'static str,
    /// Cycles, of the shortest scans.
    pub cycles: f64,
    /// Those of the same in C.
    pub compiled: f64,
    /// What is to be reached, cycles.
    pub target: f64,
}

/// A piece of work to measure.
struct Piece {
    name: &'static str,
    /// In numeric code; it may have a label of this number.
    codes: fn(i64) -> Codes,
    /// In C.
    c: &'static str,
    target: Target,
    /// How many of them are measured, at least and at most.
    counts: [usize; 2],
}

enum Target {
    /// Cycles.
    Cycles(f64),
    /// So many times what it takes in C.
    Compiled(f64),
}

const COIL: i64 = 877_901;
const PIECES: [Piece; 6] = [
    Piece {
        name: "rung of 4 contacts, the first 2 in parallel, and a coil",
        codes: |_| {
            let parallel = [INPUT + 1, 40, INPUT + 2, 41];
            rung(parallel.into_iter().chain([INPUT + 3, -(INPUT + 4), COIL]))
        },
        c: "q[0] = (i[0] | i[1]) & i[2] & NOT(i[3]);",
        target: Target::Cycles(30.0),
        counts: [10, 60],
    },
    Piece {
        name: "the same pair in the middle, with a branch point",
        codes: |_| {
            let parallel = [404_101, INPUT + 1, 40, 404_101, INPUT + 2, 41];
            let behind = [-(INPUT + 4), COIL];
            rung([INPUT + 3].into_iter().chain(parallel).chain(behind))
        },
        c: "q[0] = i[2] & (i[0] | i[1]) & NOT(i[3]);",
        target: Target::Cycles(40.0),
        counts: [10, 60],
    },
    Piece {
        name: "two markers in series and a coil",
        codes: |_| rung([827_701, 827_702, COIL]),
        c: "q[0] = m[1] & m[2];",
        target: Target::Cycles(26.0),
        counts: [10, 60],
    },
    Piece {
        name: "`D3 := D1 + D2 * 10`",
        codes: |_| rung([766_802, 77_857_600, 10, 65_686_801, 838_403]),
        c: "d[3] = d[1] + d[2] * 10;",
        target: Target::Compiled(2.0),
        counts: [5, 25],
    },
    Piece {
        name: "`D3 := D1 * D2 + D4` in REAL",
        codes: |_| rung([766_801, 82_778_502, 82_656_804, 838_403]),
        c: "r[3] = r[1] * r[2] + r[4];",
        target: Target::Compiled(1.4),
        counts: [5, 25],
    },
    Piece {
        name: "sum of a table of 10 in a loop",
        codes: |label| {
            // D 03 is the sum, D 04 the index, D 11 to D 20 the table.
            let first = [766_800, 0, 838_403, 838_404];
            let sum = [766_804, 76_688_811, 10, 65_686_803, 838_403];
            let next = [
                766_804,
                65_686_800,
                1,
                838_404,
                768_400,
                10,
                74_778_000 + label,
            ];
            let round = [766_600 + label].into_iter().chain(sum).chain(next);
            rung(first)
                .into_iter()
                .chain([NEW_RUNG])
                .chain(round)
                .collect()
        },
        c: "{ d[3] = 0; for (d[4] = 0; d[4] < 10; d[4]++) d[3] += d[11 + d[4]]; }",
        target: Target::Compiled(5.0),
        counts: [1, 4],
    },
];

/// Markers as inputs 01 and 02 are, and the numbers that are reckoned with, as `proof/bench/work.c` has them.
fn opening() -> Codes {
    let markers = [NEW_RUNG, INPUT + 1, 877_701, NEW_RUNG, INPUT + 2, 877_702];
    let whole = [NEW_RUNG, 766_800, 12_345, 838_401, 766_800, -678, 838_402];
    markers.into_iter().chain(whole).collect()
}

/// The same with REAL numbers.
fn real_opening() -> Codes {
    let bits = |number: f32| i64::from(number.to_bits().cast_signed());
    let numbers = [(1.7, 838_401), (-2.3, 838_402), (40.1, 838_404)];
    let stores = numbers.map(|(number, store)| [766_800, bits(number), store]);
    [NEW_RUNG].into_iter().chain(stores.concat()).collect()
}

fn rung(codes: impl IntoIterator<Item = i64>) -> Codes {
    [NEW_RUNG].into_iter().chain(codes).collect()
}

/// Measures all.
pub fn measure(firmware: &Program, workshop: &Workshop) -> Result<Vec<Done>> {
    PIECES
        .iter()
        .map(|piece| done(piece, firmware, workshop))
        .collect()
}

fn done(piece: &Piece, firmware: &Program, workshop: &Workshop) -> Result<Done> {
    let opening = match piece.name.contains("REAL") {
        true => real_opening(),
        false => opening(),
    };
    let own = |count: usize| {
        let pieces = (1..=count as i64).flat_map(piece.codes);
        let codes = programs::toggled(opening.iter().copied().chain(pieces));
        Times::of(Meter::firmware(firmware, &codes)?.all_inputs()?)
    };
    let compiled = |count: usize| {
        let program = workshop.work(&format!("{}\n", piece.c).repeat(count))?;
        Times::of(Meter::yardstick(&program)?.all_inputs()?)
    };
    let [few, many] = piece.counts;
    let cycles = own(many)?.each(own(few)?, many - few).least;
    let compiled = compiled(many)?.each(compiled(few)?, many - few).least;
    Ok(Done {
        name: piece.name,
        cycles,
        compiled,
        target: match piece.target {
            Target::Cycles(cycles) => cycles,
            Target::Compiled(times) => times * compiled,
        },
    })
}
