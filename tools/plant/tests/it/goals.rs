//! When the time of a goal is over.

use crate::plant;
use unoclp_plant::{Missed, Outputs, Run};

fn missed(within: &str, until: u64) -> Vec<Missed> {
    let plant = plant(&format!(
        "title = \"Lamp\"\nuntil = \"{until} ms\"\n[[part]]\nname = \"lamp\"\nkind = \"lamp\"\nby = \"Q1\"\n\
         [[goal]]\nwhen = \"lamp.lit\"\nwithin = \"{within}\"\n"
    ));
    let mut run = Run::new(&plant, plant.seed);
    while run.now() < plant.until {
        run.step(&Outputs::default());
    }
    run.verdict().missed.clone()
}

/// A goal that has until the end of the script is judged too, and one that has longer is not.
#[test]
fn a_goal_has_until_the_end_and_no_longer() {
    let late = |at| Missed {
        goal: 0,
        since: 0,
        at,
    };
    assert_eq!(missed("500 ms", 1000), [late(500)]);
    assert_eq!(missed("1 s", 1000), [late(1000)]);
    assert_eq!(missed("1001 ms", 1000), []);
}
