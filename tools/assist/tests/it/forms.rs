//! A text that is formed says the same, and is formed once and for all.

use crate::texts::{alike, all, text, written};
use unoclp_assist::{edited, format};
use unoclp_program::Written;
use unoclp_testing::{Random, held, rounds, typed_program};

fn formed(written: &Written) -> String {
    edited(&written.text(), &format(written, None))
}

/// Holds a text to its codes and its comments, and to its form.
fn keeps(before: &Written) -> String {
    let formed = formed(before);
    let mut after = before.clone();
    after.bytes = formed.clone().into_bytes();
    assert_eq!(self::formed(&after), formed, "{}", before.name);
    let solid = |text: &str| text.split_whitespace().collect::<String>();
    assert_eq!(solid(&before.text()), solid(&formed), "{}", before.name);
    assert!(alike(before, &after), "{}:\n{formed}", before.name);
    formed
}

#[test]
fn programs_keep_their_codes() {
    for path in all() {
        keeps(&written(&path));
    }
}

/// The samples that are written as most people write are what the form comes to.
#[test]
fn what_is_well_written_stays() {
    let stays = |path: &std::path::PathBuf| {
        let written = written(path);
        formed(&written) == written.text()
    };
    let paths = all();
    let kept = paths.iter().filter(|path| stays(path)).count();
    assert!(kept * 10 > paths.len() * 8, "{kept} of {}", paths.len());
}

#[test]
fn a_place_that_is_left_open_stays_one_word() {
    let open = text("st", "VAR\n  a AT %M* : BOOL;\nEND_VAR\na := TRUE;\n");
    assert!(keeps(&open).contains("%M* : BOOL"));
}

/// Blanks taken out of and put into random programs change nothing, and come back to one form.
#[test]
fn random_programs_keep_their_codes() {
    let compare = |seed: u32| {
        let mut random = Random(seed.into());
        let program = typed_program(seed.into(), 4 + seed as usize % 9);
        let shaken: String = program
            .lines()
            .map(|line| {
                let blanks = " ".repeat(random.below(9));
                let line = line.trim_start().replace(
                    " := ",
                    if random.below(2) == 0 {
                        ":="
                    } else {
                        "   :=  "
                    },
                );
                let line = line.replace(" + ", "+").replace(", ", ",");
                format!("{blanks}{line}{}\n", " ".repeat(random.below(3)))
            })
            .collect();
        let before = text("st", &program);
        let after = text("st", &shaken);
        assert!(alike(&before, &after), "{shaken}");
        keeps(&before);
        keeps(&after);
    };
    (0..rounds(60)).for_each(|seed| held(|| compare(seed)));
}

/// Whatever is written: no panic, nothing lost, the same again.
#[test]
fn scraps_are_formed_or_left_alone() {
    for path in all() {
        let whole = written(&path);
        let own = whole.text();
        for part in 1..8 {
            let mut end = own.len() * part / 8;
            while !own.is_char_boundary(end) {
                end -= 1;
            }
            let mut scrap = whole.clone();
            scrap.bytes = own.as_bytes()[..end].to_vec();
            keeps(&scrap);
        }
    }
}
