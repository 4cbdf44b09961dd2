//! What a program without calls does with each of its cells, and where.
//!
//! Owns reads, stores, lives and the rows that computed subscripts ask for. Must not know registers and markers.

use super::flat::{Does, Flat, Step, each, own_expressions, within};
use std::collections::{HashMap, HashSet};
use std::ops::Range;
use unoclp_point::Address;
use unoclp_tree::{Expr, ExprKind, Order, Place, Standard, Value};

/// Of more cells than this none has a place, so that no more are looked at.
const MOST_CELLS: u32 = 300;
/// Where an edge remembers, among its cells.
pub(super) const EDGE_MEMORY: u32 = 2;
/// More loops than this have no labels.
const MOST_LOOPS: usize = 64;

/// What is done with one cell.
#[derive(Clone, Debug, Default)]
pub(super) struct Use {
    pub reads: u32,
    pub stores: u32,
    /// The first and the last step that names it.
    pub first: u32,
    pub last: u32,
    /// The first step that reads it.
    pub first_read: Option<u32>,
    /// The value of all its stores, if it is one constant.
    pub only: Option<Value>,
}

/// The calls of a block of the standard; none of a counter that is only told to count from another number.
#[derive(Clone, Copy, Debug)]
pub(super) struct Called {
    pub block: Standard,
    /// The first one.
    pub at: u32,
    /// Whether each scan comes to it.
    pub always: bool,
    pub count: u32,
}

#[derive(Debug, Default)]
pub(super) struct Uses {
    pub cells: HashMap<u32, Use>,
    /// Cells that stand in a row, since a subscript among them is computed.
    pub rows: Vec<Range<u32>>,
    pub blocks: HashMap<u32, Called>,
    /// Inputs of such blocks that are used in their calls alone, and their values where they are always the same.
    pub given: HashMap<u32, Option<i128>>,
    /// Blocks whose presets are set beside their calls.
    pub preset: HashSet<u32>,
    /// Timers whose time is looked at beside their calls, before each time that it is read.
    pub looked: HashSet<u32>,
    /// The points that instructions name by their codes.
    pub codes: Vec<Address>,
    position: u32,
    deep: u32,
    jumps: bool,
    labels: HashMap<u32, u32>,
    loops: Vec<(u32, u32)>,
}

impl Uses {
    pub(super) fn of(flat: &Flat) -> Uses {
        let mut uses = Uses::default();
        uses.steps(&flat.body);
        uses.edges();
        uses.times();
        uses.join_rows();
        uses.stretch();
        uses
    }

    /// What is done with this cell.
    pub(super) fn get(&self, cell: u32) -> Option<&Use> {
        self.cells.get(&cell)
    }

    /// Whether it stands in a row.
    pub(super) fn row_of(&self, cell: u32) -> Option<&Range<u32>> {
        let at = self.rows.partition_point(|row| row.end <= cell);
        self.rows.get(at).filter(|row| row.contains(&cell))
    }

    fn steps(&mut self, steps: &[Step]) {
        for step in steps {
            self.position += 1;
            self.step(&step.does);
            self.deep += 1;
            for inner in within(&step.does) {
                self.steps(inner);
            }
            self.deep -= 1;
        }
    }

    /// A code of the board remembers for itself; an edge that is called again has a memory for all its calls.
    fn edges(&mut self) {
        for called in self.blocks.values_mut() {
            let mut loops = self.loops.iter();
            // Each turn of a loop is a call; to a timer all of them are one, since it knows times alone.
            if !called.block.is_timer()
                && loops.any(|(begin, end)| (*begin..=*end).contains(&called.at))
            {
                called.count += 1;
            }
        }
        let again = self.blocks.iter();
        let again = again.filter(|(_, called)| called.block.is_edge() && called.count > 1);
        let memories: Vec<u32> = again.map(|(cell, _)| cell + EDGE_MEMORY).collect();
        for cell in memories {
            let of = self.touch(cell);
            of.reads += 1;
            of.stores += 1;
        }
    }

    /// What an off-delay shows when its time is over is its preset, which is read then.
    fn times(&mut self) {
        let blocks = self.blocks.iter();
        let off = blocks.filter(|(cell, called)| {
            let timed = called.block == Standard::Tof && self.preset.contains(cell);
            timed && self.cells.contains_key(&(**cell + 3)) && !self.looked.contains(cell)
        });
        let presets: Vec<u32> = off.map(|(cell, _)| cell + 1).collect();
        for cell in presets {
            let of = self.touch(cell);
            of.reads += 1;
            of.stores += 1;
        }
    }

