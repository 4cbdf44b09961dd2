//! How an alarm stands, as a broker is told.

use unoclp_site::Text;

/// How an alarm stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Alarm {
    /// What it is called.
    pub name: String,
    /// `normal`, `active`, `acknowledged`, `gone`.
    pub state: &'static str,
    /// `low`, `medium`, `high`.
    pub severity: &'static str,
    /// What is said of it.
    pub text: Text,
    /// Since when it stands so, ms since 1970; none where that was always so.
    pub since: Option<i64>,
    /// Who has acknowledged it last.
    pub who: Option<String>,
}
