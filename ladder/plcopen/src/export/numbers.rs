//! Loads, operations, comparisons and stores: what value holds, as blocks that compute it.

use super::draw::{Draw, Values, Wire};
use super::xml::Source;
use unoclp_core::isa::{Class, Kind, Opcode, POPPED};
use unoclp_draw::edit::{Element, Step};
use unoclp_point::Address;

impl Draw {
    /// An instruction on numbers.
    pub(crate) fn number(&mut self, element: &Element, wire: &mut Wire) {
        let step = &element.step;
        let done = match step.class() {
            Class::Load => self.load(step, wire).map(|value| {
                self.values.value = Some(value);
                self.values.stored = None;
            }),
            Class::Operation if step.opcode() == Opcode::Push => {
                let value = self.values.value;
                value.map(|value| self.values.pushed.push(value))
            }
            Class::Operation => self.operation(step, wire),
            Class::Comparison => self.comparison(element, wire),
            Class::Store => self.store(step, wire),
            _ if step.opcode() == Opcode::Push => {
                let value = self.values.value;
                value.map(|value| self.values.pushed.push(value))
            }
            _ => None,
        };
        if done.is_none() {
            self.lose(element.id, step.opcode().row().letters);
        }
    }

    fn load(&mut self, step: &Step, wire: &Wire) -> Option<Source> {
        let number = step.number()?;
        let expression = match step.opcode() {
            Opcode::Load => return self.operand(step, wire),
            Opcode::LoadAnalogue => self.variables.of(Address::Analogue(number), "INT"),
            Opcode::LoadTimer => {
                format!("{}.ET", self.variables.of(Address::Timer(number), "TON"))
            }
            Opcode::LoadCount => match self.drawn.get(&number) {
                Some(block) => return Some((*block, "CV")),
                None => format!("{}.CV", self.counted(number)?),
            },
            _ => return None,
        };
        Some(self.value_of(&expression, wire.at))
    }

    /// The register or constant that an instruction names.
    fn operand(&mut self, step: &Step, wire: &Wire) -> Option<Source> {
        let expression = match (step.number()?, step.lines()) {
            (0, &[Some(constant)]) => constant.to_string(),
            (POPPED, _) | (0, _) => return None,
            (register, _) => self.variables.of(Address::Register(register), "DINT"),
        };
        Some(self.value_of(&expression, wire.at))
    }

    /// The two operands of an instruction: what was pushed is the left one.
    fn operands(&mut self, step: &Step, wire: &Wire) -> Option<(Source, Source)> {
        let value = self.values.value?;
        match step.number() {
            Some(POPPED) => Some((self.values.pushed.pop()?, value)),
            _ => Some((value, self.operand(step, wire)?)),
        }
    }

    fn operation(&mut self, step: &Step, wire: &mut Wire) -> Option<()> {
        self.values.stored = None;
        let block = match step.opcode() {
            Opcode::Add => "ADD",
            Opcode::Subtract => "SUB",
            Opcode::Multiply => "MUL",
            Opcode::Divide => "DIV",
            Opcode::Modulo => "MOD",
            Opcode::ShiftLeft => "SHL",
            Opcode::ShiftRight => "SHR",
            _ => return None,
        };
        let (left, right, names) = if step.opcode().row().kind == Kind::Bit {
            let by = step.number()?.to_string();
            let left = self.values.value?;
            (left, self.value_of(&by, wire.at), ["IN", "N"])
        } else {
            let (left, right) = self.operands(step, wire)?;
            (left, right, ["IN1", "IN2"])
        };
        let inputs = [(names[0], &[left][..]), (names[1], &[right][..])];
        self.row += 60;
        let at = super::xml::At {
            y: self.row,
            ..wire.at
        };
        let id = self.body.block(block, None, &inputs, &["OUT"], at);
        wire.at.x += 120;
        self.values.value = Some((id, "OUT"));
        Some(())
    }

    fn comparison(&mut self, element: &Element, wire: &mut Wire) -> Option<()> {
        if let Some(load) = &element.load {
            let value = self.load(load, wire)?;
            self.values.value = Some(value);
        }
        self.values.stored = None;
        let block = match element.step.opcode() {
            Opcode::Greater => "GT",
            Opcode::GreaterOrEqual => "GE",
            Opcode::Equal => "EQ",
            Opcode::NotEqual => "NE",
            Opcode::LessOrEqual => "LE",
            Opcode::Less => "LT",
            _ => return None,
        };
        let (left, right) = self.operands(&element.step, wire)?;
        let enables = self.enables(wire);
        let inputs = [
            ("EN", &enables[..]),
            ("IN1", &[left][..]),
            ("IN2", &[right][..]),
        ];
        let id = self
            .body
            .block(block, None, &inputs, &["ENO", "OUT"], wire.at);
        wire.from = vec![(id, "OUT")];
        wire.at.x += 120;
        Some(())
    }

    fn store(&mut self, step: &Step, wire: &mut Wire) -> Option<()> {
        let number = step.number()?;
        let name = match step.opcode() {
            Opcode::Store => self.variables.of(Address::Register(number), "DINT"),
            Opcode::StorePwm => self.variables.pwm(number),
            _ => return None,
        };
        // What has been pushed may no longer be what its registers hold.
        if !self.values.pushed.is_empty() {
            return None;
        }
        let block = match self.values.stored {
            Some(block) => block,
            None => {
                let value = self.values.value?;
                let enables = self.enables(wire);
                let inputs = [("EN", &enables[..]), ("IN", &[value][..])];
                let id = self
                    .body
                    .block("MOVE", None, &inputs, &["ENO", "OUT"], wire.at);
                wire.from = vec![(id, "ENO")];
                wire.at.x += 120;
                (id, "OUT")
            }
        };
        self.row = self.row.max(wire.at.y) + 60;
        let at = super::xml::At {
            y: self.row,
            ..wire.at
        };
        self.body.taken(" negated=\"false\"", &name, block, at);
        self.values = Values {
            value: None,
            pushed: Vec::new(),
            stored: Some(block),
        };
        Some(())
    }
}
