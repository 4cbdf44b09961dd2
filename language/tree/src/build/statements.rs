//! Statements: what is stored where, conditions, loops, CASE.

use super::builder::Builder;
use super::places::Target;
use super::words::both;
use crate::{Base, Expr, ExprKind, For, Kind, Root, Stmt, StmtKind, TypeId, Value};
use unoclp_text::diagnostics::{Code, Span};

/// The labels of one arm of CASE: each a value or a range of them, and where it stands.
pub type Labels = Vec<(Expr, Option<Expr>)>;

impl Builder<'_, '_> {
    /// The target, if something can be stored in it; else that is told.
    pub(super) fn writable(&mut self, target: Target) -> Option<Target> {
        if let Some(locked) = target.locked
            && !self.stores_in_input(&target)
        {
            let written = self.written(target.at);
            let (what, help) = Builder::why_not_written(locked);
            self.tell(Code::StNotWritable, target.at, [written.into(), what, help]);
            return None;
        }
        if target.place.indices.is_empty()
            && self
                .counters
                .contains(&(target.place.root, target.place.offset))
        {
            let written = self.written(target.at);
            self.tell(Code::StForChanged, target.at, [written.into()]);
        }
        let (unit, offset) = (self.current, target.place.offset);
        if target.input && self.inputs_written.insert((unit, offset)) {
            let written = self.written(target.at);
            self.tell(Code::StInputWritten, target.at, [written.into()]);
        }
        if target.result
            && let Some(draft) = self.here()
        {
            draft.gives = true;
        }
        self.writes = true;
        Some(target)
    }

    /// `target := value`
    pub fn assign(&mut self, target: Target, value: Expr, at: Span) -> Option<Stmt> {
        let target = self.writable(target)?;
        let value = self.coerce(value, target.ty);
        if matches!(value.kind, ExprKind::Wrong) {
            return None;
        }
        let store = self.store_of(target.ty);
        Some(Stmt {
            kind: StmtKind::Assign(target.place, value, store),
            at,
        })
    }

    /// `target := from`, both with parts.
    pub fn copy(&mut self, target: Target, from: Target, at: Span) -> Option<Stmt> {
        let blocks = matches!(
            self.tree.types.kind(target.ty),
            Kind::Standard(_) | Kind::Block(_)
        );
        if blocks {
            let (written, what) = (self.written(target.at), self.what_type(target.ty));
            let help = (
                "call the instance, and store values in its inputs",
                "chame a instância e guarde valores nas entradas dela",
            );
            self.tell(
                Code::StNotWritable,
                target.at,
                [written.into(), what, help.into()],
            );
            return None;
        }
        if !self.tree.types.same(target.ty, from.ty) {
            self.told_other_type(&from, target.ty);
            return None;
        }
        let target = self.writable(target)?;
        let cells = self.tree.types.get(target.ty).cells;
        Some(Stmt {
            kind: StmtKind::Copy(target.place, from.place, cells),
            at,
        })
    }

    /// The condition of IF, WHILE, REPEAT and of a transition. The numbers 0 and 1 are literals of BOOL (2.2.1).
    pub fn condition(&mut self, expr: Expr) -> Expr {
        let wrong = matches!(expr.kind, ExprKind::Wrong);
        if wrong || expr.base == Base::Bool && !self.is_enum(expr.ty) {
            return expr;
        }
        if expr.base == Base::AnyInt
            && let ExprKind::Constant(value) = &expr.kind
            && (0..=1).contains(&value.int())
        {
            return self.coerce(expr, TypeId::BOOL);
        }
        let (written, is) = (self.written(expr.at), self.type_of(&expr));
        let compared = match expr.base {
            _ if self.is_enum(expr.ty) => "= …",
            Base::Time => "> T#0s",
            base if base.is_text() => "= '…'",
            _ => "<> 0",
        };
        self.tell(
            Code::StCondition,
            expr.at,
            [written.into(), is, compared.into()],
        );
        self.wrong(expr.at)
    }

