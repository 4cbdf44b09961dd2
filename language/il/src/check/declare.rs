//! Units and variables: what `names` makes of their declarations, and the same in the tree.

use super::edges::declare_edge;
use super::first;
use super::front::{Front, MOST_WITHIN, Stage};
use super::used::parts;
use crate::ast::{Operand, Section as Part, Stmt, Unit, UnitKind as Kind, Var, Word};
use crate::names::declare::{is_new, plain_block};
use crate::names::{Instance, Place};
use crate::operators::Op;
use crate::tree::{Bit, Num};
use unoclp_core::isa::Opcode;
use unoclp_point::{Address, Kind as Point, read};
use unoclp_st::Of;
use unoclp_st::pieces::Declared;
use unoclp_text::diagnostics::{Code, Span};
use unoclp_tree::build::{Enter, Named, Section, Traits};
use unoclp_tree::{Base, Kind as Type, Root, Standard, TypeId, UnitKind};

/// More instances than this no board holds.
const MOST_INSTANCES: usize = 4_000;

impl Front<'_, '_> {
    /// Gives all names their meaning.
    pub(super) fn declare_all(&mut self) {
        self.meanings();
        self.rows();
        for (index, unit) in self.units.iter().enumerate() {
            let (name, at) = self.unit_name(index);
            let kind = match unit.kind {
                Kind::Program => UnitKind::Program,
                Kind::Function => UnitKind::Function,
                Kind::FunctionBlock => UnitKind::Block,
            };
            let made = self.c.builder.unit(&name, kind, at);
            self.numbers.push(made.number());
            self.stages.push(Stage::Not(made));
            self.edge_inputs.push(Vec::new());
        }
        for (index, unit) in self.units.iter().enumerate() {
            for var in unit.vars.iter().filter(|var| var.section == Part::Global) {
                let key = var.name.text.trim_start_matches('%');
                if self.c.builder.find(key).is_none() {
                    self.variable(var, index);
                }
            }
        }
        // What is only mentioned is declared where it is mentioned first.
        for (index, unit) in self.units.iter().enumerate() {
            for var in unit.vars.iter().filter(|var| var.section == Part::External) {
                let key = var.name.text.trim_start_matches('%');
                if self.c.builder.find(key).is_none() {
                    self.variable(var, index);
                }
            }
        }
        for index in 0..self.units.len() {
            self.unit(index);
        }
        self.c.make_types();
        self.undeclared_blocks();
    }

    /// Variables of a type that Structured Text knows, all of one declaration.
    fn typed_variable(&mut self, var: &Var, declared: &Declared) {
        let is_first = declared
            .names()
            .next()
            .is_some_and(|(_, at)| at == var.name.span);
        if !is_first
            || declared
                .names()
                .any(|(name, _)| self.c.builder.is_taken(name))
        {
            return;
        }
        self.blocks_of(&declared.types(), 0);
        let global = matches!(var.section, Part::Global | Part::External);
        let before = global.then(|| self.c.builder.outside());
        let of = Of {
            section: section(var.section),
            constant: var.constant,
            retain: var.retain,
        };
        self.c.declare_piece(declared, &of);
        if let Some(before) = before {
            self.c.builder.back(before);
        }
    }

    /// Declares the blocks of the text among these types, and in them.
    fn blocks_of(&mut self, types: &[&str], deep: usize) {
        if deep > MOST_WITHIN {
            return;
        }
        for name in types {
            if let Some(index) = self.block_named(&name.to_uppercase()) {
                self.within += 1;
                self.unit(index);
                self.within -= 1;
            }
            let made_of = self.pieces.types.made_of(name);
            self.blocks_of(&made_of, deep + 1);
        }
    }

    /// The declarations as `names` has them, which tells what is wrong with them.
    fn meanings(&mut self) {
        for (index, unit) in self.units.iter().enumerate() {
            if let (Kind::Function, Some(name)) = (unit.kind, &unit.name) {
                self.functions.insert(name.text.clone(), index);
            }
        }
        self.instances = vec![0; self.units.len()];
        self.instance(0, Span::default());
        for index in 1..self.units.len() {
            let unit = &self.units[index];
            let made = self.names.instances.iter();
            let first = made.enumerate().find(|(_, one)| one.unit == index);
            self.instances[index] = match first {
                Some((instance, _)) => instance,
                None => {
                    // What nothing calls takes nothing of the board.
                    let temps = self.names.temps;
                    let instance = self.instance(index, unit.span);
                    self.names.temps = temps;
                    instance
                }
            };
        }
    }

