//! What the names of a text mean: declared variables, addresses, and names that nothing declares.

mod declare;
mod points;
mod retain;

use crate::Dialect;
use crate::address::{Address, parse};
use crate::ast::{Operand, OperandKind, Param, Stmt, Unit, UnitKind};
use crate::diagnostics::{Code, Found, Span};
use crate::operators::Op;
use crate::temps::Temps;
use crate::tree::{Bit, Num};
use retain::Retained;
use std::collections::HashMap;
use unoclp_core::Profile;
use unoclp_core::isa::{Kind, MARKER_OPERAND, Opcode, Row, TABLE};

/// What an operand means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Place {
    Bit(Bit),
    Always(bool),
    Number(Num),
    /// A timer as a whole, by its index.
    Timer(usize),
    /// A counter as a whole, by its index.
    Counter(usize),
    /// R_TRIG or F_TRIG: its Q.
    Trigger(Opcode, u8),
    /// An instance of a function block of the file, by its index.
    Instance(usize),
    /// Something was wrong with it, and has been told.
    Unknown,
}

/// A timer of the text.
#[derive(Debug)]
pub(crate) struct Timer {
    pub name: String,
    pub kind: Option<Opcode>,
    pub preset: Option<i32>,
    pub calls: u32,
    /// Where its Q or its time is first read.
    pub read: Option<Span>,
}

/// A counter of the text.
#[derive(Debug)]
pub(crate) struct Counter {
    pub name: String,
    /// C 01 to C 16.
    pub number: u8,
    pub kind: Option<Opcode>,
    pub preset: Option<i32>,
}

/// An instance of a function block of the file, or what its functions keep.
#[derive(Debug)]
pub(crate) struct Instance {
    /// The unit's index.
    pub unit: usize,
    pub names: HashMap<String, Place>,
}

/// An input that has been declared.
#[derive(Debug)]
pub(crate) struct DeclaredInput {
    pub name: String,
    pub span: Span,
    pub input: u8,
}

/// A variable that begins with another value than 0.
#[derive(Debug)]
pub(crate) struct Initial {
    pub place: Place,
    pub value: i32,
    pub span: Span,
}

pub(crate) struct Names {
    pub dialect: Dialect,
    pub board: Profile,
    pub timers: Vec<Timer>,
    pub counters: Vec<Counter>,
    pub instances: Vec<Instance>,
    pub inputs: Vec<DeclaredInput>,
    pub initials: Vec<Initial>,
    pub retained: Retained,
    pub temps: Temps,
    /// Names that hold in the whole file: those that nothing declares, timers and counters.
    global: HashMap<String, Place>,
    /// Function blocks of the file.
    blocks: HashMap<String, usize>,
    counters_used: u16,
    /// Bit 0 is input 01.
    pub inputs_read: u16,
}

impl Names {
    /// Looks through the whole text, so that no name gets what an address of the text means.
    pub(crate) fn new(dialect: Dialect, board: Profile, units: &[Unit]) -> Names {
        let mut names = Names {
            dialect,
            board,
            timers: Vec::new(),
            counters: Vec::new(),
            instances: Vec::new(),
            inputs: Vec::new(),
            initials: Vec::new(),
            retained: Retained::default(),
            temps: Temps::default(),
            global: HashMap::new(),
            blocks: HashMap::new(),
            counters_used: 0,
            inputs_read: 0,
        };
        for (index, unit) in units.iter().enumerate() {
            if let (UnitKind::FunctionBlock, Some(name)) = (unit.kind, &unit.name) {
                names.blocks.insert(name.text.clone(), index);
            }
            for var in &unit.vars {
                var.at.iter().for_each(|at| names.note(at));
                names.note_name(&var.name.text);
            }
            for stmt in &unit.body {
                if let Stmt::Instr(instr) = stmt {
                    if instr.op == Op::Code {
                        names.note_code(&instr.operands);
                    }
                    instr
                        .operands
                        .iter()
                        .for_each(|operand| names.note(operand));
                    instr
                        .params
                        .iter()
                        .for_each(|Param { value, .. }| names.note(value));
                }
            }
        }
        names
    }

    fn note(&mut self, operand: &Operand) {
        if let Some(name) = operand.name() {
            self.note_name(name);
        }
    }

