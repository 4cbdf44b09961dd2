//! The variables of a program as the board keeps them, for whoever shows them live.
//!
//! Owns which of the tree's symbols stands where, and how what is read there becomes a value. Must not know how it is read.

use super::seats::{Seat, Seats};
use std::collections::HashSet;
use std::sync::Arc;
use unoclp_point::Address;
use unoclp_tree::{
    Base, Enumeration, Expr, ExprKind, Holds, Root, Stmt, StmtKind, Symbol, Tree, Value, Width,
};

/// A value of this type at this point.
pub type Held = (Address, Base);

/// How the board holds a variable.
#[derive(Clone, Debug, PartialEq)]
pub enum Holding {
    /// Always at one point.
    One(Held),
    /// In one of two, as a bit says: a variable that holds what was last written.
    Either {
        /// The bit.
        flag: Address,
        /// The one that is meant if it is 1; none if the program never reads it so.
        set: Option<Held>,
        /// And if it is 0.
        clear: Option<Held>,
    },
    /// Nowhere, because the program does nothing with it: it stays as it begins.
    Constant(Value, Base),
}

/// A variable of a program; a member and an element are variables of their own.
#[derive(Clone, Debug, PartialEq)]
pub struct Variable {
    /// As it was declared: `level`, `q.x`, `a[1,0]`.
    pub name: String,
    /// Its type, as a person writes it.
    pub type_name: String,
    /// Its values, if it is of an enumeration.
    pub values: Arc<Enumeration>,
    /// How the board holds it.
    pub holding: Holding,
    /// Whether PRINT asks to show it.
    pub is_watched: bool,
}

impl Variable {
    /// Where it stands, as `read` tells of a bit which of two is meant; none if nowhere.
    pub fn point(&self, read: impl Fn(Address) -> Option<i32>) -> Option<Address> {
        self.held(read).map(|(point, _)| point)
    }

    fn held(&self, read: impl Fn(Address) -> Option<i32>) -> Option<Held> {
        match &self.holding {
            Holding::One(held) => Some(*held),
            Holding::Either { flag, set, clear } => match read(*flag)? {
                0 => *clear,
                _ => *set,
            },
            Holding::Constant(..) => None,
        }
    }

    /// What it holds, and of what type, where `read` gives what stands at a point.
    pub fn value(&self, read: impl Fn(Address) -> Option<i32>) -> Option<(Value, Base)> {
        match &self.holding {
            Holding::Constant(value, base) => Some((value.clone(), *base)),
            _ => {
                let (point, base) = self.held(&read)?;
                Some((of_bits(read(point)?, base), base))
            }
        }
    }

    /// What it holds, as a literal of its type.
    pub fn shown(&self, read: impl Fn(Address) -> Option<i32>) -> Option<String> {
        let (value, base) = self.value(read)?;
        Some(named(&value, base, &self.values))
    }
}

/// These 32 bits of the board as a literal of this type, or as the name of this variable's enumeration.
pub fn literal(bits: i32, base: Base, variable: Option<&Variable>) -> String {
    let value = of_bits(bits, base);
    match variable {
        Some(variable) => named(&value, base, &variable.values),
        None => value.shown(base),
    }
}

fn named(value: &Value, base: Base, values: &Enumeration) -> String {
    let named = values.name_of(value.int());
    named.map_or_else(|| value.shown(base), str::to_owned)
}

/// The value that 32 bits of the board are, read as this type.
fn of_bits(bits: i32, base: Base) -> Value {
    match base.width() {
        Width::Single => Value::Real(f32::from_bits(bits.cast_unsigned()).into()),
        Width::Unsigned => Value::Int(bits.cast_unsigned().into()),
        Width::Bit => Value::truth(bits != 0),
        _ => Value::Int(bits.into()),
    }
}

/// The variables of a tree, in the order of its symbols, where its cells have these seats.
pub(super) fn variables(tree: &Tree, seats: &Seats, timers: &[u8]) -> Vec<Variable> {
    let mut watched = HashSet::new();
    for unit in &tree.units {
        watch(&unit.body, &mut watched);
    }
    let place = |cell: u32| {
        Some(match seats.outputs.get(&cell) {
            Some(&output) => Address::Pwm(output),
            None => seats.of.get(&cell)?.address(timers)?,
        })
    };
    let held = |cell: u32| Some((place(cell)?, tree.cells.get(cell as usize)?.base));
    let variable = |symbol: &Symbol| {
        let (holding, cells) = match symbol.holds {
            Holds::Cell(cell) => {
                let one = place(cell).map(|point| Holding::One((point, symbol.base)));
                (one, [cell; 2])
            }
            Holds::Either { flag, set, clear } => {
                let either = held(flag).map(|(flag, _)| Holding::Either {
                    flag,
                    set: held(set),
                    clear: held(clear),
                });
                let only = held(set).or(held(clear)).map(Holding::One);
                (either.or(only), [set, clear])
            }
        };
        let holding = holding.or_else(|| {
            let cell = tree.cells.get(*cells.last()? as usize)?;
            let base = match symbol.holds {
                Holds::Cell(_) => symbol.base,
                Holds::Either { .. } => cell.base,
            };
            Some(Holding::Constant(cell.initial.clone(), base))
        });
        Variable {
            name: symbol.name.clone(),
            type_name: symbol.type_name.clone(),
            values: symbol.values.clone(),
            is_watched: cells.iter().any(|cell| watched.contains(cell)),
            holding: holding.unwrap_or(Holding::Constant(Value::Int(0), Base::Bool)),
        }
    };
    tree.symbols.iter().map(variable).collect()
}

/// The cells that PRINT shows.
fn watch(body: &[Stmt], cells: &mut HashSet<u32>) {
    for stmt in body {
        match &stmt.kind {
            StmtKind::Print(_, shown) => of_print(shown, cells),
            StmtKind::If(arms, or) => {
                arms.iter().for_each(|(_, body)| watch(body, cells));
                watch(or, cells);
            }
            StmtKind::Case(_, arms, or) => {
                arms.iter().for_each(|(_, body)| watch(body, cells));
                watch(or, cells);
            }
            StmtKind::While(_, body) | StmtKind::Repeat(body, _) => watch(body, cells),
            StmtKind::For(turns) => watch(&turns.body, cells),
            _ => {}
        }
    }
}

fn of_print(shown: &Expr, cells: &mut HashSet<u32>) {
    if let ExprKind::Read(place) = &shown.kind
        && place.root == Root::Static
        && place.indices.is_empty()
    {
        cells.insert(place.offset);
    }
}

impl Seat {
    /// What the board calls it; a timer by its number.
    fn address(self, timers: &[u8]) -> Option<Address> {
        let timer = |index: usize| timers.get(index).copied().filter(|&n| n > 0);
        Some(match self {
            Seat::At(address) => address,
            Seat::Timer(index) => Address::TimerQ(timer(index)?),
            Seat::Elapsed(index) => Address::Elapsed(timer(index)?),
            Seat::Now => return None,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bits_are_values_of_their_type() {
        for (bits, base, shown) in [
            (1, Base::Bool, "TRUE"),
            (-5, Base::Int, "-5"),
            (-1, Base::Udint, "4294967295"),
            (-1, Base::Dword, "16#FFFFFFFF"),
            (0x3FC0_0000, Base::Real, "1.5"),
            (1500, Base::Time, "T#1s500ms"),
            (-1, Base::Date, "D#11761191-01-20"),
        ] {
            assert_eq!(of_bits(bits, base).shown(base), shown);
        }
    }
}
