//! What an element has that can be changed, as a form has it.

use crate::{Amiss, Offer, words};
use serde::Serialize;
use std::collections::BTreeSet;
use unoclp_core::Board;
use unoclp_core::isa::{Class, Kind, Opcode, POPPED, RETENTIVE};
use unoclp_draw::edit::{
    Cursor, Document, Draft, Element, Node, Operation, Row, Step, Table, visit,
};
use unoclp_lang::{Diagnostic, Lang, duration, no_such_point};
use unoclp_point::Address;
use unoclp_program::drawn::is_name;
use unoclp_words::{Both, both};

/// A field with what is in it.
#[derive(Debug, Serialize)]
pub struct Shown {
    /// Which.
    pub key: String,
    /// What a person calls it.
    pub name: Both,
    /// What stands there.
    pub value: String,
    /// `point`: an address or a name; `value`: that or a number; `number`; `name`.
    pub kind: &'static str,
}

/// A field that a person has filled in.
pub struct Field {
    /// Which.
    pub key: String,
    /// What stands there, without blanks around it.
    pub value: String,
}

/// The fields of an element.
pub fn shown(document: &Document, element: &Element) -> Vec<Shown> {
    let table = document.table();
    let mut fields = Vec::new();
    let mut show = |key: &str, name: Both, value: String, kind| {
        let key = key.to_owned();
        fields.push(Shown {
            key,
            name,
            value,
            kind,
        });
    };
    let Element { load, step, .. } = element;
    if step.class() == Class::Comparison {
        let left = load.as_ref().map_or_else(String::new, source);
        show("left", both(words::left), left, "value");
    }
    let kind = step.opcode().row().kind;
    let point = point(step);
    if kind.is_value() {
        show("operand", both(words::operand), source(step), "value");
    } else if has_point(kind) {
        let name = match kind {
            Kind::Timer => both(words::drives),
            _ => both(words::point),
        };
        show("point", name, text(point), "point");
    } else if kind.has_number() {
        show(
            "number",
            both(words::number),
            spelled(step.number().map(i32::from)),
            "number",
        );
    }
    let named = point.filter(|point| !matches!(point, Address::Label(_)));
    if has_point(kind) && !matches!(kind, Kind::Label | Kind::Jump) {
        let row = named.and_then(|point| table.get(point));
        let name = row.map_or_else(String::new, |row| row.name.clone());
        show("name", both(words::name), name, "name");
    }
    let lines = step.lines().iter().enumerate();
    for (index, &line) in lines.filter(|(index, _)| !(kind == Kind::Timer && *index == 1)) {
        if kind.is_value() {
            continue;
        }
        let name = match kind {
            Kind::Timer => both(words::preset_ms),
            Kind::Count => both(words::preset),
            _ => both(|lang| words::operand_line(lang, index + 1)),
        };
        show(&format!("line{index}"), name, spelled(line), "number");
    }
    fields
}

