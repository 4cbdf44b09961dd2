//! Rungs that are too wide go on in further lines, where names tell which wires are one.
//!
//! A line that goes on ends in `→a`, and the line that goes on from it begins with `a→`. Where even the paths of
//! one join are too wide, each becomes a line of its own; all ends of the same name join where it begins.

use crate::face::Face;
use crate::power::{Net, Nets};
use crate::tree::{Gate, Join, Node, Path, Series, Start};
use crate::{Element, Ladder};
use std::collections::VecDeque;
use unicode_width::UnicodeWidthStr;

/// Columns from element to element.
pub(crate) const WIRE: usize = 2;

/// What is kept free to go on elsewhere: a wire, `→aaa`, and a blank.
const GOTO: usize = WIRE + 5;

/// A line of a rung.
#[derive(Clone, Debug)]
pub(crate) struct Line {
    /// What it begins with; none for the left rail.
    pub(crate) start: Option<String>,
    /// The net there.
    pub(crate) net: Net,
    pub(crate) series: Series,
}

/// Breaks a rung of a ladder into lines.
pub(crate) struct Wrap<'w> {
    pub(crate) ladder: &'w Ladder,
    /// The faces of the elements from this one on.
    pub(crate) faces: (usize, &'w [Face]),
    /// The columns that a line may take.
    pub(crate) room: usize,
}

/// The rest of a rung, and the names that have been given.
struct Rest {
    lines: VecDeque<Line>,
    names: usize,
}

