//! What is known only at the end of a text.

use super::Lower;
use crate::diagnostics::Code;
use crate::rung::Written;

impl Lower<'_, '_> {
    pub(super) fn finish(&mut self) {
        self.timers_never_called();
        self.inputs_never_read();
        self.resolve_timers();
        self.names.temps = self.rungs.temps;
    }

    /// Where something else is wrong, the call may be what is wrong.
    fn timers_never_called(&mut self) {
        if self.found.has_errors() {
            return;
        }
        for timer in &self.names.timers {
            if let (None, Some(span)) = (&timer.called, timer.read) {
                self.found
                    .tell(Code::NeverCalled, span, [timer.name.as_str().into()]);
            }
        }
    }

    fn inputs_never_read(&mut self) {
        for declared in &self.names.inputs {
            if self.names.inputs_read >> (declared.input - 1) & 1 == 0 {
                let name = declared.name.as_str();
                self.found
                    .tell(Code::NeverRead, declared.span, [name.into()]);
            }
        }
    }

    /// A code above a timer's block means the block below.
    fn resolve_timers(&mut self) {
        for step in &mut self.rungs.steps {
            if let Written::OfTimer(_, timer, block @ None) = &mut step.written {
                *block = self.rungs.blocks.get(*timer).copied().flatten();
            }
        }
    }
}
