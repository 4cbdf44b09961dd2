//! Lines of Instruction List as expressions and statements: loads, operations, comparisons and stores, without jumps and
//! calls.

use crate::comments::without;

/// The most lines of a body.
const MOST: usize = 2_000;

/// What is in the accumulator, and what has been put aside by `(`.
struct Machine {
    now: String,
    aside: Vec<(String, &'static str, bool)>,
    statements: Vec<String>,
    /// Whether what is in the accumulator would now be another value: a statement has changed a variable of it.
    stale: bool,
}

/// The expression that a list leaves in the accumulator.
///
/// # Errors
/// The word that no expression has.
pub(super) fn expression(text: &str) -> Result<String, String> {
    let machine = run(text)?;
    match machine.statements.first() {
        Some(first) => Err(first.clone()),
        None if machine.now.is_empty() => Err("LD".to_owned()),
        None => Ok(machine.now),
    }
}

/// The statements that a list makes.
///
/// # Errors
/// The word that no statement has.
pub(super) fn statements(text: &str) -> Result<Vec<String>, String> {
    Ok(run(text)?.statements)
}

/// The operator between two operands, and whether it changes the second.
fn operator(word: &str) -> Option<(&'static str, bool)> {
    Some(match word {
        "AND" | "&" => (" AND ", false),
        "ANDN" | "&N" => (" AND ", true),
        "OR" => (" OR ", false),
        "ORN" => (" OR ", true),
        "XOR" => (" XOR ", false),
        "XORN" => (" XOR ", true),
        "ADD" => (" + ", false),
        "SUB" => (" - ", false),
        "MUL" => (" * ", false),
        "DIV" => (" / ", false),
        "MOD" => (" MOD ", false),
        "GT" => (" > ", false),
        "GE" => (" >= ", false),
        "EQ" => (" = ", false),
        "NE" => (" <> ", false),
        "LE" => (" <= ", false),
        "LT" => (" < ", false),
        _ => return None,
    })
}

fn run(text: &str) -> Result<Machine, String> {
    let mut machine = Machine {
        now: String::new(),
        aside: Vec::new(),
        statements: Vec::new(),
        stale: false,
    };
    let mut lines = 0;
    for line in without(text).lines() {
        let line = line.trim().trim_end_matches(';').trim_end();
        if line.is_empty() {
            continue;
        }
        lines += 1;
        if lines > MOST {
            return Err(line.to_owned());
        }
        let (word, operand) = match line.find([' ', '\t', '(']) {
            Some(at) => (&line[..at], line[at..].trim()),
            None => (line, ""),
        };
        machine
            .line(&word.to_ascii_uppercase(), operand)
            .ok_or(word)?;
    }
    match machine.aside.is_empty() {
        true => Ok(machine),
        false => Err("(".to_owned()),
    }
}

impl Machine {
    fn line(&mut self, word: &str, operand: &str) -> Option<()> {
        if self.stale && !matches!(word, "LD" | "LDN") {
            return None;
        }
        self.stale = false;
        if let Some((operator, inverts)) = operator(word) {
            if let Some(first) = operand.strip_prefix('(') {
                let before = std::mem::take(&mut self.now);
                self.aside.push((before, operator, inverts));
                self.now = first.trim().to_owned();
                return Some(());
            }
            self.apply(operator, inverts, operand);
            return (!operand.is_empty()).then_some(());
        }
        match (word, operand) {
            (")", "") => {
                let (before, operator, inverts) = self.aside.pop()?;
                let own = std::mem::replace(&mut self.now, before);
                self.apply(operator, inverts, &format!("({own})"));
            }
            ("NOT", "") => self.now = format!("NOT ({})", self.now),
            (_, "") => return None,
            (_, operand) if operand.starts_with('(') => return None,
            ("LD", operand) => self.now = operand.to_owned(),
            ("LDN", operand) => self.now = format!("NOT {operand}"),
            ("ST", operand) => {
                let now = std::mem::replace(&mut self.now, operand.to_owned());
                self.statements.push(format!("{operand} := {now}"));
            }
            ("STN", operand) => {
                let does = format!("{operand} := NOT ({})", self.now);
                self.does(operand, does);
            }
            ("S", operand) => self.when(operand, "TRUE"),
            ("R", operand) => self.when(operand, "FALSE"),
            _ => return None,
        }
        (!self.now.is_empty()).then_some(())
    }

    fn apply(&mut self, operator: &str, inverts: bool, operand: &str) {
        let not = if inverts { "NOT " } else { "" };
        self.now = format!("({}){operator}{not}{operand}", self.now);
    }

    fn when(&mut self, operand: &str, value: &str) {
        let does = format!("IF {} THEN {operand} := {value}; END_IF", self.now);
        self.does(operand, does);
    }

    /// A statement that changes this variable.
    fn does(&mut self, operand: &str, statement: String) {
        let is_word = |c: char| c.is_alphanumeric() || matches!(c, '_' | '.' | '%');
        let mut words = self.now.split(|c| !is_word(c));
        self.stale = words.any(|word| word.eq_ignore_ascii_case(operand));
        self.statements.push(statement);
    }
}
