//! The table in TypeScript, which the page is compiled with, and the languages that programs are written in.

use super::{First, MORE, More, Row};
use crate::answer::{answers, compare};
use std::fmt::Write;
use unoclp_program::{Lang, WrittenIn};

const HEAD: &str = "// What may be asked of Rust, and what it answers. Made of page/bridge/src/ask/table.rs: do not edit it; the test of\n\
                    // page/bridge/src/ask/contract.rs writes it where UPDATE=1 is set.\n\n";

/// Types of what is asked, which stand in `said.ts`.
const SAID: [&str; 5] = ["Act", "As", "Order", "Speak", "Text"];

/// What a row is in TypeScript.
fn row(to: &mut String, row: &Row) {
    let Row {
        about,
        ask,
        fields,
        answer,
    } = row;
    let fields = fields.iter().map(|(key, of)| match of.strip_suffix('?') {
        Some(of) => format!("readonly {key}?: {of} | undefined"),
        None => format!("readonly {key}: {of}"),
    });
    let fields: Vec<String> = fields.collect();
    let asked = match fields.is_empty() {
        true => "object".to_owned(),
        false => format!("{{ {} }}", fields.join("; ")),
    };
    let _ = writeln!(
        to,
        "  /** {about} */\n  {ask}: {{ ask: {asked}; answer: {answer} }};"
    );
}

fn written() -> String {
    let mut asks = "export interface Asks {\n".to_owned();
    for one in First::rows().iter().chain(&More::rows()) {
        row(&mut asks, one);
    }
    asks.push_str("}\n");
    let has = |name: &&str| {
        let mut words = asks.split(|ch: char| !ch.is_alphanumeric());
        words.any(|word| word == *name)
    };
    let answers = answers();
    let mut names: Vec<&str> = answers.names().chain(SAID).filter(has).collect();
    names.sort_unstable();
    let names = names.join(", ");
    format!("{HEAD}import type {{ {names} }} from \"./answers\";\n\n{asks}")
}

/// The languages in TypeScript.
fn languages() -> String {
    let mut text = "// The languages of programs, as the Rust of unoclp has them. Made like `asks.ts`: do not edit it.\n\n\
                    /** Each language by its name: the end of the names of its files, and what it is called. */\n\
                    export const LANGUAGES = {\n"
        .to_owned();
    for language in WrittenIn::all() {
        let [en, pt] = [Lang::En, Lang::Pt].map(|lang| capital(&language.title(lang)));
        let (name, end) = (language.name(), language.end());
        let _ = writeln!(
            text,
            "  {name}: {{ end: \".{end}\", en: \"{en}\", pt: \"{pt}\" }},"
        );
    }
    text.push_str("} as const;\n\nexport type LanguageName = keyof typeof LANGUAGES;\n");
    text
}

fn capital(title: &str) -> String {
    let mut signs = title.chars();
    let first = signs.next().into_iter().flat_map(char::to_uppercase);
    first.chain(signs).collect()
}

#[test]
fn the_page_is_compiled_with_the_asks_and_languages_of_rust() {
    compare("asks.ts", written());
    compare("languages.ts", languages());
}

#[test]
fn the_first_module_knows_what_takes_more() {
    let asks: Vec<&str> = More::rows().iter().map(|row| row.ask).collect();
    assert_eq!(asks, MORE);
}
