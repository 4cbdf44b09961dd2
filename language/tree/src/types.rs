//! The types of a text: elementary, and what it derives from them.
//!
//! A [`TypeId`] names one. Owns how many cells a value takes and where its parts stand. Must not know
//! variables, statements or how a type is written.

use super::base::Base;
use super::enumeration::Enumeration;
use super::standard::Standard;
use super::value::Value;
use std::sync::Arc;

/// A type of a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct TypeId(pub u32);

impl TypeId {
    /// An elementary type.
    pub const fn of(base: Base) -> TypeId {
        TypeId(base as u32)
    }

    /// BOOL.
    pub const BOOL: TypeId = TypeId::of(Base::Bool);
}

/// What a type is.
#[derive(Clone, Debug, PartialEq)]
pub enum Kind {
    /// Elementary.
    Base(Base),
    /// STRING or WSTRING of at most so many characters.
    Text {
        /// Which of the two.
        base: Base,
        /// The most characters.
        most: u32,
    },
    /// Named values.
    Enum(Arc<Enumeration>),
    /// A part of an integer type.
    Range {
        /// The type.
        base: Base,
        /// The least value.
        low: i128,
        /// The greatest.
        high: i128,
    },
    /// Elements in a row, the last subscript the fastest.
    Array {
        /// The first and the last subscript of each dimension.
        bounds: Vec<(i64, i64)>,
        /// Of what.
        of: TypeId,
    },
    /// Members in a row.
    Struct(Vec<Member>),
    /// A function block of the standard; its cells are [`Standard::cells`].
    Standard(Standard),
    /// A function block of the text, by the number of its unit.
    Block(u32),
}

/// A member of a structure.
#[derive(Clone, Debug, PartialEq)]
pub struct Member {
    /// As it was declared.
    pub name: String,
    /// Its type.
    pub ty: TypeId,
    /// Its first cell, counted from the structure's.
    pub offset: u32,
    /// With what it begins, if the structure says so.
    pub initial: Option<Arc<Initial>>,
}

/// With what a variable begins.
#[derive(Clone, Debug, PartialEq)]
pub enum Initial {
    /// A value of an elementary type.
    Value(Value),
    /// Elements of an array, each so often; none: as the type of the element says.
    Elements(Vec<(u32, Option<Arc<Initial>>)>),
    /// Members of a structure or inputs of a block, by their first cells and types.
    Members(Vec<(u32, TypeId, Arc<Initial>)>),
}

/// One type.
#[derive(Clone, Debug)]
pub struct Type {
    /// Its name; none of a type that stands where it is used.
    pub name: Option<String>,
    /// What it is; another name of it shares this.
    pub kind: Arc<Kind>,
    /// The cells that a value of it takes.
    pub cells: u32,
    /// With what its variables begin, if it says so.
    pub initial: Option<Arc<Initial>>,
    /// The type of which this is another name.
    pub alias: Option<TypeId>,
}

/// All types of a text.
#[derive(Clone, Debug)]
pub struct Types {
    all: Vec<Type>,
    /// Of each, how many types stand in one another in it; 0 of one without parts.
    depths: Vec<u32>,
}

impl Default for Types {
    fn default() -> Types {
        let one = |&base: &Base| Type {
            name: None,
            kind: Arc::new(Kind::Base(base)),
            cells: 1,
            initial: None,
            alias: None,
        };
        Types {
            all: Base::ALL.iter().map(one).collect(),
            depths: vec![0; Base::ALL.len()],
        }
    }
}

impl Types {
    /// Adds a type.
    pub fn add(&mut self, ty: Type) -> TypeId {
        let depth = match (&*ty.kind, ty.alias) {
            // A name of a name is one more step; the first name of a type is none.
            (_, Some(of)) => self.depth(of) + u32::from(self.get(of).name.is_some()),
            (Kind::Array { of, .. }, None) => self.depth(*of) + 1,
            (Kind::Struct(members), None) => {
                self.deepest(members.iter().map(|member| member.ty)) + 1
            }
            _ => 0,
        };
        self.all.push(ty);
        self.depths.push(depth);
        TypeId(self.all.len() as u32 - 1)
    }

    /// How many types stand in one another in it; 0 of one without parts.
    pub fn depth(&self, id: TypeId) -> u32 {
        self.depths.get(id.0 as usize).copied().unwrap_or(0)
    }

    /// The depth of the deepest of these; 0 of none.
    fn deepest(&self, parts: impl Iterator<Item = TypeId>) -> u32 {
        parts.map(|part| self.depth(part)).max().unwrap_or(0)
    }

