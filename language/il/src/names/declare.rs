//! Declared variables, and the places that they get.

use super::meaning::{Counter, DeclaredInput, Instance, Names, Place, Timer};
use crate::ast::{Init, Section, UnitKind, Var, Word};
use crate::tree::{Bit, Num};
use std::collections::HashMap;
use unoclp_core::isa::Opcode;
use unoclp_point::{Address, read};
use unoclp_text::diagnostics::{Code, Found, Span};
use unoclp_tree::Base;

impl Names<'_> {
    /// Declares the variables of a unit; the names are those of one instance of it.
    pub(crate) fn declare(
        &mut self,
        vars: &[Var],
        kind: UnitKind,
        instance: usize,
        found: &mut Found,
    ) {
        for var in vars {
            if self.is_elsewhere(var, kind, instance, found) {
                continue;
            }
            let initials = self.initials;
            let place = self.declared(var, kind, instance, found);
            if var.retain && place != Place::Typed {
                self.retain(place, var, kind, initials, found);
            }
            let name = var.name.text.trim_start_matches('%').to_owned();
            if let Place::Bit(Bit::At(Address::Input(input))) = place {
                let (name, span) = (self.written(var.name.span), var.name.span);
                self.inputs.push(DeclaredInput { name, span, input });
            }
            // An address that is declared, such as %TM1, means the same in the whole file.
            let direct = read(&var.name.text, self.dialect.maker()).is_some();
            let shared = matches!(var.section, Section::Global | Section::External);
            let owner = (!direct && !shared).then_some(instance);
            self.note_width(owner, &name, &var.ty.text);
            let names = match direct || shared {
                true => &mut self.global,
                false => &mut self.instances[instance].names,
            };
            if names.insert(name, place).is_some() && !direct {
                let text = self.written(var.name.span);
                found.tell(Code::NameTwice, var.name.span, [text.into()]);
            }
        }
    }

    /// The result of a function, which has its name.
    pub(crate) fn result(&mut self, instance: usize, name: &Word, ty: &str, found: &mut Found) {
        let place = match ty {
            ty if Base::named(ty).is_none_or(|base| !base.is_plain()) => Place::Typed,
            "BOOL" => Place::Bit(Bit::At(Address::Marker(self.temps.named_marker(false)))),
            _ => Place::Number(Num::At(Address::Register(self.temps.named_register()))),
        };
        self.note_width(Some(instance), &name.text, ty);
        if let Some(instance) = self.instances.get_mut(instance) {
            instance.names.insert(name.text.clone(), place);
        }
        self.told_none_left(name.span, found);
    }

    fn declared(&mut self, var: &Var, kind: UnitKind, instance: usize, found: &mut Found) -> Place {
        if var.typed.is_some() {
            return Place::Typed;
        }
        let span = var.name.span;
        if let Some(at) = &var.at {
            let place = self.place(at, None, found);
            match place {
                Place::Timer(timer) => self.timers[timer].kind = timer_kind(&var.ty.text),
                Place::Counter(counter) => self.counters[counter].kind = counter_kind(&var.ty.text),
                _ => {}
            }
            self.first_value(place, var, &var.init, found);
            return place;
        }
        let place = match var.ty.text.as_str() {
            // It goes where bits of Structured Text go: into a register.
            "BOOL" if !self.temps.has_marker(var.retain) => return Place::Typed,
            "BOOL" => Place::Bit(Bit::At(Address::Marker(
                self.temps.named_marker(var.retain),
            ))),
            "INT" | "DINT" | "SINT" | "UINT" | "UDINT" | "USINT" | "WORD" | "DWORD" | "BYTE"
            | "TIME" => Place::Number(Num::At(Address::Register(self.temps.named_register()))),
            _ => return self.declared_block(var, kind, instance, found),
        };
        self.told_none_left(span, found);
        // What is new at each call gets its first value there.
        if !is_new(var, kind) {
            let given = self.instances[instance].inits.iter();
            let named = |init: &&Init| init.name.as_ref().is_some_and(|n| n.text == var.name.text);
            let given: Vec<Init> = given.filter(named).cloned().collect();
            let inits = if given.is_empty() { &var.init } else { &given };
            self.first_value(place, var, inits, found);
        }
        place
    }

    /// A timer, a counter, an edge, or an instance of a function block of the file.
    fn declared_block(
        &mut self,
        var: &Var,
        kind: UnitKind,
        instance: usize,
        found: &mut Found,
    ) -> Place {
        let name = self.written(var.name.span);
        let name = name.trim_start_matches('%').to_owned();
        let ty = var.ty.text.as_str();
        let place = match (timer_kind(ty), counter_kind(ty)) {
            (Some(kind), _) => self.new_timer(name.clone(), Some(kind), None),
            (_, Some(kind)) => self.new_counter(name.clone(), Some(kind), None),
            _ => match ty {
                "R_TRIG" => Place::Trigger(Opcode::RisingEdge, self.temps.named_marker(false)),
                "F_TRIG" => Place::Trigger(Opcode::FallingEdge, self.temps.named_marker(false)),
                "SR" | "RS" if !self.blocks.contains_key(ty) => {
                    Place::Latch(ty == "SR", self.temps.named_marker(var.retain))
                }
                ty => match self.blocks.get(ty) {
                    Some(&unit) => {
                        self.instances.push(Instance {
                            unit,
                            names: HashMap::new(),
                            within: Some(instance),
                            span: var.name.span,
                            inits: var.init.clone(),
                        });
                        Place::Instance(self.instances.len() - 1)
                    }
                    None => {
                        let written = self.written(var.ty.span);
                        found.tell(Code::UnknownType, var.ty.span, [written.into()]);
                        return Place::Unknown;
                    }
                },
            },
        };
        self.told_none_left(var.name.span, found);
        if is_new(var, kind) {
            found.tell(Code::Stateless, var.name.span, [name.into()]);
            return Place::Unknown;
        }
        self.first_value(place, var, &var.init, found);
        place
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
            called: None,
            read: None,
        });
        Place::Timer(self.timers.len() - 1)
    }

    /// A counter; one that is named as one of the board's, C 01, is that one.
    pub(super) fn new_counter(
        &mut self,
        name: String,
        kind: Option<Opcode>,
        preset: Option<i32>,
    ) -> Place {
        let own = name.strip_prefix(['C', 'c']);
        let own = own.and_then(|n| n.parse::<u8>().ok());
        let all = 1..=self.board.counters;
        let own = own.filter(|n| all.contains(n));
        let free = || all.clone().find(|n| self.counters_used >> (n - 1) & 1 == 0);
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

    /// The index of a new instance of this unit, which stands in no other.
    pub(crate) fn new_instance(&mut self, unit: usize, span: Span) -> usize {
        self.instances.push(Instance {
            unit,
            names: HashMap::new(),
            within: None,
            span,
            inits: Vec::new(),
        });
        self.instances.len() - 1
    }
}

