//! What becomes of ladder bodies, what they do, and what is refused, case by case.

use crate::{Pou, codes, project_of};
use serde::Deserialize;
use std::fs;
use std::path::Path;
use unoclp_core::{Board, Image};
use unoclp_lang::Lang;
use unoclp_plcopen::import;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Cases {
    case: Vec<Case>,
}

/// A project, and what comes of it.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Case {
    about: String,
    /// Of the program `Main`.
    #[serde(default)]
    variables: String,
    #[serde(default)]
    ladder: String,
    /// In place of a ladder, the elements of a block diagram.
    #[serde(default)]
    blocks: String,
    #[serde(default)]
    program: Vec<Program>,
    /// The programs that run, in their order.
    #[serde(default = "main_alone")]
    tasks: Vec<String>,
    /// Whether it becomes a text, and no document.
    #[serde(default)]
    is_text: bool,
    /// Its numeric code.
    code: Option<Vec<i32>>,
    /// The codes of what is told, each once.
    #[serde(default)]
    told: Vec<String>,
    /// The inputs of each scan; bit 0 is input 01.
    #[serde(default)]
    inputs: Vec<u128>,
    /// When each scan begins, ms; where they do not say, 1 ms apart.
    #[serde(default)]
    times: Vec<u32>,
    /// The outputs of each scan; bit 0 is output 01.
    #[serde(default)]
    outputs: Vec<u128>,
}

/// A program besides `Main`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Program {
    name: String,
    #[serde(default)]
    variables: String,
    ladder: String,
}

fn main_alone() -> Vec<String> {
    vec!["Main".to_owned()]
}

impl Case {
    /// Its project.
    pub(crate) fn text(&self) -> String {
        let ladder = |ladder: &str| format!("<LD>{ladder}</LD>");
        let others = self.program.iter();
        let others = others.map(|p| (&*p.name, &*p.variables, ladder(&p.ladder)));
        let body = match &*self.blocks {
            "" => ladder(&self.ladder),
            blocks => format!("<FBD>{blocks}</FBD>"),
        };
        let main = ("Main", &*self.variables, body);
        let programs: Vec<_> = [main].into_iter().chain(others).collect();
        let programs: Vec<Pou<'_>> = programs
            .iter()
            .map(|(name, variables, body)| Pou {
                name,
                variables,
                body,
            })
            .collect();
        let tasks: Vec<&str> = self.tasks.iter().map(|name| &**name).collect();
        project_of(&programs, &tasks)
    }
}

/// The cases of all files.
pub(crate) fn cases() -> Vec<Case> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cases");
    let entries = fs::read_dir(folder).unwrap();
    let mut paths: Vec<_> = entries.map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    let read = |path| toml::from_str::<Cases>(&fs::read_to_string(path).unwrap()).unwrap();
    paths.iter().flat_map(|path| read(path).case).collect()
}

#[test]
fn each_case_becomes_its_code_does_what_it_says_or_is_told() {
    let mut wrong = Vec::new();
    for case in cases() {
        let text = case.text();
        let made = import(&text, Board::UNO);
        let sayings: Vec<String> = made
            .diagnostics
            .iter()
            .map(|told| format!("{} {}", told.code, told.message(Lang::En)))
            .collect();
        let mut told: Vec<&str> = sayings.iter().filter_map(|s| s.split(' ').next()).collect();
        told.sort();
        told.dedup();
        let mut expected = case.told.clone();
        expected.sort();
        if told != expected {
            wrong.push(format!("{}: told {sayings:#?}", case.about));
        }
        for told in made.diagnostics.iter() {
            for lang in [Lang::En, Lang::Pt] {
                let message = told.message(lang);
                assert!(
                    !message.contains('{') && !message.contains("``"),
                    "{message}"
                );
            }
            assert!(text.get(told.span.range()).is_some(), "{told:?}");
        }
        let code = made.code.as_deref().map(codes);
        // The document says the same as the code; what only a text can say has none.
        let document = made.document.as_ref();
        let drawn = document.map(|drawn| drawn.codes().ok().unwrap_or_default());
        match case.is_text {
            true if drawn.is_some() => wrong.push(format!("{}: a document", case.about)),
            true => {}
            false => assert_eq!(drawn, code, "{}", case.about),
        }
        let is_run = !case.outputs.is_empty();
        let fits = match &case.code {
            Some(_) => code == case.code,
            None => code.is_some() == is_run,
        };
        if !fits {
            wrong.push(format!("{}: {code:?}", case.about));
        }
        if let Some((mut program, _)) = made.program {
            let mut plc = unoclp_core::Plc::new(program.lend());
            let scans = (0..).zip(&case.inputs);
            let outputs: Vec<u128> = scans
                .map(|(scan, &inputs)| {
                    let at = case.times.get(scan).copied().unwrap_or(scan as u32);
                    plc.scan(Image(inputs), at).unwrap().0
                })
                .collect();
            if outputs != case.outputs {
                wrong.push(format!("{}: {outputs:?} {code:?}", case.about));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn steps_know_their_element_name_and_comment() {
    let cases = cases();
    let case = cases.iter().find(|case| case.about.contains("that blink"));
    let text = case.unwrap().text();
    let (_, map) = import(&text, Board::UNO).program.unwrap();
    let first = &map.steps[0];
    let line = text.lines().nth(first.line - 1).unwrap();
    assert!(line.contains("<contact localId=\"5\""), "{line}");
    assert_eq!(first.name.as_deref(), Some("lamp"));
    assert_eq!(first.comments, ["Blinks"]);
}
