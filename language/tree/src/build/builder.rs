//! A tree while it is made.
//!
//! Owns units and where the front end is in them. Must not know what statements mean.

use super::named::{Letters, Named, Param, Turn, Variable};
use super::stages::{Before, Closed, Declaring, Enter};
use crate::{Base, Expr, ExprKind, Kind, Root, Stmt, Tree, Type, TypeId, Unit, UnitKind};
use std::borrow::Cow;
use std::collections::{BTreeMap, HashMap, HashSet};
use unoclp_core::Board;
use unoclp_point::Address;
use unoclp_text::diagnostics::{Code, Found, Span, Word};
use unoclp_text::points::Spellings;

/// More cells than this no program has; the board has room for fewer than a hundred.
pub const MOST_CELLS: u32 = 250_000;

/// A unit while it is made.
#[derive(Debug)]
pub struct Draft {
    /// The unit.
    pub unit: Unit,
    /// What its names stand for.
    pub names: HashMap<String, Named>,
    /// What it takes and gives, in its order.
    pub params: Vec<Param>,
    /// Of a function.
    pub result: Option<TypeId>,
    /// Of a block: its declarations are complete.
    pub(super) closed: bool,
    /// Of a function: its result is stored somewhere.
    pub gives: bool,
    /// A declaration in it is wrong, so that not all of its names are known.
    pub incomplete: bool,
    /// The type of a block's instances.
    pub(super) block: TypeId,
    /// Its constants that have cells: the name, the type and the offset of each.
    pub constants: Vec<(String, TypeId, u32)>,
}

/// A tree while a front end makes it: see [`build`](super).
pub struct Builder<'t, 'f> {
    /// The text.
    pub text: &'t str,
    /// The board that the text is for.
    pub board: Board,
    /// What is told of the text.
    pub found: &'f mut Found,
    /// The tree so far.
    pub tree: Tree,
    pub(super) letters: Letters,
    /// A division by a constant 0 is no mistake of the text: it gives 0, and sets S 04.
    pub divides_by_zero: bool,
    /// The text is in Instruction List.
    pub is_list: bool,
    /// Integers go into each other, each cut to what it is stored in.
    pub is_wide: bool,
    pub(super) globals: HashMap<String, Named>,
    /// How many of these are VAR_EXTERNAL of globals that the text does not declare.
    pub(super) externals: usize,
    pub(super) drafts: Vec<Draft>,
    pub(super) current: Option<usize>,
    /// Who calls whom, and where.
    pub(super) edges: Vec<(u32, u32, Span)>,
    pub(super) points: HashMap<Address, u32>,
    /// Where points are that no board has, and whether that has been told.
    pub moved: HashMap<String, (String, bool)>,
    pub(super) spellings: Spellings,
    pub(super) shown: Vec<(String, Variable, Option<u32>)>,
    pub(super) cells: u64,
    pub(super) asked: u32,
    /// How many loops are open where a statement is made.
    pub loops: u32,
    /// What is stored in an input lasts until the next scan.
    pub keeps_inputs: bool,
    /// The cells of inputs in which something is stored, and where first.
    pub(super) stored_inputs: BTreeMap<u32, Span>,
    /// The cells that say whether an instance was called, by the first cell of each.
    pub(super) enos: HashMap<u32, u32>,
    /// The variables that count open loops.
    pub(super) counters: Vec<(Root, u32)>,
    /// Of loops whose bodies are made, one turn each.
    pub(super) turns: Vec<Turn>,
    /// How many turns have been made of them.
    pub(super) turns_made: usize,
    /// Inputs that their own units change, by the unit and the offset, which has been told.
    pub(super) inputs_written: HashSet<(Option<usize>, u32)>,
    pub(super) writes: bool,
    /// Of the unit that is called not all parameters are known.
    pub(super) lenient: bool,
    pub(super) hidden: HashSet<(Option<usize>, String)>,
}

