//! Programs as people have written them.

mod documents;
mod origins;
