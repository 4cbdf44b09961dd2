//! The tests of the program `unoclp`, in one binary.

#[cfg(unix)]
mod board;
#[cfg(unix)]
mod board_commands;
#[cfg(unix)]
mod board_upload;
mod check_output;
mod command_line;
mod common;
#[cfg(unix)]
mod fake;
mod instruction_list;
mod list;
mod tutorial;
