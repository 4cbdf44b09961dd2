//! What an instruction looks like.

use crate::element::Role;
use crate::pins::Pins;
use crate::tree::Gate;
use crate::value::Load;
use crate::words::{VALUE, amount, picture, words};
use crate::{Element, Symbol};
use unoclp_core::isa::{Class, Operand};
use unoclp_core::{Instruction, Target};
use unoclp_point::Address;

impl Element {
    /// The symbols of an instruction that has some: one, or of a timer its box and its coil. One that is called again has
    /// another box.
    ///
    /// `timer` is the number of the timer that a block here would be; `value` what the value accumulator
    /// is known to hold.
    pub(crate) fn of(
        step: usize,
        instruction: Instruction<'_>,
        timer: u8,
        value: Option<&str>,
    ) -> Vec<Element> {
        let words = words(instruction, value.unwrap_or(VALUE));
        if let Operand::Timer(block) = instruction.operand {
            let point = match block.target {
                Target::Timer(called) => Address::Timer(called),
                _ => Address::Timer(timer),
            };
            let preset = amount(block.preset.cast_signed());
            let text = format!("{words} {point} {preset} ms");
            let mut timer = Element::boxed(step, Role::Function, text, Some(point));
            timer.pins = Pins::of(instruction);
            if !block.is_own() {
                return vec![timer];
            }
            let mut coil = Element::coil(step, ' ', block.target.into());
            coil.steps.clear();
            return vec![timer, coil];
        }
        vec![Element::single(step, instruction, words)]
    }

    fn single(step: usize, instruction: Instruction<'_>, words: String) -> Element {
        let point = Address::of(instruction);
        let opcode = instruction.opcode;
        let inverted = opcode.is_inverted();
        let boxed = |role, text| Element::boxed(step, role, text, point);
        match opcode.class() {
            Class::Contact | Class::ValueContact => {
                let symbol = Symbol::Contact {
                    closed: inverted,
                    text: words,
                };
                Element::new(step, Role::Condition, symbol, point)
            }
            // What is done whatever acc is, conducts as a contact does.
            Class::Condition | Class::Comparison | Class::Operation | Class::Setting => {
                boxed(Role::Condition, words)
            }
            Class::Load => boxed(Role::Condition, Load::text(&words)),
            Class::Xor | Class::LoadResult => boxed(Role::Logic, words),
            Class::Logic => Element::new(step, Role::Logic, Symbol::Inline(picture(opcode)), None),
            Class::Coil => {
                let text = point.map_or_else(String::new, |point| point.to_string());
                let letter = picture(opcode).chars().next().unwrap_or(' ');
                Element::new(step, Role::Output, Symbol::Coil { letter, text }, point)
            }
            Class::Leave => {
                let symbol = Symbol::Leave {
                    inverted,
                    text: words,
                };
                Element::new(step, Role::Output, symbol, point)
            }
            // It ends its rung, as a jump does.
            Class::If => boxed(Role::Output, words),
            Class::Count | Class::Store => {
                let mut element = boxed(Role::Function, words);
                if let (Symbol::Box { notes, .. }, Operand::Drum { steps, .. }) =
                    (&mut element.symbol, instruction.operand)
                {
                    *notes = drum_notes(steps);
                }
                element.pins = Pins::of(instruction);
                element
            }
            // These are wires, and a timer has its box and its coil.
            Class::Rung | Class::Label | Class::Part => {
                boxed(Role::Function, instruction.to_string())
            }
            Class::OpenOr | Class::OpenAnd | Class::OpenXor => {
                boxed(Role::Function, instruction.to_string())
            }
            Class::Close | Class::StorePoint | Class::RecallPoint | Class::Timer => {
                boxed(Role::Function, instruction.to_string())
            }
        }
    }

    /// The box in which two paths come together.
    pub(crate) fn gate(close: usize, gate: Gate) -> Element {
        let text = match gate {
            Gate::Or => "OR",
            Gate::And => "AND",
            Gate::Xor => "XOR",
        };
        let mut element = Element::boxed(close, Role::Function, text.to_owned(), None);
        element.steps.clear();
        element
    }
}

/// The steps of a sequencer, four on a line: `0:1001 1:0110`, the digit of output 01 first.
fn drum_notes(steps: &[u8]) -> Vec<String> {
    let step = |(index, step): (usize, &u8)| {
        let digits: String = (0..4)
            .map(|output| if step >> output & 1 == 0 { '0' } else { '1' })
            .collect();
        format!("{index}:{digits}")
    };
    let steps: Vec<String> = steps.iter().enumerate().map(step).collect();
    steps.chunks(4).map(|line| line.join(" ")).collect()
}
