//! Statements, and how the parser goes on behind one that is wrong.

use super::super::ast::{Arm, Counting, Node, NodeKind, Path, Statement, StatementKind};
use super::super::lexer::Kind;
use super::super::words::{Keyword, meant};
use super::{Parsed, Parser, Told};
use crate::diagnostics::{Code, Span, Word};

const SEMICOLON: (&str, &str) = ("each statement ends with ;", "cada comando termina com ;");

impl Parser<'_, '_> {
    /// Statements up to what ends them.
    pub(super) fn statements(&mut self) -> Vec<Statement> {
        let mut all = Vec::new();
        loop {
            while self.accept(Kind::Semicolon) {}
            let before = self.at;
            if self.ends_statements() {
                return all;
            }
            if self.at != before {
                continue;
            }
            match self.statement() {
                Ok(Some(statement)) => all.push(statement),
                Ok(None) => {}
                Err(Told) => self.recover(),
            }
            if self.at == before {
                self.next();
            }
        }
    }

    fn ends_statements(&mut self) -> bool {
        self.take_for_end();
        let keyword = self.keyword();
        if self.is(Kind::End) || keyword.ends_unit() || keyword.begins_unit() {
            return true;
        }
        if keyword.ends_part() {
            return !self.stray_end(keyword);
        }
        // Within CASE a label ends what stands before it.
        self.closers.last() == Some(&Keyword::EndCase) && self.is_label()
    }

    /// Takes `ENDIF` and `ELSEIF` for the words that are meant, where what they end is open.
    fn take_for_end(&mut self) {
        let token = self.token();
        if token.kind != Kind::Word || self.keyword() != Keyword::None {
            return;
        }
        let follows = self.ahead(1).kind;
        if matches!(follows, Kind::Assign | Kind::Dot | Kind::OpenSquare) {
            return;
        }
        let keyword = meant(&self.slice(token.span).to_uppercase());
        let open = match keyword {
            Keyword::Elsif => self.closers.contains(&Keyword::EndIf),
            keyword if keyword.ends_unit() => true,
            keyword => keyword.ends_part() && self.closers.contains(&keyword),
        };
        if open {
            self.tell_other_word(token.span, keyword);
            let at = self.at;
            self.keywords[at] = keyword;
        }
    }

    /// Whether an END that no open statement waits for stands here; it is told and passed over.
    fn stray_end(&mut self, keyword: Keyword) -> bool {
        let waits = |closer: &Keyword| {
            *closer == keyword
                || *closer == Keyword::EndIf && matches!(keyword, Keyword::Else | Keyword::Elsif)
                || *closer == Keyword::EndCase && keyword == Keyword::Else
                || *closer == Keyword::EndRepeat && keyword == Keyword::Until
        };
        if self.closers.iter().any(waits) {
            return false;
        }
        let span = self.token().span;
        let written = self.short(span);
        // One that is open is closed by the wrong word.
        if let Some(closer) = self.closers.last().copied().filter(|c| *c != Keyword::None)
            && !matches!(keyword, Keyword::Else | Keyword::Elsif)
        {
            self.tell(
                Code::StOtherWord,
                span,
                [written.into(), closer.name().into()],
            );
            let at = self.at;
            self.keywords[at] = match closer {
                Keyword::EndRepeat => Keyword::EndRepeat,
                closer => closer,
            };
            return false;
        }
        let opener = opener(keyword);
        self.tell(Code::StStrayEnd, span, [written.into(), opener.into()]);
        self.next();
        true
    }

    /// Goes behind the statement that is wrong.
    fn recover(&mut self) {
        let start = self.at;
        let mut open = 0_u32;
        while !self.is(Kind::End) {
            let keyword = self.keyword();
            if keyword.ends_unit() || keyword.begins_unit() || keyword.is_section() {
                return;
            }
            if matches!(keyword, Keyword::Then | Keyword::Do | Keyword::Of) {
                let first = self.at == start;
                self.next();
                if !first {
                    self.skip_block();
                }
                return;
            }
            if open == 0 && self.is(Kind::Semicolon) {
                self.next();
                return;
            }
            if open == 0
                && (keyword.ends_part() || keyword.begins_statement())
                && self.on_new_line()
            {
                return;
            }
            // What the wrong statement has opened is passed over with it.
            if matches!(
                keyword,
                Keyword::EndIf
                    | Keyword::EndCase
                    | Keyword::EndFor
                    | Keyword::EndWhile
                    | Keyword::EndRepeat
            ) {
                return;
            }
            if open == 0
                && self.on_new_line()
                && self.is(Kind::Word)
                && matches!(self.ahead(1).kind, Kind::Assign)
            {
                return;
            }
            open += u32::from(self.is(Kind::Open));
            open -= u32::from(self.is(Kind::Close) && open > 0);
            self.next();
        }
    }

