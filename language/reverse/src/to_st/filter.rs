//! The input filter: an input is what its pin has been for some time.
//!
//! Owns the statements before all others that say so. Must not know what the inputs are for.

use super::expr::{Expr, Place, Type, and, not, or};
use super::statement::{Statement, places};
use std::collections::BTreeSet;
use unoclp_core::Instruction;
use unoclp_core::isa::Opcode;
use unoclp_point::Address;

/// For how many ms an input must keep a level; none where inputs are not filtered. Of several, the last holds.
pub(super) fn time(steps: &[Instruction<'_>]) -> Option<u8> {
    let mut filters = steps
        .iter()
        .filter(|step| step.opcode == Opcode::InputFilter);
    let last = filters.next_back()?.number();
    last.filter(|time| *time > 0)
}

/// What filters the inputs that these statements read.
pub(super) fn statements(time: u8, all: &[Statement]) -> Vec<Statement> {
    let mut inputs = BTreeSet::new();
    places(all, &mut |place| {
        if let Place::At(Address::Input(input)) = place {
            inputs.insert(input);
        }
    });
    inputs
        .into_iter()
        .flat_map(|input| of(input, time))
        .collect()
}

/// A timer for each direction: a level that comes back begins again.
fn of(input: u8, time: u8) -> [Statement; 3] {
    let (pin, is) = (
        Expr::Place(Place::Pin(input)),
        Expr::at(Address::Input(input)),
    );
    let keeps = |timer, on| {
        let time = Expr::Constant(time.into(), Type::Time);
        Statement::Call(timer, vec![("IN", on), ("PT", time)], None)
    };
    let (on, off) = (Place::FilterOn(input), Place::FilterOff(input));
    let first = Expr::at(Address::System(1));
    let takes = or(or(first, Expr::Place(on)), Expr::Place(off));
    [
        keeps(on, and(pin.clone(), not(is.clone()))),
        keeps(off, and(is, not(pin.clone()))),
        Statement::If(
            takes,
            vec![Statement::Assign(Place::At(Address::Input(input)), pin)],
            Vec::new(),
        ),
    ]
}
