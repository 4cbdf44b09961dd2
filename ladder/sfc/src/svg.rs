//! A chart as an SVG.
//!
//! Each part has the class of its kind and a `data-id`. A live part has a second class: `active` of a step, `ready` of a
//! transition that only its condition keeps from firing. So a page draws once, and changes only classes and short texts.

use crate::document::Document;
use crate::live::{Live, seconds};
use crate::measure::{CELL, width};
use crate::sheet::{Area, Id, Item, Line, Shape, Sheet};
use std::fmt::Write as _;

/// How it looks where no page says so.
const STYLE: &str = "<style>.sfc text{font:13px 'DejaVu Sans Mono',Consolas,Menlo,monospace;fill:#1a1a1a}\
.sfc path,.sfc rect{fill:none;stroke:#1a1a1a;stroke-width:1.4}.sfc .bar{stroke-width:3}.sfc .mark{fill:#1a1a1a}\
.sfc .gap{fill:#fff;stroke:none}.sfc .hit{stroke:none;fill:transparent}.sfc .time{font-size:11px}\
.sfc .active rect{fill:#c9f2d0}.sfc .ready .bar{stroke:#0a7d28}</style>";

/// A chart as an SVG that stands by itself, with its title; a page that has its own style takes `is_page`.
pub fn svg(
    document: &Document,
    sheet: &Sheet,
    live: Option<&Live>,
    title: &str,
    is_page: bool,
) -> String {
    let mut to = String::with_capacity(400 * sheet.items.len() + 1000);
    let (wide, high) = (
        (sheet.columns + 1) as f32 * CELL.0,
        (sheet.rows + 1) as f32 * CELL.1,
    );
    let title = escaped(title);
    let _ = write!(
        to,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"sfc\" role=\"img\" aria-label=\"{title}\" width=\"{wide}\" \
         height=\"{high}\" viewBox=\"0 0 {wide} {high}\">"
    );
    if !is_page {
        let _ = write!(
            to,
            "<title>{title}</title>{STYLE}<rect class=\"gap\" width=\"{wide}\" height=\"{high}\"/>"
        );
    }
    let _ = write!(to, "<g transform=\"translate(0,{})\">", CELL.1 / 2.0);
    to.push_str("<path class=\"line\" d=\"");
    sheet.lines.iter().for_each(|line| path(*line, &mut to));
    to.push_str("\"/>");
    for line in &sheet.lines {
        if let Line::Across {
            row,
            from,
            to: end,
            double: true,
        } = *line
        {
            double(row, (from, end), &mut to);
        }
    }
    let drawing = Drawing { document, live };
    sheet
        .items
        .iter()
        .for_each(|item| drawing.item(item, &mut to));
    to.push_str("</g></svg>\n");
    to
}

fn x(column: usize) -> f32 {
    (column as f32 + 0.5) * CELL.0
}

fn y(row: usize) -> f32 {
    (row as f32 + 0.5) * CELL.1
}

/// A line; the double ones are drawn on top of all others.
fn path(line: Line, to: &mut String) {
    let _ = match line {
        Line::Down {
            column,
            from,
            to: end,
        } => {
            let half = |half: usize| half as f32 * CELL.1 / 2.0;
            write!(to, "M{} {}V{}", x(column), half(from), half(end))
        }
        Line::Across { double: true, .. } => Ok(()),
        Line::Across {
            row, from, to: end, ..
        } => {
            write!(to, "M{} {}H{}", x(from), y(row), x(end))
        }
    };
}

fn double(row: usize, (from, end): (usize, usize), to: &mut String) {
    let (left, right, at) = (x(from), x(end), y(row));
    let wide = right - left;
    let (above, below) = (at - 2.0, at + 2.0);
    let _ = write!(
        to,
        "<rect class=\"gap\" x=\"{left}\" y=\"{above}\" width=\"{wide}\" height=\"4\"/>\
         <path class=\"line\" d=\"M{left} {above}H{right}M{left} {below}H{right}\"/>"
    );
}

struct Drawing<'d> {
    document: &'d Document,
    live: Option<&'d Live>,
}

