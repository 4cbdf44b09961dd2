//! The run of a program on expressions: acc, value and what waits are expressions, and what is written a statement.
//!
//! Owns what is pending, and that it is put aside before what it reads changes. Must not know what a step does.

use super::counters::{Counting, Edge};
use super::expr::{Expr, Place, Type, View, whole};
use super::filter;
use super::flow::Flow;
use super::live::Live;
use super::registers::Registers;
use super::statement::Statement;
use super::why::Why;
use std::collections::BTreeMap;
use unoclp_checked::SourceMap;
use unoclp_core::isa::{Class, Opcode};
use unoclp_core::{Board, Instruction};

/// More parts than this are put aside where they are needed twice.
const LONG: usize = 12;

/// A number that is pending, and what it is taken for.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Number(pub Expr, pub Type);

/// What has come of a program.
pub(super) struct Body {
    pub statements: Vec<Statement>,
    pub edges: Vec<Edge>,
    /// Each timer: its opcode, and its preset in ms.
    pub timers: Vec<(Opcode, i32)>,
    pub counting: Counting,
    pub registers: Registers,
    /// For how many ms inputs must keep a level, if they are filtered.
    pub filter: Option<u8>,
    /// Whether the root of whole numbers is taken, which is a function of the text.
    pub roots: bool,
}

/// What statements go into.
#[derive(Debug)]
pub(super) enum Frame {
    All,
    Then(Expr),
    Else(Expr, Vec<Statement>),
    /// What a jump leaves out, up to the label at this step.
    Skip(Expr, usize),
    /// What is left out while a jump is on its way.
    Guard,
    /// The loop with this index.
    Loop(usize),
}

pub(super) struct Machine<'s, 'c> {
    pub steps: &'s [Instruction<'c>],
    pub map: &'s SourceMap,
    pub flow: &'s Flow,
    /// The board that the program has been checked for.
    pub board: Board,
    pub live: Live,
    pub at: usize,
    pub acc: Expr,
    pub open: Vec<(Opcode, Expr)>,
    pub points: BTreeMap<u8, Expr>,
    pub value: Number,
    /// What value was taken for when it was last put where it lasts.
    pub kept_as: View,
    pub pushed: Vec<Number>,
    pub frames: Vec<(Frame, Vec<Statement>)>,
    /// How many bits and numbers this rung has put aside.
    pub bits: u16,
    pub numbers: u16,
    /// Whether S 04 is read: then each operation that may set it is done at its place.
    pub errors: bool,
    /// The frames in which each timer stands, as they were numbered.
    pub timer_scopes: BTreeMap<u8, Vec<usize>>,
    pub scopes: Vec<usize>,
    pub next_scope: usize,
    pub body: Body,
}

