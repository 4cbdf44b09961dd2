//! Inputs and outputs as lamps beside what the program calls them: ` I1 ● start   I2 ○ stop  `.
//!
//! Owns how they fit: names are cut before lamps take more lines than a screen can spare. Must not know what is lit.

use ratatui::layout::{Constraint, Layout, Rect};
use ratatui::text::{Line, Span};

/// A point: its number and its lamp, and its name if it has one.
pub(crate) struct Lamp {
    /// What is always shown, with the blanks after it.
    pub(crate) shown: Vec<Span<'static>>,
    /// What the program calls it.
    pub(crate) name: Option<String>,
}

/// The inputs or the outputs of a board, in order.
pub(crate) struct Lamps(pub(crate) Vec<Lamp>);

/// Fewer letters than these tell nothing of a name.
const FEWEST: usize = 3;

/// The fewest columns of inputs or of outputs that stand side by side: those of their title.
const SIDE: usize = 26;

/// The columns from which on inputs and outputs with names stand side by side.
const NAMED: u16 = 60;

/// Inputs and outputs as they are on a screen.
pub(crate) struct Sides {
    /// The columns of the inputs, if the outputs are beside them and not below.
    pub(crate) share: Option<u16>,
    pub(crate) inputs: Vec<Line<'static>>,
    pub(crate) outputs: Vec<Line<'static>>,
}

impl Sides {
    /// Side by side on screens of so many columns, in halves; with names each in the measure of what there is to show.
    pub(crate) fn new(inputs: &Lamps, outputs: &Lamps, columns: u16, screen: Rect) -> Sides {
        let named = inputs.have_names() || outputs.have_names();
        let share = match named {
            true => (screen.width >= NAMED).then(|| share(inputs, outputs, screen.width)),
            false => (screen.width >= columns).then(|| screen.width.div_ceil(2)),
        };
        let own = share.unwrap_or(screen.width);
        let other = share.map_or(own, |share| screen.width.saturating_sub(share));
        let most = most_lines(screen.height);
        Sides {
            share,
            inputs: inputs.lines(own.into(), most),
            outputs: outputs.lines(other.into(), most),
        }
    }

    /// Lines of both, with a title above each.
    fn heights(&self) -> [u16; 2] {
        [&self.inputs, &self.outputs].map(|lines| lines.len() as u16 + 1)
    }

    /// Lines of the screen, with the titles.
    pub(crate) fn height(&self) -> u16 {
        let [own, other] = self.heights();
        match self.share {
            Some(_) => own.max(other),
            None => own + other,
        }
    }

    /// Where both are within this area, with their titles.
    pub(crate) fn areas(&self, area: Rect) -> [Rect; 2] {
        match self.share {
            Some(share) => {
                Layout::horizontal([Constraint::Length(share), Constraint::Fill(1)]).areas(area)
            }
            None => Layout::vertical(self.heights().map(Constraint::Length)).areas(area),
        }
    }
}

/// The lines that lamps with names may take on a screen of this height.
const fn most_lines(height: u16) -> usize {
    match height {
        ..24 => 1,
        24..40 => 2,
        40.. => 3,
    }
}

/// The columns of the inputs, of so many for both.
fn share(inputs: &Lamps, outputs: &Lamps, columns: u16) -> u16 {
    let columns = usize::from(columns);
    let (own, other) = (inputs.width(), outputs.width());
    let share = columns * own / (own + other).max(1);
    share.clamp(SIDE, columns.saturating_sub(SIDE).max(SIDE)) as u16
}

impl Lamps {
    /// Whether any has a name.
    fn have_names(&self) -> bool {
        self.0.iter().any(|lamp| lamp.name.is_some())
    }

    /// Columns of all, with their names in full.
    fn width(&self) -> usize {
        self.0.iter().map(|lamp| lamp.spans(usize::MAX).1).sum()
    }

