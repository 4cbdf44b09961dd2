//! Names and types: from the syntax tree to the typed tree.
//!
//! Owns what a name stands for and what goes where. `operands` says which types an operator joins; what comes of
//! them is the builder's to say.

use super::ast::{Counting, Decl, Name, Node, NodeKind, Op, Program, Statement, StatementKind};
use unoclp_core::Board;
use unoclp_text::diagnostics::{Code, Found, Span, Word};
use unoclp_text::near::nearest;
use unoclp_tree::build::{Builder, Letters, Section, Target, Traits, both};
use unoclp_tree::{Base, Expr, ExprKind, Stmt, StmtKind, Tree, TypeId, UnitKind};

/// For more names than this, no near one is looked for.
const MOST_NEAR: u32 = 32;

pub(super) struct Checker<'t, 'f> {
    pub builder: Builder<'t, 'f>,
    /// The names that are declared, as they are written.
    names: Vec<String>,
    asked: u32,
}

pub(super) fn check(
    text: &str,
    program: &Program,
    board: Board,
    found: &mut Found,
) -> Option<Tree> {
    let mut checker = Checker {
        builder: Builder::new(text, Letters::Alike, board, found),
        names: Vec::new(),
        asked: 0,
    };
    checker.builder.divides_by_zero = true;
    let unit = checker
        .builder
        .unit("BLOCO", UnitKind::Program, program.span);
    let before = checker.builder.enter(&unit);
    for decl in &program.decls {
        checker.declare(decl);
    }
    let unit = checker.builder.close(unit);
    // BLOCO END_BLOCK is a program.
    checker.builder.may_do_nothing();
    let body = checker.statements(&program.body);
    checker.builder.back(before);
    checker.builder.body(unit, body);
    checker.builder.finish()
}

impl Checker<'_, '_> {
    fn declare(&mut self, decl: &Decl) {
        let Decl { base, name, point } = decl;
        if *base == Base::AnyInt {
            // Of no known type, which has been told.
            self.builder.hide(&name.text);
            return;
        }
        let ty = TypeId::of(*base);
        let mut traits = Traits::default();
        if let Some(address) = point {
            traits.point = self.builder.address_for(&address.text, ty, address.span);
            if traits.point.is_none() {
                self.builder.hide(&name.text);
                return;
            }
        }
        self.names.push(name.text.clone());
        self.builder
            .declare(&name.text, name.span, ty, Section::Var, traits);
    }

    /// What a name stands for; none where nothing declares it, which is told once.
    fn target(&mut self, name: &Name) -> Option<Target> {
        if self.builder.is_hidden(&name.text) {
            return None;
        }
        if self.builder.find(&name.text).is_none() {
            self.told_undeclared(name);
            self.builder.hide(&name.text);
            return None;
        }
        self.builder.name(&name.text, name.span)
    }

    fn told_undeclared(&mut self, name: &Name) {
        self.asked += 1;
        let names = self.names.iter().map(String::as_str);
        let near = match self.asked > MOST_NEAR {
            true => None,
            false => nearest(&name.text, names),
        };
        let text = &name.text;
        let help = match near {
            Some(near) => Word::Near(near.to_string()),
            None => both(
                format!("declare it after BLOCO: INT {text};"),
                format!("declare-o depois de BLOCO: INT {text};"),
            ),
        };
        self.builder.tell(
            Code::IsclUndeclared,
            name.span,
            [text.as_str().into(), help],
        );
    }

    fn statements(&mut self, statements: &[Statement]) -> Vec<Stmt> {
        let all = statements.iter();
        all.filter_map(|statement| self.statement(statement))
            .collect()
    }

    fn statement(&mut self, statement: &Statement) -> Option<Stmt> {
        let at = statement.span;
        let kind = match &statement.kind {
            StatementKind::Assign(name, value) => {
                let target = self.target(name);
                let value = self.expr(value);
                return self.assign(target?, value, at);
            }
            StatementKind::Print(name) => {
                let target = self.target(name)?;
                let value = self.builder.read(Some(target), name.span);
                let shown = self.builder.print(&name.text, value, at);
                return shown;
            }
            StatementKind::If(condition, then, otherwise) => {
                let condition = self.condition(condition);
                let then = self.statements(then);
                StmtKind::If(vec![(condition, then)], self.statements(otherwise))
            }
            StatementKind::While(condition, body) => {
                let condition = self.condition(condition);
                self.builder.begin_loop(None);
                let body = self.statements(body);
                self.builder.end_loop(None);
                StmtKind::While(condition, body)
            }
            StatementKind::For(counting) => self.counting(counting, at)?,
        };
        Some(Stmt { kind, at })
    }

