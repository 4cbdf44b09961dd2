//! Bad projects: each is told at its place, with the reason and a remedy, in both languages. The command line is held to
//! the same file.

use serde::Deserialize;
use unoclp_core::Board;
use unoclp_lang::{Lang, Lines, Severity};
use unoclp_plcopen::{Charts, Whole, import, outline, shown};

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Cases {
    case: Vec<Case>,
}

/// A project, and the first error of it.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Case {
    about: String,
    /// Line and column.
    at: String,
    code: String,
    en: Said,
    pt: Said,
    text: String,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Said {
    message: String,
    help: String,
}

#[test]
fn each_is_told_at_its_place_with_reason_and_remedy() {
    let cases: Cases = toml::from_str(include_str!("../bad.toml")).unwrap();
    for Case { about, text, .. } in &cases.case {
        // Who asks for something else of it gets an answer too.
        let _ = outline(text);
        Whole::of(text);
        Charts::of(text);
        shown(text, "Main");
        assert!(!text.is_empty(), "{about}");
    }
    for case in cases.case {
        let made = import(&case.text, Board::UNO);
        assert!(made.program.is_none(), "{}", case.about);
        let mut told = made.diagnostics.iter();
        let told = told
            .find(|told| told.severity() == Severity::Error && told.code.to_string() == case.code);
        let told = told.unwrap_or_else(|| panic!("{}: {:?}", case.about, made.diagnostics));
        let (line, column) = Lines::new(&case.text).place(&case.text, told.span.start);
        assert_eq!(format!("{line}:{column}"), case.at, "{}", case.about);
        for (lang, said) in [(Lang::En, &case.en), (Lang::Pt, &case.pt)] {
            assert_eq!(told.message(lang), said.message, "{}", case.about);
            assert_eq!(told.help(lang), said.help, "{}", case.about);
            assert!(!said.help.is_empty(), "{}", case.about);
        }
    }
}

#[test]
fn a_hundred_megabytes_are_not_read() {
    let mut text = "<?xml version=\"1.0\"?>\n<project>".to_owned();
    text.reserve(100 << 20);
    text.extend(std::iter::repeat_n(" ", (100 << 20) - text.len()));
    let made = import(&text, Board::UNO);
    let told: Vec<String> = [Lang::En, Lang::Pt]
        .iter()
        .flat_map(|lang| made.diagnostics.iter().map(|told| told.message(*lang)))
        .collect();
    assert_eq!(
        told,
        [
            "the file is too large: 104857600 > 1048576 bytes",
            "o arquivo é grande demais: 104857600 > 1048576 bytes"
        ]
    );
    assert!(outline(&text).is_err() && Whole::of(&text).is_none());
    assert!(Charts::of(&text).documents.is_empty() && shown(&text, "Main").is_none());
}
