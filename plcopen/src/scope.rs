//! What a name means in a program.

use crate::found::Found;
use crate::points::{Point, Points};
use crate::project::Variable;
use std::collections::{BTreeMap, HashMap};
use unoclp_core::isa::{COUNTERS, MARKERS, REGISTERS, TIMERS};
use unoclp_ladder::Address;
use unoclp_lang::typed::Base;
use unoclp_lang::{Code, Span, Word, given};

/// What a variable is on the board.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Symbol {
    /// A point that is 0 or 1.
    Bit(Address),
    /// A register or an analogue input.
    Number(Address),
    /// The PWM of an output.
    Pwm(u8),
    /// What never changes.
    Constant(i32),
    /// A timer, by the order in which they were met.
    Timer(u8),
    /// A counter; what its Q says.
    Counter(u8, Counts),
    /// The marker of an SR or RS.
    Latch(u8),
    /// An R_TRIG or F_TRIG.
    Edge,
}

/// How a counter counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Counts {
    Up,
    Down,
    Both,
}

/// What is written at a contact or at the input of a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Meaning {
    Symbol(Symbol),
    /// Q of a counter at 0 or below.
    AtZero(u8),
    /// The elapsed time of a timer.
    Elapsed(u8),
    /// The number of a counter.
    Count(u8),
    Truth(bool),
}

/// What is allotted for the whole project.
pub(crate) struct Allotted {
    pub points: Points,
    /// What points are called, the first to be met.
    pub names: BTreeMap<Address, String>,
    /// Which timer a block calls, by its program and its element.
    pub timers: HashMap<(usize, usize), u8>,
    globals: HashMap<String, (Variable, Option<Symbol>)>,
    /// Variables that begin with another value than 0, or are kept; in the order in which they were met.
    pub begun: Vec<(Symbol, Option<i32>, bool, Span)>,
}

/// The names of one program.
pub(crate) struct Scope {
    locals: HashMap<String, (Variable, Option<Symbol>)>,
}

impl Allotted {
    pub(crate) fn new(points: Points, globals: &[Variable]) -> Allotted {
        Allotted {
            points,
            names: BTreeMap::new(),
            timers: HashMap::new(),
            globals: by_name(globals),
            begun: Vec::new(),
        }
    }
}

fn by_name(variables: &[Variable]) -> HashMap<String, (Variable, Option<Symbol>)> {
    let named = variables.iter().filter(|v| v.section != "externalVars");
    named
        .map(|variable| (variable.name.to_uppercase(), (variable.clone(), None)))
        .collect()
}

impl Scope {
    pub(crate) fn new(variables: &[Variable]) -> Scope {
        Scope {
            locals: by_name(variables),
        }
    }

