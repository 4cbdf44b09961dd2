//! What each line does with the accumulator.

use super::super::super::ast::{Arg, Instruction, Line, Node, NodeKind};
use super::walk::{Acc, Frame, Walk};
use super::{MOST_FRAMES, is_load};
use crate::diagnostics::{Code, Span};
use crate::operators::{self, Op};
use crate::typed::build::{Argument, Given, Named, Target, both};
use crate::typed::{Base, Expr, ExprKind, Kind, TypeId, UnitKind, Value};
use unoclp_core::isa::Opcode;

impl Walk<'_, '_, '_, '_> {
    /// Whether a line begins with what the accumulator holds.
    pub(super) fn reads(&self, line: &Line) -> bool {
        let one = match line {
            Line::Does(one) => one,
            Line::Close(_) => return true,
            Line::Label(_) | Line::Wrong => return false,
        };
        let Some(spelling) = one.spelling else {
            return self.takes_accumulator(one);
        };
        match spelling.op {
            Op::Load | Op::Recall | Op::Release => false,
            Op::Jump | Op::Return | Op::Call => spelling.conditional,
            Op::End => false,
            Op::Part(opcode) => opcode == Opcode::If,
            _ if self.own_function(one).is_some() => self.takes_accumulator(one),
            _ => one.given.is_none(),
        }
    }

    /// Whether a line that does not read the accumulator fills or forgets it.
    pub(super) fn fills(&self, line: &Line) -> bool {
        let op = match line {
            Line::Does(one) => one.spelling.map(|spelling| spelling.op),
            Line::Close(_) | Line::Label(_) => return false,
            Line::Wrong => return true,
        };
        !matches!(op, Some(Op::Jump | Op::Return | Op::End))
    }

    /// The function of the text that an operator names.
    pub(super) fn own_function(&self, one: &Instruction) -> Option<u32> {
        match self.c.builder.find(&one.word.text) {
            Some(Named::Unit(unit)) => {
                let kind = self.c.builder.draft(*unit)?.unit.kind;
                (kind == UnitKind::Function).then_some(*unit)
            }
            _ => None,
        }
    }

    pub(super) fn instruction(&mut self, one: &Instruction, at: usize) {
        let part = one.spelling.map(|spelling| spelling.op);
        let joins = matches!(part, Some(Op::Part(Opcode::Else | Opcode::EndIf)));
        if std::mem::take(&mut self.unreachable) && !joins {
            self.tell(Code::Unreachable, one.span, []);
        }
        let Some(spelling) = one.spelling.filter(|_| self.own_function(one).is_none()) else {
            return self.by_name(one, at);
        };
        let needs_operand = spelling.op.takes_operand() && one.given.is_none();
        if needs_operand && one.operands.is_empty() && one.open.is_none() {
            let word = one.word.text.to_uppercase();
            let like = format!("{word} x");
            self.acc = Acc::Wrong;
            return self.tell(
                Code::OperandMissing,
                one.word.span,
                [word.into(), like.into()],
            );
        }
        match spelling.op {
            Op::Load => self.load(one),
            Op::Store => self.st(one, at),
            Op::Set => self.set(one, true, at),
            Op::Reset => self.set(one, false, at),
            Op::Not => self.not(one),
            Op::And | Op::Or | Op::Xor | Op::Number(_) | Op::Compare(_) => self.operate(one, at),
            Op::Shift(_) | Op::Unary(_) => self.operate(one, at),
            Op::Jump => self.jump(one, at),
            Op::Return | Op::End => self.ret(one, at),
            Op::Part(opcode) => self.part(one, opcode),
            Op::Call => self.cal(one, at),
            Op::Timer(_) | Op::CountUp | Op::CountDown => self.timer_or_counter(one),
            Op::Input(_) => self.input(one),
            Op::Preset => self.preset(one, at),
            Op::Edge(_) => self.edge_of_accumulator(one),
            Op::Differentiate(_) => self.differentiate(one, at),
            Op::Keep => self.keep(one),
            Op::Recall | Op::Release => self.recall(one, spelling.op),
            _ => self.not_here(one),
        }
    }

    /// An operator of texts without types.
    pub(super) fn not_here(&mut self, one: &Instruction) {
        self.acc = Acc::Wrong;
        let help = (
            "it belongs to texts without REAL, TYPE and the functions of the norm; write what it does with LD, ST and the operators of the norm",
            "ele pertence a textos sem REAL, TYPE e as funções da norma; escreva o que ele faz com LD, ST e os operadores da norma",
        );
        let words = [one.word.text.as_str().into(), help.into()];
        self.tell(Code::StUnsupported, one.word.span, words);
    }

