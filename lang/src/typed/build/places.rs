//! Names, members and subscripts: from what is written to a place.

use super::declare::Variable;
use super::{Builder, Draft, Named, Section, both};
use crate::address::is_block;
use crate::diagnostics::{Code, Span, Word};
use crate::typed::standard::Role;
use crate::typed::{
    Base, Expr, ExprKind, Index, Kind, Place, Point, Root, TypeId, UnitKind, Value,
};

/// What a name with its members and subscripts stands for.
#[derive(Clone, Debug)]
pub(crate) struct Target {
    pub place: Place,
    pub ty: TypeId,
    /// Why nothing can be stored in it, and what to do.
    pub locked: Option<Box<(Word, Word)>>,
    /// A constant's value.
    pub value: Option<Value>,
    /// Whether it is the name of a unit's own result.
    pub result: bool,
    pub at: Span,
}

impl Draft {
    /// The cells of a block by their names, in the order of their offsets, but for the compiler's own.
    pub(super) fn parts(&self) -> Vec<(String, TypeId, u32)> {
        let own = self.names.values().filter_map(|named| match named {
            Named::Variable(variable)
                if variable.root == Root::Own && !variable.name.starts_with('#') =>
            {
                Some((variable.name.clone(), variable.ty, variable.offset))
            }
            _ => None,
        });
        let mut parts: Vec<_> = own.collect();
        parts.sort_by_key(|part| part.2);
        parts
    }
}

impl Builder<'_, '_> {
    /// What a name stands for here: a variable, a constant, or a point by its address. None if that is nothing with a
    /// value, which is told.
    pub fn name(&mut self, name: &str, at: Span) -> Option<Target> {
        if name.starts_with('%') {
            let point = self.address(name, at)?;
            return Some(self.point_target(point, at));
        }
        match self.find(name).cloned() {
            Some(Named::Variable(variable)) => Some(self.variable(&variable, at)),
            Some(Named::Constant(value, ty)) => Some(self.constant(value, ty, at)),
            Some(Named::Ambiguous(ty)) => {
                let ty = self.tree.types.name(ty).into();
                self.tell(Code::StAmbiguous, at, [name.into(), ty]);
                None
            }
            Some(named) => {
                let what = self.what(&named);
                let help = self.instead(name, &named);
                self.tell(Code::StNoValue, at, [name.into(), what, help]);
                self.told_name(name);
                None
            }
            None => {
                let help = self.how_to_declare(name);
                self.tell(Code::StUndeclared, at, [name.into(), help]);
                self.told_name(name);
                None
            }
        }
    }

    fn how_to_declare(&mut self, name: &str) -> Word {
        let truth = match name.to_uppercase().as_str() {
            "ON" | "HIGH" | "LIGADO" | "LIGADA" | "VERDADEIRO" | "VERDADE" | "YES" | "SIM" => {
                "TRUE"
            }
            "OFF" | "LOW" | "DESLIGADO" | "DESLIGADA" | "FALSO" | "NO" | "NAO" | "NÃO" => "FALSE",
            _ => "",
        };
        if !truth.is_empty() {
            return self.near(
                name,
                both(format!("write {truth}"), format!("escreva {truth}")),
            );
        }
        let ty = match (is_block(name), name.starts_with(['T', 't'])) {
            (true, true) => "TON",
            (true, false) => "CTU",
            _ => "INT",
        };
        let declare = format!("VAR {name} : {ty}; END_VAR");
        let help = both(
            format!("declare it: {declare}"),
            format!("declare-o: {declare}"),
        );
        self.near(name, help)
    }

    fn instead(&self, name: &str, named: &Named) -> Word {
        match named {
            Named::Type(_) => both(
                format!("declare a variable of it: VAR x : {name}; END_VAR"),
                format!("declare uma variável dele: VAR x : {name}; END_VAR"),
            ),
            _ => both(format!("call it: {name}(…)"), format!("chame-o: {name}(…)")),
        }
    }

    fn variable(&mut self, variable: &Variable, at: Span) -> Target {
        let kind = self.kind_here();
        let is_own = !matches!(variable.section, Section::Global);
        let result = kind == Some(UnitKind::Function)
            && variable.offset == 0
            && variable.section == Section::Var
            && self
                .here()
                .is_some_and(|draft| draft.result.is_some() && draft.unit.name == variable.name);
        let input = variable.section == Section::Input && is_own && kind != Some(UnitKind::Program);
        let locked = match (variable.constant, input) {
            (true, _) => Some(Box::new(Builder::why_not_written(Section::Var))),
            (_, true) => Some(Box::new(Builder::why_not_written(Section::Input))),
            _ => self.input_point(variable.root, variable.offset),
        };
        Target {
            place: variable.place(at),
            ty: variable.ty,
            locked,
            value: None,
            result,
            at,
        }
    }