    fn statement(&mut self) -> Parsed<Option<Statement>> {
        self.deeper()?;
        let read = self.any_statement();
        self.open -= 1;
        read
    }

    fn any_statement(&mut self) -> Parsed<Option<Statement>> {
        let start = self.token().span;
        let keyword = self.statement_keyword();
        let kind = match keyword {
            Keyword::If => return self.if_statement(start).map(Some),
            Keyword::Case => self.case_statement(start)?,
            Keyword::For => self.for_statement(start)?,
            Keyword::While => self.while_statement(start)?,
            Keyword::Repeat => self.repeat_statement(start)?,
            Keyword::Exit | Keyword::Continue | Keyword::Return => {
                self.next();
                let kind = match keyword {
                    Keyword::Exit => StatementKind::Exit,
                    Keyword::Continue => StatementKind::Continue,
                    _ => StatementKind::Return,
                };
                if keyword == Keyword::Return && !self.is(Kind::Semicolon) && !self.on_new_line() {
                    let written = "RETURN x";
                    let help = (
                        "store the result in the function's name, F := x; and write RETURN; alone",
                        "guarde o resultado no nome da função, F := x; e escreva só RETURN;",
                    );
                    self.tell(Code::StUnsupported, start, [written.into(), help.into()]);
                    return Err(Told);
                }
                self.end_of_statement(false)?;
                return Ok(Some(Statement { kind, span: start }));
            }
            Keyword::Region => {
                self.next();
                while !self.on_new_line() && !self.is(Kind::End) {
                    self.next();
                }
                return Ok(None);
            }
            Keyword::EndRegion => {
                self.next();
                return Ok(None);
            }
            Keyword::Goto => {
                let help = (
                    "IF, CASE and loops decide what is done; EXIT leaves a loop",
                    "IF, CASE e laços decidem o que é feito; EXIT sai de um laço",
                );
                self.tell(Code::StUnsupported, start, ["GOTO".into(), help.into()]);
                return Err(Told);
            }
            keyword if keyword.is_section() => return self.late_section(start),
            Keyword::None => return self.simple_statement(start),
            _ => {
                let what = ("a statement", "um comando");
                let help = (
                    "a statement begins with a variable, IF, CASE, FOR, WHILE, REPEAT, EXIT or RETURN",
                    "um comando começa com uma variável, IF, CASE, FOR, WHILE, REPEAT, EXIT ou RETURN",
                );
                return Err(self.missing(what, help));
            }
        };
        self.accept(Kind::Semicolon);
        let span = start.to(self.behind());
        Ok(Some(Statement { kind, span }))
    }

    /// The keyword here, or the one that another language's word stands for.
    fn statement_keyword(&mut self) -> Keyword {
        let token = self.token();
        if self.keyword() != Keyword::None || token.kind != Kind::Word {
            return self.keyword();
        }
        let follows = self.ahead(1).kind;
        if matches!(follows, Kind::Assign | Kind::Dot | Kind::OpenSquare) {
            return Keyword::None;
        }
        let keyword = meant(&self.slice(token.span).to_uppercase());
        if keyword.begins_statement() && follows != Kind::Open {
            self.tell_other_word(token.span, keyword);
            let at = self.at;
            self.keywords[at] = keyword;
            return keyword;
        }
        Keyword::None
    }

    pub(super) fn tell_other_word(&mut self, span: Span, keyword: Keyword) {
        let written = self.slice(span).to_owned();
        self.tell(
            Code::StOtherWord,
            span,
            [written.into(), keyword.name().into()],
        );
    }

    /// Variables that are declared behind statements.
    fn late_section(&mut self, start: Span) -> Parsed<Option<Statement>> {
        let written = self.short(start);
        if !self.late {
            self.tell(Code::StLateDeclaration, start, [written.into()]);
        }
        self.late = true;
        self.wrong_declarations = true;
        while !self.is(Kind::End) && !self.accept_keyword(Keyword::EndVar) {
            self.next();
        }
        Ok(None)
    }

