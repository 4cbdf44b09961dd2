//! SR and RS, and inputs that were stored before a call.

use super::timers::lit;
use super::{Acc, Lower};
use crate::ast::Param;
use crate::diagnostics::{Code, Span};
use crate::names::Place;
use crate::tree::{Bit, Expr};
use unoclp_core::isa::Opcode;
use unoclp_point::Address;

impl Lower<'_, '_> {
    /// An input of a block that the text stores to.
    pub(super) fn wired(
        &mut self,
        place: Place,
        name: &str,
        input: &str,
        span: Span,
    ) -> Option<Expr> {
        // Names get markers that no intermediate result has had.
        self.names.temps = self.rungs.temps;
        let place = self.names.wired(place, name, input);
        self.rungs.temps = self.names.temps;
        match place {
            Some(Place::Bit(bit)) => Some(Expr::Lit {
                bit,
                negated: false,
                span,
            }),
            _ => None,
        }
    }

    /// `CAL a (S1:=I1, R:=I2, Q1=>Q1)`: what wins is done last.
    pub(super) fn call_latch(&mut self, place: Place, name: &str, params: &[Param], span: Span) {
        let Place::Latch(set_wins, marker) = place else {
            return;
        };
        let has = match set_wins {
            true => ("it has S1 and R, and gives Q1", "tem S1 e R, e dá Q1"),
            false => ("it has S and R1, and gives Q1", "tem S e R1, e dá Q1"),
        };
        let (mut set, mut reset) = (None, None);
        let [mut sets, mut resets] = [false; 2];
        for (index, param) in params.iter().enumerate() {
            let called = param.name.as_ref().map(|name| name.text.as_str());
            match called.or(["S", "R"].get(index).copied()) {
                Some("Q1" | "Q") if param.out => {}
                Some("S" | "S1" | "SET" | "SET1") if !param.out => {
                    sets = true;
                    set = self.param_bit(param);
                }
                Some("R" | "R1" | "RESET" | "RESET1") if !param.out => {
                    resets = true;
                    reset = self.param_bit(param);
                }
                _ => self.no_parameter(name, param, has),
            }
        }
        if !sets {
            set = self.wired(place, name, "S", span);
        }
        if !resets {
            reset = self.wired(place, name, "R", span);
        }
        if !sets && !resets && set.is_none() && reset.is_none() {
            let needs = ("what sets and resets it", "o que o liga e o desliga");
            return self
                .found
                .tell(Code::ParameterMissing, span, [name.into(), needs.into()]);
        }
        self.writes = true;
        self.freeze(span);
        let (set, reset) = ((set, Opcode::SetMarker), (reset, Opcode::ResetMarker));
        let (first, (mut last, wins)) = if set_wins { (reset, set) } else { (set, reset) };
        // What wins may ask for the state before.
        if let Some(expr) = &last
            && first.0.is_some()
            && expr.reads(&|bit| bit == Bit::At(Address::Marker(marker)))
        {
            last = Some(self.fixed_bit(expr.clone(), span));
        }
        for (expr, opcode) in [first, (last, wins)] {
            if let Some(expr) = expr {
                self.rungs.logic(expr, span);
                self.write(opcode, marker, span);
            }
        }
        for param in params.iter().filter(|param| param.out) {
            let acc = lit(Bit::At(Address::Marker(marker)), span);
            self.store_to(acc, &param.value, param.negated, param.value.span);
        }
        self.acc = Acc::Empty;
    }
}
