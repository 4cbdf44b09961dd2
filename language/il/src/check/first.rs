//! What variables begin with. What cannot be given has been told by `names`.

use super::front::Front;
use crate::ast::{Init, Var};
use crate::names::{kept, narrow_type};
use std::sync::Arc;
use unoclp_point::Address;
use unoclp_tree::build::Named;
use unoclp_tree::{Base, Initial, Kind, Standard, TypeId, Value};

impl Front<'_, '_> {
    /// With what a variable of this type begins; none of one that begins as its type does.
    pub(super) fn initial(
        &self,
        var: &Var,
        ty: TypeId,
        point: Option<Address>,
    ) -> Option<Arc<Initial>> {
        if point.is_some_and(|point| !point.is_written()) {
            return None;
        }
        match self.c.builder.tree.types.kind(ty) {
            Kind::Standard(block) => {
                let declared = var.init.last().and_then(|init| init.value.number());
                let key = var.name.text.trim_start_matches('%');
                let used = || self.used.get(key).preset().filter(|_| block.is_counter());
                preset(*block, declared.or_else(used)?)
            }
            Kind::Block(unit) => {
                let draft = self.c.builder.draft(*unit)?;
                let member = |init: &Init| {
                    let name = init.name.as_ref()?;
                    let Some(Named::Variable(variable)) = draft.names.get(&name.text) else {
                        return None;
                    };
                    let base = self.c.builder.tree.types.base(variable.ty)?;
                    let value = scalar(base, init.value.number()?)?;
                    Some((variable.offset, variable.ty, Arc::new(value)))
                };
                let members: Vec<_> = var.init.iter().filter_map(member).collect();
                (!members.is_empty()).then(|| Arc::new(Initial::Members(members)))
            }
            _ => {
                let base = self.c.builder.tree.types.base(ty)?;
                let number = kept(narrow_type(&var.ty.text), var.init.last()?.value.number()?);
                scalar(base, number).map(Arc::new)
            }
        }
    }
}

/// A timer or counter that begins with this preset.
pub(super) fn preset(block: Standard, number: i32) -> Option<Arc<Initial>> {
    let offset = block.preset()?;
    let (_, base, _) = block.parts().get(offset as usize)?;
    let value = Arc::new(Initial::Value(Value::Int(number.into())));
    let members = vec![(offset, TypeId::of(*base), value)];
    Some(Arc::new(Initial::Members(members)))
}

fn scalar(base: Base, number: i32) -> Option<Initial> {
    let value = match base {
        Base::Bool => Value::truth(number != 0),
        base => unoclp_tree::narrow(base, Value::Int(number.into())),
    };
    Some(Initial::Value(value))
}

/// The part of a block that a name of the text means, whoever's it is.
pub(super) fn part(block: Standard, member: &str) -> Option<&'static str> {
    use Standard::{Counter, FTrig, RTrig, Rs, Sr, Tof, Ton, Tonr, Tp};
    Some(match (block, member) {
        (Ton | Tof | Tp | Tonr, "Q") => "Q",
        (Ton | Tof | Tp | Tonr, "ET" | "V") => "ET",
        (Ton | Tof | Tp | Tonr, "PT" | "P") => "PT",
        (Ton | Tof | Tp | Tonr, "IN") => "IN",
        (Counter, "Q" | "QU" | "D") => "QU",
        (Counter, "QD") => "QD",
        (Counter, "CV" | "V") => "CV",
        (Counter, "PV" | "P") => "PV",
        (Counter, "CU") => "CU",
        (Counter, "CD") => "CD",
        (Counter, "R" | "RESET") => "R",
        (Counter, "LD" | "LOAD") => "LD",
        (RTrig | FTrig, "Q") => "Q",
        (RTrig | FTrig, "CLK") => "CLK",
        (Sr | Rs, "Q" | "Q1") => "Q1",
        (Sr, "S" | "S1" | "SET" | "SET1") => "S1",
        (Sr, "R" | "R1" | "RESET" | "RESET1") => "R",
        (Rs, "S" | "S1" | "SET" | "SET1") => "S",
        (Rs, "R" | "R1" | "RESET" | "RESET1") => "R1",
        _ => return None,
    })
}