    /// An assignment or a call.
    fn simple_statement(&mut self, start: Span) -> Parsed<Option<Statement>> {
        if !matches!(self.kind(), Kind::Word | Kind::Address) {
            return Err(self.no_statement());
        }
        // `END IF`
        let word = self.slice(start).to_uppercase();
        if word == "END" && self.ahead(1).kind == Kind::Word && !self.closers.is_empty() {
            let closer = format!("END_{}", self.slice(self.ahead(1).span).to_uppercase());
            let keyword = Keyword::of(&closer);
            if keyword != Keyword::None {
                let span = start.to(self.ahead(1).span);
                self.tell_other_word(span, keyword);
                self.next();
                let at = self.at;
                self.keywords[at] = keyword;
                return Ok(None);
            }
        }
        if self.is_declaration() {
            return self.headless_section(start);
        }
        let path = self.path()?;
        match self.kind() {
            Kind::Word if matches!(self.keyword(), Keyword::Then | Keyword::Do | Keyword::Of) => {
                let missing = match self.keyword() {
                    Keyword::Then => "IF",
                    Keyword::Do => "WHILE",
                    _ => "CASE",
                };
                let written = self.short(path.span);
                let help = (
                    "each of these words stands with its other half: IF … THEN, WHILE … DO, CASE … OF",
                    "cada uma destas palavras fica com a sua outra metade: IF … THEN, WHILE … DO, CASE … OF",
                );
                let words = [missing.into(), written.into(), help.into()];
                self.tell(Code::StExpected, path.span, words);
                self.next();
                self.skip_block();
                Ok(None)
            }
            Kind::Assign => {
                self.next();
                self.closers.push(Keyword::None);
                let value = self.expression();
                self.closers.pop();
                let value = value?;
                let span = start.to(value.span);
                self.end_of_statement(true)?;
                let kind = StatementKind::Assign(path, value);
                Ok(Some(Statement { kind, span }))
            }
            Kind::Open => {
                let (arguments, close) = self.arguments()?;
                let span = start.to(close);
                self.end_of_statement(false)?;
                let kind = StatementKind::Call(path, arguments);
                Ok(Some(Statement { kind, span }))
            }
            Kind::Equal => {
                let span = self.token().span;
                let target = self.short(path.span);
                self.tell(Code::StEqualsForAssign, span, [target.into()]);
                Err(Told)
            }
            Kind::Foreign => Err(self.foreign(&path)),
            Kind::Colon => {
                let what = ("`:=`", "`:=`");
                let help = (
                    "a value is stored with :=, without a space in it",
                    "um valor se guarda com :=, sem espaço no meio",
                );
                Err(self.missing(what, help))
            }
            Kind::Word | Kind::Number if !self.on_new_line() => {
                let what = ("`:=`", "`:=`");
                let help = ("a value is stored with :=", "um valor se guarda com :=");
                Err(self.missing(what, help))
            }
            Kind::Arrow => {
                let span = self.token().span;
                self.tell(Code::StOtherWord, span, ["=>".into(), ":=".into()]);
                Err(Told)
            }
            Kind::LessEqual | Kind::Less if self.keyword() == Keyword::None => {
                let span = self.token().span;
                let sign = self.slice(span).to_owned();
                self.tell(Code::StOtherWord, span, [sign.into(), ":=".into()]);
                Err(Told)
            }
            _ => {
                let written = self.short(path.span);
                self.tell(Code::StNoEffect, path.span, [written.into()]);
                Err(Told)
            }
        }
    }

    /// Whether a declaration stands where a statement is expected: a colon comes before what makes a statement.
    fn is_declaration(&self) -> bool {
        if self.closers.contains(&Keyword::EndCase) {
            return false;
        }
        for by in 1..16 {
            match self.ahead(by).kind {
                Kind::Colon => return true,
                Kind::Word | Kind::Comma | Kind::Address => {}
                _ => return false,
            }
            let keyword = self.keyword_ahead(by);
            if !matches!(keyword, Keyword::None | Keyword::At) {
                return false;
            }
        }
        false
    }