    /// The head of FOR: `variable := from TO to BY step`. Its body is put in after; meanwhile the variable is watched.
    pub fn counting(
        &mut self,
        variable: Option<Target>,
        from: Expr,
        to: Expr,
        step: Option<Expr>,
        at: Span,
    ) -> Option<Box<For>> {
        let variable = variable?;
        let base = self.tree.types.base(variable.ty);
        let base = match base.and_then(|base| Some((base, base.counted()?))) {
            Some((bits, number)) if !self.is_list => {
                self.told_counted(bits, number, variable.at);
                Some(number)
            }
            _ => base,
        };
        let counts = base.is_some_and(Base::is_int) && !self.is_enum(variable.ty);
        let (Some(base), true, true) = (base, counts, variable.place.indices.is_empty()) else {
            let (written, what) = (self.written(variable.at), self.what_type(variable.ty));
            self.tell(Code::StForVariable, variable.at, [written.into(), what]);
            return None;
        };
        let variable = self.writable(variable)?;
        let ty = TypeId::of(base);
        let step_at = step.as_ref().map_or(at, |step| step.at);
        let step = match step {
            Some(step) => step,
            None => self.whole(1, at),
        };
        if let ExprKind::Constant(Value::Int(0)) = step.kind {
            self.tell(Code::StStepZero, step_at, []);
            return None;
        }
        // A step may be negative where the variable is not.
        let step = match (&step.kind, base.is_signed()) {
            (ExprKind::Constant(Value::Int(..0)), false) if step.base == Base::AnyInt => step,
            _ => self.coerce(step, ty),
        };
        let (from, to) = (self.coerce(from, ty), self.coerce(to, ty));
        let wrong = [&from, &to, &step].map(|expr| matches!(expr.kind, ExprKind::Wrong));
        if wrong.contains(&true) {
            return None;
        }
        let step = match step.base {
            Base::AnyInt => Expr {
                base: Base::Dint,
                ty: TypeId::of(Base::Dint),
                ..step
            },
            _ => step,
        };
        Some(Box::new(For {
            variable: variable.place,
            base,
            from,
            to,
            step,
            body: Vec::new(),
        }))
    }

    /// Begins the body of a loop, which FOR counts with this variable.
    pub fn begin_loop(&mut self, counter: Option<(Root, u32)>) {
        self.loops += 1;
        self.counters.extend(counter);
    }

    /// Ends the body of a loop.
    pub fn end_loop(&mut self, counter: Option<(Root, u32)>) {
        self.loops = self.loops.saturating_sub(1);
        if counter.is_some() {
            self.counters.pop();
        }
    }

    /// EXIT and CONTINUE.
    pub fn leaves_loop(&mut self, kind: StmtKind, at: Span) -> Option<Stmt> {
        if self.loops == 0 {
            let written = self.written(at);
            self.tell(Code::StNoLoop, at, [written.into()]);
            return None;
        }
        Some(Stmt { kind, at })
    }

    /// What CASE looks at: an integer, bits, or an enumeration.
    pub fn selector(&mut self, expr: Expr) -> Expr {
        let expr = self.settled(expr);
        let wrong = matches!(expr.kind, ExprKind::Wrong);
        if wrong || expr.base.is_int() || expr.base.is_bits() {
            return expr;
        }
        let help = match expr.base {
            Base::Bool => both("use IF for a BOOL", "use IF para um BOOL"),
            _ => both(
                "CASE takes an integer or an enumeration; use IF and ELSIF for anything else",
                "CASE aceita um inteiro ou uma enumeração; use IF e ELSIF para o resto",
            ),
        };
        let (written, is) = (self.written(expr.at), self.type_of(&expr));
        let words = ["CASE".into(), "ANY_INT".into(), written.into(), is, help];
        self.tell(Code::StOperand, expr.at, words);
        self.wrong(expr.at)
    }

    /// The bounds of one arm of CASE; what is in `taken` is told to be there twice.
    pub fn labels(
        &mut self,
        selector: &Expr,
        labels: Labels,
        taken: &mut std::collections::BTreeMap<i128, i128>,
    ) -> Vec<(i128, i128)> {
        let mut bounds = Vec::new();
        if matches!(selector.kind, ExprKind::Wrong) {
            return bounds;
        }
        let ty = match self.tree.types.kind(selector.ty) {
            Kind::Range { base, .. } => TypeId::of(*base),
            _ => selector.ty,
        };
        for (low, high) in labels {
            let at = high.as_ref().map_or(low.at, |high| low.at.to(high.at));
            let mut known = |expr: Expr| {
                let at = expr.at;
                let expr = self.coerce(expr, ty);
                match expr.kind {
                    ExprKind::Constant(value) => Some(value.int()),
                    ExprKind::Wrong => None,
                    _ => {
                        let written = self.written(at);
                        self.tell(Code::StNotConstant, at, [written.into()]);
                        None
                    }
                }
            };
            let Some(first) = known(low) else { continue };
            let last = match high {
                Some(high) => match known(high) {
                    Some(last) => last,
                    None => continue,
                },
                None => first,
            };
            if last < first {
                let words = [first.to_string().into(), last.to_string().into()];
                self.tell(Code::StEmptyRange, at, words);
                continue;
            }
            let before = taken.range(..=last).next_back();
            if before.is_some_and(|(_, end)| *end >= first) {
                let written = self.written(at);
                self.tell(Code::StCaseTwice, at, [written.into()]);
                continue;
            }
            taken.insert(first, last);
            bounds.push((first, last));
        }
        bounds
    }

    /// Shows a variable.
    pub fn print(&mut self, name: &str, value: Expr, at: Span) -> Option<Stmt> {
        self.writes = true;
        let value = self.settled(value);
        (!matches!(value.kind, ExprKind::Wrong)).then(|| Stmt {
            kind: StmtKind::Print(name.to_owned(), value),
            at,
        })
    }
}