    fn assign(&mut self, target: Target, value: Expr, at: Span) -> Option<Stmt> {
        if matches!(value.kind, ExprKind::Wrong) {
            return None;
        }
        let held = self.builder.tree.types.base(target.ty)?;
        if !self.fits(&value, held) {
            self.told_mismatch(&target, &value, held);
            return None;
        }
        self.builder.assign(target, value, at)
    }

    fn condition(&mut self, node: &Node) -> Expr {
        let expr = self.expr(node);
        self.builder.condition(expr)
    }

    fn counting(&mut self, counting: &Counting, at: Span) -> Option<StmtKind> {
        let variable = self.target(&counting.variable);
        let (from, to) = (self.expr(&counting.from), self.expr(&counting.to));
        let head = variable.and_then(|variable| self.head(variable, from, to, at));
        let counter = head
            .as_ref()
            .map(|head| (head.variable.root, head.variable.offset));
        self.builder.begin_loop(counter);
        let body = self.statements(&counting.body);
        self.builder.end_loop(counter);
        let mut head = head?;
        head.body = body;
        Some(StmtKind::For(head))
    }

    /// FOR counts with an INT, from an INT to an INT.
    fn head(
        &mut self,
        variable: Target,
        from: Expr,
        to: Expr,
        at: Span,
    ) -> Option<Box<unoclp_tree::For>> {
        let held = self.builder.tree.types.base(variable.ty)?;
        if held != Base::Int {
            let written = self.builder.written(variable.at);
            let words = [written.into(), held.name().into()];
            self.builder.tell(Code::IsclForVariable, variable.at, words);
            return None;
        }
        for bound in [&from, &to] {
            if matches!(bound.kind, ExprKind::Wrong) {
                return None;
            }
            if !self.fits(bound, Base::Int) {
                self.told_mismatch(&variable, bound, Base::Int);
                return None;
            }
        }
        self.builder.counting(Some(variable), from, to, None, at)
    }

    fn expr(&mut self, node: &Node) -> Expr {
        let at = node.span;
        match &node.kind {
            NodeKind::Wrong => self.builder.wrong(at),
            NodeKind::Literal(base, value) => self.builder.literal(*base, value.clone(), at),
            NodeKind::Name(name) => {
                let target = self.target(name);
                self.builder.read(target, at)
            }
            NodeKind::Negate(inner) => {
                let inner = self.expr(inner);
                match self.is_number("-", &inner) {
                    true => self.builder.negate(inner, at),
                    false => self.builder.wrong(at),
                }
            }
            NodeKind::Not(inner) => {
                let inner = self.expr(inner);
                match self.is_bit("NOT", &inner) {
                    true => self.builder.not(inner, at),
                    false => self.builder.wrong(at),
                }
            }
            NodeKind::Binary(op, a, b) => {
                let (a, b) = (self.expr(a), self.expr(b));
                self.joined(*op, a, b, at)
            }
        }
    }

    fn joined(&mut self, op: Op, a: Expr, b: Expr, at: Span) -> Expr {
        if !self.goes_with(op, &a, &b, at) {
            return self.builder.wrong(at);
        }
        match op {
            Op::Arithmetic(op) => self.builder.arithmetic(op, a, b, at),
            Op::Logic(op) => self.builder.logic(op, a, b, at),
            Op::Compare(op) => self.builder.compare(op, a, b, at),
        }
    }

    /// The type of a value, in words.
    pub(super) fn type_of(&self, expr: &Expr) -> Word {
        match expr.base {
            Base::AnyInt => ("a whole number", "um número inteiro").into(),
            Base::AnyReal => ("a number with a fraction", "um número com casas decimais").into(),
            base => base.name().into(),
        }
    }
}
