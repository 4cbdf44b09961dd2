//! The rungs of a ladder body, which a person counts from the top: what wires hold together, rails left out.

/// In which rung each element stands, from 1. Of each it is given where it is drawn, none of rails, labels and comments;
/// and which two of them a wire joins.
pub(crate) fn numbers(
    places: &[Option<(i64, i64)>],
    wires: impl Iterator<Item = (usize, usize)>,
) -> Vec<Option<usize>> {
    let mut joined = Joined((0..places.len()).collect());
    for (one, other) in wires {
        joined.join(one, other);
    }
    let roots: Vec<usize> = (0..places.len()).map(|at| joined.root(at)).collect();
    let drawn = places.iter().enumerate();
    let drawn = drawn.filter_map(|(at, place)| place.map(|place| (place, at)));
    let mut drawn: Vec<_> = drawn.collect();
    drawn.sort_unstable();
    let (mut numbers, mut next) = (vec![None; places.len()], 1);
    let mut rungs = vec![None; places.len()];
    for (_, at) in drawn {
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
