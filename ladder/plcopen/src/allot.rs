//! What the variables of a project become: each gets a place on the board where it is first met.

use crate::found::Found;
use crate::points::Points;
use crate::project::Variable;
use crate::symbol::{Counts, Symbol, number, point};
use std::collections::{BTreeMap, HashMap, HashSet};
use std::sync::Arc;
use unoclp_core::Board;
use unoclp_core::isa::{REGISTERS, RETENTIVE};
use unoclp_lang::{Code, Span, Word};
use unoclp_point::Address;

/// What is allotted for the whole project.
pub(crate) struct Allotted {
    pub points: Points,
    /// What points are called, the first to be met.
    pub names: BTreeMap<Address, String>,
    /// Which timer a block calls, by its program and its element.
    pub timers: HashMap<(usize, usize), u8>,
    pub globals: HashMap<String, Place>,
    /// The instances that blocks call, by their names in capitals.
    pub called: HashSet<String>,
    /// Variables that begin with another value than 0, or are kept; in the order in which they were met.
    pub begun: Vec<(Symbol, Option<i32>, bool, Span)>,
}

impl Allotted {
    pub(crate) fn new(points: Points, globals: &[Variable]) -> Allotted {
        Allotted {
            points,
            names: BTreeMap::new(),
            timers: HashMap::new(),
            globals: by_name(globals),
            called: HashSet::new(),
            begun: Vec::new(),
        }
    }
}

/// The place of a variable on the board.
#[derive(Clone)]
pub(crate) enum Place {
    /// Nothing has used it yet.
    Waits(Arc<Variable>),
    Has(Symbol),
    /// The board has none for it, which has been told.
    None,
}

/// Variables by their names in capitals, none allotted yet.
pub(crate) fn by_name(variables: &[Variable]) -> HashMap<String, Place> {
    let named = variables.iter().filter(|v| v.section != "externalVars");
    named
        .map(|variable| {
            let place = Place::Waits(Arc::new(variable.clone()));
            (variable.name.to_uppercase(), place)
        })
        .collect()
}

/// What a variable becomes.
pub(crate) fn allot(
    variable: &Variable,
    who: &Word,
    all: &mut Allotted,
    found: &mut Found,
) -> Option<Symbol> {
    let at = variable.at;
    let kind = variable.kind.to_uppercase();
    let initial = variable.initial.as_deref();
    let first = initial.and_then(number);
    if let (Some(written), None) = (initial, first) {
        let what = (
            "number, time, TRUE or FALSE",
            "um número, um tempo, TRUE ou FALSE",
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
        let point = match all.points.address(address) {
            Ok(point) => {
                all.points.tell_moved(address, at, found);
                point
            }
            Err(help) => {
                let words = [who.clone(), address.as_str().into(), help];
                found.tell_at(Code::XmlAddress, at, words);
                return None;
            }
        };
        let (fits, wanted) = match point.is_bit() {
            true => (is_bit, "BOOL"),
            false => (is_number, "INT"),
        };
        if !fits {
            let words = [
                who.clone(),
                variable.name.as_str().into(),
                kind.into(),
                wanted.into(),
            ];
            found.tell_at(Code::XmlType, at, words);
            return None;
        }
        Some(Symbol::At(point))
    } else if variable.constant && (is_bit || is_number) {
        return Some(Symbol::Constant(first.unwrap_or(0)));
    } else {
        match kind.split('_').next().unwrap_or_default() {
            _ if is_bit => {
                let marker = all.points.marker(variable.retain);
                marker.map(|marker| Symbol::At(Address::Marker(marker)))
            }
            _ if is_number => {
                let register = all.points.register();
                register.map(|register| Symbol::At(Address::Register(register)))
            }
            "TON" | "TOF" | "TP" => {
                let timer = all.points.timer();
                timer.map(|timer| Symbol::At(Address::Timer(timer)))
            }
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
        none_left(variable, &kind, (who, all.points.board), found);
        return None;
    };
    // It would take the place of what was kept, at each start.
    let first = first.filter(|first| *first != 0 && !variable.retain);
    let is_read = matches!(
        symbol,
        Symbol::At(Address::Input(_) | Address::Analogue(_) | Address::System(_))
    );
    let name = || [who.clone(), variable.name.as_str().into()];
    let first = match first {
        Some(_) if is_read => {
            found.tell_at(Code::XmlFirst, at, name());
            None
        }
        first => first,
    };
    if variable.retain && !is_read && !can_be_kept(symbol) {
        found.tell_at(Code::XmlNotKept, at, name());
    }
    let keeps = variable.retain && matches!(symbol, Symbol::At(Address::Register(_)));
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

fn none_left(variable: &Variable, kind: &str, (who, board): (&Word, Board), found: &mut Found) {
    let (what, most) = match kind {
        "TON" | "TOF" | "TP" => (("timer", "temporizador"), board.timers),
        "BOOL" | "SR" | "RS" => (("marker", "memória"), board.markers),
        _ if kind.starts_with("CT") => (("counter", "contador"), board.counters),
        _ => (("register", "registrador"), REGISTERS),
    };
    let name = variable.name.as_str().into();
    let words = [who.clone(), what.into(), name, most.to_string().into()];
    found.tell_at(Code::XmlNoneLeft, variable.at, words);
}

/// Whether a board keeps it over a power cut.
fn can_be_kept(symbol: Symbol) -> bool {
    match symbol {
        Symbol::At(Address::Marker(marker)) | Symbol::Latch(marker) => {
            (RETENTIVE..RETENTIVE + 8).contains(&marker)
        }
        Symbol::At(Address::Register(_)) | Symbol::Constant(_) => true,
        _ => false,
    }
}

/// Whether registers hold variables of this type.
fn is_number(kind: &str) -> bool {
    let held = [
        "SINT", "INT", "DINT", "USINT", "UINT", "BYTE", "WORD", "TIME",
    ];
    held.contains(&kind)
}

/// Whether a ladder's document can have this variable.
pub(crate) fn is_of_ladder(variable: &Variable) -> bool {
    let kind = variable.kind.to_uppercase();
    let plain = kind.split('_').next().unwrap_or_default();
    let blocks = [
        "TON", "TOF", "TP", "CTU", "CTD", "CTUD", "SR", "RS", "R", "F",
    ];
    kind == "BOOL" || is_number(&kind) || blocks.contains(&plain)
}
