//! What a program uses of the board and its memory, for those who show it.

use std::collections::BTreeSet;
use std::fmt;
use unoclp_core::isa::{Class, Kind, Opcode, Operand, Value};
use unoclp_core::{Inputs, Instruction, Needs, Plc, Steps, Target};

/// What takes a REAL from value alone.
const TAKE_REAL: &[Opcode] = &[
    Opcode::RealRound,
    Opcode::RealCut,
    Opcode::RealNegate,
    Opcode::RealAbsolute,
    Opcode::RealRoot,
    Opcode::RealComparable,
];
/// What makes a REAL of value alone.
const GIVE_REAL: &[Opcode] = &[
    Opcode::RealFromSigned,
    Opcode::RealFromUnsigned,
    Opcode::RealNegate,
    Opcode::RealAbsolute,
    Opcode::RealRoot,
];

/// The bits of a REAL number as people read it: `0.5`, `1e30`; those of none as `inf` or `NaN`.
pub fn real(bits: i32) -> String {
    format!("{:?}", f32::from_bits(bits.cast_unsigned()))
}

/// Whether the value after this step is a REAL, of a program that uses these registers.
pub fn is_real(step: &Instruction<'_>, used: &Used) -> bool {
    let register = match step.operand {
        Operand::Value(Value::Register(register)) => Some(register),
        _ => step.number().filter(|_| step.opcode == Opcode::Store),
    };
    let is_of_real = step.opcode.row().kind == Kind::Real || GIVE_REAL.contains(&step.opcode);
    let moves = matches!(step.opcode.class(), Class::Load | Class::Store);
    is_of_real || moves && register.is_some_and(|register| used.reals.contains(&register))
}

/// The numbers that a program names, in rising order.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Used {
    /// Inputs that contacts name.
    pub inputs: BTreeSet<u8>,
    /// Analogue inputs, from 0.
    pub analogue: BTreeSet<u8>,
    /// Outputs that are named, PWM apart.
    pub outputs: BTreeSet<u8>,
    /// Outputs that are PWM.
    pub pwm: BTreeSet<u8>,
    /// Markers, those of groups among them.
    pub markers: BTreeSet<u8>,
    /// Registers, those of block moves among them.
    pub registers: BTreeSet<u8>,
    /// Those of the registers that hold REAL numbers: a REAL operation reads them, or its result is stored in them.
    pub reals: BTreeSet<u8>,
    /// Counters.
    pub counters: BTreeSet<u8>,
}

impl Used {
    /// What a program uses that needs these pins and has these steps.
    pub fn of(needs: Needs, steps: Steps<'_>) -> Used {
        let bits = |bits: u128, first: u8| -> BTreeSet<u8> {
            let set = (0..99).filter(|bit| bits >> bit & 1 != 0);
            set.map(|bit| bit + first).collect()
        };
        let mut used = Used {
            analogue: bits(needs.analogue, 0),
            outputs: bits(needs.outputs, 1),
            pwm: bits(needs.pwm, 1),
            ..Used::default()
        };
        // Whether value is a REAL, and the register that it was loaded from last.
        let (mut real, mut loaded) = (false, None);
        for step in steps {
            used.note(&step);
            used.note_real(&step, &mut real, &mut loaded);
        }
        used
    }

    /// Notes the registers that REAL operations work with.
    fn note_real(&mut self, step: &Instruction<'_>, real: &mut bool, loaded: &mut Option<u8>) {
        let kind = step.opcode.row().kind;
        let register = match step.operand {
            Operand::Value(Value::Register(register)) => Some(register),
            _ => None,
        };
        let takes = kind == Kind::Real || TAKE_REAL.contains(&step.opcode);
        if takes {
            // A result of another operation is loaded from nowhere.
            self.reals.extend(loaded.take());
        }
        if kind == Kind::Real {
            self.reals.extend(register);
        }
        match step.opcode.class() {
            Class::Load => {
                *loaded = register;
                *real = register.is_some_and(|register| self.reals.contains(&register));
            }
            Class::Operation if step.opcode != Opcode::Push => {
                *real = kind == Kind::Real || GIVE_REAL.contains(&step.opcode);
                *loaded = None;
            }
            Class::Store if step.opcode == Opcode::Store && *real => {
                self.reals.extend(step.number());
            }
            _ => {}
        }
    }

