//! Charts (B.1.6): steps, transitions, actions.
//!
//! `STEP`, `TRANSITION`, `ACTION`, `FROM` and `PRIORITY` are names elsewhere; where they begin a part of a chart, no
//! statement can stand.

use super::super::ast::{Chart, Node, NodeKind, Statement};
use super::super::token::Kind;
use super::super::words::Keyword;
use super::{Parsed, Parser, Told};
use unoclp_chart::{Action, Does, Name, Qualifier, Step, Transition};
use unoclp_text::diagnostics::{Code, Span};
use unoclp_tree::{UnitKind, Value};

const ELEMENT: (&str, &str) = (
    "a chart consists only of INITIAL_STEP, STEP, TRANSITION and ACTION; write statements in an ACTION, or in a PROGRAM of their own",
    "um SFC consiste só de INITIAL_STEP, STEP, TRANSITION e ACTION; escreva comandos em uma ACTION ou em um PROGRAM próprio",
);
const STEP: (&str, &str) = (
    "write a step like STEP name: action(N); END_STEP",
    "escreva uma etapa como STEP nome: ação(N); END_STEP",
);
const TRANSITION: (&str, &str) = (
    "write a transition like TRANSITION FROM a TO b := condition; END_TRANSITION",
    "escreva uma transição como TRANSITION FROM a TO b := condição; END_TRANSITION",
);
const ACTION: (&str, &str) = (
    "write an action like ACTION name: statements END_ACTION",
    "escreva uma ação como ACTION nome: comandos END_ACTION",
);

/// A part of a chart.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Element {
    Step,
    Transition,
    Action,
}

impl Parser<'_, '_> {
    fn word_ahead(&self, by: usize) -> &str {
        match self.ahead(by).kind {
            Kind::Word => self.slice(self.ahead(by).span),
            _ => "",
        }
    }

    fn is_word(&self, word: &str) -> bool {
        self.word_ahead(0).eq_ignore_ascii_case(word)
    }

    fn accept_word(&mut self, word: &str) -> bool {
        let is = self.is_word(word);
        if is {
            self.next();
        }
        is
    }

    /// The part of a chart that begins here.
    fn chart_element(&self) -> Option<Element> {
        if self.keyword() == Keyword::InitialStep {
            return Some(Element::Step);
        }
        let named = self.ahead(1).kind == Kind::Word && self.keyword_ahead(1) == Keyword::None;
        if self.keyword() != Keyword::None {
            return None;
        }
        if self.is_word("STEP") && named {
            return Some(Element::Step);
        }
        if self.is_word("ACTION") && named {
            return Some(Element::Action);
        }
        let priority =
            self.ahead(1).kind == Kind::Open && self.word_ahead(2).eq_ignore_ascii_case("PRIORITY");
        (self.is_word("TRANSITION") && (named || priority)).then_some(Element::Transition)
    }

    /// Whether a part of a chart begins or ends here.
    pub(super) fn ends_in_chart(&self) -> bool {
        let keyword = self.keyword();
        if self.in_chart {
            return keyword.ends_part_of_chart() || self.chart_element().is_some();
        }
        keyword == Keyword::InitialStep
    }

    /// Statements, or a chart.
    pub(super) fn body(&mut self, kind: UnitKind) -> (Vec<Statement>, Option<Chart>) {
        let mut body = Vec::new();
        if self.chart_element().is_none() {
            body = self.statements();
        }
        if self.chart_element().is_none() {
            return (body, None);
        }
        let at = self.token().span;
        if let Some(first) = body.first() {
            let written = self.short(first.span);
            self.told_place(written, first.span, STATEMENT, ELEMENT);
        }
        if kind == UnitKind::Function {
            let why = (
                "a function keeps no values between calls",
                "uma função não guarda valores entre chamadas",
            );
            let help = ("write a FUNCTION_BLOCK", "escreva um FUNCTION_BLOCK");
            let written = self.short(at);
            self.told_place(written, at, why, help);
        }
        self.in_chart = true;
        let chart = self.chart(at);
        self.in_chart = false;
        (body, (kind != UnitKind::Function).then_some(chart))
    }

    fn told_place(
        &mut self,
        written: String,
        at: Span,
        why: (&'static str, &'static str),
        help: (&'static str, &'static str),
    ) {
        let words = [written.into(), why.into(), help.into()];
        self.tell(Code::StChartPlace, at, words);
    }