    /// Says of what the instances of a block consist, once its declarations are known: so many cells, of these types.
    pub fn close_block(&mut self, id: TypeId, cells: u32, parts: impl Iterator<Item = TypeId>) {
        let depth = self.deepest(parts) + 1;
        let at = id.0 as usize;
        if let (Some(ty), Some(known)) = (self.all.get_mut(at), self.depths.get_mut(at)) {
            (ty.cells, *known) = (cells, depth);
        }
    }

    /// Adds a type without a name.
    pub fn add_kind(&mut self, kind: Kind, cells: u32) -> TypeId {
        self.add(Type {
            name: None,
            kind: Arc::new(kind),
            cells,
            initial: None,
            alias: None,
        })
    }

    /// The type; that of BOOL where there is none.
    pub fn get(&self, id: TypeId) -> &Type {
        self.all.get(id.0 as usize).unwrap_or(&self.all[0])
    }

    /// What it is.
    pub fn kind(&self, id: TypeId) -> &Kind {
        &self.get(id).kind
    }

    /// The elementary type as which its values are held; none of what has parts.
    pub fn base(&self, id: TypeId) -> Option<Base> {
        match self.kind(id) {
            Kind::Base(base) | Kind::Text { base, .. } | Kind::Range { base, .. } => Some(*base),
            Kind::Enum(_) => Some(Base::Int),
            _ => None,
        }
    }

    /// Whether values of it are a number, a bit or a text, without parts.
    pub fn is_scalar(&self, id: TypeId) -> bool {
        self.base(id).is_some()
    }

    /// With what variables of this type begin: as the type it stands for says, and then as itself does.
    pub fn initials(&self, id: TypeId) -> Vec<Arc<Initial>> {
        let mut all = Vec::new();
        let mut id = id;
        loop {
            let ty = self.get(id);
            all.extend(ty.initial.clone());
            match ty.alias.filter(|of| of.0 < id.0) {
                Some(of) => id = of,
                None => break,
            }
        }
        all.reverse();
        all
    }

    /// The type after other names.
    pub fn strip(&self, id: TypeId) -> TypeId {
        // An alias is added after what it stands for, so this ends.
        let mut id = id;
        while let Some(of) = self.get(id).alias.filter(|of| of.0 < id.0) {
            id = of;
        }
        id
    }

    /// Whether both are the same type, by their names or, without names, by what they consist of.
    pub fn same(&self, a: TypeId, b: TypeId) -> bool {
        let (a, b) = (self.strip(a), self.strip(b));
        if a == b {
            return true;
        }
        match (self.kind(a), self.kind(b)) {
            (Kind::Text { base, .. }, _) | (Kind::Base(base), _) => {
                self.base(b) == Some(*base)
                    && !matches!(self.kind(b), Kind::Enum(_) | Kind::Range { .. })
            }
            (
                Kind::Array { bounds, of },
                Kind::Array {
                    bounds: others,
                    of: other,
                },
            ) => bounds == others && self.same(*of, *other),
            (Kind::Standard(a), Kind::Standard(b)) => a == b,
            // Every other type is made once, and is compared above.
            _ => false,
        }
    }

    /// As a person writes it: `INT`, `Motor`, `ARRAY[1..4] OF INT`.
    pub fn name(&self, id: TypeId) -> String {
        self.name_within(id, 8)
    }

    fn name_within(&self, id: TypeId, depth: u32) -> String {
        let ty = self.get(id);
        if let Some(name) = &ty.name {
            return name.clone();
        }
        match &*ty.kind {
            Kind::Base(base) => base.name().to_owned(),
            Kind::Text { base, most } => format!("{base}[{most}]"),
            Kind::Enum(values) => format!("({})", values.some()),
            Kind::Range { base, low, high } => format!("{base}({low}..{high})"),
            Kind::Array { bounds, of } => {
                let bounds = bounds.iter().take(MOST_NAMED);
                let bounds: Vec<String> = bounds.map(|(a, b)| format!("{a}..{b}")).collect();
                let of = match depth {
                    0 => "…".to_owned(),
                    _ => self.name_within(*of, depth - 1),
                };
                format!("ARRAY[{}] OF {of}", bounds.join(","))
            }
            Kind::Struct(_) => "STRUCT".to_owned(),
            Kind::Standard(block) => block.name().to_owned(),
            Kind::Block(_) => "FUNCTION_BLOCK".to_owned(),
        }
    }
}

/// More dimensions of an array than these are not named in a message.
const MOST_NAMED: usize = 12;
