//! What a timing diagram shows of a run: lanes, each with its courses over time.
//!
//! Owns which lanes there are, and where what came is not what was expected. Must not know how they are drawn.

use crate::scenario::{Both, Change, Course, Place, Plan, Report, points};
use std::collections::BTreeMap;
use unoclp_core::{Millis, Point};
use unoclp_program::Lang;

/// A point over time.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Lane {
    /// The point, and what is connected to it.
    pub label: String,
    /// Whether it can only be 0 or 1.
    pub is_bit: bool,
    /// What was expected of it; none of an input.
    pub expected: Option<Course>,
    /// What it was.
    pub came: Course,
    /// Where these differ, each from one time to another.
    pub unmet: Vec<(Millis, Millis)>,
}

/// The lanes of a run, inputs first.
pub fn lanes(
    plan: &Plan,
    report: &Report,
    names: &BTreeMap<String, Both>,
    lang: Lang,
) -> Vec<Lane> {
    let label = |point: String| match names.get(&point) {
        Some(name) => format!("{point} {}", name.text(lang)),
        None => point,
    };
    let input = |point: String, is_bit, value: &dyn Fn(&Change) -> i32| Lane {
        label: label(point),
        is_bit,
        expected: None,
        came: course(report, value),
        unmet: Vec::new(),
    };
    // What is connected and not pressed is told too.
    let is_shown = |point: &Point| {
        plan.inputs.contains(point) || names.contains_key(&format!("I{}", point.number()))
    };
    let digital = points(Point::MOST).filter(is_shown).map(|point| {
        let value = move |change: &Change| i32::from(change.inputs.points.get(point));
        input(format!("I{}", point.number()), true, &value)
    });
    let analogue = report.columns.analogue.iter().map(|&number| {
        let value = move |change: &Change| {
            let reading = change.inputs.analogue.get(usize::from(number));
            i32::from(reading.copied().unwrap_or_default())
        };
        input(format!("A{number}"), false, &value)
    });
    let expected = plan.expected.iter().map(|(&place, expected)| {
        let came = course(report, &|change| report.came(place, change));
        Lane {
            label: label(place.to_string()),
            is_bit: Place::is_bit(place),
            unmet: differences(expected, &came, report.end),
            expected: Some(expected.clone()),
            came,
        }
    });
    digital.chain(analogue).chain(expected).collect()
}

/// A value over the time of a run, where it changes.
fn course(report: &Report, value: &dyn Fn(&Change) -> i32) -> Course {
    let mut course = Course::new();
    for change in &report.changes {
        let value = Some(value(change));
        if course.last().is_none_or(|last| last.1 != value) {
            course.push((change.at, value));
        }
    }
    course
}

/// What a course is at a time.
fn at(course: &Course, time: Millis) -> Option<i32> {
    let before = course.partition_point(|&(from, _)| from <= time);
    course[..before].last().and_then(|last| last.1)
}

/// The times in which something is expected and does not come, up to the last scan.
fn differences(expected: &Course, came: &Course, end: Millis) -> Vec<(Millis, Millis)> {
    let mut times: Vec<Millis> = [expected, came]
        .into_iter()
        .flatten()
        .map(|&(from, _)| from)
        .filter(|&from| from <= end)
        .collect();
    times.sort_unstable();
    times.dedup();
    let mut found: Vec<(Millis, Millis)> = Vec::new();
    for (index, &from) in times.iter().enumerate() {
        let to = times.get(index + 1).copied().unwrap_or(end);
        let expected = at(expected, from);
        if expected.is_none() || expected == at(came, from) {
            continue;
        }
        match found.last_mut() {
            Some(last) if last.1 == from => last.1 = to,
            _ => found.push((from, to)),
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_is_expected_and_does_not_come_differs() {
        let expected = vec![(0, Some(0)), (10, None), (20, Some(1)), (40, Some(0))];
        let came = vec![(0, Some(0)), (12, Some(1)), (15, Some(0)), (25, Some(1))];
        let found = differences(&expected, &came, 50);
        assert_eq!(found, [(20, 25), (40, 50)]);
        assert_eq!(
            differences(&expected, &came, 30),
            [(20, 25)],
            "after the end"
        );
        assert_eq!(differences(&expected, &expected, 50), []);
    }
}
