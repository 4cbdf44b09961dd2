//! The tests of plants, in one binary.