    /// A new instance of a unit; its declarations may make more.
    fn instance(&mut self, unit: usize, span: Span) -> usize {
        let instance = self.names.new_instance(unit, span);
        let mut next = instance;
        while let Some(Instance { unit, span, .. }) = self.names.instances.get(next) {
            let (unit, span) = (*unit, *span);
            let (in_itself, depth) = self.nesting(next);
            if in_itself {
                let (name, _) = self.unit_name(unit);
                self.tell(Code::Recursive, span, [name.into()]);
            } else if depth > MOST_WITHIN || self.names.instances.len() > MOST_INSTANCES {
                self.tell(Code::CallsTooDeep, span, []);
                self.names.instances.truncate(next + 1);
            } else {
                let Unit { vars, kind, .. } = &self.units[unit];
                let found = &mut *self.c.builder.found;
                self.names.declare(vars, *kind, next, found);
                self.result(unit, next);
            }
            next += 1;
        }
        instance
    }

    /// The result of a function has the function's name.
    fn result(&mut self, unit: usize, instance: usize) {
        let unit = &self.units[unit];
        let (Kind::Function, Some(name)) = (unit.kind, &unit.name) else {
            return;
        };
        let ty = unit.result.as_ref().map_or("BOOL", |ty| ty.text.as_str());
        let found = &mut *self.c.builder.found;
        self.names.result(instance, name, ty, found);
    }

    /// Whether an instance stands in one of its own unit, and how deep it stands.
    fn nesting(&self, instance: usize) -> (bool, usize) {
        let instances = &self.names.instances;
        let mut depth = 0;
        let mut within = instances[instance].within;
        while let Some(outer) = within {
            if instances[outer].unit == instances[instance].unit {
                return (true, depth);
            }
            depth += 1;
            within = instances[outer].within;
        }
        (false, depth)
    }

    pub(super) fn unit_name(&self, unit: usize) -> (String, Span) {
        let unit = &self.units[unit];
        match &unit.name {
            Some(name) => (self.names.written(name.span), name.span),
            None => ("PROGRAM".to_owned(), unit.span),
        }
    }

    /// The variables of a unit.
    fn unit(&mut self, index: usize) {
        let made = match std::mem::replace(&mut self.stages[index], Stage::Begun) {
            Stage::Not(made) => made,
            stage => {
                self.stages[index] = stage;
                return;
            }
        };
        let unit = &self.units[index];
        let before = self.c.builder.enter(&made);
        if let (Kind::Function, Some(name)) = (unit.kind, &unit.name) {
            let result = unit.result.as_ref().map(|ty| ty.text.as_str());
            let base = result.map_or(Some(Base::Bool), Base::named);
            let ty = match (base, &unit.result) {
                (Some(base), _) => Some(TypeId::of(base)),
                (None, Some(ty)) => {
                    let written = self.names.written(ty.span);
                    self.c.type_by_name(&written, ty.span)
                }
                (None, None) => None,
            };
            match ty {
                Some(ty) => self.c.builder.result(ty, name.span),
                None => self.c.builder.hide(&name.text),
            }
            self.c.builder.gives();
        }
        let own = |var: &&Var| !matches!(var.section, Part::Global | Part::External);
        for var in unit.vars.iter().filter(own) {
            self.variable(var, index);
        }
        self.edge_inputs(index);
        if unit.kind != Kind::Function {
            self.edges(index);
        }
        self.stages[index] = Stage::Done(self.c.builder.close(made));
        self.c.builder.back(before);
    }

    /// What sees the edges of the inputs that are declared as such.
    fn edge_inputs(&mut self, index: usize) {
        for var in &self.units[index].vars {
            let Some(edge) = var.edge else { continue };
            let Word { text, span } = &var.name;
            let made = self.c.builder.edge_input(text, edge, *span);
            self.edge_inputs[index].extend(made);
        }
    }

    /// What `names` makes of a variable.
    fn meaning(&self, var: &Var, unit: usize) -> Option<Place> {
        let name = var.name.text.trim_start_matches('%');
        let instance = self.names.instances.get(self.instances[unit])?;
        let local = instance.names.get(name);
        local.copied().or_else(|| self.names.shared(name))
    }

