//! What the tests of several crates share: how many rounds they make.

use std::env;

/// Percent of the usual rounds: `cargo xtask test --quick` sets less than 100, `cargo xtask soak` more.
const ROUNDS: &str = "UNOCLP_ROUNDS";

fn percent() -> u32 {
    env::var(ROUNDS).map_or(100, |text| {
        let percent = text.parse().ok().filter(|&percent| percent > 0);
        percent.unwrap_or_else(|| panic!("{ROUNDS} is a percentage of 1 or more, not {text:?}"))
    })
}

/// How many rounds a random test makes that usually makes `usual`; at least one.
pub fn rounds(usual: u32) -> u32 {
    let rounds = u64::from(usual) * u64::from(percent()) / 100;
    rounds.clamp(1, u32::MAX.into()) as u32
}

/// All cases of a test that goes through every one of them. In a quick run, one of each few, evenly spread.
pub fn cases<T>(all: impl IntoIterator<Item = T>) -> impl Iterator<Item = T> {
    all.into_iter().step_by(100 / percent().min(100) as usize)
}