    fn step(&mut self, does: &Does) {
        for expr in own_expressions(does) {
            self.expr(expr);
        }
        match does {
            Does::Assign(to, value, _) => self.stored(to, 1, Some(value)),
            Does::Copy(to, from, cells) => {
                self.named(from, *cells, true);
                self.stored(to, *cells, None);
            }
            Does::Label(label) => {
                self.labels.insert(*label, self.position);
            }
            Does::Jump(_, label, _) => {
                self.jumps = true;
                if let Some(&begin) = self.labels.get(label) {
                    self.loops.push((begin, self.position));
                }
            }
            Does::Standard(block, cell, inputs) => {
                for (part, value) in inputs {
                    let value = match &value.kind {
                        ExprKind::Constant(value) => Some(value.int()),
                        _ => None,
                    };
                    let known = self.given.entry(cell + part).or_insert(value);
                    *known = known.filter(|known| Some(*known) == value);
                }
                let always = self.deep == 0 && !self.jumps;
                let at = self.position;
                let called = self.block(*block, *cell);
                if called.count == 0 {
                    (called.at, called.always) = (at, always);
                }
                called.count += 1;
            }
            Does::Order(order, block, cell) => {
                if block.is_counter() {
                    self.block(*block, *cell);
                }
                match order {
                    Order::Preset(_) => self.preset.insert(*cell),
                    Order::Look => self.looked.insert(*cell),
                    Order::Reset | Order::Load | Order::Number(_) => false,
                };
            }
            Does::Codes(_, codes, behind) => {
                self.codes.extend(super::codes::named(codes));
                if let Some(cell) = behind {
                    let of = self.touch(*cell);
                    of.stores += 1;
                    of.only = None;
                }
            }
            Does::If(..) | Does::Case(..) | Does::Fail => {}
        }
    }

    fn block(&mut self, block: Standard, cell: u32) -> &mut Called {
        let at = self.position;
        self.blocks.entry(cell).or_insert(Called {
            block,
            at,
            always: false,
            count: 0,
        })
    }

    fn expr(&mut self, expr: &Expr) {
        each(expr, &mut |e| {
            if let ExprKind::Read(place) = &e.kind {
                self.named(place, 1, true);
            }
        });
    }

    /// Each cell that a place may be.
    fn named(&mut self, place: &Place, cells: u32, read: bool) {
        let reach = reach(place).saturating_add(cells);
        if !place.indices.is_empty() {
            let end = place.offset.saturating_add(reach);
            self.rows.push(place.offset..end);
        }
        let position = self.position;
        let end = place.offset.saturating_add(reach.min(MOST_CELLS));
        for cell in place.offset..end {
            let of = self.touch(cell);
            if read {
                of.reads += 1;
                of.first_read.get_or_insert(position);
            }
        }
    }

    fn stored(&mut self, place: &Place, cells: u32, value: Option<&Expr>) {
        self.named(place, cells, false);
        let value = match value.map(|value| &value.kind) {
            Some(ExprKind::Constant(value)) if place.indices.is_empty() => Some(value),
            _ => None,
        };
        let reach = reach(place).saturating_add(cells).min(MOST_CELLS);
        for cell in place.offset..place.offset.saturating_add(reach) {
            let Some(of) = self.cells.get_mut(&cell) else {
                continue;
            };
            of.only = match (of.stores, &of.only) {
                (0, _) => value.cloned(),
                (_, Some(only)) if Some(only) == value => value.cloned(),
                _ => None,
            };
            of.stores += 1;
        }
    }

    fn touch(&mut self, cell: u32) -> &mut Use {
        let position = self.position;
        let of = self.cells.entry(cell).or_insert(Use {
            first: position,
            ..Use::default()
        });
        of.last = position;
        of
    }

    fn join_rows(&mut self) {
        self.rows.sort_by_key(|row| row.start);
        let mut joined: Vec<Range<u32>> = Vec::new();
        for row in self.rows.drain(..) {
            match joined.last_mut() {
                Some(last) if row.start < last.end => last.end = last.end.max(row.end),
                _ => joined.push(row),
            }
        }
        self.rows = joined;
    }

    /// What a loop finds, it needs to its end.
    fn stretch(&mut self) {
        let loops = std::mem::take(&mut self.loops);
        if loops.len() > MOST_LOOPS {
            return;
        }
        let mut changed = true;
        while changed {
            changed = false;
            for &(begin, end) in &loops {
                for of in self.cells.values_mut() {
                    if of.first < begin && (begin..end).contains(&of.last) {
                        of.last = end;
                        changed = true;
                    }
                }
            }
        }
    }
}

/// How far the subscripts of a place reach.
pub(super) fn reach(place: &Place) -> u32 {
    let far = |index: &unoclp_tree::Index| {
        let last = index.count.saturating_sub(1);
        last.saturating_mul(index.stride)
    };
    let all = place.indices.iter().map(far);
    all.fold(0, u32::saturating_add)
}
