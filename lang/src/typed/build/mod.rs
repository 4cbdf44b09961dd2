//! How a front end makes a tree.
//!
//! A front end reads its text into a syntax tree of its own and then tells a [`Builder`] what stands there, in this
//! order. Each step tells what is wrong in it, once, in the words that all languages share; what came of something
//! wrong is a [`ExprKind::Wrong`], of which nothing more is told.
//!
//! 1. **Types**, if the language derives any: `builder.tree.types.add(…)`, then [`Builder::name_type`].
//! 2. **Units**: [`Builder::unit`] makes one and [`Builder::enter`] goes into it. [`Builder::declare`] declares a
//!    variable ([`Section`] says of which kind), [`Builder::close`] ends a block's declarations, so that instances
//!    of it can be declared. `builder.leave()` goes out; without a unit, `declare` declares globals.
//! 3. **Expressions**, inside out: [`Builder::whole`], [`Builder::literal`], [`Builder::name`] with
//!    [`Builder::member`] and [`Builder::subscript`] and then [`Builder::read`]; [`Builder::arithmetic`],
//!    [`Builder::logic`], [`Builder::compare`], [`Builder::negate`], [`Builder::not`]; [`Builder::function`] (of the
//!    norm) and [`Builder::call`] (of the text). They find the common type, put in conversions and fold constants.
//!    [`Builder::explicit`] converts as a language asks, [`Builder::coerce`] as a place needs it.
//! 4. **Statements**: [`Builder::assign`], [`Builder::condition`] for IF, WHILE and REPEAT, [`Builder::counting`]
//!    for FOR, [`Builder::selector`] and [`Builder::labels`] for CASE, [`Builder::print`], [`Builder::call`], [`Builder::block`]. Others are made as they are.
//! 5. [`Builder::body`] gives a unit its statements, and [`Builder::finish`] gives the tree.
//!
//! A variable of the front end's own is `unseen`, or [`Section::Temp`] if it need not last; what holds a symbol in one
//! of two cells is pushed to `builder.tree.symbols` as [`Holds::Either`](super::Holds). `%` before a name makes
//! [`Builder::name`] take it for an address. A declaration that is wrong is followed by [`Builder::hide`], so that
//! nothing more is told of its name.
//!
//! A program of a language without types and units takes a few lines:
//!
//! ```text
//! let mut builder = Builder::new(text, Letters::Alike, &mut found);
//! let main = builder.unit("main", UnitKind::Program, span);
//! builder.enter(main);
//! builder.declare("x", span, TypeId::of(Base::Int), Section::Var, Traits::default());
//! let one = builder.whole(1, span);
//! let to = builder.name("x", span);              // a Target, or None: told
//! let statement = to.and_then(|to| builder.assign(to, one, span));
//! builder.body(main, statement.into_iter().collect());
//! builder.leave();
//! let tree = builder.finish();                   // None where there are errors
//! ```

mod arguments;
mod calls;
mod cells;
mod coerce;
mod declare;
mod finish;
mod functions;
mod operations;
mod operators;
mod places;
mod points;
mod remedies;
mod statements;
mod symbols;
mod words;

pub(crate) use arguments::{Argument, Given};
pub(crate) use declare::{Section, Traits};
pub(crate) use functions::is_function;
pub(crate) use places::Target;
pub(crate) use words::both;

use super::tree::{Expr, ExprKind, Point, Tree, Unit, UnitKind};
use super::types::TypeId;
use super::value::Value;
use super::{Base, Kind};
use crate::diagnostics::{Code, Found, Span, Word};
use crate::names::near::nearest;
use declare::Variable;
use std::collections::{HashMap, HashSet};

/// More cells than this no program has; the board has room for fewer than a hundred.
pub(crate) const MOST_CELLS: u32 = 250_000;

/// Calls stand in calls no deeper.
const MOST_CALLS: u32 = 60;

/// For more names than this, no near one is looked for.
const MOST_NEAR: u32 = 32;

/// Nor among more names than these.
const MOST_NAMES: usize = 4_000;

