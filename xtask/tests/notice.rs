//! `NOTICE` names what is linked and bundled.

use std::fs;

use xtask::notice::{self, Parts};
use xtask::shell::root;

#[test]
fn notice_names_what_is_handed_out() {
    let parts = Parts::find().unwrap();
    let kept = fs::read_to_string(root().join("NOTICE")).unwrap();
    assert!(
        kept == notice::expected(&parts).unwrap(),
        "NOTICE is not what is linked and bundled: run `cargo xtask notice`, and look at the licences that are new"
    );
    for name in [
        "avr-libc",
        "avr8js",
        "@codemirror/view",
        "serialport",
        "uplot",
    ] {
        assert!(kept.contains(name), "{name}");
    }
}

/// Each licence of a crate or package is one that a program under MIT or Apache-2.0 may contain.
#[test]
fn no_part_asks_for_more_than_to_be_named() {
    const TAKEN: [&str; 10] = [
        "MIT",
        "Apache-2.0",
        "BSD-2-Clause",
        "BSD-3-Clause",
        "ISC",
        "Zlib",
        "Unlicense",
        "BSL-1.0",
        // As MIT, for data of Unicode.
        "Unicode-3.0",
        // Its files stay under it, and are used as they are.
        "MPL-2.0",
    ];
    for (name, licence) in Parts::find().unwrap().licences() {
        let all = licence.split(" AND ");
        let taken = all.clone().all(|one| {
            let mut choices = one
                .split(" OR ")
                .flat_map(|one| one.split('/'))
                .map(|one| one.trim().trim_matches(['(', ')']));
            choices.any(|choice| TAKEN.contains(&choice))
        });
        assert!(taken, "{name}: {licence}");
    }
}

#[test]
fn the_texts_of_the_licences_go_with_them() {
    let texts = Parts::find().unwrap().texts().unwrap();
    for text in [
        "Permission is hereby granted",
        "Mozilla Public License",
        "Uri Shaked",
    ] {
        assert!(texts.contains(text), "{text}");
    }
}
