//! An exercise: what a program shall do, whether it does it, and what a run of it looks like.
//!
//! - [`scenario`]: the one test format of the project, and the check that every engine passes
//! - [`diagram`]: a run of a scenario as a picture: what was pressed, expected and came
//! - [`find`]: a fault of a machine that is to be found
//! - [`machine`]: a plant controlled by a program
//! - [`mutants`]: wrong programs made of a right one
//! - [`wave`]: the trace of a run for a wave viewer
//! - [`live`]: a running program as it is shown
//!
//! Owns scenarios, grades, diagrams and waves of a run, and the live values of a text's lines. Must not know a command
//! line, a terminal, a page, a board at the other end of a line, nor what runs the program.

#![forbid(unsafe_code)]

pub mod diagram;
pub mod find;
pub mod live;
pub mod machine;
pub mod mutants;
pub mod scenario;
pub mod wave;
