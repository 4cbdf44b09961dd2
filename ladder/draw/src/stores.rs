//! Which stored results must be named in the picture.

use crate::tree::{Node, Origin, Series, Start};

/// Finds out which stores must be named: those that paths name, and those that none begins at.
pub(crate) fn name(series: &mut Series) {
    let (mut named, mut joined) = (Vec::new(), Vec::new());
    for node in series.iter() {
        node.visit(&mut |node| {
            if let Node::Join(join) = node {
                for path in &join.paths {
                    if let Start::At(Origin::Store(step), _) = path.start {
                        named.push(step);
                    }
                }
            }
        });
    }
    followed_by_join(series, &mut joined);
    mark_stores(series, &named, &joined);
}

/// The stores right after which paths part.
fn followed_by_join(series: &Series, joined: &mut Vec<usize>) {
    for (index, node) in series.iter().enumerate() {
        if let Node::Store(store) = node {
            let next = series[index + 1..]
                .iter()
                .find(|node| !matches!(node, Node::Store(_)));
            if matches!(next, Some(Node::Join(_))) {
                joined.push(store.step);
            }
        }
        inner(node).for_each(|series| followed_by_join(series, joined));
    }
}

fn mark_stores(series: &mut Series, named: &[usize], joined: &[usize]) {
    for node in series {
        if let Node::Store(store) = node {
            store.named = named.contains(&store.step) || !joined.contains(&store.step);
        }
        inner_mut(node).for_each(|series| mark_stores(series, named, joined));
    }
}

/// The series within a node.
fn inner(node: &Node) -> Box<dyn Iterator<Item = &Series> + '_> {
    match node {
        Node::Block(series, _) => Box::new(std::iter::once(series)),
        Node::Join(join) => Box::new(join.paths.iter().map(|path| &path.series)),
        Node::Fork(branches) => Box::new(branches.iter()),
        _ => Box::new(std::iter::empty()),
    }
}

fn inner_mut(node: &mut Node) -> Box<dyn Iterator<Item = &mut Series> + '_> {
    match node {
        Node::Block(series, _) => Box::new(std::iter::once(series)),
        Node::Join(join) => Box::new(join.paths.iter_mut().map(|path| &mut path.series)),
        Node::Fork(branches) => Box::new(branches.iter_mut()),
        _ => Box::new(std::iter::empty()),
    }
}
