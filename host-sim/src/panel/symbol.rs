//! How an instruction is drawn: `┤ I1 ├`, `( Q1 )`, `[ADD D3]`.

use super::ladder::Flow;
use unoclp_core::isa::{Kind, Opcode, Operand, Value};
use unoclp_core::{Instruction, Target};

/// What is drawn for an instruction.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Symbol {
    /// A contact, whose sides show whether it conducts.
    Contact(String),
    /// Anything else that never changes.
    Fixed(String),
    /// A timer block: its index, what stands before and behind the elapsed time.
    Timer(usize, String, String),
    /// A counter block, likewise.
    Counter(usize, String, String),
}

impl Symbol {
    /// The symbol of an instruction; `timer` is the number of its timer, `opening` what it is drawn
    /// together with.
    pub(super) fn new(
        instruction: &Instruction<'_>,
        timer: usize,
        opening: Option<Symbol>,
    ) -> Symbol {
        let opcode = instruction.opcode;
        let letters = opcode.row().letters;
        let negated = if letters.starts_with('-') { "/" } else { " " };
        let point = point(opcode.row().kind, instruction.number().unwrap_or_default());
        match opcode {
            Opcode::OpenBranch => return Symbol::Fixed("╭or".to_owned()),
            Opcode::OpenAnd => return Symbol::Fixed("╭and".to_owned()),
            Opcode::OpenXor => return Symbol::Fixed("╭xor".to_owned()),
            Opcode::CloseBranch => return Symbol::Fixed("╯".to_owned()),
            Opcode::StoreBranch => return Symbol::Fixed(format!("•{point}")),
            Opcode::RecallBranch => {
                let opening = match opening {
                    Some(Symbol::Fixed(text)) => text,
                    _ => String::new(),
                };
                return Symbol::Fixed(format!("{opening}•{point}"));
            }
            Opcode::Not => return Symbol::Contact("NOT".to_owned()),
            Opcode::RisingEdge => return Symbol::Contact(" ↑ ".to_owned()),
            Opcode::FallingEdge => return Symbol::Contact(" ↓ ".to_owned()),
            Opcode::Return | Opcode::ReturnNot => {
                return Symbol::Fixed(format!("«{}RET", negated.trim()));
            }
            Opcode::Label => return Symbol::Fixed(format!("{point}:")),
            Opcode::Jump | Opcode::JumpNot => {
                return Symbol::Fixed(format!("»{}{point}", negated.trim()));
            }
            Opcode::ZeroContact | Opcode::ZeroContactNot => {
                return Symbol::Contact(format!("{negated}{point}≤0 "));
            }
            Opcode::XorInput | Opcode::XorOutput | Opcode::XorMarker => {
                return Symbol::Contact(format!("⊕{point} "));
            }
            Opcode::XorInputNot | Opcode::XorOutputNot | Opcode::XorMarkerNot => {
                return Symbol::Contact(format!("⊕/{point} "));
            }
            Opcode::Coil | Opcode::MarkerCoil => return Symbol::Fixed(format!("( {point} )")),
            Opcode::NegatedCoil | Opcode::NegatedMarkerCoil => {
                return Symbol::Fixed(format!("(/{point} )"));
            }
            Opcode::SetCoil | Opcode::SetMarker => return Symbol::Fixed(format!("(S {point})")),
            Opcode::ResetCoil | Opcode::ResetMarker | Opcode::ResetTimer | Opcode::ResetCounter => {
                return Symbol::Fixed(format!("(R {point})"));
            }
            Opcode::LoadCounter => return Symbol::Fixed(format!("(L {point})")),
            _ => {}
        }
        match (instruction.operand, comparison(opcode)) {
            (Operand::Value(operand), Some(sign)) => {
                Symbol::Contact(format!(" {sign}{} ", number(operand)))
            }
            (Operand::Value(operand), None) => {
                Symbol::Fixed(format!("[{letters} {}]", number(operand)))
            }
            (Operand::Timer(block), _) => Symbol::Timer(
                timer.saturating_sub(1),
                format!("[T{timer} {letters} "),
                format!("/{} {}]", block.preset, name(block.target)),
            ),
            (Operand::Count { counter, preset }, _) => Symbol::Counter(
                usize::from(counter).saturating_sub(1),
                format!("[{point} {letters} "),
                format!("/{preset}]"),
            ),
            (Operand::Move { from, to, count }, _) => {
                Symbol::Fixed(format!("[MOV {count} D{from} to D{to}]"))
            }
            (Operand::Drum { register, steps }, _) => {
                Symbol::Fixed(format!("[DRM D{register} of {}]", steps.len()))
            }
            (Operand::Number(_), _) if is_contact(opcode) => {
                Symbol::Contact(format!("{negated}{point} "))
            }
            (Operand::Number(_), _) => Symbol::Fixed(format!("[{letters} {point}]")),
            (Operand::Scale { .. } | Operand::Filter { .. } | Operand::None, _) => {
                Symbol::Fixed(format!("[{instruction}]"))
            }
            (Operand::Jump { .. }, _) => Symbol::Fixed(format!("»{point}")),
        }
    }

    /// The symbol as it stands, with acc behind it.
    pub(super) fn text(&self, power: bool, flow: &Flow) -> String {
        let block = |count: String, before: &str, behind: &str| {
            let width = behind.find([' ', ']']).unwrap_or(1) - 1;
            format!("{before}{count:>width$}{behind}")
        };
        match self {
            Symbol::Contact(text) if power => format!("┥{text}┝"),
            Symbol::Contact(text) => format!("┤{text}├"),
            Symbol::Fixed(text) => text.clone(),
            Symbol::Timer(index, before, behind) => {
                let elapsed = flow.elapsed.get(*index).copied().unwrap_or_default();
                block(elapsed.to_string(), before, behind)
            }
            Symbol::Counter(index, before, behind) => {
                let counted = flow.counted.get(*index).copied().unwrap_or_default();
                block(counted.to_string(), before, behind)
            }
        }
    }
}

/// The short name of what a timer drives: `Q1`, `M12`.
pub(super) fn name(target: Target) -> String {
    match target {
        Target::Output(number) => format!("Q{number}"),
        Target::Marker(number) => format!("M{number}"),
    }
}

/// The short name of what a code of this kind names with this XX: `I1`, `D12`.
fn point(kind: Kind, xx: u8) -> String {
    let letter = match kind {
        Kind::Input => "I",
        Kind::Output => "Q",
        Kind::Pwm => "P",
        Kind::Marker => "M",
        Kind::System => "S",
        Kind::TimerQ => "T",
        Kind::Counter | Kind::Count => "C",
        Kind::Register => "D",
        Kind::Analogue => "A",
        Kind::Bit => "bit ",
        Kind::Label => "LB ",
        Kind::Group => return format!("M{}–{}", xx * 8 - 7, xx * 8),
        Kind::Time => return format!("{xx} ms"),
        _ => "",
    };
    format!("{letter}{xx}")
}

/// What an operation works with: `D3`, or a constant.
fn number(operand: Value) -> String {
    match operand {
        Value::Register(register) => format!("D{register}"),
        Value::Constant(number) => number.to_string(),
    }
}

fn comparison(opcode: Opcode) -> Option<&'static str> {
    Some(match opcode {
        Opcode::Greater => ">",
        Opcode::GreaterOrEqual => "≥",
        Opcode::Equal => "=",
        Opcode::NotEqual => "≠",
        Opcode::LessOrEqual => "≤",
        Opcode::Less => "<",
        _ => return None,
    })
}

fn is_contact(opcode: Opcode) -> bool {
    opcode.row().effect.starts_with("contact")
}
