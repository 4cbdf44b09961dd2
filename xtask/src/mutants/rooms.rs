//! The rooms whose tests are tested, and which tests they are.

/// The version that is used; another one makes other mutants.
pub const VERSION: &str = "27.1.0";

/// A room whose tests are tested.
pub struct Room {
    /// Where it is; a part of a package may be one.
    pub name: &'static str,
    pub package: &'static str,
    /// Tests that notice most mutants in no time, and those that see what is left.
    pub rounds: &'static [Tests],
}

/// Tests that are run together.
pub struct Tests {
    /// Their packages.
    pub packages: &'static [&'static str],
    /// Targets of these packages, as cargo names them; all of them where there is none.
    pub targets: &'static [&'static str],
    /// What the tests' own program is told.
    pub words: &'static [&'static str],
    /// Percent of their usual rounds.
    pub percent: u32,
    /// Seconds that they may take: many times what they do where nothing else runs. A mutant that takes longer hangs.
    pub patience: u32,
}

/// All tests of packages.
const fn of(packages: &'static [&'static str]) -> Tests {
    Tests {
        packages,
        targets: &[],
        words: &[],
        percent: 100,
        patience: 300,
    }
}

/// The same in few rounds: most mutants fall in the first of them.
const fn few(packages: &'static [&'static str]) -> Tests {
    Tests {
        percent: 5,
        patience: 20,
        ..of(packages)
    }
}

/// What compilers come to: their cases, then all but what compiles the largest and the most random texts.
const fn of_languages(packages: &'static [&'static str]) -> [Tests; 2] {
    // One program of tests: to build others takes longer than to run them.
    let cases = Tests {
        targets: &["--test=it"],
        words: &["cases", "sizes", "variables", "typed_slips", "random_typed"],
        percent: 30,
        ..few(&["unoclp-lang"])
    };
    // The examples in comments cost more than they tell.
    let targets = &["--tests"];
    let others = Tests {
        targets,
        words: &["--skip=any_text", "--skip=round_trip::random"],
        ..of(packages)
    };
    [cases, others]
}

/// All of them.
pub const ROOMS: [Room; 5] = [
    Room {
        name: "device/core",
        package: "unoclp-core",
        rounds: &[
            few(&["unoclp-core"]),
            Tests {
                targets: &["--tests"],
                ..of(&["unoclp-core", "unoclp-host-sim"])
            },
        ],
    },
    Room {
        name: "ladder/draw/src/edit",
        package: "unoclp-draw",
        rounds: &[few(&["unoclp-draw"]), of(&["unoclp-draw", "unoclp-edit"])],
    },
    Room {
        name: "language/codegen",
        package: "unoclp-codegen",
        rounds: &of_languages(&["unoclp-codegen", "unoclp-lang"]),
    },
    Room {
        name: "language/tree",
        package: "unoclp-tree",
        rounds: &of_languages(&["unoclp-tree", "unoclp-lang"]),
    },
    Room {
        name: "tools/client",
        package: "unoclp-client",
        rounds: &[Tests {
            patience: 20,
            ..of(&["unoclp-client"])
        }],
    },
];
