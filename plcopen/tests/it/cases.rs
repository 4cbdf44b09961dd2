//! What becomes of ladder bodies, and what is refused, case by case.

use crate::{codes, project};
use serde::Deserialize;
use unoclp_core::Profile;
use unoclp_lang::Lang;
use unoclp_plcopen::import;

#[derive(Deserialize)]
struct Cases {
    case: Vec<Case>,
}

#[derive(Deserialize)]
struct Case {
    about: String,
    #[serde(default)]
    variables: String,
    ladder: String,
    code: Option<Vec<i32>>,
    #[serde(default)]
    told: Vec<String>,
}

#[test]
fn each_case_becomes_its_code_or_is_told() {
    let cases: Cases = toml::from_str(include_str!("../cases.toml")).unwrap();
    for case in cases.case {
        let text = project(&case.variables, &format!("<LD>{}</LD>", case.ladder));
        let made = import(&text, Profile::UNO);
        let mut told: Vec<String> = made
            .diagnostics
            .iter()
            .map(|told| told.code.to_string())
            .collect();
        let sayings: Vec<String> = made
            .diagnostics
            .iter()
            .map(|told| told.message(Lang::En))
            .collect();
        told.sort();
        told.dedup();
        let mut expected = case.told.clone();
        expected.sort();
        assert_eq!(told, expected, "{}: {sayings:#?}", case.about);
        assert_eq!(made.code.as_deref().map(codes), case.code, "{}", case.about);
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
        // The document says the same as the code.
        if let (Some(document), Some(code)) = (&made.document, &case.code) {
            assert_eq!(document.codes().as_ref(), Ok(code), "{}", case.about);
        }
    }
}

#[test]
fn steps_know_their_element_name_and_comment() {
    let cases: Cases = toml::from_str(include_str!("../cases.toml")).unwrap();
    let case = &cases.case[1];
    let text = project(&case.variables, &format!("<LD>{}</LD>", case.ladder));
    let (_, map) = import(&text, Profile::UNO).program.unwrap();
    let first = &map.steps[0];
    let line = text.lines().nth(first.line - 1).unwrap();
    assert!(line.contains("<contact localId=\"5\""), "{line}");
    assert_eq!(first.name.as_deref(), Some("lamp"));
    assert_eq!(first.comments, ["Blinks"]);
}
