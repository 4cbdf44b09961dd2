//! Functions and function blocks of the text's own. A call compiles the body in its place.

use super::{Acc, Lower, MOST_CALLS, MOST_SCOPES, MOST_STEPS};
use crate::ast::{Param, Section, Unit, UnitKind, Var};
use crate::diagnostics::{Code, Span};
use crate::names::{Instance, Place};
use crate::rung::{Rungs, Written};
use crate::tree::{Bit, Num, Number};
use crate::typed::Base;
use std::collections::{HashMap, HashSet};
use unoclp_core::Target;
use unoclp_core::isa::Opcode;
use unoclp_point::Address;

/// More instances than this no board holds; blocks that contain several others would make them without end.
const MOST_INSTANCES: usize = 4_000;
/// So many names a message lists at most.
const MOST_NAMES: usize = 40;

impl Lower<'_, '_> {
    /// Gives the variables of the program their places, and those of its blocks. A function gets its own
    /// where it is called.
    pub(super) fn declare_all(&mut self) {
        for (index, unit) in self.units.iter().enumerate() {
            if let (UnitKind::Function, Some(name)) = (unit.kind, &unit.name) {
                self.functions.insert(name.text.clone(), index);
            }
        }
        self.declare(0, Span::default());
        self.again.reserve(&mut self.names);
        self.rungs.temps = self.names.temps;
    }

    /// A new instance of a unit. Declaring its variables may make more.
    fn declare(&mut self, unit: usize, span: Span) -> usize {
        let instance = self.names.new_instance(unit, span);
        let mut next = instance;
        while let Some(Instance { unit, span, .. }) = self.names.instances.get(next) {
            let (unit, span) = (*unit, *span);
            match self.nesting(next) {
                Nesting::Good => {
                    let Unit { vars, kind, .. } = &self.units[unit];
                    self.names.declare(vars, *kind, next, self.found);
                    self.declare_result(unit, next);
                }
                Nesting::InItself => {
                    let (name, _) = self.unit_name(unit);
                    self.found.tell(Code::Recursive, span, [name.into()]);
                }
                Nesting::TooDeep => {
                    self.found.tell(Code::CallsTooDeep, span, []);
                    self.names.instances.truncate(next + 1);
                }
            }
            next += 1;
        }
        instance
    }

    /// How an instance stands in others.
    fn nesting(&self, instance: usize) -> Nesting {
        let instances = &self.names.instances;
        let mut depth = 0;
        let mut within = instances[instance].within;
        while let Some(outer) = within {
            if instances[outer].unit == instances[instance].unit {
                return Nesting::InItself;
            }
            depth += 1;
            within = instances[outer].within;
        }
        match depth > MOST_SCOPES || instances.len() > MOST_INSTANCES {
            true => Nesting::TooDeep,
            false => Nesting::Good,
        }
    }

    /// The places of a function's variables.
    pub(super) fn function_instance(&mut self, unit: usize) -> usize {
        if let Some(&instance) = self.function_instances.get(&unit) {
            return instance;
        }
        // Names get markers that no intermediate result has had.
        self.names.temps = self.rungs.temps;
        let instance = self.declare(unit, self.units[unit].span);
        self.rungs.temps = self.names.temps;
        self.function_instances.insert(unit, instance);
        instance
    }

    /// The result of a function has the function's name.
    fn declare_result(&mut self, unit: usize, instance: usize) {
        let unit = &self.units[unit];
        let (UnitKind::Function, Some(name)) = (unit.kind, &unit.name) else {
            return;
        };
        let place = match unit.result.as_ref().map(|ty| ty.text.as_str()) {
            None | Some("BOOL") => Place::Bit(Bit::At(Address::Marker(
                self.names.temps.named_marker(false),
            ))),
            Some(_) => Place::Number(Num::At(Address::Register(
                self.names.temps.named_register(),
            ))),
        };
        let ty = unit.result.as_ref().map_or("", |ty| ty.text.as_str());
        self.names
            .note_width(Some(instance), &name.text, (ty, place), true);
        self.names.instances[instance]
            .names
            .insert(name.text.clone(), place);
        self.names.told_none_left(name.span, self.found);
    }

    fn unit_name(&self, unit: usize) -> (String, Span) {
        let unit = &self.units[unit];
        match &unit.name {
            Some(name) => (self.names.written(name.span), name.span),
            None => ("PROGRAM".to_owned(), unit.span),
        }
    }

    pub(super) fn call_unit(&mut self, unit: usize, instance: usize, params: &[Param], span: Span) {
        self.call_inputs(unit, instance, params, 0, span);
    }

