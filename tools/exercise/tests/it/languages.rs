//! Programs that stand in several languages: each does what the scenario says and what the numeric code does, and in
//! Structured Text takes little more than by hand.

use std::fs;
use std::path::Path;
use unoclp_core::Inputs;
use unoclp_exercise::scenario::{ProgramFile, Scenario, check};
use unoclp_host_sim::engine::{Engine, HostEngine};
use unoclp_host_sim::random::{Random, random_inputs, random_pause};
use unoclp_program::{Source, Written};
use unoclp_testing::in_languages;

const SCANS: u32 = 3_000;

/// The program of a text about which the compiler has nothing to say.
fn checked(path: &Path) -> Source {
    let name = path.display().to_string();
    let bytes = fs::read(path).unwrap_or_else(|error| panic!("{name}: {error}"));
    let source = Written::new(name, bytes, unoclp_core::Board::UNO).check(None);
    let source = source.unwrap_or_else(|refused| panic!("{refused:?}"));
    if let Some(told) = source.language.warnings() {
        assert_eq!(told.listed, [], "{}", source.name);
    }
    source
}

#[test]
fn every_language_passes_the_scenario() {
    for twins in in_languages() {
        for text in twins.texts() {
            let source = checked(&text);
            let program = ProgramFile {
                name: source.name.clone(),
                bytes: source.code.clone(),
            };
            let scenario = Scenario::load_for(&twins.scenario(), program, unoclp_core::Board::UNO);
            let scenario = scenario.expect("the scenario is right");
            let report = check(&scenario, &mut HostEngine::new(unoclp_core::Board::UNO));
            assert!(report.passed(), "{}: {report}", source.name);
        }
    }
}

/// Whatever the inputs are, and however long a scan takes.
#[test]
fn every_language_does_what_the_numeric_code_does() {
    for twins in in_languages() {
        let by_hand = checked(&twins.text("txt"));
        let needs = by_hand.program().needs();
        for text in twins.texts() {
            let compiled = checked(&text);
            let mut engines = [&by_hand, &compiled].map(|source| {
                let mut engine = HostEngine::new(unoclp_core::Board::UNO);
                let Ok(loaded) = engine.load(&source.code);
                loaded.expect("it has been checked");
                engine
            });
            let mut random = Random::new(1);
            let (mut now, mut inputs) = (0, Inputs::default());
            for _ in 0..SCANS {
                inputs = random_inputs(&mut random, needs, inputs);
                let [expected, came] = engines.each_mut().map(|engine| {
                    let Ok(outputs) = engine.scan(&inputs, now);
                    let pwm = [1, 4].map(|output| engine.pwm(output));
                    (outputs, pwm)
                });
                assert_eq!(came, expected, "{}, {now} ms", compiled.name);
                now = now.wrapping_add(random_pause(&mut random));
            }
        }
    }
}

/// The table of `docs/structured-text.md`, which this prints where it is another.
#[test]
fn structured_text_takes_little_more_than_numeric_code() {
    let rows = in_languages().into_iter().map(|twins| {
        let [by_hand, compiled] =
            ["txt", "st"].map(|end| checked(&twins.text(end)).size.stored_bytes);
        assert!(
            compiled * 4 <= by_hand * 5,
            "{}: {by_hand} by hand, {compiled}",
            twins.name
        );
        let hundredths = (compiled * 100 + by_hand / 2) / by_hand;
        let (times, parts) = (hundredths / 100, hundredths % 100);
        format!(
            "| `{}` | {by_hand} | {compiled} | {times}.{parts:02} |\n",
            twins.name
        )
    });
    let rows: String = rows.collect();
    for page in ["structured-text.md", "structured-text.pt-BR.md"] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("../../docs")
            .join(page);
        let text = fs::read_to_string(&path).expect("the page is there");
        let rows = match page.contains("pt-BR") {
            true => rows.replace('.', ","),
            false => rows.clone(),
        };
        assert!(
            text.contains(&format!("|\n{rows}\n")),
            "{page} needs\n{rows}"
        );
    }
}