    /// What a code of the text names.
    fn note_code(&mut self, operands: &[Operand]) {
        let codes: Vec<i32> = operands.iter().filter_map(Operand::number).collect();
        let Some(&code) = codes.first() else { return };
        let with_number = |row: &&Row| row.kind.has_number() && row.code / 100 == code / 100;
        let Some(row) = TABLE.iter().find(with_number) else {
            // A timer block names a marker in its last line.
            if let Some(n @ 1..=64) = codes.get(2).map(|target| target - MARKER_OPERAND) {
                self.temps.markers |= 1 << (n - 1);
            }
            return;
        };
        let n = (code - row.code).unsigned_abs();
        let exists = row
            .kind
            .numbers()
            .is_some_and(|(first, last)| (u32::from(first)..=u32::from(last)).contains(&n));
        // A register 00 is a constant.
        if !exists || n == 0 {
            return;
        }
        match row.kind {
            Kind::Marker => self.temps.markers |= 1 << (n - 1),
            Kind::Group => self.temps.markers |= 0xFF << (8 * (n - 1)),
            Kind::Counter | Kind::Count => self.counters_used |= 1 << (n - 1),
            Kind::Register | Kind::Value | Kind::Drum => self.temps.registers |= 1 << (n - 1),
            // A block may go on to the last.
            Kind::Move => self.temps.registers = u32::MAX,
            // The compiler gives none of these out.
            Kind::Input | Kind::Output | Kind::Branch | Kind::System | Kind::TimerQ => {}
            Kind::Analogue | Kind::Pwm | Kind::Reading | Kind::Bit | Kind::Time => {}
            Kind::Label | Kind::Jump | Kind::Filter => {}
            Kind::None | Kind::Timer | Kind::Scale => {}
        }
    }

    fn note_name(&mut self, name: &str) {
        match parse(name, self.dialect) {
            Some(Address::Marker(n @ 1..=64)) => self.temps.markers |= 1 << (n - 1),
            Some(Address::Group(n @ 1..=8)) => self.temps.markers |= 0xFF << (8 * (n - 1)),
            Some(Address::Register(n @ 1..=32)) => self.temps.registers |= 1 << (n - 1),
            Some(Address::Counter(name, _)) => {
                if let Some(n @ 1..=16) = name.strip_prefix('C').and_then(|n| n.parse::<u32>().ok())
                {
                    self.counters_used |= 1 << (n - 1);
                }
            }
            _ => {}
        }
    }

    pub(crate) fn told_none_left(&mut self, span: Span, found: &mut Found) {
        if let Some(words) = self.temps.none_left.take() {
            found.tell(Code::NoneLeft, span, [words.into()]);
        }
    }

    /// What an operand means, as seen from an instance. What is wrong is told.
    pub(crate) fn place(
        &mut self,
        operand: &Operand,
        instance: Option<usize>,
        found: &mut Found,
    ) -> Place {
        let name = match &operand.kind {
            OperandKind::Name(name) => name,
            OperandKind::Number(number) => return Place::Number(Num::Const(*number)),
            OperandKind::Bool(state) => return Place::Always(*state),
        };
        let span = operand.span;
        if let Some(place) = self.declared_place(name, span, instance, found) {
            return place;
        }
        let Some(address) = parse(name, self.dialect) else {
            if name.contains(['%', '.']) {
                let help = ADDRESS_HELP;
                found.tell(Code::NoSuchPoint, span, [name.as_str().into(), help.into()]);
                return Place::Unknown;
            }
            let marker = self.temps.named_marker(false);
            found.tell(
                Code::Undeclared,
                span,
                [name.as_str().into(), format!("M{marker}").into()],
            );
            self.told_none_left(span, found);
            let place = Place::Bit(Bit::Marker(marker));
            self.global.insert(name.clone(), place);
            return place;
        };
        self.address(address, name, span, found)
    }

    fn declared_place(
        &mut self,
        name: &str,
        span: Span,
        instance: Option<usize>,
        found: &mut Found,
    ) -> Option<Place> {
        if name.starts_with('%') {
            return None;
        }
        let look_up = |names: &Names, name: &str| {
            let local = instance.and_then(|instance| names.instances[instance].names.get(name));
            local.or_else(|| names.global.get(name)).copied()
        };
        if let Some(place) = look_up(self, name) {
            return Some(place);
        }
        let (base, member) = name.split_once('.')?;
        let place = look_up(self, base)?;
        Some(self.member(place, base, member, span, found))
    }
}

/// What messages say where there is no such point.
const ADDRESS_HELP: (&str, &str) = (
    "points count from 1: I1 to I8, Q1 to Q4, M1 to M64, D1 to D32, IW0 to IW4, QW1 and QW4, C1 to C16",
    "os pontos contam a partir de 1: I1 a I8, Q1 a Q4, M1 a M64, D1 a D32, IW0 a IW4, QW1 e QW4, C1 a C16",
);
