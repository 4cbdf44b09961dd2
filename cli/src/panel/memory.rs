//! The panel of what a program counts and remembers: analogue inputs, PWM, counters, registers, markers.

use crate::panel::ON;
use ratatui::layout::Rect;
use ratatui::style::{Modifier, Style};
use ratatui::text::{Line, Span};
use std::collections::BTreeMap;
use unoclp_source::used::{Quantity, real};

/// The analogue input that keys turn.
const SELECTED: Style = Style::new().add_modifier(Modifier::REVERSED);

/// The lines that are shown at a time; none on a screen too low for them.
pub(super) struct MemoryPage {
    lines: Vec<Line<'static>>,
    /// How many pages there are.
    pub(super) pages: usize,
}

impl MemoryPage {
    pub(super) fn new(
        quantities: &[Quantity],
        selected: Option<u8>,
        names: &BTreeMap<String, String>,
        page: usize,
        screen: Rect,
    ) -> MemoryPage {
        let width = usize::from(screen.width);
        let selected = selected.map(|input| format!("A{input}"));
        let mut lines: Vec<Line<'static>> = Vec::new();
        for quantity in quantities {
            let is_selected = selected.as_ref() == Some(&quantity.name);
            let name = names.get(&quantity.name).unwrap_or(&quantity.name);
            let spans = spans(name, quantity, is_selected);
            let wide: usize = spans.iter().map(Span::width).sum();
            let room = |line: &Line| line.width() + wide <= width;
            if !lines.last().is_some_and(room) {
                lines.push(Line::default());
            }
            if let Some(line) = lines.last_mut() {
                line.spans.extend(spans);
            }
        }
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
fn spans(name: &str, quantity: &Quantity, selected: bool) -> Vec<Span<'static>> {
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