    fn variable(&mut self, var: &Var, unit: usize) {
        if let Some(declared) = var.typed.and_then(|number| self.pieces.declared(number)) {
            return self.typed_variable(var, declared);
        }
        let written = self.names.written(var.name.span);
        let name = written.trim_start_matches('%').to_owned();
        let meaning = self.meaning(var, unit);
        let point = match (&var.at, meaning) {
            (None, _) => None,
            (Some(_), Some(Place::Bit(Bit::At(point)) | Place::Number(Num::At(point)))) => {
                Some(point)
            }
            (Some(at), Some(Place::Timer(_) | Place::Counter(_))) => {
                return self.block_at(var, at, &name);
            }
            // What is wrong has been told.
            _ => return,
        };
        let base = Base::named(&var.ty.text);
        let ty = match point {
            Some(point) if point.is_bit() => Some(TypeId::BOOL),
            Some(_) => {
                let plain = |base: &Base| base.is_int() || base.is_bits() || *base == Base::Time;
                Some(TypeId::of(base.filter(plain).unwrap_or(Base::Dint)))
            }
            None => base.map(TypeId::of).or_else(|| self.block(var, unit)),
        };
        let Some(ty) = ty else {
            if !self.c.builder.found.has_errors() {
                let words = [name.as_str().into(), "".into()];
                self.tell(Code::StUnsupported, var.ty.span, words);
            }
            return self.c.builder.hide(&name);
        };
        let is_block = !self.c.builder.tree.types.is_scalar(ty);
        let is_new = is_new(var, self.units[unit].kind);
        if is_block && is_new {
            // It has been told.
            return self.c.builder.hide(&name);
        }
        let initial = self.initial(var, ty, point);
        // Another program may have left what is kept by itself 1.
        let is_left = ty == TypeId::BOOL || matches!(point, Some(Address::Group(_)));
        let is_begun = var.retain && is_left && initial.is_some();
        let traits = Traits {
            initial,
            retain: var.retain,
            constant: var.constant
                && point.is_none()
                && base.is_some()
                && !self.names.is_stored(&var.name.text),
            point,
            ..Traits::default()
        };
        let section = section(var.section);
        // Timers and counters by the board's names, and addresses, mean the same in the whole text.
        let shared = read(&var.name.text, self.names.dialect.maker()).is_some();
        let global = shared && self.c.builder.find(&name).is_none() || section == Section::Global;
        let before = global.then(|| self.c.builder.outside());
        let taken = self.c.builder.is_taken(&name);
        let at = var.name.span;
        let made = match taken {
            true => None,
            false => self.c.builder.declare(&name, at, ty, section, traits),
        };
        match made {
            Some(made) if made.root == Root::Static => {
                self.pin(&name, ty, made.offset);
                if is_begun {
                    self.c.builder.tree.begun.push(made.offset);
                }
            }
            Some(_) => {}
            None => self.c.builder.hide(&name),
        }
        if let Some(before) = before {
            self.c.builder.back(before);
        }
    }

    /// A timer or counter of the board by another name.
    fn block_at(&mut self, var: &Var, at: &Operand, name: &str) {
        let written = at.name().unwrap_or_default();
        let (key, _) = parts(written, self.names.dialect);
        self.aliases.insert(name.to_uppercase(), key.to_string());
        if self.c.builder.find(&key).is_some() {
            return;
        }
        let Some(block) = self.standard(&var.ty.text, &key) else {
            return;
        };
        let ty = self.type_of(block);
        let traits = Traits {
            initial: self.initial(var, ty, None),
            retain: var.retain,
            ..Traits::default()
        };
        let before = self.c.builder.outside();
        let span = var.name.span;
        let made = self
            .c
            .builder
            .declare(&key, span, ty, Section::Global, traits);
        if let Some(made) = made {
            self.c.builder.show_as(name);
            self.pin(&key, ty, made.offset);
        }
        self.c.builder.back(before);
    }

