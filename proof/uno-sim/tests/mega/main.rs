//! The firmware's ELF on the simulated Mega 2560: the tests of the UNO that hold for every board, and what it alone has.

#[path = "../it/analogue.rs"]
mod analogue;
#[path = "../it/arithmetic.rs"]
mod arithmetic;
#[path = "../it/cards.rs"]
mod cards;
mod client;
#[path = "../it/common/mod.rs"]
mod common;
mod cycles;
#[path = "../it/diagnosis.rs"]
mod diagnosis;
#[path = "../it/fault_matrix.rs"]
mod fault_matrix;
#[path = "../it/kept.rs"]
mod kept;
mod lines;
#[path = "../it/live.rs"]
mod live;
#[path = "../it/machines.rs"]
mod machines;
#[path = "../it/modbus.rs"]
mod modbus;
#[path = "../it/modbus_boundaries.rs"]
mod modbus_boundaries;
#[path = "../it/modbus_data.rs"]
mod modbus_data;
#[path = "../it/modbus_frames.rs"]
mod modbus_frames;
#[path = "../it/modbus_line.rs"]
mod modbus_line;
#[path = "../it/modbus_lock.rs"]
mod modbus_lock;
#[path = "../it/modbus_upload.rs"]
mod modbus_upload;
#[path = "../it/monitor.rs"]
mod monitor;
mod points;
#[path = "../it/program_memory.rs"]
mod program_memory;
#[path = "../it/retentive.rs"]
mod retentive;
#[path = "../it/run_memory.rs"]
mod run_memory;
#[path = "../it/slow.rs"]
mod slow;
#[path = "../it/stack.rs"]
mod stack;
#[path = "../it/start_up.rs"]
mod start_up;
#[path = "../it/state.rs"]
mod state;
#[path = "../it/state_power.rs"]
mod state_power;
#[path = "../it/state_refused.rs"]
mod state_refused;
#[path = "../it/state_scans.rs"]
mod state_scans;
#[path = "../it/stop.rs"]
mod stop;
mod suite;
#[path = "../it/watchdog.rs"]
mod watchdog;

/// The board whose firmware is under test.
const BOARD: unoclp_core::Board = unoclp_core::Board::MEGA;
