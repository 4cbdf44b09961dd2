//! Members and subscripts: from what is written to a place.
//!
//! Owns what is told of one that is not there.

use super::builder::Builder;
use super::named::{Lock, Section};
use super::places::Target;
use super::words::both;
use crate::standard::Role;
use crate::{Base, Cell, Expr, ExprKind, Index, Kind, Root, TypeId, Value};
use unoclp_text::diagnostics::{Code, Span};

/// Whether anything but its block stores in a part of a block: in its inputs alone.
fn lock_of(input: bool) -> Option<Lock> {
    (!input).then_some(Lock::Output)
}

impl Builder<'_, '_> {
    /// A member of a structure or an instance.
    pub fn member(&mut self, of: Target, name: &str, at: Span) -> Option<Target> {
        let key = self.key(name);
        let kind = self.tree.types.kind(of.ty).clone();
        let mut names: Vec<String> = Vec::new();
        let (mut found, mut incomplete) = (None, false);
        match &kind {
            Kind::Struct(members) => {
                let member = members.iter().find(|member| self.key(&member.name) == key);
                found = member.map(|member| (member.offset, member.ty, None));
                names = members.iter().map(|member| member.name.clone()).collect();
            }
            Kind::Standard(block) => {
                found = block.part(&key).map(|(offset, (_, base, role))| {
                    (offset, TypeId::of(base), lock_of(role == Role::Input))
                });
                let parts = block.parts().iter().filter(|part| part.2 != Role::Hidden);
                names = parts.map(|part| part.0.to_owned()).collect();
            }
            Kind::Block(unit) => {
                let draft = self.draft(*unit)?;
                incomplete = draft.incomplete;
                let own = draft
                    .params
                    .iter()
                    .filter(|param| param.section != Section::InOut);
                names = own.clone().map(|param| param.name.clone()).collect();
                let mut named = own.filter(|param| self.key(&param.name) == key);
                found = named.next().map(|param| {
                    let lock = lock_of(param.section == Section::Input);
                    (param.offset, param.ty, lock)
                });
            }
            _ => {}
        }
        let Some((offset, ty, locked)) = found else {
            let is_block = matches!(kind, Kind::Standard(_) | Kind::Block(_));
            if is_block
                && key == "ENO"
                && let Some(eno) = self.eno(&of)
            {
                let locked = Some(Lock::Output);
                let at = of.at.to(at);
                return Some(Target { locked, at, ..eno });
            }
            if incomplete {
                return None;
            }
            let what = self.tree.types.name(of.ty);
            let hidden = match &kind {
                Kind::Block(unit) => self
                    .draft(*unit)
                    .is_some_and(|draft| draft.names.contains_key(&key)),
                _ => false,
            };
            let help = match names.as_slice() {
                _ if hidden => both(
                    format!("{name} is local to the block; declare it with VAR_OUTPUT to read it"),
                    format!("{name} é local do bloco; declare-a com VAR_OUTPUT para lê-la"),
                ),
                [] => both(
                    format!("it is {what}, which has no members"),
                    format!("ele é {what}, que não tem membros"),
                ),
                names => {
                    let list = names.join(", ");
                    both(format!("it has {list}"), format!("ele tem {list}"))
                }
            };
            let written = self.written(of.at);
            self.tell(Code::StNoMember, at, [written.into(), name.into(), help]);
            return None;
        };
        let mut place = of.place;
        place.offset += offset;
        Some(Target {
            place,
            ty,
            locked: of.locked.or(locked),
            value: None,
            result: of.result,
            input: of.input,
            at: of.at.to(at),
        })
    }

