//! Where parts stand: each at its place, and what has none on the panel below.

use super::brush::Brush;
use super::picture::{Attribute, Element, Id, Item, Live, Picture, Value};
use super::symbols;
use crate::kind::Kind;
use crate::plant::{Decoration, Plant};
use crate::run::Run;
use crate::{read, words};
use unoclp_core::Board;
use unoclp_words::Lang;

/// Around all.
const MARGIN: i32 = 24;
/// Above the machine: its title and the time.
const HEAD: i32 = 56;
/// Between two parts of the panel.
const GAP: i32 = 18;
/// The least width of a picture, for its title.
const LEAST: i32 = 480;

fn leaf(tag: &'static str, class: &str, attributes: Vec<Attribute>, text: &str) -> Item {
    let mut all = vec![("class", Value::Text(class.to_owned().into()))];
    all.extend(attributes);
    Item::Leaf(Element {
        tag,
        id: None,
        attributes: all,
        text: text.to_owned(),
    })
}

fn rect([x, y, w, h]: [i32; 4], round: i32, class: &str) -> Item {
    let all = vec![
        ("x", Value::Number(x)),
        ("y", Value::Number(y)),
        ("width", Value::Number(w)),
        ("height", Value::Number(h)),
        ("rx", Value::Number(round)),
    ];
    leaf("rect", class, all, "")
}

fn text([x, y]: [i32; 2], class: &str, words: &str) -> Item {
    let all = vec![("x", Value::Number(x)), ("y", Value::Number(y))];
    leaf("text", class, all, words)
}

/// A moment of a plant.
pub fn picture(run: &Run<'_>, lang: Lang) -> Picture {
    let plant = run.plant();
    let placed = plant.parts.iter().filter_map(|part| Some((part, part.at?)));
    let points = plant.decorations.iter().flat_map(|drawn| &drawn.points);
    let ends = placed.map(|(part, [x, y])| {
        let [width, height] = part.kind.size;
        [x + width, y + height]
    });
    let ends: Vec<[i32; 2]> = ends.chain(points.copied()).collect();
    let most = |axis: usize| ends.iter().filter_map(|end| end.get(axis)).max().copied();
    let (right, bottom) = (most(0).unwrap_or(0), most(1).unwrap_or(0));
    let panel: Vec<usize> = (0..plant.parts.len())
        .filter(|number| {
            plant
                .parts
                .get(*number)
                .is_some_and(|part| part.at.is_none())
        })
        .collect();
    let inner = right.max(LEAST);
    let (rows, places) = panel_places(run, &panel, inner - 2 * GAP);
    let width = inner + 2 * MARGIN;
    let top = HEAD + bottom + if bottom > 0 { 24 } else { 0 };
    let height = top + rows + MARGIN;

    let mut items = vec![rect([0, 0, width, height], 0, "paper")];
    items.push(text([MARGIN, 34], "title", plant.title.text(lang)));
    items.push(time(
        run,
        vec![
            ("class", "time".into()),
            ("x", Value::Number(width - MARGIN)),
            ("y", Value::Number(34)),
        ],
    ));
    items.push(open(MARGIN, HEAD));
    for (number, drawn) in plant.decorations.iter().enumerate() {
        decoration(&mut items, run, drawn, number, lang);
    }
    for (number, part) in plant.parts.iter().enumerate() {
        if let Some([x, y]) = part.at {
            draw(&mut items, run, number, [x, y], lang);
        }
    }
    items.push(Item::Close);
    if !panel.is_empty() {
        items.push(open(MARGIN, top));
        items.push(rect([0, 0, inner, rows], 10, "plate"));
        items.push(text([GAP, 22], "tag", &words::panel_title(lang)));
        for (number, at) in panel.iter().zip(places) {
            draw(&mut items, run, *number, at, lang);
        }
        items.push(Item::Close);
    }
    Picture {
        width,
        height,
        title: plant.title.text(lang).to_owned(),
        items,
        names: names(plant),
    }
}

/// What changes of a moment of a plant: less than all of it, and quicker.
pub fn live(run: &Run<'_>, lang: Lang) -> Live {
    let plant = run.plant();
    let mut items = vec![time(run, Vec::new())];
    for (number, drawn) in plant.decorations.iter().enumerate() {
        if let Some(class) = flowing(run, drawn) {
            items.push(line(class, number, Vec::new()));
        }
    }
    for number in 0..plant.parts.len() {
        symbol_of(&mut items, run, number, lang, true);
    }
    Live { items }
}

/// How long it has run.
fn time(run: &Run<'_>, attributes: Vec<Attribute>) -> Item {
    Item::Leaf(Element {
        tag: "text",
        id: Some(Id::Time),
        attributes,
        text: format!("{}.{} s", run.now() / 1000, run.now() % 1000 / 100),
    })
}

