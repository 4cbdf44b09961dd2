//! From words to the typed tree, line by line.
//!
//! Owns the grammar and what a sentence means. Must not know what an operation gives: the builder says that.

use crate::messages::{EXPECTED, NOT_DECLARED, TOO_DEEP, TOO_LONG};
use crate::words::{Kind, Word};
use unoclp_core::Board;
use unoclp_text::diagnostics::{self, Code, Found, Span};
use unoclp_text::near::nearest;
use unoclp_tree::build::{Argument, Builder, Given, Letters, Section, Target, Traits, both};
use unoclp_tree::{
    self as tree, Base, Binary, Expr, Standard, Stmt, Tree, TypeId, UnitKind, Value,
};

/// A line has no more operators and parentheses: what comes after this goes down an expression step by step.
const MOST: u32 = 100;

/// For more names than this, no near one is looked for.
const MOST_NEAR: u32 = 32;

/// What is wrong has been told.
struct Told;

struct Reader<'t, 'f> {
    text: &'t str,
    words: Vec<Word>,
    at: usize,
    /// How many operators and parentheses the line has so far.
    parts: u32,
    /// The names that are declared, as they are written.
    names: Vec<&'t str>,
    /// For how many names a near one was looked for.
    asked: u32,
    builder: Builder<'t, 'f>,
}

pub(crate) fn read(text: &str, words: Vec<Word>, board: Board, found: &mut Found) -> Option<Tree> {
    let mut reader = Reader {
        text,
        words,
        at: 0,
        parts: 0,
        names: Vec::new(),
        asked: 0,
        builder: Builder::new(text, Letters::Apart, board, found),
    };
    let whole = Span {
        start: 0,
        end: text.len() as u32,
    };
    let program = reader.builder.unit("WHEN", UnitKind::Program, whole);
    let before = reader.builder.enter(&program);
    let mut body = Vec::new();
    while reader.at < reader.words.len() {
        reader.parts = 0;
        if reader.line(&mut body).is_err() {
            while reader.word().kind != Kind::LineEnd {
                reader.at += 1;
            }
        }
        reader.at += 1;
    }
    let program = reader.builder.close(program);
    reader.builder.back(before);
    reader.builder.body(program, body);
    reader.builder.finish()
}

impl Reader<'_, '_> {
    /// The next word; the last one stays.
    fn word(&self) -> Word {
        let last = self.words.len() - 1;
        self.words[self.at.min(last)]
    }

    /// The next word, if it is this one.
    fn takes(&mut self, word: &str) -> bool {
        let is = self.word().of(self.text) == word;
        self.at += usize::from(is);
        is
    }

    fn take(&mut self, kind: Kind, what: (&str, &str)) -> Result<Word, Told> {
        let word = self.word();
        if word.kind != kind {
            return Err(self.expected(what));
        }
        self.at += 1;
        Ok(word)
    }

    fn expected(&mut self, (en, pt): (&str, &str)) -> Told {
        let word = self.word();
        let written: diagnostics::Word = match word.kind {
            Kind::LineEnd => both("the end of the line", "o fim da linha"),
            _ => format!("`{}`", word.of(self.text)).into(),
        };
        self.tell(EXPECTED, word.span, [written, both(en, pt)])
    }

    fn tell<const N: usize>(
        &mut self,
        code: Code,
        at: Span,
        words: [diagnostics::Word; N],
    ) -> Told {
        self.builder.tell(code, at, words);
        Told
    }

    /// One deeper into an expression.
    fn part(&mut self) -> Result<(), Told> {
        self.parts += 1;
        let at = self.word().span;
        match self.parts > MOST {
            true => Err(self.tell(TOO_DEEP, at, [])),
            false => Ok(()),
        }
    }

    fn line(&mut self, body: &mut Vec<Stmt>) -> Result<(), Told> {
        if self.word().kind == Kind::LineEnd {
            return Ok(());
        }
        let name = self.take(Kind::Name, ("a name", "um nome"))?;
        if self.takes("is") {
            self.meaning(name)?;
        } else if self.takes("when") {
            self.rule(name, body)?;
        } else {
            return Err(self.expected(("`is` or `when`", "`is` ou `when`")));
        }
        match self.word().kind {
            Kind::LineEnd => Ok(()),
            _ => Err(self.expected(("the end of the line", "o fim da linha"))),
        }
    }

    /// `lamp is output 1`
    fn meaning(&mut self, name: Word) -> Result<(), Told> {
        let start = self.word().span;
        let kind = match self.word().of(self.text) {
            "input" => 'I',
            "output" => 'Q',
            "memory" => 'M',
            _ => {
                return Err(self.expected((
                    "`input`, `output` or `memory`",
                    "`input`, `output` ou `memory`",
                )));
            }
        };
        self.at += 1;
        let number = self.take(Kind::Number, ("a number", "um número"))?;
        let address = format!("%{kind}X{}", number.of(self.text));
        let at = start.to(number.span);
        let name_of = name.of(self.text);
        self.names.push(name_of);
        let point = self.builder.address_for(&address, TypeId::BOOL, at);
        if point.is_none() {
            // Of a name whose place is wrong, nothing more is told.
            self.builder.hide(name_of);
            return Err(Told);
        }
        let traits = Traits {
            point,
            ..Traits::default()
        };
        self.builder
            .declare(name_of, name.span, TypeId::BOOL, Section::Var, traits);
        Ok(())
    }

