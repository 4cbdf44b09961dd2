//! Programs, functions and blocks, and what stands around them.

use super::super::ast::{File, Name, Section, SpecKind, TypeSpec, UnitDecl};
use super::super::token::{Kind, Token};
use super::super::words::{Keyword, meant};
use super::{Parsed, Parser, Told};
use std::ops::Range;
use unoclp_text::diagnostics::{Code, Span};
use unoclp_tree::UnitKind;

impl Parser<'_, '_> {
    pub(super) fn file(&mut self) -> File {
        let mut file = self.units();
        if !file.order.is_empty() {
            file.put_in_order();
        }
        file
    }

    fn units(&mut self) -> File {
        let mut file = File {
            points: self.points(),
            ..File::default()
        };
        loop {
            while self.accept(Kind::Semicolon) {}
            let token = self.token();
            let before = self.at;
            let keyword = match self.keyword() {
                Keyword::None
                    if token.kind == Kind::Word
                        && !matches!(self.ahead(1).kind, Kind::Assign | Kind::Dot | Kind::Open) =>
                {
                    let keyword = meant(&self.slice(token.span).to_uppercase());
                    if keyword.begins_unit() || keyword.is_section() {
                        self.tell_other_word(token.span, keyword);
                        let at = self.at;
                        self.keywords[at] = keyword;
                    }
                    keyword
                }
                keyword => keyword,
            };
            match keyword {
                _ if token.kind == Kind::End => return file,
                Keyword::Type => self.types(&mut file.types),
                Keyword::VarGlobal => {
                    let vars = self.section();
                    file.globals.push(vars);
                }
                Keyword::Program | Keyword::OrganizationBlock => {
                    self.unit(UnitKind::Program, &mut file)
                }
                Keyword::Function => self.unit(UnitKind::Function, &mut file),
                Keyword::FunctionBlock => self.unit(UnitKind::Block, &mut file),
                Keyword::Configuration => self.configuration(&mut file),
                Keyword::DataBlock => {
                    let help = (
                        "declare its variables with VAR_GLOBAL … END_VAR",
                        "declare as variáveis dele com VAR_GLOBAL … END_VAR",
                    );
                    self.tell(
                        Code::StUnsupported,
                        token.span,
                        ["DATA_BLOCK".into(), help.into()],
                    );
                    self.dead = true;
                    return file;
                }
                keyword if keyword.ends_unit() => {
                    let written = self.short(token.span);
                    let opener = written.to_uppercase().replace("END_", "");
                    self.tell(
                        Code::StStrayEnd,
                        token.span,
                        [written.into(), opener.into()],
                    );
                    self.next();
                }
                _ if self.other_dialect() => return file,
                _ if self.headless_unit(&mut file) => {}
                _ => self.bare(&mut file),
            }
            if self.at == before {
                self.next();
            }
        }
    }

    /// A program without PROGRAM: variables and statements. After another unit they stand outside.
    fn bare(&mut self, file: &mut File) {
        let start = self.token().span;
        if !file.units.is_empty() {
            let written = self.short(start);
            self.tell(Code::StOutside, start, [written.into()]);
            while !self.is(Kind::End) && !self.keyword().begins_unit() {
                self.next();
            }
            return;
        }
        let name = Name {
            text: "main".to_owned(),
            span: start.empty(),
        };
        let mut unit = self.inside(UnitKind::Program, name, None, file);
        // Blocks and functions may stand between.
        if unit.vars.is_empty() && unit.body.is_empty() && unit.chart.is_none() {
            return;
        }
        unit.kind = UnitKind::Program;
        file.units.push(unit);
    }

    fn unit(&mut self, kind: UnitKind, file: &mut File) {
        let start = self.token().span;
        let end = match self.keyword() {
            Keyword::Program => Keyword::EndProgram,
            Keyword::OrganizationBlock => Keyword::EndOrganizationBlock,
            Keyword::Function => Keyword::EndFunction,
            _ => Keyword::EndFunctionBlock,
        };
        self.next();
        match self.foreign_code(kind, end) {
            Some(code) => self.foreign_unit(kind, code, end, file),
            None => self.unit_behind(kind, start, end, file),
        }
    }

    /// Where addresses stand.
    fn points(&self) -> Vec<Range<usize>> {
        let points = self.tokens.iter();
        let points = points.filter(|token| token.kind == Kind::Address);
        points.map(|token| token.span.range()).collect()
    }