/// The operations that fill in the fields of what is selected.
///
/// # Errors
/// What is wrong with a field.
pub fn operations(
    (document, board): (&Document, Board),
    cursor: Cursor,
    fields: Vec<Field>,
    sure: bool,
) -> Result<Vec<Operation>, Amiss> {
    let element = document
        .element(cursor.from)
        .filter(|_| cursor.from == cursor.to);
    let Some(Element { load, step, .. }) = element else {
        return Err(both(words::select_one).into());
    };
    let table = document.table();
    let (mut load, mut step) = (load.clone(), step.clone());
    let mut called: Option<String> = None;
    let mut also: Option<String> = None;
    for Field { key, value } in fields {
        let at = |no: Amiss| no.at(&key, Vec::new());
        match key.as_str() {
            "left" if value.is_empty() => load = None,
            "left" => load = Some(loaded((table, board), &value).map_err(at)?),
            "operand" => step = valued((table, board), &step, &value).map_err(at)?,
            "point" => {
                let (point, name) = pointed((table, board), &value)
                    .map_err(|no| no.at(&key, named_offers((document, board), &step, &value)))?;
                also = name;
                if point != self::point(&step) {
                    meant((document, board), &step, point, &value, sure)?;
                }
                step = step
                    .with_address(point)
                    .map_err(|refusal| at(refusal.into()))?;
            }
            "name" => called = Some(value),
            "number" => step = step.with_number(number::<u8>(&value).map_err(at)?),
            _ => {
                let index = key
                    .strip_prefix("line")
                    .and_then(|index| index.parse().ok());
                let index: usize = index.ok_or_else(|| no_field(&key))?;
                let is_time = index == 0 && step.opcode().row().kind == Kind::Timer;
                let number = match is_time {
                    true => time(&value),
                    false => number::<i32>(&value),
                };
                let mut lines = step.lines().to_vec();
                *lines.get_mut(index).ok_or_else(|| no_field(&key))? = number.map_err(at)?;
                step = step.with_lines(lines);
            }
        }
    }
    let mut operations = Vec::new();
    if let Some(point) = point(&step) {
        let row = table.get(point).cloned().unwrap_or_default();
        let before = element.and_then(|element| self::point(&element.step)) == Some(point);
        let also_named = also.is_some();
        // Another point has a name of its own: the one in the form was that of the point before.
        let name = also
            .or(called
                .filter(|name| before || (row.name.is_empty() && table.point(name).is_none())));
        if let Some(name) = name.filter(|name| *name != row.name) {
            let field = if also_named { "point" } else { "name" };
            let naming = naming(document, point, Row { name, ..row });
            operations.push(naming.map_err(|no| no.at(field, Vec::new()))?);
        }
    }
    operations.push(Operation::Replace(Draft { load, step }));
    Ok(operations)
}

/// The operation that names a point.
///
/// # Errors
/// Where that is no name.
pub fn naming(document: &Document, point: Address, row: Row) -> Result<Operation, Amiss> {
    let is_same = document
        .table()
        .get(point)
        .is_some_and(|old| old.name == row.name);
    if !row.name.is_empty() && !is_same && !is_name(&row.name) {
        return Err(both(|lang| words::no_name(lang, &row.name)).into());
    }
    let comment = row.comment.split_whitespace().collect::<Vec<_>>().join(" ");
    Ok(Operation::Name(point, Row { comment, ..row }))
}

/// Asks about a system marker that nothing of the drawing has to do with yet: `S1` is what many call a button.
///
/// # Errors
/// The question.
pub fn ask((document, board): (&Document, Board), point: Address, sure: bool) -> Result<(), Amiss> {
    let is_new = || !used(document).contains(&point) && document.table().get(point).is_none();
    match point {
        Address::System(number) if !sure && is_new() => {
            let name = point.to_string();
            let free = free((document, board), Address::Input);
            // The letter alone is an address, and so no name.
            let button = free.map(|input| offer(format!("{input} S_{number}")));
            let marker = Offer {
                say: both(|lang| words::is_system_marker(lang, &name)),
                value: name.clone(),
                sure: true,
            };
            let told = Amiss::from(both(|lang| words::system_marker(lang, &name)));
            Err(told.at("point", button.into_iter().chain([marker]).collect()))
        }
        _ => Ok(()),
    }
}

/// Whether an element can mean this point.
fn meant(
    (document, board): (&Document, Board),
    step: &Step,
    point: Option<Address>,
    value: &str,
    sure: bool,
) -> Result<(), Amiss> {
    match point {
        Some(calls @ Address::Timer(_))
            if step.opcode().row().kind == Kind::Timer && step.target() != calls.target() =>
        {
            let kinds = [Address::Marker as fn(u8) -> Address, Address::Output];
            let points = kinds
                .into_iter()
                .filter_map(|kind| free((document, board), kind));
            let offers = points.map(|point| offer(point.to_string()));
            let told = Amiss::from(both(|lang| words::timer_drives(lang, value)));
            Err(told.at("point", offers.collect()))
        }
        Some(point) => ask((document, board), point, sure),
        None => Ok(()),
    }
}

