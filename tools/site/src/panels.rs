//! The tables `panel` of a site file, and the files that they name.

use crate::alarm::Text;
use crate::files::Files;
use crate::keys::{Amiss, At, Keys, number};
use crate::made::{grant, made_for};
use crate::mistake::{Mistake, Wrong};
use crate::panel::{Bind, Does, Item, Look, Panel, plain};
use crate::points::Point;
use crate::site::{Board, Line};
use unoclp_keyed::{DeValue, keyed};

const EXAMPLE: &str = "[{ file = \"estufa.panel.toml\" }]";
const FILE: &str = "\"estufa.panel.toml\"";
const POINT: &str = "\"estufa.target\"";
const ITEMS: &str = "[{ show = \"lamp\", point = \"estufa.fan\" }]";
const BINDS: &str = "[{ id = \"tank\", point = \"estufa.target\", does = \"level\" }]";
const LABEL: &str = "{ en = \"Fan\", pt = \"Ventilador\" }";
/// The longest label, characters.
const LONGEST: usize = 60;
/// The longest file of a panel or a drawing, bytes.
const LARGEST: usize = 256 << 10;
/// As many names as are listed to somebody who looks for one.
const LISTED: usize = 12;

/// The panels of the site: those of files, as far as they are right, and those that boards have without one.
pub(crate) fn panels(keys: &Keys<'_>, lines: &[Line], files: &dyn Files) -> Vec<Panel> {
    let tables = keys.tables("panel", EXAMPLE).unwrap_or_default();
    let mut panels: Vec<Panel> = Vec::new();
    for table in &tables {
        table.known(&["file"]);
        let Some(At { value, place }) = table.needed("file", FILE) else {
            continue;
        };
        match panel(&value, lines, files) {
            Ok(panel) if panels.iter().any(|other| other.name == panel.name) => {
                let name = panel.name;
                table.notes.wrong(&place, Wrong::TwoPanels { name });
            }
            Ok(panel) => panels.push(panel),
            Err(wrong) => {
                for wrong in wrong {
                    table.notes.wrong(&place, wrong);
                }
            }
        }
    }
    let made = made_for(lines, &panels);
    panels.extend(made);
    panels
}

/// The panel of a file.
fn panel(file: &str, lines: &[Line], files: &dyn Files) -> Result<Panel, Vec<Wrong>> {
    let text = text_of(file, files).map_err(|wrong| vec![wrong])?;
    let within = |Mistake { line, wrong }| Wrong::InPanel {
        file: file.to_owned(),
        line,
        wrong: Box::new(wrong),
    };
    let read = keyed(&text, |keys: &Keys<'_>| sheet(file, keys, lines, files));
    read.map_err(|wrong| wrong.into_iter().map(within).collect())
}

fn text_of(file: &str, files: &dyn Files) -> Result<String, Wrong> {
    let bytes = files.bytes(file).map_err(|why| Wrong::NoPanel {
        file: file.to_owned(),
        why,
    })?;
    let is_long = bytes.len() > LARGEST;
    let text = String::from_utf8(bytes).ok().filter(|_| !is_long);
    text.ok_or_else(|| Wrong::NoTextFile {
        file: file.to_owned(),
    })
}

fn sheet(file: &str, keys: &Keys<'_>, lines: &[Line], files: &dyn Files) -> Panel {
    keys.known(&["title", "columns", "drawing", "item", "bind"]);
    let boards: Vec<&Board> = lines.iter().flat_map(|line| &line.boards).collect();
    let name = called(file);
    let title = keys.has("title").then(|| text(keys, "title"));
    let columns = number(keys, "columns", "4", 1..13).map_or(4, |columns| columns.value);
    let drawing = keys.text("drawing", "\"estufa.svg\"").and_then(|of| {
        let read = text_of(&of.value, files);
        read.map_err(|wrong| keys.notes.wrong(&of.place, wrong))
            .ok()
    });
    let items = keys.tables("item", ITEMS).unwrap_or_default();
    let items = items
        .iter()
        .filter_map(|table| item(table, &boards, columns));
    let items = items.collect();
    let binds = keys.tables("bind", BINDS).unwrap_or_default();
    if let Some(first) = binds.first().filter(|_| !keys.has("drawing")) {
        first.missing("drawing", "\"estufa.svg\"");
    }
    let binds = binds.iter().filter_map(|table| bind(table, &boards));
    Panel {
        title: title.flatten().unwrap_or_else(|| plain(&name)),
        binds: binds.collect(),
        name,
        columns,
        drawing,
        items,
        is_made: false,
    }
}

/// What a file's panel is called: the file, without its folder and all that follows the first dot.
fn called(file: &str) -> String {
    let name = file.rsplit(['/', '\\']).next().unwrap_or(file);
    name.split('.').next().unwrap_or(name).to_owned()
}

fn item(table: &Keys<'_>, boards: &[&Board], columns: u8) -> Option<Item> {
    table.known(&[
        "show", "point", "label", "unit", "least", "most", "at", "size",
    ]);
    let words = Look::ALL.map(Look::word);
    let look = choice(table, "show", "\"lamp\"", &words).and_then(|at| Look::ALL.get(at).copied());
    let found = point(table, boards);
    let label = table.has("label").then(|| text(table, "label")).flatten();
    let unit = table.text("unit", "\"°C\"").map(|unit| unit.value);
    let range = range(table);
    let at = pair(table, "at", "[1, 1]", columns);
    let size = pair(table, "size", "[1, 1]", columns);
    let (look, (board, point, is_named)) = (look?, found?);
    let grant = grant(board, &point, is_named).filter(|_| look.writes());
    if look.writes() && grant.is_none() {
        let place = table.at("point").unwrap_or(table.place.clone());
        let wrong = Wrong::ReadOnly {
            point: point.name.clone(),
            known: listed(board.points.named.iter().filter(|of| !of.write.is_empty())),
        };
        table.notes.wrong(&place, wrong);
    }
    Some(Item {
        look,
        board: board.name.clone(),
        label: label.unwrap_or_else(|| plain(&point.name)),
        point: point.name,
        unit: unit.unwrap_or_default(),
        range,
        at,
        size: size.unwrap_or(look.size()),
        grant,
    })
}

fn bind(table: &Keys<'_>, boards: &[&Board]) -> Option<Bind> {
    table.known(&["id", "point", "does", "least", "most"]);
    let id = table.needed("id", "\"tank\"");
    let words = Does::ALL.map(Does::word);
    let does = choice(table, "does", "\"light\"", &words).and_then(|at| Does::ALL.get(at).copied());
    let found = point(table, boards);
    let range = range(table);
    let (board, point, _) = found?;
    Some(Bind {
        id: id?.value,
        board: board.name.clone(),
        point: point.name,
        does: does?,
        range,
    })
}

/// Which of these words a key has, which must be there.
fn choice(
    table: &Keys<'_>,
    key: &'static str,
    example: &'static str,
    words: &[&str],
) -> Option<usize> {
    let At { value, place } = table.needed(key, example)?;
    let found = words.iter().position(|word| *word == value);
    if found.is_none() {
        let known: Vec<String> = words.iter().map(|word| format!("\"{word}\"")).collect();
        let wrong = Amiss::Choice {
            key: key.to_owned(),
            given: value,
            known: known.join(", "),
        };
        table.notes.wrong(&place, wrong);
    }
    found
}

/// The point of a table, its board, and whether the board's program names it.
fn point<'b>(table: &Keys<'_>, boards: &[&'b Board]) -> Option<(&'b Board, Point, bool)> {
    let At { value, place } = table.needed("point", POINT)?;
    let wrong = |wrong| {
        table.notes.wrong(&place, wrong);
        None
    };
    let Some((of_board, of_point)) = value.split_once('.') else {
        return wrong(Wrong::NoPath { given: value });
    };
    let is = |board: &&&Board| board.name.eq_ignore_ascii_case(of_board);
    let Some(board) = boards.iter().find(is) else {
        let names: Vec<_> = boards.iter().map(|board| &*board.name).collect();
        return wrong(Wrong::NoSuchBoard {
            name: of_board.to_owned(),
            known: names.join(", "),
        });
    };
    let recorded = board.points.recorded(true);
    let is = |point: &&Point| point.name.eq_ignore_ascii_case(of_point);
    match recorded.iter().find(is) {
        Some(point) => Some((board, point.clone(), board.points.named(of_point).is_some())),
        None => wrong(Wrong::NotRecorded {
            board: board.name.clone(),
            point: of_point.to_owned(),
            known: listed(recorded.iter()),
        }),
    }
}

fn listed<'p>(points: impl Iterator<Item = &'p Point>) -> String {
    let names: Vec<&str> = points.map(|point| &*point.name).take(LISTED).collect();
    names.join(", ")
}

