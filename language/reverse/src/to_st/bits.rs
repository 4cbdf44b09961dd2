//! Contacts, branches and coils.
//!
//! Owns what the steps on bits are. Must not know numbers.

use super::expr::{Expr, Place, and, not, or, xor};
use super::machine::Machine;
use super::statement::Statement;
use super::why::Why;
use unoclp_core::Instruction;
use unoclp_core::isa::{Class, Kind, Opcode};
use unoclp_point::Address;

impl Machine<'_, '_> {
    pub fn bit(&mut self, step: Instruction<'_>) -> Result<(), Why> {
        let xx = step.number().unwrap_or_default();
        match step.opcode.class() {
            Class::OpenOr | Class::OpenAnd | Class::OpenXor => {
                let acc = std::mem::replace(&mut self.acc, Expr::Is(true));
                self.open.push((step.opcode, acc));
            }
            Class::Close => {
                let Some((opened, before)) = self.open.pop() else {
                    return Ok(());
                };
                let acc = std::mem::replace(&mut self.acc, Expr::Is(true));
                self.acc = match opened.class() {
                    Class::OpenAnd => and(before, acc),
                    Class::OpenXor => xor(before, acc),
                    _ => or(before, acc),
                };
            }
            Class::StorePoint => {
                let times = self.is_recalled(xx) + usize::from(self.live.acc[self.at + 1]);
                if times > 1 && !self.acc.is_simple() {
                    self.changes(&|place| place == Place::Branch(xx));
                    let acc = std::mem::replace(&mut self.acc, Expr::Place(Place::Branch(xx)));
                    self.put(Statement::Assign(Place::Branch(xx), acc));
                }
                self.points.insert(xx, self.acc.clone());
            }
            Class::RecallPoint => {
                self.acc = self.points.get(&xx).cloned().unwrap_or(Expr::Is(false));
            }
            Class::Contact | Class::Condition => {
                let point = self.point(step);
                let point = if step.opcode.is_inverted() {
                    not(point)
                } else {
                    point
                };
                let acc = std::mem::replace(&mut self.acc, Expr::Is(true));
                self.acc = and(acc, point);
            }
            Class::Xor => {
                let point = self.point(step);
                let acc = std::mem::replace(&mut self.acc, Expr::Is(true));
                let acc = xor(acc, point);
                self.acc = if step.opcode.is_inverted() {
                    not(acc)
                } else {
                    acc
                };
            }
            Class::Logic if step.opcode == Opcode::Not => {
                let acc = std::mem::replace(&mut self.acc, Expr::Is(true));
                self.acc = not(acc);
            }
            Class::Logic => self.edge(step.opcode),
            Class::Coil => return self.coil(step),
            _ => return Err(Why::NoWords),
        }
        Ok(())
    }

    /// What a contact looks at.
    fn point(&self, step: Instruction<'_>) -> Expr {
        let xx = step.number().unwrap_or_default();
        match step.opcode.row().kind {
            Kind::TimerQ => Expr::at(Address::TimerQ(xx)),
            Kind::Counter => match step.opcode {
                Opcode::CounterContact | Opcode::CounterContactNot => self.reached(xx),
                _ => self.is_zero(xx),
            },
            kind => Address::in_code(kind, xx).map_or(Expr::Is(false), Expr::at),
        }
    }

    fn coil(&mut self, step: Instruction<'_>) -> Result<(), Why> {
        let xx = step.number().unwrap_or_default();
        let place = match step.opcode.row().kind {
            Kind::Output => Place::At(Address::Output(xx)),
            Kind::Marker => Place::At(Address::Marker(xx)),
            Kind::Counter => {
                self.counter_coil(step.opcode, xx);
                return Ok(());
            }
            _ => return Err(Why::NoWords),
        };
        match step.opcode {
            Opcode::Coil | Opcode::MarkerCoil => {
                let acc = self.acc.clone();
                self.set_bit(place, acc);
                if !self.acc.is_simple() {
                    self.acc = Expr::Place(place);
                }
            }
            Opcode::NegatedCoil | Opcode::NegatedMarkerCoil => {
                self.shorten_acc();
                let acc = not(self.acc.clone());
                self.set_bit(place, acc);
            }
            _ => {
                let is = matches!(step.opcode, Opcode::SetCoil | Opcode::SetMarker);
                self.shorten_acc();
                self.changes(&|other| other == place);
                self.when(
                    self.acc.clone(),
                    vec![Statement::Assign(place, Expr::Is(is))],
                );
            }
        }
        Ok(())
    }

    /// A bit of the image becomes this. What is pending and reads it is put aside, but for acc where it is this.
    pub fn set_bit(&mut self, place: Place, value: Expr) {
        let is = |other| other == place;
        match value == self.acc && !self.acc.is_simple() {
            // After it the bit is acc.
            true => {
                let acc = std::mem::replace(&mut self.acc, Expr::Is(true));
                self.changes(&is);
                self.acc = acc;
                self.put(Statement::Assign(place, value));
            }
            false => {
                let before = self.acc.clone();
                self.changes(&is);
                // What was put aside is what is stored.
                let value = if value == before {
                    self.acc.clone()
                } else {
                    value
                };
                self.put(Statement::Assign(place, value));
            }
        }
    }
}
