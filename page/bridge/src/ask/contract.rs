//! The table in TypeScript, which the page is compiled with, and the languages that programs are written in.

use super::{First, MORE, More, Row, Said, WORDS};
use crate::answer::{answers, compare};
use crate::board::orders;
use crate::edit::acts;
use crate::machine;
use std::fmt::Write;
use unoclp_client::Line;
use unoclp_client::map::setting;
use unoclp_client::settings::RATES;
use unoclp_program::{Lang, WrittenIn};

const HEAD: &str = "// What may be asked of Rust, and what it answers. Made of page/bridge/src/ask/table.rs: do not edit it; the test of\n\
                    // page/bridge/src/ask/contract.rs writes it where UPDATE=1 is set.\n\n";

/// Types of what is asked, which stand in `said.ts`: those that have texts in place of versions.
const SAID: [&str; 2] = ["Order", "Text"];

/// Languages of what is drawn.
const SPEAK: (&str, &[&str]) = ("Speak", &["en", "pt"]);

/// What a row is in TypeScript.
fn row(to: &mut String, row: &Row) {
    let Row {
        about,
        ask,
        fields,
        answer,
    } = row;
    let fields = keys(fields);
    let asked = match fields.is_empty() {
        true => "object".to_owned(),
        false => format!("{{ {} }}", fields.join("; ")),
    };
    let _ = writeln!(
        to,
        "  /** {about} */\n  {ask}: {{ ask: {asked}; answer: {answer} }};"
    );
}

/// The keys of a row, each with what stands there.
fn keys(fields: &[(&str, &str)]) -> Vec<String> {
    let fields = fields.iter().map(|(key, of)| match of.strip_suffix('?') {
        Some(of) => format!("readonly {key}?: {of} | undefined"),
        None => format!("readonly {key}: {of}"),
    });
    fields.collect()
}

/// What is one of several.
fn said(to: &mut String, said: &Said) {
    let Said { typed, about, rows } = said;
    let _ = writeln!(to, "/** {about} */\nexport type {typed} =");
    for (index, row) in rows.iter().enumerate() {
        if !row.about.is_empty() {
            let _ = writeln!(to, "  /** {} */", row.about);
        }
        let word = format!("readonly do: \"{}\"", row.ask);
        let fields = [vec![word], keys(&row.fields)].concat().join("; ");
        let end = if index + 1 == rows.len() { ";\n" } else { "" };
        let _ = writeln!(to, "  | {{ {fields} }}{end}");
    }
}

/// All of those, and the words that stand in them.
fn all_said() -> String {
    let mut text = String::new();
    for (name, words) in WORDS.iter().chain([&SPEAK]) {
        let words: Vec<String> = words.iter().map(|word| format!("\"{word}\"")).collect();
        let _ = writeln!(text, "export type {name} = {};\n", words.join(" | "));
    }
    said(&mut text, &acts::declared());
    said(&mut text, &orders::declared());
    text
}

fn written() -> String {
    let mut asks = all_said() + "export interface Asks {\n";
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

/// Numbers that the page would know otherwise by heart.
fn numbers() -> String {
    let usual = Line::default();
    let Line { address, rate, .. } = usual;
    let rates = RATES.map(|rate| rate.to_string()).join(", ");
    let (least, greatest) = (setting::ADDRESS.least, setting::ADDRESS.most);
    let (parity, most, numbers) = (usual.parity as u16, machine::MOST, machine::NUMBERS);
    format!(
        "// Numbers of Rust that are no answers. Made like `asks.ts`: do not edit it.\n\n\
         /** Points of a kind whose numbers a machine is told by: number 0 of outputs is none. */\n\
         export const NUMBERS = {numbers};\n\n\
         /** The most ms that a machine goes on at once. */\n\
         export const MOST_MS = {most};\n\n\
         /** How a board is spoken to whose settings nobody has changed; parity: 0 none, 1 even, 2 odd. */\n\
         export const USUAL = {{ address: {address}, rate: {rate}, parity: {parity} }};\n\n\
         /** The rates that a board meets well, bits per second. */\n\
         export const RATES = [{rates}];\n\n\
         /** Addresses that a board may have, the least and the greatest. */\n\
         export const ADDRESSES = [{least}, {greatest}] as const;\n"
    )
}

fn capital(title: &str) -> String {
    let mut signs = title.chars();
    let first = signs.next().into_iter().flat_map(char::to_uppercase);
    first.chain(signs).collect()
}

#[test]
fn the_page_is_compiled_with_the_asks_the_languages_and_the_numbers_of_rust() {
    compare("asks.ts", written());
    compare("languages.ts", languages());
    compare("numbers.ts", numbers());
}

#[test]
fn the_first_module_knows_what_takes_more() {
    let asks: Vec<&str> = More::rows().iter().map(|row| row.ask).collect();
    assert_eq!(asks, MORE);
}
