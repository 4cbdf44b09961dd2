//! From the lines of a rung to cells.

use crate::block::{Block, Cell, cells};
use crate::face::INDENT;
use crate::power::Net;
use crate::tree::{Gate, Join, Node, Path, Series, Start};
use crate::wrap::{Line, WIRE, Wrap};
use unicode_width::UnicodeWidthStr;

/// How a path part of a fork is joined to its vertical: first, in between, last.
const FORK: [char; 3] = ['┬', '├', '└'];
/// Likewise where paths come together.
const MEET: [char; 3] = ['┬', '┤', '┘'];

/// Where a series stands.
#[derive(Clone, Copy, PartialEq, Eq)]
struct Place {
    /// Right after the left rail, which joins the paths of a join that begins there.
    at_rail: bool,
    /// Before the right rail.
    at_end: bool,
}

impl Wrap<'_> {
    /// A line, without the rails. Rows that reach the right rail have a column that stretches.
    pub(crate) fn layout(&self, line: &Line) -> Block {
        let mut block = Block::default();
        if let Some(start) = &line.start {
            block = Block::row(vec![Cell::BLANK]);
            block.append(Block::text(start, line.net));
        }
        let place = Place {
            at_rail: line.start.is_none(),
            at_end: true,
        };
        block.append(self.series(&line.series, line.net, place).0);
        if block.rows.is_empty() {
            block = Block::wire(WIRE, line.net);
        }
        block
    }

    /// A series, and the net after it.
    fn series(&self, series: &Series, mut net: Net, place: Place) -> (Block, Net) {
        let mut block = Block::default();
        let mut at_rail = place.at_rail;
        let mut nodes = series.iter().filter(|node| node.is_visible()).peekable();
        while let Some(node) = nodes.next() {
            let at_end = place.at_end && nodes.peek().is_none();
            let lead = match node {
                Node::Join(_) if at_rail => 0,
                Node::Block(..) => 0,
                _ => WIRE,
            };
            if lead > 0 {
                block.append(Block::wire(lead, net));
            }
            let column = block.width.saturating_sub(1);
            let behind = self.behind(node, net);
            let inner = Place { at_rail, at_end };
            block.append(self.node(node, net, inner));
            if at_end && self.reaches_the_rail(node) {
                block.append(Block::wire(1, behind));
                block.square();
                for row in &mut block.rows {
                    row[column].stretches = true;
                }
            }
            net = behind;
            at_rail = false;
        }
        (block, net)
    }

    fn reaches_the_rail(&self, node: &Node) -> bool {
        match node {
            Node::Element(index) => self.ladder.elements[*index].ends_a_rung(),
            _ => false,
        }
    }

    fn node(&self, node: &Node, net: Net, place: Place) -> Block {
        match node {
            Node::Element(index) => self.symbol(*index, net),
            Node::Store(store) => Block::text(&format!("•{}", store.name), net),
            Node::Block(series, _) => self.series(series, net, place).0,
            Node::Join(join) if join.gate == Gate::Or => self.join(join, net, place.at_rail),
            Node::Join(join) => self.gate(join, net, place.at_rail),
            Node::Fork(branches) => self.fork(branches, net),
            Node::Goto(name) => {
                let mut block = Block::text(name, net);
                block.append(Block::row(vec![Cell::BLANK]));
                block
            }
        }
    }

    /// The symbol of an element, its name above and its notes below.
    fn symbol(&self, index: usize, before: Net) -> Block {
        let Some(face) = self.face(index) else {
            return Block::default();
        };
        let net = self.ladder.elements[index].net;
        // Notes stand below the beginning, names above the middle.
        let spare = match (&face.notes[..], face.pins) {
            (_, Some((before, _))) => before,
            ([], None) => face.width.saturating_sub(face.symbol.width()) / 2,
            _ => 0,
        };
        let mut row = vec![Cell::wire(before); spare];
        row.extend(cells(&face.symbol, Some(net), Some(index)));
        row.resize(face.width, Cell::wire(net));
        let mut block = Block::row(row);
        if face.pins.is_some() {
            // Its address is above it, and its second row of pins below the wire.
            let mut row = vec![Cell::BLANK; spare];
            let blank = " ".repeat(face.symbol.width());
            row.extend(cells(&blank, Some(net), Some(index)));
            block.rows.push(row);
            block.rows.insert(0, Vec::new());
            block.axis = 1;
        }
        if let Some(name) = &face.name {
            let middle = 2 * spare + face.symbol.width();
            let room = face.width.saturating_sub(name.width());
            let before = match face.pins {
                Some(_) => (middle.saturating_sub(name.width()) / 2).min(room),
                None => room.div_ceil(2),
            };
            let mut row = vec![Cell::BLANK; before];
            row.extend(cells(name, None, None));
            block.rows.insert(0, row);
            block.axis += 1;
        }
        for note in &face.notes {
            let mut row = vec![Cell::BLANK; INDENT];
            row.extend(cells(note, Some(net), None));
            block.rows.push(row);
        }
        block.square();
        block
    }

    /// Paths one below the other, of the same width; and the rows of their wires.
    fn paths(&self, paths: &[Path], at_rail: bool, width: usize) -> (Block, Vec<usize>) {
        let place = Place {
            at_rail: false,
            at_end: false,
        };
        let mut blocks = Vec::new();
        for path in paths {
            let mut block = Block::default();
            if path.start != Start::Here {
                block = Block::row(vec![Cell::BLANK]);
                block.append(Block::text(&self.ladder.start(&path.start), path.net));
            }
            let inner = Place {
                at_rail: at_rail && path.start == Start::Here,
                ..place
            };
            let (series, end) = self.series(&path.series, path.net, inner);
            block.append(series);
            blocks.push((block, end));
        }
        let widest = blocks.iter().map(|(block, _)| block.width).max();
        let mut all = Block::default();
        let mut axes = Vec::new();
        for (mut block, end) in blocks {
            block.lengthen(widest.unwrap_or(0) + width, end);
            axes.push(all.stack(block));
        }
        (all, axes)
    }

    /// Paths that part where they begin and join by wire where they end.
    fn join(&self, join: &Join, net: Net, at_rail: bool) -> Block {
        let (mut all, axes) = self.paths(&join.paths, at_rail, WIRE);
        vertical(&mut all, &axes, MEET, join.net);
        self.part(join, all, &axes, net, at_rail)
    }

    /// Two paths into a box.
    fn gate(&self, join: &Join, net: Net, at_rail: bool) -> Block {
        let (mut all, axes) = self.paths(&join.paths, at_rail, WIRE);
        let Some(element) = join.element else {
            return all;
        };
        let column = all.width;
        let symbol = self.symbol(element, net);
        let middle = column + symbol.width / 2;
        if let [first, second] = axes[..] {
            let end = join.paths.last().map(|path| self.behind_path(path));
            let end = end.unwrap_or(join.net);
            for row in first + 1..second {
                all.set(row, middle, Cell::new('│', Some(end)));
            }
            for column in column..middle {
                all.set(second, column, Cell::wire(end));
            }
            all.set(second, middle, Cell::new('┘', Some(end)));
            for (offset, cell) in symbol.rows.concat().into_iter().enumerate() {
                all.set(first, column + offset, cell);
            }
        }
        self.part(join, all, &axes, net, at_rail)
    }

    fn behind_path(&self, path: &Path) -> Net {
        let nodes = path.series.iter();
        nodes.fold(path.net, |net, node| self.behind(node, net))
    }

    /// Puts the joint before the paths that begin here.
    fn part(&self, join: &Join, all: Block, axes: &[usize], net: Net, at_rail: bool) -> Block {
        if at_rail {
            return all;
        }
        let here: Vec<usize> = join
            .paths
            .iter()
            .zip(axes)
            .filter(|(path, _)| path.start == Start::Here)
            .map(|(_, axis)| *axis)
            .collect();
        let mut joint = Block {
            rows: vec![Vec::new(); all.rows.len()],
            axis: all.axis,
            width: 0,
        };
        vertical(&mut joint, &here, FORK, net);
        joint.square();
        joint.append(all);
        joint
    }

    /// Branches that each end on their own.
    fn fork(&self, branches: &[Series], net: Net) -> Block {
        let mut all = Block::default();
        let mut axes = Vec::new();
        let place = Place {
            at_rail: false,
            at_end: true,
        };
        for branch in branches {
            axes.push(all.stack(self.series(branch, net, place).0));
        }
        let mut joint = Block {
            rows: vec![Vec::new(); all.rows.len()],
            axis: all.axis,
            width: 0,
        };
        vertical(&mut joint, &axes, FORK, net);
        joint.append(all);
        joint
    }
}

/// Joins the wires in these rows by a vertical one after all that is there.
fn vertical(block: &mut Block, axes: &[usize], [first, between, last]: [char; 3], net: Net) {
    let (Some(&top), Some(&bottom)) = (axes.first(), axes.last()) else {
        return;
    };
    let column = block.width;
    for row in top..=bottom {
        let ch = match row {
            _ if top == bottom => '─',
            row if row == top => first,
            row if row == bottom => last,
            row if axes.contains(&row) => between,
            _ => '│',
        };
        block.set(row, column, Cell::new(ch, Some(net)));
    }
}
