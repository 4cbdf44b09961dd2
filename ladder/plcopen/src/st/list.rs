//! A body in Instruction List as Structured Text: what stands beside bodies in other languages.
//!
//! The accumulator is an expression that grows from line to line. What stores or branches gets it as it is; where it is
//! used again, it is the variable that it was stored in, or one of the compiler's own.
//!
//! - `jumps`: jumps to a label below; `lines`: a body as instructions; `operators`: those of the norm, and what they are in Structured Text
//!
//! Owns what the norm's operators do. Makers' words are those of projects that are in Instruction List alone.

mod jumps;
mod lines;
mod operators;

use super::Written;
use super::sentences::{Piece, Sentences, piece};
use crate::found::{Found, span};
use crate::project::{Pou, Variable};
use crate::text::Text;
use lines::{Line, lines};
use operators::{Binary, Value};
use roxmltree::Node;
use std::collections::{HashMap, HashSet};
use unoclp_lang::{Code, Span, Word};

/// What a list is, and how it is told that it cannot be imported.
pub(crate) struct Role {
    /// Who a message is about, and what cannot be imported follow it.
    pub code: Code,
    pub who: Word,
}

/// Writes the body of a unit; what is wrong with it is told.
pub(crate) fn write(
    xml: &str,
    pou: &Pou<'_, '_>,
    body: Node<'_, '_>,
    globals: &[Variable],
    found: &mut Found,
) -> Written {
    let role = Role {
        code: Code::XmlMixed,
        who: (*pou.name).into(),
    };
    statements(xml, (pou, role), body, globals, found)
}

/// Writes a list within this unit as statements.
pub(crate) fn statements(
    xml: &str,
    (pou, role): (&Pou<'_, '_>, Role),
    body: Node<'_, '_>,
    globals: &[Variable],
    found: &mut Found,
) -> Written {
    let (source, text) = written(xml, body);
    let lines = lines(&text);
    let mut list = List::new(&source, &lines, (pou, role), globals, found);
    list.all();
    Written {
        variables: list.added,
        pieces: list.sentences.pieces(),
    }
}

/// Writes a list within this unit as the expression that the accumulator is in the end; none where it does something, or
/// where something is wrong, which is told.
pub(crate) fn expression(
    xml: &str,
    (pou, role): (&Pou<'_, '_>, Role),
    body: Node<'_, '_>,
    globals: &[Variable],
    found: &mut Found,
) -> Option<Vec<Piece>> {
    let (source, text) = written(xml, body);
    let lines = lines(&text);
    let mut list = List::new(&source, &lines, (pou, role), globals, found);
    list.is_expression = true;
    list.all()?;
    match list.holds.take() {
        Some(value) => Some(value.pieces.into()),
        None => list.refuse(span(body), ("an empty body", "um corpo vazio").into()),
    }
}

/// The text of a body, and the same without its comments.
fn written(xml: &str, body: Node<'_, '_>) -> (Text, String) {
    let mut source = Text::default();
    source.body(xml, body);
    let text = lines::without_comments(&source.text);
    (source, text)
}

/// A body on its way.
struct List<'l> {
    role: Role,
    /// Whether it is an expression, which does nothing.
    is_expression: bool,
    source: &'l Text,
    lines: &'l [Line<'l>],
    at: usize,
    /// Names that are taken, in capitals.
    taken: HashSet<String>,
    /// The types of variables, by their names in capitals.
    kinds: HashMap<String, String>,
    /// The lines of each label.
    labels: HashMap<String, Vec<usize>>,
    /// The variables that say where to jump, by the labels.
    jumps: HashMap<String, String>,
    /// The variables that hold the accumulator at labels where it is used, by their lines.
    carried: HashMap<usize, String>,
    /// The labels to which a way leads that holds nothing, or nothing of a known type.
    lost: HashSet<usize>,
    /// Nothing comes here but by a label.
    has_left: bool,
    sentences: Sentences,
    added: Vec<(String, String, Span)>,
    /// The accumulator.
    holds: Option<Value>,
    /// What waits for `)`: what stood before it, and the operation.
    waiting: Vec<(Value, Binary)>,
    found: &'l mut Found,
}

