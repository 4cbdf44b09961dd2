//! A page of paper: its size, its margins, and what is written on it, in millimetres.

use crate::listing::wrapped;
use crate::svg_page::node::Node;
use crate::svg_page::page::{Font, INK, MONO, SANS};

/// What a report is printed on, upright.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Paper {
    /// 210 × 297 mm (ISO 216).
    #[default]
    A4,
    /// 8.5 × 11 inches.
    Letter,
}

impl Paper {
    /// Width and height.
    pub(super) fn size(self) -> (f32, f32) {
        match self {
            Paper::A4 => (210.0, 297.0),
            Paper::Letter => (215.9, 279.4),
        }
    }

    /// What stays empty at each edge.
    pub(super) fn margin(self) -> f32 {
        15.0
    }

    /// Width and height within the margins, without the foot.
    pub(super) fn room(self) -> (f32, f32) {
        let (width, height) = self.size();
        let margins = 2.0 * self.margin();
        (width - margins, height - margins - FOOT)
    }

    /// Where the foot begins.
    fn bottom(self) -> f32 {
        self.margin() + self.room().1
    }
}

/// The height of a page's foot.
const FOOT: f32 = 8.0;

/// How text is set on paper.
pub(super) struct Type {
    font: Font,
    /// The width of a letter, of its height. Sans serif has no one width: that of a wide text.
    letter: f32,
}

/// A report's title.
pub(super) const TITLE: Type = Type::new(SANS, 5.6, true, 0.62);
/// A heading within a report.
pub(super) const HEAD: Type = Type::new(SANS, 4.0, true, 0.62);
/// All else in sans serif.
pub(super) const SMALL: Type = Type::new(SANS, 3.2, false, 0.6);
/// A row of a table.
pub(super) const ROW: Type = Type::new(MONO, 3.0, false, 0.61);

impl Type {
    const fn new(family: &'static str, height: f32, bold: bool, letter: f32) -> Type {
        Type {
            font: Font::new(family, height, bold, false, ""),
            letter,
        }
    }

    /// The height of its letters.
    pub(super) fn height(&self) -> f32 {
        self.font.size
    }

    /// From one line to the next.
    pub(super) fn line(&self) -> f32 {
        self.height() * 1.35
    }

    /// How many letters go into so many millimetres.
    pub(super) fn columns(&self, wide: f32) -> usize {
        (wide / (self.height() * self.letter)) as usize
    }
}

/// A page that fills from the top.
pub(super) struct Leaf {
    group: Node,
    /// Where it goes on.
    pub(super) y: f32,
    /// Whether nothing stands on it but its head.
    pub(super) empty: bool,
}

impl Leaf {
    /// An empty page whose head begins here.
    pub(super) fn new(y: f32) -> Leaf {
        Leaf {
            group: Node::group(),
            y,
            empty: true,
        }
    }

    /// What is left of its height.
    pub(super) fn room(&self, paper: Paper) -> f32 {
        (paper.bottom() - self.y).max(1.0)
    }

    /// Adds what stands below its head.
    pub(super) fn add(&mut self, node: Node) {
        self.put(node);
        self.empty = false;
    }

    fn put(&mut self, node: Node) {
        self.group.add(node);
    }

    /// Writes a line, from the left.
    pub(super) fn text(&mut self, x: f32, y: f32, text: &str, set: &Type) {
        self.put(set.font.written(x, y, text));
    }

    /// A line across, between two edges.
    pub(super) fn rule(&mut self, from: f32, to: f32, y: f32) {
        let path = Node::path()
            .set("d", format!("M{from} {y}H{to}"))
            .set("fill", "none")
            .set("stroke", INK)
            .set("stroke-width", 0.2);
        self.put(path);
    }

    /// Words, and after them a line to write on.
    pub(super) fn blank(&mut self, from: f32, to: f32, y: f32, words: &str) {
        self.text(from, y, words, &SMALL);
        let wide = words.chars().count() as f32 * SMALL.height() * SMALL.letter;
        self.rule(from + wide + 1.0, to, y + 0.8);
    }

    /// The page with its foot.
    pub(super) fn finish(mut self, paper: Paper, file: &str, page: &str) -> Node {
        let (width, height) = paper.size();
        let (left, right) = (paper.margin(), width - paper.margin());
        let base = height - paper.margin();
        // The page of how many is never covered.
        let columns = SMALL
            .columns(right - left)
            .saturating_sub(page.chars().count() + 2);
        let file: String = file.chars().take(columns).collect();
        self.text(left, base, &file, &SMALL);
        self.put(
            SMALL
                .font
                .written(right, base, page)
                .set("text-anchor", "end"),
        );
        let sheet = Node::rectangle()
            .set("width", width)
            .set("height", height)
            .set("fill", "#ffffff");
        Node::group().with(sheet).with(self.group)
    }
}

/// A text in lines of so many letters: between words where there are some.
pub(super) fn lines(text: &str, columns: usize) -> Vec<String> {
    let long = wrapped(text, columns);
    let letters = long.iter().map(|line| line.chars().collect::<Vec<_>>());
    let parts = letters.flat_map(|line| {
        let parts = line
            .chunks(columns.max(1))
            .map(|part| part.iter().collect());
        parts.collect::<Vec<String>>()
    });
    parts.collect()
}
