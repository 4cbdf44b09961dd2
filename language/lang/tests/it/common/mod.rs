//! What the tests share: random numbers, and a board that runs what has been compiled.

use unoclp_core::{Board, Image, Inputs, Loader, Plc};
use unoclp_lang::{CompiledText, Options, TextLanguage, compile};
pub use unoclp_testing::Random;

/// A board with more memory than any, so that size decides nothing.
pub const LARGE: Board = Board {
    stored_bytes: 60_000,
    linked_bytes: 60_000,
    ..Board::UNO
};

pub fn large() -> Options {
    Options {
        dialect: None,
        board: LARGE,
    }
}

/// Compiles a text that must be a program.
pub fn program(text: &str, options: &Options) -> CompiledText {
    let compiled = compile(text, TextLanguage::Il, options);
    assert!(
        !compiled.has_errors(),
        "{text}\n{:#?}",
        compiled.diagnostics
    );
    compiled
}

/// The program in this memory.
pub fn plc<'m>(file: &str, memory: &'m mut [u8], board: Board) -> Plc<'m> {
    let mut loader = Loader::new(memory, board);
    for byte in file.bytes() {
        loader
            .push(byte)
            .unwrap_or_else(|fault| panic!("{fault}\n{file}"));
    }
    Plc::new(
        loader
            .finish()
            .unwrap_or_else(|fault| panic!("{fault}\n{file}")),
    )
}

/// Inputs as bits, and analogue readings.
pub fn inputs(points: u8, analogue: [u16; 5]) -> Inputs {
    Inputs::from(Image(points.into())).reading(&analogue)
}
