//! What names stand for: variables `V0`, points, and the names that `var` gives them.
//!
//! Owns which places there are and in which cells a variable lives. Must not know expressions.

use super::ast::{Kind, Name};
use super::checker::{Cells, Checker, Shown, Slot, Variable, Written};
use unoclp_point::Maker;
use unoclp_text::diagnostics::{Code, Word};
use unoclp_text::near::nearest;
use unoclp_text::points;
use unoclp_tree::build::both;
use unoclp_tree::build::points::point_base;
use unoclp_tree::{Base, Cell, Holds, Symbol, Value};

/// For more names than this, no near one is looked for.
const MOST_NEAR: u32 = 32;

/// Whether it is written like a place: `V0`, `I0.0`, `AIW1`.
pub(super) fn is_place(text: &str) -> bool {
    let end = text.find(|c: char| !c.is_ascii_uppercase());
    let (letters, digits) = text.split_at(end.unwrap_or(text.len()));
    let number = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    match letters {
        "V" | "AIW" => number(digits),
        "I" | "Q" | "M" => digits
            .split_once('.')
            .is_some_and(|(byte, bit)| number(byte) && number(bit)),
        _ => false,
    }
}

impl Checker<'_, '_> {
    /// What a name stands for; none, with one message, if it stands for nothing.
    pub(super) fn slot(&mut self, name: &Name) -> Option<Slot> {
        if let Some(slot) = self.names.get(&name.text) {
            return *slot;
        }
        let slot = self.place(name);
        if slot.is_none() {
            self.told_no_place(name);
        }
        self.names.insert(name.text.clone(), slot);
        if let Some(slot) = slot {
            self.shown.push(Shown {
                name: name.text.clone(),
                slot,
                at: name.span,
            });
        }
        slot
    }

    /// The place that a name is, if it is one.
    fn place(&mut self, name: &Name) -> Option<Slot> {
        if !is_place(&name.text) {
            return None;
        }
        if !name.text.starts_with('V') {
            let point = self
                .builder
                .address_of(&name.text, Maker::Simuplc, name.span);
            return point.map(Slot::Point);
        }
        self.variables.push(Variable::default());
        Some(Slot::Variable(self.variables.len() - 1))
    }

    fn told_no_place(&mut self, name: &Name) {
        let text = name.text.as_str();
        let upper = text.to_uppercase();
        let pointed = text.contains('.');
        if is_place(text) || pointed && !is_place(&upper) {
            let help = points::help(text, Maker::Simuplc, self.builder.board);
            self.builder
                .tell(Code::LceNoPoint, name.span, [text.into(), help]);
            return;
        }
        self.asked += 1;
        let names = self.names.iter().filter(|(_, slot)| slot.is_some());
        let near = match self.asked > MOST_NEAR {
            true => None,
            false => {
                let mut same = names.clone().map(|(name, _)| name.as_str());
                let same = same.find(|name| name.to_uppercase() == upper);
                same.or_else(|| nearest(text, names.map(|(name, _)| name.as_str())))
            }
        };
        let help = match near {
            _ if is_place(&upper) => both(
                format!("LCE is case-sensitive: write {upper}"),
                format!("maiúsculas e minúsculas são diferentes: escreva {upper}"),
            ),
            Some(near) if near.to_uppercase() == upper => both(
                format!("LCE is case-sensitive: did you mean `{near}`?"),
                format!("maiúsculas e minúsculas são diferentes: você quis dizer `{near}`?"),
            ),
            Some(near) => Word::Near(near.to_string()),
            None => both(
                format!("give this name to a variable: var V0 = {text};"),
                format!("dê esse nome a uma variável: var V0 = {text};"),
            ),
        };
        self.builder
            .tell(Code::LceUndeclared, name.span, [text.into(), help]);
    }

    /// Notes the type that a name is written with.
    pub(super) fn note(&mut self, name: &Name, written: Written) {
        let Some(Slot::Variable(number)) = self.slot(name) else {
            return;
        };
        if let Some(variable) = self.variables.get_mut(number) {
            match written {
                Written::Bit => variable.bit = true,
                Written::Whole => variable.whole = true,
                Written::Real => variable.real = true,
            }
        }
    }

    /// The cells of a variable, made when they are asked for first.
    pub(super) fn cells(&mut self, number: usize) -> Cells {
        let Some(variable) = self.variables.get(number) else {
            return Cells::One(0, Base::Dint);
        };
        if let Some(cells) = variable.cells {
            return cells;
        }
        let cells = match (variable.real, variable.whole, variable.bit) {
            (true, true, _) => Cells::Two {
                flag: self.cell(Base::Bool),
                real: self.cell(Base::Real),
                whole: self.cell(Base::Dint),
            },
            // 1 and 0 are the same as a REAL, so a bit needs no marker beside it.
            (true, false, _) => Cells::One(self.cell(Base::Real), Base::Real),
            (false, false, true) => Cells::One(self.cell(Base::Bool), Base::Bool),
            _ => Cells::One(self.cell(Base::Dint), Base::Dint),
        };
        if let Some(variable) = self.variables.get_mut(number) {
            variable.cells = Some(cells);
        }
        cells
    }

    fn cell(&mut self, base: Base) -> u32 {
        let cells = &mut self.builder.tree.cells;
        cells.push(Cell {
            base,
            initial: Value::zero(base),
            retain: false,
            scratch: false,
        });
        cells.len() as u32 - 1
    }

    /// All names with what they stand for.
    pub(super) fn symbols(&mut self) -> Vec<Symbol> {
        let shown = std::mem::take(&mut self.shown);
        let symbol = |Shown { name, slot, at }| {
            let (holds, base, type_name) = match slot {
                Slot::Point(point) => {
                    let cell = self.builder.point(point);
                    let base = point_base(point);
                    (Holds::Cell(cell), base, base.name().to_owned())
                }
                Slot::Variable(number) => match self.cells(number) {
                    Cells::One(cell, base) => (Holds::Cell(cell), base, base.name().to_owned()),
                    Cells::Two { flag, real, whole } => {
                        let holds = Holds::Either {
                            flag,
                            set: real,
                            clear: whole,
                        };
                        (holds, Base::Dint, format!("{}/{}", Base::Real, Base::Dint))
                    }
                },
            };
            Symbol {
                name,
                type_name,
                base,
                holds,
                at,
                values: Default::default(),
            }
        };
        shown.into_iter().map(symbol).collect()
    }
}

impl Written {
    /// The type that an assignment of this type writes.
    pub fn of(kind: Option<Kind>) -> Written {
        match kind {
            Some(Kind::R) => Written::Real,
            _ => Written::Whole,
        }
    }
}
