//! Where numbers are stored.
//!
//! Owns what a store is in Structured Text. Must not know how numbers are computed.

use super::expr::{Expr, Place, Type, View, call, whole};
use super::machine::{Machine, Number};
use super::statement::Statement;
use super::why::Why;
use unoclp_core::Instruction;
use unoclp_core::isa::{Kind, Opcode, Operand};
use unoclp_point::Address;

impl Machine<'_, '_> {
    /// The inputs of the board in their order, but for pins that are inputs only where a step names them.
    pub fn inputs(&self) -> Vec<Option<Place>> {
        let named = self.named(Kind::Input);
        let shared = self.board.shared_from;
        let inputs = 1..=self.board.inputs;
        inputs
            .map(|n| {
                let is_there = shared == 0 || n < shared || named.contains(&n);
                is_there.then_some(Place::At(Address::Input(n)))
            })
            .collect()
    }

    /// The outputs of the board in their order, those that are PWM left out.
    pub fn outputs(&self) -> Vec<Option<Place>> {
        let pwm = self.named(Kind::Pwm);
        let outputs = 1..=self.board.outputs;
        outputs
            .map(|n| (!pwm.contains(&n)).then_some(Place::At(Address::Output(n))))
            .collect()
    }

    /// The numbers of all steps of this kind.
    fn named(&self, kind: Kind) -> Vec<u8> {
        let of = self
            .steps
            .iter()
            .filter(|step| step.opcode.row().kind == kind);
        of.filter_map(|step| step.number()).collect()
    }

    pub fn store(&mut self, step: Instruction<'_>) -> Result<(), Why> {
        let xx = step.number().unwrap_or_default();
        match step.opcode {
            Opcode::Store => self.store_register(xx),
            Opcode::StoreTable => self.store_table(step.operand),
            Opcode::StoreCount => self.store_in(Place::At(Address::Count(xx)), Self::dint),
            Opcode::StorePwm => self.store_in(Place::At(Address::Pwm(xx)), Self::dint),
            Opcode::PresetCounter => self.store_in(
                Place::At(Address::CountPreset(xx)),
                |this, number| match number.0 {
                    Expr::Constant(preset, _) => whole(preset.max(0)),
                    _ => Expr::Call("MAX", vec![this.dint(number), whole(0)]),
                },
            ),
            Opcode::PresetTimer => self.store_in(
                Place::At(Address::TimerPreset(xx)),
                |this, number| match number.0 {
                    Expr::Constant(preset, _) => Expr::Constant(preset.max(0), Type::Time),
                    _ => call("DINT_TO_TIME", this.dint(number)),
                },
            ),
            Opcode::StoreMarkers => {
                let first = (xx - 1) * 8 + 1;
                self.scatter(
                    &(first..first + 8)
                        .map(|n| Some(Place::At(Address::Marker(n))))
                        .collect::<Vec<_>>(),
                );
            }
            Opcode::StoreOutputs => self.scatter(&self.outputs()),
            Opcode::Move => self.copy(step.operand),
            Opcode::Drum => self.drum(step.operand),
            _ => return Err(Why::NoWords),
        }
        Ok(())
    }

    /// Value into a place of whole numbers.
    fn store_in(&mut self, place: Place, as_stored: fn(&mut Self, Number) -> Expr) {
        self.shorten_value();
        let value = self.value.clone();
        let stored = as_stored(self, value);
        self.changes(&|other| match (place, other) {
            (Place::At(Address::Count(n)), Place::At(Address::Reached(other))) => n == other,
            _ => place == other,
        });
        self.when(self.acc.clone(), vec![Statement::Assign(place, stored)]);
    }

    /// A number as the register, or the array that it is an element of, takes it; and what is written.
    fn as_stored_in(&mut self, register: u8, number: Number) -> Statement {
        let held = self.register(register);
        match held.0 {
            Expr::Element(table, at) => {
                let value = match held.1 {
                    Type::Real => self.real(number),
                    _ => self.dint(number),
                };
                Statement::AssignElement(table, *at, value)
            }
            _ => {
                // A constant is what the register is.
                let real = match number.0 {
                    Expr::Constant(..) => held.1 == Type::Real,
                    _ => number.1 == Type::Real,
                };
                match real {
                    true => {
                        let value = self.real(number);
                        let view = match value {
                            Expr::Place(Place::Number(_, View::Whole)) => View::Whole,
                            _ => View::Real,
                        };
                        Statement::Assign(Place::Register(register, view), value)
                    }
                    false => {
                        let value = self.dint(number);
                        Statement::Assign(Place::Register(register, View::Whole), value)
                    }
                }
            }
        }
    }

