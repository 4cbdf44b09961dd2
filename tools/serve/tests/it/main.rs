//! Visitors of a server, with boards in memory.

mod alarms;
mod attacks;
mod clients;
mod common;
mod examples;
mod modbus;
mod openapi;
mod orders;
mod pages;
mod panels;
mod past;
mod poll;
mod remote;
mod simulated;
mod site;
mod users;
mod visitors;
