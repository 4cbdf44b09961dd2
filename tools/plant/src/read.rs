//! From the text of a file to a plant.

use crate::fields::{Names, quoted};
use crate::keys::{Amiss, At, Keys, both, number, pair, place_of, quantity, time, whole};
use crate::kind::{Fault, Form, Kind};
use crate::mistake::{Mistake, Wrong};
use crate::names::names;
use crate::order::order;
use crate::parts::{KINDS, named};
use crate::plant::{Decoration, Part, Plant, Step, Trouble};
use crate::rules::{Goal, Never};
use crate::sentence;
use crate::text::Text;
use crate::unit::Unit;
use std::collections::BTreeMap;
use std::ops::Range;
use unoclp_core::Board;
use unoclp_keyed::keyed;
use unoclp_lang::typed::Base;
use unoclp_lang::{Condition, condition, is_name};

/// A plant has no more parts.
pub const MOST_PARTS: usize = 100;
/// Nor more rules, steps, faults and drawn lines, of each.
const MOST_OTHERS: usize = 200;
/// A script goes on for a day at most.
const DAY: i64 = 86_400_000;

const FILE: [&str; 11] = [
    "title", "about", "board", "until", "seed", "part", "draw", "step", "fault", "never", "goal",
];

/// Reads the text of a plant's file; it is wired to this board, unless it names another.
///
/// # Errors
/// All that is wrong with it, in the order of the lines.
pub fn read(text: &str, board: Board) -> Result<Plant, Vec<Mistake>> {
    let plant = keyed(text, |keys| {
        keys.known(&FILE);
        plant(keys, board)
    })?;
    // Without a plant there was a mistake.
    plant.ok_or_else(Vec::new)
}

/// The tables of a key, of which there are not too many.
fn some<'a>(
    keys: &Keys<'a>,
    key: &'static str,
    example: &'static str,
    most: usize,
) -> Vec<Keys<'a>> {
    let mut tables = keys.tables(key, example).unwrap_or_default();
    if let Some(first) = tables.get(most) {
        keys.notes.wrong(&first.place, Wrong::TooMany { key, most });
        tables.truncate(most);
    }
    tables
}

/// The plant as far as its parts are right; none where they are not, which is told.
fn plant(keys: &Keys<'_>, usual: Board) -> Option<Plant> {
    let title = both(keys, "title");
    if !keys.has("title") {
        keys.missing("title", "{ en = \"Press\", pt = \"Prensa\" }");
    }
    let title = title.map_or_else(Text::default, |at| at.value);
    let about = both(keys, "about").map_or_else(Text::default, |at| at.value);
    let board = board(keys, usual);
    let until = time(keys, "until", 1, DAY).map_or(60_000, |at| at.value);
    let seed = number(keys, "seed", 0, i64::from(i32::MAX)).map_or(1, |at| at.value);
    let tables = some(
        keys,
        "part",
        "[{ name = \"k1\", kind = \"contactor\" }]",
        MOST_PARTS,
    );
    if tables.is_empty() && !keys.has("part") {
        keys.notes.wrong(&(0..0), Wrong::NoPart);
        return None;
    }
    let heads: Vec<_> = tables.iter().map(head).collect();
    let names_of = Names {
        board,
        known: heads.iter().flatten().cloned().collect(),
        notes: keys.notes,
        taken: Default::default(),
    };
    let mut seen: BTreeMap<String, ()> = BTreeMap::new();
    for (head, table) in heads.iter().zip(&tables) {
        let Some((name, _)) = head else { continue };
        if seen.insert(name.to_uppercase(), ()).is_some() {
            let name = name.clone();
            keys.notes.wrong(&table.place, Wrong::TwoNames { name });
        }
    }
    if !heads.iter().all(Option::is_some) {
        // What others say of the missing ones would be told in vain.
        return None;
    }
    let mut cells = 0;
    let pairs = names_of.known.iter().zip(&tables);
    let parts: Vec<Part> = pairs
        .map(|((name, kind), table)| part(name, kind, table, &names_of, &mut cells))
        .collect();
    let places: Vec<Range<usize>> = tables.iter().map(|table| table.place.clone()).collect();
    let place = |number: usize| places.get(number).cloned().unwrap_or(0..0);
    names_of.check_outputs(&parts, place);
    let order = match order(&parts) {
        Ok(order) => order,
        Err(circle) => {
            let name = |number: &usize| parts.get(*number).map_or("", |part| part.name.as_str());
            let way: Vec<&str> = circle.iter().chain(circle.first()).map(name).collect();
            let way = way.join(" → ");
            keys.notes.wrong(
                &place(circle.first().copied().unwrap_or(0)),
                Wrong::Cycle { way },
            );
            return None;
        }
    };
    let mut plant = Plant {
        title,
        about,
        board,
        until,
        seed: seed.unsigned_abs(),
        parts,
        order,
        nevers: Vec::new(),
        goals: Vec::new(),
        steps: Vec::new(),
        troubles: Vec::new(),
        decorations: Vec::new(),
        cells,
        places: Vec::new(),
    };
    let (known, at) = names(&plant);
    plant.places = at;
    let conditions = Conditions { known, board };
    plant.nevers = nevers(keys, &conditions, &plant);
    plant.goals = goals(keys, &conditions, &plant);
    plant.troubles = troubles(keys, &names_of, &conditions);
    plant.steps = steps(keys, &names_of, &plant);
    plant.decorations = decorations(keys, &names_of);
    Some(plant)
}

