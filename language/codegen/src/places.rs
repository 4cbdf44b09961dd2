//! Where the steps of a program stand in its text.
//!
//! Owns which unit, line, column, comments and name a step has; must not know how it was compiled, nor which
//! codes are operands: the loader says that.

use crate::origin::Origin;
use std::sync::Arc;
use unoclp_checked::{Place, SourceMap};
use unoclp_text::comments::Comments;
use unoclp_text::diagnostics::Lines;
use unoclp_tree::Units;

/// Makes the map of a text, code by code.
pub(crate) struct Places<'t> {
    text: &'t str,
    lines: &'t Lines,
    units: Units,
    comments: Comments,
    /// Where instructions begin whose comments go on to the next step, where they take none themselves.
    pub instructions: Vec<u32>,
    map: SourceMap,
}

impl<'t> Places<'t> {
    pub(crate) fn new(
        text: &'t str,
        lines: &'t Lines,
        units: Units,
        comments: Comments,
    ) -> Places<'t> {
        Places {
            text,
            lines,
            units,
            instructions: Vec::new(),
            map: SourceMap {
                title: comments.title(),
                steps: Vec::new(),
            },
            comments,
        }
    }

    /// A step begins with this code, in this line of the program file.
    pub(crate) fn begin(&mut self, origin: &Origin, line_of_code: u32) {
        let span = origin.span;
        let (line, column) = self.lines.place(self.text, span.start);
        let line = line as usize;
        self.map.steps.push(Place {
            unit: self.unit_at(span.start),
            line,
            column: column as usize,
            last: line,
            comments: self.comments.take_above(line),
            name: origin.name.clone(),
            codes: line_of_code..=line_of_code,
        });
    }

    /// The function or function block that stands there.
    fn unit_at(&self, start: u32) -> Option<Arc<str>> {
        let behind = self
            .units
            .partition_point(|(bytes, _)| bytes.start <= start);
        let unit = behind.checked_sub(1).and_then(|at| self.units.get(at))?;
        unit.0.contains(&start).then(|| unit.1.clone())
    }

    /// This line of the program file is an operand of the step that began last.
    pub(crate) fn operand(&mut self, origin: &Origin, line_of_code: u32) {
        if let Some(place) = self.map.steps.last_mut() {
            place.codes = *place.codes.start()..=line_of_code;
            place.last = place.last.max(self.lines.line(origin.span.start) as usize);
        }
    }

    pub(crate) fn finish(mut self) -> SourceMap {
        for start in std::mem::take(&mut self.instructions) {
            let line = self.lines.line(start) as usize;
            let unit = self.unit_at(start);
            let behind = |step: &&mut Place| step.line >= line && step.unit == unit;
            let steps = self.map.steps.iter_mut().filter(behind);
            if let Some(step) = steps.min_by_key(|step| step.line) {
                let mut above = self.comments.take_above(line);
                above.append(&mut step.comments);
                step.comments = above;
            }
        }
        self.map
    }
}
