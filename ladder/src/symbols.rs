//! What an instruction looks like.

use crate::element::Role;
use crate::tree::Gate;
use crate::value::{Load, group, operand, point_of, sign};
use crate::{Address, Element, Symbol};
use unoclp_core::isa::{Opcode, Operand};
use unoclp_core::{Delay, Instruction, Target};

/// A comparison or contact of the value; the source of the value is put in where it is known.
const VALUE: &str = "V";

impl Element {
    /// The symbols of an instruction that has some: one, or of a timer its box and its coil.
    ///
    /// `timer` is the number of the timer that a block here would be; `value` what the value accumulator
    /// is known to hold.
    pub(crate) fn of(
        step: usize,
        instruction: Instruction<'_>,
        timer: u8,
        value: Option<&str>,
    ) -> Vec<Element> {
        if let Operand::Timer(block) = instruction.operand {
            let point = Address::Timer(timer);
            let letters = Delay::of(instruction.opcode).map_or("", Delay::letters);
            let text = format!("{letters} {point} {} ms", block.preset);
            let timer = Element::boxed(step, Role::Function, text, Some(point));
            let mut coil = Element::coil(step, ' ', target(block.target));
            coil.steps.clear();
            return vec![timer, coil];
        }
        vec![Element::single(step, instruction, value.unwrap_or(VALUE))]
    }