fn board(keys: &Keys<'_>, usual: Board) -> Board {
    let Some(At { value, place }) = keys.text("board", "\"uno\"") else {
        return usual;
    };
    Board::named(&value).unwrap_or_else(|| {
        let ids: Vec<&str> = Board::ALL.iter().map(Board::id).collect();
        let wrong = Amiss::Choice {
            key: "board".to_owned(),
            given: format!("{value:?}"),
            known: quoted(&ids),
        };
        keys.notes.wrong(&place, wrong);
        usual
    })
}

/// The name and the kind of a part; none where one is wrong, which is told.
fn head(keys: &Keys<'_>) -> Option<(String, &'static Kind)> {
    let name = keys.needed("name", "\"k1\"");
    let kind = keys.needed("kind", "\"contactor\"");
    let name = name.and_then(|At { value, place }| {
        let right = is_name(&value) && value.len() <= 24 && !value.eq_ignore_ascii_case("clock");
        let is_point = unoclp_point::Address::parse(&value).is_some_and(|point| {
            matches!(
                point,
                unoclp_point::Address::Input(_) | unoclp_point::Address::Output(_)
            )
        });
        if right && !is_point {
            return Some(value);
        }
        let given: String = format!("{value:?}").chars().take(40).collect();
        keys.notes.wrong(&place, Wrong::Name { given });
        None
    });
    let kind = kind.and_then(|At { value, place }| {
        let kind = named(&value);
        if kind.is_none() {
            let kinds: Vec<&str> = KINDS.iter().map(|kind| kind.name).collect();
            let wrong = Amiss::Choice {
                key: "kind".to_owned(),
                given: format!("{value:?}"),
                known: quoted(&kinds),
            };
            keys.notes.wrong(&place, wrong);
        }
        kind
    });
    Some((name?, kind?))
}

fn part(
    name: &str,
    kind: &'static Kind,
    keys: &Keys<'_>,
    names: &Names<'_>,
    cells: &mut usize,
) -> Part {
    let own = kind.fields.iter().map(|field| field.name);
    let known: Vec<&str> = ["name", "kind", "label", "at"]
        .into_iter()
        .chain(own)
        .collect();
    keys.known(&known);
    let label = both(keys, "label");
    let mut part = Part {
        kind,
        name: name.to_owned(),
        label: label.map_or_else(|| Text::same(name), |at| at.value),
        at: place_of(keys, "at").map(|at| at.value),
        given: names.given(kind, name, keys),
        ranges: Vec::new(),
        cells: Vec::new(),
        contacts: Vec::new(),
        faults: 0,
    };
    let mut take = |count: usize| {
        let first = *cells;
        *cells += count;
        first
    };
    part.cells = kind.values.iter().map(|slot| take(slot.count)).collect();
    part.contacts = kind
        .fields
        .iter()
        .map(|field| {
            if matches!(field.form, Form::Sense) {
                take(1)
            } else {
                usize::MAX
            }
        })
        .collect();
    part.faults = take(1);
    part.ranges = kind
        .values
        .iter()
        .map(|slot| (part.limit(slot.low), part.limit(slot.high)))
        .collect();
    part
}

/// What a condition may read.
struct Conditions {
    known: Vec<(String, Base)>,
    board: Board,
}

impl Conditions {
    /// The condition of a key, if it is there.
    fn of(&self, keys: &Keys<'_>, key: &'static str) -> Option<Condition> {
        let At { value, place } = keys.text(key, "\"tank.level > 950\"")?;
        if value.len() > 1000 {
            let (from, to) = ("1".to_owned(), "1000".to_owned());
            let key = key.to_owned();
            keys.notes.wrong(&place, Wrong::Range { key, from, to });
            return None;
        }
        match condition(&value, &self.known, self.board) {
            Ok(condition) => Some(condition),
            Err(told) => {
                let told = told.first().cloned().map(Box::new);
                keys.notes.wrong(&place, Wrong::NoCondition { told });
                None
            }
        }
    }