    fn load(&mut self, one: &Instruction) {
        if self.frames.is_empty() || !matches!(self.acc, Acc::Value(_)) {
            self.warn_unused();
        }
        let Some(arg) = one.operands.first() else {
            return;
        };
        if self.output_of(&arg.node).is_some() {
            let expr = self.value(&arg.node, None);
            return self.loaded(expr, one);
        }
        if let NodeKind::Path(path) = &arg.node.kind {
            let target = self.c.target(path);
            let whole = |target: &Target| !self.c.builder.tree.types.is_scalar(target.ty);
            match target {
                Some(target) if whole(&target) => {
                    self.acc = Acc::Whole(target);
                    return;
                }
                Some(target) => {
                    let expr = self.c.builder.read(Some(target), arg.node.span);
                    self.loaded(expr, one);
                }
                None => self.acc = Acc::Wrong,
            }
            return;
        }
        let expr = self.c.expr(&arg.node, None);
        self.loaded(expr, one);
    }

    /// The output that a block of the norm stands for where a value is needed: `LD T1` loads its Q.
    fn output_of(&self, node: &Node) -> Option<&'static str> {
        let NodeKind::Path(path) = &node.kind else {
            return None;
        };
        let variable = match self.c.builder.find(&path.name.text) {
            Some(Named::Variable(variable)) if path.parts.is_empty() => variable,
            _ => return None,
        };
        match self.c.builder.tree.types.kind(variable.ty) {
            Kind::Standard(block) => {
                let outputs = ["Q", "QU", "Q1"];
                outputs.into_iter().find(|name| block.part(name).is_some())
            }
            _ => None,
        }
    }

    /// What an operand is worth.
    fn value(&mut self, node: &Node, hint: Option<TypeId>) -> Expr {
        match (self.output_of(node), &node.kind) {
            (Some(output), NodeKind::Path(path)) => {
                let block = self.c.target(path);
                let output =
                    block.and_then(|block| self.c.builder.member(block, output, node.span));
                self.c.builder.read(output, node.span)
            }
            _ => self.c.expr(node, hint),
        }
    }

    fn loaded(&mut self, expr: Expr, one: &Instruction) {
        let mut expr = expr;
        let inverts = std::mem::take(&mut self.inverts);
        if one.spelling.and_then(|spelling| spelling.edge).is_some() {
            expr = self.edge(expr, one.span);
        }
        if inverts != one.spelling.is_some_and(|spelling| spelling.negated) {
            expr = self.c.builder.not(expr, one.span);
        }
        self.hold(expr, 0);
        self.unused = Some(one.span);
    }

    fn st(&mut self, one: &Instruction, at: usize) {
        let Some(Arg { node, .. }) = one.operands.first() else {
            return;
        };
        for more in one.operands.iter().skip(1) {
            let written = self.c.builder.written(more.node.span).into();
            self.tell(Code::Unexpected, more.node.span, [written]);
        }
        let NodeKind::Path(path) = &node.kind else {
            let written = self.c.builder.written(node.span);
            return self.tell(Code::NotWritable, node.span, [written.into()]);
        };
        let Some(target) = self.c.target(path) else {
            self.unused = None;
            return;
        };
        let needed = self.needs[at + 1];
        if let Acc::Whole(from) = self.acc.clone() {
            self.unused = None;
            let statement = self.c.builder.copy(target, from, one.span);
            return statement
                .into_iter()
                .for_each(|one| self.store(one, needed));
        }
        let stays = self.stays(&target);
        if needed && !stays {
            self.settle_costly();
        }
        let Some(mut value) = self.take(&one.word.text, one.word.span) else {
            return;
        };
        if one.spelling.is_some_and(|spelling| spelling.negated) {
            value = self.c.builder.not(value, one.span);
        }
        // What has just been stored in a bit is there for the next store.
        let is_read = |acc: &Acc| matches!(acc, Acc::Value(expr) if expr.base == Base::Bool && matches!(expr.kind, ExprKind::Read(_)));
        let costs = self.links > 0 || is_read(&self.acc);
        let reads = stays && costs && !one.spelling.is_some_and(|s| s.negated);
        let again = reads.then(|| target.clone());
        let Some(statement) = self.c.builder.assign(target, value, one.span) else {
            return;
        };
        self.store(statement, needed && again.is_none());
        if let Some(again) = again.filter(|_| needed) {
            let held = self.c.builder.read(Some(again), one.span);
            self.hold(held, 0);
        }
    }

    /// Whether a variable holds after ST just what the accumulator does.
    fn stays(&self, target: &Target) -> bool {
        let Acc::Value(expr) = &self.acc else {
            return false;
        };
        let types = &self.c.builder.tree.types;
        let plain = !matches!(
            types.kind(target.ty),
            Kind::Range { .. } | Kind::Text { .. }
        );
        plain && target.place.indices.is_empty() && types.base(target.ty) == Some(expr.base)
    }

    /// S, R.
    fn set(&mut self, one: &Instruction, to: bool, at: usize) {
        let needed = self.needs[at + 1];
        if needed {
            self.settle_costly();
        }
        let mut condition = self.condition(one);
        for (number, arg) in one.operands.iter().enumerate() {
            let NodeKind::Path(path) = &arg.node.kind else {
                let written = self.c.builder.written(arg.node.span);
                return self.tell(Code::NotWritable, arg.node.span, [written.into()]);
            };
            let target = self.c.target(path);
            let value = self
                .c
                .builder
                .literal(Base::Bool, Value::truth(to), one.span);
            let statement = target.and_then(|to| self.c.builder.assign(to, value, one.span));
            let (Some(held), Some(statement)) = (condition.clone(), statement) else {
                continue;
            };
            let more = number + 1 < one.operands.len();
            self.conditional(held, vec![statement], one.span, needed || more);
            if more {
                condition = self.condition(one);
            }
        }
    }

    fn not(&mut self, one: &Instruction) {
        let Some(expr) = self.linked(&one.word.text, one.word.span) else {
            return;
        };
        let expr = self.c.builder.not(expr, one.span);
        let links = self.links;
        self.hold(expr, links);
        self.unused = Some(one.span);
    }

    /// An operation on the accumulator and what follows the operator, or in parentheses on the lines that follow.
    fn operate(&mut self, one: &Instruction, at: usize) {
        let word = one.word.text.to_uppercase();
        let Some(name) = self.function_of(one, &word) else {
            return self.not_here(one);
        };
        if let Some(negated) = one.open {
            return self.defer(one, name, negated, at);
        }
        if one.given.is_some() {
            return self.formal(one, &name);
        }
        let Some(expr) = self.linked(&one.word.text, one.word.span) else {
            self.c.arguments(&one.operands);
            return;
        };
        let links = self.links + 1;
        let ty = expr.ty;
        if name == "NEG" {
            let expr = self.c.builder.negate(expr, one.span);
            self.hold(expr, links);
            self.unused = Some(one.span);
            return;
        }
        let mut all = vec![accumulated(expr)];
        for arg in &one.operands {
            let given = self.operand(arg, one, ty);
            all.push(given);
        }
        let expr = self.c.builder.function(&name, all, one.span);
        self.hold(expr, links);
        self.unused = Some(one.span);
    }

    /// An operand; a value of the accumulator's own enumeration is looked for there.
    fn operand(&mut self, arg: &Arg, one: &Instruction, with: TypeId) -> Argument {
        let spelling = one.spelling;
        let negated = spelling.is_some_and(|spelling| spelling.negated);
        let edge = spelling.is_some_and(|spelling| spelling.edge.is_some());
        let mut expr = self.value(&arg.node, Some(with));
        if edge {
            expr = self.edge(expr, one.span);
        }
        if negated {
            expr = self.c.builder.not(expr, arg.node.span);
        }
        Argument {
            name: None,
            out: false,
            at: arg.node.span,
            given: match expr.kind {
                ExprKind::Wrong => Given::Wrong,
                _ => Given::Value(expr),
            },
        }
    }

    /// The standard function that an operator stands for, whoever's word it is.
    fn function_of(&self, one: &Instruction, word: &str) -> Option<String> {
        let op = one.spelling.map(|spelling| spelling.op);
        let name = match op {
            Some(Op::And) => "AND",
            Some(Op::Or) => "OR",
            Some(Op::Xor) => "XOR",
            Some(Op::Number(_) | Op::Unary(_)) => word.strip_prefix("REAL_").unwrap_or(word),
            _ => word,
        };
        let known = name == "NEG" || self.c.builder.is_function(name);
        known.then(|| name.to_owned())
    }

    /// `AND(`
    fn defer(&mut self, one: &Instruction, name: String, negated: bool, at: usize) {
        if self.frames.len() == MOST_FRAMES {
            self.tell(Code::TooDeep, one.span, []);
        }
        if self.frames.len() >= MOST_FRAMES {
            self.acc = Acc::Wrong;
        }
        let acc = match self.linked(&one.word.text, one.word.span) {
            Some(expr) => Acc::Value(expr),
            None => Acc::Wrong,
        };
        self.frames.push(Frame {
            name,
            acc,
            negated: one.spelling.is_some_and(|spelling| spelling.negated),
            at: one.span,
        });
        if let Some(arg) = one.operands.first() {
            let mut expr = self.c.expr(&arg.node, None);
            if negated {
                expr = self.c.builder.not(expr, one.span);
            }
            self.hold(expr, 0);
        } else {
            self.inverts = negated;
            if !is_load(self.lines.get(at + 1)) {
                self.inverts = false;
            }
        }
    }

    /// `)`
    pub(super) fn close(&mut self, span: Span) {
        let Some(frame) = self.frames.pop() else {
            if !self.lost {
                self.tell(Code::CloseWithoutOpen, span, []);
            }
            return;
        };
        let Some(mut inner) = self.take(")", span) else {
            return;
        };
        if frame.negated {
            inner = self.c.builder.not(inner, span);
        }
        let Acc::Value(outer) = frame.acc else {
            self.acc = Acc::Wrong;
            return;
        };
        let links = self.links + 1;
        let all = vec![accumulated(outer), accumulated(inner)];
        let at = frame.at.to(span);
        let expr = self.c.builder.function(&frame.name, all, at);
        self.hold(expr, links);
        self.unused = Some(at);
    }

    /// MPS
    fn keep(&mut self, one: &Instruction) {
        self.settle_costly();
        if self.take(&one.word.text, one.word.span).is_some() {
            self.kept.push(self.acc.clone());
        }
    }

    /// MRD, MPP
    fn recall(&mut self, one: &Instruction, op: Op) {
        let kept = match op {
            Op::Recall => self.kept.last().cloned(),
            _ => self.kept.pop(),
        };
        let Some(kept) = kept else {
            let why = ("write MPS before it", "escreva MPS antes");
            let words = [one.word.text.as_str().into(), why.into()];
            return self.tell(Code::Structure, one.word.span, words);
        };
        self.warn_unused();
        self.acc = kept;
        self.links = 0;
    }

    /// A function, or a block, by its name alone.
    fn by_name(&mut self, one: &Instruction, at: usize) {
        if let Some(unit) = self.own_function(one) {
            return self.own_call(unit, one, at);
        }
        if self.c.calls_itself(&one.word) {
            self.acc = Acc::Wrong;
            return;
        }
        let word = one.word.text.clone();
        let variable = matches!(self.c.builder.find(&word), Some(Named::Variable(_)));
        if variable && one.given.is_some() {
            return self.cal_named(one, at);
        }
        if self.c.builder.is_function(&word) {
            return self.operate(one, at);
        }
        self.acc = Acc::Wrong;
        self.unused = None;
        if self.c.builder.is_hidden(&word) {
            return;
        }
        let help = match operators::nearest(&word.to_uppercase()) {
            Some(near) => both(format!("is it {near}?"), format!("seria {near}?")),
            None => {
                let otherwise = both(
                    "each line begins with an operator, like LD, AND, OR or ST",
                    "cada linha começa com um operador, como LD, AND, OR ou ST",
                );
                self.c.builder.near(&word, otherwise)
            }
        };
        let words = [word.into(), help];
        self.tell(Code::UnknownOperator, one.word.span, words);
    }

    /// A value of 32 bits that is a time, where it stands without T#.
    pub(super) fn preset_value(&mut self, arg: &Arg) -> Expr {
        let expr = self.c.expr(&arg.node, None);
        match (&expr.kind, expr.base) {
            (ExprKind::Constant(value), Base::AnyInt) => {
                self.c.builder.literal(Base::Time, value.clone(), expr.at)
            }
            _ => expr,
        }
    }
}

/// What an operation takes from the accumulator.
pub(super) fn accumulated(expr: Expr) -> Argument {
    Argument {
        name: None,
        out: false,
        at: expr.at,
        given: Given::Value(expr),
    }
}
