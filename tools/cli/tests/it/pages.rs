//! Programs on pages of paper: every rung whole, on one page, within its margins.

use crate::common::{empty_folder, outcome, outcome_in};
use roxmltree::{Document, Node};
use std::fs;
use std::path::Path;
use unoclp_host_sim::random::{Random, random_program};
use unoclp_program::list::{Paper, pages};
use unoclp_program::{Lang, Source, Written};
use unoclp_testing::held;

/// The margin of every page, millimetres; a wire may be half as wide as this beyond it.
const MARGIN: f32 = 15.0;
const STROKE: f32 = 0.4;

fn program(name: &str, text: &str) -> Option<Source> {
    Written::new(
        name.to_owned(),
        text.as_bytes().to_vec(),
        unoclp_core::Board::UNO,
    )
    .check(None)
    .ok()
}

fn number(node: Node<'_, '_>, name: &str) -> f32 {
    node.attribute(name).unwrap().parse().unwrap()
}

/// The numbers of a text: `translate(1 2) scale(3)`, `M1 2H3`.
fn numbers(text: &str) -> Vec<f32> {
    let parts = text.split(|ch: char| !ch.is_ascii_digit() && ch != '.' && ch != '-');
    parts.filter_map(|part| part.parse().ok()).collect()
}

/// The places of a path: those that its letters name.
fn places(data: &str) -> (Vec<f32>, Vec<f32>) {
    let (mut across, mut down) = (Vec::new(), Vec::new());
    let at = |index: usize, ch: char| ch.is_ascii_alphabetic().then_some(index);
    let starts: Vec<usize> = data
        .char_indices()
        .filter_map(|(index, ch)| at(index, ch))
        .collect();
    for (order, &start) in starts.iter().enumerate() {
        let end = starts.get(order + 1).copied().unwrap_or(data.len());
        let values = numbers(&data[start + 1..end]);
        match (&data[start..=start], &values[..]) {
            ("H", [x]) => across.push(*x),
            ("V", [y]) => down.push(*y),
            ("M" | "L" | "A", [.., x, y]) => {
                across.push(*x);
                down.push(*y);
            }
            other => panic!("{other:?} in {data}"),
        }
    }
    (across, down)
}

/// Where a rung begins and ends on its page: left, top, right, bottom, millimetres.
fn extent(rung: Node<'_, '_>) -> [f32; 4] {
    let [scale, _, _, _, left, top] = numbers(rung.attribute("transform").unwrap())[..] else {
        panic!("{rung:?}");
    };
    let (mut across, mut down) = (Vec::new(), Vec::new());
    for node in rung.descendants() {
        match node.tag_name().name() {
            "path" => {
                let (x, y) = places(node.attribute("d").unwrap());
                across.extend(x);
                down.extend(y);
            }
            "rect" => {
                let (x, y) = (number(node, "x"), number(node, "y"));
                across.extend([x, x + number(node, "width")]);
                down.extend([y, y + number(node, "height")]);
            }
            "text" => down.extend([
                number(node, "y") - number(node, "font-size"),
                number(node, "y"),
            ]),
            _ => {}
        }
    }
    let least = |all: &[f32]| all.iter().copied().fold(f32::MAX, f32::min);
    let most = |all: &[f32]| all.iter().copied().fold(f32::MIN, f32::max);
    [
        left + scale * least(&across),
        top + scale * least(&down),
        left + scale * most(&across),
        top + scale * most(&down),
    ]
}

/// Looks at all pages of a program, and gives how many there are.
fn look(program: &Source, paper: Paper, width: usize) -> usize {
    let pages = pages(program, width, paper, None, Lang::Pt);
    let (wide, high) = match paper {
        Paper::A4 => (210.0, 297.0),
        Paper::Letter => (215.9, 279.4),
    };
    let mut rungs = Vec::new();
    for (index, page) in pages.iter().enumerate() {
        let tree = Document::parse(page).unwrap();
        let root = tree.root_element();
        assert_eq!(root.attribute("width"), Some(&*format!("{wide}mm")));
        assert_eq!(root.attribute("height"), Some(&*format!("{high}mm")));
        let foot = format!("Página {} de {}", index + 1, pages.len());
        let texts = || root.descendants().filter(|node| node.has_tag_name("text"));
        assert!(
            texts().any(|text| text.text().map(str::trim) == Some(&foot)),
            "{page}"
        );
        let mut below = MARGIN;
        for rung in root
            .descendants()
            .filter(|node| node.attribute("class") == Some("rung"))
        {
            let [left, top, right, bottom] = extent(rung);
            assert!(
                left >= MARGIN - STROKE && right <= wide - MARGIN + STROKE,
                "{page}"
            );
            assert!(top >= below - STROKE && bottom <= high - MARGIN, "{page}");
            below = bottom;
            rungs.push(
                rung.attribute("data-rung")
                    .unwrap()
                    .parse::<usize>()
                    .unwrap(),
            );
        }
        for text in
            texts().filter(|text| text.parent_element().unwrap().attribute("class") != Some("rung"))
        {
            let y = number(text, "y");
            assert!(y > MARGIN && y <= high - MARGIN, "{y} in {page}");
        }
    }
    let all: Vec<usize> = (1..=rungs.len()).collect();
    assert_eq!(rungs, all, "each rung once, in order");
    pages.len()
}

