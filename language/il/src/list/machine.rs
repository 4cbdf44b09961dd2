//! What the machine asks of the reader of a text.

use super::run::{Changes, Run, Waiting};
use super::says::Says;
use unoclp_text::diagnostics::{Code, Span, Word};
use unoclp_tree::build::{Builder, Target};
use unoclp_tree::{Expr, Stmt};

/// A reader of Instruction List: whose operands and operators they are.
pub(crate) trait Machine<'t, 'f>: Sized {
    fn run(&self) -> &Run;

    fn run_mut(&mut self) -> &mut Run;

    fn builder(&mut self) -> &mut Builder<'t, 'f>;

    /// The builder, of which something is asked.
    fn built(&self) -> &Builder<'t, 'f>;

    /// Tells what is wrong.
    fn tell<const N: usize>(&mut self, code: Code, at: Span, words: [Word; N]);

    /// A value as a condition; what cannot be one is told.
    fn tested(&mut self, expr: Expr, at: Span) -> Option<Expr>;

    /// A value as it is left for a label, where another way to it may have left one already; one that does not fit is told.
    fn carries(&mut self, expr: Expr, to: Option<&Target>, at: Span) -> Option<Expr>;

    /// The statement that stores a value; one that does not fit is told.
    fn assigned(&mut self, target: &Target, value: Expr, at: Span) -> Option<Stmt>;

    /// The opposite of a value.
    fn inverted(&mut self, expr: Expr, at: Span) -> Expr;

    /// What an operation makes that waited from this parenthesis to that; what does not go together is told.
    fn joined(&mut self, of: Waiting, left: Expr, right: Expr, from: [Span; 2]) -> Option<Expr>;

    /// How many lines the body has.
    fn lines(&self) -> usize;

    /// What a line is.
    fn says(&self, at: usize) -> Says<'_>;

    /// Whether an instruction begins with what the accumulator holds, where its operator alone does not say so.
    fn reads(&self, at: usize) -> bool;

    /// Does an instruction.
    fn line(&mut self, at: usize);

    /// Before something changes: puts aside what the reader itself holds.
    fn before_own(&mut self, _changes: &Changes) {}
}