/// The block that has one of the standard's longer names: of `CTU_DINT`, CTU.
pub(crate) fn plain_block(ty: &str) -> &str {
    match ty.rsplit_once('_') {
        Some((plain, "INT" | "DINT")) if plain.starts_with("CT") => plain,
        Some((plain, "TIME")) => plain,
        _ => ty,
    }
}

fn timer_kind(ty: &str) -> Option<Opcode> {
    Some(match plain_block(ty) {
        "TON" => Opcode::OnDelay,
        "TOF" => Opcode::OffDelay,
        "TP" => Opcode::Pulse,
        "TONR" | "TOR" => Opcode::RetentiveOnDelay,
        _ => return None,
    })
}

fn counter_kind(ty: &str) -> Option<Opcode> {
    Some(match plain_block(ty) {
        "CTU" | "CTUD" => Opcode::CountUp,
        "CTD" => Opcode::CountDown,
        _ => return None,
    })
}

/// Whether a variable is new at each call: all of a function, VAR_TEMP of the others.
pub(crate) fn is_new(var: &Var, kind: UnitKind) -> bool {
    let own = !matches!(
        var.section,
        Section::InOut | Section::Global | Section::External
    );
    own && var.at.is_none() && (kind == UnitKind::Function || var.section == Section::Temp)
}
