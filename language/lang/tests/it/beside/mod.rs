//! Trees of what only Instruction List says, on the core, in the interpreter, and as the compiler writes the same
//! text.

mod fixed;
mod tests;
mod writer;