/// Whether letters of both cases are the same in names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Letters {
    /// `Motor` is `MOTOR`.
    Alike,
    /// They are two names.
    Apart,
}

/// What a name stands for.
#[derive(Clone, Debug)]
pub(crate) enum Named {
    Variable(Variable),
    /// A value of an enumeration, or VAR CONSTANT.
    Constant(Value, TypeId),
    /// A value of more than one enumeration; of this one too.
    Ambiguous(TypeId),
    Type(TypeId),
    Unit(u32),
}

/// What a unit takes and gives.
#[derive(Clone, Debug)]
pub(crate) struct Param {
    pub name: String,
    pub section: Section,
    pub ty: TypeId,
    /// Its first cell, or of VAR_IN_OUT its number.
    pub offset: u32,
}

/// A unit while it is made.
#[derive(Debug)]
pub(crate) struct Draft {
    pub unit: Unit,
    pub names: HashMap<String, Named>,
    pub params: Vec<Param>,
    /// Of a function.
    pub result: Option<TypeId>,
    /// Of a block: its declarations are complete.
    pub closed: bool,
    /// Of a function: its result is stored somewhere.
    pub gives: bool,
    /// It calls a timer, a counter or an edge.
    pub timed: bool,
    /// A declaration in it is wrong, so that not all of its names are known.
    pub incomplete: bool,
    /// The type of a block's instances.
    pub block: TypeId,
}

/// An instance by the unit that has it and its place there; globals are nobody's.
type Instance = (Option<usize>, super::Root, u32);

/// A call of an instance of a block of the text.
struct BlockCall {
    instance: Instance,
    from: Option<usize>,
    unit: u32,
    in_loop: bool,
    at: Span,
}

pub(crate) struct Builder<'t, 'f> {
    pub text: &'t str,
    pub found: &'f mut Found,
    pub tree: Tree,
    letters: Letters,
    globals: HashMap<String, Named>,
    drafts: Vec<Draft>,
    current: Option<usize>,
    /// Who calls whom, and where.
    edges: Vec<(u32, u32, Span)>,
    points: HashMap<Point, u32>,
    shown: Vec<(String, Variable, Option<u32>)>,
    cells: u64,
    asked: u32,
    /// How many loops are open where a statement is made.
    pub loops: u32,
    /// The variables that count open loops.
    counters: Vec<(super::Root, u32)>,
    called: HashMap<Instance, Span>,
    /// Calls of blocks of the text, of which some have timers within.
    calls: Vec<BlockCall>,
    writes: bool,
    /// Of the unit that is called not all parameters are known.
    lenient: bool,
    hidden: HashSet<(Option<usize>, String)>,
}

impl<'t, 'f> Builder<'t, 'f> {
    pub fn new(text: &'t str, letters: Letters, found: &'f mut Found) -> Builder<'t, 'f> {
        Builder {
            text,
            found,
            tree: Tree::default(),
            letters,
            globals: HashMap::new(),
            drafts: Vec::new(),
            current: None,
            edges: Vec::new(),
            points: HashMap::new(),
            shown: Vec::new(),
            cells: 0,
            asked: 0,
            loops: 0,
            counters: Vec::new(),
            called: HashMap::new(),
            calls: Vec::new(),
            writes: false,
            lenient: false,
            hidden: HashSet::new(),
        }
    }

    /// A name as the tables have it.
    pub fn key(&self, name: &str) -> String {
        match self.letters {
            Letters::Alike => name.to_uppercase(),
            Letters::Apart => name.to_owned(),
        }
    }

    /// What stands in the text there, short enough for a message.
    pub fn written(&self, at: Span) -> String {
        let text = self.text.get(at.range()).unwrap_or_default();
        let mut words = text.split_whitespace();
        let mut line = words.next().unwrap_or_default().to_owned();
        for word in words {
            if line.len() > 40 {
                break;
            }
            line.push(' ');
            line.push_str(word);
        }
        match line.char_indices().nth(40) {
            Some((end, _)) => format!("{}…", &line[..end]),
            None => line,
        }
    }