    /// Copies the inputs but those that have been, renews what is new at each call, and compiles the body in
    /// place.
    pub(super) fn call_inputs(
        &mut self,
        unit: usize,
        instance: usize,
        params: &[Param],
        done: usize,
        span: Span,
    ) {
        let (name, _) = self.unit_name(unit);
        self.called.insert(unit);
        if self.scopes.iter().any(|scope| scope.unit == unit) {
            self.found.tell(Code::Recursive, span, [name.into()]);
            self.acc = Acc::Unknown;
            return;
        }
        self.calls += 1;
        if self.scopes.len() > MOST_SCOPES || self.calls > MOST_CALLS {
            if self.calls <= MOST_CALLS + 1 {
                self.found.tell(Code::CallsTooDeep, span, []);
            }
            self.acc = Acc::Unknown;
            return;
        }
        let vars = &self.units[unit].vars;
        let inputs: Vec<&str> = vars
            .iter()
            .filter(|var| is_input(var))
            .map(|var| var.name.text.as_str())
            .collect();
        let known: HashSet<&str> = inputs.iter().copied().collect();
        let in_outs = vars.iter().filter(|var| var.section == Section::InOut);
        let in_outs: HashMap<&str, &Var> = in_outs
            .rev()
            .map(|var| (var.name.text.as_str(), var))
            .collect();
        let mut given: HashSet<String> = inputs.iter().take(done).map(|&i| i.to_owned()).collect();
        for (index, param) in params.iter().enumerate().filter(|(_, param)| !param.out) {
            let named = param.name.as_ref().map(|name| name.text.as_str());
            let input = named.or_else(|| inputs.get(index + done).copied());
            let Some(input) = input.filter(|input| known.contains(input)) else {
                let names = few(&inputs);
                let has = (format!("it has {names}"), format!("tem {names}"));
                let (text, span) = match &param.name {
                    Some(word) => (self.names.written(word.span), word.span),
                    None => (self.spelled(&param.value), param.value.span),
                };
                self.found.tell(
                    Code::NoSuchParameter,
                    span,
                    [name.as_str().into(), text.into(), has.into()],
                );
                continue;
            };
            given.insert(input.to_owned());
            if let Some(var) = in_outs.get(input) {
                self.bind(instance, var, param);
                continue;
            }
            let place = self.names.instances[instance].names.get(input).copied();
            let mut acc = self.value(&param.value);
            if param.negated
                && let Some(expr) = self.param_bit(param)
            {
                acc = Acc::Bit(expr);
            }
            let width = self.names.width_of(instance, input);
            let place = place.unwrap_or(Place::Unknown);
            self.assign(acc, place, width, param.value.span);
        }
        self.unbound(unit, instance, &given, span);
        self.freeze(span);
        self.renew(unit, instance, &given, span);
        let end = self.new_label(span, None);
        let before = self.rungs.steps.len();
        self.unit_body(unit, instance, Some(end), Some(span));
        let wanted =
            |written: &Written| matches!(written, Written::Jump(_, label) if *label == end);
        if self.rungs.steps[before..]
            .iter()
            .any(|step| wanted(&step.written))
        {
            self.place_label(end, span);
        }
        for param in params.iter().filter(|param| param.out) {
            let output = param.name.as_ref().map_or("", |name| name.text.as_str());
            let place = self.names.instances[instance].names.get(output).copied();
            let Some(place) = place else {
                self.no_parameter(&name, param, ("see its VAR_OUTPUT", "veja seu VAR_OUTPUT"));
                continue;
            };
            let acc = self.held(place, span);
            self.store_to(acc, &param.value, param.negated, param.value.span);
        }
        let result = self.units[unit].name.as_ref();
        let result = result.and_then(|name| self.names.instances[instance].names.get(&name.text));
        let result = result.copied();
        self.acc = match (self.kind_of(unit), result) {
            (UnitKind::Function, Some(place)) => self.held(place, span),
            _ => Acc::Empty,
        };
    }

    fn held(&self, place: Place, span: Span) -> Acc {
        match place {
            Place::Bit(bit) => super::timers::lit(bit, span),
            Place::Number(num) => Acc::Number(Number::Leaf(num, span)),
            _ => Acc::Unknown,
        }
    }

    /// Stores a value in a variable of a unit.
    pub(super) fn assign(&mut self, acc: Acc, place: Place, to: Option<Base>, span: Span) {
        match place {
            Place::Bit(Bit::At(Address::Marker(n))) => {
                if let Some(expr) = self.as_bit(acc, "VAR_INPUT", span) {
                    self.bring(expr, span);
                    self.rungs.coil(Target::Marker(n), false, span);
                }
            }
            Place::Number(Num::At(Address::Register(n))) => {
                if let Some(number) = self.as_number(acc, "VAR_INPUT", span) {
                    let number = self.narrowed(number, to, span);
                    self.freeze(span);
                    self.rungs.fresh(span);
                    self.rungs.number(&number);
                    self.write(Opcode::Store, n, span);
                }
            }
            _ => {}
        }
        self.acc = Acc::Empty;
    }

    /// What nothing calls is checked all the same, and not kept.
    pub(super) fn check_uncalled(&mut self) {
        let (temps, writes) = (self.names.temps, self.writes);
        let mut steps = self.rungs.steps.len();
        for unit in 1..self.units.len() {
            if self.called.contains(&unit) || steps > MOST_STEPS {
                continue;
            }
            let kept = std::mem::replace(&mut self.rungs, Rungs::new(temps));
            let labels = self.labels.len();
            let instance = self.function_instance(unit);
            self.unit_body(unit, instance, Some(usize::MAX), None);
            self.labels.truncate(labels);
            steps += std::mem::replace(&mut self.rungs, kept).steps.len();
        }
        (self.names.temps, self.writes) = (temps, writes);
    }
}

/// Whether a call gives a variable: VAR_INPUT, VAR_IN_OUT.
pub(super) fn is_input(var: &Var) -> bool {
    matches!(var.section, Section::Input | Section::InOut)
}

/// See [`Lower::nesting`].
enum Nesting {
    Good,
    /// A block that contains itself would never end.
    InItself,
    TooDeep,
}

/// The first of these names.
fn few(names: &[&str]) -> String {
    let more = if names.len() > MOST_NAMES {
        ", …"
    } else {
        ""
    };
    names[..names.len().min(MOST_NAMES)].join(", ") + more
}