    /// Declarations whose VAR or TYPE is missing: they are passed over to their end, if that is there.
    fn headless_section(&mut self, start: Span) -> Parsed<Option<Statement>> {
        self.wrong_declarations = true;
        if self.headless {
            return Err(Told);
        }
        let mut by = 0;
        let end = loop {
            let keyword = self.keyword_ahead(by);
            if matches!(keyword, Keyword::EndVar | Keyword::EndType) {
                break Some(keyword);
            }
            let other = keyword.ends_unit() || keyword.begins_unit() || keyword.is_section();
            if other || self.ahead(by).kind == Kind::End {
                break None;
            }
            by += 1;
        };
        let written = self.short(start);
        let (missing, help) = match end {
            Some(Keyword::EndType) => (
                "TYPE",
                (
                    "types are declared between TYPE and END_TYPE",
                    "tipos são declarados entre TYPE e END_TYPE",
                ),
            ),
            _ => (
                "VAR",
                (
                    "variables are declared between VAR and END_VAR",
                    "variáveis são declaradas entre VAR e END_VAR",
                ),
            ),
        };
        self.tell(
            Code::StExpected,
            start,
            [missing.into(), written.into(), help.into()],
        );
        match end {
            Some(_) => {
                for _ in 0..=by {
                    self.next();
                }
                Ok(None)
            }
            None => {
                self.headless = true;
                Err(Told)
            }
        }
    }

    /// Passes over what THEN, DO or OF has begun, to its end.
    fn skip_block(&mut self) {
        let mut open = 1_u32;
        while !self.is(Kind::End) {
            let keyword = self.keyword();
            if keyword.ends_unit() || keyword.begins_unit() {
                return;
            }
            let begins = matches!(
                keyword,
                Keyword::If | Keyword::Case | Keyword::For | Keyword::While | Keyword::Repeat
            );
            let ends = matches!(
                keyword,
                Keyword::EndIf
                    | Keyword::EndCase
                    | Keyword::EndFor
                    | Keyword::EndWhile
                    | Keyword::EndRepeat
            );
            self.next();
            open = match (begins, ends) {
                (true, _) => open + 1,
                (_, true) => open - 1,
                _ => open,
            };
            if open == 0 {
                self.accept(Kind::Semicolon);
                return;
            }
        }
    }

    /// `x += 1`, `x++`
    fn foreign(&mut self, path: &Path) -> Told {
        let span = self.token().span;
        let (sign, name) = (self.short(span), self.short(path.span));
        let meant = match sign.as_str() {
            "++" => format!("{name} := {name} + 1"),
            "--" => format!("{name} := {name} - 1"),
            "{" | "}" => "THEN … END_IF".to_owned(),
            _ => format!("{name} := {name} {} …", sign.trim_end_matches('=')),
        };
        self.tell(Code::StOtherWord, span, [sign.into(), meant.into()]);
        Told
    }

    fn no_statement(&mut self) -> Told {
        let span = self.token().span;
        if self.is(Kind::Foreign) {
            let sign = self.short(span);
            let meant: Word = match sign.as_str() {
                "{" => ("THEN or DO", "THEN ou DO").into(),
                "}" => (
                    "END_IF, END_FOR or END_WHILE",
                    "END_IF, END_FOR ou END_WHILE",
                )
                    .into(),
                _ => "x := x + 1".into(),
            };
            self.tell(Code::StOtherWord, span, [sign.into(), meant]);
            return Told;
        }
        let what = ("a statement", "um comando");
        let help = (
            "a statement begins with a variable, IF, CASE, FOR, WHILE, REPEAT, EXIT or RETURN",
            "um comando começa com uma variável, IF, CASE, FOR, WHILE, REPEAT, EXIT ou RETURN",
        );
        self.missing(what, help)
    }

    /// The `;` behind a statement.
    fn end_of_statement(&mut self, value: bool) -> Parsed<()> {
        if self.accept(Kind::Semicolon) {
            return Ok(());
        }
        // `2,5`
        if value && self.is(Kind::Comma) && self.ahead(1).kind == Kind::Number {
            let before = self.behind();
            let span = before.to(self.ahead(1).span);
            let written = self.short(span);
            let meant = written.replace(',', ".").replace(' ', "");
            self.tell(Code::StOtherWord, span, [written.into(), meant.into()]);
            return Err(Told);
        }
        if self.is(Kind::Assign) || self.is(Kind::Equal) {
            return Err(self.missing(("`;`", "`;`"), SEMICOLON));
        }
        if self.is(Kind::Close) {
            let span = self.token().span;
            self.tell(Code::StStrayEnd, span, [")".into(), "(".into()]);
            return Err(Told);
        }
        let told = self.missing(("`;`", "`;`"), SEMICOLON);
        // Where the next statement begins, it is read.
        match self.on_new_line() || self.keyword() != Keyword::None {
            true => Ok(()),
            false => Err(told),
        }
    }