impl<'l> List<'l> {
    fn new(
        source: &'l Text,
        lines: &'l [Line<'l>],
        (pou, role): (&Pou<'_, '_>, Role),
        globals: &[Variable],
        found: &'l mut Found,
    ) -> List<'l> {
        let mut labels: HashMap<String, Vec<usize>> = HashMap::new();
        for (at, line) in lines.iter().enumerate() {
            if line.is_label {
                labels.entry(line.word.to_uppercase()).or_default().push(at);
            }
        }
        let variables = globals.iter().chain(&pou.variables);
        let mut kinds: HashMap<String, String> = variables
            .map(|own| (own.name.to_uppercase(), own.kind.clone()))
            .collect();
        if pou.kind == "function" {
            kinds.insert(pou.name.to_uppercase(), super::units::returns(pou));
        }
        let mut taken: HashSet<String> = kinds.keys().cloned().collect();
        taken.insert(pou.name.to_uppercase());
        List {
            role,
            is_expression: false,
            source,
            lines,
            at: 0,
            taken,
            kinds,
            labels,
            jumps: HashMap::new(),
            carried: HashMap::new(),
            lost: HashSet::new(),
            has_left: false,
            sentences: Sentences::default(),
            added: Vec::new(),
            holds: None,
            waiting: Vec::new(),
            found,
        }
    }

    /// Reads all lines; none where something is wrong: what follows it would be told because of this.
    fn all(&mut self) -> Option<()> {
        for (at, line) in self.lines.iter().enumerate() {
            self.at = at;
            self.line(line)?;
            if self.is_expression && (line.is_label || !self.sentences.is_empty()) {
                let word = line.word;
                let what = (format!("`{word}` in IL"), format!("`{word}` em IL"));
                return self.refuse(self.span(line), what.into());
            }
        }
        match self.lines.last() {
            Some(last) if !self.waiting.is_empty() => {
                self.refuse(self.span(last), ("`(` with no `)`", "`(` sem `)`").into())
            }
            _ => Some(()),
        }
    }

    fn span(&self, line: &Line<'_>) -> Span {
        self.source.span(line.at)
    }

    fn refuse<T>(&mut self, at: Span, what: Word) -> Option<T> {
        let who = self.role.who.clone();
        self.found.tell_at(self.role.code, at, [who, what]);
        None
    }

    /// An operand of the list as a value.
    fn operand(&mut self, line: &Line<'_>) -> Option<Value> {
        match line.operands.first() {
            Some((text, at)) => Some(Value::plain(text, self.source.span(*at))),
            None => self.lacks(line),
        }
    }

    fn lacks<T>(&mut self, line: &Line<'_>) -> Option<T> {
        let word = line.word;
        let en = format!("`{word}` without an operand");
        let pt = format!("`{word}` sem operando");
        self.refuse(self.span(line), (en, pt).into())
    }

    /// What the accumulator holds, which is used up.
    fn held(&mut self, line: &Line<'_>) -> Option<Value> {
        let held = self.holds.take();
        held.or_else(|| {
            let word = line.word;
            let en = format!("`{word}` with no LD before it");
            let pt = format!("`{word}` sem um LD antes");
            self.refuse(self.span(line), (en, pt).into())
        })
    }

    /// Whether the next instruction uses the accumulator.
    fn is_used(&self) -> bool {
        let next = self.lines.get(self.at + 1);
        next.is_some_and(|next| {
            let word = next.word.to_uppercase();
            !next.is_label && !matches!(&*word, "LD" | "LDN" | "CAL" | "JMP" | "RET")
        })
    }

    /// The accumulator as a condition. It stays, whatever is done then to this variable; to any where none is named.
    fn condition(&mut self, line: &Line<'_>, changes: Option<&str>) -> Option<Value> {
        let value = self.held(line)?;
        let is_kept = changes.is_some_and(|variable| value.is_kept_over(variable));
        if is_kept || !self.is_used() {
            self.holds = value.is_simple().then(|| value.clone());
            return Some(value);
        }
        let at = self.span(line);
        let name = self.own("acc", "BOOL", at);
        let mut stores = vec![piece(&format!("{name} := "), at)];
        stores.extend(value.pieces);
        self.sentences.add(stores);
        let own = Value::plain(&name, at);
        self.holds = Some(own.clone());
        Some(own)
    }

    /// A variable of the compiler's own.
    fn own(&mut self, what: &str, kind: &str, at: Span) -> String {
        let mut count = self.added.len() + 1;
        let mut name = format!("{what}_{count}");
        while !self.taken.insert(name.to_uppercase()) {
            count += 1;
            name = format!("{what}_{count}");
        }
        self.added.push((name.clone(), kind.to_owned(), at));
        name
    }

    /// What one line does; none where something is wrong, which is told.
    fn line(&mut self, line: &Line<'_>) -> Option<()> {
        let at = self.span(line);
        let word = line.word.to_uppercase();
        if line.is_label {
            self.land(line, &word);
            return Some(());
        }
        if let Some(operation) = operators::binary(&word) {
            return self.operation(line, operation);
        }
        match &*word {
            ")" => {
                let inner = self.held(line)?;
                let Some((outer, operation)) = self.waiting.pop() else {
                    return self.refuse(at, ("`)` with no `(`", "`)` sem `(`").into());
                };
                self.holds = Some(outer.with(operation, inner, at));
            }
            "LD" => self.holds = Some(self.operand(line)?),
            "LDN" => self.holds = Some(self.operand(line)?.inverted(at)),
            "NOT" => self.holds = Some(self.held(line)?.inverted(at)),
            "ST" | "STN" => self.store(line, word == "STN")?,
            "S" | "R" => {
                let Some((target, place)) = line.operands.first() else {
                    return self.lacks(line);
                };
                let value = self.condition(line, Some(target))?;
                let truth = if word == "S" { "TRUE" } else { "FALSE" };
                let place = self.source.span(*place);
                let does = vec![piece(&format!("{target} := {truth}"), place)];
                self.sentences.only(value.pieces.into(), does);
            }
            "CAL" | "CALC" | "CALCN" => {
                let Some((block, place)) = line.operands.first() else {
                    return self.lacks(line);
                };
                let place = self.source.span(*place);
                let mut call = vec![piece(&format!("{block}("), place)];
                call.extend(
                    line.given
                        .map(|(text, at)| piece(text, self.source.span(at))),
                );
                call.push(piece(")", place));
                self.branch(line, &word, "CAL", call)?;
            }
            "RET" | "RETC" | "RETCN" => {
                self.branch(line, &word, "RET", vec![piece("RETURN", at)])?;
            }
            "JMP" | "JMPC" | "JMPCN" => self.jump(line, &word)?,
            "IN" | "CU" | "CD" | "CLK" | "PT" | "PV" | "S1" | "R1" => {
                let Some((block, place)) = line.operands.first() else {
                    return self.lacks(line);
                };
                let place = self.source.span(*place);
                let value = self.held(line)?;
                let is_preset = matches!(&*word, "PT" | "PV");
                let mut does = match is_preset {
                    true => vec![piece(&format!("{block}.{word} := "), place)],
                    false => vec![piece(&format!("{block}({word} := "), place)],
                };
                does.extend(value.pieces);
                if !is_preset {
                    does.push(piece(")", place));
                }
                self.sentences.add(does);
            }
            _ => self.function(line)?,
        }
        Some(())
    }

    fn operation(&mut self, line: &Line<'_>, operation: Binary) -> Option<()> {
        let at = self.span(line);
        let left = self.held(line)?;
        if line.opens {
            self.waiting.push((left, operation));
            let first = line.operands.first();
            self.holds = first.map(|(text, at)| Value::plain(text, self.source.span(*at)));
            return Some(());
        }
        self.operand(line)?;
        let mut value = left;
        for (text, place) in &line.operands {
            let right = Value::plain(text, self.source.span(*place));
            value = value.with(operation, right, at);
        }
        self.holds = Some(value);
        Some(())
    }

    fn store(&mut self, line: &Line<'_>, negated: bool) -> Option<()> {
        let Some((target, place)) = line.operands.first() else {
            return self.lacks(line);
        };
        let place = self.source.span(*place);
        let value = self.held(line)?;
        let keeps = value.is_kept_over(target).then(|| value.clone());
        let stored = Value::plain(target, place);
        let mut does = vec![piece(&format!("{target} := "), place)];
        let (value, stored) = match negated {
            true => (value.inverted(place), stored.inverted(place)),
            false => (value, stored),
        };
        does.extend(value.pieces);
        self.sentences.add(does);
        self.holds = Some(keeps.unwrap_or(stored));
        Some(())
    }

    /// What is done always, or where the accumulator says so: by C and N after the operator.
    fn branch(
        &mut self,
        line: &Line<'_>,
        word: &str,
        operator: &str,
        does: Vec<Piece>,
    ) -> Option<()> {
        let at = self.span(line);
        if word == operator {
            self.holds = None;
            self.has_left = operator == "RET";
            self.sentences.add(does);
            return Some(());
        }
        let changes = (operator != "CAL").then_some("");
        let mut value = self.condition(line, changes)?;
        if word.ends_with('N') {
            value = value.inverted(at);
        }
        self.sentences.only(value.pieces.into(), does);
        Some(())
    }

    /// A function: of the accumulator and what stands behind it, or of what it names itself.
    fn function(&mut self, line: &Line<'_>) -> Option<()> {
        let at = self.span(line);
        let mut call = vec![piece(&format!("{}(", line.word), at)];
        match line.given {
            Some((text, place)) => call.push(piece(text, self.source.span(place))),
            None => {
                call.extend(self.held(line)?.pieces);
                for (text, place) in &line.operands {
                    call.push(piece(", ", at));
                    call.push(piece(text, self.source.span(*place)));
                }
            }
        }
        call.push(piece(")", at));
        self.holds = Some(Value::whole(call));
        Some(())
    }
}