impl<'t, 'f> Builder<'t, 'f> {
    /// Begins a tree of a text for a board; what is wrong goes to `found`.
    pub fn new(
        text: &'t str,
        letters: Letters,
        board: Board,
        found: &'f mut Found,
    ) -> Builder<'t, 'f> {
        Builder {
            text,
            board,
            found,
            tree: Tree::default(),
            letters,
            divides_by_zero: false,
            is_list: false,
            is_wide: false,
            globals: HashMap::new(),
            externals: 0,
            drafts: Vec::new(),
            current: None,
            edges: Vec::new(),
            points: HashMap::new(),
            moved: HashMap::new(),
            spellings: Spellings::default(),
            shown: Vec::new(),
            cells: 0,
            asked: 0,
            loops: 0,
            keeps_inputs: false,
            stored_inputs: BTreeMap::new(),
            enos: HashMap::new(),
            counters: Vec::new(),
            turns: Vec::new(),
            turns_made: 0,
            inputs_written: HashSet::new(),
            writes: false,
            lenient: false,
            hidden: HashSet::new(),
        }
    }

    /// A name as the tables have it.
    pub fn key(&self, name: &str) -> String {
        match self.letters {
            Letters::Alike if name.is_ascii() => name.to_ascii_uppercase(),
            Letters::Alike => name.to_uppercase(),
            Letters::Apart => name.to_owned(),
        }
    }

    /// The same to look it up: without memory of its own where it fits this room, as nearly all names do.
    pub(super) fn folded<'n>(&self, name: &'n str, room: &'n mut [u8; 32]) -> Cow<'n, str> {
        if self.letters == Letters::Apart {
            return Cow::Borrowed(name);
        }
        let Some(room) = room.get_mut(..name.len()).filter(|_| name.is_ascii()) else {
            return Cow::Owned(self.key(name));
        };
        room.copy_from_slice(name.as_bytes());
        room.make_ascii_uppercase();
        match std::str::from_utf8(room) {
            Ok(key) => Cow::Borrowed(key),
            Err(_) => Cow::Owned(self.key(name)),
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

    /// Tells this of a place of the text.
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
    pub fn unit(&mut self, name: &str, kind: UnitKind, at: Span) -> Declaring {
        let number = self.drafts.len() as u32;
        let block = self.tree.types.add(Type {
            name: Some(name.to_owned()),
            kind: Kind::Block(number).into(),
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
            incomplete: false,
            block,
            constants: Vec::new(),
        });
        let named = match kind {
            UnitKind::Block => Named::Type(block),
            UnitKind::Function | UnitKind::Program => Named::Unit(number),
        };
        if kind == UnitKind::Program {
            self.tree.programs.push(number);
            // A variable may have its name.
            return Declaring(number);
        }
        let key = self.key(name);
        if self.globals.insert(key, named).is_some() {
            self.tell(Code::StNameTwice, at, [name.into()]);
        }
        Declaring(number)
    }

    /// Goes into a unit: what is declared and named from here on is in it.
    pub fn enter(&mut self, unit: &impl Enter) -> Before {
        Before(self.current.replace(unit.number() as usize))
    }

    /// Goes out of all units: what is declared from here on is for all.
    pub fn outside(&mut self) -> Before {
        Before(self.current.take())
    }

    /// Goes back to where it was.
    pub fn back(&mut self, before: Before) {
        self.current = before.0;
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

    /// A unit by its number.
    pub fn draft(&self, unit: u32) -> Option<&Draft> {
        self.drafts.get(unit as usize)
    }

    /// The type of a block's instances; none of another unit.
    pub fn block_type(&self, unit: &Closed) -> Option<TypeId> {
        let draft = self.draft(unit.0)?;
        (draft.unit.kind == UnitKind::Block).then_some(draft.block)
    }

    pub(super) fn here(&mut self) -> Option<&mut Draft> {
        self.current.and_then(|unit| self.drafts.get_mut(unit))
    }

    /// The kind of the unit that it is in.
    pub fn kind_here(&self) -> Option<UnitKind> {
        let unit = self.current.and_then(|unit| self.drafts.get(unit));
        unit.map(|draft| draft.unit.kind)
    }

    /// Gives a unit its statements.
    pub fn body(&mut self, unit: Closed, body: Vec<Stmt>) {
        if let Some(draft) = self.drafts.get_mut(unit.0 as usize) {
            draft.unit.body = body;
        }
    }
}
