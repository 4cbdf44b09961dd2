//! The language that this process speaks.

use std::sync::OnceLock;
use unoclp_lang::Lang;

static SPOKEN: OnceLock<Lang> = OnceLock::new();

/// Speaks this language from now on. A process chooses once, before it says anything.
pub fn speak(lang: Lang) {
    // The first choice holds.
    let _ = SPOKEN.set(lang);
}

/// The language of this process; English before it has chosen.
pub fn spoken() -> Lang {
    #[cfg(test)]
    if let Some(lang) = SPOKEN_HERE.get() {
        return lang;
    }
    SPOKEN.get().copied().unwrap_or_default()
}

#[cfg(test)]
thread_local! {
    /// The language of a test, apart from the others of the process.
    pub(crate) static SPOKEN_HERE: std::cell::Cell<Option<Lang>> = const { std::cell::Cell::new(None) };
}