    fn chart(&mut self, at: Span) -> Chart {
        let mut chart = Chart {
            steps: Vec::new(),
            transitions: Vec::new(),
            actions: Vec::new(),
            at,
        };
        let mut told = false;
        loop {
            while self.accept(Kind::Semicolon) {}
            let keyword = self.keyword();
            if self.is(Kind::End) || keyword.ends_unit() || keyword.begins_unit() {
                return chart;
            }
            let before = self.at;
            let read = match self.chart_element() {
                Some(Element::Step) => self.step(&mut chart),
                Some(Element::Transition) => self.transition(&mut chart),
                Some(Element::Action) => self.action(&mut chart),
                None => {
                    let span = self.token().span;
                    if !std::mem::replace(&mut told, true) {
                        let written = self.short(span);
                        self.told_place(written, span, STATEMENT, ELEMENT);
                    }
                    self.next();
                    self.skip_element();
                    Ok(())
                }
            };
            if read.is_err() {
                if self.at == before {
                    self.next();
                }
                self.skip_element();
            }
        }
    }

    /// Goes to where the next part of a chart may begin.
    fn skip_element(&mut self) {
        while !self.is(Kind::End) {
            let keyword = self.keyword();
            if keyword.ends_part_of_chart() {
                self.next();
                return;
            }
            if keyword.ends_unit() || keyword.begins_unit() || self.chart_element().is_some() {
                return;
            }
            self.next();
        }
    }

    /// The name of a step or an action, which others may use.
    fn declared_name(
        &mut self,
        what: (&str, &str),
        help: (&'static str, &'static str),
    ) -> Parsed<Name> {
        let name = self.chart_name(what, help);
        self.wrong_declarations |= name.is_err();
        name
    }

    fn chart_name(
        &mut self,
        what: (&str, &str),
        help: (&'static str, &'static str),
    ) -> Parsed<Name> {
        let name = self.name(what, help)?;
        Ok(Name {
            text: name.text,
            at: name.span,
        })
    }

    /// The end of a part of a chart.
    fn end_of(&mut self, end: Keyword, start: Span) -> Parsed<()> {
        if self.accept_keyword(end) {
            return Ok(());
        }
        if self.keyword().ends_part_of_chart() {
            let span = self.next().span;
            self.tell_other_word(span, end);
            return Ok(());
        }
        let written = self.short(start);
        self.tell(
            Code::StNotClosed,
            start,
            [written.into(), end.name().into()],
        );
        Err(Told)
    }

    fn step(&mut self, chart: &mut Chart) -> Parsed<()> {
        let initial = self.keyword() == Keyword::InitialStep;
        let start = self.next().span;
        let name = self.declared_name(("the name of the step", "o nome da etapa"), STEP)?;
        let mut step = Step {
            name,
            initial,
            does: Vec::new(),
        };
        let read = self.step_body(&mut step);
        // What is wrong within leaves its name known.
        chart.steps.push(step);
        read?;
        self.end_of(Keyword::EndStep, start)
    }

    fn step_body(&mut self, step: &mut Step<Node>) -> Parsed<()> {
        if !self.accept(Kind::Colon) {
            return Err(self.missing(("a `:`", "um `:`"), STEP));
        }
        loop {
            while self.accept(Kind::Semicolon) {}
            let is_name = match self.kind() {
                Kind::Address => true,
                Kind::Word => self.keyword() == Keyword::None && self.chart_element().is_none(),
                _ => false,
            };
            if !is_name {
                return Ok(());
            }
            let does = self.association()?;
            step.does.extend(does);
            if !self.accept(Kind::Semicolon) && !self.keyword().ends_part_of_chart() {
                return Err(self.missing(("`;`", "`;`"), STEP));
            }
        }
    }

    /// `action(N)`, `action(L, T#5s)`
    fn association(&mut self) -> Parsed<Option<Does<Node>>> {
        let span = self.next().span;
        let action = Name {
            text: self.slice(span).to_owned(),
            at: span,
        };
        let help = (
            "write the qualifier after the action: action(N);",
            "escreva o qualificador depois da ação: ação(N);",
        );
        if !self.accept(Kind::Open) {
            return Err(self.missing(("`(`", "`(`"), help));
        }
        let mut does = Does {
            action,
            qualifier: Qualifier::N,
            time: None,
        };
        if self.accept(Kind::Close) {
            return Ok(Some(does));
        }
        let at = self.token().span;
        let named = Qualifier::named(self.word_ahead(0));
        match named {
            Some(qualifier) => does.qualifier = qualifier,
            None => {
                let written = self.short(at);
                self.tell(Code::StQualifier, at, [written.into()]);
            }
        }
        self.next();
        if self.accept(Kind::Comma) {
            does.time = Some(self.expression()?);
        }
        if named.is_some_and(|qualifier| qualifier.is_timed() != does.time.is_some()) {
            self.told_time(&does, at);
            does.time = None;
        }
        self.expect(Kind::Close, ")", help)?;
        Ok(named.map(|_| does))
    }

