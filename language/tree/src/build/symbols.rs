//! The symbols of a finished tree: each member and each element by its own name.

use super::builder::Builder;
use crate::standard::Role;
use crate::{Base, Enumeration, Holds, Kind, Symbol, TypeId};
use std::cell::Cell;
use std::sync::Arc;
use unoclp_text::diagnostics::{Code, Span};

/// Where a symbol comes from.
struct Whole<'n> {
    at: Span,
    /// Its name is that of the variable and of the parts that lead to it.
    name: &'n str,
    /// The bytes that are left for names of symbols.
    room: &'n Cell<usize>,
}

/// The most bytes that the names of all symbols and of their types may have.
const MOST_TEXT: usize = 64 << 20;

impl Builder<'_, '_> {
    pub(super) fn make_symbols(&mut self) {
        let shown = std::mem::take(&mut self.shown);
        let room = Cell::new(MOST_TEXT);
        let many = self.tree.programs.len() > 1;
        for (name, variable, program) in shown {
            let program = program.filter(|_| many).and_then(|unit| self.draft(unit));
            let name = match program {
                Some(draft) => format!("{}.{name}", draft.unit.name),
                None => name,
            };
            let mut symbols = Vec::new();
            let whole = Whole {
                at: variable.at,
                name: &name,
                room: &room,
            };
            self.push_symbols(&whole, "", variable.ty, variable.offset, &mut symbols);
            if room.get() == 0 {
                let written = self.written(variable.at);
                self.tell(Code::StLongNames, variable.at, [written.into()]);
                return;
            }
            self.tree.symbols.append(&mut symbols);
        }
    }

    fn push_symbols(
        &self,
        whole: &Whole<'_>,
        part: &str,
        ty: TypeId,
        offset: u32,
        symbols: &mut Vec<Symbol>,
    ) {
        let one = |part: &str, type_name: String, base, values: Arc<Enumeration>, cell| {
            let text = whole.name.len() + part.len() + type_name.len();
            whole.room.set(whole.room.get().saturating_sub(text));
            Symbol {
                name: format!("{}{part}", whole.name),
                type_name,
                base,
                holds: Holds::Cell(cell),
                at: whole.at,
                values,
            }
        };
        if whole.room.get() == 0 {
            return;
        }
        match self.tree.types.kind(ty) {
            Kind::Array { bounds, of } => {
                let size = self.tree.types.get(*of).cells;
                let mut subscripts: Vec<i64> = bounds.iter().map(|bound| bound.0).collect();
                let total = self.tree.types.get(ty).cells;
                let mut at = 0;
                while at < total && size > 0 {
                    let written: Vec<String> = subscripts.iter().map(i64::to_string).collect();
                    let part = format!("{part}[{}]", written.join(","));
                    self.push_symbols(whole, &part, *of, offset + at, symbols);
                    at += size;
                    for (subscript, (low, high)) in subscripts.iter_mut().zip(bounds).rev() {
                        *subscript += 1;
                        if *subscript <= *high {
                            break;
                        }
                        *subscript = *low;
                    }
                }
            }
            Kind::Struct(members) => {
                for member in members {
                    let part = format!("{part}.{}", member.name);
                    self.push_symbols(whole, &part, member.ty, offset + member.offset, symbols);
                }
            }
            Kind::Standard(block) => {
                for (at, (name, base, role)) in (0..).zip(block.parts()) {
                    if *role != Role::Hidden {
                        let part = format!("{part}.{name}");
                        let type_name = base.name().to_owned();
                        symbols.push(one(&part, type_name, *base, Arc::default(), offset + at));
                    }
                }
            }
            Kind::Block(unit) => {
                let Some(draft) = self.draft(*unit) else {
                    return;
                };
                for (name, ty, at) in draft.parts() {
                    let part = format!("{part}.{name}");
                    self.push_symbols(whole, &part, ty, offset + at, symbols);
                }
            }
            kind => {
                let values = match kind {
                    Kind::Enum(values) => values.clone(),
                    _ => Arc::default(),
                };
                let base = self.tree.types.base(ty).unwrap_or(Base::Bool);
                symbols.push(one(part, self.tree.types.name(ty), base, values, offset));
            }
        }
    }
}