    /// Code for another machine before the end of this unit, or what uses a unit above that has it.
    fn foreign_code(&self, kind: UnitKind, end: Keyword) -> Option<Span> {
        let rest = self.tokens.iter().zip(&self.keywords).skip(self.at);
        let mut unit = rest.take_while(|(_, word)| **word != end && !word.begins_unit());
        let may_use = !self.foreign.is_empty() && kind != UnitKind::Program;
        let uses = |token: &Token| {
            self.foreign
                .contains(&self.slice(token.span).to_uppercase())
        };
        let is_foreign = |token: &Token| match token.kind {
            Kind::ForeignCode => true,
            Kind::Word => may_use && uses(token),
            _ => false,
        };
        let found = unit.find(|(token, _)| is_foreign(token));
        found.map(|(token, _)| token.span)
    }

    /// Passes over a unit with code for another machine; only a program cannot do without.
    fn foreign_unit(&mut self, kind: UnitKind, code: Span, end: Keyword, file: &mut File) {
        let name = self.named(self.token().span);
        if kind == UnitKind::Program {
            self.tell(Code::StForeignCode, code, [name.text.as_str().into()]);
            self.wrong_declarations = true;
        }
        self.foreign.insert(name.text.to_uppercase());
        file.foreign.push(name);
        while !self.is(Kind::End) && !self.keyword().begins_unit() {
            if self.accept_keyword(end) {
                break;
            }
            self.next();
        }
    }

    /// A unit whose first word is missing or misspelt, `Scale : REAL VAR_INPUT …`; false if this is none.
    fn headless_unit(&mut self, file: &mut File) -> bool {
        let plain = |by: usize| {
            self.ahead(by).kind == Kind::Word && self.keyword_ahead(by) == Keyword::None
        };
        let misspelt = plain(0) && plain(1) && !matches!(self.ahead(2).kind, Kind::Assign);
        let name = usize::from(misspelt);
        if !plain(name) {
            return false;
        }
        let behind = match self.ahead(name + 1).kind {
            Kind::Colon => name + 3,
            _ => name + 1,
        };
        if !self.keyword_ahead(behind).is_section() {
            return false;
        }
        let mut by = behind;
        while self.ahead(by).kind != Kind::End && !self.keyword_ahead(by).ends_unit() {
            by += 1;
        }
        let end = self.keyword_ahead(by);
        let (kind, word) = match end {
            Keyword::EndFunction => (UnitKind::Function, "FUNCTION"),
            Keyword::EndFunctionBlock => (UnitKind::Block, "FUNCTION_BLOCK"),
            Keyword::EndProgram => (UnitKind::Program, "PROGRAM"),
            _ => return false,
        };
        let span = self.token().span;
        let written = self.short(span);
        if misspelt {
            self.tell(Code::StOtherWord, span, [written.into(), word.into()]);
            self.next();
        } else {
            let help = ("begin with the kind of unit", "comece pelo tipo da unidade");
            self.tell(
                Code::StExpected,
                span,
                [word.into(), written.into(), help.into()],
            );
        }
        self.unit_behind(kind, span, end, file);
        true
    }

    fn unit_behind(&mut self, kind: UnitKind, start: Span, end: Keyword, file: &mut File) {
        let head = self.head(kind);
        let (name, result) = match head {
            Ok(head) => head,
            Err(Told) => {
                self.wrong_declarations = true;
                // What follows is read, so that its mistakes are told in one run too.
                while !self.on_new_line() && !self.is(Kind::End) {
                    self.next();
                }
                let name = Name {
                    text: String::new(),
                    span: start,
                };
                (name, None)
            }
        };
        let unit = self.inside(kind, name, result, file);
        if self.keyword() == end {
            self.next();
        } else if self.keyword().ends_unit() {
            let span = self.token().span;
            self.tell_other_word(span, end);
            self.next();
        } else {
            let written = self.short(start);
            self.tell(
                Code::StNotClosed,
                start,
                [written.into(), end.name().into()],
            );
        }
        self.accept(Kind::Semicolon);
        file.units.push(unit);
    }

