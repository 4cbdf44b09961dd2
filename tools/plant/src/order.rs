//! The order in which parts are stepped: what others need comes before them.

use crate::plant::Part;
use crate::signal::{Given, Signal, Source};

/// The parts that a part needs.
fn needs(part: &Part) -> impl Iterator<Item = usize> + '_ {
    part.given.iter().filter_map(|given| match given {
        Given::Part(other) | Given::Value(other, _) => Some(*other),
        Given::Signal(Signal {
            source: Source::Value(other, _),
            ..
        }) => Some(*other),
        _ => None,
    })
}

/// The order of the parts.
///
/// # Errors
/// The parts that need each other in a circle, in that order.
pub(crate) fn order(parts: &[Part]) -> Result<Vec<usize>, Vec<usize>> {
    let mut order = Vec::with_capacity(parts.len());
    let mut done = vec![false; parts.len()];
    for first in 0..parts.len() {
        // The way to where the search is, and what of each part on it is still to be seen.
        let mut way: Vec<(usize, Vec<usize>)> = Vec::new();
        let mut next = (!done.get(first).copied().unwrap_or(true)).then_some(first);
        loop {
            if let Some(part) = next.take() {
                if let Some(begin) = way.iter().position(|(on, _)| *on == part) {
                    let circle = way.iter().skip(begin).map(|(on, _)| *on);
                    return Err(circle.collect());
                }
                let own = parts.get(part).map(|own| needs(own).collect());
                way.push((part, own.unwrap_or_default()));
            }
            let Some((part, left)) = way.last_mut() else {
                break;
            };
            match left.pop() {
                Some(other) => next = (done.get(other) == Some(&false)).then_some(other),
                None => {
                    if let Some(done) = done.get_mut(*part) {
                        *done = true;
                    }
                    order.push(*part);
                    way.pop();
                }
            }
        }
    }
    Ok(order)
}
