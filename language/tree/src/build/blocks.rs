//! Calls of instances: blocks of the text and of the standard.
//!
//! Owns that an instance of a timer has one call, not in a loop; a counter and an edge may have several. Owns what is
//! done to a timer or a counter beside its call.

use super::arguments::{Argument, Params};
use super::builder::Builder;
use super::named::{Param, Section};
use super::places::Target;
use crate::standard::{Role, Standard};
use crate::{Base, Call, Expr, ExprKind, Input, Kind, Order, Stmt, StmtKind, TypeId};
use unoclp_text::diagnostics::{Code, Span};

impl Builder<'_, '_> {
    /// A call of an instance of a block: its inputs, the call, what is read after it.
    pub fn block(&mut self, target: Target, arguments: Vec<Argument>, at: Span) -> Vec<Stmt> {
        self.writes = true;
        match self.tree.types.kind(target.ty).clone() {
            Kind::Standard(block) => self.standard(block, target, arguments, at),
            Kind::Block(unit) => self.own_block(unit, target, arguments, at),
            _ => {
                let (written, what) = (self.written(target.at), self.what_type(target.ty));
                let help = (
                    "only functions and instances of function blocks can be called",
                    "só se podem chamar funções e instâncias de blocos de funções",
                );
                self.tell(
                    Code::StNotCallable,
                    target.at,
                    [written.into(), what, help.into()],
                );
                Vec::new()
            }
        }
    }

    /// What is done to a timer or a counter beside its call; none of what is neither, which the front end tells, and where a
    /// value is wrong.
    pub fn order(&mut self, target: Target, order: Order, at: Span) -> Option<Stmt> {
        let Kind::Standard(block) = *self.tree.types.kind(target.ty) else {
            return None;
        };
        if !block.is_timer() && !block.is_counter() {
            return None;
        }
        self.writes = true;
        let order = match order {
            Order::Preset(value) => Order::Preset(self.as_part(value, block, block.preset()?)?),
            Order::Number(value) => Order::Number(self.as_part(value, block, block.number()?)?),
            other => other,
        };
        let kind = StmtKind::Order(order, block, target.place);
        Some(Stmt { kind, at })
    }

    /// A value as a part of a block holds it.
    fn as_part(&mut self, value: Expr, block: Standard, part: u32) -> Option<Expr> {
        let (_, base, _) = block.parts().get(part as usize)?;
        let value = self.coerce(value, TypeId::of(*base));
        (!matches!(value.kind, ExprKind::Wrong)).then_some(value)
    }

    fn own_block(
        &mut self,
        unit: u32,
        target: Target,
        arguments: Vec<Argument>,
        at: Span,
    ) -> Vec<Stmt> {
        let Some(draft) = self.draft(unit) else {
            return Vec::new();
        };
        let name = draft.unit.name.clone();
        let params: Params = draft.params.iter().map(|p| (p.clone(), false)).collect();
        self.lenient = draft.incomplete;
        if let Some(here) = self.current {
            self.edges.push((here as u32, unit, target.at));
        }
        let mut call = Call {
            unit,
            instance: Some(target.place.clone()),
            inputs: Vec::new(),
            lent: Vec::new(),
            outputs: Vec::new(),
            at,
        };
        let Some(mut after) = self.pass(&name, params, arguments, Some(&target), &mut call, at)
        else {
            return Vec::new();
        };
        let mut all = vec![Stmt {
            kind: StmtKind::Call(call),
            at,
        }];
        all.append(&mut after);
        all
    }

    fn standard(
        &mut self,
        block: Standard,
        target: Target,
        mut arguments: Vec<Argument>,
        at: Span,
    ) -> Vec<Stmt> {
        for (name, _) in arguments.iter_mut().filter_map(|one| one.name.as_mut()) {
            if let Some((_, part)) = block.part(&name.to_uppercase()) {
                part.0.clone_into(name);
            }
        }
        let param = |(offset, (name, base, role)): (u32, (&str, Base, Role))| {
            let section = match role {
                Role::Input => Section::Input,
                _ => Section::Output,
            };
            let param = Param {
                name: name.to_owned(),
                section,
                ty: TypeId::of(base),
                offset,
            };
            (param, false)
        };
        let parts = (0..).zip(block.parts().iter().copied());
        let params = parts
            .filter(|(_, part)| part.2 != Role::Hidden)
            .map(param)
            .collect();
        let mut call = Call {
            unit: 0,
            instance: None,
            inputs: Vec::new(),
            lent: Vec::new(),
            outputs: Vec::new(),
            at,
        };
        let after = self.pass(
            block.name(),
            params,
            arguments,
            Some(&target),
            &mut call,
            at,
        );
        let Some(mut after) = after else {
            return Vec::new();
        };
        let mut all = Vec::new();
        for input in call.inputs {
            if let Input::Value(offset, value, store) = input {
                let mut place = target.place.clone();
                place.offset += offset;
                let at = value.at;
                all.push(Stmt {
                    kind: StmtKind::Assign(place, value, store),
                    at,
                });
            }
        }
        all.push(Stmt {
            kind: StmtKind::Standard(block, target.place),
            at,
        });
        all.append(&mut after);
        all
    }
}
