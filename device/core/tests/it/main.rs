//! The loader, the instructions and the documents, from outside.

mod documents;
mod fuzzed;
mod isa;
mod links;
mod loader;
mod pc;
mod stored;
mod timers;