    /// A counter with the name of one of the board's is that one.
    fn pin(&mut self, name: &str, ty: TypeId, offset: u32) {
        let Type::Standard(block) = *self.c.builder.tree.types.kind(ty) else {
            return;
        };
        let own = name.strip_prefix(['C', 'c']);
        let own = own.and_then(|n| n.parse::<u8>().ok());
        let board = self.names.board;
        let own = own.filter(|n| (1..=board.counters).contains(n));
        if let (Some(own), Some(number)) = (own, block.number()) {
            let points = &mut self.c.builder.tree.points;
            points.push((offset + number, Address::Count(own)));
        }
    }

    /// The type of a block: of the standard, or of the text, which is declared first.
    fn block(&mut self, var: &Var, unit: usize) -> Option<TypeId> {
        let key = var.name.text.trim_start_matches('%');
        if let Some(standard) = self.standard(&var.ty.text, key) {
            return Some(self.type_of(standard));
        }
        let index = self.block_named(&var.ty.text)?;
        if index == unit || self.within > MOST_WITHIN {
            return None;
        }
        self.within += 1;
        self.unit(index);
        self.within -= 1;
        match &self.stages[index] {
            Stage::Done(made) => self.c.builder.block_type(made),
            Stage::Not(_) | Stage::Begun => None,
        }
    }

    pub(super) fn type_of(&mut self, standard: Standard) -> TypeId {
        let types = &mut self.c.builder.tree.types;
        types.add_kind(Type::Standard(standard), standard.cells())
    }

    /// The block of the standard that a timer or counter of this type and name is, by what the text does with it.
    pub(super) fn standard(&self, ty: &str, name: &str) -> Option<Standard> {
        let uses = self.used.get(name);
        let ty = plain_block(ty);
        Some(match ty {
            "TON" | "TOF" | "TP" | "TONR" | "TOR" => match (uses.timer, ty) {
                (Some(Opcode::OnDelay), _) => Standard::Ton,
                (Some(Opcode::OffDelay), _) => Standard::Tof,
                (Some(Opcode::Pulse), _) => Standard::Tp,
                (Some(_), _) | (None, "TONR" | "TOR") => Standard::Tonr,
                (None, ty) => Standard::named(ty)?,
            },
            "CTU" | "CTD" | "CTUD" => Standard::Counter,
            "R_TRIG" => Standard::RTrig,
            "F_TRIG" => Standard::FTrig,
            "SR" | "RS" if !self.is_own_block(ty) => Standard::named(ty)?,
            _ => return None,
        })
    }

    fn is_own_block(&self, name: &str) -> bool {
        matches!(self.c.builder.find(name), Some(Named::Type(_)))
    }

    /// Timers and counters that the text names and declares nowhere.
    fn undeclared_blocks(&mut self) {
        for name in self.used.names() {
            let kind = read(&name, self.names.dialect.maker()).map(|written| written.kind);
            let ty = match kind {
                Some(Point::Timer) => "TON",
                Some(Point::Counter) => "CTU",
                _ => continue,
            };
            if self.c.builder.find(&name).is_some() {
                continue;
            }
            let Some(standard) = self.standard(ty, &name) else {
                continue;
            };
            let ty = self.type_of(standard);
            let at = self.units.first().map_or(Span::default(), |unit| unit.span);
            let mut traits = Traits::default();
            if let (true, Some(preset)) = (standard.is_counter(), self.used.get(&name).preset()) {
                traits.initial = first::preset(standard, preset);
            }
            let at = at.empty();
            let made = self
                .c
                .builder
                .declare(&name, at, ty, Section::Global, traits);
            if let Some(made) = made {
                self.pin(&name, ty, made.offset);
            }
        }
    }

    /// The instances that edges without one of their own need, before the unit's declarations are closed.
    fn edges(&mut self, index: usize) {
        let body = &self.units[index].body;
        for stmt in body {
            let Stmt::Instr(instr) = stmt else { continue };
            let edge = match instr.op {
                Op::Edge(edge) | Op::Differentiate(edge) => Some(edge),
                _ => instr.edge,
            };
            if let Some(edge) = edge
                && !declare_edge(&mut self.c.builder, edge, instr.span)
            {
                return;
            }
        }
    }
}

/// The same of the tree.
fn section(of: Part) -> Section {
    match of {
        Part::Local => Section::Var,
        Part::Temp => Section::Temp,
        Part::Input => Section::Input,
        Part::Output => Section::Output,
        Part::InOut => Section::InOut,
        Part::Global | Part::External => Section::Global,
    }
}