    fn is_register(&self, register: u8) -> impl Fn(Place) -> bool + use<> {
        let table = self.body.registers.table(register);
        move |place| match place {
            Place::Register(other, _) => other == register,
            Place::Table(other) => Some(other) == table,
            _ => false,
        }
    }

    fn store_register(&mut self, register: u8) {
        let is = self.is_register(register);
        if self.acc.is_true() {
            let value = std::mem::replace(&mut self.value, Number(whole(0), Type::Dint));
            let statement = self.as_stored_in(register, value.clone());
            self.changes(&is);
            self.put(statement);
            let constant = matches!(value.0, Expr::Constant(..));
            self.value = if constant {
                value
            } else {
                self.register_as(register, value.1)
            };
            return;
        }
        self.shorten_value();
        let value = self.value.clone();
        let statement = self.as_stored_in(register, value);
        self.changes(&is);
        self.when(self.acc.clone(), vec![statement]);
    }

    /// What a register holds, taken for what was stored.
    fn register_as(&self, register: u8, stored: Type) -> Number {
        let held = self.register(register);
        match (held.0, stored) {
            (Expr::Place(_), Type::Real) => Number(
                Expr::Place(Place::Register(register, View::Real)),
                Type::Real,
            ),
            (Expr::Place(_), _) => Number(
                Expr::Place(Place::Register(register, View::Whole)),
                Type::Dint,
            ),
            (element, _) => Number(element, held.1),
        }
    }

    fn store_table(&mut self, operand: Operand<'_>) {
        let Operand::Table { first, length } = operand else {
            return;
        };
        let index = self.pushed.pop().unwrap_or(Number(whole(0), Type::Dint));
        self.shorten_value();
        let value = self.value.clone();
        let (table, at) = self.subscript(index, first, length);
        let stored = match self.register(table).1 {
            Type::Real => self.real(value),
            _ => self.dint(value),
        };
        let errors = self.errors;
        self.changes(&|place| {
            place == Place::Table(table) || errors && place == Place::At(Address::System(4))
        });
        self.when(
            self.acc.clone(),
            vec![Statement::AssignElement(table, at, stored)],
        );
    }

    /// The low bits of value into these places.
    fn scatter(&mut self, places: &[Option<Place>]) {
        if !matches!(self.value.0, Expr::Place(_) | Expr::Constant(..)) {
            let value = self.value.clone();
            self.value = self.number_aside(value);
        }
        let value = self.value.clone();
        let bits = places.iter().enumerate();
        let bits = bits.filter_map(|(at, place)| Some((1 << at, (*place)?)));
        let statements = bits.map(|(bit, place)| {
            let holds = match value.0 {
                Expr::Constant(number, _) => Expr::Is(number & bit != 0),
                _ => self.has_bit(value.clone(), bit),
            };
            Statement::Assign(place, holds)
        });
        let statements: Vec<Statement> = statements.collect();
        self.changes(&|place| places.contains(&Some(place)));
        self.when(self.acc.clone(), statements);
    }

    fn copy(&mut self, operand: Operand<'_>) {
        let Operand::Move { from, to, count } = operand else {
            return;
        };
        // In an order in which nothing is written before it is read.
        let mut order: Vec<u8> = (0..count).collect();
        if to > from {
            order.reverse();
        }
        let mut statements = Vec::new();
        for at in order.into_iter().filter(|_| from != to) {
            let number = self.register(from + at);
            statements.push(self.as_stored_in(to + at, number));
        }
        let written: Vec<_> = (to..to + count)
            .map(|register| self.is_register(register))
            .collect();
        self.changes(&|place| written.iter().any(|is| is(place)));
        self.when(self.acc.clone(), statements);
    }

    fn drum(&mut self, operand: Operand<'_>) {
        let Operand::Drum { register, steps } = operand else {
            return;
        };
        let number = self.register(register);
        let number = self.dint(number);
        let outputs = self.outputs();
        let set = |step: u8| -> Vec<Statement> {
            let places = outputs.iter().enumerate();
            let places = places.filter_map(|(at, place)| Some((at, (*place)?)));
            places
                .map(|(at, place)| Statement::Assign(place, Expr::Is(step >> at & 1 != 0)))
                .collect()
        };
        let cases = steps.iter().map(|step| set(*step)).collect();
        let case = Statement::Case(number, cases, set(0));
        self.changes(&|place| outputs.contains(&Some(place)));
        self.when(self.acc.clone(), vec![case]);
    }
}
