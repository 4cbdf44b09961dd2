//! The tests of the program `unoclp`, in one binary.

#[cfg(unix)]
mod board;
#[cfg(unix)]
mod board_commands;
mod check_output;
mod command_line;
mod common;
mod instruction_list;
mod list;
mod outputs;
#[cfg(unix)]
mod pty;
mod readme;
mod source_map;
mod tutorial;
