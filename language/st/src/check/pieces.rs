//! What the pieces of Instruction List mean that are written as in Structured Text.

use super::super::ast::{Name, NodeKind};
use super::super::pieces::{Declared, Piece, Types};
use super::Checker;
use super::units::Of;
use std::borrow::Cow;
use unoclp_point::{Kind, Maker, read};
use unoclp_text::diagnostics::Span;
use unoclp_tree::build::{Builder, Target};
use unoclp_tree::{Expr, TypeId};

impl<'a, 't, 'f> Checker<'a, 't, 'f> {
    /// For a list with these types.
    pub fn of_list(
        builder: Builder<'t, 'f>,
        types: &'a Types,
        maker: Maker,
    ) -> Checker<'a, 't, 'f> {
        let mut checker = Checker::new(builder, &types.0);
        checker.maker = Some(maker);
        for (at, ty) in types.0.types.iter().enumerate() {
            let key = checker.builder.key(&ty.name.text);
            checker.types.entry(key).or_insert(at);
        }
        checker
    }
}

impl Checker<'_, '_, '_> {
    /// The name of a variable, or the address that it is where nothing declares it: in a list `I1` is `%I1`.
    pub(super) fn address<'n>(&self, name: &'n str) -> Cow<'n, str> {
        let is_point = |maker| {
            let plain = !name.starts_with('%') && self.builder.find(name).is_none();
            plain
                && read(&name.to_uppercase(), maker)
                    .is_some_and(|point| !matches!(point.kind, Kind::Timer | Kind::Counter))
        };
        match self.maker.is_some_and(is_point) {
            true => Cow::Owned(format!("%{name}")),
            false => Cow::Borrowed(name),
        }
    }

    /// Makes out all types of TYPE.
    pub fn make_types(&mut self) {
        let file = self.file;
        for (at, ty) in file.types.iter().enumerate() {
            self.declared_type(at, &ty.name);
        }
    }

    /// The type of this name; told if there is none.
    pub fn type_by_name(&mut self, name: &str, span: Span) -> Option<TypeId> {
        let name = Name {
            text: name.to_owned(),
            span,
        };
        self.type_named(&name)
    }

    /// Declares the variables of a declaration, where the builder is.
    pub fn declare_piece(&mut self, declared: &Declared, of: &Of) {
        self.declare(of, &declared.0);
    }

    /// What a piece is worth; where one of this type is needed, the values of an enumeration are looked for there first.
    pub fn piece(&mut self, piece: &Piece, hint: Option<TypeId>) -> Expr {
        self.expr(&piece.0, hint)
    }

    /// The variable that a piece names, none if it is wrong, which is told; none at all of what is no variable.
    pub fn variable(&mut self, piece: &Piece) -> Option<Option<Target>> {
        match &piece.0.kind {
            NodeKind::Path(path) if path.bit().is_none() && self.dotted(path).is_none() => {
                Some(self.target(path))
            }
            _ => None,
        }
    }
}