/// Free points for a name that no point has yet.
fn named_offers((document, board): (&Document, Board), step: &Step, name: &str) -> Vec<Offer> {
    let kinds: &[fn(u8) -> Address] = match (step.class(), step.opcode().row().kind) {
        (Class::Contact | Class::Xor, _) => &[Address::Input, Address::Marker],
        (Class::Count, _) => &[Address::Counter],
        // It is for a timer or a counter that is there.
        (Class::Coil, Kind::TimerQ | Kind::Counter) => &[],
        (Class::Coil | Class::Timer, _) => &[Address::Output, Address::Marker],
        _ => &[],
    };
    if !is_name(name) {
        return Vec::new();
    }
    let points = kinds
        .iter()
        .filter_map(|kind| free((document, board), kind));
    let offers = points.map(|point| offer(format!("{point} {name}")));
    offers.collect()
}

fn offer(value: String) -> Offer {
    Offer {
        say: both(|lang| words::free_point(lang, &value)),
        value,
        sure: false,
    }
}

/// The first point of a kind that has no name, and that nothing reads or drives.
fn free((document, board): (&Document, Board), kind: impl Fn(u8) -> Address) -> Option<Address> {
    let used = used(document);
    let most = match kind(1) {
        Address::Input(_) => board.inputs,
        Address::Output(_) => board.outputs,
        Address::Counter(_) => board.counters,
        // The last of them are retentive.
        _ => RETENTIVE - 1,
    };
    let is_free = |point: &Address| !used.contains(point) && document.table().get(*point).is_none();
    (1..=most).map(kind).find(is_free)
}

/// The points that elements name.
fn used(document: &Document) -> BTreeSet<Address> {
    let mut used = BTreeSet::new();
    for rung in document.rungs() {
        visit(&rung.series, &mut |node| {
            if let Node::Element(element) = node {
                used.extend(point(&element.step));
                used.extend(element.load.as_ref().and_then(point));
            }
        });
    }
    used
}

/// The point that a step names; of a timer what it drives.
fn point(step: &Step) -> Option<Address> {
    let kind = step.opcode().row().kind;
    if kind == Kind::Timer {
        return step.target().map(Address::from);
    }
    let number = step.number().filter(|_| !kind.is_value())?;
    Address::in_code(kind, number)
}

/// Whether a code of this kind names a point, alone or with others.
fn has_point(kind: Kind) -> bool {
    let has_none = matches!(
        kind,
        Kind::None | Kind::Branch | Kind::Reading | Kind::Group | Kind::Bit | Kind::Time
    );
    !has_none && !kind.is_value() && !matches!(kind, Kind::Scale | Kind::Filter)
}

/// Where a load or an operation takes its number from.
fn source(step: &Step) -> String {
    match (step.opcode().row().kind, step.number()) {
        (Kind::Value, Some(0)) => spelled(step.lines().first().copied().flatten()),
        (Kind::Real, Some(0)) => match step.lines().first().copied().flatten() {
            Some(bits) => format!("{:?}", f32::from_bits(bits.cast_unsigned())),
            None => String::new(),
        },
        (Kind::Value | Kind::Real, Some(POPPED)) => "POP".to_owned(),
        (Kind::Value | Kind::Real, Some(register)) => Address::Register(register).to_string(),
        _ => text(point(step)),
    }
}

