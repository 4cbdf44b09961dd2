//! Commands: what is stored, IF, WHILE, FOR, PRINT.

use super::ast::{Counting, Name, Node, NodeKind, Statement, StatementKind};
use super::parser::Parser;
use super::words::Word;
use unoclp_small::cursor::{Keywords, Parsed, Told};
use unoclp_small::rules::Sign;
use unoclp_text::diagnostics::Code;

impl Statement {
    /// Whether it ends with a word of its own.
    pub(super) fn is_whole(&self) -> bool {
        use StatementKind::{For, If, While};
        matches!(self.kind, If(..) | While(..) | For(_))
    }
}

impl Parser<'_, '_> {
    pub(super) fn command(&mut self) -> Parsed<Statement> {
        self.cursor.deeper()?;
        let begin = self.cursor.token().span;
        let kind = match self.cursor.keyword() {
            Word::If => self.condition_command(),
            Word::While => self.repeated(),
            Word::For => self.counting(),
            Word::Print => self.print(),
            Word::None => self.assign(),
            _ => Err(self.no_command()),
        };
        self.cursor.higher();
        let span = begin.to(self.cursor.behind());
        Ok(Statement { kind: kind?, span })
    }

    fn no_command(&mut self) -> Told {
        let help = (
            "a statement stores a value, or begins with IF, WHILE, FOR or PRINT",
            "um comando guarda um valor ou começa com IF, WHILE, FOR ou PRINT",
        );
        self.cursor.missing(("a statement", "um comando"), help)
    }

    /// `x := e`
    fn assign(&mut self) -> Parsed<StatementKind> {
        if !self.cursor.is(Sign::Word) {
            return Err(self.lacks().unwrap_or_else(|| self.no_command()));
        }
        let behind = self.cursor.ahead(1).sign;
        if !matches!(behind, Sign::Assign | Sign::Equal)
            && let Some(told) = self.lacks()
        {
            self.skip_other();
            return Err(told);
        }
        let token = self.cursor.advance();
        let name = self.cursor.named(token.span);
        match behind {
            Sign::Open => Err(self.called(&name)),
            Sign::Foreign => Err(self.lacks().unwrap_or(Told)),
            _ => {
                self.store_sign(&name)?;
                let value = self.expression()?;
                Ok(StatementKind::Assign(name, value))
            }
        }
    }

    /// Tells that nothing can be called.
    pub(super) fn called(&mut self, name: &Name) -> Told {
        let help = (
            "there are no functions: write out the calculation",
            "não há funções: escreva o cálculo por extenso",
        );
        let written = format!("{}(…)", name.text);
        let words = [written.into(), help.into()];
        self.cursor.tell(Code::IsclLacks, name.span, words);
        Told
    }

    /// `:=`, or `=`, which is told.
    fn store_sign(&mut self, name: &Name) -> Parsed<()> {
        if self.cursor.is(Sign::Equal) {
            let span = self.cursor.advance().span;
            let words = [name.text.as_str().into()];
            self.cursor.tell(Code::StEqualsForAssign, span, words);
            return Ok(());
        }
        let help = (
            "store a value like this: x := 1",
            "guarde um valor assim: x := 1",
        );
        self.cursor.expect(Sign::Assign, ":=", help).map(|_| ())
    }

    /// An expression in which `:=` can mean nothing but `=`.
    fn condition(&mut self) -> Parsed<Node> {
        self.condition = true;
        let read = self.expression();
        self.condition = false;
        read
    }

    fn condition_command(&mut self) -> Parsed<StatementKind> {
        let begin = self.cursor.advance().span;
        let condition = self.condition_of_if()?;
        let ends = [Word::EndIf, Word::Else, Word::Elsif];
        let then = self.list(&ends);
        let mut otherwise = Vec::new();
        let mut told = false;
        while self.cursor.keyword() == Word::Elsif {
            let span = self.cursor.advance().span;
            if !told {
                let written = self.cursor.slice(span).into();
                self.cursor.tell(Code::IsclNoElsif, span, [written]);
                told = true;
            }
            // There is no program any more: what stands in it is only looked through.
            self.condition_of_if()?;
            otherwise.append(&mut self.list(&ends));
        }
        if self.cursor.keyword() == Word::Else {
            self.cursor.advance();
            otherwise.append(&mut self.list(&ends[..1]));
        }
        self.end(begin, Word::EndIf);
        Ok(StatementKind::If(condition, then, otherwise))
    }

    fn condition_of_if(&mut self) -> Parsed<Node> {
        let help = (
            "write THEN after the condition of an IF",
            "escreva THEN depois da condição de um IF",
        );
        self.head(Word::Then, help)
    }

    /// A condition and the word after it. Where it is wrong, what it is the head of is read all the same.
    fn head(&mut self, keyword: Word, help: (&str, &str)) -> Parsed<Node> {
        let (begin, depth) = (self.cursor.token().span, self.cursor.depth());
        let read = self.condition();
        let read = read.and_then(|node| self.keyword(keyword, help).map(|()| node));
        match read {
            Err(Told) if !self.cursor.dead => {
                self.cursor.back_to(depth);
                self.skip_head(keyword);
                Ok(Node {
                    kind: NodeKind::Wrong,
                    span: begin,
                    height: 1,
                })
            }
            read => read,
        }
    }