/// The least value and the most; from 0 to 100 unless the file says otherwise.
fn range(table: &Keys<'_>) -> [f64; 2] {
    let of = |key, usual| table.take(key, "100", real).map_or(usual, |of| of.value);
    let (least, most) = (of("least", 0.0), of("most", 100.0));
    if least < most {
        return [least, most];
    }
    let place = table.at("most").or(table.at("least"));
    let place = place.unwrap_or(table.place.clone());
    table.notes.wrong(&place, Wrong::NoRange);
    [0.0, 100.0]
}

fn real(value: &DeValue<'_>) -> Option<f64> {
    let whole = value.as_integer().map(|number| number.as_str().parse());
    let number = whole.or_else(|| value.as_float().map(|number| number.as_str().parse()));
    number?.ok().filter(|number: &f64| number.is_finite())
}

/// Two numbers: of columns, and of rows.
fn pair(
    table: &Keys<'_>,
    key: &'static str,
    example: &'static str,
    columns: u8,
) -> Option<[u8; 2]> {
    let two = |value: &DeValue<'_>| {
        let numbers = value.as_array()?.iter().map(|of| {
            let number = of.get_ref().as_integer()?;
            number.as_str().parse::<u8>().ok()
        });
        let numbers: Option<Vec<u8>> = numbers.collect();
        <[u8; 2]>::try_from(numbers?).ok()
    };
    let At { value, place } = table.take(key, example, two)?;
    let [column, row] = value;
    if (1..=columns).contains(&column) && (1..=100).contains(&row) {
        return Some(value);
    }
    let (from, to) = (1, columns.into());
    table.notes.wrong(&place, Wrong::Range { key, from, to });
    None
}

/// The text of a key, in both languages or in one for both.
fn text(table: &Keys<'_>, key: &'static str) -> Option<Text> {
    let of = match table.is_table(key) {
        true => {
            let of = table.table(key, LABEL)?;
            of.known(&["en", "pt"]);
            let (en, pt) = (
                of.needed("en", "\"Fan\""),
                of.needed("pt", "\"Ventilador\""),
            );
            Text {
                en: en?.value,
                pt: pt?.value,
            }
        }
        false => plain(&table.text(key, LABEL)?.value),
    };
    let is_long = |text: &str| text.chars().count() > LONGEST;
    if is_long(&of.en) || is_long(&of.pt) {
        let place = table.at(key).unwrap_or(table.place.clone());
        table
            .notes
            .wrong(&place, Wrong::LongLabel { most: LONGEST });
        return None;
    }
    Some(of)
}
