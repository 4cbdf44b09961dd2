//! Counters that take more than one result of the stack.

use crate::ast::Instr;
use crate::operators::Op;
use unoclp_text::Dialect;

/// How many results below the top a counter takes in the S7-200's form, `CTU C2, 20`.
pub(super) fn more_inputs(op: Op, instr: &Instr, dialect: Dialect) -> usize {
    match op {
        Op::OmronCounter => 1,
        _ if dialect != Dialect::S7200 => 0,
        Op::CountUp | Op::CountDown if instr.operands.len() == 2 => 1,
        Op::CountUpDown if instr.operands.len() == 2 => 2,
        _ => 0,
    }
}