    /// A condition with the word behind it.
    fn condition(&mut self, keyword: Keyword, help: (&str, &str)) -> Parsed<Node> {
        self.closers.push(Keyword::Then);
        let read = self.expression();
        self.closers.pop();
        let condition = read?;
        if self.is(Kind::Foreign) && self.slice(self.token().span) == "{" || self.is(Kind::Colon) {
            let span = self.token().span;
            let sign = self.short(span);
            self.tell(
                Code::StOtherWord,
                span,
                [sign.into(), keyword.name().into()],
            );
            if self.is(Kind::Foreign) {
                // A text of another language: its } would be told too.
                self.end_here();
                return Err(Told);
            }
            self.next();
            return Ok(condition);
        }
        self.expect_keyword(keyword, help)?;
        Ok(condition)
    }

    /// The statements of a part, and what is open while they are read.
    fn part(&mut self, closer: Keyword) -> Vec<Statement> {
        self.closers.push(closer);
        let body = self.statements();
        self.closers.pop();
        body
    }

    fn not_closed(&mut self, start: Span, closer: Keyword) {
        let written = self.short(start);
        self.tell(
            Code::StNotClosed,
            start,
            [written.into(), closer.name().into()],
        );
    }

    fn if_statement(&mut self, start: Span) -> Parsed<Statement> {
        const THEN: (&str, &str) = (
            "behind the condition stands THEN",
            "depois da condição vem THEN",
        );
        let mut arms = Vec::new();
        let mut otherwise = Vec::new();
        self.next();
        let mut condition = self.condition(Keyword::Then, THEN);
        loop {
            let (node, failed) = match condition {
                Ok(node) => (node, false),
                Err(Told) => (self.wrong_node(start), true),
            };
            if failed {
                self.seek_part();
            }
            let body = self.part(Keyword::EndIf);
            arms.push((node, body));
            let keyword = self.keyword();
            if keyword == Keyword::Elsif {
                self.next();
                condition = self.condition(Keyword::Then, THEN);
                continue;
            }
            if keyword == Keyword::Else {
                let at = self.next().span;
                if self.keyword() == Keyword::If && !self.on_new_line() && !self.closed_twice() {
                    let span = at.to(self.token().span);
                    self.tell_other_word(span, Keyword::Elsif);
                    self.next();
                    condition = self.condition(Keyword::Then, THEN);
                    continue;
                }
                otherwise = self.part(Keyword::EndIf);
                if matches!(self.keyword(), Keyword::Else | Keyword::Elsif) {
                    let span = self.token().span;
                    let written = self.short(span);
                    self.tell(Code::StStrayEnd, span, [written.into(), "IF".into()]);
                    self.next();
                    self.recover();
                    self.part(Keyword::EndIf);
                }
            }
            break;
        }
        if !self.accept_keyword(Keyword::EndIf) {
            self.not_closed(start, Keyword::EndIf);
        }
        self.accept(Kind::Semicolon);
        let kind = StatementKind::If(arms, otherwise);
        let span = start.to(self.behind());
        Ok(Statement { kind, span })
    }

    /// Whether behind `ELSE IF` two END_IF follow one another, so that it is an IF of its own: looked for as far as a
    /// person would.
    fn closed_twice(&self) -> bool {
        let mut open = 0_i32;
        for by in 0..600 {
            match self.keyword_ahead(by) {
                Keyword::If => open += 1,
                Keyword::EndIf => open -= 1,
                keyword if keyword.ends_unit() || keyword.begins_unit() => return false,
                _ => {}
            }
            if self.ahead(by).kind == Kind::End {
                return false;
            }
            if open == 0 {
                // The IF behind ELSE ends here; does the outer one end too?
                let semicolon = usize::from(self.ahead(by + 1).kind == Kind::Semicolon);
                return self.keyword_ahead(by + 1 + semicolon) == Keyword::EndIf
                    || semicolon == 1 && {
                        let next = self.keyword_ahead(by + 2);
                        !next.ends_unit() && self.later_end_if(by + 2)
                    };
            }
        }
        true
    }

