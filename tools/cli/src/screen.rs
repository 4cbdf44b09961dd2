//! What holds for every screen: how small it may be, and which characters it may use.

use crate::ascii::nearest;
use crate::messages;
use ratatui::Frame;
use ratatui::buffer::Buffer;
use ratatui::text::Line;
use ratatui::widgets::Paragraph;

/// The columns and lines that a screen needs.
pub const LEAST: (u16, u16) = (41, 11);

/// Says so on a screen that is too small, and how to leave; tells whether it is.
pub fn is_too_small(frame: &mut Frame) -> bool {
    let area = frame.area();
    let (width, height) = LEAST;
    if area.width >= width && area.height >= height {
        return false;
    }
    let lines = [
        messages::too_small(area.width, area.height),
        messages::needs(width, height),
        messages::q_quits(),
    ];
    let lines: Vec<Line> = lines.into_iter().map(Line::raw).collect();
    frame.render_widget(Paragraph::new(lines), area);
    true
}

/// Leaves only ASCII on the screen, for a terminal that may know nothing else.
pub fn to_ascii(buffer: &mut Buffer) {
    for cell in &mut buffer.content {
        let other = cell.symbol().chars().next().filter(|c| !c.is_ascii());
        if let Some(character) = other {
            cell.set_char(nearest(character));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use ratatui::layout::Rect;
    use ratatui::style::Style;

    #[test]
    fn nothing_but_ascii_is_left() {
        let text = "┣━━┥ I1 ┝──( Q1 )─┤ ●○ 214 µs ████░░ ↑↓ memória €";
        let mut buffer = Buffer::empty(Rect::new(0, 0, 60, 1));
        buffer.set_string(0, 0, text, Style::new());
        to_ascii(&mut buffer);
        let shown: String = buffer.content.iter().map(|cell| cell.symbol()).collect();
        assert_eq!(
            shown.trim_end(),
            "|==| I1 |--( Q1 )-| *o 214 us ####.. ^v memoria ?"
        );
    }
}
