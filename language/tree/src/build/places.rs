//! Names, members and subscripts: from what is written to a place.

use super::builder::{Builder, Draft};
use super::named::{Lock, Named, Section, Variable};
use super::points::point_base;
use super::words::both;
use crate::standard::Role;
use crate::{Expr, ExprKind, Kind, Place, Root, TypeId, UnitKind, Value};
use unoclp_point::{Address, is_block};
use unoclp_text::diagnostics::{Code, Span, Word};

/// What a name with its members and subscripts stands for.
#[derive(Clone, Debug)]
pub struct Target {
    /// The place.
    pub place: Place,
    /// The type of what it holds.
    pub ty: TypeId,
    /// Why nothing can be stored in it, and what to do.
    pub locked: Option<Lock>,
    /// A constant's value.
    pub value: Option<Value>,
    /// Whether it is the name of a unit's own result.
    pub result: bool,
    /// Whether it is an input of the unit that names it.
    pub input: bool,
    /// Where it stands.
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
        let mut parts: Vec<_> = own.chain(self.constants.iter().cloned()).collect();
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
                format!("declare a variable of this type: VAR x : {name}; END_VAR"),
                format!("declare uma variável desse tipo: VAR x : {name}; END_VAR"),
            ),
            _ => both(format!("call it: {name}(…)"), format!("chame {name}(…)")),
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
        let locked = match variable.section {
            Section::Chart => Some(Lock::Chart),
            _ if variable.constant => Some(Lock::Constant),
            _ => self.input_point(variable.root, variable.offset),
        };
        Target {
            place: variable.place(at),
            ty: variable.ty,
            locked,
            value: None,
            result,
            input,
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
            locked: Some(Lock::Constant),
            value: Some(value),
            result: false,
            input: false,
            at,
        }
    }

    fn input_point(&self, root: Root, offset: u32) -> Option<Lock> {
        if root != Root::Static {
            return None;
        }
        let points = self.points.iter();
        let mut at = points.filter(|(point, cell)| **cell == offset && !point.is_written());
        at.next().map(|_| Lock::Sensor)
    }

    /// A point of the board as a place.
    pub fn point_target(&mut self, point: Address, at: Span) -> Target {
        let offset = self.point(point);
        Target {
            place: Place {
                root: Root::Static,
                offset,
                indices: Vec::new(),
                at,
            },
            ty: TypeId::of(point_base(point)),
            locked: self.input_point(Root::Static, offset),
            value: None,
            result: false,
            input: false,
            at,
        }
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
