//! What each block is: a function block, a function, of the standard or of the project.

use super::units::Units;
use crate::network::Network;
use unoclp_lang::typed::is_function;

/// What a block is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum What {
    /// A function block.
    Block,
    /// A function of the project.
    Own,
    /// A comparison, or another function of the standard that gives a truth at once.
    Truth,
    /// A function of the standard.
    Function,
    /// It is not known.
    Unknown,
    /// No block at all.
    Other,
}

impl What {
    pub(super) fn is_function(self) -> bool {
        matches!(self, What::Own | What::Truth | What::Function)
    }
}

/// What each element is.
pub(super) fn own(network: &Network<'_, '_>, units: &Units<'_, '_, '_>) -> Vec<What> {
    let elements = network.elements.iter();
    let what = elements.map(|element| {
        if element.kind != "block" {
            return What::Other;
        }
        let name = element.block();
        match units.get(&name) {
            _ if units.is_block(element) => What::Block,
            Some(_) => What::Own,
            None if matches!(&*name, "GT" | "GE" | "EQ" | "NE" | "LE" | "LT") => What::Truth,
            None if is_function(&name) => What::Function,
            None => What::Unknown,
        }
    });
    what.collect()
}