#[test]
fn no_rung_is_on_two_pages_and_none_is_lost() {
    let takes_several = |seed: u64| {
        let file = random_program(&mut Random::new(seed));
        let program = program("p.txt", &file).unwrap();
        let paper = if seed.is_multiple_of(2) {
            Paper::A4
        } else {
            Paper::Letter
        };
        look(&program, paper, [56, 80, 200][seed as usize % 3]) > 1
    };
    let several = (0..400).filter(|seed| held(|| takes_several(*seed)));
    assert!(several.count() > 0);
}

#[test]
fn a_rung_that_is_too_high_for_a_page_is_drawn_smaller() {
    let text = format!("LD I1\n{}ST Q1\n", "OR I2\n".repeat(60));
    assert_eq!(look(&program("high.il", &text).unwrap(), Paper::A4, 80), 2);
}

#[test]
fn points_are_listed_with_their_names_and_rungs() {
    let text = "(* Two lamps *)\nVAR start AT %IX0.0 : BOOL; lamp AT %QX0.0 : BOOL; END_VAR\n\
        LD start\nST lamp\nLD lamp\nST Q2\n";
    let pages = pages(
        &program("two.il", text).unwrap(),
        80,
        Paper::A4,
        None,
        Lang::En,
    );
    let tree = Document::parse(&pages[0]).unwrap();
    let texts: Vec<&str> = tree
        .descendants()
        .filter(|node| node.is_text())
        .filter_map(|node| node.text())
        .map(str::trim)
        .collect();
    let at = texts.iter().position(|text| *text == "Points").unwrap();
    let table: Vec<&str> = texts[at..]
        .iter()
        .copied()
        .filter(|text| !text.is_empty())
        .collect();
    let expected = "Points point name rungs I1 start 1 Q1 lamp 1 2 Q2 2 two.il Page 1 of 1";
    assert_eq!(table.join(" ").replace(", ", " "), expected);
    assert_eq!(
        texts.iter().filter(|text| **text == "Two lamps").count(),
        2,
        "as title, and at the head"
    );
}

#[test]
fn a_table_that_goes_on_has_its_columns_named_again() {
    let rungs = (1..=56).map(|number| format!("LD M{number}\nST Q1\n"));
    let program = program("many.il", &rungs.collect::<String>()).unwrap();
    let pages = pages(&program, 80, Paper::Letter, None, Lang::Pt);
    let with = |text: &str| pages.iter().filter(|page| page.contains(text)).count();
    assert_eq!(with(">Pontos<"), 1);
    assert_eq!(with(">degraus<"), 2, "{} pages", pages.len());
}

#[test]
fn pages_are_written_each_into_a_file_and_over_no_other() {
    let folder = empty_folder("pages");
    let at = |name: &str| folder.join(name).to_str().unwrap().to_owned();
    let traffic = folder_of("traffic.txt");
    let out = at("t.svg");
    let (code, said, _) = outcome(&[
        "list",
        &traffic,
        "--svg",
        &out,
        "--paper",
        "a4",
        "--title",
        "Sinal <1>",
    ]);
    assert_eq!(code, 0);
    let written: Vec<String> = said
        .lines()
        .map(|line| line.trim_end_matches(": drawn").to_owned())
        .collect();
    assert!(written.len() > 1, "{said}");
    assert_eq!(written[0], at("t-1.svg"));
    let first = fs::read_to_string(&written[0]).unwrap();
    assert!(first.contains("Sinal &lt;1&gt;"), "{first}");
    assert!(!fs::exists(&out).unwrap());

    // One that is something else stops all of them.
    fs::write(&written[1], "my notes").unwrap();
    fs::remove_file(&written[0]).unwrap();
    let (code, _, err) = outcome_in(
        &["list", &traffic, "--svg", &out, "--paper", "letter"],
        "pt",
    );
    assert_eq!(code, 2);
    assert!(err.contains("t-2.svg"), "{err}");
    assert_eq!(fs::read_to_string(&written[1]).unwrap(), "my notes");
    assert!(!fs::exists(&written[0]).unwrap());

    // Pages are of a picture; a title is of pages.
    let (code, _, err) = outcome(&["list", &traffic, "--paper", "a4"]);
    assert_eq!(code, 2);
    assert!(err.contains("--svg"), "{err}");
    let (code, _, err) = outcome(&["list", &traffic, "--svg", &out, "--paper", "a5"]);
    assert_eq!(code, 2);
    assert!(err.contains("a4") && err.contains("letter"), "{err}");
}

fn folder_of(program: &str) -> String {
    let programs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../programs");
    programs.join(program).to_str().unwrap().to_owned()
}

#[test]
fn control_characters_of_a_comment_do_not_break_a_picture() {
    let program = program("c.il", "(* a\u{7}b\u{1b} *)\nLD I1\nST Q1\n").unwrap();
    for svg in pages(&program, 80, Paper::A4, Some("x\u{1}y"), Lang::En) {
        assert!(Document::parse(&svg).is_ok(), "{svg}");
    }
    assert!(Document::parse(&unoclp_program::list::svg(&program, 80, Lang::En)).is_ok());
}
