//! What the names of a text mean: declared variables, addresses, and names that nothing declares.

pub(crate) mod declare;
mod first;
mod inputs;
mod meaning;
pub(crate) mod near;
mod points;
mod retain;
mod shared;
mod widths;

use crate::ast::{Operand, OperandKind, Param, Section, Stmt, Unit, UnitKind};
use crate::operators::Op;
use crate::temps::Temps;
use crate::tree::{Bit, Num};
use std::collections::{HashMap, HashSet};
use unoclp_core::Board;
use unoclp_core::isa::{Kind, MARKER_OPERAND, REGISTERS, Row, TABLE};
use unoclp_point::{Address, Kind as Point, read};
use unoclp_text::Dialect;
use unoclp_text::diagnostics::{Code, Found, Span, Word as Said};
use unoclp_text::literal;
use unoclp_text::points::{Spellings, exists};

pub(crate) use meaning::{Instance, Names, Place};
use meaning::{Retained, Widths};
pub(crate) use widths::{kept, narrow_type};

const LAST_REGISTER: u32 = REGISTERS as u32;

impl<'t> Names<'t> {
    /// Looks through the whole text, so that no name gets what an address of the text means.
    pub(crate) fn new(text: &'t str, dialect: Dialect, board: Board, units: &[Unit]) -> Names<'t> {
        let mut names = Names {
            text,
            dialect,
            board,
            timers: Vec::new(),
            counters: Vec::new(),
            instances: Vec::new(),
            inputs: Vec::new(),
            initials: 0,
            retained: Retained::default(),
            temps: Temps::new(board),
            global: HashMap::new(),
            globals: HashSet::new(),
            blocks: HashMap::new(),
            inputs_of: HashSet::new(),
            block_inputs: HashMap::new(),
            counters_used: 0,
            inputs_read: 0,
            points: Spellings::default(),
            widths: Widths::default(),
            near: near::Near::default(),
        };
        for (index, unit) in units.iter().enumerate() {
            if let Some(name) = &unit.name {
                if unit.kind == UnitKind::FunctionBlock {
                    names.blocks.insert(name.text.clone(), index);
                }
                let written = names.written(name.span);
                names.near.declare(written);
            }
            for var in &unit.vars {
                var.at.iter().for_each(|at| names.note(at));
                names.note_name(&var.name.text);
                if var.section == Section::Global {
                    names.globals.insert(var.name.text.clone());
                }
                if var.section == Section::Input {
                    names.inputs_of.insert((index, var.name.text.clone()));
                }
                let written = names.written(var.name.span);
                names.near.declare(written);
            }
            for stmt in &unit.body {
                if let Stmt::Instr(instr) = stmt {
                    names.near.note_stores(instr);
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

    /// What stands here in the text, without blanks.
    pub(crate) fn written(&self, span: Span) -> String {
        let text = self.text.get(span.range()).unwrap_or_default();
        text.split_whitespace().collect()
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
            let marker = codes.get(2).map(|target| target - MARKER_OPERAND);
            if let Some(n) = marker.filter(|n| (1..=self.board.markers.into()).contains(n)) {
                self.temps.markers |= 1 << (n - 1);
            }
            return;
        };
        let n = (code - row.code).unsigned_abs();
        let exists = self
            .board
            .numbers(row.kind)
            .is_some_and(|(first, last)| (u32::from(first)..=u32::from(last)).contains(&n));
        // A register 00 is a constant.
        if !exists || n == 0 {
            return;
        }
        match row.kind {
            Kind::Marker => self.temps.markers |= 1 << (n - 1),
            Kind::Group => self.temps.markers |= 0xFF << (8 * (n - 1)),
            Kind::Counter | Kind::Count => self.counters_used |= 1 << (n - 1),
            Kind::Table => {
                let length = codes.get(1).map_or(1, |&length| length.clamp(1, 98) as u32);
                for register in n..(n + length).min(LAST_REGISTER + 1) {
                    self.temps.registers |= 1 << (register - 1);
                }
            }
            // The one after the last is what was pushed.
            Kind::Value | Kind::Real if n > LAST_REGISTER => {}
            Kind::Register | Kind::Value | Kind::Real | Kind::Drum => {
                self.temps.registers |= 1 << (n - 1);
            }
            // A block may go on to the last.
            Kind::Move => self.temps.registers = u128::MAX,
            // The compiler gives none of these out.
            Kind::Input | Kind::Output | Kind::Branch | Kind::System | Kind::TimerQ => {}
            Kind::Analogue | Kind::Pwm | Kind::Reading | Kind::Bit | Kind::Time => {}
            Kind::Label | Kind::Jump | Kind::Filter => {}
            Kind::None | Kind::Timer | Kind::Scale => {}
        }
    }

    fn note_name(&mut self, name: &str) {
        let address = read(name, self.dialect.maker()).and_then(|written| written.address);
        let Some(address) = address.filter(|address| exists(*address, self.board)) else {
            return;
        };
        match (address.kind(), address.number()) {
            (Point::Marker, n) => self.temps.markers |= 1 << (n - 1),
            (Point::Group, n) => self.temps.markers |= 0xFF << (8 * (n - 1)),
            (Point::Register, n) => self.temps.registers |= 1 << (n - 1),
            (Point::Counter, n) if (1..=self.board.counters).contains(&n) => {
                self.counters_used |= 1 << (n - 1)
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
            OperandKind::Piece(_) => return Place::Typed,
            OperandKind::Bool(state) => return Place::Always(*state),
            _ => {
                let number = operand.number().map(Num::Const);
                return number.map_or(Place::Unknown, Place::Number);
            }
        };
        let span = operand.span;
        if let Some(place) = self.declared_place(name, span, instance, found) {
            return place;
        }
        let Some(point) = read(name, self.dialect.maker()) else {
            let written = self.written(span);
            if literal::is_fraction(name) {
                found.tell(Code::Fraction, span, [written.into()]);
                return Place::Unknown;
            }
            if name.contains(['%', '.']) {
                self.told_no_point(span, found);
                return Place::Unknown;
            }
            let marker = self.temps.named_marker(false);
            let help = self.near.declaration(&written);
            let words = [written.into(), format!("M{marker}").into(), help];
            found.tell(Code::Undeclared, span, words);
            self.told_none_left(span, found);
            let place = Place::Bit(Bit::At(Address::Marker(marker)));
            self.global.insert(name.clone(), place);
            return place;
        };
        self.point(&point, span, found)
    }

    /// Whether this is a point of the board, as this maker writes them.
    pub(crate) fn is_point(&self, name: &str) -> bool {
        let written = read(name, self.dialect.maker());
        written.is_some_and(|written| written.address.is_some())
    }

    /// Whether a name is declared, or an address.
    pub(crate) fn knows(&self, name: &str, instance: Option<usize>) -> bool {
        let local = instance.is_some_and(|at| self.instances[at].names.contains_key(name));
        local || self.global.contains_key(name) || read(name, self.dialect.maker()).is_some()
    }

    /// What a name of the whole file means.
    pub(crate) fn shared(&self, name: &str) -> Option<Place> {
        self.global.get(name).copied()
    }

    /// Whether the text stores to this name, in upper case.
    pub(crate) fn is_stored(&self, name: &str) -> bool {
        self.near.is_stored(name)
    }

    /// What to do about a name that cannot be called.
    pub(crate) fn callable_help(&mut self, written: &str) -> Said {
        self.near.callable(written)
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
