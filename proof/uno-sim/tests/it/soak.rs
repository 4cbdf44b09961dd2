//! Long runs on the board's own clock, beside the core: the same outputs in every millisecond.

use crate::common;
use unoclp_core::{Image, Inputs, Needs};
use unoclp_host_sim::engine::{Engine, HostEngine};
use unoclp_host_sim::random::{Random, random_inputs};
use unoclp_testing::rounds;
use unoclp_uno_sim::engine::{Clock, UnoEngine};

/// Timers that drive timers, none of whose outputs depends on how many scans go into a
/// millisecond.
const TEXT: &str = "0\n827301\n847978\n70\n7901\n847970\n130\n7902\n787600\n827302\n-827303\n847970\n45\n7903\n787600\n827303\n827304\n847978\n20\n7904\n847970\n300\n7904\n";

/// Simulated time.
const SECONDS: u32 = 60;

#[test]
fn a_long_run_is_alike_in_every_millisecond() {
    let seconds = rounds(SECONDS);
    let mut uno = UnoEngine::new(common::firmware(), Clock::Running).unwrap();
    let mut host = HostEngine::new(unoclp_core::Board::UNO);
    let Ok(loaded) = host.load(TEXT.as_bytes());
    assert_eq!(loaded, Ok(()));
    assert_eq!(uno.load(TEXT.as_bytes()).unwrap(), Ok(()));

    let random = &mut Random::new(7);
    let (mut inputs, mut before, mut changes) = (Inputs::default(), Ok(Image::default()), 0u64);
    // Across the wrap of the clock too.
    let start = u32::MAX - 30_000;
    for ms in 0..seconds.saturating_mul(1000) {
        if random.percent(2) {
            inputs = random_inputs(random, Needs::default(), inputs);
        }
        let now = start.wrapping_add(ms);
        let Ok(expected) = host.scan(&inputs, now);
        let came = uno.scan(&inputs, now).unwrap();
        assert_eq!(came, expected, "after {ms} ms");
        changes += u64::from(came != before);
        before = came;
    }
    println!(
        "{seconds} simulated seconds alike in every millisecond, outputs changed {changes} times"
    );
    assert!(changes > u64::from(seconds), "{changes}");
}
