//! Reports to Debian's mosquitto, as its own subscriber hears them.
#![cfg(unix)]

mod broker;
mod plain;
mod site;
mod sparkplug;
mod tls;
