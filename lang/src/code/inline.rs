//! From the typed tree to a program without calls: the body of each unit in the place of each of its calls.
//!
//! Owns the cells of calls and the order in which what is called and what calls it are computed. Must not know the
//! board.

use super::flat::{Does, Flat, Step, constant, expr, place, read};
use super::pure;
use super::ranges::ANALOGUE;
use crate::diagnostics::{Code, Found, Span};
use crate::typed::{
    Base, Binary, Call, Cell, Convert, Expr, ExprKind, Input, Place, Point, Root, Stmt, StmtKind,
    Store, Tree, Unary, Unit, UnitKind, Value, Width,
};
use std::collections::HashMap;

/// More steps than this fit no board.
const MOST_STEPS: usize = 4_000;

/// The cells of a call.
#[derive(Clone, Debug, Default)]
pub(super) struct Frame {
    own: u32,
    local: u32,
    lent: Vec<Place>,
    /// Locals in whose place stands what the caller gives.
    given: HashMap<u32, Expr>,
    /// Behind the body, and whether something jumps there.
    end: Option<u32>,
    ended: bool,
    /// The labels of its statements, which jumps name.
    targets: HashMap<u32, u32>,
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
    analogue: Vec<u32>,
    /// The units that change nothing but their own.
    pure: Vec<bool>,
    pub flat: Flat,
    /// The steps that are being made.
    pub out: Vec<Step>,
    pub loops: Vec<Inner>,
    /// The innermost loop's number.
    pub inner: Option<usize>,
    steps: usize,
    pub too_large: Option<Span>,
    pub found: &'f mut Found,
}

/// The program without its calls.
pub(super) fn inline(tree: &Tree, found: &mut Found) -> Flat {
    let points = tree.points.iter();
    let analogue = points.filter(|(_, point)| matches!(point, Point::Analogue(_)));
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
        too_large: None,
        found,
    };
    for &number in &tree.programs {
        if let Some(unit) = tree.units.get(number as usize) {
            let mut frame = inliner.enter(unit, 0, unit.at);
            inliner.body(unit, &mut frame);
        }
    }
    if let Some(at) = inliner.too_large {
        inliner.found.tell(Code::BoardTooLarge, at, []);
    }
    inliner.flat.body = inliner.out;
    inliner.flat
}

impl Inliner<'_, '_> {
    pub(super) fn push(&mut self, does: Does, at: Span) {
        self.steps += 1;
        if self.steps > MOST_STEPS {
            self.too_large.get_or_insert(at);
            return;
        }
        self.out.push(Step { does, at });
    }

    pub(super) fn label(&mut self) -> u32 {
        self.flat.labels += 1;
        self.flat.labels - 1
    }

    /// A cell for something between two statements.
    pub(super) fn temporary(&mut self, base: Base) -> u32 {
        self.flat.cells.push(Cell {
            base,
            initial: Value::zero(base),
            retain: false,
        });
        self.flat.cells.len() as u32 - 1
    }

    /// What these statements become, on their own.
    pub(super) fn apart(&mut self, make: impl FnOnce(&mut Self)) -> Vec<Step> {
        let before = std::mem::take(&mut self.out);
        make(self);
        std::mem::replace(&mut self.out, before)
    }

    /// Makes the cells of a call.
    fn enter(&mut self, unit: &Unit, own: u32, at: Span) -> Frame {
        let local = self.flat.cells.len() as u32;
        if self.flat.cells.len() > 100_000 {
            self.too_large.get_or_insert(at);
        } else {
            self.flat.cells.extend(unit.locals.iter().cloned());
        }
        Frame {
            own,
            local,
            ..Frame::default()
        }
    }

    /// Gives each local its first value that is not stored before it is read.
    fn begin(&mut self, unit: &Unit, frame: &Frame, stored: &[u32]) {
        for (offset, cell) in (0..).zip(&unit.locals) {
            if stored.contains(&offset) || pure::is_stored_first(unit, offset) {
                continue;
            }
            let value = constant(cell.initial.clone(), cell.base, unit.at);
            let to = place(frame.local + offset, unit.at);
            self.push(Does::Assign(to, value, Store::Narrow(cell.base)), unit.at);
        }
    }

