//! Calls: what is given, lent and taken, and the body in their place.
//!
//! Owns the cells of a call.

use super::flat::{Does, constant, expr, place, read};
use super::inline::{Frame, Inliner, MOST_STEPS};
use super::pure;
use super::values::zero;
use std::collections::HashMap;
use unoclp_text::diagnostics::Span;
use unoclp_tree::{Base, Call, Convert, Expr, ExprKind, Input, Place, Store, Unit, UnitKind};

fn read_place(from: Place, _cells: u32) -> Expr {
    let at = from.at;
    expr(ExprKind::Read(Box::new(from)), Base::Dint, at)
}

/// Whether what is given may stand in the place of the parameter.
fn as_given(value: &Expr, store: Store, base: Base) -> bool {
    let plain = matches!(store, Store::Narrow(_)) && value.base == base;
    plain
        && match &value.kind {
            ExprKind::Constant(_) => true,
            ExprKind::Read(place) => place.indices.is_empty(),
            _ => false,
        }
}

fn narrowed(value: Expr, base: Base) -> Expr {
    match value.kind {
        ExprKind::Constant(held) => {
            let kind = ExprKind::Constant(unoclp_tree::narrow(base, held));
            Expr { kind, ..value }
        }
        _ => value,
    }
}

impl Inliner<'_, '_> {
    /// Makes the cells of a call of the unit of this number.
    pub(super) fn enter(&mut self, number: u32, unit: &Unit, own: u32, at: Span) -> Frame {
        let local = self.flat.cells.len() as u32;
        self.flat.calls.push((local, number));
        if self.flat.cells.len() > 100_000 {
            self.too_large.get_or_insert(at);
        } else {
            self.flat.cells.extend(unit.locals.iter().cloned());
        }
        Frame {
            own,
            local,
            ..Frame::default()
        }
    }

    /// Gives each local its first value that is not stored before it is read.
    fn begin(&mut self, unit: &Unit, frame: &Frame, stored: &[u32]) {
        for (offset, cell) in (0..).zip(&unit.locals) {
            let known = cell.scratch || stored.contains(&offset);
            if known || pure::is_stored_first(unit, offset) {
                continue;
            }
            let value = constant(cell.initial.clone(), cell.base, unit.at);
            let to = place(frame.local + offset, unit.at);
            self.push(Does::Assign(to, value, Store::Narrow(cell.base)), unit.at);
        }
    }

    pub(super) fn body(&mut self, unit: &Unit, frame: &mut Frame) {
        if unit.kind != UnitKind::Function {
            self.begin(unit, frame, &[]);
        }
        let loops = std::mem::take(&mut self.loops);
        for target in pure::targets(unit) {
            let label = self.label();
            frame.targets.insert(target, label);
        }
        let count = unit.body.len() as u32;
        for (number, statement) in (0..).zip(&unit.body) {
            if self.too_large.is_some() {
                break;
            }
            self.target(frame, number, statement.at);
            self.statement(statement, frame);
        }
        self.target(frame, count, unit.at);
        if let Some(end) = frame.end.filter(|_| frame.ended) {
            self.push(Does::Label(end), unit.at);
        }
        self.loops = loops;
    }

    fn target(&mut self, frame: &Frame, number: u32, at: Span) {
        if let Some(&label) = frame.targets.get(&number) {
            self.push(Does::Label(label), at);
        }
    }

    /// A place whose subscripts are computed now.
    fn settled(&mut self, mut place: Place) -> Place {
        for index in &mut place.indices {
            let subscript = std::mem::replace(&mut index.subscript, zero());
            index.subscript = self.aside(subscript);
        }
        place
    }

    /// Calls a unit of the text; the cell of a function's result.
    pub(super) fn call(&mut self, call: &Call, frame: &Frame) -> Option<u32> {
        let tree = self.tree;
        let unit = tree.units.get(call.unit as usize)?;
        // A call of what does nothing counts too, so that calls in calls come to an end.
        self.steps += 1;
        if self.steps > MOST_STEPS {
            self.too_large.get_or_insert(call.at);
        }
        if self.too_large.is_some() {
            return None;
        }
        let own = match &call.instance {
            Some(instance) => self.place(instance, frame).offset,
            None => 0,
        };
        let is_pure = self.pure.get(call.unit as usize).copied().unwrap_or(true);
        let many = call.inputs.len() > 1 && !is_pure;
        let mut given = HashMap::new();
        let mut values = Vec::with_capacity(call.inputs.len());
        let mut stored = Vec::new();
        for input in &call.inputs {
            match input {
                Input::Value(offset, value, store) => {
                    let value = self.expr(value, frame);
                    let simple = is_pure && call.instance.is_none();
                    let simple = simple && !pure::is_written(unit, *offset);
                    match unit.locals.get(*offset as usize) {
                        Some(cell) if simple && as_given(&value, *store, cell.base) => {
                            given.insert(*offset, narrowed(value, cell.base));
                        }
                        _ => {
                            let value = if many { self.aside(value) } else { value };
                            values.push((*offset, value, *store));
                        }
                    }
                    stored.push(*offset);
                }
                Input::Cells(offset, from, cells) => {
                    let from = self.place(from, frame);
                    stored.extend(*offset..*offset + *cells);
                    values.push((*offset, read_place(from, *cells), Store::Text(*cells)));
                }
            }
        }
        let mut lent = Vec::with_capacity(call.lent.len());
        for place in &call.lent {
            let place = self.place(place, frame);
            lent.push(self.settled(place));
        }
        let mut outputs = Vec::with_capacity(call.outputs.len());
        for output in &call.outputs {
            let to = self.place(&output.to, frame);
            outputs.push(self.settled(to));
        }
        let mut callee = self.enter(call.unit, unit, own, call.at);
        (callee.lent, callee.given) = (lent, given);
        let base = match call.instance {
            Some(_) => own,
            None => callee.local,
        };
        if unit.kind == UnitKind::Function {
            self.begin(unit, &callee, &stored);
        }
        for (offset, value, store) in values {
            let to = place(base + offset, value.at);
            let at = value.at;
            match (value.kind, store) {
                (ExprKind::Read(from), Store::Text(cells)) => {
                    self.push(Does::Copy(to, *from, cells), at);
                }
                (kind, store) => {
                    let value = Expr { kind, ..value };
                    self.push(Does::Assign(to, value, store), at);
                }
            }
        }
        let before = self.brought;
        if unit.at == Span::default() {
            self.brought.get_or_insert(call.at);
        }
        self.body(unit, &mut callee);
        self.brought = before;
        for (output, to) in call.outputs.iter().zip(outputs) {
            let from = callee.local + output.from;
            match output.value {
                None => {
                    let from = place(from, call.at);
                    self.push(Does::Copy(to, from, output.cells), call.at);
                }
                Some((base, how, store)) => {
                    let (Store::Narrow(target) | Store::Within(target, ..)) = store else {
                        continue;
                    };
                    let value = read(from, base, call.at);
                    let value = match how {
                        Convert::Keep if base == target => value,
                        _ => expr(ExprKind::Convert(how, Box::new(value)), target, call.at),
                    };
                    self.show(Does::Assign(to, value, store), call.at);
                }
            }
        }
        (!unit.locals.is_empty()).then_some(callee.local)
    }
}