    fn constant(&self, value: Value, ty: TypeId, at: Span) -> Target {
        Target {
            place: Place {
                root: Root::Static,
                offset: 0,
                indices: Vec::new(),
                at,
            },
            ty,
            locked: Some(Box::new(Builder::why_not_written(Section::Var))),
            value: Some(value),
            result: false,
            at,
        }
    }

    fn input_point(&self, root: Root, offset: u32) -> Option<Box<(Word, Word)>> {
        if root != Root::Static {
            return None;
        }
        let points = self.points.iter();
        let mut at = points.filter(|(point, cell)| **cell == offset && !point.is_written());
        at.next()?;
        let what = (
            "an input, which only its sensor changes",
            "uma entrada, que só o seu sensor muda",
        );
        let help = (
            "store in an output (%QX1) or a variable",
            "guarde em uma saída (%QX1) ou em uma variável",
        );
        Some(Box::new((what.into(), help.into())))
    }

    fn point_target(&mut self, point: Point, at: Span) -> Target {
        let offset = self.point(point);
        let base = match point {
            _ if point.is_bit() => Base::Bool,
            Point::Register(_) => Base::Dint,
            _ => Base::Int,
        };
        Target {
            place: Place {
                root: Root::Static,
                offset,
                indices: Vec::new(),
                at,
            },
            ty: TypeId::of(base),
            locked: self.input_point(Root::Static, offset),
            value: None,
            result: false,
            at,
        }
    }

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
                    (offset, TypeId::of(base), self.lock_of(role == Role::Input))
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
                    let lock = self.lock_of(param.section == Section::Input);
                    (param.offset, param.ty, lock)
                });
            }
            _ => {}
        }
        let Some((offset, ty, locked)) = found else {
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
                    format!("{name} is the block's own; declare it with VAR_OUTPUT to read it"),
                    format!("{name} é do próprio bloco; declare com VAR_OUTPUT para lê-lo"),
                ),
                [] => both(
                    format!("it is {what}, which has no parts"),
                    format!("ele é {what}, que não tem partes"),
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
            at: of.at.to(at),
        })
    }

    fn lock_of(&self, input: bool) -> Option<Box<(Word, Word)>> {
        let what = ("an output of its block", "uma saída do seu bloco");
        let help = (
            "only the block changes it; store in one of its inputs",
            "só o bloco a muda; guarde em uma das entradas dele",
        );
        (!input).then(|| Box::new((what.into(), help.into())))
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
            if !subscript.base.is_int() || self.is_enum(subscript.ty) {
                self.told_mismatch(&subscript, TypeId::of(Base::Int));
                right = false;
                continue;
            }
            match &subscript.kind {
                ExprKind::Constant(value) => {
                    let number = value.int();
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
                _ if blocks => {
                    self.tell(Code::StBlockSubscript, subscript.at, []);
                    right = false;
                }
                _ => indices.push(Index {
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
            at: of.at.to(at),
        })
    }

    /// The value of a variable without parts.
    pub fn read(&mut self, target: Option<Target>, at: Span) -> Expr {
        let Some(target) = target else {
            return self.wrong(at);
        };
        let Some(base) = self.tree.types.base(target.ty) else {
            let (written, what) = (self.written(at), self.what_type(target.ty));
            let part = match self.tree.types.kind(target.ty) {
                Kind::Array { .. } => format!("{written}[1]"),
                Kind::Standard(block) => {
                    let parts = block.parts().iter();
                    let output = parts.filter(|part| part.2 == Role::Output);
                    let name = output.map(|part| part.0).next().unwrap_or("Q");
                    format!("{written}.{name}")
                }
                _ => format!("{written}.x"),
            };
            self.tell(Code::StSharedWhole, at, [written.into(), what, part.into()]);
            return self.wrong(at);
        };
        let kind = match target.value {
            Some(value) => ExprKind::Constant(value),
            None => ExprKind::Read(Box::new(target.place)),
        };
        Expr {
            kind,
            base,
            ty: target.ty,
            at,
        }
    }

    pub(super) fn is_enum(&self, ty: TypeId) -> bool {
        matches!(self.tree.types.kind(ty), Kind::Enum(_))
    }
}
