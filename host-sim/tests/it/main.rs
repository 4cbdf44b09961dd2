//! The tests of the PLC on a PC, in one binary.

mod documents;
mod exercises;
mod languages;
mod live;
mod naive;
mod oracle;
mod scenario_check;
mod scenario_format;
mod suite;
mod to_st;
