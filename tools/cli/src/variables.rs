//! The variables of a running program, by the names and in the types that its text gives them.
//!
//! Owns which of them are shown beside the lamps, and how. Must not know whether a board or a simulator holds them.

use ratatui::style::{Color, Modifier, Style};
use ratatui::text::{Line, Span};
use unoclp_lang::typed::{Base, Value};
use unoclp_lang::{Holding, Variable};
use unoclp_point::Address;

/// What is 1.
const ON: Style = Style::new().fg(Color::Green).add_modifier(Modifier::BOLD);

/// The variables of a program; none of one whose language declares no types.
#[derive(Clone, Debug, Default)]
pub struct Variables(Vec<Variable>);

impl Variables {
    /// These.
    pub fn new(variables: &[Variable]) -> Variables {
        let mut own: Vec<Variable> = Vec::new();
        for variable in variables {
            // A name that LCE's `var` gives to V0 is declared after it, and says more.
            let same = |of: &&mut Variable| {
                of.holding == variable.holding && matches!(of.holding, Holding::One(_))
            };
            match own.iter_mut().find(same) {
                Some(of) => {
                    of.name.clone_from(&variable.name);
                    of.is_watched |= variable.is_watched;
                }
                None => own.push(variable.clone()),
            }
        }
        Variables(own)
    }

    /// Whether there are any: they then are in place of registers and markers.
    pub fn any(&self) -> bool {
        !self.0.is_empty()
    }

    /// Those that PRINT asks to show, where `read` gives what is at a point.
    pub fn watched(&self, read: impl Fn(Address) -> Option<i32>) -> Vec<Vec<Span<'static>>> {
        let watched = self.0.iter().filter(|variable| variable.is_watched);
        watched
            .filter_map(|variable| spans(variable, &read))
            .collect()
    }

    /// The others that are analogue inputs.
    pub fn analogue(&self, read: impl Fn(Address) -> Option<i32>) -> Vec<Vec<Span<'static>>> {
        let is_analogue =
            |of: &&Variable| matches!(of.holding, Holding::One((Address::Analogue(_), _)));
        let others = self.0.iter().filter(|variable| !variable.is_watched);
        others
            .filter(is_analogue)
            .filter_map(|variable| spans(variable, &read))
            .collect()
    }

    /// The others, as far as no lamp and no timer shows them.
    pub fn others(&self, read: impl Fn(Address) -> Option<i32>) -> Vec<Vec<Span<'static>>> {
        let in_memory = |variable: &&Variable| match variable.holding {
            Holding::One((point, _)) => matches!(
                point,
                Address::Register(_) | Address::Marker(_) | Address::Count(_) | Address::System(_)
            ),
            Holding::Either { .. } => true,
            Holding::Constant(..) => false,
        };
        let others = self.0.iter().filter(|variable| !variable.is_watched);
        others
            .filter(in_memory)
            .filter_map(|variable| spans(variable, &read))
            .collect()
    }
}

/// ` level 12.5  `, ` run ●  `
fn spans(
    variable: &Variable,
    read: &impl Fn(Address) -> Option<i32>,
) -> Option<Vec<Span<'static>>> {
    let shown = match variable.value(read)? {
        (Value::Int(0), Base::Bool) => Span::raw("○"),
        (Value::Int(_), Base::Bool) => Span::styled("●", ON),
        _ => Span::raw(variable.shown(read)?),
    };
    let name = Span::raw(format!(" {} ", variable.name));
    Some(vec![name, shown, Span::raw("  ")])
}

/// These in lines of this width, none broken unless it is wider.
pub fn lines(all: Vec<Vec<Span<'static>>>, width: usize) -> Vec<Line<'static>> {
    let mut lines: Vec<Line<'static>> = Vec::new();
    for spans in all {
        let wide: usize = spans.iter().map(Span::width).sum();
        let room = |line: &Line| line.width() + wide <= width;
        if !lines.last().is_some_and(room) {
            lines.push(Line::default());
        }
        if let Some(line) = lines.last_mut() {
            line.spans.extend(spans);
        }
    }
    lines
}
