//! Which net each wire of a rung belongs to.

use crate::Element;
use crate::power::{Feed, Net, Nets};
use crate::tree::{Gate, Node, Series, Start};

/// Gives every wire its net; gives the one at the end. `block` is the net that an AND block stands after,
/// whose elements know only of acc inside it.
pub(crate) fn energise(
    series: &mut Series,
    start: Net,
    block: Option<Net>,
    elements: &mut [Element],
    nets: &mut Nets,
) -> Net {
    let mut net = start;
    for node in series {
        match node {
            Node::Element(index) => {
                let element = &mut elements[*index];
                net = nets.add(Feed::Step(element.conducts));
                if let Some(block) = block {
                    net = nets.add(Feed::Both(block, net));
                }
                element.net = net;
            }
            Node::Block(series, _) => net = energise(series, net, Some(net), elements, nets),
            Node::Join(join) => {
                let mut end: Option<Net> = None;
                for path in &mut join.paths {
                    path.net = match path.start {
                        Start::At(_, step) => nets.add(Feed::Step(step)),
                        _ => net,
                    };
                    let one = energise(&mut path.series, path.net, block, elements, nets);
                    end = Some(match end {
                        None => one,
                        Some(other) => nets.add(Feed::Either(other, one)),
                    });
                }
                net = match (join.gate, end) {
                    (Gate::Or, Some(end)) => end,
                    _ => nets.add(Feed::Step(join.close)),
                };
                if let Some(element) = join.element {
                    elements[element].net = net;
                }
                join.net = net;
            }
            Node::Fork(branches) => {
                for branch in branches {
                    energise(branch, net, block, elements, nets);
                }
            }
            Node::Store(_) | Node::Goto(_) => {}
        }
    }
    net
}
