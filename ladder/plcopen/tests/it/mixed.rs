//! Random projects with bodies in all five languages, beside the same in Structured Text: the same outputs on random inputs,
//! scan by scan, as in `alike`. What is exported of the text comes back as the same codes.

use crate::alike::agree;
use crate::charts::{comes_back, large};
use unoclp_testing::{held, mixed_project, rounds, typed_program};

#[test]
fn random_projects_of_all_languages_mean_what_their_texts_mean() {
    let run = |seed: u64| {
        let (project, text) = mixed_project(seed);
        let changes = agree(&format!("seed {seed}"), &project, &text, 60);
        assert!(comes_back(&text, large()), "seed {seed}");
        changes
    };
    let changes = (0..rounds(120).into()).fold(0, |changes, seed| changes | held(|| run(seed)));
    assert!(changes == 0b1111 || rounds(120) < 120);
}

#[test]
fn random_texts_come_back() {
    let all = rounds(120);
    let back = |seed: u64| comes_back(&typed_program(seed, 8), large());
    let same = (0..all.into()).filter(|seed| held(|| back(*seed))).count();
    println!("{same} of {all} compile");
    assert!(all < 120 || same * 2 >= all as usize, "{same} of {all}");
}