fn names(plant: &Plant) -> Vec<String> {
    plant.parts.iter().map(|part| part.name.clone()).collect()
}

/// The height of the panel, and where each of its parts stands on it.
fn panel_places(run: &Run<'_>, panel: &[usize], width: i32) -> (i32, Vec<[i32; 2]>) {
    let (mut x, mut y, mut tall) = (0, 34, 0);
    let mut places = Vec::new();
    for number in panel {
        let size = run.plant().parts.get(*number).map(|part| part.kind.size);
        // Room for the label below.
        let [w, h] = size.map_or([0, 0], |[w, h]| [w.max(84), h + 24]);
        if x > 0 && x + w > width {
            (x, y, tall) = (0, y + tall + GAP / 2, 0);
        }
        let inset = size.map_or(0, |[own, _]| (w - own) / 2);
        places.push([GAP + x + inset, y]);
        x += w + GAP;
        tall = tall.max(h);
    }
    (if panel.is_empty() { 0 } else { y + tall + 6 }, places)
}

fn open(x: i32, y: i32) -> Item {
    Item::Open(Element {
        tag: "g",
        id: None,
        attributes: vec![("transform", Value::Moved(x, y))],
        text: String::new(),
    })
}

fn draw(items: &mut Vec<Item>, run: &Run<'_>, number: usize, [x, y]: [i32; 2], lang: Lang) {
    let Some(part) = run.plant().parts.get(number) else {
        return;
    };
    items.push(Item::Open(Element {
        tag: "g",
        id: None,
        attributes: vec![
            ("transform", Value::Moved(x, y)),
            ("data-part", Value::Text(part.name.clone().into())),
        ],
        text: String::new(),
    }));
    symbol_of(items, run, number, lang, false);
    items.push(Item::Close);
}

/// The symbol of a part, or what changes of it.
fn symbol_of(items: &mut Vec<Item>, run: &Run<'_>, number: usize, lang: Lang, live_only: bool) {
    let Some(part) = run.plant().parts.get(number) else {
        return;
    };
    if let Some(symbol) = symbols::of(part.kind) {
        symbol(&mut Brush {
            run,
            number,
            part,
            lang,
            items,
            live_only,
            live: None,
            twin: 0,
        });
    }
}

/// What a line looks like that shows whether something flows; none: it shows nothing.
fn flowing(run: &Run<'_>, drawn: &Decoration) -> Option<&'static str> {
    let flows = drawn
        .carries
        .is_some_and(|(part, value)| run.value(part, value) != 0);
    match (drawn.kind, flows) {
        ("pipe", true) => Some("flow"),
        ("pipe", false) => Some("pipe-in"),
        ("wire", true) => Some("hot"),
        ("wire", false) => Some("wire"),
        _ => None,
    }
}

/// A drawn line that changes.
fn line(class: &'static str, number: usize, more: Vec<Attribute>) -> Item {
    let mut attributes = vec![("class", class.into())];
    attributes.extend(more);
    Item::Leaf(Element {
        tag: "path",
        id: Some(Id::Drawn(number)),
        attributes,
        text: String::new(),
    })
}

fn decoration(items: &mut Vec<Item>, run: &Run<'_>, drawn: &Decoration, number: usize, lang: Lang) {
    let points: Vec<String> = drawn
        .points
        .iter()
        .map(|[x, y]| format!("{x} {y}"))
        .collect();
    let way = || ("d", Value::Text(format!("M{}", points.join("L")).into()));
    match drawn.kind {
        "pipe" => items.push(leaf("path", "pipe", vec![way()], "")),
        "floor" => items.push(leaf("path", "floor", vec![way()], "")),
        "wire" => {}
        "frame" => {
            if let [[x, y], [right, bottom], ..] = drawn.points.as_slice() {
                items.push(rect([*x, *y, right - x, bottom - y], 8, "frame"));
            }
        }
        _ => {
            if let Some(at) = drawn.points.first() {
                items.push(text(*at, "label", drawn.text.text(lang)));
            }
        }
    }
    if let Some(class) = flowing(run, drawn) {
        items.push(line(class, number, vec![way()]));
    }
}

/// The symbol of a kind, as a part of it stands at first; none of a kind that is not there.
pub fn symbol(kind: &Kind, lang: Lang) -> Option<Picture> {
    let plant = read(&crate::guide::sample(kind), Board::PC).ok()?;
    let run = Run::new(&plant, 1);
    let number = plant
        .parts
        .iter()
        .position(|part| part.kind.name == kind.name)?;
    let [w, h] = kind.size;
    let (width, height) = (w.max(90) + 20, h + 40);
    let mut items = vec![rect([0, 0, width, height], 6, "sheet")];
    draw(&mut items, &run, number, [(width - w) / 2, 10], lang);
    Some(Picture {
        width,
        height,
        title: kind.name.to_owned(),
        items,
        names: names(&plant),
    })
}
