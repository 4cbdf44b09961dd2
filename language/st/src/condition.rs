//! A condition of Structured Text over values that somebody else has, and whether it holds.
//!
//! Owns that way from a text to an answer. Must not know whose the values are.

use crate::{check, is_word, parser};
use unoclp_core::Board;
use unoclp_text::diagnostics::{Found, Told};
use unoclp_tree::run::Machine;
use unoclp_tree::{Base, Tree, Value};

/// A condition whose names and types have been checked.
#[derive(Clone, Debug)]
pub struct Condition {
    tree: Tree,
    reads: Vec<(usize, u32)>,
    result: u32,
}

/// Reads a condition over these names, each of which may have points in it: `tank.level > 950 AND NOT drain.open`.
///
/// # Errors
/// What is wrong with the text; places count from its first byte.
pub fn condition(text: &str, names: &[(String, Base)], board: Board) -> Result<Condition, Told> {
    let mut found = Found::default();
    let node = parser::expression(text, &mut found);
    let asked =
        node.and_then(|node| check::condition::condition(text, node, names, board, &mut found));
    match asked.filter(|_| !found.has_errors()) {
        Some((tree, reads, result)) => Ok(Condition {
            tree,
            reads,
            result,
        }),
        None => Err(found.finish()),
    }
}

/// Whether a variable can be called so: a letter, then letters, digits and single underscores, and no word of the language.
pub fn is_name(text: &str) -> bool {
    let is_sign = |sign: char| sign.is_ascii_alphanumeric() || sign == '_';
    text.starts_with(|first: char| first.is_ascii_alphabetic())
        && text.chars().all(is_sign)
        && !text.contains("__")
        && !text.ends_with('_')
        && !is_word(&text.to_ascii_uppercase())
}

impl Condition {
    /// The names that it reads, by their numbers in the list that it was checked against.
    pub fn reads(&self) -> impl Iterator<Item = usize> + '_ {
        self.reads.iter().map(|(name, _)| *name)
    }
}

/// A condition that is asked again and again; it is computed again only where a value that it reads has changed.
#[derive(Debug)]
pub struct Judge<'c> {
    condition: &'c Condition,
    machine: Machine<'c>,
    seen: Vec<Value>,
    holds: Option<bool>,
}

impl<'c> Judge<'c> {
    /// One that has not been asked yet.
    pub fn new(condition: &'c Condition) -> Judge<'c> {
        Judge {
            condition,
            machine: Machine::new(&condition.tree),
            seen: vec![Value::Int(0); condition.reads.len()],
            holds: None,
        }
    }

    /// Whether it holds with these whole numbers, each by the number of its name; of BOOL 0 and 1.
    pub fn holds(&mut self, value: impl Fn(usize) -> i64) -> bool {
        self.holds_of(|name| Value::Int(value(name).into()))
    }

    /// Whether it holds with these values, each by the number of its name and of the type that the name has: of BOOL and whole
    /// numbers [`Value::Int`], of REAL [`Value::Real`].
    pub fn holds_of(&mut self, value: impl Fn(usize) -> Value) -> bool {
        let mut changed = self.holds.is_none();
        for ((name, cell), seen) in self.condition.reads.iter().zip(&mut self.seen) {
            let now = value(*name);
            if changed || now != *seen {
                changed = true;
                self.machine.set_cell(*cell, now.clone());
                *seen = now;
            }
        }
        if changed {
            let ended = self.machine.scan(0).is_ok();
            let result = self.machine.cell(self.condition.result);
            self.holds = Some(ended && result.is_true());
        }
        self.holds == Some(true)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use unoclp_text::diagnostics::Lang;

    fn names() -> Vec<(String, Base)> {
        let name = |name: &str, base| (name.to_owned(), base);
        vec![
            name("tank.level", Base::Dint),
            name("k1.closed", Base::Bool),
            name("k2.closed", Base::Bool),
        ]
    }

    fn holds(text: &str, values: [i64; 3]) -> bool {
        let condition = condition(text, &names(), Board::PC).unwrap();
        Judge::new(&condition).holds(|name| values[name])
    }

    #[test]
    fn a_condition_holds_as_structured_text_says() {
        assert!(holds("k1.closed AND K2.Closed", [0, 1, 1]));
        assert!(!holds("k1.closed AND k2.closed", [0, 1, 0]));
        assert!(holds("tank.level > 950 (* full *)", [951, 0, 0]));
        assert!(holds(
            "ABS(tank.level - 500) <= 20 OR k1.closed",
            [480, 0, 0]
        ));
        assert!(holds("TRUE", [0, 0, 0]));
    }

    #[test]
    fn a_condition_reads_reals_beside_whole_numbers() {
        let names = [
            ("oven.heat".to_owned(), Base::Real),
            ("oven.step".to_owned(), Base::Dint),
        ];
        let text = "oven.heat > 80.0 AND oven.step = 3 OR DINT_TO_REAL(oven.step) * 0.5 < oven.heat - 100.0";
        let condition = condition(text, &names, Board::PC).unwrap();
        let mut judge = Judge::new(&condition);
        for (heat, step, holds) in [
            (80.0, 3, false),
            (80.5, 3, true),
            (80.5, 4, false),
            (101.5, 4, false),
            (102.5, 4, true),
            (-1.0, 3, false),
        ] {
            let value = |name| match name {
                0 => Value::Real(heat),
                _ => Value::Int(step),
            };
            assert_eq!(judge.holds_of(value), holds, "{heat} {step}");
        }
        // A whole number does not become a REAL by itself.
        assert!(super::condition("oven.heat > oven.step", &names, Board::PC).is_err());
    }

    #[test]
    fn what_changes_is_seen_and_what_is_read_is_known() {
        let condition = condition("NOT k2.closed", &names(), Board::PC).unwrap();
        assert_eq!(condition.reads().collect::<Vec<_>>(), [2]);
        let mut judge = Judge::new(&condition);
        for closed in [0, 0, 1, 1, 0] {
            assert_eq!(judge.holds(|_| closed), closed == 0);
        }
    }

    #[test]
    fn what_is_no_condition_is_told() {
        for text in [
            "",
            "tank.level",
            "tank.levle > 1",
            "k1.closed; k2.closed",
            "k1.closed) OR (k2.closed",
            "k1.closed := TRUE; x",
            "TRUE END_PROGRAM PROGRAM x",
            "(* open",
            "k1.closed AND",
            "tank.level > TRUE",
            "tank.level.x > 3",
            "ton(IN := k1.closed)",
            "'",
            "#",
        ] {
            let told = condition(text, &names(), Board::PC).expect_err(text);
            let first = told.first().map(|told| told.message(Lang::Pt));
            assert!(first.is_some_and(|first| !first.is_empty()), "{text}");
        }
    }

    #[test]
    fn a_name_is_no_word_of_the_language() {
        for name in ["k1", "tank_2", "Pump"] {
            assert!(is_name(name), "{name}");
        }
        for name in ["", "1k", "k-1", "a__b", "a_", "if", "TON", "INT", "é", "#"] {
            assert!(!is_name(name), "{name}");
        }
    }
}