    /// The same of a key that must be there.
    fn needed(&self, keys: &Keys<'_>, key: &'static str) -> Option<Condition> {
        if !keys.has(key) {
            keys.missing(key, "\"tank.level > 950\"");
        }
        self.of(keys, key)
    }
}

/// A condition as it is written.
fn written<'a>(keys: &Keys<'a>, key: &str) -> Option<&'a str> {
    keys.value(key).and_then(|value| value.get_ref().as_str())
}

/// What a rule says; its condition as a sentence, where it says nothing else.
fn rule_text(keys: &Keys<'_>, sentence: impl FnOnce(&str) -> Text) -> Text {
    let text = both(keys, "text").map(|at| at.value);
    text.unwrap_or_else(|| sentence(written(keys, "when").unwrap_or_default()))
}

fn nevers(keys: &Keys<'_>, conditions: &Conditions, plant: &Plant) -> Vec<Never> {
    let tables = some(
        keys,
        "never",
        "[{ when = \"tank.level > 950\" }]",
        MOST_OTHERS,
    );
    let never = |keys: &Keys<'_>| {
        keys.known(&["when", "text", "after", "for"]);
        let after = time(keys, "after", 0, DAY).map_or(0, |at| at.value);
        let lasts = time(keys, "for", 0, DAY).map_or(0, |at| at.value);
        let when = conditions.needed(keys, "when")?;
        Some(Never {
            text: rule_text(keys, |when| sentence::never(when, after, lasts, plant)),
            when,
            after,
            lasts,
        })
    };
    tables.iter().filter_map(never).collect()
}

fn goals(keys: &Keys<'_>, conditions: &Conditions, plant: &Plant) -> Vec<Goal> {
    let tables = some(
        keys,
        "goal",
        "[{ when = \"bin.count >= 20\" }]",
        MOST_OTHERS,
    );
    let goal = |keys: &Keys<'_>| {
        keys.known(&["when", "text", "each", "within"]);
        let each = conditions.of(keys, "each");
        if !keys.has("within") {
            keys.missing("within", "\"30 s\"");
        }
        let within = time(keys, "within", 1, DAY)?.value;
        let when = conditions.needed(keys, "when")?;
        let each_time = written(keys, "each");
        Some(Goal {
            text: rule_text(keys, |when| sentence::goal(when, each_time, within, plant)),
            when,
            each,
            within,
        })
    };
    tables.iter().filter_map(goal).collect()
}

fn troubles(keys: &Keys<'_>, names: &Names<'_>, conditions: &Conditions) -> Vec<Trouble> {
    let tables = some(
        keys,
        "fault",
        "[{ part = \"k1\", is = \"welded\" }]",
        MOST_OTHERS,
    );
    let trouble = |keys: &Keys<'_>| {
        keys.known(&["part", "is", "at", "when", "for"]);
        let at = time(keys, "at", 0, DAY).map(|at| at.value);
        let when = conditions.of(keys, "when");
        let lasts = time(keys, "for", 1, DAY).map_or(0, |at| at.value);
        if !keys.has("at") && !keys.has("when") {
            keys.notes.wrong(&keys.place, Wrong::NeverComes);
        }
        let part = keys.needed("part", "\"k1\"");
        let is = keys.needed("is", "\"welded\"");
        let part = part.and_then(|At { value, place }| names.part(&value, &place))?;
        let (_, kind) = names.known.get(part)?;
        let At { value, place } = is?;
        let fault = Fault::named(&value).filter(|fault| kind.faults.contains(fault));
        if fault.is_none() {
            let known: Vec<&str> = kind.faults.iter().map(|fault| fault.name()).collect();
            let wrong = Wrong::NoFault {
                kind: kind.name,
                given: format!("{value:?}"),
                known: quoted(&known),
            };
            keys.notes.wrong(&place, wrong);
        }
        Some(Trouble {
            part,
            fault: fault?,
            at,
            when,
            lasts,
        })
    };
    tables.iter().filter_map(trouble).collect()
}

