//! The words that the instruction table has for instructions: they are compiled, and the pages name them.

use crate::common::program;
use std::fs;
use std::path::Path;
use unoclp_core::isa::{Class, Kind, Opcode};
use unoclp_lang::Options;

macro_rules! rows {
    ($($name:ident $kind:ident $class:ident $code:literal $letters:literal $stored:literal $own:literal
        $effect:literal $il:literal $picture:literal;)*) => {
        /// Every instruction, and how Instruction List says it.
        const ROWS: &[(Opcode, &str)] = &[$((Opcode::$name, $il),)*];
    };
}
unoclp_core::instructions!(rows);

/// The instructions that have a word of their own, and that word.
fn own_words() -> impl Iterator<Item = (Opcode, &'static str)> {
    let own = [
        Class::Comparison,
        Class::Timer,
        Class::Count,
        Class::Logic,
        Class::Operation,
        Class::If,
        Class::Part,
    ];
    let words = ROWS
        .iter()
        .map(|&(opcode, il)| (opcode, il.split(' ').next().unwrap()));
    words.filter(move |(opcode, word)| own.contains(&opcode.class()) && !word.is_empty())
}

#[test]
fn the_pages_name_every_word() {
    for page in ["docs/instruction-list.md", "docs/instruction-list.pt-BR.md"] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("../..")
            .join(page);
        let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{page}: {error}"));
        for (opcode, word) in own_words() {
            let cell = format!("`{word}`");
            let row = |line: &&str| line.starts_with("| `") && line.contains(&cell);
            assert!(
                text.lines().any(|line| row(&line)),
                "{page}: {cell} ({opcode:?}) stands in no row of the operators"
            );
        }
    }
}

#[test]
fn every_word_compiles_to_its_code() {
    for (opcode, word) in own_words() {
        let row = opcode.row();
        let (text, xx) = match row.kind {
            Kind::None if opcode == Opcode::Push => {
                ("LD D1\nPUSH\nLD D2\nADD 3\nSUB POP\nST D3".to_owned(), 0)
            }
            Kind::None if matches!(row.class, Class::If | Class::Part) => (
                "LD I1\nIF\nLD I2\nST Q1\nELSE\nLD I3\nST Q1\nEND_IF".to_owned(),
                0,
            ),
            Kind::Table => (format!("LD D1\n{word} D2, 3\nST D3"), 2),
            Kind::Value if row.class == Class::Comparison => {
                (format!("LD D1\n{word} D2\nST Q1"), 2)
            }
            Kind::Value | Kind::Real => (format!("LD D1\n{word} D2\nST D3"), 2),
            Kind::Bit => (format!("LD D1\n{word} 3\nST D3"), 3),
            Kind::Timer => (format!("LD I1\n{word} T1, 100\nST Q1"), 0),
            Kind::Count => (format!("LD I1\n{word} C1, I2, 5\nST Q1"), 1),
            Kind::None if row.class == Class::Logic => (format!("LD I1\nAND I2\n{word}\nST Q1"), 0),
            kind => {
                assert_eq!(
                    kind,
                    Kind::None,
                    "{opcode:?}: {word} is of a kind without a test"
                );
                (format!("LD D1\n{word}\nST D3"), 0)
            }
        };
        let codes = program(&text, &Options::on(unoclp_core::Board::UNO)).codes();
        let code = row.code + xx;
        // The compiler may invert the contacts in place of what it has made of them.
        let inverted = opcode == Opcode::Not && codes.contains(&-827301);
        assert!(
            codes.contains(&code) || inverted,
            "{text}\n{code}: {codes:?}"
        );
    }
}
