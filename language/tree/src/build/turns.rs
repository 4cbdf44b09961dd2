//! Loops whose variable picks the instance of a block in an array: their bodies are written once for each turn.

use super::builder::Builder;
use super::named::Turn;
use crate::{Binary, Expr, ExprKind, For, Root, Stmt, StmtKind, Store, Value};
use unoclp_text::diagnostics::{Code, Span};

/// A loop of more turns stays one.
const MOST_TURNS: usize = 100;

/// All loops of a text, with those in them, are written for no more turns.
const MOST_MADE: usize = 2_000;

/// The values that a loop's variable has in its turns; none where they are computed, or too many.
pub fn turns(head: &For) -> Vec<i128> {
    let known = |expr: &Expr| match &expr.kind {
        ExprKind::Constant(value) => Some(value.int()),
        _ => None,
    };
    let (Some(from), Some(to), Some(step)) =
        (known(&head.from), known(&head.to), known(&head.step))
    else {
        return Vec::new();
    };
    let goes_on = |value: &i128| match step > 0 {
        true => *value <= to,
        false => *value >= to,
    };
    let values = std::iter::successors(Some(from), |value| Some(value + step));
    let mut values: Vec<i128> = values.take_while(goes_on).take(MOST_TURNS + 1).collect();
    if values.len() > MOST_TURNS {
        values.clear();
    }
    values
}

impl Builder<'_, '_> {
    /// Begins the body of a turn in which this variable has this value; where it is known that turns are written, one for
    /// each, the value is that of every subscript too.
    pub fn begin_turn(&mut self, variable: (Root, u32), value: i128, is_written: bool) {
        self.turns_made += 1;
        self.turns.push(Turn {
            variable,
            value,
            picks: false,
            is_written,
        });
    }

    /// Whether the loop is known to be written once for each turn.
    pub(super) fn writes_turns(&self) -> bool {
        self.turns.iter().any(|turn| turn.is_written)
    }

    /// Ends it; whether the value has picked an instance.
    pub fn end_turn(&mut self) -> bool {
        self.turns.pop().is_some_and(|turn| turn.picks)
    }

    /// What a subscript is in the turns whose bodies are made; none where they are too many.
    pub(super) fn picked(&mut self, subscript: &Expr) -> Option<i128> {
        if self.turns_made > MOST_MADE {
            return None;
        }
        Some(match &subscript.kind {
            ExprKind::Constant(value) => value.int(),
            ExprKind::Read(place) if place.indices.is_empty() => {
                let variable = (place.root, place.offset);
                let mut turns = self.turns.iter_mut();
                let turn = turns.rfind(|turn| turn.variable == variable)?;
                turn.picks = true;
                turn.value
            }
            ExprKind::Convert(_, of) => self.picked(of)?,
            ExprKind::Binary(op, one, other) => {
                let (one, other) = (self.picked(one)?, self.picked(other)?);
                match op {
                    Binary::Add => one.checked_add(other)?,
                    Binary::Subtract => one.checked_sub(other)?,
                    Binary::Multiply => one.checked_mul(other)?,
                    _ => return None,
                }
            }
            _ => return None,
        })
    }

    /// A loop as the bodies of its turns, in each of which its variable has another value.
    pub fn unrolled(
        &mut self,
        head: &For,
        turns: &[i128],
        bodies: Vec<Vec<Stmt>>,
        at: Span,
        all: &mut Vec<Stmt>,
    ) {
        if bodies.iter().any(|body| leaves(body)) {
            return self.tell(Code::StBlockSubscript, at, []);
        }
        let mut count = |value: i128, all: &mut Vec<Stmt>| {
            let value = self.literal(head.base, Value::Int(value), at);
            let kind = StmtKind::Assign(head.variable.clone(), value, Store::Narrow(head.base));
            all.push(Stmt { kind, at });
        };
        for (turn, body) in turns.iter().zip(bodies) {
            count(*turn, all);
            all.extend(body);
        }
        if let (Some(last), ExprKind::Constant(step)) = (turns.last(), &head.step.kind) {
            let after = last + step.int();
            let range = head.base.range();
            if range.is_none_or(|(least, most)| (least..=most).contains(&after)) {
                count(after, all);
            }
        }
    }
}

/// Whether statements leave the loop around them, or its turn.
pub fn leaves(statements: &[Stmt]) -> bool {
    statements.iter().any(|statement| match &statement.kind {
        StmtKind::Exit | StmtKind::Continue => true,
        StmtKind::If(arms, otherwise) => {
            arms.iter().any(|(_, body)| leaves(body)) || leaves(otherwise)
        }
        StmtKind::Case(_, arms, otherwise) => {
            arms.iter().any(|(_, body)| leaves(body)) || leaves(otherwise)
        }
        _ => false,
    })
}