    fn head(&mut self, kind: UnitKind) -> Parsed<(Name, Option<TypeSpec>)> {
        let help = ("write a name here", "escreva um nome aqui");
        let name = self.name(("a name", "um nome"), help)?;
        if self.other_dialect() {
            return Err(Told);
        }
        if self.is(Kind::Word) && self.keyword() == Keyword::None && !self.on_new_line() {
            let help = (
                "a unit has one name, of one word",
                "uma unidade tem um só nome, de uma palavra",
            );
            let told = self.missing(("the end of the line", "o fim da linha"), help);
            return Err(told);
        }
        if kind != UnitKind::Function {
            self.accept(Kind::Semicolon);
            return Ok((name, None));
        }
        if !self.is(Kind::Colon) {
            let what = (
                "`:` and the type of the result",
                "`:` e o tipo do resultado",
            );
            let help = (
                format!("write FUNCTION {} : INT", name.text),
                format!("escreva FUNCTION {} : INT", name.text),
            );
            return Err(self.missing(what, help));
        }
        self.next();
        let spec = self.spec()?;
        self.accept(Kind::Semicolon);
        let void =
            matches!(&spec.kind, SpecKind::Named(name) if name.text.eq_ignore_ascii_case("VOID"));
        Ok((name, (!void).then_some(spec)))
    }

    /// Variables and statements of a unit.
    fn inside(
        &mut self,
        kind: UnitKind,
        name: Name,
        result: Option<TypeSpec>,
        file: &mut File,
    ) -> UnitDecl {
        let mut vars = Vec::new();
        self.late = false;
        loop {
            while self.accept(Kind::Semicolon) {}
            if self.keyword() == Keyword::EndVar {
                let span = self.next().span;
                let written = self.short(span);
                self.tell(Code::StStrayEnd, span, [written.into(), "VAR".into()]);
                continue;
            }
            let token = self.token();
            let keyword = match self.keyword() {
                Keyword::None if token.kind == Kind::Word && self.ahead(1).kind != Kind::Assign => {
                    let keyword = meant(&self.slice(token.span).to_uppercase());
                    if keyword.is_section() {
                        self.tell_other_word(token.span, keyword);
                        let at = self.at;
                        self.keywords[at] = keyword;
                    }
                    keyword
                }
                keyword => keyword,
            };
            if keyword.is_section() {
                let section = self.section();
                match section.section {
                    Section::Global => file.globals.push(section),
                    _ => vars.push(section),
                }
            } else if keyword == Keyword::Begin {
                self.next();
            } else if keyword == Keyword::None && self.is_title() {
                while !self.on_new_line() && !self.is(Kind::End) {
                    self.next();
                }
            } else {
                break;
            }
        }
        let (body, chart) = self.body(kind);
        UnitDecl {
            kind,
            name,
            result,
            vars,
            body,
            chart,
        }
    }

    /// `VERSION : 0.1` and `TITLE = …` of SCL.
    fn is_title(&mut self) -> bool {
        let token = self.token();
        let word = self.slice(token.span).to_uppercase();
        let known = matches!(
            word.as_str(),
            "VERSION" | "TITLE" | "AUTHOR" | "NAME" | "FAMILY"
        );
        let is = known && matches!(self.ahead(1).kind, Kind::Colon | Kind::Equal);
        if is {
            self.next();
        }
        is
    }

    /// Its globals are read, and the order of its programs.
    fn configuration(&mut self, file: &mut File) {
        let start = self.next().span;
        let written = "CONFIGURATION";
        while !self.is(Kind::End) {
            if self.accept_keyword(Keyword::EndConfiguration) {
                self.tell(Code::StPassedOver, start, [written.into()]);
                return;
            }
            match self.keyword() {
                Keyword::VarGlobal => {
                    let vars = self.section();
                    file.globals.push(vars);
                }
                Keyword::Program => file.order.extend(self.instance_of_program()),
                _ => drop(self.next()),
            }
        }
        self.not_closed_word(start);
    }

    /// `PROGRAM first WITH task : Pumps`: its type, `PUMPS`.
    fn instance_of_program(&mut self) -> Option<String> {
        self.next();
        while self.is(Kind::Word) && self.keyword() == Keyword::None {
            self.next();
        }
        if !self.accept(Kind::Colon) || !self.is(Kind::Word) {
            return None;
        }
        let span = self.next().span;
        Some(self.slice(span).to_uppercase())
    }

    fn not_closed_word(&mut self, start: Span) {
        let written = self.short(start);
        self.tell(
            Code::StNotClosed,
            start,
            [written.into(), "END_CONFIGURATION".into()],
        );
    }
}
