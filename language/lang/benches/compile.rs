//! How long it takes to check and compile a text: in proportion to its size, and 10,000 lines at once.

use divan::{Bencher, black_box};
use std::fmt::Write;
use unoclp_lang::{TextLanguage, check, compile_text};

mod text;

fn main() {
    divan::main();
}

/// A text of so many lines, as a person would write them; only the first of them fit the board.
fn text(lines: usize) -> String {
    let mut text = String::new();
    for rung in 0..lines / 10 {
        let (input, marker) = (rung % 8 + 1, rung % 56 + 1);
        write!(
            text,
            "LD   I{input}   (* rung {rung} *)\nANDN M{marker}\nOR(  Q1\nANDN I2\n)\nST   M{marker}\n\
             LD   IW4\nGE   500\nS    Q2\n\n"
        )
        .unwrap_or_default();
    }
    text
}

#[divan::bench(args = [100, 1_000, 10_000, 100_000])]
fn lines(bencher: Bencher, lines: usize) {
    let text = text(lines);
    bencher.bench(|| compile_text(black_box(&text), TextLanguage::Il, unoclp_core::Board::UNO));
}

#[divan::bench(args = [1_000, 10_000, 100_000])]
fn structured_lines(bencher: Bencher, lines: usize) {
    let text = text::structured(lines);
    bencher.bench(|| check(black_box(&text), TextLanguage::St, unoclp_core::Board::UNO));
}

/// The worst kind of text: each line is wrong.
#[divan::bench(args = [1_000, 10_000])]
fn wrong_lines(bencher: Bencher, lines: usize) {
    let text = "AND( Z9.9 x\n".repeat(lines);
    bencher.bench(|| compile_text(black_box(&text), TextLanguage::Il, unoclp_core::Board::UNO));
}

/// Parentheses in one another, far deeper than the board can have them.
#[divan::bench(args = [1_000, 10_000, 100_000])]
fn nested(bencher: Bencher, deep: usize) {
    let text = format!(
        "LD I1\n{}{}ST Q1\n",
        "AND( I2\n".repeat(deep),
        ")\n".repeat(deep)
    );
    bencher.bench(|| compile_text(black_box(&text), TextLanguage::Il, unoclp_core::Board::UNO));
}