    fn body(&mut self, unit: &Unit, frame: &mut Frame) {
        if unit.kind != UnitKind::Function {
            self.begin(unit, frame, &[]);
        }
        let loops = std::mem::take(&mut self.loops);
        for target in pure::targets(unit) {
            let label = self.label();
            frame.targets.insert(target, label);
        }
        let count = unit.body.len() as u32;
        for (number, statement) in (0..).zip(&unit.body) {
            if self.too_large.is_some() {
                break;
            }
            self.target(frame, number, statement.at);
            self.statement(statement, frame);
        }
        self.target(frame, count, unit.at);
        if let Some(end) = frame.end.filter(|_| frame.ended) {
            self.push(Does::Label(end), unit.at);
        }
        self.loops = loops;
    }

    fn target(&mut self, frame: &Frame, number: u32, at: Span) {
        if let Some(&label) = frame.targets.get(&number) {
            self.push(Does::Label(label), at);
        }
    }

    pub(super) fn statements(&mut self, statements: &[Stmt], frame: &mut Frame) {
        for statement in statements {
            self.statement(statement, frame);
        }
    }

    fn statement(&mut self, statement: &Stmt, frame: &mut Frame) {
        let at = statement.at;
        if self.too_large.is_some() {
            return;
        }
        match &statement.kind {
            StmtKind::Assign(to, value, store) => {
                let value = self.expr(value, frame);
                let to = self.place(to, frame);
                self.push(Does::Assign(to, value, *store), at);
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
                self.push(Does::Case(selector, made, otherwise), at);
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
                self.push(Does::Standard(*block, cell, Vec::new()), at);
            }
            // It shows a variable, which the symbols tell of; it takes no code.
            StmtKind::Print(..) => {}
            StmtKind::Jump(condition, to) => {
                let condition = condition.as_ref().map(|c| self.expr(c, frame));
                if let Some(&label) = frame.targets.get(to) {
                    self.push(Does::Jump(condition, label, None), at);
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
                this.choice(rest, otherwise, at, frame);
            }
        });
        self.push(Does::If(condition, then, otherwise), at);
    }

    pub(super) fn place(&mut self, from: &Place, frame: &Frame) -> Place {
        let mut made = match from.root {
            Root::Static => place(0, from.at),
            Root::Own => place(frame.own, from.at),
            Root::Local => place(frame.local, from.at),
            Root::Lent(number) => match frame.lent.get(number as usize) {
                Some(lent) => lent.clone(),
                None => place(0, from.at),
            },
        };
        made.at = from.at;
        made.offset += from.offset;
        for index in &from.indices {
            let subscript = self.expr(&index.subscript, frame);
            made.indices.push(crate::typed::Index {
                subscript,
                ..index.clone()
            });
        }
        made
    }

