//! The typed tree itself: units, their cells, statements and expressions.
//!
//! Nothing in it is open: each expression has its type, each conversion is a node, each variable a place.

use super::base::Base;
use super::standard::Standard;
use super::types::{TypeId, Types};
use super::value::Value;
use crate::diagnostics::Span;

/// A program as any of the languages has written it.
#[derive(Clone, Debug, Default)]
pub struct Tree {
    /// The types of its variables.
    pub types: Types,
    /// What lives as long as the program: globals, variables of programs, instances in them, points.
    pub cells: Vec<Cell>,
    /// Its functions, blocks and programs; a call names one by its number here.
    pub units: Vec<Unit>,
    /// The programs among them, in the order in which a scan runs them.
    pub programs: Vec<u32>,
    /// What lives as long as the program, by its names, for whoever shows it.
    pub symbols: Vec<Symbol>,
    /// The cells that are points of the board.
    pub points: Vec<(u32, Point)>,
}

/// A cell: it holds one value of an elementary type.
#[derive(Clone, Debug, PartialEq)]
pub struct Cell {
    /// Of what type.
    pub base: Base,
    /// With what it begins.
    pub initial: Value,
    /// Whether it is kept over a power cut.
    pub retain: bool,
}

/// A point of the board, by its number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Point {
    /// `%IX1`
    Input(u32),
    /// `%QX1`
    Output(u32),
    /// `%MX1`
    Marker(u32),
    /// `%SX1`, a system marker, which is only read.
    System(u32),
    /// `%IW0`
    Analogue(u32),
    /// `%QW1`
    Pwm(u32),
    /// `%MW1`
    Register(u32),
}

impl Point {
    /// Whether a program may write it.
    pub fn is_written(self) -> bool {
        !matches!(
            self,
            Point::Input(_) | Point::System(_) | Point::Analogue(_)
        )
    }

    /// Whether it is a bit.
    pub fn is_bit(self) -> bool {
        use Point::{Input, Marker, Output, System};
        matches!(self, Input(_) | Output(_) | Marker(_) | System(_))
    }
}

/// A variable that lives as long as the program, for whoever shows it.
#[derive(Clone, Debug, PartialEq)]
pub struct Symbol {
    /// As it was declared; a member and an element are symbols of their own, `q.x` and `a[1,0]`.
    pub name: String,
    /// Its type, as a person writes it.
    pub type_name: String,
    /// Where it is.
    pub holds: Holds,
    /// Its declaration.
    pub at: Span,
    /// The name behind an enumeration's number, in order of the numbers.
    pub values: Vec<String>,
}

/// Where the value of a symbol is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Holds {
    /// In this cell.
    Cell(u32),
    /// In one of two cells, as a third says: a variable that holds what was last written.
    Either {
        /// The cell that says which.
        flag: u32,
        /// The one that is meant if it is 1.
        set: u32,
        /// And if it is 0.
        clear: u32,
    },
}

/// What a unit is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UnitKind {
    /// Runs in each scan.
    Program,
    /// Its instances keep their cells.
    Block,
    /// Its cells are new at each call.
    Function,
}

/// A program, a function block or a function.
#[derive(Clone, Debug)]
pub struct Unit {
    /// As it was declared.
    pub name: String,
    /// What it is.
    pub kind: UnitKind,
    /// The cells of an instance of a block; empty of others.
    pub own: Vec<Cell>,
    /// The cells of one call: a function's result first, what it takes, and its variables; VAR_TEMP of others.
    pub locals: Vec<Cell>,
    /// How many places a caller lends it, for VAR_IN_OUT.
    pub references: u32,
    /// What it does.
    pub body: Vec<Stmt>,
    /// Its name.
    pub at: Span,
}

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
    /// How many cells behind it.
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

/// A statement.
#[derive(Clone, Debug)]
pub struct Stmt {
    /// What it does.
    pub kind: StmtKind,
    /// Where it stands.
    pub at: Span,
}

/// What a statement does.
#[derive(Clone, Debug)]
pub enum StmtKind {
    /// Stores a value.
    Assign(Place, Expr, Store),
    /// Copies cells of the same types: from the second place to the first.
    Copy(Place, Place, u32),
    /// The first arm whose condition holds, or what is behind ELSE.
    If(Vec<(Expr, Vec<Stmt>)>, Vec<Stmt>),
    /// The arm that has the number between two of its bounds, or what is behind ELSE.
    Case(Expr, Vec<Arm>, Vec<Stmt>),
    /// While the condition holds.
    While(Expr, Vec<Stmt>),
    /// At least once, until the condition holds.
    Repeat(Vec<Stmt>, Expr),
    /// Counts.
    For(Box<For>),
    /// Leaves the innermost loop.
    Exit,
    /// Goes on with the next turn of the innermost loop.
    Continue,
    /// Leaves the unit.
    Return,
    /// Calls a function without its result, or a block.
    Call(Call),
    /// Runs a block of the norm, whose inputs have been stored.
    Standard(Standard, Place),
    /// Shows a variable on a PC; marks it as watched on a board.
    Print(String, Expr),
    /// Goes to the statement of this number in the unit's body, if the condition holds. It stands in the body
    /// itself, in no other statement.
    Jump(Option<Expr>, u32),
}

/// An arm of CASE: the first and the last number of each of its ranges, and what is done.
pub type Arm = (Vec<(i128, i128)>, Vec<Stmt>);

/// A loop that counts. The three expressions are computed once; a step of 0 does nothing, and sets S 04.
#[derive(Clone, Debug)]
pub struct For {
    /// The variable, of an integer type, without computed subscripts.
    pub variable: Place,
    /// Its type.
    pub base: Base,
    /// Its first value.
    pub from: Expr,
    /// Its last one.
    pub to: Expr,
    /// By how much.
    pub step: Expr,
    /// What is done.
    pub body: Vec<Stmt>,
}
