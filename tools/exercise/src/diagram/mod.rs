//! A run of a scenario as a picture: what was pressed, and for each output what was expected above what came.
//!
//! - `lanes`: what there is to show
//! - `moment`: what passed between a program and its machine about a moment
//! - `stroke`: a course over time as lines and boxes
//! - `words`: the words in it
//!
//! It owns how a run looks, on paper and in a page. It must not know where the picture goes, nor how a run is made.
//! What differs is told by words and by place too, never by colour alone.

mod lanes;
mod moment;
mod stroke;
mod words;

pub use moment::Moment;

use crate::scenario::{Both, Report, Scenario};
use lanes::{Lane, lanes};
use std::collections::BTreeMap;
use stroke::{ROW, Scale, label, line, stroke};
use svg::Document;
use svg::node::element::{Group, Rectangle, Title};
use unoclp_core::Millis;
use unoclp_program::Lang;

/// A run to be drawn.
#[derive(Clone, Copy, Debug)]
pub struct Run<'r> {
    /// The case that ran.
    pub scenario: &'r Scenario,
    /// What came of it.
    pub report: &'r Report,
}

/// Units of the picture, which are pixels on a screen.
const WIDTH: f32 = 900.0;
const MARGIN: f32 = 16.0;
/// Where time begins.
const LEFT: f32 = 250.0;
/// Between lanes.
const GAP: f32 = 6.0;
/// From one line of text to the next.
const TEXT: f32 = 20.0;
/// The size of what stands beside and below lanes.
const SMALL: f32 = 12.0;
/// A letter takes no more, on an average.
const LETTER: f32 = 6.6;
/// A time below the lanes needs so much.
const TIME: f32 = 60.0;

const INK: &str = "#1a1a1a";
const PALE: &str = "#5c6670";
const LINE: &str = "#d5dade";
const RED: &str = "#b3261e";
const GREEN: &str = "#12684f";
const BLUE: &str = "#274b8f";

/// What a picture is made for.
#[derive(Clone, Copy, Debug)]
struct Form {
    width: f32,
    /// Where time begins.
    left: f32,
    /// Whether a name stands above its lane, not before it.
    is_above: bool,
}

const PAPER: Form = Form {
    width: WIDTH,
    left: LEFT,
    is_above: false,
};
const COLUMN: Form = Form {
    width: 300.0,
    left: 78.0,
    is_above: true,
};

impl Form {
    fn plot(self) -> f32 {
        self.width - self.left - 2.0 * MARGIN
    }

    /// Lines of a text from `y` on, and the `y` of the next.
    fn lines(self, text: &str, y: f32, ink: &str) -> (Group, f32) {
        let letters = ((self.width - 2.0 * MARGIN) / LETTER) as usize;
        let mut lines = vec![String::new()];
        for word in text.split_whitespace() {
            match lines.last_mut() {
                Some(line) if line.is_empty() => line.push_str(word),
                Some(line) if line.chars().count() + 1 + word.chars().count() <= letters => {
                    line.push(' ');
                    line.push_str(word);
                }
                _ => lines.push(word.to_owned()),
            }
        }
        let group = Group::new();
        lines.iter().fold((group, y), |(group, y), line| {
            (group.add(label(MARGIN, y, line, ink)), y + TEXT)
        })
    }
}

