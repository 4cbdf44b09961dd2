//! A chart in Structured Text.

use super::{Body, Chart, Condition};
use std::fmt::Write as _;

impl Chart {
    /// The name of an action.
    pub fn action(&self, number: usize) -> String {
        match number.checked_sub(self.variables) {
            None => format!("v{number}"),
            Some(body) => format!("a{body}"),
        }
    }

    /// As a program, or as a function block and a program that calls it.
    pub fn text(&self, is_block: bool) -> String {
        let mut text = String::new();
        self.write(&mut text, is_block);
        text
    }

    fn write(&self, text: &mut String, is_block: bool) {
        let (head, end) = match is_block {
            true => ("FUNCTION_BLOCK Chart", "END_FUNCTION_BLOCK"),
            false => ("PROGRAM main", "END_PROGRAM"),
        };
        let vars = match is_block {
            true => "VAR_INPUT i1, i2, i3, i4 : BOOL; END_VAR\nVAR",
            false => {
                "VAR i1 AT %IX1 : BOOL; i2 AT %IX2 : BOOL; i3 AT %IX3 : BOOL; i4 AT %IX4 : BOOL;"
            }
        };
        let _ = writeln!(text, "{head}\n{vars} x : INT;");
        for number in 0..self.variables {
            let _ = writeln!(text, "v{number} : BOOL;");
        }
        for number in 0..self.bodies.len() {
            let _ = writeln!(
                text,
                "n{number} : INT; b{number} : BOOL; e{number} : R_TRIG; t{number} : TON;"
            );
        }
        let _ = writeln!(text, "END_VAR");
        for (number, does) in self.steps.iter().enumerate() {
            let word = match self.initial.contains(&number) {
                true => "INITIAL_STEP",
                false => "STEP",
            };
            let _ = write!(text, "{word} s{number}:");
            for (action, qualifier, time) in does {
                let name = self.action(*action);
                let _ = match is_timed(qualifier) {
                    true => write!(text, " {name}({qualifier}, T#{time}ms);"),
                    false => write!(text, " {name}({qualifier});"),
                };
            }
            let _ = writeln!(text, " END_STEP");
        }
        for transition in &self.transitions {
            let list = |steps: &[usize]| {
                let names: Vec<String> = steps.iter().map(|step| format!("s{step}")).collect();
                match names.len() {
                    1 => names.concat(),
                    _ => format!("({})", names.join(", ")),
                }
            };
            let priority = transition.priority;
            let priority = priority.map_or(String::new(), |n| format!("(PRIORITY := {n}) "));
            let _ = writeln!(
                text,
                "TRANSITION {priority}FROM {} TO {} := {}; END_TRANSITION",
                list(&transition.from),
                list(&transition.to),
                condition(&transition.condition)
            );
        }
        for (number, body) in self.bodies.iter().enumerate() {
            let name = format!("a{number}");
            let does = match body {
                Body::Counts => format!("n{number} := n{number} + 1;"),
                Body::Shows => format!("b{number} := {name}.Q;"),
                Body::Edge => format!(
                    "e{number}(CLK := {name}.Q); IF e{number}.Q THEN n{number} := n{number} + 1; END_IF;"
                ),
                Body::Timer => {
                    format!("t{number}(IN := {name}.Q, PT := T#30ms); b{number} := t{number}.Q;")
                }
                Body::Shares => format!("x := (x * 3 + {}) MOD 1000;", number + 1),
                Body::Copies(input) => format!("b{number} := i{};", input + 1),
            };
            let _ = writeln!(text, "ACTION {name}: {does} END_ACTION");
        }
        let _ = writeln!(text, "{end}");
        if is_block {
            text.push_str(
                "PROGRAM main VAR c : Chart; END_VAR\nc(i1 := %IX1, i2 := %IX2, i3 := %IX3, i4 := %IX4);\nEND_PROGRAM\n",
            );
        }
    }
}

pub(super) fn is_timed(qualifier: &str) -> bool {
    matches!(qualifier, "L" | "D" | "SD" | "DS" | "SL")
}

fn condition(of: &Condition) -> String {
    let not = |is: bool| if is { "" } else { "NOT " };
    match of {
        Condition::Input(input, is) => format!("{}i{}", not(*is), input + 1),
        Condition::Active(step, is) => format!("{}s{step}.X", not(*is)),
        Condition::Time(step, ms) => format!("s{step}.T >= T#{ms}ms"),
        Condition::Count(body, count) => format!("n{body} >= {count}"),
        Condition::And(a, b) => format!("({} AND {})", condition(a), condition(b)),
        Condition::Or(a, b) => format!("({} OR {})", condition(a), condition(b)),
        Condition::True => "TRUE".to_owned(),
    }
}
