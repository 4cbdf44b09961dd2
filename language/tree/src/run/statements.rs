//! What each statement does.

use super::{Frame, MOST_DEEP, Machine, Printed, Stop};
use crate::ops;
use crate::{For, Stmt, StmtKind, Store, Unit, Value};
use unoclp_text::diagnostics::Span;

/// How the statements after one go on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Flow {
    Next,
    Exit,
    Continue,
    Return,
    /// To the statement of this number in the unit's body.
    Jump(usize),
}

impl Machine<'_> {
    /// A program, with new cells for what it keeps during a scan alone.
    pub(super) fn run_unit(&mut self, number: u32) -> Result<(), Stop> {
        let Some(unit) = self.tree.units.get(number as usize) else {
            return Ok(());
        };
        let local = self.memory.len();
        self.memory
            .extend(unit.locals.iter().map(|cell| cell.initial.clone()));
        let frame = Frame {
            local,
            ..Frame::default()
        };
        let run = self.body(unit, &frame);
        self.memory.truncate(self.tree.cells.len());
        run
    }

    pub(super) fn body(&mut self, unit: &Unit, frame: &Frame) -> Result<(), Stop> {
        let mut at = 0;
        while let Some(statement) = unit.body.get(at) {
            at += 1;
            match self.statement(statement, frame)? {
                Flow::Jump(to) => at = to,
                Flow::Return => break,
                Flow::Next | Flow::Exit | Flow::Continue => {}
            }
        }
        Ok(())
    }

    fn statements(&mut self, statements: &[Stmt], frame: &Frame) -> Result<Flow, Stop> {
        for statement in statements {
            match self.statement(statement, frame)? {
                Flow::Next => {}
                flow => return Ok(flow),
            }
        }
        Ok(Flow::Next)
    }

    fn statement(&mut self, statement: &Stmt, frame: &Frame) -> Result<Flow, Stop> {
        self.step(statement.at)?;
        self.deep += 1;
        if self.deep > MOST_DEEP {
            return Err(Stop::TooDeep(statement.at));
        }
        let flow = self.run(statement, frame)?;
        self.deep -= 1;
        Ok(flow)
    }

    fn run(&mut self, statement: &Stmt, frame: &Frame) -> Result<Flow, Stop> {
        match &statement.kind {
            StmtKind::Assign(place, expr, store) => {
                let value = self.evaluate(expr, frame)?;
                let cell = self.cell_of(place, frame)?;
                if let Some(value) = self.stored(value, *store, statement.at) {
                    self.write(cell, value);
                }
            }
            StmtKind::Copy(to, from, cells) => {
                let from = self.cell_of(from, frame)?;
                let to = self.cell_of(to, frame)?;
                self.copy(to, from, *cells);
            }
            StmtKind::If(arms, otherwise) => {
                for (condition, body) in arms {
                    if self.evaluate(condition, frame)?.is_true() {
                        return self.statements(body, frame);
                    }
                }
                return self.statements(otherwise, frame);
            }
            StmtKind::Case(selector, arms, otherwise) => {
                let value = self.evaluate(selector, frame)?.int();
                let holds = |bounds: &(i128, i128)| (bounds.0..=bounds.1).contains(&value);
                let arm = arms.iter().find(|(bounds, _)| bounds.iter().any(holds));
                let body = arm.map_or(otherwise, |(_, body)| body);
                return self.statements(body, frame);
            }
            StmtKind::While(condition, body) => {
                while self.evaluate(condition, frame)?.is_true() {
                    self.step(statement.at)?;
                    if let Some(flow) = leaves(self.statements(body, frame)?) {
                        return Ok(flow);
                    }
                }
            }
            StmtKind::Repeat(body, until) => loop {
                self.step(statement.at)?;
                if let Some(flow) = leaves(self.statements(body, frame)?) {
                    return Ok(flow);
                }
                if self.evaluate(until, frame)?.is_true() {
                    break;
                }
            },
            StmtKind::For(head) => return self.counting(head, statement.at, frame),
            StmtKind::Exit => return Ok(Flow::Exit),
            StmtKind::Continue => return Ok(Flow::Continue),
            StmtKind::Return => return Ok(Flow::Return),
            StmtKind::Call(call) => {
                self.call(call, frame)?;
            }
            StmtKind::Standard(block, place) => {
                if let Some(cell) = self.cell_of(place, frame)? {
                    self.standard(*block, cell);
                }
            }
            StmtKind::Order(order, block, place) => {
                let value = match order.value() {
                    Some(value) => Some(self.evaluate(value, frame)?),
                    None => None,
                };
                if let Some(cell) = self.cell_of(place, frame)? {
                    self.order(order, value, *block, cell);
                }
            }
            StmtKind::Codes(_) => return Err(Stop::Codes(statement.at)),
            StmtKind::Print(name, expr) => {
                let value = self.evaluate(expr, frame)?;
                let value = ops::narrow(expr.base, value);
                // What is printed is kept, so it counts for more than other steps.
                self.steps += 100;
                self.printed.push(Printed {
                    name: name.clone(),
                    value,
                    base: expr.base,
                });
            }
            StmtKind::Jump(condition, to) => {
                let jumps = match condition {
                    Some(condition) => self.evaluate(condition, frame)?.is_true(),
                    None => true,
                };
                if jumps {
                    return Ok(Flow::Jump(*to as usize));
                }
            }
        }
        Ok(Flow::Next)
    }

    fn counting(&mut self, head: &For, at: Span, frame: &Frame) -> Result<Flow, Stop> {
        let from = self.evaluate(&head.from, frame)?;
        let to = self.evaluate(&head.to, frame)?.int();
        let step = self.evaluate(&head.step, frame)?.int();
        let cell = self.cell_of(&head.variable, frame)?;
        if step == 0 {
            self.fail(at);
            return Ok(Flow::Next);
        }
        self.write(cell, ops::narrow(head.base, from));
        loop {
            let held = cell.and_then(|cell| self.memory.get(cell));
            let number = held.map_or(0, Value::int);
            if if step > 0 { number > to } else { number < to } {
                return Ok(Flow::Next);
            }
            self.step(at)?;
            if let Some(flow) = leaves(self.statements(&head.body, frame)?) {
                return Ok(flow);
            }
            let held = cell.and_then(|cell| self.memory.get(cell));
            let next = held.map_or(0, Value::int) + step;
            let range = head.base.range();
            if !range.is_some_and(|(low, high)| (low..=high).contains(&next)) {
                return Ok(Flow::Next);
            }
            self.write(cell, Value::Int(next));
        }
    }

    /// The value as it is stored; none where it is not, which sets S 04.
    pub(super) fn stored(&mut self, value: Value, store: Store, at: Span) -> Option<Value> {
        match store {
            Store::Narrow(base) => Some(ops::narrow(base, value)),
            Store::Within(base, low, high) => {
                let value = ops::narrow(base, value);
                let within = (low..=high).contains(&value.int());
                if !within {
                    self.fail(at);
                }
                within.then_some(value)
            }
            Store::Text(most) => {
                let text = value.text().chars().take(most as usize);
                Some(Value::Text(text.collect()))
            }
        }
    }
}

/// How a loop is left by what its body did; none: it goes on.
fn leaves(flow: Flow) -> Option<Flow> {
    match flow {
        Flow::Next | Flow::Continue => None,
        Flow::Exit => Some(Flow::Next),
        Flow::Return | Flow::Jump(_) => Some(flow),
    }
}
