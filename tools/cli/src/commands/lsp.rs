//! `unoclp lsp`.

use crate::messages;
use crate::outcome::Outcome;
use anyhow::anyhow;
use unoclp_core::Board;
use unoclp_lang::Lang;
use unoclp_lsp::{Connection, serve};

/// Helps the editor at standard input and output until it says goodbye. `asked`: in which language; none: in the editor's.
pub fn lsp(board: Board, asked: Option<Lang>) -> Outcome {
    let (connection, threads) = Connection::stdio();
    let served = serve(&connection, board, asked);
    // What still waits to be written is written when the last sender is gone.
    drop(connection);
    served.map_err(|why| anyhow!(messages::no_editor(why)))?;
    threads.join()?;
    Ok(true)
}