    fn repeated(&mut self) -> Parsed<StatementKind> {
        let begin = self.cursor.advance().span;
        let help = (
            "write DO after the condition of a WHILE",
            "escreva DO depois da condição de um WHILE",
        );
        let condition = self.head(Word::Do, help)?;
        let body = self.list(&[Word::EndWhile, Word::EndFor]);
        if self.cursor.keyword() == Word::EndFor {
            let span = self.cursor.advance().span;
            self.cursor.tell(Code::IsclEndFor, span, []);
        } else {
            self.end(begin, Word::EndWhile);
        }
        Ok(StatementKind::While(condition, body))
    }

    fn counting(&mut self) -> Parsed<StatementKind> {
        let begin = self.cursor.advance().span;
        let depth = self.cursor.depth();
        let head = self.bounds();
        if head.is_err() && !self.cursor.dead {
            self.cursor.back_to(depth);
            self.skip_head(Word::Do);
        }
        let body = self.list(&[Word::EndFor]);
        self.end(begin, Word::EndFor);
        let (variable, from, to) = head?;
        Ok(StatementKind::For(Box::new(Counting {
            variable,
            from,
            to,
            body,
        })))
    }

    /// `i := 1 TO 10 DO`
    fn bounds(&mut self) -> Parsed<(Name, Node, Node)> {
        let what = ("the variable that counts", "a variável que conta");
        let help = ("write FOR i := 1 TO 10 DO", "escreva FOR i := 1 TO 10 DO");
        let variable = self.cursor.name(what, help)?;
        self.store_sign(&variable)?;
        let from = self.expression()?;
        self.keyword(Word::To, help)?;
        let to = self.expression()?;
        self.keyword(Word::Do, help)?;
        Ok((variable, from, to))
    }

    /// A keyword, or a word that InterSCL does not have in its place.
    fn keyword(&mut self, keyword: Word, help: (&str, &str)) -> Parsed<()> {
        if self.cursor.keyword() == Word::None
            && Word::meant(self.cursor.written()) != keyword
            && let Some(told) = self.lacks()
        {
            return Err(told);
        }
        self.cursor.expect_keyword(keyword, help).map(|_| ())
    }

    /// The word that ends a part.
    fn end(&mut self, begin: unoclp_text::diagnostics::Span, end: Word) {
        match self.cursor.keyword() == end {
            true => {
                self.cursor.advance();
            }
            false => self.not_closed(begin, end),
        }
    }

    /// `PRINT(x)`
    fn print(&mut self) -> Parsed<StatementKind> {
        self.cursor.advance();
        let help = (
            "write PRINT(x), with the name of a variable",
            "escreva PRINT(x), com o nome de uma variável",
        );
        self.cursor.expect(Sign::Open, "(", help)?;
        let token = self.cursor.token();
        let alone = token.sign == Sign::Word
            && self.cursor.keyword() == Word::None
            && self.cursor.ahead(1).sign == Sign::Close;
        if !alone {
            return Err(self.no_name(help));
        }
        self.cursor.advance();
        self.cursor.advance();
        Ok(StatementKind::Print(self.cursor.named(token.span)))
    }

    /// Tells that PRINT is given something that is no name.
    fn no_name(&mut self, help: (&str, &str)) -> Told {
        let token = self.cursor.token();
        if matches!(token.sign, Sign::Close | Sign::End | Sign::Semicolon) {
            let what = ("the name of a variable", "o nome de uma variável");
            return self.cursor.missing(what, help);
        }
        let span = match token.sign {
            Sign::Text => {
                self.cursor.advance();
                token.span
            }
            _ => match self.expression() {
                Ok(node) => node.span,
                Err(told) => return told,
            },
        };
        if !matches!(self.cursor.sign(), Sign::Close | Sign::Comma) {
            // A name, and then something that is missing.
            let help = ("write ) to match the (", "escreva o ) que corresponde ao (");
            let told = self.cursor.expect(Sign::Close, ")", help);
            return told.err().unwrap_or(Told);
        }
        let written = self.cursor.short(span);
        let help = match (token.sign, self.cursor.sign()) {
            (Sign::Text, _) => (
                "InterSCL has no strings: print a variable, PRINT(x)".to_owned(),
                "o InterSCL não tem strings: mostre uma variável, PRINT(x)".to_owned(),
            ),
            (_, Sign::Comma) => (
                format!("write a PRINT for each: PRINT({written})"),
                format!("escreva um PRINT para cada um: PRINT({written})"),
            ),
            _ => (
                format!("store it first: x := {written}; PRINT(x)"),
                format!("guarde-o antes: x := {written}; PRINT(x)"),
            ),
        };
        let span = match self.cursor.is(Sign::Comma) {
            true => self.cursor.token().span,
            false => span,
        };
        let written = self.cursor.short(span);
        let words = [written.into(), help.into()];
        self.cursor.tell(Code::IsclPrint, span, words);
        Told
    }
}