    pub fn tell<const N: usize>(&mut self, code: Code, at: Span, words: [Word; N]) {
        self.found.tell(code, at, words);
    }

    /// What is wrong has been told.
    pub fn wrong(&self, at: Span) -> Expr {
        Expr {
            kind: ExprKind::Wrong,
            base: Base::Bool,
            ty: TypeId::BOOL,
            at,
        }
    }

    /// Makes a unit; of a function, its result is declared by [`Builder::result`].
    pub fn unit(&mut self, name: &str, kind: UnitKind, at: Span) -> u32 {
        let number = self.drafts.len() as u32;
        let block = self.tree.types.add(super::Type {
            name: Some(name.to_owned()),
            kind: Kind::Block(number),
            cells: 0,
            initial: None,
            alias: None,
        });
        self.drafts.push(Draft {
            unit: Unit {
                name: name.to_owned(),
                kind,
                own: Vec::new(),
                locals: Vec::new(),
                references: 0,
                body: Vec::new(),
                at,
            },
            names: HashMap::new(),
            params: Vec::new(),
            result: None,
            closed: kind != UnitKind::Block,
            gives: false,
            timed: false,
            incomplete: false,
            block,
        });
        let named = match kind {
            UnitKind::Block => Named::Type(block),
            UnitKind::Function | UnitKind::Program => Named::Unit(number),
        };
        if kind == UnitKind::Program {
            self.tree.programs.push(number);
            // A variable may have its name.
            return number;
        }
        let key = self.key(name);
        if self.globals.insert(key, named).is_some() {
            self.tell(Code::StNameTwice, at, [name.into()]);
        }
        number
    }

    /// Goes into a unit: what is declared and named from here on is in it.
    pub fn enter(&mut self, unit: u32) {
        self.current = Some(unit as usize);
    }

    /// Goes out of it.
    pub fn leave(&mut self) {
        self.current = None;
    }

    /// Where it is, to go back there.
    pub fn inside(&self) -> Option<usize> {
        self.current
    }

    /// Goes back to where it was.
    pub fn go(&mut self, back: Option<usize>) {
        self.current = back;
    }

    /// The name of the function or block that it is in.
    pub fn name_here(&self) -> Option<String> {
        let draft = self.current.and_then(|unit| self.drafts.get(unit))?;
        (draft.unit.kind != UnitKind::Program).then(|| draft.unit.name.clone())
    }

    /// The result of the function that it is in needs no store.
    pub fn gives(&mut self) {
        if let Some(draft) = self.here() {
            draft.gives = true;
        }
    }

    /// The program may change nothing without a word about it.
    pub fn may_do_nothing(&mut self) {
        self.writes = true;
    }

    /// A name whose declaration is wrong: what is done with it is not told.
    pub fn hide(&mut self, name: &str) {
        let key = (self.current, self.key(name));
        self.hidden.insert(key);
        if let Some(draft) = self.here() {
            draft.incomplete = true;
        }
    }

    /// Whether the declaration of this name is wrong, or what is wrong with the name has been told.
    pub fn is_hidden(&self, name: &str) -> bool {
        if self.hidden.is_empty() {
            return false;
        }
        let key = self.key(name);
        let here = self.current.and_then(|unit| self.drafts.get(unit));
        if here.is_some_and(|draft| draft.names.contains_key(&key)) {
            return false;
        }
        let globally = !self.globals.contains_key(&key);
        self.hidden.contains(&(self.current, key.clone()))
            || globally && self.hidden.contains(&(None, key))
    }

    /// What is wrong with this name has been told: not again in this unit.
    pub(super) fn told_name(&mut self, name: &str) {
        let key = (self.current, self.key(name));
        self.hidden.insert(key);
    }

    /// Whether an instance of this type takes or gives something of this name.
    pub fn has_parameter(&self, ty: TypeId, name: &str) -> bool {
        let key = self.key(name);
        match self.tree.types.kind(ty) {
            Kind::Standard(block) => block.part(&key).is_some(),
            Kind::Block(unit) => self.draft(*unit).is_some_and(|draft| {
                let mut params = draft.params.iter();
                params.any(|param| self.key(&param.name) == key)
            }),
            _ => false,
        }
    }