fn steps(keys: &Keys<'_>, names: &Names<'_>, plant: &Plant) -> Vec<Step> {
    let tables = some(
        keys,
        "step",
        "[{ at = \"1 s\", set = { start = 1 } }]",
        MOST_OTHERS,
    );
    let mut steps: Vec<Step> = Vec::new();
    for table in &tables {
        table.known(&["at", "set", "for"]);
        if !table.has("at") {
            table.missing("at", "\"1 s\"");
        }
        let at = time(table, "at", 0, DAY);
        let lasts = time(table, "for", 1, DAY);
        if let Some(late) = at.as_ref().filter(|at| at.value > plant.until) {
            let until = Unit::Ms.shown(plant.until as i64);
            let key = "at";
            keys.notes.wrong(&late.place, Wrong::TooLate { key, until });
        }
        let example = "{ start = 1 }";
        if !table.has("set") {
            table.missing("set", example);
        }
        let Some(set) = table.table("set", example) else {
            continue;
        };
        let mut settings = Vec::new();
        for (path, value) in set.each() {
            let Some((part, slot)) = by_hand(&path, names, plant) else {
                continue;
            };
            let Some(own) = plant.parts.get(part) else {
                continue;
            };
            let (low, high) = own.range(slot);
            let unit = own
                .kind
                .values
                .get(slot)
                .map_or(Unit::Count, |slot| slot.unit);
            let unit = if value.get_ref().as_str().is_some() {
                unit
            } else {
                Unit::Count
            };
            let number = whole(value.get_ref());
            let number = match number {
                Some(number) if (i64::from(low)..=i64::from(high)).contains(&number) => {
                    Some(number as i32)
                }
                _ => quantity(
                    keys.notes,
                    &path.value,
                    value,
                    unit,
                    low.into(),
                    high.into(),
                ),
            };
            settings.extend(number.map(|number| (part, slot, number)));
        }
        let Some(at) = at else { continue };
        if let Some(lasts) = lasts {
            let back = |(part, slot, _): &(usize, usize, i32)| {
                let own = plant.parts.get(*part);
                let first = own.and_then(|own| Some(own.limit(own.kind.values.get(*slot)?.first)));
                (*part, *slot, first.unwrap_or(0))
            };
            let set = settings.iter().map(back).collect();
            let at = at.value + lasts.value;
            steps.push(Step { at, set });
        }
        let (at, set) = (at.value, settings);
        steps.push(Step { at, set });
    }
    steps.sort_by_key(|step| step.at);
    steps
}

/// The value that a step of the script changes.
fn by_hand(path: &At<String>, names: &Names<'_>, plant: &Plant) -> Option<(usize, usize)> {
    let At { value, place } = path;
    let (name, _) = value.split_once('.').unwrap_or((value, ""));
    let part = names.part(name, place)?;
    let kind = plant.parts.get(part)?.kind;
    let found = match value.contains('.') {
        true => names.value(value, place)?.1,
        false => kind
            .values
            .iter()
            .position(|slot| slot.by_hand)
            .unwrap_or(usize::MAX),
    };
    if kind.values.get(found).is_some_and(|slot| slot.by_hand) {
        return Some((part, found));
    }
    let all = plant.parts.iter().flat_map(|part| {
        let own = part.kind.values.iter().filter(|slot| slot.by_hand);
        own.map(move |slot| format!("{}.{}", part.name, slot.name))
    });
    let wrong = Wrong::NotByHand {
        path: value.clone(),
        known: all.take(30).collect::<Vec<_>>().join(", "),
    };
    names.notes.wrong(place, wrong);
    None
}

/// What may be drawn beside the parts.
const DRAWN: [&str; 5] = ["pipe", "wire", "floor", "frame", "text"];

fn decorations(keys: &Keys<'_>, names: &Names<'_>) -> Vec<Decoration> {
    let tables = some(
        keys,
        "draw",
        "[{ kind = \"pipe\", points = [[0, 0], [40, 0]] }]",
        MOST_OTHERS,
    );
    let decoration = |keys: &Keys<'_>| {
        keys.known(&["kind", "points", "carries", "text"]);
        let text = both(keys, "text").map_or_else(Text::default, |at| at.value);
        let carries = keys.text("carries", "\"valve.flow\"");
        let carries = carries.and_then(|At { value, place }| names.value(&value, &place));
        let example = "[[0, 0], [40, 0]]";
        if !keys.has("points") {
            keys.missing("points", example);
        }
        let points = keys.take("points", example, |value| {
            let array = value.as_array()?;
            let points = array.iter().map(|value| pair(value.get_ref()));
            points
                .collect::<Option<Vec<_>>>()
                .filter(|all| (1..=50).contains(&all.len()))
        });
        let At { value, place } = keys.needed("kind", "\"pipe\"")?;
        let kind = DRAWN.into_iter().find(|kind| *kind == value);
        if kind.is_none() {
            let wrong = Amiss::Choice {
                key: "kind".to_owned(),
                given: format!("{value:?}"),
                known: quoted(&DRAWN),
            };
            keys.notes.wrong(&place, wrong);
        }
        Some(Decoration {
            kind: kind?,
            points: points?.value,
            carries,
            text,
        })
    };
    tables.iter().filter_map(decoration).collect()
}
