//! The machines of the exercises: each model solution controls its own, what is typically wrong breaks a rule, and no mutant
//! passes both verdicts. What the machines catch alone is told in the pages.

use crate::exercises::{exercises, files, of_folders, program, says, stem, wrong};
use std::fs;
use std::path::{Path, PathBuf};
use unoclp_exercise::find::{Answer, Search};
use unoclp_exercise::machine::{First, first_wrong, with_chances};
use unoclp_exercise::mutants::passing;
use unoclp_exercise::scenario::{Exercise, ProgramFile, grade, passes};
use unoclp_host_sim::engine::HostEngine;
use unoclp_plant::{Plant, Run, read};
use unoclp_program::Lang;

/// The machine of an exercise.
fn plant(exercise: &Exercise) -> Option<Plant> {
    let path = exercise.plant.as_ref()?;
    let text = fs::read_to_string(path).unwrap_or_else(|error| panic!("{path:?}: {error}"));
    let plant = read(&text, exercise.board).unwrap_or_else(|mistakes| {
        let told = mistakes
            .iter()
            .map(|mistake| mistake.text("machine", Lang::En));
        panic!("{path:?}: {}", told.collect::<Vec<_>>().join("\n"))
    });
    Some(plant)
}

/// What goes wrong first with a machine, in words.
fn first(plant: &Plant, code: &[u8]) -> Option<String> {
    let engine = &mut HostEngine::new(plant.board);
    let first = first_wrong(plant, plant.seed, code, engine).unwrap();
    first.map(|first| match first {
        First::Broken(broken) => plant.nevers[broken.rule].text.en.clone(),
        First::Missed(missed) => plant.goals[missed.goal].text.en.clone(),
    })
}

#[test]
fn each_model_solution_controls_its_machine() {
    let (mut count, mut hidden) = (0, 0);
    for (name, exercise) in exercises() {
        let Some(plant) = plant(&exercise) else {
            continue;
        };
        count += 1;
        let code = program(exercise.program.as_deref().unwrap(), exercise.board).bytes;
        let engine = &mut HostEngine::new(plant.board);
        let wrong = with_chances(&plant, &exercise.seeds, &code, engine).unwrap();
        let told = wrong.map(|wrong| wrong.text(&plant, Lang::En));
        assert_eq!(told, None, "{name}");
        hidden += exercise.seeds.len();
    }
    assert!(count >= 36 && hidden > 4, "{count}, {hidden}");
}

#[test]
fn each_mistake_that_the_cases_do_not_see_breaks_its_rule() {
    let mut count = 0;
    for (name, exercise) in exercises() {
        for file in wrong(&name) {
            let Some(rule) = says(&file, "Breaks") else {
                continue;
            };
            count += 1;
            let plant = plant(&exercise).unwrap();
            assert_eq!(
                first(&plant, &program(&file, exercise.board).bytes),
                Some(rule),
                "{file:?}"
            );
        }
    }
    assert!(count > 2, "{count}");
}

/// The typical mistakes for the machine of an exercise: its own, and those of the machine where that is one of the gallery.
fn mistakes(name: &str, exercise: &Exercise) -> Vec<PathBuf> {
    let mut all = wrong(name);
    let machine = exercise.plant.as_deref().unwrap();
    if machine
        .parent()
        .is_some_and(|folder| folder.ends_with("plants"))
    {
        let begin = format!("{}-", stem(machine));
        let of_gallery = files("plants/wrong", &["st"]);
        all.extend(
            of_gallery
                .into_iter()
                .filter(|file| stem(file).starts_with(&begin)),
        );
    }
    all
}

/// Between these the tally stands, which this test writes with UPDATE=1.
const MARKS: [&str; 2] = ["<!-- tally -->\n", "<!-- end of tally -->\n"];

/// How many wrong programs there are, how many of them the cases catch, how many the machine, and each alone.
#[derive(Default)]
struct Tally {
    of: usize,
    both: usize,
    cases_alone: usize,
    machine_alone: usize,
    /// Pass the cases that are not hidden, and fail on the machine.
    not_shown: usize,
}

#[test]
fn no_mutant_passes_and_the_pages_tell_what_the_machines_catch() {
    let mut typical = Tally::default();
    let (mut mutants, mut by_machine) = (0, 0);
    for (name, exercise) in exercises() {
        let plant = plant(&exercise);
        let model = program(exercise.program.as_deref().unwrap(), exercise.board);
        let found = passing(&exercise, plant.as_ref(), &model.bytes, exercise.board);
        assert!(
            found.pass.is_empty() && found.of > 0,
            "{name}: {:#?}",
            found.pass
        );
        let Some(plant) = plant else {
            continue;
        };
        mutants += found.of;
        by_machine += found.machine_alone;
        for file in mistakes(&name, &exercise) {
            let program = program(&file, exercise.board);
            let grade = grade(&exercise, &program, &mut HostEngine::new(exercise.board));
            let cases = !grade.is_passed();
            let all = exercise.cases().iter().zip(&grade.passed);
            let is_shown = all
                .filter(|(case, _)| !case.hidden)
                .any(|(_, passed)| !passed);
            let machine = first(&plant, &program.bytes).is_some();
            assert!(cases || machine, "{file:?} passes");
            typical.of += 1;
            typical.both += usize::from(cases && machine);
            typical.cases_alone += usize::from(cases && !machine);
            typical.machine_alone += usize::from(machine && !cases);
            typical.not_shown += usize::from(machine && !is_shown);
        }
    }
    let told = [
        ("exercises.md", english(&typical, mutants, by_machine)),
        (
            "exercises.pt-BR.md",
            portuguese(&typical, mutants, by_machine),
        ),
    ];
    for (name, tally) in told {
        let file = Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("../../docs")
            .join(name);
        let page = fs::read_to_string(&file).unwrap();
        let (before, rest) = page.split_once(MARKS[0]).unwrap();
        let (_, after) = rest.split_once(MARKS[1]).unwrap();
        let now = format!("{before}{}\n{tally}\n{}{after}", MARKS[0], MARKS[1]);
        if std::env::var_os("UPDATE").is_some() {
            fs::write(&file, &now).unwrap();
        }
        let page = fs::read_to_string(&file).unwrap();
        assert_eq!(
            page, now,
            "{name}: UPDATE=1 cargo test -p unoclp-exercise writes it"
        );
    }
}

