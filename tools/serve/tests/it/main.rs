//! Visitors of a server, with boards in memory.

mod attacks;
mod clients;
mod common;
mod modbus;
mod pages;
mod remote;
mod simulated;
mod site;
mod visitors;
