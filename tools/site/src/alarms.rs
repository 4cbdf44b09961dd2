//! The tables `alarm` of a site file.

use crate::alarm::{Alarm, Reading, Severity, Sort, Text, UP, When};
use crate::keys::{Amiss, At, Keys, time};
use crate::mistake::Wrong;
use crate::named::named;
use crate::points::{Kind, Point};
use crate::site::{Board, Line};
use std::time::Duration;
use unoclp_core::Board as Model;
use unoclp_lang::condition;
use unoclp_lang::typed::Base;
use unoclp_modbus::map::Width;

const EXAMPLE: &str =
    "[{ name = \"hot\", when = \"estufa.temperature > 80.0\", text = \"too hot\" }]";
const NAME: &str = "\"hot\"";
const WHEN: &str = "\"estufa.temperature > 80.0\"";
const TEXT: &str = "{ en = \"too hot\", pt = \"quente demais\" }";
/// The longest condition, characters.
const LONGEST: usize = 1000;
/// The longest text, characters.
const LONGEST_TEXT: usize = 200;

/// The alarms, as far as they are right.
pub(crate) fn alarms(keys: &Keys<'_>, lines: &[Line]) -> Vec<Alarm> {
    let tables = keys.tables("alarm", EXAMPLE).unwrap_or_default();
    let mut alarms: Vec<Alarm> = Vec::new();
    for table in &tables {
        table.known(&["name", "when", "for", "text", "severity"]);
        let name = named(table, NAME);
        if let Some(At { value, place }) = &name
            && alarms
                .iter()
                .any(|other| other.name.eq_ignore_ascii_case(value))
        {
            let name = value.clone();
            table.notes.wrong(place, Wrong::TwoAlarms { name });
        }
        let when = when(table, lines);
        let lasts = time(table, "for", "\"5s\"", ["0s", "1d"]);
        let severity = severity(table);
        let text = text(table);
        if let (Some(name), Some(when), Some(text)) = (name, when, text) {
            alarms.push(Alarm {
                name: name.value,
                when,
                lasts: lasts.map_or(Duration::ZERO, |lasts| lasts.value),
                text,
                severity,
            });
        }
    }
    alarms
}

fn when(table: &Keys<'_>, lines: &[Line]) -> Option<When> {
    let At { value, place } = table.needed("when", WHEN)?;
    if value.chars().count() > LONGEST {
        let most = LONGEST;
        table.notes.wrong(&place, Wrong::LongCondition { most });
        return None;
    }
    let readings = readings(&value, lines);
    let names: Vec<(String, Base)> = readings
        .iter()
        .map(|reading| {
            let base = match reading.sort {
                Sort::Up | Sort::Bit => Base::Bool,
                Sort::Whole => Base::Dint,
                Sort::Real => Base::Real,
            };
            (format!("{}.{}", reading.board, reading.point), base)
        })
        .collect();
    let wrong = match condition(&value, &names, Model::PC) {
        Ok(condition) => {
            let reads: Vec<(usize, Reading)> = condition
                .reads()
                .filter_map(|number| Some((number, readings.get(number)?.clone())))
                .collect();
            match reads.is_empty() {
                true => Wrong::ReadsNothing,
                false => {
                    return Some(When {
                        text: value,
                        condition,
                        reads,
                    });
                }
            }
        }
        Err(told) => Wrong::NoCondition {
            told: told.first().cloned().map(Box::new),
        },
    };
    table.notes.wrong(&place, wrong);
    None
}

/// What a condition may read: the points of those boards whose names stand in its text.
fn readings(text: &str, lines: &[Line]) -> Vec<Reading> {
    let text = text.to_ascii_lowercase();
    let stands = |board: &&Board| text.contains(&*board.name.to_ascii_lowercase());
    let boards = lines.iter().flat_map(|line| &line.boards).filter(stands);
    let mut readings: Vec<Reading> = Vec::new();
    for board in boards {
        let mut add = |point: &str, sort| {
            let is_known = readings
                .iter()
                .any(|other| other.board == board.name && other.point.eq_ignore_ascii_case(point));
            if !is_known {
                readings.push(Reading {
                    board: board.name.clone(),
                    point: point.to_owned(),
                    sort,
                });
            }
        };
        for point in board.points.recorded(true) {
            add(&point.name, sort(&point));
        }
        add(UP, Sort::Up);
    }
    readings
}

fn sort(point: &Point) -> Sort {
    match (point.read.width, point.kind) {
        (Width::Bit, _) => Sort::Bit,
        (_, Kind::Real) => Sort::Real,
        _ => Sort::Whole,
    }
}

fn severity(table: &Keys<'_>) -> Severity {
    let Some(At { value, place }) = table.text("severity", "\"high\"") else {
        return Severity::Medium;
    };
    let all = [Severity::Low, Severity::Medium, Severity::High];
    if let Some(severity) = all.into_iter().find(|of| of.word() == value) {
        return severity;
    }
    let wrong = Amiss::Choice {
        key: "severity".to_owned(),
        given: value,
        known: "\"low\", \"medium\", \"high\"".to_owned(),
    };
    table.notes.wrong(&place, wrong);
    Severity::Medium
}

fn text(table: &Keys<'_>) -> Option<Text> {
    let (en, pt) = match table.is_table("text") {
        true => {
            let of = table.table("text", TEXT)?;
            of.known(&["en", "pt"]);
            let text = |key| of.text(key, NAME).map(|text| text.value);
            (text("en"), text("pt"))
        }
        false => {
            let text = table.needed("text", TEXT)?.value;
            (Some(text.clone()), Some(text))
        }
    };
    // What says nothing in one language is said in the other.
    let is_said = |text: &String| {
        let is_plain = !text.chars().any(char::is_control);
        !text.trim().is_empty() && text.chars().count() <= LONGEST_TEXT && is_plain
    };
    let (en, pt) = (en.filter(is_said), pt.filter(is_said));
    match (en.clone().or(pt.clone()), pt.or(en)) {
        (Some(en), Some(pt)) => Some(Text { en, pt }),
        _ => {
            let place = table.at("text").unwrap_or(table.place.clone());
            table.notes.wrong(&place, Wrong::NoText);
            None
        }
    }
}
