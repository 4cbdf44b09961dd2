//! Outputs one below the other at the right rail.

use crate::Element;
use crate::tree::{Node, Path, Series, Start};

/// Gives each output that is not the last of a rung a branch of its own, as well as paths that all end
/// in outputs.
pub(crate) fn fork(series: &mut Series, elements: &[Element]) {
    let is_output = |node: &Node| match node {
        Node::Element(index) => elements[*index].is_output(),
        _ => false,
    };
    let mut rest = Some(std::mem::take(series));
    // From the front, without recursion: a rung may be one long chain of coils.
    let mut levels: Vec<(Series, Node)> = Vec::new();
    while let Some(mut now) = rest.take() {
        let output = now.iter().position(is_output);
        match output {
            Some(index) if now[index + 1..].iter().any(Node::is_visible) => {
                let behind = now.split_off(index + 1);
                if let Some(output) = now.pop() {
                    levels.push((now, output));
                }
                rest = Some(behind);
            }
            _ => {
                fork_last(&mut now, elements);
                *series = now;
            }
        }
    }
    for (mut before, output) in levels.into_iter().rev() {
        let behind = std::mem::take(series);
        let mut branches = vec![vec![output]];
        match <[Node; 1]>::try_from(behind) {
            Ok([Node::Fork(more)]) => branches.extend(more),
            Ok([node]) => branches.push(vec![node]),
            Err(behind) => branches.push(behind),
        }
        before.push(Node::Fork(branches));
        *series = before;
    }
}

/// Paths at the end of a rung need not come together again where each ends in an output.
fn fork_last(series: &mut Series, elements: &[Element]) {
    let ends = |path: &Path| {
        let last = path.series.last();
        let output = matches!(last, Some(Node::Element(index)) if elements[*index].is_output());
        path.start == Start::Here && output
    };
    let last = series.last_mut().and_then(Node::as_or);
    if last.is_some_and(|join| join.paths.iter().all(ends))
        && let Some(Node::Join(join)) = series.pop()
    {
        let mut branches = Vec::new();
        let mut steps = Vec::new();
        for mut path in join.paths {
            steps.append(&mut path.steps);
            fork(&mut path.series, elements);
            branches.push(path.series);
        }
        // The steps that were joints belong to the fork now.
        series.push(Node::Block(Vec::new(), steps));
        series.push(Node::Fork(branches));
    }
}