    /// `lamp when start for 5 s`
    fn rule(&mut self, name: Word, body: &mut Vec<Stmt>) -> Result<(), Told> {
        let target = self.target(name);
        let mut value = self.either()?;
        let at = name.span.to(self.words[self.at - 1].span);
        if self.takes("for") {
            let time = self.time()?;
            value = self.waited(name, value, time, body)?;
        }
        body.extend(self.builder.assign(target?, value, at));
        Ok(())
    }

    fn either(&mut self) -> Result<Expr, Told> {
        self.chain("or", Binary::Or, |reader| {
            reader.chain("and", Binary::And, Self::one)
        })
    }

    fn chain(
        &mut self,
        word: &str,
        op: Binary,
        part: impl Fn(&mut Self) -> Result<Expr, Told>,
    ) -> Result<Expr, Told> {
        let mut left = part(self)?;
        while self.takes(word) {
            self.part()?;
            let right = part(self)?;
            let at = left.at.to(right.at);
            left = self.builder.logic(op, left, right, at);
        }
        Ok(left)
    }

    fn one(&mut self) -> Result<Expr, Told> {
        let first = self.word();
        if self.takes("not") {
            self.part()?;
            let operand = self.one()?;
            return Ok(self.builder.not(operand, first.span));
        }
        if first.kind == Kind::Open {
            self.at += 1;
            self.part()?;
            let inner = self.either()?;
            self.take(Kind::Close, ("`)`", "`)`"))?;
            return Ok(inner);
        }
        let name = self.take(
            Kind::Name,
            ("a name, `not` or `(`", "um nome, `not` ou `(`"),
        )?;
        let target = self.target(name).ok();
        Ok(self.builder.read(target, name.span))
    }

    /// What a name stands for; nothing is told twice of one that stands for nothing.
    fn target(&mut self, name: Word) -> Result<Target, Told> {
        let written = name.of(self.text);
        if self.builder.find(written).is_none() && !self.builder.is_hidden(written) {
            let help = self.help(written);
            self.builder.hide(written);
            return Err(self.tell(NOT_DECLARED, name.span, [written.into(), help]));
        }
        self.builder.name(written, name.span).ok_or(Told)
    }

    /// How a name may be declared, or which declared one was meant.
    fn help(&mut self, written: &str) -> diagnostics::Word {
        self.asked += 1;
        let names = self.names.iter().copied();
        match nearest(written, names.filter(|_| self.asked <= MOST_NEAR)) {
            Some(near) => both(
                format!("did you mean `{near}`?"),
                format!("você quis dizer `{near}`?"),
            ),
            None => both(
                format!("define it first: `{written} is input 1`"),
                format!("defina-o antes: `{written} is input 1`"),
            ),
        }
    }

    /// The ms of `5 s` or `500 ms`.
    fn time(&mut self) -> Result<Expr, Told> {
        let number = self.take(Kind::Number, ("a number", "um número"))?;
        let factor = match (self.takes("s"), self.takes("ms")) {
            (true, _) => 1000,
            (_, true) => 1,
            _ => return Err(self.expected(("`s` or `ms`", "`s` ou `ms`"))),
        };
        let ms = number.of(self.text).parse::<i32>().ok();
        let Some(ms) = ms.and_then(|ms| ms.checked_mul(factor)) else {
            let written = number.of(self.text).into();
            return Err(self.tell(TOO_LONG, number.span, [written]));
        };
        Ok(self
            .builder
            .literal(Base::Time, Value::Int(ms.into()), number.span))
    }

    /// A timer of the standard, whose IN is the value so far.
    fn waited(
        &mut self,
        name: Word,
        value: Expr,
        time: Expr,
        body: &mut Vec<Stmt>,
    ) -> Result<Expr, Told> {
        let at = value.at;
        let timer = Standard::Ton;
        let kind = tree::Kind::Standard(timer);
        let ty = self.builder.tree.types.add_kind(kind, timer.cells());
        // No name that a person can write.
        let instance = format!("{}#{}", name.of(self.text), name.span.start);
        let traits = Traits {
            unseen: true,
            ..Traits::default()
        };
        self.builder
            .declare(&instance, name.span, ty, Section::Var, traits);
        let target = self.builder.name(&instance, name.span).ok_or(Told)?;
        let argument = |name: &str, value: Expr| Argument {
            name: Some((name.to_owned(), at)),
            out: false,
            at: value.at,
            given: Given::Value(value),
        };
        let arguments = vec![argument("IN", value), argument("PT", time)];
        body.extend(self.builder.block(target.clone(), arguments, at));
        let done = self.builder.member(target, "Q", at);
        Ok(self.builder.read(done, at))
    }
}
