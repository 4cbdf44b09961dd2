//! From the typed tree to a program without calls: statements.
//!
//! Owns its steps, labels and cells. Must not know the board.

use super::flat::{Does, Flat, Step};
use super::pure;
use std::collections::HashMap;
use unoclp_point::Address;
use unoclp_text::diagnostics::{Code, Found, Span};
use unoclp_tree::{Base, Cell, Expr, Order, Place, Stmt, StmtKind, Tree};

/// More steps than this fit no board.
pub(super) const MOST_STEPS: usize = 4_000;
/// Statements stand in one another no deeper, with all calls in it: more labels than a board has.
const MOST_DEEP: u32 = 250;
/// Nor do expressions: more than one alone may have, and more operands than fit a board.
pub(super) const MOST_HIGH: u32 = 400;

/// The cells of a call.
#[derive(Clone, Debug, Default)]
pub(super) struct Frame {
    pub own: u32,
    pub local: u32,
    pub lent: Vec<Place>,
    /// Locals in whose place stands what the caller gives.
    pub given: HashMap<u32, Expr>,
    /// After the body, and whether something jumps there.
    pub end: Option<u32>,
    pub ended: bool,
    /// The labels of its statements, which jumps name.
    pub targets: HashMap<u32, u32>,
}

/// What leaves a loop, and what goes on with its next turn; a label that is used is there.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Inner {
    pub exit: Option<u32>,
    pub next: Option<u32>,
}

pub(super) struct Inliner<'t, 'f> {
    pub tree: &'t Tree,
    /// The cells that are analogue inputs.
    pub analogue: Vec<u32>,
    /// The units that change nothing but their own.
    pub pure: Vec<bool>,
    pub flat: Flat,
    /// The steps that are being made.
    pub out: Vec<Step>,
    pub loops: Vec<Inner>,
    /// The innermost loop's number.
    pub inner: Option<usize>,
    pub steps: usize,
    /// How many statements are open around this one, those of the callers among them.
    pub deep: u32,
    /// The same of expressions.
    pub high: u32,
    pub too_large: Option<Span>,
    /// Where a unit that does not stand in the text is called: its steps stand there.
    pub brought: Option<Span>,
    pub found: &'f mut Found,
}

/// The program without its calls.
pub(super) fn inline(tree: &Tree, found: &mut Found) -> Flat {
    let points = tree.points.iter();
    let analogue = points.filter(|(_, point)| matches!(point, Address::Analogue(_)));
    let mut inliner = Inliner {
        tree,
        analogue: analogue.map(|(cell, _)| *cell).collect(),
        pure: pure::pure_units(tree),
        flat: Flat {
            cells: tree.cells.clone(),
            ..Flat::default()
        },
        out: Vec::new(),
        loops: Vec::new(),
        inner: None,
        steps: 0,
        deep: 0,
        high: 0,
        too_large: None,
        brought: None,
        found,
    };
    for &number in &tree.programs {
        if let Some(unit) = tree.units.get(number as usize) {
            let mut frame = inliner.enter(number, unit, 0, unit.at);
            inliner.body(unit, &mut frame);
            if tree.programs.last() == Some(&number) && frame.ended {
                inliner.flat.leaves.extend(frame.end);
            }
        }
    }
    if let Some(at) = inliner.too_large {
        inliner.found.tell(Code::BoardTooLarge, at, []);
    }
    inliner.flat.body = inliner.out;
    inliner.flat
}

impl Inliner<'_, '_> {
    /// What a statement needs besides what it says.
    pub(super) fn push(&mut self, does: Does, at: Span) {
        let shown = false;
        self.add(Step { does, at, shown });
    }

    /// What a statement says, for its line to show.
    pub(super) fn show(&mut self, does: Does, at: Span) {
        let shown = true;
        self.add(Step { does, at, shown });
    }

    fn add(&mut self, mut step: Step) {
        step.at = self.brought.unwrap_or(step.at);
        self.steps += 1;
        if self.steps > MOST_STEPS {
            self.too_large.get_or_insert(step.at);
            return;
        }
        self.out.push(step);
    }

    pub(super) fn label(&mut self) -> u32 {
        self.flat.labels += 1;
        self.flat.labels - 1
    }

    /// A cell for something between two statements.
    pub(super) fn temporary(&mut self, base: Base) -> u32 {
        self.flat.cells.push(Cell::own(base));
        self.flat.cells.len() as u32 - 1
    }

    /// What these statements become, on their own.
    pub(super) fn apart(&mut self, make: impl FnOnce(&mut Self)) -> Vec<Step> {
        let before = std::mem::take(&mut self.out);
        make(self);
        std::mem::replace(&mut self.out, before)
    }

    pub(super) fn statements(&mut self, statements: &[Stmt], frame: &mut Frame) {
        for statement in statements {
            self.statement(statement, frame);
        }
    }

