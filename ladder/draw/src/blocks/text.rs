//! A rung as blocks, in characters: `I1 ──┤≥1├──┤ Q1 │`.

use super::graph::{Graph, Kind, Vertex};
use super::place::Placed;
use crate::face::Face;
use crate::style::Medium;
use crate::{Ladder, Names, Rung, Symbol};
use unicode_width::UnicodeWidthStr;

/// Between a block and the wires that go down after it.
const BEFORE: usize = 1;
/// From there to the next block: a wire, and the sign that negates.
const AFTER: usize = 2;

/// A rung as blocks, line by line.
pub(crate) fn picture(ladder: &Ladder, rung: &Rung, names: &Names) -> Vec<String> {
    let graph = Graph::of(ladder, rung);
    let said: Vec<String> = graph
        .vertices
        .iter()
        .map(|vertex| said(vertex, ladder, names))
        .collect();
    let placed = Placed::of(&graph, &|_| 1);
    let mut widths = vec![0; placed.columns.len()];
    for (spot, said) in placed.spots.iter().zip(&said) {
        widths[spot.column] = widths[spot.column].max(said.width());
    }
    let mut lefts = Vec::new();
    let mut x = 0;
    for (width, down) in widths.iter().zip(&placed.columns) {
        lefts.push(x);
        x += width + BEFORE + down + AFTER;
    }
    let mut cells = Cells(vec![vec![' '; x]; placed.rows.max(1)]);
    for (at, vertex) in graph.vertices.iter().enumerate() {
        let spot = &placed.spots[at];
        for (pin, route) in vertex.inputs.iter().zip(&spot.routes) {
            let source = &placed.spots[pin.from];
            let mut from = lefts[source.column] + said[pin.from].width();
            if is_value(&graph.vertices[pin.from]) {
                from = lefts[source.column] + widths[source.column];
            }
            let to = lefts[spot.column];
            match route.down {
                None => cells.across(route.row, from, to),
                Some(track) => {
                    let x = lefts[source.column] + widths[source.column] + BEFORE + track;
                    cells.across(source.row, from, x + 1);
                    cells.down(x, source.row, route.row);
                    cells.across(route.row, x + 1, to);
                }
            }
            if pin.negated != ends_negated(vertex, ladder) {
                cells.0[route.row][to - 1] = 'o';
            }
        }
    }
    for (at, vertex) in graph.vertices.iter().enumerate() {
        let (spot, said) = (&placed.spots[at], &said[at]);
        let mut x = lefts[spot.column];
        if is_value(vertex) {
            x += widths[spot.column] - said.width();
        }
        cells.write(spot.row, x, said);
        for row in spot.row + 1..=spot.last() {
            let inside = " ".repeat(said.width().saturating_sub(2));
            let is_input = spot.routes.iter().any(|route| route.row == row);
            let edge = if is_input { '┤' } else { '│' };
            cells.write(row, x, &format!("{edge}{inside}│"));
        }
    }
    cells.lines()
}

fn is_value(vertex: &Vertex) -> bool {
    matches!(vertex.kind, Kind::Value(_) | Kind::Named(_))
}

/// What a block says.
fn said(vertex: &Vertex, ladder: &Ladder, names: &Names) -> String {
    let (index, sign) = match &vertex.kind {
        Kind::Gate(sign, _) => return format!("┤{sign:^3}├"),
        Kind::Named(name) => return format!("{name} "),
        Kind::Store(name) => return format!("┤ {name} │"),
        Kind::Value(index) => (*index, ' '),
        Kind::Box(index) => (*index, '├'),
        Kind::Output(index) => (*index, '│'),
    };
    let Some(element) = ladder.elements.get(index) else {
        return String::new();
    };
    let text = match &element.symbol {
        Symbol::Coil {
            letter: ' ' | '/',
            text,
        } => text.clone(),
        Symbol::Coil { letter, text } => format!("{letter} {text}"),
        Symbol::Inline(text) => (*text).to_owned(),
        Symbol::Contact { text, .. } | Symbol::Box { text, .. } | Symbol::Leave { text, .. } => {
            text.clone()
        }
    };
    let name = Face::new(element, names, Medium::PLAIN).name;
    let text = name.map_or(text.clone(), |name| format!("{name} {text}"));
    match vertex.kind {
        Kind::Value(_) => text + " ",
        _ => format!("┤ {text} {sign}"),
    }
}

/// Whether what leads to an output is negated there.
fn ends_negated(vertex: &Vertex, ladder: &Ladder) -> bool {
    let Kind::Output(index) = vertex.kind else {
        return false;
    };
    let element = ladder.elements.get(index);
    element.is_some_and(|element| {
        matches!(
            element.symbol,
            Symbol::Coil { letter: '/', .. } | Symbol::Leave { inverted: true, .. }
        )
    })
}

/// Characters, row by row; the second column of a wide one is `\0`.
struct Cells(Vec<Vec<char>>);

impl Cells {
    fn across(&mut self, row: usize, from: usize, to: usize) {
        for cell in &mut self.0[row][from..to] {
            *cell = match *cell {
                '│' => '┼',
                ' ' => '─',
                other => other,
            };
        }
    }

    fn down(&mut self, x: usize, from: usize, to: usize) {
        self.0[from][x] = match self.0[from][x] {
            '┼' | '│' | '├' => '┼',
            _ => '┬',
        };
        for row in from + 1..to {
            let cell = &mut self.0[row][x];
            *cell = if *cell == '─' { '┼' } else { '│' };
        }
        self.0[to][x] = '└';
    }

    fn write(&mut self, row: usize, x: usize, text: &str) {
        let mut x = x;
        for ch in text.chars() {
            let width = ch.to_string().width();
            let cells = self.0[row].iter_mut().skip(x).take(width);
            for (at, cell) in cells.enumerate() {
                *cell = if at == 0 { ch } else { '\0' };
            }
            x += width;
        }
    }

    fn lines(self) -> Vec<String> {
        let rows = self.0.into_iter();
        rows.map(|row| {
            let line: String = row.into_iter().filter(|ch| *ch != '\0').collect();
            line.trim_end().to_owned()
        })
        .collect()
    }
}
