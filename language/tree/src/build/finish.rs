//! The end: no unit calls itself, and each function has a result.

use super::builder::Builder;
use crate::{Tree, UnitKind};
use unoclp_text::diagnostics::{Code, Span};

/// Calls stand in calls no deeper.
const MOST_CALLS: u32 = 60;

impl Builder<'_, '_> {
    /// The tree; none where errors have been told.
    pub fn finish(mut self) -> Option<Tree> {
        self.refuse_circles();
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
        self.read_stored_inputs();
        self.make_symbols();
        let units = std::mem::take(&mut self.drafts);
        self.tree.units = units.into_iter().map(|draft| draft.unit).collect();
        (!self.found.has_errors()).then_some(self.tree)
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
