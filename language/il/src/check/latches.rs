//! SR and RS.

use super::edges::named;
use super::walk::Walk;
use crate::ast::{Operand, Param};
use unoclp_text::diagnostics::{Code, Span};
use unoclp_tree::Standard;
use unoclp_tree::build::Target;

impl Walk<'_, '_, '_> {
    /// `CAL a (S1:=I1, R:=I2, Q1=>Q1)`
    pub(super) fn call_latch(
        &mut self,
        operand: &Operand,
        target: Target,
        block: Standard,
        params: &[Param],
        span: Span,
    ) {
        let (has, [set_part, reset_part]) = match block {
            Standard::Sr => (
                (
                    "its inputs are S1 and R, its output Q1",
                    "as entradas são S1 e R; a saída, Q1",
                ),
                ["S1", "R"],
            ),
            _ => (
                (
                    "its inputs are S and R1, its output Q1",
                    "as entradas são S e R1; a saída, Q1",
                ),
                ["S", "R1"],
            ),
        };
        let name = self.spelled(operand);
        let mut all = Vec::new();
        let [mut sets, mut resets] = [false; 2];
        for (index, param) in params.iter().enumerate() {
            let called = param.name.as_ref().map(|name| name.text.as_str());
            match called.or(["S", "R"].get(index).copied()) {
                Some("Q1" | "Q") if param.out => {}
                Some("S" | "S1" | "SET" | "SET1") if !param.out => {
                    sets = true;
                    all.extend(self.param_bit(param).map(|bit| named(set_part, bit)));
                }
                Some("R" | "R1" | "RESET" | "RESET1") if !param.out => {
                    resets = true;
                    all.extend(self.param_bit(param).map(|bit| named(reset_part, bit)));
                }
                _ => self.no_parameter(&name, param, has),
            }
        }
        let spelt = ["S", "S1", "SET", "SET1", "R", "R1", "RESET", "RESET1"];
        let mut spelt = spelt.iter();
        if !sets && !resets && !spelt.any(|part| self.front.names.stores(&name, part)) {
            let needs = (
                "a value for its set input and its reset input",
                "um valor na entrada que o liga e na que o desliga",
            );
            let words = [name.as_str().into(), needs.into()];
            return self.tell(Code::ParameterMissing, span, words);
        }
        self.front.writes = true;
        self.run_block(&target, all, span);
        for param in params.iter().filter(|param| param.out) {
            if let Some(q) = self.part_of(target.clone(), block, "Q1") {
                let q = self.read(q, span);
                self.store_value(q, &param.value, param.negated);
            }
        }
    }
}
