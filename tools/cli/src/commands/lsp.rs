//! `unoclp lsp`.

use crate::messages;
use crate::outcome::Outcome;
use anyhow::anyhow;
use unoclp_core::Board;
use unoclp_lang::Lang;
use unoclp_lsp::stdio;

/// Helps the editor at standard input and output until it says goodbye. `asked`: in which language; none: in the editor's.
pub fn lsp(board: Board, asked: Option<Lang>) -> Outcome {
    stdio(board, asked).map_err(|why| anyhow!(messages::no_editor(why)))?;
    Ok(true)
}
