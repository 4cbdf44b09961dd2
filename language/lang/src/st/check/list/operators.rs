//! What each line does with the accumulator.

use super::super::super::ast::{Arg, Instruction, Line, Node, NodeKind};
use super::walk::{Walk, accumulated};
use crate::diagnostics::{Code, Span};
use crate::list::{
    Acc, Accumulator, Branches, Decides, Defers, Flow, Machine, Opens, Stack, Waiting,
};
use crate::operators::{self, Op};
use crate::typed::build::{Argument, Given, Named, Target, both};
use crate::typed::{Base, Expr, ExprKind, Kind, TypeId, UnitKind, Value};

impl Walk<'_, '_, '_, '_> {
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

    pub(super) fn instruction(&mut self, one: &Instruction) {
        let Some(spelling) = one.spelling.filter(|_| self.own_function(one).is_none()) else {
            return self.by_name(one);
        };
        let needs_operand = spelling.op.takes_operand() && one.given.is_none();
        if needs_operand && one.operands.is_empty() && one.open.is_none() {
            let word = one.word.text.to_uppercase();
            let like = format!("{word} x");
            self.run.acc = Acc::Wrong;
            return self.tell(
                Code::OperandMissing,
                one.word.span,
                [word.into(), like.into()],
            );
        }
        match spelling.op {
            Op::Load => self.load(one),
            Op::Store => self.st(one),
            Op::Set => self.set(one, true),
            Op::Reset => self.set(one, false),
            Op::Not => self.not(one),
            Op::And | Op::Or | Op::Xor | Op::Number(_) | Op::Compare(_) => self.operate(one),
            Op::Shift(_) | Op::Unary(_) => self.operate(one),
            Op::Jump => self.jump_line(one),
            Op::Return | Op::End => self.ret_line(one),
            Op::Part(opcode) => self.part(one.word.span, opcode),
            Op::Call => self.cal(one),
            Op::Timer(_) | Op::CountUp | Op::CountDown => self.timer_or_counter(one),
            Op::Input(_) => self.input(one),
            Op::Preset => self.preset(one),
            Op::Edge(_) => self.edge_of_accumulator(one),
            Op::Differentiate(_) => self.differentiate(one),
            Op::Keep => self.keep_result(one.span),
            Op::Recall | Op::Release => self.recall_result(spelling.op, one.word.span, one.span),
            Op::AndBlock | Op::OrBlock => self.pop_result(spelling.op, one.word.span),
            Op::Push => self.push_line(one),
            Op::Table(opcode) => self.table_line(one, opcode),
            Op::Code => self.code(one),
            _ => self.not_here(one),
        }
    }

    /// An operator of texts without types.
    pub(super) fn not_here(&mut self, one: &Instruction) {
        self.run.acc = Acc::Wrong;
        let help = (
            "it belongs to texts without REAL, TYPE and the functions of the norm; write what it does with LD, ST and the operators of the norm",
            "ele pertence a textos sem REAL, TYPE e as funções da norma; escreva o que ele faz com LD, ST e os operadores da norma",
        );
        let words = [one.word.text.as_str().into(), help.into()];
        self.tell(Code::StUnsupported, one.word.span, words);
    }

    fn load(&mut self, one: &Instruction) {
        if self.run.frames.is_empty() || !matches!(self.run.acc, Acc::Value(_)) {
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
                    self.run.load(None);
                    self.run.acc = Acc::Whole(target);
                    return;
                }
                Some(target) => {
                    let expr = self.c.builder.read(Some(target), arg.node.span);
                    self.loaded(expr, one);
                }
                None => self.run.acc = Acc::Wrong,
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
        let inverts = std::mem::take(&mut self.run.inverts);
        if one.spelling.and_then(|spelling| spelling.edge).is_some() {
            expr = self.edge(expr, one.span);
        }
        if inverts != one.spelling.is_some_and(|spelling| spelling.negated) {
            expr = self.c.builder.not(expr, one.span);
        }
        self.run.load(Some(expr));
        self.run.unused = Some(one.span);
    }

