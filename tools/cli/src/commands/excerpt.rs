//! Excerpts of a program, in which what is wrong is underlined.

use annotate_snippets::Renderer;
use ratatui::crossterm::terminal;
use std::io::{IsTerminal, stdout};

/// How excerpts of a program are shown.
pub fn renderer() -> Renderer {
    let mut renderer = Renderer::styled();
    if stdout().is_terminal()
        && let Ok((width, _)) = terminal::size()
    {
        renderer = renderer.term_width(width.into());
    }
    renderer
}
