//! Random conditions, written and drawn in each language.

use std::fmt::Write;
use unoclp_testing::Random;

/// A condition.
#[derive(Clone, Debug)]
pub(super) enum Expression {
    Variable(&'static str),
    Not(Box<Expression>),
    All(Vec<Expression>),
    Any(Vec<Expression>),
}

use Expression::{All, Any, Not, Variable};

impl Expression {
    /// One of these variables, nested up to so deep.
    pub(super) fn random(names: &[&'static str], depth: usize, random: &mut Random) -> Expression {
        if depth == 0 || random.percent(25) {
            return Variable(random.pick(names));
        }
        let inner = |random: &mut Random| Expression::random(names, depth - 1, random);
        let several =
            |random: &mut Random| (0..2 + random.below(2)).map(|_| inner(random)).collect();
        match random.below(5) {
            0 => Not(Box::new(inner(random))),
            1 | 2 => All(several(random)),
            _ => Any(several(random)),
        }
    }

    /// In Structured Text.
    pub(super) fn text(&self) -> String {
        let joined = |all: &[Expression], sign: &str| {
            let all: Vec<String> = all.iter().map(Expression::text).collect();
            format!("({})", all.join(sign))
        };
        match self {
            Variable(name) => (*name).to_owned(),
            Not(inner) => format!("NOT ({})", inner.text()),
            All(all) => joined(all, " AND "),
            Any(all) => joined(all, " OR "),
        }
    }

    /// In Instruction List: the lines that leave it in the accumulator.
    pub(super) fn list(&self) -> Vec<String> {
        let joined = |all: &[Expression], word: &str| {
            let mut lines = all[0].list();
            for operand in &all[1..] {
                match operand {
                    Variable(name) => lines.push(format!("{word} {name}")),
                    Not(inner) if matches!(**inner, Variable(_)) => {
                        lines.push(format!("{word}N {}", inner.text()));
                    }
                    operand => {
                        let mut inner = operand.list();
                        inner[0] = inner[0].replace("LD ", &format!("{word}( "));
                        lines.extend(inner);
                        lines.push(")".to_owned());
                    }
                }
            }
            lines
        };
        match self {
            Variable(name) => vec![format!("LD {name}")],
            Not(inner) => inner.list().into_iter().chain(["NOT".to_owned()]).collect(),
            All(all) => joined(all, "AND"),
            Any(all) => joined(all, "OR"),
        }
    }
}

/// A drawing on its way.
#[derive(Default)]
pub(super) struct Drawing {
    pub xml: String,
    last: u32,
    /// Where the next row stands.
    row: u32,
}

/// An output of an element.
pub(super) type From = (u32, &'static str);

/// The wires of a pin.
fn wires(from: &[From]) -> String {
    let mut wires = String::new();
    for (id, output) in from {
        let _ = match *output {
            "" => write!(wires, "<connection refLocalId=\"{id}\"/>"),
            output => write!(
                wires,
                "<connection refLocalId=\"{id}\" formalParameter=\"{output}\"/>"
            ),
        };
    }
    format!("<connectionPointIn>{wires}</connectionPointIn>")
}

impl Drawing {
    /// The number and the place of one more element.
    fn place(&mut self) -> (u32, String) {
        self.last += 1;
        self.row += 20;
        let (x, y) = (20 * self.last % 400, self.row);
        (self.last, format!("<position x=\"{x}\" y=\"{y}\"/>"))
    }

    pub(super) fn rail(&mut self) -> From {
        let (id, place) = self.place();
        let _ = writeln!(
            self.xml,
            "<leftPowerRail localId=\"{id}\">{place}<connectionPointOut/></leftPowerRail>"
        );
        (id, "")
    }

    pub(super) fn contact(&mut self, name: &str, negated: bool, from: &[From]) -> From {
        let (id, place) = self.place();
        let wires = wires(from);
        let _ = writeln!(
            self.xml,
            "<contact localId=\"{id}\" negated=\"{negated}\">{place}{wires}<connectionPointOut/><variable>{name}</variable></contact>"
        );
        (id, "")
    }

    pub(super) fn coil(&mut self, name: &str, from: &[From]) {
        let (id, place) = self.place();
        let wires = wires(from);
        let _ = writeln!(
            self.xml,
            "<coil localId=\"{id}\">{place}{wires}<connectionPointOut/><variable>{name}</variable></coil>"
        );
    }

    pub(super) fn value(&mut self, name: &str) -> From {
        let (id, place) = self.place();
        let _ = writeln!(
            self.xml,
            "<inVariable localId=\"{id}\">{place}<connectionPointOut/><expression>{name}</expression></inVariable>"
        );
        (id, "")
    }

    pub(super) fn variable(&mut self, name: &str, from: From) {
        let (id, place) = self.place();
        let wires = wires(&[from]);
        let _ = writeln!(
            self.xml,
            "<outVariable localId=\"{id}\">{place}{wires}<expression>{name}</expression></outVariable>"
        );
    }

    pub(super) fn block(
        &mut self,
        kind: &str,
        instance: Option<&str>,
        pins: &[(String, Vec<From>)],
        output: &'static str,
    ) -> From {
        let (id, place) = self.place();
        let instance = instance.map_or(String::new(), |name| format!(" instanceName=\"{name}\""));
        let pins: String = pins
            .iter()
            .map(|(name, from)| {
                format!(
                    "<variable formalParameter=\"{name}\">{}</variable>",
                    wires(from)
                )
            })
            .collect();
        let _ = writeln!(
            self.xml,
            "<block localId=\"{id}\" typeName=\"{kind}\"{instance}>{place}<inputVariables>{pins}</inputVariables><inOutVariables/><outputVariables><variable formalParameter=\"{output}\"><connectionPointOut/></variable></outputVariables></block>"
        );
        (id, output)
    }

    /// Contacts from these elements on; `negated`: its opposite.
    pub(super) fn contacts(
        &mut self,
        of: &Expression,
        negated: bool,
        from: Vec<From>,
    ) -> Vec<From> {
        match (of, negated) {
            (Variable(name), _) => vec![self.contact(name, negated, &from)],
            (Not(inner), _) => self.contacts(inner, !negated, from),
            (All(all), false) | (Any(all), true) => {
                let mut inner = all.iter();
                inner
                    .by_ref()
                    .fold(from, |from, of| self.contacts(of, negated, from))
            }
            (Any(all), false) | (All(all), true) => {
                let mut ways = Vec::new();
                for of in all {
                    ways.extend(self.contacts(of, negated, from.clone()));
                }
                ways
            }
        }
    }

    /// Blocks.
    pub(super) fn blocks(&mut self, of: &Expression) -> From {
        let (kind, all) = match of {
            Variable(name) => return self.value(name),
            Not(inner) => {
                let from = self.blocks(inner);
                return self.block("NOT", None, &[("IN".to_owned(), vec![from])], "OUT");
            }
            All(all) => ("AND", all),
            Any(all) => ("OR", all),
        };
        let pins = all.iter().enumerate().map(|(at, of)| {
            let from = self.blocks(of);
            (format!("IN{}", at + 1), vec![from])
        });
        let pins: Vec<_> = pins.collect();
        self.block(kind, None, &pins, "OUT")
    }
}