    /// What is written at an element, which is called so and stands there; none where that is told to be wrong.
    pub(crate) fn meaning(
        &mut self,
        written: &str,
        who: &Word,
        at: Span,
        all: &mut Allotted,
        found: &mut Found,
    ) -> Option<Meaning> {
        let upper = written.trim().to_uppercase();
        match upper.as_str() {
            "TRUE" | "BOOL#TRUE" | "BOOL#1" => return Some(Meaning::Truth(true)),
            "FALSE" | "BOOL#FALSE" | "BOOL#0" => return Some(Meaning::Truth(false)),
            _ => {}
        }
        if upper.starts_with('%') {
            let point = all.points.address(&upper);
            if point.is_none() {
                found.tell_at(Code::XmlAddress, at, [who.clone(), written.into()]);
            }
            return point.map(|point| Meaning::Symbol(symbol_of(point)));
        }
        if upper.starts_with(|c: char| c.is_ascii_digit() || c == '-' || c == '+')
            || upper.contains('#')
        {
            let number = number(written);
            if number.is_none() {
                let what = ("number that fits 32 bits", "um número que caiba em 32 bits");
                found.tell_at(
                    Code::XmlValue,
                    at,
                    [who.clone(), written.into(), what.into()],
                );
            }
            return number.map(|number| Meaning::Symbol(Symbol::Constant(number)));
        }
        let (name, member) = match upper.split_once('.') {
            Some((name, member)) => (name, Some(member)),
            None => (upper.as_str(), None),
        };
        let symbol = self.symbol(name, who, at, all, found)?;
        let meaning = match (symbol, member) {
            (symbol, None) => Some(Meaning::Symbol(symbol)),
            (Symbol::Timer(_), Some("Q")) => Some(Meaning::Symbol(symbol)),
            (Symbol::Timer(timer), Some("ET")) => Some(Meaning::Elapsed(timer)),
            (Symbol::Counter(counter, Counts::Down), Some("Q")) => Some(Meaning::AtZero(counter)),
            (Symbol::Counter(counter, Counts::Both), Some("QD")) => Some(Meaning::AtZero(counter)),
            (Symbol::Counter(_, Counts::Up), Some("Q")) => Some(Meaning::Symbol(symbol)),
            (Symbol::Counter(_, Counts::Both), Some("QU")) => Some(Meaning::Symbol(symbol)),
            (Symbol::Counter(counter, _), Some("CV")) => Some(Meaning::Count(counter)),
            (Symbol::Latch(_), Some("Q1")) => Some(Meaning::Symbol(symbol)),
            _ => None,
        };
        if meaning.is_none() {
            found.tell_at(Code::XmlUndeclared, at, [who.clone(), written.into()]);
        }
        meaning
    }

    /// The point of a variable, which gets one where it has none yet.
    fn symbol(
        &mut self,
        name: &str,
        who: &Word,
        at: Span,
        all: &mut Allotted,
        found: &mut Found,
    ) -> Option<Symbol> {
        let local = self.locals.get(name);
        let Some((variable, known)) = local.or_else(|| all.globals.get(name)).cloned() else {
            found.tell_at(Code::XmlUndeclared, at, [who.clone(), name.into()]);
            return None;
        };
        if known.is_some() {
            return known;
        }
        let is_local = local.is_some();
        let symbol = allot(&variable, who, all, found)?;
        let own = match is_local {
            true => self.locals.get_mut(name),
            false => all.globals.get_mut(name),
        };
        if let Some(own) = own {
            own.1 = Some(symbol);
        }
        Some(symbol)
    }
}

