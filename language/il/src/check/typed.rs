//! Values of other types than bits and whole numbers of the board: REAL, dates, texts, enumerations, arrays,
//! structures.
//!
//! Elsewhere a number is a DINT, whatever declares it: what is narrower is widened where it is read. Here it is what its
//! declaration says again.

use super::operands::Is;
use super::walk::Walk;
use crate::ast::{Instr, Operand, Param, Var};
use unoclp_st::pieces::Piece;
use unoclp_text::diagnostics::{Code, Span};
use unoclp_tree::build::{Argument, Given, Named, Target};
use unoclp_tree::{Base, Convert, Expr, ExprKind, Kind, Stmt, TypeId, Value};

impl Walk<'_, '_, '_> {
    pub(super) fn is_enum(&self, ty: TypeId) -> bool {
        matches!(self.front.c.builder.tree.types.kind(ty), Kind::Enum(_))
    }

    /// Whether a value is a bit, or a number of 32 bits.
    pub(super) fn is_plain(&self, expr: &Expr) -> bool {
        matches!(expr.base, Base::Bool | Base::Dint) && !self.is_enum(expr.ty)
    }

    /// Whether a variable of this type holds a bit, or a number that is stored in its bits.
    pub(super) fn is_plain_type(&self, ty: TypeId) -> bool {
        matches!(self.front.c.builder.tree.types.kind(ty), Kind::Base(base) if base.is_plain())
    }

    pub(super) fn real(&mut self, bits: i32, at: Span) -> Expr {
        let real = f32::from_bits(bits.cast_unsigned());
        let value = Value::Real(real.into());
        self.front.c.builder.literal(Base::Real, value, at)
    }

    /// A time of the text: a number, of which it is known that it is one.
    pub(super) fn time(&mut self, ms: i32, at: Span) -> Expr {
        let ty = TypeId::of(Base::Time);
        Expr {
            ty,
            ..self.whole(ms, at)
        }
    }

    /// What a piece means that is written as in Structured Text.
    pub(super) fn piece(&mut self, piece: &Piece) -> Is {
        let checker = &mut self.front.c;
        let target = match checker.variable(piece) {
            Some(Some(target)) if target.value.is_none() => target,
            Some(None) => return Is::Wrong,
            _ => {
                let expr = checker.piece(piece, self.hint);
                return match expr.kind {
                    ExprKind::Wrong => Is::Wrong,
                    _ => Is::Constant(self.wide(expr)),
                };
            }
        };
        match *checker.builder.tree.types.kind(target.ty) {
            Kind::Standard(block) => Is::Block(target, block),
            Kind::Block(_) => Is::Instance(target),
            _ => Is::Variable(target),
        }
    }

    /// What a name means that has a type of the text, or is the value of one.
    pub(super) fn of_type(&mut self, name: &str, at: Span) -> Option<Is> {
        let written = || self.front.names.written(at);
        if name.starts_with(|c: char| c.is_ascii_digit() || c == '-') {
            return self.fraction(&written(), at).map(Is::Constant);
        }
        if !self.front.has_types {
            return None;
        }
        let mut parts = name.split('.');
        let (first, more) = (parts.next().unwrap_or(name), parts.count());
        let builder = &self.front.c.builder;
        let types = &builder.tree.types;
        let is = match builder.find(first)? {
            Named::Constant(..) | Named::Ambiguous(_) => more == 0,
            Named::Type(ty) => more == 1 && self.is_enum(*ty),
            Named::Variable(variable) => match types.kind(variable.ty) {
                Kind::Struct(_) | Kind::Array { .. } => true,
                // A member of what a block has.
                Kind::Block(_) => more > 1,
                _ => false,
            },
            Named::Unit(_) => false,
        };
        let hinted = || {
            let Some(Kind::Enum(values)) = self.hint.map(|ty| types.kind(ty)) else {
                return false;
            };
            let number = values.number_of(|value| value.eq_ignore_ascii_case(name));
            number.is_some()
        };
        (is || more == 0 && hinted()).then(|| {
            let piece = Piece::named(&self.front.names.written(at), at);
            self.piece(&piece)
        })
    }

    /// A REAL of the text; none of what is a point in it.
    fn fraction(&mut self, written: &str, at: Span) -> Option<Expr> {
        let (sign, size) = match written.strip_prefix('-') {
            Some(size) => (-1.0, size),
            None => (1.0, written),
        };
        let is_point = self.front.names.is_point(size);
        let read = unoclp_tree::literal::number(size)
            .ok()
            .filter(|_| !is_point);
        match read? {
            (base @ Base::AnyReal, Value::Real(real)) => {
                let value = Value::Real(real * sign);
                Some(self.front.c.builder.literal(base, value, at))
            }
            _ => None,
        }
    }

    /// The array or structure that an operand names.
    pub(super) fn whole_variable(&mut self, operand: &Operand) -> Option<Target> {
        if !self.front.has_types {
            return None;
        }
        match self.meaning(operand) {
            Is::Variable(target) if !self.front.c.builder.tree.types.is_scalar(target.ty) => {
                Some(target)
            }
            _ => None,
        }
    }

    /// What is left open by a number of the text, settled.
    pub(super) fn settled(&mut self, expr: Expr) -> Expr {
        let number = match &expr.kind {
            ExprKind::Constant(value) => i32::try_from(value.int()).ok(),
            _ => None,
        };
        match number {
            Some(number) => self.whole(number, expr.at),
            None => {
                let expr = self.front.c.builder.settled(expr);
                match expr.base {
                    Base::AnyInt => expr,
                    _ => self.wide(expr),
                }
            }
        }
    }

    /// A value where a number of the board is needed: a REAL of the text is its bits; all else is told.
    pub(super) fn bits_of_real(&mut self, expr: Expr) -> Option<Expr> {
        match (&expr.kind, expr.base) {
            (ExprKind::Constant(Value::Real(real)), Base::Real) => {
                let bits = (*real as f32).to_bits().cast_signed();
                Some(self.whole(bits, expr.at))
            }
            _ => {
                self.not_into(expr, TypeId::of(Base::Dint));
                None
            }
        }
    }

    /// Tells that a value does not go into this type by itself.
    pub(super) fn not_into(&mut self, expr: Expr, ty: TypeId) {
        if let (ExprKind::Constant(_), Base::AnyReal) = (&expr.kind, expr.base) {
            let written = self.front.names.written(expr.at);
            return self.tell(Code::Fraction, expr.at, [written.into()]);
        }
        self.front.c.builder.coerce(expr, ty);
    }

    /// The statement that stores a value of a type, or stores in a variable of one.
    pub(super) fn typed_stored(
        &mut self,
        expr: Expr,
        target: &Target,
        operand: &Operand,
        negated: bool,
        at: Span,
    ) -> Option<Stmt> {
        let expr = match negated {
            true => self.front.c.builder.not(natural(expr), at),
            false => expr,
        };
        // A register by its address holds whatever is stored in it.
        let is_register = self.point_at(target).is_some_and(|point| !point.is_bit());
        let by_address = operand
            .name()
            .is_some_and(|name| self.front.c.builder.find(name).is_none());
        if is_register && by_address && expr.base == Base::Real {
            let kind = ExprKind::Convert(Convert::Bits, Box::new(expr));
            let (base, ty) = (Base::Dint, TypeId::of(Base::Dint));
            return self.assigned(target, Expr { kind, base, ty, at }, at);
        }
        if self.is_plain_type(target.ty) {
            self.not_into(expr, target.ty);
            return None;
        }
        self.typed_assigned(target, expr, at)
    }

    pub(super) fn typed_assigned(
        &mut self,
        target: &Target,
        value: Expr,
        at: Span,
    ) -> Option<Stmt> {
        let to = self.front.c.builder.tree.types.base(target.ty);
        let value = match to.is_some_and(Base::is_real) {
            true => self.beside_real(value),
            false => natural(value),
        };
        self.front.c.builder.assign(target.clone(), value, at)
    }

    /// Whether a variable holds after ST just what the accumulator does.
    pub(super) fn stays(&self, target: &Target, expr: &Expr) -> bool {
        let types = &self.front.c.builder.tree.types;
        let plain = !matches!(
            types.kind(target.ty),
            Kind::Range { .. } | Kind::Text { .. }
        );
        let alike = self.is_plain(expr) && self.is_plain_type(target.ty);
        alike || plain && types.base(target.ty) == Some(expr.base)
    }

    /// Stores an array or a structure.
    pub(super) fn copy(&mut self, instr: &Instr, from: Target) {
        self.run.unused = None;
        self.only(instr, 1);
        let Some(operand) = instr.operands.first() else {
            return self.missing("ST", instr.span);
        };
        let Some(target) = self.storable(operand) else {
            return;
        };
        let statement = self.front.c.builder.copy(target, from, instr.whole);
        let needed = self.needed();
        if let Some(statement) = statement {
            self.does(statement, needed);
        }
    }

    /// What a call gives to a parameter of a type.
    pub(super) fn give_typed(
        &mut self,
        var: &Var,
        param: &Param,
        given: &mut Vec<Argument>,
    ) -> bool {
        let at = param.value.span;
        let argument = match self.meaning(&param.value) {
            Is::Variable(target) => Given::Place(target),
            Is::Constant(expr) => Given::Value(natural(expr)),
            Is::Wrong => return false,
            Is::Block(target, _) | Is::Instance(target) => Given::Place(target),
        };
        given.push(Argument {
            name: Some((var.name.text.clone(), at)),
            out: false,
            at,
            given: argument,
        });
        true
    }
}

/// A value in the type that its declaration says, where it has been taken for a number of the board.
pub(super) fn natural(expr: Expr) -> Expr {
    let Expr { kind, base, ty, at } = expr;
    match kind {
        ExprKind::Convert(Convert::Keep | Convert::Wrap | Convert::Bits, of)
            if base == Base::Dint && of.base != Base::Bool && of.base.bits() <= 32 =>
        {
            Expr { at, ..*of }
        }
        ExprKind::Constant(value) if base == Base::Dint && ty == TypeId::of(Base::Time) => Expr {
            kind: ExprKind::Constant(value),
            base: Base::Time,
            ty,
            at,
        },
        ExprKind::Constant(value) if base == Base::Dint => Expr {
            kind: ExprKind::Constant(value),
            base: Base::AnyInt,
            ty: TypeId::of(Base::AnyInt),
            at,
        },
        kind => Expr { kind, base, ty, at },
    }
}
