//! The end: no unit calls itself, and each function has a result.

use super::builder::Builder;
use crate::diagnostics::{Code, Span};
use crate::typed::{Tree, UnitKind};
use std::collections::HashSet;

/// Calls stand in calls no deeper.
const MOST_CALLS: u32 = 60;

impl Builder<'_, '_> {
    /// The tree; none where errors have been told.
    pub fn finish(mut self) -> Option<Tree> {
        self.refuse_circles();
        self.refuse_second_calls();
        for draft in &self.drafts {
            let unit = &draft.unit;
            let told = self.found.has_errors();
            if unit.kind == UnitKind::Function && !draft.gives && !told {
                let name = unit.name.as_str().into();
                self.found.tell(Code::StNoResult, unit.at, [name]);
            }
        }
        if !self.writes && !self.found.has_errors() && !self.tree.programs.is_empty() {
            let end = self.text.trim_end().len() as u32;
            let end = Span { start: end, end };
            self.tell(Code::StNothingWritten, end, []);
        }
        self.make_symbols();
        let units = std::mem::take(&mut self.drafts);
        self.tree.units = units.into_iter().map(|draft| draft.unit).collect();
        (!self.found.has_errors()).then_some(self.tree)
    }

    /// An instance that has timers or counters within has one call, not in a loop, as these have.
    fn refuse_second_calls(&mut self) {
        if self.found.has_errors() {
            return;
        }
        // To the depth of the calls, each turn finds those one further out.
        loop {
            let mut more = false;
            for call in &self.calls {
                let within = self.drafts.get(call.unit as usize);
                let once = within.is_some_and(|of| of.once);
                let Some(caller) = call.from.and_then(|unit| self.drafts.get_mut(unit)) else {
                    continue;
                };
                more |= once && !caller.once;
                caller.once |= once;
            }
            if !more {
                break;
            }
        }
        let mut seen = HashSet::new();
        for call in std::mem::take(&mut self.calls) {
            let draft = self.drafts.get(call.unit as usize);
            let Some(draft) = draft.filter(|draft| draft.once) else {
                continue;
            };
            let words = || {
                [
                    self.written(call.at).into(),
                    draft.unit.name.as_str().into(),
                ]
            };
            let (first, words) = (seen.insert(call.instance), words());
            if call.in_loop {
                self.found.tell(Code::StCalledInLoop, call.at, words);
            } else if !first {
                self.found.tell(Code::StCalledTwice, call.at, words);
            }
        }
    }

    /// No unit may come to call itself.
    fn refuse_circles(&mut self) {
        let mut out: Vec<Vec<(u32, Span)>> = vec![Vec::new(); self.drafts.len()];
        for &(from, to, at) in &self.edges {
            if let Some(calls) = out.get_mut(from as usize) {
                calls.push((to, at));
            }
        }
        // 0: not seen, 1: on the way, 2: done.
        let mut state = vec![0_u8; self.drafts.len()];
        // How many calls within calls each comes to.
        let mut deep = vec![0_u32; self.drafts.len()];
        for first in 0..self.drafts.len() {
            if state[first] != 0 {
                continue;
            }
            state[first] = 1;
            let mut way = vec![(first, 0)];
            while let Some((unit, next)) = way.pop() {
                let Some(&(to, at)) = out[unit].get(next) else {
                    state[unit] = 2;
                    let below = out[unit]
                        .iter()
                        .map(|(to, _)| deep.get(*to as usize).copied().unwrap_or(0));
                    deep[unit] = below.max().unwrap_or(0) + 1;
                    if deep[unit] == MOST_CALLS {
                        let at = out[unit].first().map_or(Span::default(), |call| call.1);
                        self.found.tell(Code::StTooDeep, at, []);
                    }
                    continue;
                };
                way.push((unit, next + 1));
                let to = to as usize;
                match state.get(to) {
                    Some(0) => {
                        state[to] = 1;
                        way.push((to, 0));
                    }
                    Some(1) => {
                        let name = self.drafts[to].unit.name.as_str().into();
                        let calls = ("calls", "chama").into();
                        self.found.tell(Code::StRecursive, at, [name, calls]);
                    }
                    _ => {}
                }
            }
        }
    }
}
