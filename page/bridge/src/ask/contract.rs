//! The table in TypeScript, which the page is compiled with, and the languages that programs are written in.

use super::{First, MORE, More, Row};
use std::fmt::Write;
use std::path::Path;
use std::{env, fs};
use unoclp_program::{Lang, WrittenIn};

/// Where the page has it.
const FILE: &str = "../web/src/tools/asks.ts";

/// Where it has the languages.
const LANGUAGES: &str = "../web/src/tools/languages.ts";

const HEAD: &str = "// What may be asked of Rust, and what it answers. Made of page/bridge/src/ask/table.rs: do not edit it; the test of\n\
                    // page/bridge/src/ask/contract.rs writes it where UPDATE=1 is set.\n\n";

/// Names that `answers.ts` has.
const NAMES: [&str; 22] = [
    "Act",
    "As",
    "BoardFacts",
    "CardImage",
    "Checked",
    "Drawn",
    "Fared",
    "FlashStep",
    "MachineFacts",
    "MachineLook",
    "Order",
    "Outcome",
    "Replayed",
    "Searched",
    "Sheet",
    "Shelf",
    "Speak",
    "Step",
    "Text",
    "Both",
    "News",
    "Settings",
];

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
    let mut names: Vec<&str> = NAMES.into_iter().filter(has).collect();
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
fn the_page_is_compiled_with_what_rust_has() {
    for (file, written) in [(FILE, written()), (LANGUAGES, languages())] {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(file);
        if env::var_os("UPDATE").is_some() {
            fs::write(file, written).unwrap();
            continue;
        }
        assert_eq!(
            fs::read_to_string(file).unwrap(),
            written,
            "UPDATE=1 writes it"
        );
    }
}

#[test]
fn the_first_module_knows_what_takes_more() {
    let asks: Vec<&str> = More::rows().iter().map(|row| row.ask).collect();
    assert_eq!(asks, MORE);
}
