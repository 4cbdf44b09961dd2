//! Exercises: their cases run by `unoclp sim`, and what it draws of them.

use crate::common::{empty_folder, outcome};
use std::fs;
use std::path::{Path, PathBuf};

/// A lamp that follows its button, and a lamp that remembers.
const EXERCISE: &str = r#"
title = { en = "A lamp with memory", pt = "Uma lâmpada com memória" }
task = { en = "I1 lights Q1, I2 puts it out.", pt = "I1 acende Q1, I2 apaga." }
names = { I1 = { en = "on <1>", pt = "liga" }, Q1 = { en = "lamp", pt = "lâmpada" } }
scan_ms = 10
within_ms = 20
[[case]]
title = { en = "On", pt = "Liga" }
step = [
  { at = 0, expect = { Q1 = 0 } },
  { at = 100, set = { I1 = 1 }, expect = { Q1 = 1 } },
]
[[case]]
title = { en = "It stays", pt = "Continua" }
hidden = true
step = [
  { at = 0, set = { I1 = 1 } },
  { at = 100, set = { I1 = 0 }, expect = { Q1 = 1 } },
]
until = 300
"#;
const FOLLOWS: &str = "LD I1\nST Q1\n";
const REMEMBERS: &str = "LD I1\nOR Q1\nANDN I2\nST Q1\n";

/// A folder with the exercise in it.
fn folder(name: &str) -> PathBuf {
    let folder = empty_folder(name);
    fs::write(folder.join("lamp.toml"), EXERCISE).unwrap();
    folder
}

/// A file in a folder, by its path.
fn put(folder: &Path, name: &str, text: impl AsRef<[u8]>) -> String {
    let path = folder.join(name);
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    fs::write(&path, text).unwrap();
    path.to_str().unwrap().to_owned()
}

#[test]
fn sim_runs_all_cases_or_one() {
    let folder = folder("exercise-sim");
    let exercise = put(&folder, "lamp.toml", EXERCISE);
    let follows = put(&folder, "follows.il", FOLLOWS);
    let (code, out, _) = outcome(&["sim", &follows, "--scenario", &exercise]);
    assert_eq!(code, 1);
    let [first, second] = ["lamp.toml: On\n", "lamp.toml: It stays\n"].map(|title| out.find(title));
    assert!(first < second && first.is_some(), "{out}");
    assert!(out.contains("PASS") && out.contains("FAIL"), "{out}");
    let case = |number: &str| {
        let (code, out, err) =
            outcome(&["sim", &follows, "--scenario", &exercise, "--case", number]);
        (code, out + &err)
    };
    assert_eq!(case("1").0, 0);
    assert_eq!(case("2").0, 1);
    let (code, told) = case("3");
    assert!(code == 2 && told.contains("there is no case 3"), "{told}");
    let trace = folder.join("out.vcd");
    let trace = ["--vcd", trace.to_str().unwrap()];
    let (code, _, err) =
        outcome(&[&["sim", &follows, "--scenario", &exercise], &trace[..]].concat());
    assert!(code == 2 && err.contains("--case"), "{err}");
}

#[test]
fn sim_draws_what_was_pressed_expected_and_came() {
    let folder = folder("exercise-svg");
    let exercise = put(&folder, "lamp.toml", EXERCISE);
    let drawing = folder.join("out.svg");
    for (program, passes) in [(FOLLOWS, false), (REMEMBERS, true)] {
        let program = put(&folder, "program.il", program);
        let drawing = drawing.to_str().unwrap();
        let (code, _, err) = outcome(&["sim", &program, "--scenario", &exercise, "--svg", drawing]);
        assert_eq!(code, i32::from(!passes), "{err}");
        let svg = fs::read_to_string(drawing).unwrap();
        for text in ["I1 on &lt;1&gt;", "Q1 lamp", "expected", "came", "It stays"] {
            assert!(svg.contains(text), "{text} in {svg}");
        }
        let why = "FAIL: Q1 at 120 ms: expected 1, came 0";
        assert_eq!(svg.contains(why), !passes, "{svg}");
    }
}