/// Runs a program.
///
/// # Errors
/// The first step that cannot be said.
pub(super) fn run(
    steps: &[Instruction<'_>],
    map: &SourceMap,
    flow: &Flow,
    board: Board,
) -> Result<Body, (usize, Why)> {
    let errors = steps.iter().any(|step| {
        let system = matches!(
            step.opcode,
            Opcode::SystemContact | Opcode::SystemContactNot
        );
        system && step.number() == Some(4)
    });
    let mut machine = Machine {
        steps,
        map,
        flow,
        board,
        live: Live::of(steps, &|at| flow.next(at)),
        at: 0,
        acc: Expr::Is(true),
        open: Vec::new(),
        points: BTreeMap::new(),
        value: Number(whole(0), Type::Dint),
        kept_as: View::Whole,
        pushed: Vec::new(),
        frames: vec![(Frame::All, Vec::new())],
        bits: 0,
        numbers: 0,
        errors,
        timer_scopes: BTreeMap::new(),
        scopes: vec![0],
        next_scope: 1,
        body: Body {
            statements: Vec::new(),
            edges: Vec::new(),
            timers: Vec::new(),
            counting: Counting::of(steps, flow),
            registers: Registers::of(steps),
            filter: filter::time(steps),
            roots: false,
        },
    };
    while let Some(&step) = steps.get(machine.at) {
        let at = machine.at;
        machine.comments();
        machine.step(step).map_err(|why| (at, why))?;
        machine.ends_loops(at);
        machine.at += 1;
    }
    while machine.frames.len() > 1 {
        machine.end_frame();
    }
    let (_, statements) = machine.frames.pop().unwrap_or((Frame::All, Vec::new()));
    let mut body = machine.body;
    if let Some(time) = body.filter {
        body.statements = filter::statements(time, &statements);
        body.statements.push(Statement::Space);
    }
    body.statements.extend(statements);
    Ok(body)
}

impl Machine<'_, '_> {
    fn step(&mut self, step: Instruction<'_>) -> Result<(), Why> {
        match step.opcode.class() {
            Class::Rung => self.rung(),
            Class::Label => self.label(),
            Class::If | Class::Part => self.part(step),
            Class::Leave => self.leave(step),
            Class::Timer => return self.timer(step),
            Class::Count => self.count(step),
            Class::Load | Class::LoadResult => return self.load(step),
            Class::Operation => return self.operation(step),
            Class::Comparison | Class::ValueContact => self.comparison(step),
            Class::Store => return self.store(step),
            // What is set up holds for the whole program.
            Class::Setting => {}
            _ => return self.bit(step),
        }
        Ok(())
    }

    /// A rung begins.
    pub fn rung(&mut self) {
        self.acc = Expr::Is(true);
        self.points.clear();
        (self.bits, self.numbers) = (0, 0);
        // What is put aside in a rung is of that rung.
        let aside = |place: Place| matches!(place, Place::Bit(_) | Place::Number(..));
        if self.value.0.reads(&aside) && self.live.value[self.at] {
            self.keep_value();
        }
        let last = self.frames.last().and_then(|(_, all)| all.last());
        if !matches!(last, Some(Statement::Comment(_))) {
            self.put(Statement::Space);
        }
    }

    pub fn comments(&mut self) {
        let comments = self.map.steps.get(self.at).map(|place| &place.comments);
        if let Some(comments) = comments.filter(|comments| !comments.is_empty()) {
            // The comment stands by its rung.
            self.put(Statement::Space);
            self.put(Statement::Comment(comments.clone()));
        }
    }

    pub fn put(&mut self, statement: Statement) {
        if let Some((_, statements)) = self.frames.last_mut() {
            statements.push(statement);
        }
    }

    /// Puts statements where this holds; into the IF right before, if that asks for the same.
    pub fn when(&mut self, condition: Expr, body: Vec<Statement>) {
        match condition {
            Expr::Is(true) => body.into_iter().for_each(|statement| self.put(statement)),
            Expr::Is(false) => {}
            condition => {
                let last = self.frames.last_mut().and_then(|(_, all)| all.last_mut());
                match last {
                    Some(Statement::If(asked, then, otherwise))
                        if *asked == condition
                            && otherwise.is_empty()
                            && !then.ends_with(&[Statement::Return]) =>
                    {
                        then.extend(body);
                    }
                    _ => self.put(Statement::If(condition, body, Vec::new())),
                }
            }
        }
    }

    /// Puts aside what is pending and reads what is about to change.
    pub fn changes(&mut self, is: &dyn Fn(Place) -> bool) {
        if self.acc.reads(is) && self.live.acc[self.at + 1] {
            let acc = self.acc.clone();
            self.acc = self.aside(acc);
        }
        for at in 0..self.open.len() {
            if self.open[at].1.reads(is) {
                let before = self.open[at].1.clone();
                self.open[at].1 = self.aside(before);
            }
        }
        let points: Vec<u8> = self.points.keys().copied().collect();
        for point in points {
            let holds = self.points[&point].clone();
            if holds.reads(is) && self.is_recalled(point) > 0 {
                let aside = self.aside(holds);
                self.points.insert(point, aside);
            }
        }
        for at in 0..self.pushed.len() {
            if self.pushed[at].0.reads(is) {
                let before = self.pushed[at].clone();
                self.pushed[at] = self.number_aside(before);
            }
        }
        if self.value.0.reads(is) && self.live.value[self.at + 1] {
            let value = self.value.clone();
            self.value = self.number_aside(value);
        }
    }

    /// How often the rest of this rung recalls a branch point before it is stored again.
    pub fn is_recalled(&self, point: u8) -> usize {
        let rest = self.steps.get(self.at + 1..).unwrap_or_default();
        let of = |step: &&Instruction<'_>| step.number() == Some(point);
        rest.iter()
            .take_while(|step| {
                !matches!(step.opcode.class(), Class::Rung | Class::Part | Class::If)
            })
            .filter(of)
            .take_while(|step| step.opcode != Opcode::StoreBranch)
            .filter(|step| step.opcode == Opcode::RecallBranch)
            .count()
    }

    /// A bit that holds this from here on.
    pub fn aside(&mut self, expr: Expr) -> Expr {
        if matches!(expr, Expr::Is(_)) {
            return expr;
        }
        self.bits += 1;
        let place = Place::Bit(self.bits);
        self.put(Statement::Assign(place, expr));
        Expr::Place(place)
    }

    /// A number that holds this from here on.
    pub fn number_aside(&mut self, number: Number) -> Number {
        let number = self.resolved(number);
        self.numbers += 1;
        let view = match number.1 {
            Type::Real => View::Real,
            _ => View::Whole,
        };
        let (expr, ty) = match view {
            View::Real => (number.0, Type::Real),
            View::Whole => (self.dint(number), Type::Dint),
        };
        let place = Place::Number(self.numbers, view);
        self.put(Statement::Assign(place, expr));
        Number(Expr::Place(place), ty)
    }

    /// Value, where it has been put.
    pub fn kept(&self) -> Number {
        let ty = match self.kept_as {
            View::Real => Type::Real,
            View::Whole => Type::Dint,
        };
        Number(Expr::Place(Place::Value(self.kept_as)), ty)
    }

    /// Puts value where it lasts; acc, which this step looks at, stays what it is.
    pub fn keep_value_beside_acc(&mut self) {
        let is_value = |place: Place| matches!(place, Place::Value(_));
        if self.acc.reads(&is_value) && !matches!(self.value.0, Expr::Place(Place::Value(_))) {
            let acc = self.acc.clone();
            self.acc = self.aside(acc);
        }
        self.keep_value();
    }

    /// Puts value where it lasts, and keeps it there.
    pub fn keep_value(&mut self) {
        let is_there = |expr: &Expr| matches!(expr, Expr::Place(Place::Value(_)));
        if is_there(&self.value.0) {
            return;
        }
        let before = self.value.clone();
        let number = self.resolved(before);
        let number = match number.1 {
            Type::Real => number,
            _ => Number(self.dint(number), Type::Dint),
        };
        let view = if number.1 == Type::Real {
            View::Real
        } else {
            View::Whole
        };
        // Nothing else that is pending reads it: no rung is open where it is kept, or it is put aside.
        self.changes_but_value(&|place| matches!(place, Place::Value(_)));
        self.put(Statement::Assign(Place::Value(view), number.0));
        self.kept_as = view;
        self.value = self.kept();
    }

    fn changes_but_value(&mut self, is: &dyn Fn(Place) -> bool) {
        let value = std::mem::replace(&mut self.value, Number(whole(0), Type::Dint));
        self.changes(is);
        self.value = value;
    }

    /// Puts acc aside where it is long and needed again.
    pub fn shorten_acc(&mut self) {
        if self.acc.size() > LONG && self.live.acc[self.at + 1] {
            let acc = self.acc.clone();
            self.acc = self.aside(acc);
        }
    }

    /// Puts value aside where it is no more than a place's, and needed again.
    pub fn shorten_value(&mut self) {
        if !self.value.0.is_simple() && self.live.value[self.at + 1] {
            let value = self.value.clone();
            self.value = self.number_aside(value);
        }
    }
}