    pub(super) fn expr(&mut self, from: &Expr, frame: &Frame) -> Expr {
        let kind = match &from.kind {
            ExprKind::Constant(_) | ExprKind::Wrong => from.kind.clone(),
            ExprKind::Read(place) => {
                if place.root == Root::Local
                    && place.indices.is_empty()
                    && let Some(given) = frame.given.get(&place.offset)
                {
                    return given.clone();
                }
                let place = self.place(place, frame);
                let ty = match self.analogue.contains(&place.offset) {
                    true => ANALOGUE,
                    false => from.ty,
                };
                let kind = ExprKind::Read(Box::new(place));
                return Expr {
                    kind,
                    ty,
                    ..from.clone_without_kind()
                };
            }
            ExprKind::Convert(how, a) => ExprKind::Convert(*how, Box::new(self.expr(a, frame))),
            ExprKind::Unary(op, a) => ExprKind::Unary(*op, Box::new(self.expr(a, frame))),
            ExprKind::Binary(op, a, b) => {
                let [a, b] = self.operands([&**a, &**b], frame);
                ExprKind::Binary(*op, Box::new(a), Box::new(b))
            }
            ExprKind::Compare(op, a, b) => {
                let [a, b] = self.operands([&**a, &**b], frame);
                ExprKind::Compare(*op, Box::new(a), Box::new(b))
            }
            ExprKind::Select(three) => {
                let made = self.operands([&three[0], &three[1], &three[2]], frame);
                ExprKind::Select(Box::new(made))
            }
            ExprKind::Ordered(op, all) => ExprKind::Ordered(*op, self.all(all, frame)),
            ExprKind::Extra(function, all) => ExprKind::Extra(*function, self.all(all, frame)),
            ExprKind::Mux(which, all) => {
                let which = self.expr(which, frame);
                ExprKind::Mux(Box::new(which), self.all(all, frame))
            }
            ExprKind::Call(call) => {
                let Some(result) = self.call(call, frame) else {
                    return constant(Value::zero(from.base), from.base, from.at);
                };
                // A later call of the same function has cells of its own, so this stays.
                return Expr {
                    ty: from.ty,
                    ..read(result, from.base, from.at)
                };
            }
        };
        Expr {
            kind,
            ..from.clone_without_kind()
        }
    }

    /// Operands in their order: what a call behind them might change is put aside.
    fn operands<const N: usize>(&mut self, from: [&Expr; N], frame: &Frame) -> [Expr; N] {
        let mut at = 0;
        from.map(|operand| {
            let made = self.expr(operand, frame);
            at += 1;
            match from[at..]
                .iter()
                .any(|later| pure::may_change(&self.pure, later))
            {
                true => self.aside(made),
                false => made,
            }
        })
    }

    fn all(&mut self, from: &[Expr], frame: &Frame) -> Vec<Expr> {
        let mut made = Vec::with_capacity(from.len());
        for (at, operand) in from.iter().enumerate() {
            let value = self.expr(operand, frame);
            let later = from.get(at + 1..).unwrap_or_default();
            made.push(
                match later.iter().any(|l| pure::may_change(&self.pure, l)) {
                    true => self.aside(value),
                    false => value,
                },
            );
        }
        made
    }

    /// A value in a cell of its own, which is not narrowed: nothing is stored there.
    pub(super) fn aside(&mut self, value: Expr) -> Expr {
        if matches!(value.kind, ExprKind::Constant(_)) {
            return value;
        }
        let at = value.at;
        let base = match value.base.width() {
            Width::Signed => Base::Dint,
            _ => value.base,
        };
        let cell = self.temporary(base);
        self.push(
            Does::Assign(place(cell, at), value, Store::Narrow(base)),
            at,
        );
        read(cell, base, at)
    }

    /// A place whose subscripts are computed now.
    fn settled(&mut self, mut place: Place) -> Place {
        for index in &mut place.indices {
            let subscript = std::mem::replace(&mut index.subscript, zero());
            index.subscript = self.aside(subscript);
        }
        place
    }