impl Wrap<'_> {
    /// The lines of a rung, none wider than the room unless a single element is.
    pub(crate) fn lines(&self, series: &Series, rail: Net) -> Vec<Line> {
        let mut lines = Vec::new();
        let mut rest = Rest {
            lines: VecDeque::from([Line {
                start: None,
                net: rail,
                series: series.clone(),
            }]),
            names: 0,
        };
        while let Some(line) = rest.lines.pop_front() {
            let label = line.start.as_deref().map_or(0, |start| start.width() + 1);
            let room = self.room.saturating_sub(label);
            let mut next = Rest {
                lines: VecDeque::new(),
                names: rest.names,
            };
            let begins = (line.start.clone(), line.net);
            let series = self.fit(line.series, room, begins, true, &mut next);
            rest.names = next.names;
            next.lines.append(&mut rest.lines);
            rest.lines = next.lines;
            let alone = lines.is_empty() && rest.lines.is_empty();
            if series.iter().any(Node::is_visible) || alone {
                lines.push(Line { series, ..line });
            }
        }
        lines
    }

    /// As much of a series as fits into the room. `first` says that a line begins here: what does not fit
    /// then does not fit into any.
    fn fit(
        &self,
        series: Series,
        room: usize,
        (start, mut net): (Option<String>, Net),
        mut first: bool,
        rest: &mut Rest,
    ) -> Series {
        let mut fitting = Series::new();
        let mut used = 0;
        let mut nodes: VecDeque<Node> = series.into();
        while let Some(node) = nodes.pop_front() {
            if !node.is_visible() {
                fitting.push(node);
                continue;
            }
            let width = WIRE + self.width(&node);
            let last = !nodes.iter().any(Node::is_visible);
            if used + width + if last { 1 } else { GOTO } <= room {
                used += width;
                net = self.behind(&node, net);
                fitting.push(node);
                first = false;
                continue;
            }
            let left = room.saturating_sub(used);
            match node {
                // A block is a series like any other.
                Node::Block(series, steps) => {
                    fitting.push(Node::Block(Series::new(), steps));
                    series
                        .into_iter()
                        .rev()
                        .for_each(|node| nodes.push_front(node));
                }
                Node::Fork(branches) if first || self.least(&branches) <= left => {
                    let left = left.saturating_sub(WIRE + 1);
                    let fit = |branch| self.fit(branch, left, (None, net), false, rest);
                    fitting.push(Node::Fork(branches.into_iter().map(fit).collect()));
                    return fitting;
                }
                Node::Join(join) if first => {
                    let name = start.unwrap_or_else(|| "├".to_owned());
                    let begins = (name, net);
                    self.apart(join, begins, nodes.into(), rest);
                    return fitting;
                }
                // An element of its own line stays, however wide.
                node @ Node::Element(_) if first => {
                    used += width;
                    net = self.behind(&node, net);
                    fitting.push(node);
                    first = false;
                }
                node => {
                    let name = rest.name();
                    fitting.push(Node::Goto(format!("→{name}")));
                    nodes.push_front(node);
                    rest.lines.push_back(Line {
                        start: Some(format!("{name}→")),
                        net,
                        series: nodes.into(),
                    });
                    return fitting;
                }
            }
        }
        fitting
    }

    /// Makes each path of a join a line of its own, and what follows the join another.
    fn apart(&self, join: Join, (start, net): (String, Net), behind: Series, rest: &mut Rest) {
        let name = rest.name();
        let mut end = name.clone();
        let mut series = behind;
        if join.gate != Gate::Or {
            // The box stays; its second input gets a name too.
            let second = rest.name();
            let mut path = Path::here(Series::new());
            path.start = Start::Named(format!("{second}→"));
            path.net = join.paths.last().map_or(net, |path| self.end(path));
            let paths = vec![Path::here(Series::new()), path];
            let mut gate = Join {
                paths,
                ..join.clone()
            };
            gate.paths[0].net = join.paths.first().map_or(net, |path| self.end(path));
            series.insert(0, Node::Join(gate));
            end = second;
        }
        let first_net = join.paths.first().map_or(net, |path| self.end(path));
        let gate = join.gate;
        for (index, mut path) in join.paths.into_iter().enumerate() {
            let to = if index == 0 { &name } else { &end };
            path.series.push(Node::Goto(format!("→{to}")));
            let begin = match path.start {
                Start::Here => Some(start.clone()).filter(|start| start != "├"),
                other => Some(self.ladder.start(&other)),
            };
            rest.lines.push_back(Line {
                start: begin,
                net: path.net,
                series: path.series,
            });
        }
        rest.lines.push_back(Line {
            start: Some(format!("{name}→")),
            net: if gate == Gate::Or {
                join.net
            } else {
                first_net
            },
            series,
        });
    }

    /// The net at the end of a path.
    fn end(&self, path: &Path) -> Net {
        let net = path.net;
        path.series
            .iter()
            .fold(net, |net, node| self.behind(node, net))
    }

    /// The net after a node.
    pub(crate) fn behind(&self, node: &Node, before: Net) -> Net {
        match node {
            Node::Element(index) => self.element(*index).map_or(Nets::RAIL, |e| e.net),
            Node::Join(join) => join.net,
            Node::Block(series, _) => series
                .iter()
                .fold(before, |net, node| self.behind(node, net)),
            _ => before,
        }
    }

    fn element(&self, index: usize) -> Option<&Element> {
        self.ladder.elements.get(index)
    }

    /// The least that a fork takes to be worth drawing: its first element.
    fn least(&self, branches: &[Series]) -> usize {
        let first = branches.first().and_then(|branch| branch.first());
        WIRE + 1 + WIRE + first.map_or(0, |node| self.width(node)) + 1
    }

    /// The columns of a node.
    fn width(&self, node: &Node) -> usize {
        match node {
            Node::Element(index) => self.face_width(*index),
            Node::Store(store) => store.name.len() + 1,
            Node::Block(series, _) => self.series_width(series).saturating_sub(WIRE),
            Node::Join(join) => {
                let path = |path: &Path| {
                    let start = match &path.start {
                        Start::Here => 0,
                        start => self.ladder.start(start).width() + 1,
                    };
                    start + self.series_width(&path.series)
                };
                let end = join.element.map_or(1, |element| self.face_width(element));
                1 + join.paths.iter().map(path).max().unwrap_or(0) + WIRE + end
            }
            Node::Fork(branches) => {
                let branch = |branch: &Series| self.series_width(branch) + 1;
                1 + branches.iter().map(branch).max().unwrap_or(0)
            }
            Node::Goto(name) => name.width() + 1,
        }
    }

    pub(crate) fn face(&self, element: usize) -> Option<&Face> {
        let (first, faces) = self.faces;
        faces.get(element.checked_sub(first)?)
    }

    fn face_width(&self, element: usize) -> usize {
        self.face(element).map_or(0, |face| face.width)
    }

    fn series_width(&self, series: &Series) -> usize {
        let visible = series.iter().filter(|node| node.is_visible());
        visible.map(|node| WIRE + self.width(node)).sum()
    }
}

impl Rest {
    /// The next name: a, b … z, aa, ab …
    fn name(&mut self) -> String {
        let mut number = self.names;
        self.names += 1;
        let mut name = String::new();
        loop {
            name.insert(0, char::from(b'a' + (number % 26) as u8));
            match (number / 26).checked_sub(1) {
                Some(left) => number = left,
                None => return name,
            }
        }
    }
}
