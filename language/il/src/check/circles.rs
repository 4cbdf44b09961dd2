//! Units that come to call themselves, which would never end.

use super::front::{Front, MOST_WITHIN};
use crate::ast::{Instr, Stmt};
use crate::operators::Op;
use unoclp_text::diagnostics::{Code, Span};

impl Front<'_, '_> {
    /// Tells of each call that leads back to where it came from; whether there is one.
    pub(super) fn refuse_circles(&mut self) -> bool {
        let calls: Vec<Vec<(usize, Span)>> = (0..self.units.len())
            .map(|unit| self.calls_of(unit))
            .collect();
        let mut on_way = vec![false; calls.len()];
        let mut done = vec![false; calls.len()];
        let mut any = false;
        for first in 0..calls.len() {
            let mut way = vec![(first, 0)];
            while let Some((unit, next)) = way.pop() {
                if next == 0 && std::mem::replace(&mut done[unit], true) {
                    continue;
                }
                on_way[unit] = true;
                self.called[unit] |= first == 0;
                let Some(&(to, at)) = calls[unit].get(next) else {
                    on_way[unit] = false;
                    continue;
                };
                way.push((unit, next + 1));
                if on_way[to] {
                    let (name, _) = self.unit_name(to);
                    self.tell(Code::Recursive, at, [name.into()]);
                    any = true;
                } else {
                    way.push((to, 0));
                }
            }
        }
        if !any {
            self.refuse_deep(&calls);
        }
        any
    }

    /// Tells of the first call that goes too deep. Nothing calls itself.
    fn refuse_deep(&mut self, calls: &[Vec<(usize, Span)>]) {
        let mut depths = vec![0; calls.len()];
        let mut todo = vec![0];
        while let Some(unit) = todo.pop() {
            for &(to, at) in &calls[unit] {
                let depth = depths[unit] + 1;
                if depth > MOST_WITHIN {
                    return self.tell(Code::CallsTooDeep, at, []);
                }
                if depth > depths[to] {
                    depths[to] = depth;
                    todo.push(to);
                }
            }
        }
    }

    /// The units that a unit calls, and where.
    fn calls_of(&self, unit: usize) -> Vec<(usize, Span)> {
        let called = |stmt: &Stmt| match stmt {
            Stmt::Instr(instr) => Some((self.callee(unit, instr)?, instr.whole)),
            _ => None,
        };
        self.units[unit].body.iter().filter_map(called).collect()
    }

    fn callee(&self, unit: usize, instr: &Instr) -> Option<usize> {
        if let Some(name) = &instr.function {
            return self.functions.get(name).copied();
        }
        let name = instr.operands.first()?.name()?;
        if instr.op != Op::Call {
            return None;
        }
        if let Some(&function) = self.functions.get(name) {
            return Some(function);
        }
        let mut vars = self.units[unit].vars.iter();
        let ty = &vars.find(|var| var.name.text == name)?.ty.text;
        self.block_named(ty)
    }
}
