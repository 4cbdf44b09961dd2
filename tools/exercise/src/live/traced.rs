//! Lines of a text with statements: each shows the condition that it tests, else what it stores.
//!
//! Owns which of the traces of a line speaks for it. Must not know how a statement is compiled.

use super::{Flow, Mark};
use std::collections::BTreeMap;
use unoclp_program::{Shows, Source, Trace, Variable, literal};

/// The lines of a text, with the traces that speak for each.
pub(super) struct Traced {
    lines: BTreeMap<usize, Vec<Trace>>,
    variables: Vec<Variable>,
}

impl Traced {
    pub(super) fn new(program: &Source) -> Traced {
        let mut lines: BTreeMap<usize, Vec<Trace>> = BTreeMap::new();
        for trace in &program.traces {
            lines.entry(trace.line).or_default().push(trace.clone());
        }
        for traces in lines.values_mut() {
            // The first that the line tests, however often it is compiled; without one, whatever it stores.
            let tested = traces.iter().filter(|trace| trace.tests);
            if let Some(first) = tested.map(|trace| trace.column).min() {
                traces.retain(|trace| trace.tests && trace.column == first);
            }
            traces.sort_by_key(|trace| trace.step);
        }
        Traced {
            lines,
            variables: program.variables.clone(),
        }
    }

    /// The first line of which there is something to tell, counted from 0.
    pub(super) fn first(&self) -> usize {
        self.lines.keys().next().map_or(0, |line| line - 1)
    }

    /// What this line, from 1, has come to.
    pub(super) fn mark(&self, line: usize, flow: &Flow) -> Mark {
        let traces = self.lines.get(&line);
        let traces = traces.into_iter().flatten().rev();
        let mut marks = traces.filter_map(|trace| self.shown(trace, flow));
        marks.next().unwrap_or(Mark::Power(None))
    }

    /// What a trace shows, if the scan has come there.
    fn shown(&self, trace: &Trace, flow: &Flow) -> Option<Mark> {
        match trace.shows {
            Shows::Power { inverted } => {
                let acc = flow.acc(trace.step)?;
                Some(Mark::Power(Some(acc != inverted)))
            }
            Shows::Bit { when, to } => {
                flow.value_where(trace.step, when)?;
                Some(Mark::Power(Some(to)))
            }
            Shows::Counter { number, zero } => {
                flow.acc(trace.step)?;
                let counter = flow.counter(number)?;
                let is_on = if zero { counter.value <= 0 } else { counter.q };
                Some(Mark::Power(Some(is_on)))
            }
            Shows::Truth => {
                let value = flow.value_where(trace.step, true)?;
                Some(Mark::Power(Some(value != 0)))
            }
            Shows::Number { base, variable } => {
                let bits = flow.value_where(trace.step, true)?;
                let variable = variable.and_then(|index| self.variables.get(index));
                Some(Mark::Value(Some(literal(bits, base, variable))))
            }
        }
    }
}