    pub fn draft(&self, unit: u32) -> Option<&Draft> {
        self.drafts.get(unit as usize)
    }

    fn here(&mut self) -> Option<&mut Draft> {
        self.current.and_then(|unit| self.drafts.get_mut(unit))
    }

    /// The kind of the unit that it is in.
    pub fn kind_here(&self) -> Option<UnitKind> {
        let unit = self.current.and_then(|unit| self.drafts.get(unit));
        unit.map(|draft| draft.unit.kind)
    }

    /// Gives a type its name.
    pub fn name_type(&mut self, name: &str, ty: TypeId, at: Span) {
        let key = self.key(name);
        if self.globals.insert(key, Named::Type(ty)).is_some() {
            self.tell(Code::StNameTwice, at, [name.into()]);
        }
    }

    /// Makes the values of an enumeration known.
    pub fn name_values(&mut self, ty: TypeId) {
        let Kind::Enum(names) = self.tree.types.kind(ty).clone() else {
            return;
        };
        for (number, name) in (0..).zip(names) {
            let named = Named::Constant(Value::Int(number), ty);
            let key = self.key(&name);
            let before = self.globals.get(&key);
            let named = match before {
                None => named,
                Some(Named::Constant(..) | Named::Ambiguous(_)) => Named::Ambiguous(ty),
                Some(_) => continue,
            };
            self.globals.insert(key, named);
        }
    }

    /// What a name stands for here.
    pub fn find(&self, name: &str) -> Option<&Named> {
        let key = self.key(name);
        let here = self.current.and_then(|unit| self.drafts.get(unit));
        let own = here.and_then(|draft| draft.names.get(&key));
        own.or_else(|| self.globals.get(&key))
    }

    /// The type of this name, which a variable may have too.
    pub fn find_type(&self, name: &str) -> Option<TypeId> {
        match self.globals.get(&self.key(name)) {
            Some(Named::Type(ty)) => Some(*ty),
            _ => None,
        }
    }

    /// The name that may have been meant, in words.
    pub fn near(&mut self, name: &str, otherwise: Word) -> Word {
        self.asked += 1;
        if self.asked > MOST_NEAR {
            return otherwise;
        }
        let here = self.current.and_then(|unit| self.drafts.get(unit));
        let own = here.into_iter().flat_map(|draft| draft.unit_names());
        let globals = self.globals.keys().map(String::as_str);
        // For no longer than the names of the text live.
        let known = functions::names().map(shorter);
        let mut names: Vec<&str> = own.chain(globals).chain(known).collect();
        if names.len() > MOST_NAMES {
            return otherwise;
        }
        // Of two that are as near, the same is told each time.
        names.sort_unstable();
        match nearest(name, names.into_iter()) {
            Some(near) => {
                let near = self.spelt(near);
                both(format!("is it `{near}`?"), format!("seria `{near}`?"))
            }
            None => otherwise,
        }
    }

    /// A name of the tables as it was declared.
    fn spelt(&self, key: &str) -> String {
        match self.find(key) {
            Some(Named::Variable(variable)) => variable.name.clone(),
            Some(Named::Type(ty)) => self.tree.types.name(*ty),
            Some(Named::Unit(unit)) => match self.draft(*unit) {
                Some(draft) => draft.unit.name.clone(),
                None => key.to_owned(),
            },
            _ => key.to_owned(),
        }
    }

    /// Gives a unit its statements.
    pub fn body(&mut self, unit: u32, body: Vec<super::Stmt>) {
        if let Some(draft) = self.drafts.get_mut(unit as usize) {
            draft.unit.body = body;
        }
    }
}

/// The same for a shorter time.
fn shorter<'n>(name: &'static str) -> &'n str {
    name
}

impl Draft {
    fn unit_names(&self) -> impl Iterator<Item = &str> {
        self.names.keys().map(String::as_str)
    }
}
