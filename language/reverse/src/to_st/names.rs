//! What the places of a program are called, and how they are declared.
//!
//! Owns both. Must not know what is done with them.

use super::counters::Edge;
use super::expr::{Place, Type, View, literal};
use super::given::{free, given, kept};
use super::machine::Body;
use super::statement::places;
use super::why::Why;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use unoclp_checked::SourceMap;
use unoclp_core::Instruction;
use unoclp_core::isa::Opcode;
use unoclp_point::{Address, Kind};

/// The names of a program, and its variables.
pub(super) struct Names {
    names: BTreeMap<Place, String>,
    /// The declarations that are kept over a power cut, and the others.
    kept: Vec<String>,
    others: Vec<String>,
}

impl Names {
    /// # Errors
    /// A step whose variable has no place.
    pub fn of(
        steps: &[Instruction<'_>],
        map: &SourceMap,
        body: &Body,
    ) -> Result<Names, (usize, Why)> {
        let mut used = BTreeSet::new();
        places(&body.statements, &mut |place| {
            used.insert(place);
        });
        let mut draft = Draft {
            given: given(steps, map),
            taken: BTreeSet::from(["MAIN".to_owned(), "ROOT".to_owned()]),
            body,
            free: free(steps, &used),
            names: Names {
                names: BTreeMap::new(),
                kept: Vec::new(),
                others: Vec::new(),
            },
        };
        for (at, step) in steps.iter().enumerate() {
            draft.keep(step, &mut used).map_err(|why| (at, why))?;
        }
        let kept: BTreeSet<Place> = kept(steps, body).collect();
        // What stands at an address before what has none.
        let mut places: Vec<Place> = used.iter().copied().collect();
        places.sort_by_key(|place| match place {
            Place::At(Address::Analogue(_) | Address::Pwm(_)) => 1,
            Place::Register(..) => 2,
            Place::At(point) if point.kind() > Kind::System => 3,
            Place::At(_) | Place::Pin(_) | Place::FilterOn(_) | Place::FilterOff(_) => 0,
            _ => 4,
        });
        for place in places {
            draft.declare(place, &used, &kept).map_err(|why| (0, why))?;
        }
        Ok(draft.names)
    }

    /// What a place is called.
    pub fn name(&self, place: Place) -> String {
        let name = |of: Place| self.names.get(&of).cloned().unwrap_or_default();
        match place {
            Place::At(Address::TimerQ(n)) => name(Place::At(Address::TimerQ(n))) + ".Q",
            Place::At(Address::Elapsed(n)) => name(Place::At(Address::TimerQ(n))) + ".ET",
            Place::EdgeQ(_) | Place::FilterOn(_) | Place::FilterOff(_) => name(place) + ".Q",
            Place::At(Address::Reached(n)) => {
                name(Place::At(Address::Count(n))).replace(".CV", ".Q")
            }
            other => name(other),
        }
    }

    /// The sections of variables.
    pub fn declarations(&self) -> String {
        let mut text = String::new();
        for (section, lines) in [("VAR RETAIN", &self.kept), ("VAR", &self.others)] {
            if !lines.is_empty() {
                let _ = writeln!(text, "{section}");
                for line in lines {
                    let _ = writeln!(text, "  {line}");
                }
                text.push_str("END_VAR\n");
            }
        }
        text
    }
}

struct Draft<'b> {
    given: BTreeMap<Place, String>,
    /// The names that are taken, in upper case.
    taken: BTreeSet<String>,
    body: &'b Body,
    /// Registers that the program does not have.
    free: Vec<u8>,
    names: Names,
}

