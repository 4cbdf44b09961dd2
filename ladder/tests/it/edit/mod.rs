//! The editor without a screen.

mod random;
