//! The tests of exercises, in one binary.

mod exercises;
mod languages;
mod live;
mod machines;
mod plants;
mod scenario_check;
mod scenario_format;
mod suite;
mod traces;
