//! Statements of Structured Text, and how they are written.
//!
//! Owns their form. Must not know instructions, nor what a place is called.

use super::expr::{Expr, Place, not, written};

#[derive(Clone, Debug, PartialEq)]
pub(super) enum Statement {
    /// Comments of the text that the program comes from.
    Comment(Vec<String>),
    /// A rung begins: what comes stands apart.
    Space,
    Assign(Place, Expr),
    /// An element of the array that begins with this register.
    AssignElement(u8, Expr, Expr),
    /// A call of the block that has this place, its inputs, and where its Q goes.
    Call(Place, Vec<(&'static str, Expr)>, Option<Place>),
    If(Expr, Vec<Statement>, Vec<Statement>),
    /// The cases of a number, each with its statements, and those of all others.
    Case(Expr, Vec<Vec<Statement>>, Vec<Statement>),
    Repeat(Vec<Statement>, Expr),
    Return,
}

/// Writes statements; `name` says what a place is called.
pub(super) fn lines(all: &[Statement], name: &dyn Fn(Place) -> String) -> String {
    let mut page = Page {
        text: String::new(),
        depth: 0,
        space: false,
        begins: false,
        name,
    };
    page.all(all);
    page.text
}

struct Page<'n> {
    text: String,
    depth: usize,
    /// Whether a rung has begun since the last line, and whether a part has.
    space: bool,
    begins: bool,
    name: &'n dyn Fn(Place) -> String,
}

impl Page<'_> {
    fn line(&mut self, line: &str) {
        if self.space && !self.begins {
            self.text.push('\n');
        }
        (self.space, self.begins) = (false, false);
        self.text.push_str(&"  ".repeat(self.depth));
        self.text.push_str(line);
        self.text.push('\n');
    }

    fn inner(&mut self, all: &[Statement]) {
        self.depth += 1;
        self.begins = true;
        self.all(all);
        self.depth -= 1;
        (self.space, self.begins) = (false, false);
    }

    fn all(&mut self, all: &[Statement]) {
        for statement in all {
            self.statement(statement);
        }
    }

    fn say(&self, expr: &Expr) -> String {
        written(expr, self.name)
    }

    fn statement(&mut self, statement: &Statement) {
        match statement {
            Statement::Comment(about) => about.iter().for_each(|about| self.line(&comment(about))),
            Statement::Space => self.space = true,
            Statement::Assign(to, value) => {
                self.line(&format!("{} := {};", (self.name)(*to), self.say(value)));
            }
            Statement::AssignElement(table, at, value) => {
                let to = Expr::Element(*table, Box::new(at.clone()));
                self.line(&format!("{} := {};", self.say(&to), self.say(value)));
            }
            Statement::Call(block, inputs, q) => {
                let inputs = inputs.iter();
                let inputs = inputs.map(|(input, value)| format!("{input} := {}", self.say(value)));
                let q = q.iter().map(|q| format!("Q => {}", (self.name)(*q)));
                let all: Vec<String> = inputs.chain(q).collect();
                let member = (self.name)(*block);
                let block = member.split('.').next().unwrap_or_default();
                self.line(&format!("{block}({});", all.join(", ")));
            }
            Statement::If(condition, then, otherwise) if then.is_empty() => {
                self.branch(&not(condition.clone()), otherwise, then);
            }
            Statement::If(condition, then, otherwise) => self.branch(condition, then, otherwise),
            Statement::Case(number, cases, others) => {
                self.line(&format!("CASE {} OF", self.say(number)));
                for (case, body) in cases.iter().enumerate() {
                    self.line(&format!("{case}:"));
                    self.inner(body);
                }
                self.line("ELSE");
                self.inner(others);
                self.line("END_CASE;");
            }
            Statement::Repeat(body, until) => {
                self.line("REPEAT");
                self.inner(body);
                self.line(&format!("UNTIL {} END_REPEAT;", self.say(until)));
            }
            Statement::Return => self.line("RETURN;"),
        }
    }

    fn branch(&mut self, condition: &Expr, then: &[Statement], otherwise: &[Statement]) {
        self.line(&format!("IF {} THEN", self.say(condition)));
        self.inner(then);
        if !otherwise.is_empty() {
            self.line("ELSE");
            self.inner(otherwise);
        }
        self.line("END_IF;");
    }
}

/// A comment on a line of its own; what would end it does not.
pub(super) fn comment(about: &str) -> String {
    if about.trim().is_empty() {
        return String::new();
    }
    let about = about.replace("(*", "( *").replace("*)", "* )");
    format!("(* {} *)", about.trim())
}

/// Each place that these statements read, write or call.
pub(super) fn places(all: &[Statement], see: &mut dyn FnMut(Place)) {
    for statement in all {
        match statement {
            Statement::Comment(_) | Statement::Space | Statement::Return => {}
            Statement::Assign(to, value) => {
                see(*to);
                within(value, see);
            }
            Statement::AssignElement(table, at, value) => {
                see(Place::Table(*table));
                within(at, see);
                within(value, see);
            }
            Statement::Call(block, inputs, q) => {
                see(*block);
                inputs.iter().for_each(|(_, value)| within(value, see));
                q.iter().for_each(|q| see(*q));
            }
            Statement::If(condition, then, otherwise) => {
                within(condition, see);
                places(then, see);
                places(otherwise, see);
            }
            Statement::Case(number, cases, others) => {
                within(number, see);
                cases.iter().for_each(|case| places(case, see));
                places(others, see);
            }
            Statement::Repeat(body, until) => {
                places(body, see);
                within(until, see);
            }
        }
    }
}

fn within(expr: &Expr, see: &mut dyn FnMut(Place)) {
    match expr {
        Expr::Place(place) => see(*place),
        Expr::Element(table, _) => see(Place::Table(*table)),
        _ => {}
    }
    expr.parts().into_iter().for_each(|part| within(part, see));
}
