//! A history in a file and in PostgreSQL: what comes back of what was taken, whatever clocks, disks and servers do.

mod file;
mod keeper;
mod kill;
mod postgres;
mod server;
mod store;
