//! The loader, the instructions and the documents, from outside.

mod documents;
mod fuzzed;
mod isa;
mod kept;
mod links;
mod loader;
mod pc;
mod points;
mod stored;
mod timers;
