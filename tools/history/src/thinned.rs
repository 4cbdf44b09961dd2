//! What is left of rows that are old: one for each minute, and later for each hour.

use crate::query::Row;

/// ms.
pub(crate) const MINUTE: i64 = 60_000;
/// ms.
pub(crate) const HOUR: i64 = 3_600_000;
/// So many times as long as samples are kept, minutes are.
const MINUTES_KEPT: i64 = 4;
/// As many rows as are thinned in one go: nobody waits long for it.
pub(crate) const AT_ONCE: i64 = 20_000;

/// Before when samples, and before when minutes, are thinned. Whole minutes and hours alone, so that none is thinned twice.
pub(crate) fn before(now: i64, keep: i64) -> (i64, i64) {
    let whole = |before: i64, width: i64| before.div_euclid(width) * width;
    (
        whole(now.saturating_sub(keep), MINUTE),
        whole(now.saturating_sub(keep.saturating_mul(MINUTES_KEPT)), HOUR),
    )
}

/// What is thinned: a point, and a row of it.
pub(crate) type Part = (i64, Row);

/// One row for each width of each point. Where there is more than goes at once, the last one may lack its end and is left
/// out, unless it is all there is.
pub(crate) fn whole(parts: Vec<Part>, width: i64) -> (Vec<Part>, bool) {
    let more = parts.len() as i64 == AT_ONCE;
    let mut whole: Vec<Part> = Vec::new();
    for (point, row) in parts {
        let at = row.at.div_euclid(width) * width;
        match whole.last_mut() {
            Some((of, last)) if *of == point && last.at == at => last.extend(&row),
            _ => whole.push((point, Row { at, ..row })),
        }
    }
    if more && whole.len() > 1 {
        whole.pop();
    }
    (whole, more)
}