    fn single(step: usize, instruction: Instruction<'_>, value: &str) -> Element {
        use Address::{Counter, Input, Marker, Output, Register, System, Timer};
        let xx = instruction.number().unwrap_or(0);
        let letters = instruction.opcode.row().letters;
        let contact = |closed, point| Element::contact(step, closed, point);
        let coil = |letter, point| Element::coil(step, letter, point);
        let xor = |inverted, point: Address| {
            let not = if inverted { "/" } else { "" };
            Element::boxed(step, Role::Logic, format!("XOR {not}{point}"), Some(point))
        };
        let condition =
            |text: String, point| Element::boxed(step, Role::Condition, text, Some(point));
        // Loads and operations are done whatever acc is.
        let operation = |text: String, point| Element::boxed(step, Role::Condition, text, point);
        let function = |text: String, point| Element::boxed(step, Role::Function, text, point);
        match instruction.opcode {
            Opcode::InputContact => contact(false, Input(xx)),
            Opcode::InputContactNot => contact(true, Input(xx)),
            Opcode::OutputContact => contact(false, Output(xx)),
            Opcode::OutputContactNot => contact(true, Output(xx)),
            Opcode::MarkerContact => contact(false, Marker(xx)),
            Opcode::MarkerContactNot => contact(true, Marker(xx)),
            Opcode::SystemContact => contact(false, System(xx)),
            Opcode::SystemContactNot => contact(true, System(xx)),
            Opcode::TimerContact => contact(false, Timer(xx)),
            Opcode::TimerContactNot => contact(true, Timer(xx)),
            Opcode::CounterContact => contact(false, Counter(xx)),
            Opcode::CounterContactNot => contact(true, Counter(xx)),
            Opcode::ZeroContact => condition(format!("C{xx} <= 0"), Counter(xx)),
            Opcode::ZeroContactNot => condition(format!("C{xx} > 0"), Counter(xx)),
            Opcode::BitContact | Opcode::BitContactNot => {
                let closed = instruction.opcode == Opcode::BitContactNot;
                let text = format!("{value}.{xx}");
                Element::new(
                    step,
                    Role::Condition,
                    Symbol::Contact { closed, text },
                    None,
                )
            }
            Opcode::Coil => coil(' ', Output(xx)),
            Opcode::NegatedCoil => coil('/', Output(xx)),
            Opcode::SetCoil => coil('S', Output(xx)),
            Opcode::ResetCoil => coil('R', Output(xx)),
            Opcode::MarkerCoil => coil(' ', Marker(xx)),
            Opcode::NegatedMarkerCoil => coil('/', Marker(xx)),
            Opcode::SetMarker => coil('S', Marker(xx)),
            Opcode::ResetMarker => coil('R', Marker(xx)),
            Opcode::ResetTimer => coil('R', Timer(xx)),
            Opcode::ResetCounter => coil('R', Counter(xx)),
            Opcode::LoadCounter => coil('L', Counter(xx)),
            Opcode::XorInput => xor(false, Input(xx)),
            Opcode::XorInputNot => xor(true, Input(xx)),
            Opcode::XorOutput => xor(false, Output(xx)),
            Opcode::XorOutputNot => xor(true, Output(xx)),
            Opcode::XorMarker => xor(false, Marker(xx)),
            Opcode::XorMarkerNot => xor(true, Marker(xx)),
            Opcode::Not => Element::new(step, Role::Logic, Symbol::Inline("NOT"), None),
            Opcode::RisingEdge => Element::new(step, Role::Logic, Symbol::Inline("P"), None),
            Opcode::FallingEdge => Element::new(step, Role::Logic, Symbol::Inline("N"), None),
            Opcode::Jump | Opcode::JumpNot => {
                let point = Address::Label(xx);
                let symbol = Symbol::Leave {
                    inverted: instruction.opcode == Opcode::JumpNot,
                    text: format!(">> {point}"),
                };
                Element::new(step, Role::Output, symbol, Some(point))
            }
            Opcode::Return | Opcode::ReturnNot => {
                let symbol = Symbol::Leave {
                    inverted: instruction.opcode == Opcode::ReturnNot,
                    text: "<RET>".to_owned(),
                };
                Element::new(step, Role::Output, symbol, None)
            }
            Opcode::LoadBit => Element::boxed(step, Role::Logic, "LD RESULT".to_owned(), None),
            Opcode::LoadInputs
            | Opcode::LoadOutputs
            | Opcode::LoadAnalogue
            | Opcode::LoadTimer
            | Opcode::LoadCount
            | Opcode::LoadSystem
            | Opcode::LoadMarkers
            | Opcode::Load => {
                let source = Load::of(instruction).map_or_else(String::new, |load| load.source);
                operation(format!("LD {source}"), point_of(instruction))
            }
            Opcode::Greater
            | Opcode::GreaterOrEqual
            | Opcode::Equal
            | Opcode::NotEqual
            | Opcode::LessOrEqual
            | Opcode::Less => {
                let sign = sign(instruction.opcode);
                let text = format!("{value} {sign} {}", operand(instruction));
                operation(text, point_of(instruction))
            }
            Opcode::Negate | Opcode::SquareRoot => operation(letters.to_owned(), None),
            Opcode::Add
            | Opcode::Subtract
            | Opcode::Multiply
            | Opcode::Divide
            | Opcode::Modulo
            | Opcode::AndWord
            | Opcode::OrWord
            | Opcode::XorWord => operation(
                format!("{letters} {}", operand(instruction)),
                point_of(instruction),
            ),
            Opcode::ShiftLeft | Opcode::ShiftRight => operation(format!("{letters} {xx}"), None),
            Opcode::Store | Opcode::Integrate => {
                function(format!("{letters} D{xx}"), Some(Register(xx)))
            }
            Opcode::StoreCount => function(format!("ST C{xx}"), Some(Counter(xx))),
            Opcode::StorePwm => function(format!("ST PWM Q{xx}"), Some(Output(xx))),
            Opcode::StoreMarkers => function(format!("ST {}", group(xx)), None),
            Opcode::StoreOutputs => function("ST Q".to_owned(), None),
            Opcode::PresetCounter => function(format!("PRESET C{xx}"), Some(Counter(xx))),
            Opcode::PresetTimer => function(format!("PRESET T{xx}"), Some(Timer(xx))),
            Opcode::InputFilter => operation(format!("INPUT FILTER {xx} ms"), None),
            _ => Element::with_operands(step, instruction),
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

    /// Boxes that have operands of their own, and whatever needs no more than its listing.
    fn with_operands(step: usize, instruction: Instruction<'_>) -> Element {
        let letters = instruction.opcode.row().letters;
        let (role, text, point) = match instruction.operand {
            Operand::Count { counter, preset } => (
                Role::Function,
                format!("{letters} C{counter} {preset}"),
                Some(Address::Counter(counter)),
            ),
            Operand::Move { from, to, count } => {
                let last = |first: u8| first.saturating_add(count).saturating_sub(1);
                let text = format!("MOV D{from}-{} to D{to}-{}", last(from), last(to));
                (Role::Function, text, Some(Address::Register(from)))
            }
            Operand::Drum { register, .. } => (
                Role::Function,
                format!("DRM D{register}"),
                Some(Address::Register(register)),
            ),
            Operand::Scale { from, to } => (
                Role::Condition,
                format!("SCL {}..{} to {}..{}", from[0], from[1], to[0], to[1]),
                None,
            ),
            Operand::Filter { strength, time } => {
                let text = format!("FLT 1/{} {time} ms", 1u32 << strength);
                (Role::Condition, text, None)
            }
            _ => (Role::Function, instruction.to_string(), None),
        };
        let mut element = Element::boxed(step, role, text, point);
        if let (Symbol::Box { notes, .. }, Operand::Drum { steps, .. }) =
            (&mut element.symbol, instruction.operand)
        {
            *notes = drum_notes(steps);
        }
        element
    }
}

fn target(target: Target) -> Address {
    match target {
        Target::Output(number) => Address::Output(number),
        Target::Marker(number) => Address::Marker(number),
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
