//! What is on a wire: contacts, coils, timers, edges and jumps.

use super::counters::input;
use super::draw::{COLUMN, Draw, Wire, timer};
use unoclp_core::Target;
use unoclp_core::isa::{Class, Kind, Opcode};
use unoclp_draw::edit::{Element, Step};
use unoclp_point::Address;

impl Draw {
    pub(crate) fn element(&mut self, element: &Element, wire: &mut Wire) {
        let step = &element.step;
        let (opcode, number) = (step.opcode(), step.number().unwrap_or(0));
        let takes_en = matches!(
            step.class(),
            Class::Load | Class::Operation | Class::Comparison | Class::Store
        );
        if self.is_blocks && !takes_en {
            self.lead(wire);
        }
        match step.class() {
            Class::Contact | Class::Condition => self.contact(element, wire),
            Class::Coil => self.coil(element, wire),
            Class::Timer => self.timer(element, wire),
            Class::Count => {
                let Some((_, input)) = input(step).filter(|_| self.counters.counts_only(number))
                else {
                    return self.lose(element.id, opcode.row().letters);
                };
                let id = self.count(element, &[(input, wire.from.clone())], wire.at);
                wire.from = vec![(id, "Q")];
                wire.at.x += COLUMN;
            }
            Class::Logic => {
                let (kind, instance, input, output) = match opcode {
                    Opcode::RisingEdge => ("R_TRIG", true, "CLK", "Q"),
                    Opcode::FallingEdge => ("F_TRIG", true, "CLK", "Q"),
                    _ => ("NOT", false, "IN", "OUT"),
                };
                let instance = instance.then(|| self.variables.instance(kind));
                let inputs = [(input, &wire.from[..])];
                let id = self
                    .body
                    .block(kind, instance.as_deref(), &inputs, &[output], wire.at);
                wire.from = vec![(id, output)];
                wire.at.x += COLUMN;
            }
            Class::Xor => {
                let Some(point) = bit(step) else {
                    return self.lose(element.id, opcode.row().letters);
                };
                let name = self.variables.of(point, "BOOL");
                let value = self.value_of(&name, wire.at);
                let second = if opcode.is_inverted() { "!IN2" } else { "IN2" };
                let inputs = [("IN1", &wire.from[..]), (second, &[value][..])];
                let id = self.body.block("XOR", None, &inputs, &["OUT"], wire.at);
                wire.from = vec![(id, "OUT")];
                wire.at.x += COLUMN;
            }
            Class::Leave => {
                let negated = if opcode.is_inverted() {
                    " negated=\"true\""
                } else {
                    ""
                };
                match opcode.row().kind == Kind::Jump {
                    true => {
                        let attributes = format!(" label=\"L{number:02}\"{negated}");
                        self.body.leave("jump", &attributes, &wire.from, wire.at);
                    }
                    false => self.body.leave("return", negated, &wire.from, wire.at),
                }
                wire.at.x += COLUMN;
            }
            _ => self.number(element, wire),
        }
    }

    fn contact(&mut self, element: &Element, wire: &mut Wire) {
        let Some(variable) = self.read(element) else {
            return;
        };
        let attributes = format!(" negated=\"{}\"", element.step.opcode().is_inverted());
        let id = self
            .body
            .symbol("contact", &attributes, &variable, &wire.from, wire.at);
        wire.from = vec![(id, "")];
        wire.at.x += COLUMN;
    }

    /// The variable that a contact reads; none, which is noted, where it is none.
    pub(super) fn read(&mut self, element: &Element) -> Option<String> {
        let step = &element.step;
        let number = step.number().unwrap_or(0);
        let variable = match step.opcode().row().kind {
            Kind::TimerQ => {
                let known = self.timers.values().any(|timer| *timer == number);
                known.then(|| format!("{}.Q", self.variables.of(Address::Timer(number), "TON")))
            }
            Kind::Counter => {
                let output = self.output_read(element);
                let instance = self.counted(number);
                instance
                    .zip(output)
                    .map(|(name, output)| format!("{name}.{output}"))
            }
            _ => bit(step).map(|point| self.variables.of(point, "BOOL")),
        };
        if variable.is_none() {
            self.lose(element.id, step.opcode().row().letters);
        }
        variable
    }

    /// The output of a counter that a contact reads.
    pub(super) fn output_read(&self, element: &Element) -> Option<&'static str> {
        let step = &element.step;
        let number = step
            .number()
            .filter(|_| step.opcode().row().kind == Kind::Counter)?;
        self.reached(number, step.class() == Class::Condition)
    }

    fn coil(&mut self, element: &Element, wire: &mut Wire) {
        let opcode = element.step.opcode();
        let attributes = match opcode {
            Opcode::Coil | Opcode::MarkerCoil => " negated=\"false\"",
            Opcode::NegatedCoil | Opcode::NegatedMarkerCoil => " negated=\"true\"",
            Opcode::SetCoil | Opcode::SetMarker => " negated=\"false\" storage=\"set\"",
            Opcode::ResetCoil | Opcode::ResetMarker => " negated=\"false\" storage=\"reset\"",
            other => return self.lose(element.id, other.row().letters),
        };
        let Some(point) = bit(&element.step) else {
            return self.lose(element.id, opcode.row().letters);
        };
        self.driven(attributes, point, wire);
    }

    /// A coil, or a variable that takes the power.
    fn driven(&mut self, attributes: &str, point: Address, wire: &mut Wire) {
        let name = self.variables.of(point, "BOOL");
        match wire.from[..] {
            [from] if self.is_blocks => self.body.taken(attributes, &name, from, wire.at),
            _ => drop(
                self.body
                    .symbol("coil", attributes, &name, &wire.from, wire.at),
            ),
        }
        wire.at.x += COLUMN;
    }

    fn timer(&mut self, element: &Element, wire: &mut Wire) {
        let opcode = element.step.opcode();
        if let Some(Target::Timer(called)) = element.step.target() {
            // Two blocks of one instance are read as Structured Text, which has other codes.
            return self.lose(
                element.id,
                format!("{}, 84{called:02}", opcode.row().letters),
            );
        }
        let (Some(kind), Some(&number)) = (timer(opcode), self.timers.get(&element.id)) else {
            return self.lose(element.id, opcode.row().letters);
        };
        let (&[Some(preset), _], Some(target)) = (element.step.lines(), element.step.target())
        else {
            return self.lose(element.id, opcode.row().letters);
        };
        let instance = self.variables.of(Address::Timer(number), kind);
        let preset = self.value_of(&format!("T#{preset}ms"), wire.at);
        let inputs = [("IN", &wire.from[..]), ("PT", &[preset][..])];
        let id = self
            .body
            .block(kind, Some(&instance), &inputs, &["Q", "ET"], wire.at);
        wire.from = vec![(id, "Q")];
        wire.at.x += COLUMN;
        self.driven(" negated=\"false\"", target.into(), wire);
    }
}

/// The input, output or marker that an instruction names.
fn bit(step: &Step) -> Option<Address> {
    let number = step.number()?;
    Some(match step.opcode().row().kind {
        Kind::Input => Address::Input(number),
        Kind::Output => Address::Output(number),
        Kind::Marker => Address::Marker(number),
        _ => return None,
    })
}