    fn told_time(&mut self, does: &Does<Node>, at: Span) {
        let code = match does.qualifier.is_timed() {
            true => Code::StTimeMissing,
            false => Code::StTimeExtra,
        };
        let action = does.action.text.as_str();
        self.tell(code, at, [does.qualifier.name().into(), action.into()]);
    }

    fn transition(&mut self, chart: &mut Chart) -> Parsed<()> {
        let start = self.next().span;
        let mut name = None;
        let is_from = |by: usize, this: &Self| this.word_ahead(by).eq_ignore_ascii_case("FROM");
        // A transition may be called FROM.
        if self.is(Kind::Word) && (!is_from(0, self) || is_from(1, self)) {
            name = Some(self.chart_name(("a name", "um nome"), TRANSITION)?);
        }
        let mut priority = None;
        if self.accept(Kind::Open) {
            priority = Some(self.priority()?);
        }
        if !self.accept_word("FROM") {
            return Err(self.missing("FROM", TRANSITION));
        }
        let from = self.ends()?;
        if !self.accept_keyword(Keyword::To) {
            return Err(self.missing("TO", TRANSITION));
        }
        let to = self.ends()?;
        let at = start.to(self.behind());
        if !self.accept(Kind::Assign) {
            let told = match self.is(Kind::Equal) {
                true => {
                    let span = self.token().span;
                    self.tell(Code::StOtherWord, span, ["=".into(), ":=".into()]);
                    Told
                }
                false => self.missing("`:=`", TRANSITION),
            };
            // So that the steps that it joins are known to be joined.
            chart.transitions.push(Transition {
                name,
                priority,
                from,
                to,
                condition: Node {
                    kind: NodeKind::Wrong,
                    span: at,
                    height: 1,
                },
                at,
            });
            return Err(told);
        }
        let condition = self.expression();
        let wrong = condition.is_err();
        chart.transitions.push(Transition {
            name,
            priority,
            from,
            to,
            condition: condition.unwrap_or(Node {
                kind: NodeKind::Wrong,
                span: at,
                height: 1,
            }),
            at,
        });
        if wrong {
            return Err(Told);
        }
        if !self.accept(Kind::Semicolon) && self.keyword() != Keyword::EndTransition {
            return Err(self.missing(("`;`", "`;`"), TRANSITION));
        }
        self.end_of(Keyword::EndTransition, start)
    }

    /// `PRIORITY := 1)`
    fn priority(&mut self) -> Parsed<u32> {
        let help = (
            "write a priority like (PRIORITY := 1); the lowest number comes first",
            "escreva uma prioridade como (PRIORITY := 1); o menor número vem primeiro",
        );
        if !self.accept_word("PRIORITY") {
            return Err(self.missing("PRIORITY", help));
        }
        self.expect(Kind::Assign, ":=", help)?;
        let number = self.expression()?;
        let number = match &number.kind {
            NodeKind::Literal(_, Value::Int(number)) => u32::try_from(*number).ok(),
            _ => None,
        };
        let Some(number) = number else {
            return Err(self.missing(("a whole number", "um número inteiro"), help));
        };
        self.expect(Kind::Close, ")", help)?;
        Ok(number)
    }

    /// `a`, or `(a, b)`
    fn ends(&mut self) -> Parsed<Vec<Name>> {
        let what = ("the name of a step", "o nome de uma etapa");
        if !self.accept(Kind::Open) {
            return Ok(vec![self.chart_name(what, TRANSITION)?]);
        }
        let mut all = vec![self.chart_name(what, TRANSITION)?];
        while self.accept(Kind::Comma) {
            all.push(self.chart_name(what, TRANSITION)?);
        }
        self.expect(Kind::Close, ")", TRANSITION)?;
        Ok(all)
    }

    fn action(&mut self, chart: &mut Chart) -> Parsed<()> {
        let start = self.next().span;
        let name = self.declared_name(("the name of the action", "o nome da ação"), ACTION)?;
        let colon = self.accept(Kind::Colon);
        if !colon {
            self.missing(("a `:`", "um `:`"), ACTION);
        }
        let body = self.statements();
        chart.actions.push(Action { name, body });
        self.end_of(Keyword::EndAction, start)
    }
}

const STATEMENT: (&str, &str) = ("it is not a part of a chart", "não é uma parte de um SFC");