impl Drawing<'_> {
    fn item(&self, item: &Item, to: &mut String) {
        let area = item.area;
        let class = self.class(item);
        let _ = write!(to, "<g class=\"{class}\" data-id=\"{}\">", item.id);
        match &item.shape {
            Shape::Step { label, initial } => {
                rectangle(area, 0.0, to);
                if *initial {
                    rectangle(area, 3.0, to);
                }
                let middle = x(area.x + area.columns / 2);
                said(middle, y(area.y + 1), label, "middle", to);
                let time = self.time(item.id).map(seconds).unwrap_or_default();
                let _ = write!(
                    to,
                    "<text class=\"time\" x=\"{}\" y=\"{}\">{time}</text>",
                    middle + 5.0,
                    y(area.y + area.rows) + 1.0
                );
            }
            Shape::Does { when, name, split } => {
                rectangle(area, 0.0, to);
                let mut from = area.x;
                if let Some(split) = *split {
                    said(x(from + 2) - 4.0, y(area.y + 1), when, "start", to);
                    let line = x(from + split);
                    let (top, low) = (y(area.y), y(area.y + area.rows - 1));
                    let _ = write!(to, "<path d=\"M{line} {top}V{low}\"/>");
                    from += split;
                }
                said(x(from + 2) - 4.0, y(area.y + 1), name, "start", to);
            }
            Shape::Transition { axis, lines } => {
                hit(area, to);
                let (left, right, at) = (x(axis - 2), x(axis + 2), y(area.y));
                let _ = write!(to, "<path class=\"bar\" d=\"M{left} {at}H{right}\"/>");
                for (row, line) in lines.iter().enumerate() {
                    said(x(axis + 4) - 4.0, y(area.y + row), line, "start", to);
                }
            }
            Shape::Jump(label) => mark(area, label, "mark", to),
            Shape::Wait(label) => mark(area, label, "open", to),
        }
        to.push_str("</g>");
    }

    fn class(&self, item: &Item) -> String {
        let mut class = String::from(match item.shape {
            Shape::Step { initial: true, .. } => "step initial",
            Shape::Step { .. } => "step",
            Shape::Does { .. } => "does",
            Shape::Transition { .. } => "transition",
            Shape::Jump(_) => "jump",
            Shape::Wait(_) => "wait",
        });
        let live = self.live.filter(|live| match item.id {
            Id::Step(step) | Id::Does(step, _) => live.is_active(step),
            Id::Transition(transition) => live.may_fire(self.document, transition),
            Id::Jump(..) | Id::Wait(..) => false,
        });
        match (live, item.id) {
            (None, _) => {}
            (Some(_), Id::Transition(_)) => class.push_str(" ready"),
            (Some(_), _) => class.push_str(" active"),
        }
        class
    }

    fn time(&self, id: Id) -> Option<i64> {
        let Id::Step(step) = id else { return None };
        let state = self.live?.steps.get(step)?;
        state.time.filter(|_| state.active)
    }
}

fn rectangle(area: Area, within: f32, to: &mut String) {
    let (left, top) = (x(area.x) + within, y(area.y) + within);
    let wide = (area.columns - 1) as f32 * CELL.0 - 2.0 * within;
    let high = (area.rows - 1) as f32 * CELL.1 - 2.0 * within;
    let _ = write!(
        to,
        "<rect x=\"{left}\" y=\"{top}\" width=\"{wide}\" height=\"{high}\"/>"
    );
}

/// What takes a click beside the lines.
fn hit(area: Area, to: &mut String) {
    let (left, top) = (x(area.x) - 4.0, y(area.y) - CELL.1 / 2.0);
    let (wide, high) = (area.columns as f32 * CELL.0, area.rows as f32 * CELL.1);
    let _ = write!(
        to,
        "<rect class=\"hit\" x=\"{left}\" y=\"{top}\" width=\"{wide}\" height=\"{high}\"/>"
    );
}

fn mark(area: Area, label: &str, class: &str, to: &mut String) {
    hit(area, to);
    let (at, top) = (x(area.x), y(area.y) - 2.0);
    let _ = write!(
        to,
        "<path class=\"{class}\" d=\"M{} {top}h10l-5 9z\"/>",
        at - 5.0
    );
    said(at + CELL.0 + 2.0, y(area.y), label, "start", to);
}

/// A text, its middle at this height; no wider than its cells.
fn said(x: f32, y: f32, text: &str, anchor: &str, to: &mut String) {
    if text.is_empty() {
        return;
    }
    let anchor = match anchor {
        "start" => String::new(),
        anchor => format!(" text-anchor=\"{anchor}\""),
    };
    let wide = width(text) as f32 * (CELL.0 - 0.2);
    let base = y + 4.5;
    let _ = write!(
        to,
        "<text x=\"{x}\" y=\"{base}\"{anchor} textLength=\"{wide}\" lengthAdjust=\"spacingAndGlyphs\">{}</text>",
        escaped(text)
    );
}

/// A text as XML has it.
fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            c if c < ' ' || matches!(c, '\u{FFFE}' | '\u{FFFF}') => escaped.push(' '),
            c => escaped.push(c),
        }
    }
    escaped
}
