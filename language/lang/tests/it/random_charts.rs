//! Random charts: the interpreter and the board's core do what the standard says, scan by scan. `uno-sim` has the firmware do
//! the same.
//!
//! `UNOCLP_SEED` is the first seed.

use crate::board::{Twins, errors, large, none_differs, with_plc};
use unoclp_core::Board;
use unoclp_lang::typed::{Tree, Value};
use unoclp_lang::{TextLanguage, compile_text};
use unoclp_testing::chart::{Naive, sketch};
use unoclp_testing::{Random, rounds};

const CHARTS: u32 = 500;
const SCANS: u32 = 60;

/// What differs between the standard and the interpreter, by the names of the text.
fn difference(naive: &Naive<'_>, twins: &Twins<'_>, tree: &Tree, before: &str) -> Option<String> {
    let bit = |is: &bool| i128::from(*is);
    let named = |letter: &str, part: &str, values: Vec<i128>| {
        let values = values.into_iter().enumerate();
        let one = |(n, value)| (format!("{before}{letter}{n}{part}"), value);
        values.map(one).collect::<Vec<_>>()
    };
    let mut all = named("s", ".X", naive.active.iter().map(bit).collect());
    all.extend(named("v", "", naive.variables.iter().map(bit).collect()));
    all.extend(named("b", "", naive.shows.iter().map(bit).collect()));
    let counts = naive.counts.iter().map(|count| i128::from(*count));
    all.extend(named("n", "", counts.collect()));
    all.push((format!("{before}x"), naive.shared.into()));
    for (name, wanted) in all {
        let symbol = tree.symbols.iter().find(|symbol| symbol.name == name)?;
        let (value, _) = twins.machine.value(symbol);
        if value.int() != wanted {
            return Some(format!("{name} is {value:?}, but {wanted} by the standard"));
        }
    }
    None
}

/// Whether the chart of this seed ran on this board.
///
/// # Errors
/// What differs.
fn compared(seed: u64, board: Board) -> Result<bool, String> {
    let chart = sketch(seed);
    let is_block = seed.is_multiple_of(5);
    let text = chart.text(is_block);
    let made = compile_text(&text, TextLanguage::St, board);
    if let Some(errors) = errors(&made) {
        return match errors.contains("ST-20") || errors.contains("S0 ") {
            true => Ok(false),
            false => Err(format!("seed {seed} does not compile: {errors}\n{text}")),
        };
    }
    let places = made.places();
    let (Some(tree), Some((mut checked, _))) = (made.tree, made.program) else {
        return Ok(false);
    };
    let before = if is_block { "c." } else { "" };
    with_plc(&mut checked, |plc| {
        let mut twins = Twins::new(&tree, &places);
        let mut naive = Naive::new(&chart);
        let random = &mut Random(seed ^ 0xC4A7);
        let mut now = random.below(1_000) as u32;
        for scan in 0..SCANS {
            for (at, symbol) in tree.symbols.iter().enumerate() {
                let is_input =
                    symbol.name.starts_with("%IX") || !is_block && symbol.name.starts_with('i');
                if is_input && random.percent(30) {
                    twins.set(plc, at, &Value::Int(random.below(2) as i128));
                }
            }
            let points = twins.inputs().points.0;
            let inputs = [0, 1, 2, 3].map(|input| points >> input & 1 != 0);
            naive.scan(inputs, now.into());
            let ran = twins.scan(plc, now);
            let differs = ran
                .err()
                .or_else(|| difference(&naive, &twins, &tree, before));
            if let Some(why) = differs {
                return Err(format!("seed {seed}, scan {scan}: {why}\n{text}"));
            }
            now += random.below(30) as u32;
        }
        Ok(true)
    })
}

#[test]
fn random_charts_do_what_the_norm_says() {
    all_do(large());
}

/// What has no marker stands in a register.
#[test]
fn random_charts_do_so_where_most_bits_stand_in_registers() {
    all_do(Board {
        markers: 3,
        ..large()
    });
}

fn all_do(board: Board) {
    none_differs(rounds(CHARTS), 90, |seed| compared(seed, board));
}
