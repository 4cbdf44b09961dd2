//! The firmware's ELF on the simulated UNO. What holds for every board runs on the Mega's too (`tests/mega/`).

mod analogue;
mod arithmetic;
mod boot_loaders;
mod brackets;
mod cards;
mod charts;
mod clients;
mod common;
mod demo;
mod diagnosis;
mod fault_matrix;
mod film;
mod kept;
mod languages;
mod live;
mod lockstep;
mod machines;
mod modbus;
mod modbus_boundaries;
mod modbus_data;
mod modbus_frames;
mod modbus_line;
mod modbus_lock;
mod modbus_upload;
mod monitor;
mod program_memory;
mod quick;
mod real;
mod retentive;
mod sd_driver;
mod sd_protocol;
mod sd_write;
mod serve;
mod soak;
mod stack;
mod start_up;
mod state;
mod state_power;
mod state_refused;
mod state_scans;
mod stop;
mod suite;
mod typed;
mod watchdog;

/// The board whose firmware is under test.
const BOARD: unoclp_core::Board = unoclp_core::Board::UNO;
