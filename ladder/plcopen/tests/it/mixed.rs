//! Random projects with bodies in all five languages, beside the same in Structured Text: the same outputs on random inputs,
//! scan by scan, as in `alike`. What is exported of the text comes back as the same codes.

use crate::alike::agree;
use crate::charts::{comes_back, large};
use unoclp_testing::{mixed_project, rounds, typed_program};

#[test]
fn random_projects_of_all_languages_mean_what_their_texts_mean() {
    let mut changes = 0;
    for seed in 0..u64::from(rounds(120)) {
        let (project, text) = mixed_project(seed);
        changes |= agree(&format!("seed {seed}"), &project, &text, 60);
        assert!(comes_back(&text, large()), "seed {seed}");
    }
    assert!(changes == 0b1111 || rounds(120) < 120);
}

#[test]
fn random_texts_come_back() {
    let all = rounds(120);
    let same = (0..u64::from(all)).filter(|seed| comes_back(&typed_program(*seed, 8), large()));
    let same = same.count();
    println!("{same} of {all} compile");
    assert!(all < 120 || same * 2 >= all as usize, "{same} of {all}");
}