    /// ENO of an instance: whether its last call was made.
    pub fn eno(&mut self, of: &Target) -> Option<Target> {
        if of.place.root != Root::Static || !of.place.indices.is_empty() {
            return None;
        }
        let new = self.tree.cells.len() as u32;
        let offset = *self.enos.entry(of.place.offset).or_insert(new);
        if offset == new {
            self.tree.cells.push(Cell {
                base: Base::Bool,
                initial: Value::truth(true),
                retain: false,
                scratch: false,
            });
        }
        let mut place = of.place.clone();
        place.offset = offset;
        Some(Target {
            place,
            ty: TypeId::of(Base::Bool),
            locked: None,
            value: None,
            result: false,
            input: false,
            at: of.at,
        })
    }

    /// An element of an array. Constant subscripts are checked here, computed ones while the program runs.
    pub fn subscript(&mut self, of: Target, subscripts: Vec<Expr>, at: Span) -> Option<Target> {
        let Kind::Array {
            bounds,
            of: element,
        } = self.tree.types.kind(of.ty).clone()
        else {
            let (written, name) = (self.written(of.at), self.tree.types.name(of.ty));
            self.tell(Code::StNotArray, at, [written.into(), name.into()]);
            return None;
        };
        let written = self.written(of.at);
        if bounds.len() != subscripts.len() {
            let needs = match bounds.len() {
                1 => both("1 subscript", "1 índice"),
                n => both(format!("{n} subscripts"), format!("{n} índices")),
            };
            let sample: Vec<String> = match bounds.len() {
                1 => subscripts
                    .iter()
                    .map(|one| format!("[{}]", self.written(one.at)))
                    .collect(),
                _ => vec![format!("[{}]", vec!["i"; bounds.len().min(8)].join(", "))],
            };
            let nested = matches!(self.tree.types.kind(element), Kind::Array { .. });
            let sample = match bounds.len() == 1 && !nested {
                true => format!("{written}{}", sample.first().map_or("[1]", String::as_str)),
                false => format!("{written}{}", sample.concat()),
            };
            let has = subscripts.len().to_string();
            self.tell(
                Code::StDimensions,
                at,
                [written.into(), needs, has.into(), sample.into()],
            );
            return None;
        }
        let mut place = of.place;
        let mut stride = self.tree.types.get(element).cells;
        let blocks = matches!(
            self.tree.types.kind(element),
            Kind::Standard(_) | Kind::Block(_)
        );
        let mut indices = Vec::new();
        let mut right = true;
        for (subscript, (low, high)) in subscripts.into_iter().zip(&bounds).rev() {
            let count = high.saturating_sub(*low).saturating_add(1).max(0) as u32;
            if matches!(subscript.kind, ExprKind::Wrong) {
                right = false;
                continue;
            }
            let subscript = self.counted(subscript);
            if !subscript.base.is_int() || self.is_enum(subscript.ty) {
                self.told_mismatch(&subscript, TypeId::of(Base::Int));
                right = false;
                continue;
            }
            let known = match &subscript.kind {
                ExprKind::Constant(value) => Some(value.int()),
                _ if blocks || self.writes_turns() => self.picked(&subscript),
                _ => None,
            };
            match known {
                Some(number) => {
                    if number < i128::from(*low) || number > i128::from(*high) {
                        let words = [
                            number.to_string().into(),
                            written.clone().into(),
                            low.to_string().into(),
                            high.to_string().into(),
                        ];
                        self.tell(Code::StSubscript, subscript.at, words);
                        right = false;
                    } else {
                        place.offset += (number - i128::from(*low)) as u32 * stride;
                    }
                }
                None if blocks => {
                    self.tell(Code::StBlockSubscript, subscript.at, []);
                    right = false;
                }
                None => indices.push(Index {
                    subscript,
                    low: *low,
                    count,
                    stride,
                }),
            }
            stride = stride.saturating_mul(count);
        }
        indices.reverse();
        place.indices.append(&mut indices);
        right.then_some(Target {
            place,
            ty: element,
            locked: of.locked,
            value: None,
            result: of.result,
            input: of.input,
            at: of.at.to(at),
        })
    }
}
