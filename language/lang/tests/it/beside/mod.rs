//! Trees of what only Instruction List says, on the core, in the interpreter, and as the older compiler writes the same
//! text.

mod fixed;
mod tests;
mod writer;