    /// Whether more IF are closed than opened from there to the end of the unit.
    fn later_end_if(&self, from: usize) -> bool {
        let mut open = 0_i32;
        for by in from..from + 600 {
            match self.keyword_ahead(by) {
                Keyword::If => open += 1,
                Keyword::EndIf => open -= 1,
                keyword if keyword.ends_unit() => return false,
                _ => {}
            }
            if open < 0 {
                return true;
            }
            if self.ahead(by).kind == Kind::End {
                return false;
            }
        }
        false
    }

    fn wrong_node(&self, span: Span) -> Node {
        Node {
            kind: NodeKind::Wrong,
            span,
            height: 1,
        }
    }

    /// Behind a head that is wrong, to where its statements begin: its line ends, or THEN, DO, OF stand.
    fn seek_part(&mut self) {
        while !self.is(Kind::End) {
            let keyword = self.keyword();
            if matches!(keyword, Keyword::Then | Keyword::Do | Keyword::Of) {
                self.next();
                return;
            }
            if self.on_new_line()
                || keyword.ends_part()
                || keyword.ends_unit()
                || self.is(Kind::Semicolon)
            {
                return;
            }
            self.next();
        }
    }

    fn while_statement(&mut self, start: Span) -> Parsed<StatementKind> {
        self.next();
        let help = (
            "behind the condition stands DO",
            "depois da condição vem DO",
        );
        let condition = match self.condition(Keyword::Do, help) {
            Ok(condition) => condition,
            Err(Told) => {
                self.seek_part();
                self.wrong_node(start)
            }
        };
        let body = self.part(Keyword::EndWhile);
        if !self.accept_keyword(Keyword::EndWhile) {
            self.not_closed(start, Keyword::EndWhile);
        }
        Ok(StatementKind::While(condition, body))
    }

    fn repeat_statement(&mut self, start: Span) -> Parsed<StatementKind> {
        self.next();
        let body = self.part(Keyword::EndRepeat);
        if !self.accept_keyword(Keyword::Until) {
            if self.keyword() == Keyword::EndRepeat {
                let what = ("UNTIL with a condition", "UNTIL com uma condição");
                let help = (
                    "say when the loop ends: UNTIL x > 10 END_REPEAT",
                    "diga quando o laço termina: UNTIL x > 10 END_REPEAT",
                );
                self.missing(what, help);
                self.next();
            } else {
                self.not_closed(start, Keyword::Until);
            }
            return Ok(StatementKind::Repeat(body, self.wrong_node(start)));
        }
        self.closers.push(Keyword::Then);
        let read = self.expression();
        self.closers.pop();
        let until = match read {
            Ok(until) => until,
            Err(Told) => {
                self.seek_part();
                self.wrong_node(start)
            }
        };
        self.accept(Kind::Semicolon);
        if !self.accept_keyword(Keyword::EndRepeat) {
            self.not_closed(start, Keyword::EndRepeat);
        }
        Ok(StatementKind::Repeat(body, until))
    }

    fn for_statement(&mut self, start: Span) -> Parsed<StatementKind> {
        self.next();
        let head = self.for_head();
        if head.is_err() {
            self.seek_part();
        }
        let body = self.part(Keyword::EndFor);
        if !self.accept_keyword(Keyword::EndFor) {
            self.not_closed(start, Keyword::EndFor);
        }
        let (variable, from, to, by) = head?;
        Ok(StatementKind::For(Box::new(Counting {
            variable,
            from,
            to,
            by,
            body,
        })))
    }

    fn for_head(&mut self) -> Parsed<(Path, Node, Node, Option<Node>)> {
        const HELP: (&str, &str) = ("write FOR i := 1 TO 10 DO", "escreva FOR i := 1 TO 10 DO");
        let variable = self.path()?;
        if self.is(Kind::Equal) {
            let span = self.next().span;
            let written = self.short(variable.span);
            self.tell(Code::StEqualsForAssign, span, [written.into()]);
        } else {
            self.expect(Kind::Assign, ":=", HELP)?;
        }
        let from = self.expression()?;
        if self.is(Kind::Range) || self.is(Kind::Comma) {
            let span = self.next().span;
            let written = self.short(span);
            self.tell(Code::StOtherWord, span, [written.into(), "TO".into()]);
        } else {
            self.expect_keyword(Keyword::To, HELP)?;
        }
        let to = self.expression()?;
        let step =
            self.is(Kind::Word) && self.slice(self.token().span).eq_ignore_ascii_case("STEP");
        if step {
            let span = self.token().span;
            self.tell_other_word(span, Keyword::By);
        }
        let by = match step || self.keyword() == Keyword::By {
            true => {
                self.next();
                Some(self.expression()?)
            }
            false => None,
        };
        self.expect_keyword(Keyword::Do, HELP)?;
        Ok((variable, from, to, by))
    }