    pub(super) fn statement(&mut self, statement: &Stmt, frame: &mut Frame) {
        self.nested(statement.at, |this| this.any_statement(statement, frame));
    }

    /// Makes what stands in another statement; nothing where that goes too deep, or the program is too large.
    fn nested(&mut self, at: Span, make: impl FnOnce(&mut Self)) {
        if self.deep >= MOST_DEEP {
            self.too_large.get_or_insert(at);
        }
        if self.too_large.is_some() {
            return;
        }
        self.deep += 1;
        make(self);
        self.deep -= 1;
    }

    fn any_statement(&mut self, statement: &Stmt, frame: &mut Frame) {
        let at = statement.at;
        match &statement.kind {
            StmtKind::Assign(to, value, store) => {
                let value = self.expr(value, frame);
                let to = self.place(to, frame);
                self.show(Does::Assign(to, value, *store), at);
            }
            StmtKind::Copy(to, from, cells) => {
                let (from, to) = (self.place(from, frame), self.place(to, frame));
                self.push(Does::Copy(to, from, *cells), at);
            }
            StmtKind::If(arms, otherwise) => self.choice(arms, otherwise, at, frame),
            StmtKind::Case(selector, arms, otherwise) => {
                let selector = self.expr(selector, frame);
                let mut made = Vec::with_capacity(arms.len());
                for (bounds, body) in arms {
                    let body = self.apart(|this| this.statements(body, frame));
                    made.push((bounds.clone(), body));
                }
                let otherwise = self.apart(|this| this.statements(otherwise, frame));
                self.show(Does::Case(selector, made, otherwise), at);
            }
            StmtKind::While(condition, body) => self.while_loop(condition, body, at, frame),
            StmtKind::Repeat(body, until) => self.repeat(body, until, at, frame),
            StmtKind::For(head) => self.counting(head, at, frame),
            StmtKind::Exit => self.leave(at, |inner| &mut inner.exit),
            StmtKind::Continue => self.leave(at, |inner| &mut inner.next),
            StmtKind::Return => {
                let end = match frame.end {
                    Some(end) => end,
                    None => self.label(),
                };
                frame.end = Some(end);
                frame.ended = true;
                self.push(Does::Jump(None, end, None), at);
            }
            StmtKind::Call(call) => {
                self.call(call, frame);
            }
            StmtKind::Standard(block, instance) => {
                let cell = self.place(instance, frame).offset;
                self.show(Does::Standard(*block, cell, Vec::new()), at);
            }
            StmtKind::Order(order, block, instance) => {
                let order = match order {
                    Order::Preset(value) => Order::Preset(self.expr(value, frame)),
                    Order::Number(value) => Order::Number(self.expr(value, frame)),
                    other => other.clone(),
                };
                let cell = self.place(instance, frame).offset;
                self.show(Does::Order(order, *block, cell), at);
            }
            StmtKind::Codes(codes) => {
                let before = codes.before.as_ref().map(|before| self.expr(before, frame));
                let behind = codes.behind.as_ref();
                let behind = behind.map(|behind| self.place(behind, frame).offset);
                self.show(Does::Codes(before, codes.codes.clone(), behind), at);
            }
            // It shows a variable, which the symbols tell of; it takes no code.
            StmtKind::Print(..) => {}
            StmtKind::Jump(condition, to) => {
                let condition = condition.as_ref().map(|c| self.expr(c, frame));
                if let Some(&label) = frame.targets.get(to) {
                    self.show(Does::Jump(condition, label, None), at);
                }
            }
        }
    }

    fn leave(&mut self, at: Span, which: impl Fn(&mut Inner) -> &mut Option<u32>) {
        let label = self.flat.labels;
        let Some(inner) = self.loops.last_mut() else {
            return;
        };
        let wanted = which(inner);
        let label = match *wanted {
            Some(label) => label,
            None => {
                *wanted = Some(label);
                self.flat.labels += 1;
                label
            }
        };
        self.push(Does::Jump(None, label, None), at);
    }

    fn choice(
        &mut self,
        arms: &[(Expr, Vec<Stmt>)],
        otherwise: &[Stmt],
        at: Span,
        frame: &mut Frame,
    ) {
        // From the last to the first would turn the labels round, so each ELSIF is made within the arm before.
        let Some(((condition, body), rest)) = arms.split_first() else {
            self.statements(otherwise, frame);
            return;
        };
        let condition = self.expr(condition, frame);
        let then = self.apart(|this| this.statements(body, frame));
        let otherwise = self.apart(|this| match rest.is_empty() {
            true => this.statements(otherwise, frame),
            false => {
                let at = rest.first().map_or(at, |(condition, _)| condition.at);
                this.nested(at, |this| this.choice(rest, otherwise, at, frame));
            }
        });
        self.show(Does::If(condition, then, otherwise), at);
    }
}