fn english(typical: &Tally, mutants: usize, by_machine: usize) -> String {
    let Tally {
        of,
        both,
        cases_alone,
        machine_alone,
        not_shown,
    } = typical;
    format!(
        "| typical mistakes for exercises with a machine | programs |\n| --- | --- |\n\
         | in total | {of} |\n| caught by the cases and by the machine | {both} |\n\
         | caught only by the cases | {cases_alone} |\n\
         | pass the cases that the page shows, but fail on the machine | {not_shown} |\n\
         | pass all cases, hidden ones included, but fail on the machine | {machine_alone} |\n\n\
         `unoclp mutants` makes {mutants} wrong programs from the model solutions. Of these, {by_machine} pass all cases but \
         fail on the machine, and\n\
         none passes the cases and the machine.\n"
    )
}

fn portuguese(typical: &Tally, mutants: usize, by_machine: usize) -> String {
    let Tally {
        of,
        both,
        cases_alone,
        machine_alone,
        not_shown,
    } = typical;
    format!(
        "| erros típicos em exercícios com máquina | programas |\n| --- | --- |\n\
         | total | {of} |\n| pegos pelos casos e pela máquina | {both} |\n\
         | pegos só pelos casos | {cases_alone} |\n\
         | passam nos casos que a página mostra, mas falham na máquina | {not_shown} |\n\
         | passam em todos os casos, inclusive os ocultos, mas falham na máquina | {machine_alone} |\n\n\
         `unoclp mutants` gera {mutants} programas errados a partir das soluções-modelo. Destes, {by_machine} passam em todos os casos, \
         mas falham na\n\
         máquina, e nenhum passa nos casos e na máquina.\n"
    )
}

/// A fault that is to be found shows in a machine that is controlled as it should be, and is found by its name alone.
#[test]
fn each_hidden_fault_shows_and_can_be_named() {
    let mut count = 0;
    for (name, exercise) in of_folders(&["exercises/find"]) {
        let hidden = exercise.find.as_ref().unwrap_or_else(|| panic!("{name}"));
        count += 1;
        assert!(
            exercise.task.is_some() && exercise.hints.len() > 1,
            "{name}"
        );
        let plant = plant(&exercise).unwrap();
        let (part, fault) = hidden.of(&plant).unwrap_or_else(|| panic!("{name}"));
        let text = fs::read_to_string(exercise.plant.as_ref().unwrap()).unwrap();
        let broken = format!(
            "{text}\n[[fault]]\npart = \"{}\"\nis = \"{}\"\nat = \"0 s\"\n",
            hidden.part, hidden.is
        );
        let broken = read(&broken, exercise.board).unwrap();
        let code = program(exercise.program.as_deref().unwrap(), exercise.board).bytes;
        assert!(first(&broken, &code).is_some(), "{name}: nobody sees it");

        let mut search = Search::new(&plant, hidden).unwrap();
        let mut run = Run::new(&plant, plant.seed).by_hand();
        search.begin(&mut run);
        assert!(run.fails(part, fault));
        let button = plant.parts.iter().position(|own| own.kind.name == "button");
        let button = button.unwrap();
        let pressed = plant.parts[button].kind.value("pressed").unwrap();
        // Pressed and let go, twice, and a point is forced.
        for to in [1, 0, 1, 0] {
            search.touched(&plant, button, pressed, to);
        }
        search.forced();
        let other = (0..plant.parts.len()).find(|one| *one != part).unwrap();
        assert!(!search.name(other, fault) && !search.is_found());
        assert!(search.name(part, fault) && search.is_found());
        assert_eq!((search.steps(), search.tries()), (3, 2));
        // What is found is mended with the next beginning.
        search.begin(&mut run);
        assert!(!run.fails(part, fault));
        let answer = format!("{} {}", hidden.part, hidden.is);
        assert!(Answer::of(&answer, hidden).is_found);
    }
    assert!(count >= 3, "{count}");
}

/// What is given is judged as the model solution is, scan by scan; it may not be handed in as it stands.
#[test]
fn a_program_that_is_given_does_what_its_exercise_expects() {
    let mut count = 0;
    for (name, exercise) in exercises() {
        let Some(given) = &exercise.given else {
            continue;
        };
        count += 1;
        let source = unoclp_program::Written::new(
            name.clone(),
            given.text.clone().into_bytes(),
            exercise.board,
        );
        let source = source.check(None).unwrap();
        assert_ne!(source.language.written_in(), given.answer_in, "{name}");
        let model = program(exercise.program.as_deref().unwrap(), exercise.board);
        let same = ProgramFile {
            name: name.clone(),
            bytes: source.code,
        };
        for one in [&model, &same] {
            assert!(
                passes(&exercise, one, &mut HostEngine::new(exercise.board)),
                "{name}"
            );
        }
    }
    assert!(count >= 2, "{count}");
}
