//! `unoclp plant`, `unoclp sim --plant`, and machines in `unoclp grade` and `unoclp mutants`.

use crate::common::{empty_folder, outcome};
use std::fs;
use std::path::{Path, PathBuf};

fn plants(name: &str) -> String {
    let folder: PathBuf = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../programs/plants");
    folder.join(name).to_str().unwrap().to_owned()
}

#[test]
fn a_program_that_controls_a_machine_well_passes() {
    let (program, plant) = (plants("garage.st"), plants("garage.toml"));
    let (code, said, told) = outcome(&["sim", &program, "--plant", &plant]);
    assert_eq!(code, 0, "{said}{told}");
    assert_eq!(
        said,
        "A garage door\n  rules kept: 3 of 3; goals met: 4 of 4\nthe machine does what it should: PASS\n"
    );
}

/// Its program is for the board that it names; for one that lacks its points it is not compiled.
#[test]
fn a_machine_brings_its_board() {
    let (program, plant) = (plants("three-bins.st"), plants("three-bins.toml"));
    let (code, said, told) = outcome(&["sim", &program, "--plant", &plant]);
    assert_eq!(code, 0, "{said}{told}");
    let arguments = ["sim", &program, "--plant", &plant, "--board", "uno"];
    let (code, said, told) = outcome(&arguments);
    assert_ne!(code, 0, "{said}");
    assert!(told.contains("use --board mega"), "{told}");
}

#[test]
fn a_rule_that_breaks_is_told_with_its_second_and_drawn() {
    let folder = empty_folder("plant-broken");
    let svg = folder.join("strip.svg").to_str().unwrap().to_owned();
    let (program, plant) = (plants("wrong/garage-beam.st"), plants("garage.toml"));
    let arguments = [
        "sim", &program, "--plant", &plant, "--lang", "pt", "--svg", &svg,
    ];
    let (code, said, told) = outcome(&arguments);
    assert_eq!(code, 1, "{said}{told}");
    let first = "aos 15.";
    assert!(
        said.contains(first) && said.contains("Ninguém é esmagado"),
        "{said}"
    );
    let drawing = fs::read_to_string(&svg).unwrap();
    // Three moments, of which the last has the damage.
    assert_eq!(drawing.matches("class=\"title\"").count(), 3);
    roxmltree::Document::parse(&drawing).unwrap();
    let (code, ..) = outcome(&[
        "sim", &program, "--plant", &plant, "--svg", &svg, "--at", "1s,2.5s",
    ]);
    assert_eq!(code, 1);
    assert_eq!(
        fs::read_to_string(&svg)
            .unwrap()
            .matches("class=\"title\"")
            .count(),
        2
    );
}

/// The animation of README: `unoclp sim … --gif` makes it.
#[cfg(feature = "gif")]
#[test]
fn a_run_becomes_a_moving_picture() {
    let folder = empty_folder("plant-film");
    let gif = folder.join("filling.gif").to_str().unwrap().to_owned();
    let (program, plant) = (plants("filling.st"), plants("filling.toml"));
    let arguments = [
        "sim", &program, "--plant", &plant, "--gif", &gif, "--span", "0s-12s",
    ];
    let (code, said, told) = outcome(&arguments);
    assert_eq!(code, 0, "{said}{told}");
    let bytes = fs::read(&gif).unwrap();
    assert!(bytes.len() < 1_500_000, "{}", bytes.len());
    let mut decoder = gif::DecodeOptions::new().read_info(&bytes[..]).unwrap();
    let mut frames = 0;
    while decoder.read_next_frame().unwrap().is_some() {
        frames += 1;
    }
    assert_eq!(frames, 121);
}

#[test]
fn what_is_wrong_with_the_arguments_is_told() {
    let (program, plant) = (plants("garage.st"), plants("garage.toml"));
    for (more, words) in [
        (["--at", "tomorrow"], "tomorrow is not a time"),
        (["--at", "2min"], "2min is after the end of the run (60 s)"),
    ] {
        let arguments = [&["sim", &program, "--plant", &plant][..], &more].concat();
        let (code, _, told) = outcome(&arguments);
        assert_ne!(code, 0);
        assert!(told.contains(words), "{told}");
    }
    let (code, _, told) = outcome(&["sim", "--plant", &plant]);
    assert_ne!(code, 0);
    assert!(told.contains("a machine needs a program"), "{told}");
    let (code, _, told) = outcome(&["sim", &program, "--svg", "x.svg"]);
    assert_ne!(code, 0);
    assert!(told.contains("--svg draws the run of"), "{told}");
}

