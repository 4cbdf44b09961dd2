//! Statements.

use super::super::ast::{Arm, Counting, Node, NodeKind, Path, Statement, StatementKind};
use super::Checker;
use std::collections::BTreeMap;
use unoclp_text::diagnostics::{Code, Span};
use unoclp_tree::build::{Named, Target, turns};
use unoclp_tree::{Base, Kind, Root, Stmt, StmtKind, Store, UnitKind, Value};

impl Checker<'_, '_, '_> {
    pub(super) fn statements(&mut self, statements: &[Statement]) -> Vec<Stmt> {
        let mut all = Vec::new();
        for statement in statements {
            self.statement(statement, &mut all);
        }
        all
    }

    fn statement(&mut self, statement: &Statement, all: &mut Vec<Stmt>) {
        let at = statement.span;
        let kind = match &statement.kind {
            StatementKind::Assign(path, node) => {
                all.extend(self.assign(path, node, at));
                return;
            }
            StatementKind::Call(path, arguments) => {
                self.call(path, arguments, at, all);
                return;
            }
            StatementKind::Exit | StatementKind::Continue => {
                let kind = match statement.kind {
                    StatementKind::Exit => StmtKind::Exit,
                    _ => StmtKind::Continue,
                };
                all.extend(self.builder.leaves_loop(kind, at));
                return;
            }
            StatementKind::Return if self.in_action => {
                self.return_in_action(at);
                return;
            }
            StatementKind::Return => StmtKind::Return,
            StatementKind::Enabled(en, eno, inner) => {
                self.enabled(en.as_ref(), eno.as_ref(), inner, all);
                return;
            }
            StatementKind::If(arms, otherwise) => {
                let mut made = Vec::new();
                for (condition, body) in arms {
                    let condition = self.condition(condition);
                    made.push((condition, self.statements(body)));
                }
                StmtKind::If(made, self.statements(otherwise))
            }
            StatementKind::Case(selector, arms, otherwise) => self.case(selector, arms, otherwise),
            StatementKind::While(condition, body) => {
                let condition = self.condition(condition);
                self.builder.begin_loop(None);
                let body = self.statements(body);
                self.builder.end_loop(None);
                StmtKind::While(condition, body)
            }
            StatementKind::Repeat(body, until) => {
                self.builder.begin_loop(None);
                let body = self.statements(body);
                self.builder.end_loop(None);
                StmtKind::Repeat(body, self.condition(until))
            }
            StatementKind::For(counting) => {
                self.counting(counting, at, all);
                return;
            }
        };
        all.push(Stmt { kind, at });
    }

    /// A call with EN and ENO.
    fn enabled(
        &mut self,
        en: Option<&Node>,
        eno: Option<&Path>,
        inner: &Statement,
        all: &mut Vec<Stmt>,
    ) {
        let at = inner.span;
        let condition = en.map(|en| self.condition(en));
        let mut done = Vec::new();
        self.statement(inner, &mut done);
        let mut targets: Vec<Target> = self.eno_of(inner).into_iter().collect();
        targets.extend(eno.and_then(|path| self.target(path)));
        let mut tell = |truth: bool| {
            let targets = targets.iter().cloned();
            let told = targets.filter_map(|target| {
                let at = target.at;
                let value = self.builder.literal(Base::Bool, Value::truth(truth), at);
                self.builder.assign(target, value, at)
            });
            told.collect::<Vec<Stmt>>()
        };
        let is_told = tell(true);
        let mut otherwise = match !is_told.is_empty() && condition.is_some() {
            true => tell(false),
            false => Vec::new(),
        };
        if let Some(StmtKind::Assign(to, _, Store::Narrow(Base::Bool))) =
            done.last().map(|s| &s.kind)
        {
            // A truth that nobody has found is none.
            let value = self.builder.literal(Base::Bool, Value::truth(false), at);
            let kind = StmtKind::Assign(to.clone(), value, Store::Narrow(Base::Bool));
            otherwise.push(Stmt { kind, at });
        }
        done.extend(is_told);
        match condition {
            Some(condition) => {
                let kind = StmtKind::If(vec![(condition, done)], otherwise);
                all.push(Stmt { kind, at });
            }
            None => all.append(&mut done),
        }
    }

    /// ENO of the instance that a statement calls, where the text reads one.
    fn eno_of(&mut self, statement: &Statement) -> Option<Target> {
        let StatementKind::Call(path, _) = &statement.kind else {
            return None;
        };
        let is_variable = matches!(self.builder.find(&path.name.text), Some(Named::Variable(_)));
        if !is_variable || !self.reads_eno {
            return None;
        }
        let target = self.target(path)?;
        self.builder.eno(&target)
    }

    pub(super) fn condition(&mut self, node: &Node) -> unoclp_tree::Expr {
        let expr = self.expr(node, None);
        self.builder.condition(expr)
    }

    fn assign(&mut self, path: &Path, node: &Node, at: Span) -> Option<Stmt> {
        if let Some((parts, bit)) = path.bit() {
            let number = self.part_of(path, parts);
            let value = self.expr(node, None);
            return self
                .builder
                .assign_bit(number?, &bit.text, value, bit.span, at);
        }
        let target = self.target(path);
        let Some(target) = target else {
            self.expr(node, None);
            return None;
        };
        if self.builder.tree.types.is_scalar(target.ty) {
            let value = self.expr(node, Some(target.ty));
            return self.builder.assign(target, value, at);
        }
        match &node.kind {
            NodeKind::Path(from) => {
                let from = self.target(from)?;
                self.builder.copy(target, from, at)
            }
            NodeKind::Call(from, arguments) if from.parts.is_empty() => {
                if self.calls_itself(&from.name) {
                    return None;
                }
                let unit = self.builder.callee(&from.name.text, from.name.span)?;
                let given = self.arguments(arguments);
                self.builder.call_into(unit, given, target, node.span)
            }
            _ => {
                let ty = target.ty;
                let value = self.expr(node, None);
                self.builder.coerce(value, ty);
                None
            }
        }
    }

    fn call(
        &mut self,
        path: &Path,
        arguments: &[super::super::ast::Arg],
        at: Span,
        all: &mut Vec<Stmt>,
    ) {
        let name = &path.name;
        if path.parts.is_empty() {
            if self.builder.is_hidden(&name.text) || self.calls_itself(name) {
                return;
            }
            match self.builder.find(&name.text).cloned() {
                Some(Named::Variable(_)) => {}
                Some(Named::Unit(unit)) => {
                    let kind = self.builder.draft(unit).map(|draft| draft.unit.kind);
                    if kind == Some(UnitKind::Function) {
                        let given = self.arguments(arguments);
                        all.extend(self.builder.call_statement(unit, given, name.span, at));
                        return;
                    }
                }
                None if self.builder.is_hidden(&name.text) || self.is_foreign(name) => return,
                None if self.builder.is_function(&name.text) => {
                    let written = self.builder.written(at);
                    self.builder.tell(Code::StNoEffect, at, [written.into()]);
                    return;
                }
                _ => {
                    self.builder.callee(&name.text, name.span);
                    return;
                }
            }
        }
        let Some(target) = self.target(path) else {
            return;
        };
        if self.equals_for_assign(target.ty, arguments) {
            return;
        }
        let given = self.arguments(arguments);
        all.append(&mut self.builder.block(target, given, at));
    }

    fn case(&mut self, selector: &Node, arms: &[Arm], otherwise: &[Statement]) -> StmtKind {
        let selector = self.expr(selector, None);
        let selector = self.builder.selector(selector);
        let hint = Some(selector.ty)
            .filter(|ty| matches!(self.builder.tree.types.kind(*ty), Kind::Enum(_)));
        let mut taken = BTreeMap::new();
        let mut made = Vec::new();
        for arm in arms {
            let mut labels = Vec::new();
            for (low, high) in &arm.labels {
                let low = self.expr(low, hint);
                let high = high.as_ref().map(|high| self.expr(high, hint));
                labels.push((low, high));
            }
            let bounds = self.builder.labels(&selector, labels, &mut taken);
            made.push((bounds, self.statements(&arm.body)));
        }
        StmtKind::Case(selector, made, self.statements(otherwise))
    }

    fn counting(&mut self, counting: &Counting, at: Span, all: &mut Vec<Stmt>) {
        let Counting {
            variable,
            from,
            to,
            by,
            body,
        } = counting;
        let target = self.target(variable);
        let (from, to) = (self.expr(from, None), self.expr(to, None));
        let by = by.as_ref().map(|by| self.expr(by, None));
        let head = self.builder.counting(target, from, to, by, at);
        let counter = head
            .as_ref()
            .map(|head| (head.variable.root, head.variable.offset));
        let turns = head.as_ref().map_or(Vec::new(), |head| turns(head));
        self.builder.begin_loop(counter);
        let (picks, mut bodies) = self.turns(counter, &turns, body);
        self.builder.end_loop(counter);
        let Some(mut head) = head else {
            return;
        };
        if picks {
            return self.builder.unrolled(&head, &turns, bodies, at, all);
        }
        head.body = bodies.pop().unwrap_or_default();
        let kind = StmtKind::For(head);
        all.push(Stmt { kind, at });
    }

    /// The body of a loop; whether its turns pick instances of blocks, and then the body of each.
    fn turns(
        &mut self,
        counter: Option<(Root, u32)>,
        turns: &[i128],
        body: &[Statement],
    ) -> (bool, Vec<Vec<Stmt>>) {
        let Some(counter) = counter.filter(|_| !turns.is_empty()) else {
            return (false, vec![self.statements(body)]);
        };
        let made = |this: &mut Self, turn: i128, is_written: bool| {
            this.builder.begin_turn(counter, turn, is_written);
            let body = this.statements(body);
            (this.builder.end_turn(), body)
        };
        let (picks, first) = made(self, turns.first().copied().unwrap_or(0), false);
        if !picks || self.builder.found.has_errors() {
            return (picks, vec![first]);
        }
        let turns = turns.iter();
        (true, turns.map(|turn| made(self, *turn, true).1).collect())
    }
}
