//! Where parts stand: each at its place, and what has none on the panel below.

use super::brush::Brush;
use super::picture::{Element, Item, Picture};
use super::symbols;
use crate::kind::Kind;
use crate::plant::Decoration;
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

fn leaf(
    tag: &'static str,
    class: &str,
    attributes: Vec<(&'static str, String)>,
    text: &str,
) -> Item {
    let mut all = vec![("class", class.to_owned())];
    all.extend(attributes);
    Item::Leaf(Element {
        tag,
        id: None,
        attributes: all,
        text: text.to_owned(),
    })
}

fn rect([x, y, w, h]: [i32; 4], round: i32, class: &str) -> Item {
    let of = |name: &'static str, value: i32| (name, value.to_string());
    let all = vec![
        of("x", x),
        of("y", y),
        of("width", w),
        of("height", h),
        of("rx", round),
    ];
    leaf("rect", class, all, "")
}

fn text([x, y]: [i32; 2], class: &str, words: &str) -> Item {
    let all = vec![("x", x.to_string()), ("y", y.to_string())];
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
    let seconds = format!("{}.{} s", run.now() / 1000, run.now() % 1000 / 100);
    items.push(Item::Leaf(Element {
        tag: "text",
        id: Some("time".to_owned()),
        attributes: vec![
            ("class", "time".to_owned()),
            ("x", (width - MARGIN).to_string()),
            ("y", "34".to_owned()),
        ],
        text: seconds,
    }));
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
    }
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
        attributes: vec![("transform", format!("translate({x},{y})"))],
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
            ("transform", format!("translate({x},{y})")),
            ("data-part", part.name.clone()),
        ],
        text: String::new(),
    }));
    let mut brush = Brush {
        run,
        number,
        part,
        lang,
        items,
        live: None,
        twin: 0,
    };
    if let Some(symbol) = symbols::of(part.kind) {
        symbol(&mut brush);
    }
    items.push(Item::Close);
}

fn decoration(items: &mut Vec<Item>, run: &Run<'_>, drawn: &Decoration, number: usize, lang: Lang) {
    let carries = drawn
        .carries
        .is_some_and(|(part, value)| run.value(part, value) != 0);
    let points: Vec<String> = drawn
        .points
        .iter()
        .map(|[x, y]| format!("{x} {y}"))
        .collect();
    let way = format!("M{}", points.join("L"));
    let path = |class: &str, live: bool| {
        Item::Leaf(Element {
            tag: "path",
            id: live.then(|| format!("drawn-{number}")),
            attributes: vec![("class", class.to_owned()), ("d", way.clone())],
            text: String::new(),
        })
    };
    match drawn.kind {
        "pipe" => {
            items.push(path("pipe", false));
            items.push(path(if carries { "flow" } else { "pipe-in" }, true));
        }
        "wire" => items.push(path(if carries { "hot" } else { "wire" }, true)),
        "frame" => {
            if let [[x, y], [right, bottom], ..] = drawn.points.as_slice() {
                items.push(rect([*x, *y, right - x, bottom - y], 8, "frame"));
            }
        }
        "floor" => items.push(path("floor", false)),
        _ => {
            if let Some(at) = drawn.points.first() {
                items.push(text(*at, "label", drawn.text.text(lang)));
            }
        }
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
    })
}