impl Draft<'_> {
    /// Takes what a step of KD and KC keeps among the variables, though nothing else may name it.
    fn keep(&self, step: &Instruction<'_>, used: &mut BTreeSet<Place>) -> Result<(), Why> {
        let xx = step.number().unwrap_or_default();
        match step.opcode {
            Opcode::KeepCounter => drop(used.insert(Place::At(Address::Count(xx)))),
            Opcode::KeepRegister => {
                let registers = &self.body.registers;
                match registers.table(xx) {
                    None => drop(used.insert(Place::Register(xx, registers.view(xx)))),
                    Some(_) => return Err(Why::PartOfArray),
                }
            }
            _ => {}
        }
        Ok(())
    }

    /// A name that nothing else has: the one that the text gave, or this.
    fn take(&mut self, place: Place, or: &str) -> String {
        let given = self
            .given
            .get(&place)
            .filter(|name| !self.taken.contains(&name.to_uppercase()));
        let mut name = given.cloned().unwrap_or_else(|| or.to_owned());
        while !self.taken.insert(name.to_uppercase()) {
            name.push('_');
        }
        name
    }

    fn declare(
        &mut self,
        place: Place,
        used: &BTreeSet<Place>,
        kept: &BTreeSet<Place>,
    ) -> Result<(), Why> {
        // Of two views of the same bits the first is declared where it stands, the other beside it.
        let twin = twin(place).filter(|twin| used.contains(twin));
        let type_of = |view| if view == View::Real { "REAL" } else { "DINT" };
        let (or, address, of): (String, Option<String>, String) = match place {
            Place::At(Address::Input(n)) if self.body.filter.is_some() => {
                (format!("I{n}"), None, "BOOL".into())
            }
            Place::Pin(n) => (
                self.beside(n, "pin"),
                Some(format!("%IX{n}")),
                "BOOL".into(),
            ),
            Place::FilterOn(n) => (self.beside(n, "on"), None, "TON".into()),
            Place::FilterOff(n) => (self.beside(n, "off"), None, "TON".into()),
            Place::Register(n, view) => {
                let real = if twin.is_some() && view == View::Real {
                    "_real"
                } else {
                    ""
                };
                (
                    format!("D{n}{real}"),
                    Some(format!("%MD{n}")),
                    type_of(view).into(),
                )
            }
            Place::Table(n) => {
                let tables = self.body.registers.tables.iter();
                let last = tables
                    .clone()
                    .find(|(first, _)| *first == n)
                    .map_or(n, |(_, last)| *last);
                let of = type_of(self.body.registers.view(n));
                (
                    format!("D{n}_to_{last}"),
                    None,
                    format!("ARRAY[0..{}] OF {of}", last - n),
                )
            }
            Place::At(Address::TimerQ(n) | Address::Elapsed(n)) => {
                let block = match self.body.timers.get(usize::from(n).wrapping_sub(1)) {
                    Some((Opcode::OffDelay, _)) => "TOF",
                    Some((Opcode::Pulse, _)) => "TP",
                    _ => "TON",
                };
                if self
                    .names
                    .names
                    .contains_key(&Place::At(Address::TimerQ(n)))
                {
                    return Ok(());
                }
                let name = self.take(Place::At(Address::TimerQ(n)), &format!("T{n}"));
                self.names.others.push(format!("{name} : {block};"));
                self.names.names.insert(Place::At(Address::TimerQ(n)), name);
                return Ok(());
            }
            Place::At(Address::TimerPreset(n)) => {
                let preset = self.body.timers.get(usize::from(n).wrapping_sub(1));
                let preset = literal(preset.map_or(0, |(_, preset)| *preset), Type::Time);
                (format!("T{n}_PT"), None, format!("TIME := {preset}"))
            }
            Place::At(Address::Count(n) | Address::Reached(n)) => {
                self.counter(n, kept.contains(&Place::At(Address::Count(n))));
                return Ok(());
            }
            Place::At(Address::CountPreset(n)) => {
                let preset = self
                    .body
                    .counting
                    .0
                    .get(&n)
                    .map_or(0, |counter| counter.preset);
                (format!("C{n}_PV"), None, format!("DINT := {preset}"))
            }
            Place::At(point) => {
                let letters = match point {
                    Address::Input(_) => "%IX",
                    Address::Output(_) => "%QX",
                    Address::Marker(_) => "%MX",
                    Address::System(_) => "%S",
                    Address::Analogue(_) => "%IW",
                    _ => "%QW",
                };
                let address = format!("{letters}{}", point.number());
                let of = if point.is_bit() { "BOOL" } else { "DINT" };
                (point.to_string(), Some(address), of.into())
            }
            Place::CountUp(n) => (format!("C{n}_up"), None, "BOOL".into()),
            Place::CountDown(n) => (format!("C{n}_down"), None, "BOOL".into()),
            Place::EdgeQ(n) => match self.body.edges.get(usize::from(n).wrapping_sub(1)) {
                Some(Edge::Rise) => (format!("rise{n}"), None, "R_TRIG".into()),
                _ => (format!("fall{n}"), None, "F_TRIG".into()),
            },
            Place::EdgeBefore(n) => (format!("before{n}"), None, "BOOL".into()),
            Place::Branch(n) => (format!("branch{n}"), None, "BOOL".into()),
            Place::Bit(n) => (format!("bit{n}"), None, "BOOL".into()),
            Place::Number(n, view) => (
                view_name(&format!("number{n}"), view, twin),
                self.shared(twin)?,
                type_of(view).into(),
            ),
            Place::Value(view) => (
                view_name("value", view, twin),
                self.shared(twin)?,
                type_of(view).into(),
            ),
            Place::Jump => ("jump".into(), None, "DINT".into()),
            Place::Zero(view) => (view_name("zero", view, twin), None, type_of(view).into()),
        };
        let name = self.take(place, &or);
        let is_kept = kept.contains(&place);
        let first = if is_kept { " := 0" } else { "" };
        let at = address
            .map(|address| format!(" AT {address}"))
            .unwrap_or_default();
        let line = format!("{name}{at} : {of}{first};");
        let section = if is_kept {
            &mut self.names.kept
        } else {
            &mut self.names.others
        };
        section.push(line);
        self.names.names.insert(place, name);
        Ok(())
    }

    /// The register that both views of a variable stand at: the first takes one, the second finds it.
    fn shared(&mut self, twin: Option<Place>) -> Result<Option<String>, Why> {
        let Some(twin) = twin else {
            return Ok(None);
        };
        let register = match self.names.names.contains_key(&twin) {
            true => self.free.pop(),
            false => self.free.last().copied(),
        };
        let register = register.ok_or(Why::NoRegister)?;
        Ok(Some(format!("%MD{register}")))
    }

    /// What belongs to an input is called by its name and a word.
    fn beside(&self, input: u8, word: &str) -> String {
        let name = self.names.names.get(&Place::At(Address::Input(input)));
        format!("{}_{word}", name.map_or("I", String::as_str))
    }

    fn counter(&mut self, number: u8, is_kept: bool) {
        if self
            .names
            .names
            .contains_key(&Place::At(Address::Count(number)))
        {
            return;
        }
        let counting = &self.body.counting.0;
        let block = counting.get(&number).and_then(|counter| counter.block);
        let name = self.take(Place::At(Address::Count(number)), &format!("C{number}"));
        let (of, member) = match block {
            Some((Opcode::CountUp, _)) => ("CTU", ".CV"),
            Some(_) => ("CTD", ".CV"),
            None => ("DINT", ""),
        };
        let section = if is_kept {
            &mut self.names.kept
        } else {
            &mut self.names.others
        };
        section.push(format!("{name} : {of};"));
        self.names
            .names
            .insert(Place::At(Address::Count(number)), name + member);
    }
}

