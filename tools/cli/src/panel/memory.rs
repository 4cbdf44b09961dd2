//! The panel of what a program counts and remembers: analogue inputs, PWM, counters, registers, markers, variables.

use crate::panel::ON;
use crate::variables::lines;
use ratatui::layout::Rect;
use ratatui::style::{Modifier, Style};
use ratatui::text::{Line, Span};
use unoclp_program::used::{Quantity, real};

/// The analogue input that keys turn.
const SELECTED: Style = Style::new().add_modifier(Modifier::REVERSED);

/// The lines that are shown at a time; none on a screen too low for them.
pub(super) struct MemoryPage {
    lines: Vec<Line<'static>>,
    /// How many pages there are.
    pub(super) pages: usize,
}

impl MemoryPage {
    /// The page of this number, of what is shown on a screen of this size.
    pub(super) fn new(all: Vec<Vec<Span<'static>>>, page: usize, screen: Rect) -> MemoryPage {
        let lines = lines(all, screen.width.into());
        // What the other panels leave is shared with the timers and the rungs.
        let rows = lines
            .len()
            .min(usize::from(screen.height.saturating_sub(8) / 4));
        let pages = lines.len().div_ceil(rows.max(1)).max(1);
        let first = page % pages * rows;
        let lines = lines.into_iter().skip(first).take(rows).collect();
        MemoryPage { lines, pages }
    }

    /// Lines of the screen, with the title.
    pub(super) fn height(&self) -> u16 {
        match self.lines.len() {
            0 => 0,
            lines => lines as u16 + 1,
        }
    }

    pub(super) fn lines(self) -> Vec<Line<'static>> {
        self.lines
    }
}

/// With the name that the program gives it, else its own: ` D1 -45  `, ` C2 3/5  `, ` M7 ●  `
pub(super) fn spans(name: &str, quantity: &Quantity, selected: bool) -> Vec<Span<'static>> {
    let value = &quantity.value;
    let name = Span::styled(
        name.to_owned(),
        if selected { SELECTED } else { Style::new() },
    );
    let value = match (quantity.bits, quantity.of) {
        (1, _) if *value != 0 => Span::styled("●", ON),
        (1, _) => Span::raw("○"),
        (_, Some(of)) => Span::raw(format!("{value}/{of}")),
        _ if quantity.is_real => Span::raw(real(*value)),
        (..) => Span::raw(value.to_string()),
    };
    vec![Span::raw(" "), name, Span::raw(" "), value, Span::raw("  ")]
}