    fn case_statement(&mut self, start: Span) -> Parsed<StatementKind> {
        self.next();
        let help = ("behind the value stands OF", "depois do valor vem OF");
        self.closers.push(Keyword::None);
        let read = self.expression();
        self.closers.pop();
        let selector = read.and_then(|node| {
            self.expect_keyword(Keyword::Of, help)?;
            Ok(node)
        });
        let selector = match selector {
            Ok(selector) => selector,
            Err(Told) => {
                self.seek_part();
                self.wrong_node(start)
            }
        };
        let (mut arms, mut otherwise) = (Vec::new(), Vec::new());
        loop {
            while self.accept(Kind::Semicolon) {}
            if self.is_label() {
                match self.arm() {
                    Ok(arm) => arms.push(arm),
                    Err(Told) => {
                        self.seek_part();
                        self.part(Keyword::EndCase);
                    }
                }
                continue;
            }
            if self.accept_keyword(Keyword::Else) {
                self.accept(Kind::Colon);
                // No label is looked for behind ELSE.
                otherwise = self.part(Keyword::EndCase);
                continue;
            }
            let keyword = self.keyword();
            if keyword == Keyword::EndCase
                || self.is(Kind::End)
                || keyword.ends_unit()
                || keyword.begins_unit()
            {
                break;
            }
            if keyword.ends_part() {
                break;
            }
            let what = (
                "a value with a colon, `1:`,",
                "um valor com dois-pontos, `1:`,",
            );
            let help = (
                "each part of CASE begins with its values: 1, 2: or 3..5: or a name of an enumeration",
                "cada parte de CASE começa com os seus valores: 1, 2: ou 3..5: ou um nome de enumeração",
            );
            self.missing(what, help);
            let before = self.at;
            self.recover();
            if self.at == before {
                self.next();
            }
        }
        if !self.accept_keyword(Keyword::EndCase) {
            self.not_closed(start, Keyword::EndCase);
        }
        Ok(StatementKind::Case(selector, arms, otherwise))
    }

    /// Whether a label of CASE stands here.
    fn is_label(&self) -> bool {
        let follows =
            |by: usize| matches!(self.ahead(by).kind, Kind::Colon | Kind::Comma | Kind::Range);
        match self.kind() {
            Kind::Number | Kind::Minus | Kind::Plus | Kind::Text => true,
            Kind::Typed => follows(1),
            Kind::Word if matches!(self.keyword(), Keyword::True | Keyword::False) => follows(1),
            Kind::Word => self.keyword() == Keyword::None && follows(1),
            _ => false,
        }
    }

    fn arm(&mut self) -> Parsed<Arm> {
        let mut labels = Vec::new();
        loop {
            self.closers.push(Keyword::None);
            let low = self.expression();
            let high = match self.is(Kind::Range) {
                true => {
                    self.next();
                    self.expression().map(Some)
                }
                false => Ok(None),
            };
            self.closers.pop();
            labels.push((low?, high?));
            if !self.accept(Kind::Comma) {
                break;
            }
        }
        let help = (
            "behind the values of a part stands a colon",
            "depois dos valores de uma parte vêm dois-pontos",
        );
        self.expect(Kind::Colon, ":", help)?;
        let body = self.part(Keyword::EndCase);
        Ok(Arm { labels, body })
    }
}

fn opener(keyword: Keyword) -> &'static str {
    match keyword {
        Keyword::EndIf | Keyword::Else | Keyword::Elsif => "IF",
        Keyword::EndFor => "FOR",
        Keyword::EndWhile => "WHILE",
        Keyword::EndRepeat | Keyword::Until => "REPEAT",
        Keyword::EndCase => "CASE",
        Keyword::EndRegion => "REGION",
        _ => "PROGRAM",
    }
}