#[test]
fn a_plant_alone_is_told_and_drawn_or_its_mistakes_are() {
    let folder = empty_folder("plant-alone");
    let svg = folder.join("press.svg").to_str().unwrap().to_owned();
    let (code, said, _) = outcome(&["plant", "check", &plants("press.toml")]);
    assert_eq!(code, 0);
    assert!(
        said.contains("parts: 5, rules: 4, goals: 2; a run takes 40 s\n  rule: Nobody is hurt\n"),
        "{said}"
    );
    let (code, said, told) = outcome(&["plant", "draw", &plants("press.toml"), &svg]);
    assert_eq!(code, 0, "{said}{told}");
    roxmltree::Document::parse(&fs::read_to_string(&svg).unwrap()).unwrap();
    let wrong = folder.join("wrong.toml").to_str().unwrap().to_owned();
    let text = fs::read_to_string(plants("press.toml")).unwrap();
    fs::write(&wrong, text.replace("to = \"I2\"", "to = \"I1\"")).unwrap();
    let (code, said, _) = outcome(&["plant", "check", &wrong]);
    assert_eq!(code, 1);
    assert!(
        said.contains("left also sets I1; choose another input"),
        "{said}"
    );
}

#[test]
fn an_exercise_with_a_machine_has_two_verdicts() {
    let folder = empty_folder("plant-grade");
    let exercise = folder.join("motor.toml").to_str().unwrap().to_owned();
    let text = format!(
        "title = \"Motor\"\nprogram = {:?}\nplant = {:?}\n[[case]]\ntitle = \"Rest\"\nuntil = 100\nstep = [{{ at = 0, set = {{ I2 = 1, I3 = 1 }}, expect = {{ Q1 = 0 }} }}]\n",
        plants("motor.st"),
        plants("motor.toml"),
    );
    fs::write(&exercise, text).unwrap();
    let programs = [plants("motor.st"), plants("wrong/motor-relay.st")];
    let (code, said, told) = outcome(&["grade", &exercise, &programs[0], &programs[1]]);
    assert_eq!(code, 1, "{said}{told}");
    assert!(
        said.contains("machine") && said.contains("the overload relay has tripped"),
        "{said}"
    );
    assert!(said.contains("Motor: 1 of 2 passed"), "{said}");
    let (_, said, _) = outcome(&["grade", &exercise, &programs[1], "--csv"]);
    let mut lines = said.lines();
    assert_eq!(
        lines.next(),
        Some("file,exercise,passed,cases passed,cases,first failing case,machine")
    );
    assert!(
        lines
            .next()
            .is_some_and(|line| line.contains(",no,1,1,,at 23.145 s a rule was broken")),
        "{said}"
    );
    // What the one case and the machine leave open.
    let (code, said, _) = outcome(&["mutants", &exercise]);
    assert_eq!(code, 1);
    assert!(
        said.contains("two coils swapped: ST Q1 → ST Q2\n"),
        "{said}"
    );
    assert!(
        said.ends_with("wrong programs that pass: 2 of 14\n"),
        "{said}"
    );
}

/// A machine whose one part is plastic with its own chance, and metal with the hidden chance 2.
const BY_CHANCE: &str = r#"title = "Belt"
until = "12 s"
seed = 4
[[part]]
name = "belt"
kind = "belt"
run = "Q1"
onto = "rest"
long = "1 m"
speed = "400 mm/s"
[[part]]
name = "feeder"
kind = "feeder"
onto = "belt"
every = "400 mm"
things = "mixed"
most = 1
[[part]]
name = "rest"
kind = "bin"
wants = "plastic"
[[never]]
when = "rest.wrong > 0"
text = { en = "No metal", pt = "Nenhum metal" }
"#;

/// What chance brings is hidden from a student, whose page tells nothing of it (`page/bridge/tests/machine.rs`), and told to
/// the teacher who grades.
#[test]
fn hidden_chances_are_told_to_the_teacher() {
    let folder = empty_folder("plant-seeds");
    let put = |name: &str, text: &str| {
        let path = folder.join(name);
        fs::write(&path, text).unwrap();
        path.to_str().unwrap().to_owned()
    };
    put("belt.toml", BY_CHANCE);
    let exercise = |seeds: &str| {
        let text = format!(
            "title = \"Belt\"\nplant = \"belt.toml\"\n{seeds}[[case]]\ntitle = \"It runs\"\nuntil = 20\nstep = [{{ at = 10, expect = {{ Q1 = 1 }} }}]\n"
        );
        put("exercise.toml", &text)
    };
    let program = put("runs.il", "LDN M1\nST Q1\n");
    let (code, said, told) = outcome(&["grade", &exercise(""), &program]);
    assert_eq!(code, 0, "its own chance alone: {said}{told}");
    let (code, said, _) = outcome(&["grade", &exercise("seeds = [5, 6]\n"), &program]);
    assert_eq!(code, 0, "{said}");
    let hidden = exercise("seeds = [5, 2]\n");
    let (code, said, _) = outcome(&["grade", &hidden, &program, "--csv"]);
    assert_eq!(code, 1, "{said}");
    assert!(
        said.contains(
            ",no,1,1,,with hidden random values (seed 2): at 2.599 s a rule was broken: No metal"
        ),
        "{said}"
    );
}