/// A load of this: a point, or a constant.
fn loaded((table, board): (&Table, Board), value: &str) -> Result<Step, Amiss> {
    if value.parse::<i32>().is_ok() {
        return valued((table, board), &Step::new(Opcode::Load), value);
    }
    let (point, _) = pointed((table, board), value)?;
    let (opcode, number) = match point {
        Some(Address::Register(number)) => (Opcode::Load, number),
        Some(Address::Analogue(number)) => (Opcode::LoadAnalogue, number),
        Some(Address::Timer(number)) => (Opcode::LoadTimer, number),
        Some(Address::Counter(number)) => (Opcode::LoadCount, number),
        _ => return Err(both(|lang| words::no_number(lang, value)).into()),
    };
    Ok(Step::new(opcode).with_number(number))
}

/// An operation or comparison with this: a register, a constant, what was pushed.
fn valued((table, board): (&Table, Board), step: &Step, value: &str) -> Result<Step, Amiss> {
    let constant = |line| step.clone().with_number(0).with_lines([line]);
    let is_real = step.opcode().row().kind == Kind::Real;
    if value.is_empty() {
        return Ok(constant(None));
    }
    if value.eq_ignore_ascii_case("POP") {
        return Ok(step.clone().with_number(POPPED));
    }
    if let (true, Ok(real)) = (is_real, value.parse::<f32>()) {
        return Ok(constant(Some(real.to_bits().cast_signed())));
    }
    if let (false, Ok(number)) = (is_real, value.parse()) {
        return Ok(constant(Some(number)));
    }
    // What a timer has is in ms.
    if let (false, None, Some(ms)) = (is_real, table.point(value), duration(value)) {
        return Ok(constant(Some(ms)));
    }
    match (pointed((table, board), value)?.0, step.opcode()) {
        (Some(Address::Register(register)), _) => Ok(step.clone().with_number(register)),
        // What a load loads may stand elsewhere too.
        (Some(_), Opcode::Load) => loaded((table, board), value),
        _ => Err(both(|lang| words::no_number(lang, value)).into()),
    }
}

/// The point of `I1`, `start` or `I1 start`, and the name that it gets.
fn pointed(
    (table, board): (&Table, Board),
    value: &str,
) -> Result<(Option<Address>, Option<String>), Amiss> {
    let (first, name) = value.split_once(char::is_whitespace).unwrap_or((value, ""));
    if first.is_empty() {
        return Ok((None, None));
    }
    let name = Some(name.trim().to_owned()).filter(|name| !name.is_empty());
    match table.point(value).or_else(|| Address::parse(first)) {
        Some(point) => match no_such_point(point, board) {
            Some(lacking) => Err(both(|lang| told(&lacking, lang)).into()),
            None => Ok((Some(point), name)),
        },
        None => Err(both(|lang| words::no_such_point(lang, value)).into()),
    }
}

/// A number; none for an empty field.
fn number<T: TryFrom<i64>>(value: &str) -> Result<Option<T>, Amiss> {
    let wrong = || Amiss::from(both(|lang| words::no_number(lang, value)));
    if value.is_empty() {
        return Ok(None);
    }
    let number: i64 = value.parse().map_err(|_| wrong())?;
    T::try_from(number).map(Some).map_err(|_| wrong())
}

/// A time in ms, which may be written with its units; none for an empty field.
fn time(value: &str) -> Result<Option<i32>, Amiss> {
    let ms = || duration(&value.replace(char::is_whitespace, "").replace(',', "."));
    match number::<i32>(value) {
        Ok(number) => Ok(number),
        Err(_) => match ms() {
            Some(ms) => Ok(Some(ms)),
            None => Err(both(|lang| words::no_time(lang, value)).into()),
        },
    }
}

fn text(point: Option<Address>) -> String {
    point.map_or_else(String::new, |point| point.to_string())
}

fn spelled(number: Option<i32>) -> String {
    number.map_or_else(String::new, |number| number.to_string())
}

fn no_field(key: &str) -> Amiss {
    both(|lang| words::no_field(lang, key)).into()
}

/// What is wrong, and what to do.
fn told(diagnostic: &Diagnostic, lang: Lang) -> String {
    format!("{}: {}", diagnostic.message(lang), diagnostic.help(lang))
}