fn view_name(name: &str, view: View, twin: Option<Place>) -> String {
    match (view, twin) {
        (View::Real, Some(_)) => format!("{name}_real"),
        _ => name.to_owned(),
    }
}

/// The other view of the same bits.
fn twin(place: Place) -> Option<Place> {
    let other = |view| match view {
        View::Whole => View::Real,
        View::Real => View::Whole,
    };
    Some(match place {
        Place::Register(n, view) => Place::Register(n, other(view)),
        Place::Number(n, view) => Place::Number(n, other(view)),
        Place::Value(view) => Place::Value(other(view)),
        Place::Zero(view) => Place::Zero(other(view)),
        _ => return None,
    })
}

impl Body {
    /// The functions that the text calls and that are none of the standard.
    pub fn functions(&self) -> &'static str {
        match self.roots {
            true => ROOT,
            false => "",
        }
    }
}

/// The whole root of a whole number. That of a negative one is 0, and sets S 04.
const ROOT: &str = "
FUNCTION root : DINT
VAR_INPUT n : DINT; END_VAR
root := REAL_TRUNC_DINT(SQRT(DINT_TO_REAL(n)));
(* A REAL has 24 bits, so it may be one off. *)
IF root > 46340 OR root * root > MAX(n, 0) THEN
  root := root - 1;
ELSIF root < 46340 AND (root + 1) * (root + 1) <= n THEN
  root := root + 1;
END_IF;
END_FUNCTION
";
