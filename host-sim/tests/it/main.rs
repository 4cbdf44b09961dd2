//! The PLC on a PC against the page, in one binary.

mod naive;
mod oracle;
