//! Declared variables, and the places that they get.

use super::{Counter, DeclaredInput, Initial, Instance, Names, Place, Timer};
use crate::address::parse;
use crate::ast::{Operand, Section, Var};
use crate::diagnostics::{Code, Found, Span};
use crate::tree::{Bit, Num};
use std::collections::HashMap;
use unoclp_core::isa::{COUNTERS, Opcode};

impl Names {
    /// Declares the variables of a unit; the names are those of one instance of it.
    pub(crate) fn declare(&mut self, vars: &[Var], instance: usize, found: &mut Found) {
        for var in vars {
            let initials = self.initials.len();
            let place = self.declared(var, found);
            if var.section == Section::Retain {
                self.retain(place, var, initials, found);
            }
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
    pub(super) fn new_counter(
        &mut self,
        name: String,
        kind: Option<Opcode>,
        preset: Option<i32>,
    ) -> Place {
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
}