    fn st(&mut self, one: &Instruction) {
        self.undecided();
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
            self.run.unused = None;
            return;
        };
        let needed = self.needed();
        if let Acc::Whole(from) = self.run.acc.clone() {
            self.run.unused = None;
            let statement = self.c.builder.copy(target, from, one.span);
            return statement.into_iter().for_each(|one| self.does(one, needed));
        }
        let stays = self.stays(&target);
        if needed && !stays {
            self.settle_costly();
        }
        let Some(mut value) = self.peek(&one.word.text, one.word.span) else {
            return;
        };
        if one.spelling.is_some_and(|spelling| spelling.negated) {
            value = self.c.builder.not(value, one.span);
        }
        // What has just been stored in a bit is there for the next store.
        let is_read = |acc: &Acc| matches!(acc, Acc::Value(expr) if expr.base == Base::Bool && matches!(expr.kind, ExprKind::Read(_)));
        let costs = self.run.links > 0 || is_read(&self.run.acc);
        let reads = stays && costs && !one.spelling.is_some_and(|s| s.negated);
        let again = reads.then(|| target.clone());
        let Some(statement) = self.c.builder.assign(target, value, one.span) else {
            return;
        };
        self.does(statement, needed && again.is_none());
        if let Some(again) = again.filter(|_| needed) {
            let held = self.c.builder.read(Some(again), one.span);
            self.run.load(Some(held));
        }
    }

    /// Whether a variable holds after ST just what the accumulator does.
    fn stays(&self, target: &Target) -> bool {
        let Acc::Value(expr) = &self.run.acc else {
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
    fn set(&mut self, one: &Instruction, to: bool) {
        // S1 and R1 are inputs of latches.
        let own = one.word.text.to_uppercase();
        let input = self.latch_input(one, to);
        if let Some(input) = input.or(Some(&*own).filter(|word| word.ends_with('1'))) {
            return self.give(one, input);
        }
        let held = self.run.decided.is_some() || {
            let expr = self.take(&one.word.text, one.word.span);
            let condition = expr.and_then(|expr| self.tested(expr, one.span));
            self.hold(condition);
            matches!(self.run.acc, Acc::Value(_))
        };
        self.run.unused = None;
        let mut body = Vec::new();
        for arg in &one.operands {
            let NodeKind::Path(path) = &arg.node.kind else {
                let written = self.c.builder.written(arg.node.span);
                return self.tell(Code::NotWritable, arg.node.span, [written.into()]);
            };
            let target = self.c.target(path);
            let value = Value::truth(to);
            let value = self.c.builder.literal(Base::Bool, value, one.span);
            body.extend(target.and_then(|to| self.c.builder.assign(to, value, one.span)));
        }
        if held && !body.is_empty() {
            self.decide(body, one.span);
        }
    }

    /// The input of a latch that S or R gives.
    fn latch_input(&self, one: &Instruction, set: bool) -> Option<&'static str> {
        let [arg] = one.operands.as_slice() else {
            return None;
        };
        let NodeKind::Path(path) = &arg.node.kind else {
            return None;
        };
        let builder = &self.c.builder;
        match builder.find(&path.name.text) {
            Some(Named::Variable(of)) if path.parts.is_empty() => {
                match builder.tree.types.kind(of.ty) {
                    Kind::Standard(block) => block.latch_input(set),
                    _ => None,
                }
            }
            _ => None,
        }
    }

    fn not(&mut self, one: &Instruction) {
        let Some(expr) = self.take(&one.word.text, one.word.span) else {
            return;
        };
        let expr = self.c.builder.not(expr, one.span);
        self.hold(Some(expr));
        self.run.unused = Some(one.span);
    }

    /// An operation on the accumulator and what follows the operator, or in parentheses on the lines that follow.
    fn operate(&mut self, one: &Instruction) {
        let word = one.word.text.to_uppercase();
        let Some(name) = self.function_of(one, &word) else {
            return self.not_here(one);
        };
        if let Some(negated) = one.open {
            return self.open(one, name, negated);
        }
        if one.given.is_some() {
            return self.formal(one, &name);
        }
        let Some(expr) = self.take(&one.word.text, one.word.span) else {
            self.c.arguments(&one.operands);
            return;
        };
        let ty = expr.ty;
        if name == "NEG" {
            let expr = self.c.builder.negate(expr, one.span);
            self.hold(Some(expr));
            self.link();
            self.run.unused = Some(one.span);
            return;
        }
        if self.is_popped(one) {
            let popped = self.popped_number(one.span);
            let made = popped.map(|popped| {
                let all = vec![accumulated(popped), accumulated(expr)];
                self.c.builder.function(&name, all, one.span)
            });
            self.hold(made);
            return self.link();
        }
        let mut all = vec![accumulated(expr)];
        for (number, arg) in one.operands.iter().enumerate() {
            let at = if number == 0 { one.span } else { arg.node.span };
            let given = self.operand(arg, one, at, ty);
            all.push(given);
        }
        let expr = self.c.builder.function(&name, all, one.span);
        self.hold(Some(expr));
        self.link();
        self.run.unused = Some(one.span);
    }

    /// An operand; a value of the accumulator's own enumeration is looked for there.
    fn operand(&mut self, arg: &Arg, one: &Instruction, at: Span, with: TypeId) -> Argument {
        let spelling = one.spelling;
        let negated = spelling.is_some_and(|spelling| spelling.negated);
        let edge = spelling.is_some_and(|spelling| spelling.edge.is_some());
        let mut expr = self.value(&arg.node, Some(with));
        if edge {
            expr = self.edge(expr, at);
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
    fn open(&mut self, one: &Instruction, name: String, negated: bool) {
        let inverts = one.spelling.is_some_and(|spelling| spelling.negated);
        let opens = Opens {
            what: &one.word.text,
            operator: one.word.span,
            at: one.span,
            negated,
            loads: is_load(self.lines.get(self.run.at + 1)),
        };
        let first = one.operands.first();
        let first = first.map(|arg| |walk: &mut Self| Some(walk.value(&arg.node, None)));
        self.defer(Waiting::Function(name, inverts), &opens, first);
    }

    /// A function, or a block, by its name alone.
    fn by_name(&mut self, one: &Instruction) {
        if let Some(unit) = self.own_function(one) {
            return self.own_call(unit, one);
        }
        if self.c.calls_itself(&one.word) {
            self.run.acc = Acc::Wrong;
            return;
        }
        let word = one.word.text.clone();
        let variable = matches!(self.c.builder.find(&word), Some(Named::Variable(_)));
        if variable && one.given.is_some() {
            return self.cal_named(one);
        }
        if self.c.builder.is_function(&word) {
            return self.operate(one);
        }
        self.run.acc = Acc::Wrong;
        self.run.unused = None;
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

/// Whether this operator loads.
fn is_load(line: Option<&Line>) -> bool {
    matches!(line, Some(Line::Does(one)) if one.spelling.is_some_and(|s| s.op == Op::Load))
}
