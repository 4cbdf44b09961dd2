//! The tests of the program `unoclp`, in one binary.

mod adapt;
#[cfg(unix)]
mod board;
#[cfg(unix)]
mod board_commands;
mod check_output;
mod command_line;
mod common;
#[cfg(unix)]
mod editors;
mod exercises;
mod flash;
mod handed_in;
mod hostile;
mod instruction_list;
mod kept;
mod lacking;
mod languages;
mod list;
#[cfg(unix)]
mod monitor;
mod nano;
mod outputs;
mod pages;
mod payload;
mod pc;
mod plant;
mod plcopen;
mod portuguese;
#[cfg(unix)]
mod pty;
mod readme;
mod run;
mod site;
mod source_map;
mod texts;
mod translated;
mod tutorial;
mod words;