    fn note(&mut self, step: &Instruction<'_>) {
        let xx = step.number().unwrap_or_default();
        match step.opcode.row().kind {
            Kind::Input => drop(self.inputs.insert(xx)),
            Kind::Marker => drop(self.markers.insert(xx)),
            Kind::Group => self.markers.extend(xx * 8 - 7..=xx * 8),
            Kind::Register | Kind::Drum => drop(self.registers.insert(xx)),
            Kind::Counter | Kind::Count => drop(self.counters.insert(xx)),
            _ => {}
        }
        match step.operand {
            Operand::Value(Value::Register(register)) => drop(self.registers.insert(register)),
            Operand::Move { from, to, count } => {
                self.registers.extend(from..from + count);
                self.registers.extend(to..to + count);
            }
            Operand::Table { first, length } => self.registers.extend(first..first + length),
            Operand::Timer(block) => {
                if let Target::Marker(marker) = block.target {
                    self.markers.insert(marker);
                }
            }
            _ => {}
        }
    }

    /// The quantities beside inputs, outputs and timers as they stand after a scan with these inputs; in
    /// the same order each time.
    pub fn quantities(&self, plc: &Plc<'_>, inputs: &Inputs) -> Vec<Quantity> {
        let quantity =
            |letter: char, number: u8, bits: u32, value: i32, of: Option<i32>| Quantity {
                name: format!("{letter}{number}"),
                bits,
                value,
                of,
                is_real: false,
            };
        let reading = |input: u8| inputs.analogue.get(usize::from(input)).copied();
        let analogue = self.analogue.iter().map(|&input| {
            let reading = reading(input).unwrap_or_default();
            quantity('A', input, 10, reading.into(), None)
        });
        let pwm = self.pwm.iter().map(|&output| {
            let duty = plc.pwm(output);
            quantity('P', output, 8, duty.into(), None)
        });
        let states: Vec<_> = plc.counters().collect();
        let counters = self.counters.iter().filter_map(|&counter| {
            let state = states.get(usize::from(counter).wrapping_sub(1))?;
            Some(quantity('C', counter, 32, state.value, Some(state.preset)))
        });
        let registers = self.registers.iter().filter_map(|&register| {
            let value = plc.registers().get(usize::from(register).wrapping_sub(1))?;
            Some(Quantity {
                is_real: self.reals.contains(&register),
                ..quantity('D', register, 32, *value, None)
            })
        });
        let markers = self.markers.iter().map(|&marker| {
            let state = plc.markers() >> marker.wrapping_sub(1) & 1;
            quantity('M', marker, 1, state as i32, None)
        });
        analogue
            .chain(pwm)
            .chain(counters)
            .chain(registers)
            .chain(markers)
            .collect()
    }
}

impl fmt::Display for Used {
    /// The pins: `I1 I2 A0 Q1 P4`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let kinds = [
            ('I', &self.inputs),
            ('A', &self.analogue),
            ('Q', &self.outputs),
            ('P', &self.pwm),
        ];
        let names = kinds.iter().flat_map(|(letter, numbers)| {
            numbers
                .iter()
                .map(move |number| format!("{letter}{number}"))
        });
        let names: Vec<String> = names.collect();
        f.write_str(&names.join(" "))
    }
}

/// A number or state of a running program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Quantity {
    /// `D3`
    pub name: String,
    /// How many bits it has; 1 where it is a state.
    pub bits: u32,
    /// What it is.
    pub value: i32,
    /// A counter's preset.
    pub of: Option<i32>,
    /// Whether it is a REAL number.
    pub is_real: bool,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::load;

    #[test]
    fn registers_of_real_operations_are_real() {
        // D 04 := D 01 * D 02; D 05 := D 04; D 06 := D 03, rounded
        let text = "0 766801 82778502 838404 787600 766804 838405 787600 766803 827868 838406";
        let source = load(text.replace(' ', "\n").as_bytes(), unoclp_core::Board::UNO).unwrap();
        let program = source.program();
        let used = Used::of(program.needs(), program.steps());
        assert_eq!(used.reals, BTreeSet::from([1, 2, 3, 4, 5]));
        assert_eq!([real(0x3F00_0000), real(0)], ["0.5", "0.0"]);
    }
}
