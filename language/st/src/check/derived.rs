//! Derived types: ranges, arrays, structures, and function blocks as types of instances.
//!
//! Owns what is told of bounds and sizes.

use super::super::ast::{Name, Node, SpecKind, TypeSpec};
use super::{Checker, MOST_WITHIN, Stage};
use std::collections::HashSet;
use unoclp_text::diagnostics::{Code, Span};
use unoclp_tree::build::MOST_CELLS;
use unoclp_tree::{Base, Enumeration, Kind, Member, TypeId};

fn clamped(number: i128) -> i64 {
    i64::try_from(number).unwrap_or(i64::MAX)
}

impl Checker<'_, '_, '_> {
    fn bounds(&mut self, low: &Node, high: &Node) -> Option<(i128, i128)> {
        let (first, last) = (self.constant(low), self.constant(high));
        let (first, last) = (first?, last?);
        if last < first {
            let words = [first.to_string().into(), last.to_string().into()];
            self.builder
                .tell(Code::StEmptyRange, low.span.to(high.span), words);
            return None;
        }
        Some((first, last))
    }

    /// Values count on from the one before, the first from 0, where the text gives no number.
    pub(super) fn enumeration(&mut self, values: &[(Name, Option<Node>)]) -> Option<TypeId> {
        let mut seen = HashSet::new();
        let (mut made, mut next) = (Vec::new(), 0);
        for (name, number) in values {
            if !seen.insert(self.builder.key(&name.text)) {
                let text = name.text.as_str().into();
                self.builder.tell(Code::StNameTwice, name.span, [text]);
                return None;
            }
            let (number, at) = match number {
                Some(node) => (self.constant(node)?, node.span),
                None => (next, name.span),
            };
            let held = self.within_base(number, Base::Int, at)?;
            made.push((name.text.clone(), held as i16));
            next = number + 1;
        }
        let kind = Kind::Enum(std::sync::Arc::new(Enumeration::new(made)));
        Some(self.builder.tree.types.add_kind(kind, 1))
    }

    /// A number that this type holds; one that it does not is told.
    fn within_base(&mut self, number: i128, base: Base, at: Span) -> Option<i128> {
        let (least, most) = base.range()?;
        if (least..=most).contains(&number) {
            return Some(number);
        }
        let words = [
            number.to_string().into(),
            base.name().into(),
            least.to_string().into(),
            most.to_string().into(),
        ];
        self.builder.tell(Code::StOutOfRange, at, words);
        None
    }

    pub(super) fn range(&mut self, name: &Name, bounds: &(Node, Node)) -> Option<TypeId> {
        let of = self.type_named(name)?;
        let base = self
            .builder
            .tree
            .types
            .base(of)
            .filter(|base| base.is_int());
        let Some(base) = base else {
            let expr = self
                .builder
                .literal(Base::Int, unoclp_tree::Value::Int(0), name.span);
            let is = self.builder.tree.types.name(of);
            let help = (
                "write the range of an integer type: INT(0..100)",
                "escreva o intervalo de um tipo inteiro: INT(0..100)",
            );
            let words = [
                "( .. )".into(),
                "ANY_INT".into(),
                name.text.as_str().into(),
                is.into(),
                help.into(),
            ];
            self.builder.tell(Code::StOperand, expr.at, words);
            return None;
        };
        let (low, high) = self.bounds(&bounds.0, &bounds.1)?;
        for (number, node) in [(low, &bounds.0), (high, &bounds.1)] {
            self.within_base(number, base, node.span)?;
        }
        Some(
            self.builder
                .tree
                .types
                .add_kind(Kind::Range { base, low, high }, 1),
        )
    }

    pub(super) fn array(
        &mut self,
        spec: &TypeSpec,
        bounds: &[(Node, Node)],
        of: &TypeSpec,
    ) -> Option<TypeId> {
        let mut known = Vec::new();
        let of = self.spec(of);
        let mut count = 1_u64;
        for (low, high) in bounds {
            let (first, last) = self.bounds(low, high)?;
            count = count.saturating_mul(u64::try_from(last - first + 1).unwrap_or(u64::MAX));
            known.push((clamped(first), clamped(last)));
        }
        let of = of?;
        let cells = count.saturating_mul(self.builder.tree.types.get(of).cells.into());
        if cells > u64::from(MOST_CELLS) {
            self.told_too_large(spec, cells);
            return None;
        }
        let kind = Kind::Array { bounds: known, of };
        self.made_of_others(kind, cells as u32, spec)
    }

    /// A type that consists of others; told where these stand in one another too deeply.
    fn made_of_others(&mut self, kind: Kind, cells: u32, spec: &TypeSpec) -> Option<TypeId> {
        let ty = self.builder.tree.types.add_kind(kind, cells);
        self.not_too_deep(ty, spec.span)
    }

    pub(super) fn not_too_deep(&mut self, ty: TypeId, at: Span) -> Option<TypeId> {
        if self.builder.tree.types.depth(ty) > MOST_WITHIN {
            self.builder.tell(Code::StTooDeep, at, []);
            return None;
        }
        Some(ty)
    }

    fn told_too_large(&mut self, spec: &TypeSpec, cells: u64) {
        let written = self.builder.written(spec.span);
        let words = [
            written.into(),
            cells.to_string().into(),
            MOST_CELLS.to_string().into(),
        ];
        self.builder.tell(Code::StTooLarge, spec.span, words);
    }

    pub(super) fn structure(
        &mut self,
        spec: &TypeSpec,
        decls: &[super::super::ast::Decl],
    ) -> Option<TypeId> {
        let mut members: Vec<Member> = Vec::new();
        let mut seen = HashSet::new();
        let mut cells = 0_u64;
        let mut right = true;
        for decl in decls {
            let Some(ty) = self.spec(&decl.spec) else {
                right = false;
                continue;
            };
            if matches!(decl.spec.kind, SpecKind::Enum(_)) {
                self.builder.name_values(ty);
            }
            for name in &decl.names {
                if !seen.insert(self.builder.key(&name.text)) {
                    let text = name.text.as_str().into();
                    self.builder.tell(Code::StNameTwice, name.span, [text]);
                    right = false;
                    continue;
                }
                let initial = match &decl.initial {
                    Some(init) => match self.initial(name, init, ty) {
                        None => {
                            right = false;
                            None
                        }
                        initial => initial,
                    },
                    None => None,
                };
                members.push(Member {
                    name: name.text.clone(),
                    ty,
                    offset: cells.min(MOST_CELLS.into()) as u32,
                    initial,
                });
                cells += u64::from(self.builder.tree.types.get(ty).cells);
            }
        }
        if cells > u64::from(MOST_CELLS) {
            self.told_too_large(spec, cells);
            return None;
        }
        if !right {
            return None;
        }
        self.made_of_others(Kind::Struct(members), cells as u32, spec)
    }

    /// The type of a block's instances, whose declarations are made out first.
    pub(super) fn block_type(&mut self, at: usize, used: &Name) -> Option<TypeId> {
        match self.units[at] {
            Stage::Begun => {
                let name = used.text.as_str().into();
                let contains = ("contains", "contém").into();
                self.builder
                    .tell(Code::StRecursive, used.span, [name, contains]);
                return None;
            }
            Stage::Not(_) if self.within >= MOST_WITHIN => {
                self.builder.tell(Code::StTooDeep, used.span, []);
                return None;
            }
            Stage::Not(_) => self.declare_unit(at),
            Stage::Done(_) => {}
        }
        let Stage::Done(unit) = &self.units[at] else {
            return None;
        };
        let ty = self.builder.block_type(unit)?;
        self.not_too_deep(ty, used.span)
    }
}
