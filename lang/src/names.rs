//! What the names of a text mean: declared variables, addresses, and names that nothing declares.

use crate::Dialect;
use crate::address::{Address, parse};
use crate::ast::{Operand, OperandKind, Param, Section, Stmt, Unit, UnitKind, Var};
use crate::diagnostics::{Code, Found, Span};
use crate::operators::Op;
use crate::temps::Temps;
use crate::tree::{Bit, Num};
use std::collections::HashMap;
use unoclp_core::Profile;
use unoclp_core::isa::{
    ANALOGUE, COUNTERS, Kind, MARKER_OPERAND, MARKERS, Opcode, REGISTERS, Row, SYSTEM_MARKERS,
    TABLE,
};

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
        match row.kind {
            Kind::Marker if (1..=64).contains(&n) => self.temps.markers |= 1 << (n - 1),
            Kind::Group if (1..=8).contains(&n) => self.temps.markers |= 0xFF << (8 * (n - 1)),
            Kind::Counter | Kind::Count if (1..=16).contains(&n) => {
                self.counters_used |= 1 << (n - 1)
            }
            Kind::Register | Kind::Value | Kind::Drum if (1..=32).contains(&n) => {
                self.temps.registers |= 1 << (n - 1);
            }
            // A block may go on to the last.
            Kind::Move => self.temps.registers = u32::MAX,
            _ => {}
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

    /// Declares the variables of a unit; the names are those of one instance of it.
    pub(crate) fn declare(&mut self, vars: &[Var], instance: usize, found: &mut Found) {
        for var in vars {
            let place = self.declared(var, found);
            let name = var.name.text.trim_start_matches('%').to_owned();
            if let Place::Bit(Bit::Input(input)) = place {
                let (name, span) = (var.name.text.clone(), var.name.span);
                self.inputs.push(DeclaredInput { name, span, input });
            }
            // An address that is declared, such as %TM1, means the same in the whole file.
            let direct = parse(&var.name.text, self.dialect).is_some();
            let names = match direct {
                true => &mut self.global,
                false => &mut self.instances[instance].names,
            };
            if names.insert(name, place).is_some() && !direct {
                let text = var.name.text.clone();
                found.tell(Code::NameTwice, var.name.span, [text.into()]);
            }
        }
    }

    fn declared(&mut self, var: &Var, found: &mut Found) -> Place {
        let init = var.init.as_ref().and_then(Operand::number);
        let span = var.name.span;
        if let Some(at) = &var.at {
            let place = self.place(at, None, found);
            self.initial(place, init, span);
            return place;
        }
        let name = var.name.text.trim_start_matches('%').to_owned();
        let retained = var.section == Section::Retain;
        let timer = |names: &mut Names, kind| names.new_timer(name.clone(), Some(kind), init);
        let counter = |names: &mut Names, kind| names.new_counter(name.clone(), Some(kind), init);
        match var.ty.text.as_str() {
            "BOOL" => {
                let place = Place::Bit(Bit::Marker(self.temps.named_marker(retained)));
                self.initial(place, init, span);
                self.told_none_left(span, found);
                place
            }
            "INT" | "DINT" | "SINT" | "UINT" | "UDINT" | "USINT" | "WORD" | "DWORD" | "BYTE"
            | "TIME" => {
                let place = Place::Number(Num::Register(self.temps.named_register()));
                self.initial(place, init, span);
                self.told_none_left(span, found);
                place
            }
            "TON" => timer(self, Opcode::OnDelay),
            "TOF" => timer(self, Opcode::OffDelay),
            "TP" => timer(self, Opcode::Pulse),
            "TONR" | "TOR" => timer(self, Opcode::RetentiveOnDelay),
            "CTU" | "CTUD" => counter(self, Opcode::CountUp),
            "CTD" => counter(self, Opcode::CountDown),
            "R_TRIG" => Place::Trigger(Opcode::RisingEdge, self.temps.named_marker(false)),
            "F_TRIG" => Place::Trigger(Opcode::FallingEdge, self.temps.named_marker(false)),
            ty => match self.blocks.get(ty) {
                Some(&unit) => {
                    self.instances.push(Instance {
                        unit,
                        names: HashMap::new(),
                    });
                    Place::Instance(self.instances.len() - 1)
                }
                None => {
                    found.tell(Code::UnknownType, var.ty.span, [ty.into()]);
                    Place::Unknown
                }
            },
        }
    }

    fn initial(&mut self, place: Place, value: Option<i32>, span: Span) {
        if let Some(value) = value.filter(|&value| value != 0) {
            self.initials.push(Initial { place, value, span });
        }
    }

    pub(crate) fn told_none_left(&mut self, span: Span, found: &mut Found) {
        if let Some(words) = self.temps.none_left.take() {
            found.tell(Code::NoneLeft, span, [words.into()]);
        }
    }

    pub(crate) fn new_timer(
        &mut self,
        name: String,
        kind: Option<Opcode>,
        preset: Option<i32>,
    ) -> Place {
        self.timers.push(Timer {
            name,
            kind,
            preset,
            calls: 0,
            read: None,
        });
        Place::Timer(self.timers.len() - 1)
    }

    /// A counter; one that is named C 01 to C 16 is that one.
    fn new_counter(&mut self, name: String, kind: Option<Opcode>, preset: Option<i32>) -> Place {
        let own = name.strip_prefix('C').and_then(|n| n.parse::<u8>().ok());
        let own = own.filter(|n| (1..=COUNTERS).contains(n));
        let free = || (1..=COUNTERS).find(|n| self.counters_used >> (n - 1) & 1 == 0);
        let number = match own.or_else(free) {
            Some(number) => number,
            None => {
                self.temps.none_left = Some(("counter", "contador"));
                1
            }
        };
        self.counters_used |= 1 << (number - 1);
        self.counters.push(Counter {
            name,
            number,
            kind,
            preset,
        });
        Place::Counter(self.counters.len() - 1)
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

    fn address(&mut self, address: Address, name: &str, span: Span, found: &mut Found) -> Place {
        let within = |n: u32, first: u32, last: u8| {
            (first..=u32::from(last)).contains(&n).then_some(n as u8)
        };
        let board = self.board;
        let place = match address {
            Address::Input(n) => within(n, 1, board.inputs).map(|n| Place::Bit(Bit::Input(n))),
            Address::Output(n) => within(n, 1, board.outputs).map(|n| Place::Bit(Bit::Output(n))),
            Address::Marker(n) => within(n, 1, MARKERS).map(|n| Place::Bit(Bit::Marker(n))),
            Address::System(n) => within(n, 1, SYSTEM_MARKERS).map(|n| Place::Bit(Bit::System(n))),
            Address::Always => Some(Place::Always(true)),
            Address::Analogue(n) => {
                within(n, 0, ANALOGUE - 1).map(|n| Place::Number(Num::Analogue(n)))
            }
            Address::Pwm(n) => [1, 4]
                .contains(&n)
                .then_some(Place::Number(Num::Pwm(n as u8))),
            Address::Register(n) => {
                within(n, 1, REGISTERS).map(|n| Place::Number(Num::Register(n)))
            }
            Address::Group(n) => within(n, 1, 8).map(|n| Place::Number(Num::Group(n))),
            Address::Inputs => Some(Place::Number(Num::Inputs)),
            Address::Outputs => Some(Place::Number(Num::Outputs)),
            Address::Timer(key, member) => {
                let timer = match self.global.get(&key) {
                    Some(&place) => place,
                    None => {
                        let place = self.new_timer(key.clone(), None, None);
                        self.global.insert(key.clone(), place);
                        place
                    }
                };
                return match member {
                    Some(member) => self.member(timer, &key, &member, span, found),
                    None => timer,
                };
            }
            Address::Counter(key, member) => {
                let counter = match self.global.get(&key) {
                    Some(&place) => place,
                    None => {
                        let place = self.new_counter(key.clone(), None, None);
                        self.told_none_left(span, found);
                        self.global.insert(key.clone(), place);
                        place
                    }
                };
                return match member {
                    Some(member) => self.member(counter, &key, &member, span, found),
                    None => counter,
                };
            }
        };
        place.unwrap_or_else(|| {
            found.tell(Code::NoSuchPoint, span, [name.into(), ADDRESS_HELP.into()]);
            Place::Unknown
        })
    }

    /// What a block keeps under this name: `T1.Q`, `C2.CV`.
    pub(crate) fn member(
        &mut self,
        block: Place,
        name: &str,
        member: &str,
        span: Span,
        found: &mut Found,
    ) -> Place {
        let (place, has) = match block {
            Place::Timer(timer) => (
                match member {
                    "Q" => Some(Place::Bit(Bit::Timer(timer))),
                    "ET" | "V" => Some(Place::Number(Num::Elapsed(timer))),
                    "PT" | "P" => Some(Place::Number(Num::TimerPreset(timer))),
                    _ => None,
                },
                "Q, ET, PT",
            ),
            Place::Counter(counter) => {
                let Counter { number, kind, .. } = self.counters[counter];
                let down = kind == Some(Opcode::CountDown);
                (
                    match member {
                        "Q" if down => Some(Place::Bit(Bit::Zero(number))),
                        "Q" | "QU" | "D" => Some(Place::Bit(Bit::Reached(number))),
                        "QD" => Some(Place::Bit(Bit::Zero(number))),
                        "CV" | "V" => Some(Place::Number(Num::Count(number))),
                        "PV" | "P" => Some(Place::Number(Num::CountPreset(number))),
                        _ => None,
                    },
                    "Q, QU, QD, D, CV, PV",
                )
            }
            Place::Trigger(_, marker) if member == "Q" => {
                (Some(Place::Bit(Bit::Marker(marker))), "Q")
            }
            Place::Trigger(..) => (None, "Q"),
            Place::Instance(instance) => (
                self.instances[instance].names.get(member).copied(),
                "VAR_INPUT, VAR_OUTPUT",
            ),
            Place::Unknown => return Place::Unknown,
            _ => (None, ""),
        };
        place.unwrap_or_else(|| {
            let help = match has {
                "" => (
                    "only timers, counters and blocks have parts".to_owned(),
                    "só temporizadores, contadores e blocos têm partes".to_owned(),
                ),
                has => (format!("it has {has}"), format!("tem {has}")),
            };
            found.tell(
                Code::NoSuchMember,
                span,
                [name.into(), member.into(), help.into()],
            );
            Place::Unknown
        })
    }
}

const ADDRESS_HELP: (&str, &str) = (
    "points count from 1: I1 to I8, Q1 to Q4, M1 to M64, D1 to D32, IW0 to IW4, QW1 and QW4, C1 to C16",
    "os pontos contam a partir de 1: I1 a I8, Q1 a Q4, M1 a M64, D1 a D32, IW0 a IW4, QW1 e QW4, C1 a C16",
);
