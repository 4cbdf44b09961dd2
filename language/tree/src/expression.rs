//! Expressions of the typed tree, and the places that they read.
//!
//! Each has its type, and each conversion is a node.

use super::base::Base;
use super::types::TypeId;
use super::value::Value;
use unoclp_text::diagnostics::Span;

/// From where a place is counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Root {
    /// The cells of the tree.
    Static,
    /// Those of the instance whose body this is.
    Own,
    /// Those of this call.
    Local,
    /// Those that the caller lends, by the number of the VAR_IN_OUT.
    Lent(u32),
}

/// Where a value is: a root, an offset in cells, and computed subscripts.
#[derive(Clone, Debug)]
pub struct Place {
    /// From where it is counted.
    pub root: Root,
    /// How many cells after it.
    pub offset: u32,
    /// What is computed: each is added. Constant subscripts and members are in `offset`.
    pub indices: Vec<Index>,
    /// Where it stands.
    pub at: Span,
}

/// A computed subscript. Outside of its bounds the place reads 0, takes nothing, and S 04 is set.
#[derive(Clone, Debug)]
pub struct Index {
    /// The subscript as it is written, a whole number.
    pub subscript: Expr,
    /// The first one.
    pub low: i64,
    /// How many there are.
    pub count: u32,
    /// The cells from one to the next.
    pub stride: u32,
}

/// An expression: it has one value of an elementary type.
#[derive(Clone, Debug)]
pub struct Expr {
    /// What it is.
    pub kind: ExprKind,
    /// The type of its value.
    pub base: Base,
    /// The same with its name: an enumeration, a subrange.
    pub ty: TypeId,
    /// Where it stands.
    pub at: Span,
}

impl Expr {
    /// Another of the same type in the same place.
    #[must_use]
    pub fn with(&self, kind: ExprKind) -> Expr {
        Expr {
            kind,
            base: self.base,
            ty: self.ty,
            at: self.at,
        }
    }
}

/// What an expression is. Operands of arithmetic and comparisons have one type, that of the result or, of a
/// comparison, their own; [`Base::width`] says how it is done. A result is not narrowed to the bits of its type
/// until it is stored or converted.
#[derive(Clone, Debug)]
pub enum ExprKind {
    /// A value that is known.
    Constant(Value),
    /// What a place holds.
    Read(Box<Place>),
    /// From the operand's type to that of this.
    Convert(Convert, Box<Expr>),
    /// Of one operand.
    Unary(Unary, Box<Expr>),
    /// Of two.
    Binary(Binary, Box<Expr>, Box<Expr>),
    /// Whether it holds, a BOOL.
    Compare(Compare, Box<Expr>, Box<Expr>),
    /// Whether it holds for each two neighbours of three or more, a BOOL.
    Ordered(Compare, Vec<Expr>),
    /// The second if the first, a BOOL, is 0, else the third. Each is computed.
    Select(Box<[Expr; 3]>),
    /// That of the number which the first operand, a DINT from 0, says; outside 0, and S 04.
    Mux(Box<Expr>, Vec<Expr>),
    /// A function of the PC alone.
    Extra(Extra, Vec<Expr>),
    /// When the scan began, ms since the start.
    Now,
    /// A function of the text; its result is the first cell of its locals.
    Call(Box<Call>),
    /// What is wrong has been told. No finished tree has one.
    Wrong,
}

/// How a value goes from one type to another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Convert {
    /// The bits stay: to a wider integer of the same width of arithmetic, or one of the same bits.
    Keep,
    /// To the bits of the new type, wrapping, with or without its sign.
    Wrap,
    /// A whole number to a type that has fewer values than its bits, TOD or DATE; 0 and S 04 if it does not fit.
    Fit,
    /// A whole number to a real.
    Float,
    /// A real to a whole number, to the nearest, halves to even; 0 and S 04 if it does not fit.
    Round,
    /// A real to a whole number, without its fraction; 0 and S 04 if it does not fit.
    Cut,
    /// LREAL to REAL; 0 and S 04 if it does not fit.
    Single,
    /// Anything to BOOL: whether it is not 0.
    Test,
    /// 32 bits of a REAL as a DWORD, and back.
    Bits,
    /// 32 bits taken for those of a REAL, as they are on a board: what is not finite is found by what uses it.
    Raw,
    /// DT to its DATE.
    Day,
    /// DT to its time of day.
    Clock,
    /// DATE to DT, at midnight.
    Midnight,
    /// Any to text.
    Write,
    /// Text to any; 0 and S 04 if it is none.
    Parse,
}

/// What is done with one operand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unary {
    /// `-x`
    Negate,
    /// The complement of all bits of the width; of BOOL, of its one bit.
    Not,
    /// The size without the sign.
    Abs,
    /// The square root; of a negative number 0, and S 04.
    Sqrt,
    /// So many of its lowest bits, with their sign or without.
    Low(u8, bool),
    /// A whole number that compares with others as the REAL of these bits does.
    Order,
}

/// What is done with two operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Binary {
    Add,
    Subtract,
    Multiply,
    /// By 0: 0, and S 04.
    Divide,
    /// By 0: 0, and S 04.
    Modulo,
    And,
    Or,
    Xor,
    /// Left by a DINT, in the bits of the type; by less than 0 or its bits and more: 0.
    ShiftLeft,
    ShiftRight,
    RotateLeft,
    RotateRight,
    Min,
    Max,
    /// A real or whole number to a whole power, a DINT.
    Power,
    /// DT and a TIME: the fraction of a second is cut.
    DtPlusTime,
    DtMinusTime,
    /// TOD and a TIME, past midnight from the beginning.
    TodPlusTime,
    TodMinusTime,
    /// Two DT in seconds, or two DATE in days, as a TIME; beyond TIME: 0, and S 04.
    DtMinusDt,
    DateMinusDate,
}

/// Two operands compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Compare {
    Equal,
    NotEqual,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
}

/// The functions that run on a PC alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Extra {
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Ln,
    Log,
    Exp,
    /// A real to a real power.
    Power,
    Len,
    Left,
    Right,
    Mid,
    Concat,
    Insert,
    Delete,
    Replace,
    Find,
}

/// What is stored may have to be checked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Store {
    /// Narrowed to the bits of the cell, whose type this is.
    Narrow(Base),
    /// Only if it is within; else nothing, and S 04.
    Within(Base, i128, i128),
    /// A text, cut to so many characters.
    Text(u32),
}

/// A call of a function or block of the text.
#[derive(Clone, Debug)]
pub struct Call {
    /// Its number in the tree.
    pub unit: u32,
    /// The instance of a block.
    pub instance: Option<Place>,
    /// What is stored before: into its locals for a function, into its own cells for a block, by their offsets.
    pub inputs: Vec<Input>,
    /// The places that are lent, in order.
    pub lent: Vec<Place>,
    /// What is stored behind: from the function's locals. A block's outputs are read as places.
    pub outputs: Vec<Output>,
    /// Where it stands.
    pub at: Span,
}

/// What a call gives.
#[derive(Clone, Debug)]
pub enum Input {
    /// A value into a cell.
    Value(u32, Expr, Store),
    /// Cells of a place into as many.
    Cells(u32, Place, u32),
}

/// What a function gives back beside its result, or a result with parts.
#[derive(Clone, Debug)]
pub struct Output {
    /// The first of its locals.
    pub from: u32,
    /// How many cells.
    pub cells: u32,
    /// To where.
    pub to: Place,
    /// Of one cell: from this type, converted as said, and stored so.
    pub value: Option<(Base, Convert, Store)>,
}