/// These runs below each other as an SVG document; `names` are what is connected to the points.
pub fn svg(runs: &[Run<'_>], names: &BTreeMap<String, Both>, lang: Lang) -> String {
    on(PAPER, runs, names, lang)
}

/// The same for a column beside a program.
pub fn column(runs: &[Run<'_>], names: &BTreeMap<String, Both>, lang: Lang) -> String {
    on(COLUMN, runs, names, lang)
}

fn on(form: Form, runs: &[Run<'_>], names: &BTreeMap<String, Both>, lang: Lang) -> String {
    let (mut page, mut y) = (Group::new(), MARGIN);
    let mut about = Vec::new();
    for run in runs {
        let (group, below) = drawn(*run, names, lang, y, form);
        page = page.add(group);
        y = below + 2.0 * GAP;
        about.push(format!(
            "{}: {}",
            run.scenario.about(lang),
            told(*run, lang)
        ));
    }
    let (legend, y) = form.lines(&words::legend(lang), y + 12.0, PALE);
    document(
        page.add(legend),
        (form.width, y - TEXT + MARGIN),
        &about.join("\n"),
    )
}

/// A page of this width and height as a document.
fn document(page: Group, (width, height): (f32, f32), about: &str) -> String {
    let paper = Rectangle::new()
        .set("width", width)
        .set("height", height)
        .set("fill", "#ffffff");
    Document::new()
        .set("width", width)
        .set("height", height)
        .set("viewBox", (0.0, 0.0, width, height))
        .set("role", "img")
        .set("font-family", "Helvetica, Arial, 'DejaVu Sans', sans-serif")
        .set("font-size", 13)
        .add(Title::new(about))
        .add(paper)
        .add(page)
        .to_string()
}

/// How a run ended, in a line.
fn told(run: Run<'_>, lang: Lang) -> String {
    run.report.verdict.brief(lang)
}

/// A run from `y` on, and where it ends.
fn drawn(
    run: Run<'_>,
    names: &BTreeMap<String, Both>,
    lang: Lang,
    y: f32,
    form: Form,
) -> (Group, f32) {
    let plan = run.scenario.plan();
    let lanes = lanes(&plan, run.report, names, lang);
    let colour = if run.report.passed() { GREEN } else { RED };
    let (title, below) = form.lines(run.scenario.about(lang), y + 14.0, INK);
    let (verdict, below) = form.lines(&told(run, lang), below, colour);
    let top = below - 10.0;
    let scale = Scale {
        left: form.left,
        width: form.plot(),
        from: 0,
        until: plan.until.max(1),
    };
    let (mut drawn, mut bottom) = (Group::new(), top);
    for lane in &lanes {
        let (next, below) = drawn_lane(lane, scale, run.report.end, bottom, lang, form);
        drawn = drawn.add(next);
        bottom = below + GAP;
    }
    let mut group = Group::new()
        .add(title.set("font-weight", "bold"))
        .add(verdict);
    if plan.until > 0 {
        group = group.add(axis(scale, top, bottom, lang));
    }
    group = group.add(drawn);
    for &cut in &plan.restarts {
        let x = scale.x(cut);
        group = group
            .add(line(x, top, x, bottom, PALE).set("stroke-dasharray", "2 3"))
            .add(label(x + 4.0, top + 10.0, &words::power_cut(lang), PALE).set("font-size", SMALL));
    }
    let unmet = lanes.iter().filter_map(|lane| lane.unmet.first());
    if let Some(&(first, _)) = unmet.min() {
        let x = scale.x(first);
        group = group.add(line(x, top, x, bottom, RED).set("stroke-dasharray", "5 3"));
    }
    if plan.until > 0 {
        bottom += 20.0;
    }
    (group, bottom)
}

/// A lane from `y` on, and where it ends.
fn drawn_lane(
    lane: &Lane,
    scale: Scale,
    end: Millis,
    y: f32,
    lang: Lang,
    form: Form,
) -> (Group, f32) {
    // Where it stands above its lane, lines of times go behind it.
    let name = label(MARGIN, y + ROW - 8.0, &cut(&lane.label), INK)
        .set("stroke", "#ffffff")
        .set("stroke-width", 4)
        .set("paint-order", "stroke");
    let mut group = Group::new().add(name);
    let y = if form.is_above { y + TEXT } else { y };
    let Some(expected) = &lane.expected else {
        group = group.add(stroke(&lane.came, lane.is_bit, scale, y, end, BLUE));
        return (group, y + ROW);
    };
    for &(from, to) in &lane.unmet {
        let x = scale.x(from);
        let unmet = Rectangle::new()
            .set("x", x)
            .set("y", y)
            .set("width", (scale.x(to) - x).max(2.0))
            .set("height", 2.0 * ROW)
            .set("fill", "#fbdcd9");
        group = group.add(unmet);
    }
    let colour = if lane.unmet.is_empty() { GREEN } else { RED };
    let rows = [(words::expected(lang), PALE), (words::came(lang), colour)];
    for (row, (word, colour)) in rows.iter().enumerate() {
        let y = y + row as f32 * ROW + ROW - 8.0;
        group = group.add(
            label(scale.left - 8.0, y, word, colour)
                .set("text-anchor", "end")
                .set("font-size", SMALL),
        );
    }
    let until = scale.until;
    group = group
        .add(stroke(expected, lane.is_bit, scale, y, until, PALE).set("stroke-dasharray", "4 2"))
        .add(stroke(&lane.came, lane.is_bit, scale, y + ROW, end, colour));
    (group, y + 2.0 * ROW)
}

/// The most letters of a label.
const LETTERS: usize = 24;

/// A label, cut where it is too long.
fn cut(text: &str) -> String {
    match text.chars().count() > LETTERS {
        true => text.chars().take(LETTERS - 1).chain(['…']).collect(),
        false => text.to_owned(),
    }
}

/// The times below the lanes, and thin lines up from them.
fn axis(scale: Scale, top: f32, bottom: f32, lang: Lang) -> Group {
    let steps = (0..9).flat_map(|power| [1, 2, 5].map(|step: Millis| step * 10_u32.pow(power)));
    let span = scale.until.saturating_sub(scale.from);
    let most = (scale.width / TIME) as Millis;
    let is_wide = |step: &Millis| span / step <= most;
    let mut steps = steps.into_iter();
    let step = steps.find(is_wide).unwrap_or(Millis::MAX);
    let first = scale.from.div_ceil(step).saturating_mul(step);
    let mut group = Group::new();
    for at in (first..=scale.until).step_by(step as usize) {
        let x = scale.x(at);
        let time = match step % 100 {
            0 => words::seconds(lang, at / 1000, at % 1000 / 100),
            _ => format!("{at} ms"),
        };
        group = group
            .add(line(x, top, x, bottom, LINE).set("stroke-width", 0.5))
            .add(
                label(x, bottom + 14.0, &time, PALE)
                    .set("text-anchor", "middle")
                    .set("font-size", SMALL),
            );
    }
    group
}
