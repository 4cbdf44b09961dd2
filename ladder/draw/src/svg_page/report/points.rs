//! The table of points: what each is called, and the rungs in which it stands.

use super::pages::{Pages, Report, SPACE};
use super::paper::{HEAD, Leaf, ROW, SMALL, lines};
use crate::{Drawing, Names};
use std::collections::{BTreeMap, BTreeSet};
use unoclp_point::Address;

/// The columns: point, name and rungs by their number, and where each begins, of the width.
const NAMED: &[(usize, f32)] = &[(0, 0.0), (1, 0.1), (2, 0.5)];
/// Those where nothing has a name.
const NAMELESS: &[(usize, f32)] = &[(0, 0.0), (2, 0.1)];
/// The width of names.
const NAME: f32 = 0.39;

/// Writes the table after the rungs; none where no rung has a point.
pub(super) fn table(drawing: &Drawing<'_>, names: &Names, pages: &mut Pages<'_>) {
    let used = used(drawing);
    if used.is_empty() {
        return;
    }
    let named = used.keys().any(|point| names.contains_key(point));
    let columns = if named { NAMED } else { NAMELESS };
    let report = pages.report;
    let (left, (wide, _)) = (report.paper.margin(), report.paper.room());

    // The heading is not left alone at the foot of a page.
    let leaf = pages.open(HEAD.line() + 2.0 * SPACE + 3.0 * ROW.line());
    leaf.y += SPACE;
    leaf.text(left, leaf.y + HEAD.height(), report.points[0], &HEAD);
    leaf.y += HEAD.line() + 2.0;
    head(leaf, report, columns);

    let rest = 1.0 - columns.last().map_or(0.0, |(_, part)| *part);
    for (point, rungs) in used {
        let rungs: Vec<String> = rungs.iter().map(usize::to_string).collect();
        let name = names.get(&point).map_or("", String::as_str);
        let cells = [
            vec![point.to_string()],
            lines(name, ROW.columns(NAME * wide)),
            lines(&rungs.join(", "), ROW.columns(rest * wide)),
        ];
        for line in 0..cells.iter().map(Vec::len).max().unwrap_or(0) {
            let leaf = pages.open(ROW.line());
            if leaf.empty {
                head(leaf, report, columns);
            }
            for (column, part) in columns {
                if let Some(text) = cells[*column].get(line) {
                    leaf.text(left + part * wide, leaf.y + ROW.height(), text, &ROW);
                }
            }
            leaf.y += ROW.line();
        }
    }
}

/// What stands above the rows of a page.
fn head(leaf: &mut Leaf, report: &Report<'_>, columns: &[(usize, f32)]) {
    let (left, (wide, _)) = (report.paper.margin(), report.paper.room());
    let [_, words @ ..] = report.points;
    for (column, part) in columns {
        let x = left + part * wide;
        leaf.text(x, leaf.y + SMALL.height(), words[*column], &SMALL);
    }
    leaf.y += SMALL.height() + 1.5;
    leaf.rule(left, left + wide, leaf.y);
    leaf.y += 2.0;
    leaf.empty = false;
}

/// The points that stand in rungs, with the numbers of these, from 1.
fn used(drawing: &Drawing<'_>) -> BTreeMap<Address, BTreeSet<usize>> {
    let ladder = drawing.ladder();
    let mut used: BTreeMap<Address, BTreeSet<usize>> = BTreeMap::new();
    for (rung, picture) in (1..).zip(&drawing.rungs) {
        let cells = picture.rows.iter().flatten();
        let elements: BTreeSet<usize> = cells.filter_map(|cell| cell.element).collect();
        let points = elements
            .into_iter()
            .filter_map(|at| ladder.elements.get(at)?.point);
        for point in points {
            used.entry(point).or_default().insert(rung);
        }
        for &label in &ladder.rungs[rung - 1].labels {
            used.entry(Address::Label(label)).or_default().insert(rung);
        }
    }
    used
}
