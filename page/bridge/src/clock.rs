//! The times of a page, in ms since any moment.
//!
//! A page gives fractions of ms, and is given whole ones: no clock of a browser is finer, and a module that prints no
//! fractions needs none of what that takes.

use std::time::Duration;

/// A time that does not come: the largest whole number that a page has.
pub const NEVER: u64 = (1 << 53) - 1;

/// A page's time. A clock that stands before zero, or nowhere, stands at zero.
pub fn time(ms: f64) -> Duration {
    Duration::try_from_secs_f64(ms / 1000.0).unwrap_or_default()
}

/// The first whole ms that is not before a time.
pub fn whole_ms(time: Duration) -> u64 {
    let part = time.subsec_nanos().div_ceil(1_000_000);
    let ms = time.as_secs().saturating_mul(1000);
    ms.saturating_add(part.into()).min(NEVER)
}
