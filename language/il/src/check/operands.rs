//! What an operand means, and what it is worth.

use super::first::part;
use super::run::Changes;
use super::said::{BLOCK, BOOL, NUMBER, Words, constant};
use super::used::parts;
use super::walk::Walk;
use crate::ast::{Operand, OperandKind};
use crate::names::Place;
use crate::tree::{Bit, Num};
use unoclp_core::isa::Opcode;
use unoclp_point::Address;
use unoclp_text::diagnostics::{Code, Span, Word};
use unoclp_tree::build::{Named, Target};
use unoclp_tree::{Base, Convert, Expr, Kind, Order, Root, Standard, TypeId, Value};

/// What an operand means.
#[derive(Clone, Debug)]
pub(super) enum Is {
    Constant(Expr),
    Variable(Target),
    /// A block of the standard as a whole.
    Block(Target, Standard),
    /// An instance of a block of the text.
    Instance(Target),
    /// What is wrong has been told.
    Wrong,
}

impl Walk<'_, '_, '_> {
    /// What an operand means; what is wrong with it is told.
    pub(super) fn meaning(&mut self, operand: &Operand) -> Is {
        let span = operand.span;
        let name = match &operand.kind {
            OperandKind::Piece(number) => {
                let piece = self.front.pieces.value(*number);
                return piece.map_or(Is::Wrong, |piece| self.piece(piece));
            }
            OperandKind::Real(bits) => return Is::Constant(self.real(*bits, span)),
            OperandKind::Time(ms) => return Is::Constant(self.time(*ms, span)),
            OperandKind::Number(number) => return Is::Constant(self.whole(*number, span)),
            OperandKind::Unsigned(bits) => return Is::Constant(self.unsigned(*bits, span)),
            OperandKind::Bool(state) => return Is::Constant(self.truth(*state, span)),
            OperandKind::Unknown => return Is::Wrong,
            OperandKind::Name(name) => name,
        };
        if let Some(is) = self.block_member(name, span) {
            return is;
        }
        if let Some(is) = self.lent(name, span) {
            return is;
        }
        if let Some(is) = self.of_type(name, span) {
            return is;
        }
        let instance = Some(self.instance);
        let place = self
            .front
            .names
            .place(operand, instance, self.front.c.builder.found);
        if self.front.c.builder.is_hidden(name) {
            return Is::Wrong;
        }
        match place {
            Place::Unknown => Is::Wrong,
            Place::Typed if self.front.c.builder.find(name).is_none() => Is::Wrong,
            Place::Always(state) => Is::Constant(self.truth(state, span)),
            Place::Number(Num::Const(number)) => Is::Constant(self.whole(number, span)),
            Place::Bit(Bit::At(Address::AtZero(_))) => {
                self.counter_part(name, "QD", span).unwrap_or(Is::Wrong)
            }
            _ => match (self.declared(name, span), place) {
                (Some(is), _) => is,
                (None, Place::Bit(Bit::At(point)) | Place::Number(Num::At(point))) => {
                    let target = self.front.c.builder.point_target(point, span);
                    let base = if point.is_bit() {
                        Base::Bool
                    } else {
                        Base::Dint
                    };
                    Is::Variable(Target {
                        ty: TypeId::of(base),
                        ..target
                    })
                }
                (None, _) => {
                    self.not_yet(span);
                    Is::Wrong
                }
            },
        }
    }

    /// A part of a counter, whichever the name says.
    fn counter_part(&mut self, name: &str, part: &str, span: Span) -> Option<Is> {
        let (block, _) = parts(name, self.front.names.dialect);
        match self.variable(&block, None, span)? {
            Is::Block(target, block) => self.part_of(target, block, part).map(Is::Variable),
            _ => None,
        }
    }

    /// Whether this counter's Q says that it is 0.
    pub(super) fn counts_down(&mut self, operand: &Operand) -> bool {
        let instance = Some(self.instance);
        let found = &mut *self.front.c.builder.found;
        match self.front.names.place(operand, instance, found) {
            Place::Counter(counter) => {
                let counter = self.front.names.counters.get(counter);
                counter.is_some_and(|counter| counter.kind == Some(Opcode::CountDown))
            }
            _ => false,
        }
    }

    /// What the caller lends.
    fn lent(&mut self, name: &str, span: Span) -> Option<Is> {
        let (first, _) = name.split_once('.').unwrap_or((name, ""));
        let Some(Named::Variable(variable)) = self.front.c.builder.find(first) else {
            return None;
        };
        match variable.root {
            Root::Lent(_) => self.declared(name, span),
            _ => None,
        }
    }

    /// A variable of the text, or a part of one.
    fn declared(&mut self, name: &str, span: Span) -> Option<Is> {
        let (first, member) = match name.split_once('.') {
            Some((first, member)) => (first, Some(member)),
            None => (name, None),
        };
        if let Some(key) = self.front.aliases.get(first).cloned() {
            return self.variable(&key, member, span);
        }
        let plain = name.trim_start_matches('%');
        let direct = !name.starts_with('%');
        if direct && let Some(is) = self.variable(plain, None, span) {
            return Some(is);
        }
        if direct && let Some((block, member)) = name.split_once('.') {
            let made = self.variable(block, Some(member), span);
            if made.is_some() {
                return made;
            }
        }
        let (block, member) = parts(name, self.front.names.dialect);
        self.variable(&block, member, span)
    }

    fn variable(&mut self, name: &str, member: Option<&str>, span: Span) -> Option<Is> {
        let Some(Named::Variable(_)) = self.front.c.builder.find(name) else {
            return None;
        };
        let target = self.front.c.builder.name(name, span)?;
        let kind = self.front.c.builder.tree.types.kind(target.ty).clone();
        Some(match (kind, member) {
            (Kind::Standard(block), None) => Is::Block(target, block),
            (Kind::Standard(block), Some(member)) => {
                Is::Variable(self.part_of(target, block, part(block, member)?)?)
            }
            (Kind::Block(_), None) => Is::Instance(target),
            (Kind::Block(unit), Some(member)) => {
                let draft = self.front.c.builder.draft(unit)?;
                let Some(Named::Variable(variable)) = draft.names.get(member) else {
                    return None;
                };
                let (offset, ty) = (variable.offset, variable.ty);
                let mut made = Target { ty, ..target };
                made.place.offset += offset;
                match self.front.c.builder.tree.types.kind(ty).clone() {
                    Kind::Standard(block) => Is::Block(made, block),
                    Kind::Block(_) => Is::Instance(made),
                    _ => Is::Variable(made),
                }
            }
            (_, None) => Is::Variable(target),
            (_, Some(_)) => return None,
        })
    }

    /// A part of a block of the standard, whether the text may store to it or not.
    pub(super) fn part_of(
        &mut self,
        block: Target,
        standard: Standard,
        part: &str,
    ) -> Option<Target> {
        let (offset, (_, base, _)) = standard.part(part)?;
        // What counters count has all bits of the board's numbers.
        let base = if base == Base::Int { Base::Dint } else { base };
        let mut target = Target {
            ty: TypeId::of(base),
            locked: None,
            ..block
        };
        target.place.offset += offset;
        Some(target)
    }

    /// The operand's value; none where something is wrong, which is told.
    pub(super) fn value(&mut self, operand: &Operand) -> Option<Expr> {
        let span = operand.span;
        match self.meaning(operand) {
            Is::Constant(expr) => Some(expr),
            Is::Wrong => None,
            Is::Instance(_) => {
                let name = self.spelled(operand).into();
                self.wrong_type(name, span, BLOCK, BOOL);
                None
            }
            Is::Block(block, standard) => {
                let q = match standard {
                    Standard::Sr | Standard::Rs => "Q1",
                    Standard::Counter if self.counts_down(operand) => "QD",
                    Standard::Counter => "QU",
                    _ => "Q",
                };
                if standard.is_timer() {
                    self.reads_timer(operand);
                }
                let q = self.part_of(block, standard, q)?;
                Some(self.read(q, span))
            }
            Is::Variable(target) if !self.front.c.builder.tree.types.is_scalar(target.ty) => {
                self.front.c.builder.read(Some(target), span);
                None
            }
            Is::Variable(target) => {
                if self.is_write_only(operand, &target) {
                    let name = self.spelled(operand);
                    let help = ("it can only be written", "só pode ser escrito");
                    let words = ["PLC".into(), name.into(), help.into()];
                    self.tell(Code::NoSuchMember, span, words);
                    return None;
                }
                if !self.names_block_member(operand) {
                    self.note_read(operand, &target);
                }
                self.look(operand);
                Some(self.read(target, span))
            }
        }
    }

    /// The time of a timer is that of the moment when it is asked for.
    fn look(&mut self, operand: &Operand) {
        let (block, part) = match operand.name() {
            Some(name) => parts(name, self.front.names.dialect),
            None => return,
        };
        if !matches!(part, Some("ET" | "V")) {
            return;
        }
        let Some(Is::Block(target, standard)) = self.variable(&block, None, operand.span) else {
            return;
        };
        if standard.is_timer()
            && let Some(order) = self.order(&target, Order::Look, operand.span)
        {
            self.before_others(&Changes::Cells(&target.place, standard.cells()));
            self.push(order);
        }
    }

    /// Presets and PWM outputs are written alone.
    fn is_write_only(&self, operand: &Operand, target: &Target) -> bool {
        let preset = operand.name().and_then(|name| name.rsplit_once('.'));
        let preset = preset.is_some_and(|(_, part)| matches!(part, "PT" | "P" | "PV"));
        let of_block = preset
            && operand.name().is_some_and(|name| {
                let (block, _) = parts(name, self.front.names.dialect);
                match self.front.c.builder.find(&block) {
                    Some(Named::Variable(variable)) => {
                        let kind = self.front.c.builder.tree.types.kind(variable.ty);
                        matches!(kind, Kind::Standard(_))
                    }
                    _ => false,
                }
            });
        of_block || matches!(self.point_at(target), Some(Address::Pwm(_)))
    }

    /// The point of the board that a variable is.
    pub(super) fn point_at(&self, target: &Target) -> Option<Address> {
        if target.place.root != Root::Static || !target.place.indices.is_empty() {
            return None;
        }
        let mut points = self.front.c.builder.tree.points.iter();
        let held = points.find(|(cell, _)| *cell == target.place.offset);
        held.map(|(_, point)| *point)
    }

    fn note_read(&mut self, operand: &Operand, target: &Target) {
        match self.point_at(target) {
            Some(Address::Input(input)) => self.front.names.inputs_read |= 1 << (input - 1),
            Some(Address::Inputs(_)) => self.front.names.inputs_read = u128::MAX,
            Some(_) => {}
            None => self.reads_timer(operand),
        }
    }

    /// A timer is read here, in whole or in part.
    pub(super) fn reads_timer(&mut self, operand: &Operand) {
        let instance = Some(self.instance);
        let found = &mut *self.front.c.builder.found;
        let timer = match self.front.names.place(operand, instance, found) {
            Place::Timer(timer) => timer,
            Place::Bit(Bit::Timer(timer))
            | Place::Number(Num::Elapsed(timer) | Num::TimerPreset(timer)) => timer,
            _ => return,
        };
        if let Some(timer) = self.front.names.timers.get_mut(timer) {
            timer.read.get_or_insert(operand.span);
        }
    }

    /// What a variable holds: a bit, or a number of 32 bits.
    pub(super) fn read(&mut self, target: Target, span: Span) -> Expr {
        let expr = self.front.c.builder.read(Some(target), span);
        self.wide(expr)
    }

    /// A number as a DINT.
    pub(super) fn wide(&mut self, expr: Expr) -> Expr {
        if self.is_enum(expr.ty) {
            return expr;
        }
        let how = match expr.base {
            Base::Bool | Base::Dint => return expr,
            Base::AnyInt => return self.settled(expr),
            base if !base.is_plain() => return expr,
            base if base.bits() < 32 || base == Base::Time => Convert::Keep,
            _ => Convert::Wrap,
        };
        self.front
            .c
            .builder
            .converted(expr, how, TypeId::of(Base::Dint))
    }

    pub(super) fn whole(&mut self, number: i32, span: Span) -> Expr {
        let value = Value::Int(number.into());
        self.front.c.builder.literal(Base::Dint, value, span)
    }

    pub(super) fn unsigned(&mut self, bits: i32, span: Span) -> Expr {
        let value = Value::Int(bits.cast_unsigned().into());
        self.front.c.builder.literal(Base::Udint, value, span)
    }

    pub(super) fn truth(&mut self, state: bool, span: Span) -> Expr {
        let value = Value::truth(state);
        self.front.c.builder.literal(Base::Bool, value, span)
    }

    pub(super) fn spelled(&self, operand: &Operand) -> String {
        self.front.names.written(operand.span)
    }

    pub(super) fn wrong_type(&mut self, what: Word, span: Span, is: Words, needed: Words) {
        self.tell(Code::WrongType, span, [what, is.into(), needed.into()]);
    }

    /// As a bit; the constants 0 and 1 are both bit and number.
    pub(super) fn as_bit(&mut self, expr: Expr, what: impl Into<Word>, span: Span) -> Option<Expr> {
        if expr.base == Base::Bool {
            return Some(expr);
        }
        match constant(&expr) {
            Some(number @ 0..=1) => Some(self.truth(number == 1, expr.at)),
            _ if expr.base == Base::AnyReal => {
                self.not_into(expr, TypeId::BOOL);
                None
            }
            _ => {
                self.wrong_type(what.into(), span, NUMBER, BOOL);
                None
            }
        }
    }

    pub(super) fn as_number(
        &mut self,
        expr: Expr,
        what: impl Into<Word>,
        span: Span,
    ) -> Option<Expr> {
        if expr.base == Base::Bool {
            self.wrong_type(what.into(), span, BOOL, NUMBER);
            return None;
        }
        if self.is_plain(&expr) {
            // A time of the text is a number like any other from here on.
            return Some(Expr {
                ty: TypeId::of(expr.base),
                ..expr
            });
        }
        self.bits_of_real(expr)
    }
}
