//! From the accumulator code of a rung to its tree.
//!
//! A frame is what one run of acc has gathered: the rung itself, or an open branch or block. Where a branch
//! closes, its frame becomes a path beside what the frame around it holds.

use crate::element::{Element, Role};
use crate::energise::energise;
use crate::fork::fork;
use crate::power::{Net, Nets};
use crate::stores;
use crate::tree::{Gate, Join, Node, Origin, Path, Series, Start, Store};
use crate::value::{Load, asks_for_value};
use unoclp_core::Instruction;
use unoclp_core::isa::Class;

/// Builds the tree of one rung.
pub(crate) struct Builder<'e> {
    elements: &'e mut Vec<Element>,
    /// The rung, then the branches that are open.
    frames: Vec<Frame>,
    /// Which step has stored each branch point, the last one of each.
    latest: [Option<usize>; 8],
    /// How often each has been stored.
    stored: [usize; 8],
    /// What the value accumulator is known to hold.
    value: Option<Load>,
}

struct Frame {
    gate: Gate,
    origin: Origin,
    series: Series,
    /// The steps that have opened it.
    steps: Vec<usize>,
}

impl<'e> Builder<'e> {
    pub(crate) fn new(elements: &'e mut Vec<Element>) -> Builder<'e> {
        Builder {
            elements,
            frames: vec![Frame::new(Gate::Or, Vec::new())],
            latest: [None; 8],
            stored: [0; 8],
            value: None,
        }
    }

    /// Takes the next instruction; `timer` is the number of the timer that a block here would be.
    pub(crate) fn push(&mut self, step: usize, instruction: Instruction<'_>, timer: u8) {
        let number = usize::from(instruction.number().unwrap_or(0));
        match instruction.opcode.class() {
            Class::OpenOr => self.frames.push(Frame::new(Gate::Or, vec![step])),
            Class::OpenAnd => self.frames.push(Frame::new(Gate::And, vec![step])),
            Class::OpenXor => self.frames.push(Frame::new(Gate::Xor, vec![step])),
            Class::RecallPoint => {
                let store = self.latest.get(number.wrapping_sub(1)).copied().flatten();
                let frame = self.frame();
                frame.steps.push(step);
                if let Some(store) = store {
                    frame.origin = Origin::Store(store);
                }
            }
            Class::StorePoint => {
                let index = number.wrapping_sub(1) & 7;
                self.latest[index] = Some(step);
                self.stored[index] += 1;
                let name = match self.stored[index] {
                    1 => number.to_string(),
                    again => format!("{number}.{again}"),
                };
                let named = false;
                self.frame()
                    .series
                    .push(Node::Store(Store { step, name, named }));
            }
            Class::Close => self.close(step),
            Class::Contact
            | Class::Condition
            | Class::ValueContact
            | Class::Comparison
            | Class::Xor
            | Class::Logic
            | Class::Coil
            | Class::Timer
            | Class::Count
            | Class::Load
            | Class::LoadResult
            | Class::Operation
            | Class::Store
            | Class::Leave
            | Class::If
            | Class::Setting => self.element(step, instruction, timer),
            // At the head of the rung, where the ladder has them.
            Class::Rung | Class::Label | Class::Part => {}
        }
    }

    /// The tree of the rung, with `rail` as the net at its beginning.
    pub(crate) fn finish(mut self, nets: &mut Nets, rail: Net) -> Series {
        let mut series = std::mem::take(&mut self.frame().series);
        stores::name(&mut series);
        fork(&mut series, self.elements);
        energise(&mut series, rail, None, self.elements, nets);
        series
    }

    /// The innermost frame; the loader has seen to it that the rung's own is never closed.
    fn frame(&mut self) -> &mut Frame {
        if self.frames.is_empty() {
            self.frames.push(Frame::new(Gate::Or, Vec::new()));
        }
        let last = self.frames.len() - 1;
        &mut self.frames[last]
    }

    fn element(&mut self, step: usize, instruction: Instruction<'_>, timer: u8) {
        let opcode = instruction.opcode;
        let source = self.value.as_ref().map(|load| load.source.as_str());
        let mut elements = Element::of(step, instruction, timer, source);
        if let Some(first) = elements.first_mut() {
            if asks_for_value(opcode) && self.value.is_some() {
                // The load right before it is part of its picture.
                if let Some(Node::Element(load)) = self.frame().series.last().cloned()
                    && self.is_load(load)
                {
                    self.frame().series.pop();
                    first
                        .steps
                        .splice(0..0, self.elements[load].steps.drain(..));
                    first.point = self.elements[load].point.or(first.point);
                }
            }
            self.value = match Load::of(instruction) {
                None => self
                    .value
                    .take()
                    .filter(|load| load.survives(first, opcode)),
                load => load,
            };
        }
        for element in elements {
            self.elements.push(element);
            let index = self.elements.len() - 1;
            self.frame().series.push(Node::Element(index));
        }
    }

    /// Whether this element, the last of its series, is the load that the value comes from.
    fn is_load(&self, element: usize) -> bool {
        let symbol = self.elements.get(element).map(|element| &element.symbol);
        match (symbol, &self.value) {
            (Some(crate::Symbol::Box { text, .. }), Some(load)) => {
                *text == Load::text(&load.source)
            }
            _ => false,
        }
    }

    fn close(&mut self, close: usize) {
        let Some(mut inner) = self.frames.pop() else {
            return;
        };
        inner.steps.push(close);
        let pure = self.is_pure(&inner.series);
        let outer = self.frame();
        match inner.gate {
            Gate::Or => {
                for (origin, path) in inner.into_paths() {
                    if let Err(path) =
                        join(&mut outer.series, Some(outer.origin), origin, path, close)
                    {
                        let before = Path::here(std::mem::take(&mut outer.series));
                        outer
                            .series
                            .push(Join::node(Gate::Or, vec![before, path], close, None));
                    }
                }
            }
            // In series is what it means, unless something inside looks at what stands before it.
            Gate::And if pure && inner.origin == Origin::Rail => {
                outer.series.push(Node::Block(inner.series, inner.steps));
            }
            Gate::And | Gate::Xor => {
                let gate = inner.gate;
                let (origin, mut path) = inner.into_path();
                let from = match (origin, place(&outer.series, origin)) {
                    _ if origin == outer.origin => Some(0),
                    (_, place) => place,
                };
                if from.is_some() {
                    path.start = Start::Here;
                }
                let before = Path::here(outer.series.split_off(from.unwrap_or(0)));
                let element = self.elements.len();
                self.elements.push(Element::gate(close, gate));
                let paths = vec![before, path];
                let join = Join::node(gate, paths, close, Some(element));
                self.frame().series.push(join);
            }
        }
    }

    /// Whether a series only conducts or does not, whatever stands before it.
    fn is_pure(&self, series: &Series) -> bool {
        series.iter().all(|node| match node {
            Node::Element(index) => self.elements[*index].role == Role::Condition,
            Node::Block(series, _) => self.is_pure(series),
            Node::Join(join) => {
                let path = |path: &Path| path.start == Start::Here && self.is_pure(&path.series);
                join.gate == Gate::Or && join.paths.iter().all(path)
            }
            _ => false,
        })
    }
}

impl Frame {
    fn new(gate: Gate, steps: Vec<usize>) -> Frame {
        Frame {
            gate,
            origin: Origin::Rail,
            series: Vec::new(),
            steps,
        }
    }

