//! What each expression comes to.

use super::{Frame, MOST_DEEP, Machine, Stop, extra};
use crate::{Call, Expr, ExprKind, Input, Value};
use crate::{narrow, ops};

impl Machine<'_> {
    pub(super) fn evaluate(&mut self, expr: &Expr, frame: &Frame) -> Result<Value, Stop> {
        self.step(expr.at)?;
        self.deep += 1;
        if self.deep > MOST_DEEP {
            return Err(Stop::TooDeep(expr.at));
        }
        let value = self.value_of(expr, frame)?;
        self.deep -= 1;
        Ok(value)
    }

    fn value_of(&mut self, expr: &Expr, frame: &Frame) -> Result<Value, Stop> {
        let (value, failed) = match &expr.kind {
            ExprKind::Constant(value) => (value.clone(), false),
            ExprKind::Wrong => (Value::zero(expr.base), false),
            ExprKind::Now => (narrow(expr.base, Value::Int(self.now.into())), false),
            ExprKind::Read(place) => (self.read(place, expr.base, frame)?, false),
            ExprKind::Convert(how, inner) => {
                let value = self.evaluate(inner, frame)?;
                ops::convert(*how, inner.base, expr.base, &value)
            }
            ExprKind::Unary(op, inner) => {
                let value = self.evaluate(inner, frame)?;
                ops::unary(*op, expr.base, &value)
            }
            ExprKind::Binary(op, a, b) => {
                let a_value = self.evaluate(a, frame)?;
                let b_value = self.evaluate(b, frame)?;
                ops::binary(*op, a.base, &a_value, &b_value)
            }
            ExprKind::Compare(op, a, b) => {
                let a = self.evaluate(a, frame)?;
                let b = self.evaluate(b, frame)?;
                (Value::truth(ops::compare(*op, &a, &b)), false)
            }
            ExprKind::Ordered(op, operands) => {
                let values = self.all(operands, frame)?;
                let mut pairs = values.windows(2);
                let holds = pairs.all(|pair| match pair {
                    [a, b] => ops::compare(*op, a, b),
                    _ => true,
                });
                (Value::truth(holds), false)
            }
            ExprKind::Select(parts) => {
                let [which, no, yes] = &**parts;
                let which = self.evaluate(which, frame)?;
                let (no, yes) = (self.evaluate(no, frame)?, self.evaluate(yes, frame)?);
                (if which.is_true() { yes } else { no }, false)
            }
            ExprKind::Mux(which, inputs) => {
                let which = self.evaluate(which, frame)?.int();
                let mut values = self.all(inputs, frame)?;
                match usize::try_from(which).ok().filter(|at| *at < values.len()) {
                    Some(at) => (values.swap_remove(at), false),
                    None => (Value::zero(expr.base), true),
                }
            }
            ExprKind::Extra(function, operands) => {
                let values = self.all(operands, frame)?;
                extra::extra(*function, expr.base, &values)
            }
            ExprKind::Call(call) => (self.call(call, frame)?, false),
        };
        if failed {
            self.fail(expr.at);
        }
        Ok(value)
    }

    fn all(&mut self, operands: &[Expr], frame: &Frame) -> Result<Vec<Value>, Stop> {
        operands
            .iter()
            .map(|operand| self.evaluate(operand, frame))
            .collect()
    }

    /// Calls a function or a block of the text; the value is that of a function's first cell.
    pub(super) fn call(&mut self, call: &Call, frame: &Frame) -> Result<Value, Stop> {
        self.step(call.at)?;
        let Some(unit) = self.tree.units.get(call.unit as usize) else {
            return Ok(Value::Int(0));
        };
        // All that the caller gives is computed before the callee's cells are made.
        let own = match &call.instance {
            Some(place) => match self.cell_of(place, frame)? {
                Some(cell) => cell,
                None => return Ok(Value::Int(0)),
            },
            None => 0,
        };
        let mut given: Vec<(u32, Vec<Value>)> = Vec::with_capacity(call.inputs.len());
        for input in &call.inputs {
            match input {
                Input::Value(offset, expr, store) => {
                    let value = self.evaluate(expr, frame)?;
                    if let Some(value) = self.stored(value, *store, expr.at) {
                        given.push((*offset, vec![value]));
                    }
                }
                Input::Cells(offset, place, cells) => {
                    let from = self.cell_of(place, frame)?;
                    let values =
                        from.and_then(|from| self.memory.get(from..from + *cells as usize));
                    let values = values.map(<[Value]>::to_vec);
                    given.extend(values.map(|values| (*offset, values)));
                }
            }
        }
        let mut lent = Vec::with_capacity(call.lent.len());
        for place in &call.lent {
            lent.push(self.cell_of(place, frame)?);
        }
        let mut outputs = Vec::with_capacity(call.outputs.len());
        for output in &call.outputs {
            outputs.push(self.cell_of(&output.to, frame)?);
        }
        let local = self.memory.len();
        let cells = unit.locals.iter().map(|cell| cell.initial.clone());
        self.memory.extend(cells);
        let base = if call.instance.is_some() { own } else { local };
        for (offset, values) in given {
            for (value, at) in values.into_iter().zip(base + offset as usize..) {
                self.write(Some(at), value);
            }
        }
        let callee = Frame { own, local, lent };
        self.body(unit, &callee)?;
        for (output, to) in call.outputs.iter().zip(outputs) {
            let from = local + output.from as usize;
            match output.value {
                None => self.copy(to, Some(from), output.cells),
                Some((base, how, store)) => {
                    let value = self.memory.get(from).cloned().unwrap_or(Value::Int(0));
                    let target = match store {
                        crate::Store::Narrow(target) | crate::Store::Within(target, ..) => target,
                        crate::Store::Text(_) => base,
                    };
                    let (value, failed) = ops::convert(how, base, target, &value);
                    if failed {
                        self.fail(output.to.at);
                    }
                    if let Some(value) = self.stored(value, store, output.to.at) {
                        self.write(to, value);
                    }
                }
            }
        }
        let result = match unit.locals.is_empty() {
            true => Value::Int(0),
            false => self.memory.get(local).cloned().unwrap_or(Value::Int(0)),
        };
        self.memory.truncate(local);
        Ok(result)
    }
}
