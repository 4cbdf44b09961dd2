//! The rungs of a ladder body, which a person counts from the top: what wires hold together, rails left out.

use crate::network::Element;

/// In which rung each element stands, from 1; none of rails, labels and comments.
pub(crate) fn numbers(elements: &[Element<'_, '_>]) -> Vec<Option<usize>> {
    let mut joined = Joined((0..elements.len()).collect());
    for (at, element) in elements.iter().enumerate() {
        if element.kind == "rightPowerRail" {
            continue;
        }
        for wire in element.inputs.iter().flat_map(|pin| &pin.wires) {
            let is_rail = elements
                .get(wire.from)
                .is_none_or(|from| from.kind == "leftPowerRail");
            if !is_rail {
                joined.join(wire.from, at);
            }
        }
    }
    let is_drawn = |element: &Element<'_, '_>| {
        !matches!(
            element.kind,
            "leftPowerRail" | "rightPowerRail" | "label" | "comment" | "vendorElement"
        )
    };
    let roots: Vec<usize> = (0..elements.len()).map(|at| joined.root(at)).collect();
    let drawn = elements.iter().enumerate().filter(|(_, e)| is_drawn(e));
    let mut drawn: Vec<usize> = drawn.map(|(at, _)| at).collect();
    drawn.sort_by_key(|at| (elements[*at].place, *at));
    let (mut numbers, mut next) = (vec![None; elements.len()], 1);
    let mut rungs = vec![None; elements.len()];
    for at in drawn {
        let number = numbers[roots[at]].get_or_insert_with(|| {
            next += 1;
            next - 1
        });
        rungs[at] = Some(*number);
    }
    rungs
}

/// Which elements are joined: each names another of its rung, or itself.
struct Joined(Vec<usize>);

impl Joined {
    fn root(&mut self, mut at: usize) -> usize {
        while self.0[at] != at {
            self.0[at] = self.0[self.0[at]];
            at = self.0[at];
        }
        at
    }

    fn join(&mut self, one: usize, other: usize) {
        let (one, other) = (self.root(one), self.root(other));
        self.0[one.max(other)] = one.min(other);
    }
}