    /// Calls a unit of the text; the cell of a function's result.
    fn call(&mut self, call: &Call, frame: &Frame) -> Option<u32> {
        let tree = self.tree;
        let unit = tree.units.get(call.unit as usize)?;
        // A call of what does nothing counts too, so that calls in calls come to an end.
        self.steps += 1;
        if self.steps > MOST_STEPS {
            self.too_large.get_or_insert(call.at);
        }
        if self.too_large.is_some() {
            return None;
        }
        let own = match &call.instance {
            Some(instance) => self.place(instance, frame).offset,
            None => 0,
        };
        let is_pure = self.pure.get(call.unit as usize).copied().unwrap_or(true);
        let many = call.inputs.len() > 1 && !is_pure;
        let mut given = HashMap::new();
        let mut values = Vec::with_capacity(call.inputs.len());
        let mut stored = Vec::new();
        for input in &call.inputs {
            match input {
                Input::Value(offset, value, store) => {
                    let value = self.expr(value, frame);
                    let simple = is_pure && call.instance.is_none();
                    let simple = simple && !pure::is_written(unit, *offset);
                    match unit.locals.get(*offset as usize) {
                        Some(cell) if simple && as_given(&value, *store, cell.base) => {
                            given.insert(*offset, narrowed(value, cell.base));
                        }
                        _ => {
                            let value = if many { self.aside(value) } else { value };
                            values.push((*offset, value, *store));
                        }
                    }
                    stored.push(*offset);
                }
                Input::Cells(offset, from, cells) => {
                    let from = self.place(from, frame);
                    stored.extend(*offset..*offset + *cells);
                    values.push((*offset, read_place(from, *cells), Store::Text(*cells)));
                }
            }
        }
        let mut lent = Vec::with_capacity(call.lent.len());
        for place in &call.lent {
            let place = self.place(place, frame);
            lent.push(self.settled(place));
        }
        let mut outputs = Vec::with_capacity(call.outputs.len());
        for output in &call.outputs {
            let to = self.place(&output.to, frame);
            outputs.push(self.settled(to));
        }
        let mut callee = self.enter(unit, own, call.at);
        (callee.lent, callee.given) = (lent, given);
        let base = match call.instance {
            Some(_) => own,
            None => callee.local,
        };
        if unit.kind == UnitKind::Function {
            self.begin(unit, &callee, &stored);
        }
        for (offset, value, store) in values {
            let to = place(base + offset, value.at);
            let at = value.at;
            match (value.kind, store) {
                (ExprKind::Read(from), Store::Text(cells)) => {
                    self.push(Does::Copy(to, *from, cells), at);
                }
                (kind, store) => {
                    let value = Expr { kind, ..value };
                    self.push(Does::Assign(to, value, store), at);
                }
            }
        }
        self.body(unit, &mut callee);
        for (output, to) in call.outputs.iter().zip(outputs) {
            let from = callee.local + output.from;
            match output.value {
                None => {
                    let from = place(from, call.at);
                    self.push(Does::Copy(to, from, output.cells), call.at);
                }
                Some((base, how, store)) => {
                    let (Store::Narrow(target) | Store::Within(target, ..)) = store else {
                        continue;
                    };
                    let value = read(from, base, call.at);
                    let value = match how {
                        Convert::Keep if base == target => value,
                        _ => expr(ExprKind::Convert(how, Box::new(value)), target, call.at),
                    };
                    self.push(Does::Assign(to, value, store), call.at);
                }
            }
        }
        (!unit.locals.is_empty()).then_some(callee.local)
    }
}

impl Expr {
    fn clone_without_kind(&self) -> Expr {
        Expr {
            kind: ExprKind::Wrong,
            base: self.base,
            ty: self.ty,
            at: self.at,
        }
    }
}

fn zero() -> Expr {
    constant(Value::Int(0), Base::Dint, Span::default())
}

fn read_place(from: Place, _cells: u32) -> Expr {
    let at = from.at;
    expr(ExprKind::Read(Box::new(from)), Base::Dint, at)
}

/// Whether what is given may stand in the place of the parameter.
fn as_given(value: &Expr, store: Store, base: Base) -> bool {
    let plain = matches!(store, Store::Narrow(_)) && value.base == base;
    plain
        && match &value.kind {
            ExprKind::Constant(_) => true,
            ExprKind::Read(place) => place.indices.is_empty(),
            _ => false,
        }
}

fn narrowed(value: Expr, base: Base) -> Expr {
    match value.kind {
        ExprKind::Constant(held) => {
            let kind = ExprKind::Constant(crate::typed::narrow(base, held));
            Expr { kind, ..value }
        }
        _ => value,
    }
}

/// Not so.
pub(super) fn not(condition: Expr) -> Expr {
    let at = condition.at;
    expr(
        ExprKind::Unary(Unary::Not, Box::new(condition)),
        Base::Bool,
        at,
    )
}

/// Both of them.
pub(super) fn both(op: Binary, a: Expr, b: Expr) -> Expr {
    let at = a.at;
    let base = a.base;
    expr(ExprKind::Binary(op, Box::new(a), Box::new(b)), base, at)
}
