//! What writes: ST, S, R.

use super::edges::named;
use super::operands::Is;
use super::run::Acc;
use super::said::{ACCUMULATOR, BLOCK, BOOL, NUMBER, constant};
use super::used::parts;
use super::walk::Walk;
use crate::ast::{Instr, Operand, UnitKind};
use crate::names::kept;
use crate::operators::Op;
use unoclp_point::Address;
use unoclp_text::diagnostics::{Code, Span};
use unoclp_tree::build::{Named, Target};
use unoclp_tree::{Base, Convert, Expr, ExprKind, Kind, Order, Standard, Stmt, TypeId};

impl Walk<'_, '_, '_> {
    pub(super) fn store(&mut self, instr: &Instr) {
        if let Acc::Whole(from) = self.run.acc.clone() {
            return self.copy(instr, from);
        }
        let expr = self.take("ST", instr.span);
        if instr.operands.is_empty() {
            return self.missing("ST", instr.span);
        }
        let Some(expr) = expr else {
            for operand in &instr.operands {
                self.storable(operand);
            }
            return;
        };
        if instr.starts_block() {
            return self.out_block_of(instr, expr);
        }
        self.hold(Some(expr));
        let needed = self.needed();
        for (index, operand) in instr.operands.iter().enumerate() {
            let more = index + 1 < instr.operands.len();
            self.store_acc(operand, instr.negated, instr.whole, needed || more);
        }
    }

    /// Stores the accumulator, which stays what it is.
    fn store_acc(&mut self, operand: &Operand, negated: bool, span: Span, needed: bool) {
        let Some(target) = self.storable(operand) else {
            return;
        };
        let Acc::Value(expr) = self.run.acc.clone() else {
            return;
        };
        let is_bit = self.is_bit(&target);
        let stays = !negated && target.place.indices.is_empty() && self.stays(&target, &expr);
        let again = needed && stays && !is_leaf(&expr) && (is_bit == (expr.base == Base::Bool));
        if needed && !again {
            self.settle_costly();
        }
        let Acc::Value(expr) = self.run.acc.clone() else {
            return;
        };
        let Some(statement) = self.stored(expr, &target, operand, negated, span) else {
            return;
        };
        let statement = Stmt {
            at: operand.span,
            ..statement
        };
        self.does(statement, needed && !again);
        if again {
            let held = self.read(target, span);
            self.run.links = 0;
            self.hold(Some(held));
        } else if needed && !negated {
            self.hold_cut(operand);
        }
    }

    /// A constant that a type does not hold is told; what is left of it is the accumulator from then on.
    fn hold_cut(&mut self, operand: &Operand) {
        let instance = Some(self.instance);
        let width = self.front.names.width(operand, instance);
        if let (Some(base), Acc::Value(expr)) = (width, &self.run.acc)
            && let Some(number) = constant(expr)
        {
            let cut = kept(Some(base), number);
            if cut != number {
                let at = expr.at;
                let cut = self.whole(cut, at);
                self.hold(Some(cut));
            }
        }
    }

    /// Whether a bit is stored there.
    fn is_bit(&self, target: &Target) -> bool {
        self.front.c.builder.tree.types.base(target.ty) == Some(Base::Bool)
    }

    /// Stores a value that is not the accumulator: what a block gives.
    pub(super) fn store_value(&mut self, expr: Expr, operand: &Operand, negated: bool) {
        let Some(target) = self.storable(operand) else {
            return;
        };
        let span = operand.span;
        if let Some(statement) = self.stored(expr, &target, operand, negated, span) {
            self.does(statement, false);
        }
    }

    /// What can be stored to; what cannot is told.
    pub(super) fn storable(&mut self, operand: &Operand) -> Option<Target> {
        let target = match self.meaning(operand) {
            Is::Variable(target) => target,
            Is::Wrong => {
                self.front.writes = true;
                return None;
            }
            _ => {
                self.front.writes = true;
                self.not_writable(operand);
                return None;
            }
        };
        let is_read_only = self.is_output(operand);
        match self.point_at(&target) {
            Some(Address::Input(_)) => {
                let name = self.spelled(operand);
                self.tell(Code::StoreToInput, operand.span, [name.into()]);
                return None;
            }
            Some(Address::Output(output)) => self.note_coil(output, operand),
            Some(point) if !point.is_written() => {
                self.not_writable(operand);
                return None;
            }
            None if is_read_only => {
                self.front.writes = true;
                self.not_writable(operand);
                return None;
            }
            _ => {}
        }
        self.front.writes = true;
        Some(Target {
            locked: None,
            ..target
        })
    }

    /// Q and ET of timers and Q of counters: their blocks alone write them.
    fn is_output(&self, operand: &Operand) -> bool {
        let name = operand.name().unwrap_or_default();
        let (block, part) = parts(name, self.front.names.dialect);
        let Some(Named::Variable(variable)) = self.front.c.builder.find(&block) else {
            return false;
        };
        let is_output = matches!(part, Some("Q" | "QU" | "QD" | "D" | "ET"));
        let kind = self.front.c.builder.tree.types.kind(variable.ty);
        is_output
            && matches!(kind, Kind::Standard(block) if block.part("PT").is_some() || block.part("PV").is_some())
    }

    fn not_writable(&mut self, operand: &Operand) {
        let name = self.spelled(operand);
        self.tell(Code::NotWritable, operand.span, [name.into()]);
    }

    /// An output that has been written by ST before is told, where no jump may lead past one of the two.
    fn note_coil(&mut self, output: u8, operand: &Operand) {
        let kind = self.front.kind_of(self.unit);
        if kind != UnitKind::Program || self.run.jumps {
            return;
        }
        let span = operand.span;
        if *self.front.coils.entry(output).or_insert(span) != span {
            let name = self.spelled(operand);
            self.tell(Code::WrittenTwice, span, [name.into()]);
        }
    }

    /// The statement that stores a value.
    fn stored(
        &mut self,
        expr: Expr,
        target: &Target,
        operand: &Operand,
        negated: bool,
        span: Span,
    ) -> Option<Stmt> {
        if !self.is_plain(&expr) || !self.is_plain_type(target.ty) {
            return self.typed_stored(expr, target, operand, negated, span);
        }
        if self.is_bit(target) {
            if expr.base != Base::Bool && !matches!(constant(&expr), Some(0..=1)) {
                self.wrong_type(ACCUMULATOR.into(), operand.span, NUMBER, BOOL);
                return None;
            }
            let mut bit = self.as_bit(expr, ACCUMULATOR, span)?;
            if negated {
                bit = self.front.c.builder.not(bit, span);
            }
            return self.assigned(target, bit, span);
        }
        if expr.base == Base::Bool {
            self.wrong_type(ACCUMULATOR.into(), operand.span, BOOL, NUMBER);
            return None;
        }
        let mut number = expr;
        let instance = Some(self.instance);
        let width = self.front.names.width(operand, instance);
        if let (Some(base), Some(constant), false) = (width, constant(&number), negated) {
            let name = self.spelled(operand);
            let found = &mut *self.front.c.builder.found;
            let to = (base, name.as_str());
            let kept = self.front.names.cut(to, constant, operand.span, found);
            number = self.whole(kept, operand.span);
        }
        if negated {
            number = self.opposite(number, span);
            if number.base == Base::Bool {
                let state = matches!(&number.kind, ExprKind::Constant(value) if value.is_true());
                number = self.whole(if state { -1 } else { -2 }, span);
            }
        }
        if let Some((block, order)) = self.order_for(operand, &number) {
            // A timer that nothing starts has no preset.
            self.reads_timer(operand);
            return self.order(&block, order, span);
        }
        self.assigned(target, number, span)
    }

    /// A number of 32 bits as one of a type, in whose bits it is stored.
    pub(super) fn fit(&mut self, value: Expr, ty: TypeId, base: Base) -> Expr {
        if value.base == base {
            return value;
        }
        let how = match base.bits() {
            32 => Convert::Keep,
            _ => Convert::Wrap,
        };
        self.front.c.builder.converted(value, how, ty)
    }

    pub(super) fn set_or_reset(&mut self, instr: &Instr) {
        let set = instr.op == Op::Set;
        let what = if set { "S" } else { "R" };
        if instr.operands.is_empty() && self.block.is_some() {
            return self.wire(what, instr.span);
        }
        let decided = self.run.decided.filter(|_| !instr.operands.is_empty());
        let bit = match decided {
            Some(_) => {
                self.run.unused = None;
                None
            }
            None => match self.take_bit(what, instr.span) {
                Some(bit) => Some(bit),
                None => {
                    if let Some(operand) = instr.operands.first() {
                        self.meaning(operand);
                    }
                    return;
                }
            },
        };
        let Some(operand) = instr.operands.first() else {
            return self.missing(what, instr.span);
        };
        // On an S7-200 a count of points follows.
        let most = self.front.names.board.markers.into();
        let count = match instr.operands.get(1) {
            None => 1,
            Some(count) => count.number().unwrap_or(1).clamp(1, most) as u8,
        };
        self.only(instr, 2);
        if bit.is_some() {
            self.hold(bit);
        }
        let span = operand.span;
        // S1 and R1 are inputs of latches.
        let is_of_latch = self.front.names.written(instr.span).ends_with('1');
        let target = match self.meaning(operand) {
            Is::Block(target, block) if !is_of_latch || block.latch_input(set).is_some() => {
                return self.set_block(target, block, set, instr);
            }
            Is::Variable(_) | Is::Block(..) if is_of_latch => return self.not_callable(operand),
            Is::Variable(target) => target,
            Is::Block(..) => return,
            Is::Instance(_) => {
                self.front.writes = true;
                let name = self.spelled(operand).into();
                return self.wrong_type(name, span, BLOCK, BOOL);
            }
            Is::Constant(_) => {
                self.front.writes = true;
                return self.not_writable(operand);
            }
            Is::Wrong => {
                self.front.writes = true;
                return;
            }
        };
        let point = self.point_at(&target);
        if let Some(Address::Input(_)) = point {
            let name = self.spelled(operand);
            return self.tell(Code::StoreToInput, span, [name.into()]);
        }
        self.front.writes = true;
        if !self.is_bit(&target) {
            let name = self.spelled(operand).into();
            return self.wrong_type(name, span, NUMBER, BOOL);
        }
        if point.is_some_and(|point| !point.is_written()) || self.is_output(operand) {
            return self.not_writable(operand);
        }
        let board = self.front.names.board;
        let last = match point {
            Some(Address::Output(n)) => n.saturating_add(count - 1).min(board.outputs),
            Some(Address::Marker(n)) => n.saturating_add(count - 1).min(board.markers),
            _ => 0,
        };
        let first = point.map_or(0, Address::number);
        let mut targets = vec![target];
        for number in first.saturating_add(1)..=last {
            let more = match point {
                Some(Address::Output(_)) => Address::Output(number),
                _ => Address::Marker(number),
            };
            targets.push(self.front.c.builder.point_target(more, span));
        }
        let mut body = Vec::new();
        for target in targets {
            let value = self.truth(set, span);
            body.extend(self.assigned(&target, value, span));
        }
        self.decide(body, instr.whole);
    }

    /// The accumulator as a bit.
    pub(super) fn take_bit(&mut self, what: &str, span: Span) -> Option<Expr> {
        let expr = self.take(what, span)?;
        self.as_bit(expr, ACCUMULATOR, span)
    }

    /// S and R of a timer or counter.
    fn set_block(&mut self, target: Target, block: Standard, set: bool, instr: &Instr) {
        self.front.writes = true;
        let span = instr.whole;
        if let Some(input) = block.latch_input(set) {
            let Some(bit) = self.take_bit(input, instr.span) else {
                return;
            };
            self.hold(Some(bit.clone()));
            return self.run_block(&target, vec![named(input, bit)], span);
        }
        let order = match set {
            true if block.is_counter() => Order::Load,
            false if block.is_counter() || block.is_timer() => Order::Reset,
            _ => {
                if let Some(operand) = instr.operands.first() {
                    self.not_writable(operand);
                }
                return;
            }
        };
        let body = self.order(&target, order, span).into_iter().collect();
        self.decide(body, span);
    }

    /// What is done to a timer or counter beside its call.
    pub(super) fn order(&mut self, target: &Target, order: Order, at: Span) -> Option<Stmt> {
        self.front.c.builder.order(target.clone(), order, at)
    }

    /// A store in a preset, or in what a counter has counted, which the board does by instructions of their own.
    fn order_for(&mut self, operand: &Operand, value: &Expr) -> Option<(Target, Order)> {
        let name = operand.name()?;
        let (block, part) = parts(name, self.front.names.dialect);
        let Some(Named::Variable(_)) = self.front.c.builder.find(&block) else {
            return None;
        };
        let target = self.front.c.builder.name(&block, operand.span)?;
        let Kind::Standard(standard) = *self.front.c.builder.tree.types.kind(target.ty) else {
            return None;
        };
        let value = value.clone();
        Some(match part? {
            "PT" | "P" if standard.is_timer() => {
                let time = self.fit(value, TypeId::of(Base::Time), Base::Time);
                (target, Order::Preset(time))
            }
            "PV" | "P" if standard.is_counter() => (target, Order::Preset(value)),
            "CV" | "V" if standard.is_counter() => (target, Order::Number(value)),
            _ => return None,
        })
    }
}

/// A constant, or what a variable holds: it is not worked out, so it stays as it is where it is stored.
fn is_leaf(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Constant(_) => true,
        ExprKind::Read(_) => expr.base != Base::Bool,
        ExprKind::Convert(_, of) => of.base != Base::Bool && is_leaf(of),
        _ => false,
    }
}
