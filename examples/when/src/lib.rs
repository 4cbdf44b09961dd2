//! WHEN, a language of two sentences, made outside of unoclp:
//!
//! ```text
//! start is input 1        // the button
//! stop  is input 2
//! motor is output 1
//! fan   is output 2
//! motor when (start or motor) and not stop
//! fan   when motor for 5 s
//! ```
//!
//! Its grammar:
//!
//! ```text
//! program = { [ meaning | rule ] , end of line } ;
//! meaning = name , "is" , ( "input" | "output" | "memory" ) , number ;
//! rule    = name , "when" , either , [ "for" , number , ( "s" | "ms" ) ] ;
//! either  = both , { "or" , both } ;
//! both    = one , { "and" , one } ;
//! one     = { "not" } , ( name | "(" , either , ")" ) ;
//! name    = letter , { letter | digit | "_" } ;
//! number  = digit , { digit } ;
//! comment = "//" , { any character but the end of the line } ;
//! ```
//!
//! Owns what WHEN is: [`WHEN`] is the row that all others take. Must not know codes, boards' memories, screens: the typed
//! tree is all that it makes.

#![forbid(unsafe_code)]

mod messages;
mod reader;
mod words;

use unoclp_core::Board;
use unoclp_text::colour::Colour;
use unoclp_text::diagnostics::Found;
use unoclp_text::outline::{Named, Outline, What};
use unoclp_tree::{FrontEnd, Painted, Tree};
use words::{Kind, words};

/// The language.
pub static WHEN: FrontEnd = FrontEnd {
    name: "when",
    title: ["WHEN", "WHEN"],
    begins,
    colours,
    outline,
    vocabulary: || KEYWORDS.to_vec(),
    read: |text, options, found| tree(text, options.board, found).into(),
};

/// The words that have a meaning of their own.
const KEYWORDS: [&str; 11] = [
    "is", "when", "for", "s", "ms", "and", "or", "not", "input", "output", "memory",
];

/// A name, and `is` or `when` after it.
fn begins(text: &str) -> bool {
    let words = words(text);
    let mut said = words.iter().skip_while(|word| word.kind == Kind::LineEnd);
    let first = said.next().map(|word| word.kind);
    let second = said.next().map(|word| word.of(text));
    first == Some(Kind::Name) && matches!(second, Some("is" | "when"))
}

fn colours(text: &str) -> Painted {
    let colour = |word: &words::Word| match word.kind {
        Kind::Number => Some(Colour::Number),
        Kind::Name if KEYWORDS.contains(&word.of(text)) => Some(Colour::Word),
        _ => None,
    };
    words(text)
        .iter()
        .map(|word| (word.span, colour(word)))
        .collect()
}

/// Each name before an `is`.
fn outline(text: &str) -> Outline {
    let words = words(text);
    let names = words.windows(2).filter(|pair| {
        let [name, is] = pair else { return false };
        name.kind == Kind::Name && is.of(text) == "is"
    });
    let name = |pair: &[words::Word]| Named::new(What::Variable, pair[0].span, None);
    Outline {
        named: names.map(name).collect(),
        letters_apart: true,
    }
}

fn tree(text: &str, board: Board, found: &mut Found) -> Option<Tree> {
    reader::read(text, words(text), board, found)
}