/// What a variable becomes.
fn allot(variable: &Variable, who: &Word, all: &mut Allotted, found: &mut Found) -> Option<Symbol> {
    let at = variable.at;
    let kind = variable.kind.to_uppercase();
    let initial = variable.initial.as_deref();
    let first = initial.and_then(number);
    if let (Some(written), None) = (initial, first) {
        let what = (
            "number, time or truth",
            "um número, um tempo ou TRUE ou FALSE",
        );
        found.tell_at(
            Code::XmlValue,
            at,
            [who.clone(), written.into(), what.into()],
        );
        return None;
    }
    let is_bit = kind == "BOOL";
    let is_number = is_number(&kind);
    let symbol = if let Some(address) = &variable.address {
        let Some(point) = all.points.address(address) else {
            found.tell_at(Code::XmlAddress, at, [who.clone(), address.as_str().into()]);
            return None;
        };
        let symbol = symbol_of(point);
        let fits = match symbol {
            Symbol::Bit(_) => is_bit,
            _ => is_number,
        };
        if !fits {
            let wanted = match symbol {
                Symbol::Bit(_) => "BOOL",
                _ => "INT",
            };
            let words = [
                who.clone(),
                variable.name.as_str().into(),
                kind.into(),
                wanted.into(),
            ];
            found.tell_at(Code::XmlType, at, words);
            return None;
        }
        Some(symbol)
    } else if variable.constant && (is_bit || is_number) {
        return Some(Symbol::Constant(first.unwrap_or(0)));
    } else {
        match kind.split('_').next().unwrap_or_default() {
            _ if is_bit => {
                let marker = all.points.marker(variable.retain);
                marker.map(|marker| Symbol::Bit(Address::Marker(marker)))
            }
            _ if is_number => {
                let register = all.points.register();
                register.map(|register| Symbol::Number(Address::Register(register)))
            }
            "TON" | "TOF" | "TP" => all.points.timer().map(Symbol::Timer),
            "CTU" => all
                .points
                .counter(&variable.name)
                .map(|c| Symbol::Counter(c, Counts::Up)),
            "CTD" => all
                .points
                .counter(&variable.name)
                .map(|c| Symbol::Counter(c, Counts::Down)),
            "CTUD" => all
                .points
                .counter(&variable.name)
                .map(|c| Symbol::Counter(c, Counts::Both)),
            "SR" | "RS" => all.points.marker(variable.retain).map(Symbol::Latch),
            "R" | "F" if matches!(kind.as_str(), "R_TRIG" | "F_TRIG") => Some(Symbol::Edge),
            _ => {
                let wanted = ("BOOL or a whole number", "BOOL ou um número inteiro");
                let words = [
                    who.clone(),
                    variable.name.as_str().into(),
                    variable.kind.as_str().into(),
                    wanted.into(),
                ];
                found.tell_at(Code::XmlType, at, words);
                return None;
            }
        }
    };
    let Some(symbol) = symbol else {
        none_left(variable, &kind, who, found);
        return None;
    };
    // It would take the place of what was kept, at each start.
    let first = first.filter(|first| *first != 0 && !variable.retain);
    let keeps = variable.retain && matches!(symbol, Symbol::Number(Address::Register(_)));
    if first.is_some() || keeps {
        all.begun.push((symbol, first, keeps, at));
    }
    if let Some(point) = point(symbol)
        && !variable.name.eq_ignore_ascii_case(&point.to_string())
    {
        all.names
            .entry(point)
            .or_insert_with(|| variable.name.clone());
    }
    Some(symbol)
}

fn none_left(variable: &Variable, kind: &str, who: &Word, found: &mut Found) {
    let (what, most) = match kind {
        "TON" | "TOF" | "TP" => (("timer", "temporizador"), TIMERS),
        "BOOL" | "SR" | "RS" => (("marker", "memória"), MARKERS),
        _ if kind.starts_with("CT") => (("counter", "contador"), COUNTERS),
        _ => (("register", "registrador"), REGISTERS),
    };
    let name = variable.name.as_str().into();
    let words = [who.clone(), what.into(), name, most.to_string().into()];
    found.tell_at(Code::XmlNoneLeft, variable.at, words);
}

/// The point that has the name of a variable.
pub(crate) fn point(symbol: Symbol) -> Option<Address> {
    match symbol {
        Symbol::Bit(point) | Symbol::Number(point) => Some(point),
        Symbol::Timer(timer) => Some(Address::Timer(timer)),
        Symbol::Counter(counter, _) => Some(Address::Counter(counter)),
        Symbol::Latch(marker) => Some(Address::Marker(marker)),
        Symbol::Pwm(_) | Symbol::Constant(_) | Symbol::Edge => None,
    }
}

fn symbol_of(point: Point) -> Symbol {
    match point {
        Point::At(point @ (Address::Register(_) | Address::Analogue(_))) => Symbol::Number(point),
        Point::At(point) => Symbol::Bit(point),
        Point::Pwm(output) => Symbol::Pwm(output),
    }
}

/// Whether registers hold variables of this type.
fn is_number(kind: &str) -> bool {
    let held = [
        "SINT", "INT", "DINT", "USINT", "UINT", "BYTE", "WORD", "TIME",
    ];
    held.contains(&kind)
}

/// The number, time or truth that a text says, as a register holds it.
pub(crate) fn number(text: &str) -> Option<i32> {
    let bases = [Base::Dint, Base::Time, Base::Dword, Base::Bool];
    let value = bases.into_iter().find_map(|base| given(text, base, &[]))?;
    let number = value.int();
    i32::try_from(number)
        .or_else(|_| u32::try_from(number).map(u32::cast_signed))
        .ok()
}