    /// It as one path, and where that begins.
    fn into_path(self) -> (Origin, Path) {
        // The step after which acc is what the path begins with: the last before the close.
        let entry = self.steps.iter().rev().nth(1).copied().unwrap_or(0);
        let path = Path {
            start: Start::At(self.origin, entry),
            series: self.series,
            steps: self.steps,
            net: Nets::RAIL,
        };
        (self.origin, path)
    }

    /// It as paths beside each other, and where each begins: several where it is nothing but such paths.
    fn into_paths(mut self) -> Vec<(Origin, Path)> {
        if self.series.len() != 1 || !self.series.iter_mut().all(|node| node.as_or().is_some()) {
            return vec![self.into_path()];
        }
        let mut paths = Vec::new();
        if let Some(Node::Join(join)) = self.series.pop() {
            let entry = self.steps.iter().rev().nth(1).copied().unwrap_or(0);
            for mut path in join.paths {
                let origin = match path.start {
                    Start::At(origin, _) => origin,
                    _ => self.origin,
                };
                if path.start == Start::Here {
                    path.start = Start::At(origin, entry);
                }
                path.steps.append(&mut self.steps);
                paths.push((origin, path));
            }
        }
        paths
    }
}

/// Where in a series a path from this origin branches off: after what has stored it.
fn place(series: &Series, origin: Origin) -> Option<usize> {
    let stored = |node: &Node| match node {
        Node::Store(store) => origin == Origin::Store(store.step),
        _ => false,
    };
    series.iter().position(stored).map(|index| index + 1)
}

/// Puts a path beside as much of the series as begins where it begins; gives it back where none of the
/// series does. `own` is where the series itself begins, as far as known.
fn join(
    series: &mut Series,
    own: Option<Origin>,
    origin: Origin,
    mut path: Path,
    close: usize,
) -> Result<(), Path> {
    let from = if own == Some(origin) {
        Some(0)
    } else {
        place(series, origin)
    };
    if let Some(from) = from {
        path.start = Start::Here;
        let mut before = series.split_off(from);
        if let [node] = &mut before[..]
            && let Some(join) = node.as_or()
        {
            join.paths.push(path);
            join.close = close;
            series.append(&mut before);
        } else {
            series.push(Join::node(
                Gate::Or,
                vec![Path::here(before), path],
                close,
                None,
            ));
        }
        return Ok(());
    }
    // What joins at the end of a join by wire may as well join at the end of one of its paths.
    if let Some(last) = series.last_mut().and_then(Node::as_or) {
        for beside in &mut last.paths {
            let own = match beside.start {
                Start::At(origin, _) => Some(origin),
                _ => None,
            };
            match join(&mut beside.series, own, origin, path, close) {
                Ok(()) => return Ok(()),
                Err(back) => path = back,
            }
        }
    }
    Err(path)
}