    /// The lamps in lines of so many columns. Names are cut until there are at most so many lines; lamps never are.
    fn lines(&self, columns: usize, most: usize) -> Vec<Line<'static>> {
        let longest = self.0.iter().filter_map(|lamp| lamp.name.as_ref());
        let longest = longest.map(|name| name.chars().count()).max();
        let longest = longest.unwrap_or_default();
        let mut tries = (FEWEST.min(longest)..=longest).rev();
        let fits = |letters: usize| {
            let lines = self.wrapped(letters, columns);
            (lines.len() <= most).then_some(lines)
        };
        tries
            .find_map(fits)
            .unwrap_or_else(|| self.wrapped(0, columns))
    }

    /// With so many letters of each name.
    fn wrapped(&self, letters: usize, columns: usize) -> Vec<Line<'static>> {
        let mut lines: Vec<(Line, usize)> = vec![(Line::default(), 0)];
        for lamp in &self.0 {
            let (spans, width) = lamp.spans(letters);
            match lines.last_mut() {
                // The blanks at its end may be cut off.
                Some((line, used)) if *used + width <= columns + 2 || *used == 0 => {
                    line.spans.extend(spans);
                    *used += width;
                }
                _ => lines.push((spans.into(), width)),
            }
        }
        lines.into_iter().map(|(line, _)| line).collect()
    }
}

impl Lamp {
    /// The lamp with so many letters of its name and the blanks after it, and the columns of all that.
    fn spans(&self, letters: usize) -> (Vec<Span<'static>>, usize) {
        let mut spans = self.shown.clone();
        if let Some(name) = self.name.as_ref().filter(|_| letters > 0) {
            spans.push(Span::raw(format!("{}  ", cut(name, letters))));
        }
        let width = spans.iter().map(Span::width).sum();
        (spans, width)
    }
}

/// So many letters of a name; `…` is one of them, if there are more.
fn cut(name: &str, letters: usize) -> String {
    if name.chars().count() <= letters {
        return name.to_owned();
    }
    let kept = name.chars().take(letters.saturating_sub(1));
    kept.chain(['…']).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lamps(names: &[&str]) -> Lamps {
        let named = |(index, name): (usize, &&str)| Lamp {
            shown: vec![Span::raw(format!(" I{} ○ ", index + 1))],
            name: Some((*name).to_owned()).filter(|name| !name.is_empty()),
        };
        Lamps(names.iter().enumerate().map(named).collect())
    }

    fn shown(lamps: &Lamps, columns: usize, most: usize) -> Vec<String> {
        let lines = lamps.lines(columns, most).into_iter();
        lines
            .map(|line| line.to_string().trim_end().to_owned())
            .collect()
    }

    #[test]
    fn names_stand_beside_their_lamps_as_far_as_there_is_room() {
        let lamps = lamps(&["start_button", "", "stop"]);
        assert_eq!(
            shown(&lamps, 80, 1),
            [" I1 ○ start_button   I2 ○  I3 ○ stop"]
        );
        assert_eq!(
            shown(&lamps, 30, 2),
            [" I1 ○ start_button   I2 ○", " I3 ○ stop"]
        );
        assert_eq!(shown(&lamps, 31, 1), [" I1 ○ start_…   I2 ○  I3 ○ stop"]);
        assert_eq!(shown(&lamps, 24, 1), [" I1 ○  I2 ○  I3 ○"]);
    }

    #[test]
    fn short_names_are_names() {
        let lamps = lamps(&["go", ""]);
        assert_eq!(shown(&lamps, 80, 1), [" I1 ○ go   I2 ○"]);
    }

    #[test]
    fn no_lamp_is_cut_off() {
        let lamps = lamps(&["start", "stop", "level", "door"]);
        let lines = shown(&lamps, 14, 1);
        assert_eq!(lines, [" I1 ○  I2 ○", " I3 ○  I4 ○"]);
    }

    #[test]
    fn who_has_longer_names_has_more_room() {
        let (long, short) = (lamps(&["start_button", "stop_button"]), lamps(&["lamp"]));
        assert!(share(&long, &short, 80) > 40);
        assert!(share(&short, &long, 80) < 40);
        assert_eq!(share(&short, &long, 60), 26);
    }
}
