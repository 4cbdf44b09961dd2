//! The types that a declaration may name.

/// Words that are types, so that what stands before them is a name.
pub(super) const TYPES: [&str; 22] = [
    "BOOL", "SINT", "INT", "DINT", "USINT", "UINT", "UDINT", "BYTE", "WORD", "DWORD", "TIME",
    "TON", "TOF", "TP", "TONR", "CTU", "CTD", "CTUD", "R_TRIG", "F_TRIG", "SR", "RS",
];
