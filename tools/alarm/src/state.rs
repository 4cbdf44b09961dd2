//! How an alarm stands, and what becomes of it.

/// How an alarm stands.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum State {
    /// There is nothing to say.
    #[default]
    Normal,
    /// Its condition holds, and nobody has acknowledged it.
    Active,
    /// Its condition holds, and somebody has acknowledged it.
    Acknowledged,
    /// Its condition holds no more, and nobody has acknowledged it.
    Gone,
}

/// What becomes of an alarm.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Turn {
    /// Its condition holds.
    Came,
    /// It holds no more.
    Gone,
    /// Somebody has acknowledged it.
    Acknowledged,
}

impl State {
    /// All of them.
    pub const ALL: [State; 4] = [
        State::Normal,
        State::Active,
        State::Acknowledged,
        State::Gone,
    ];

    /// As it is recorded and told. These words are those of `docs/site.md`.
    pub fn word(self) -> &'static str {
        match self {
            State::Normal => "normal",
            State::Active => "active",
            State::Acknowledged => "acknowledged",
            State::Gone => "gone",
        }
    }

    /// The state of a word.
    pub fn of(word: &str) -> Option<State> {
        State::ALL.into_iter().find(|state| state.word() == word)
    }

    /// Whether the condition holds.
    pub fn holds(self) -> bool {
        matches!(self, State::Active | State::Acknowledged)
    }

    /// Whether somebody should acknowledge it.
    pub fn waits(self) -> bool {
        matches!(self, State::Active | State::Gone)
    }

    /// The state after a turn; none where that changes nothing.
    pub fn after(self, turn: Turn) -> Option<State> {
        match (self, turn) {
            (State::Normal | State::Gone, Turn::Came) => Some(State::Active),
            (State::Active, Turn::Gone) => Some(State::Gone),
            (State::Acknowledged, Turn::Gone) => Some(State::Normal),
            (State::Active, Turn::Acknowledged) => Some(State::Acknowledged),
            (State::Gone, Turn::Acknowledged) => Some(State::Normal),
            _ => None,
        }
    }
}

impl Turn {
    /// As it is recorded. These words are those of `docs/site.md`.
    pub fn word(self) -> &'static str {
        match self {
            Turn::Came => "came",
            Turn::Gone => "gone",
            Turn::Acknowledged => "acknowledged",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_alarm_ends_once_it_is_gone_and_acknowledged_in_either_order() {
        use Turn::{Acknowledged, Came, Gone};
        for (turns, ends) in [
            (&[Came, Gone][..], State::Gone),
            (&[Came, Gone, Acknowledged], State::Normal),
            (&[Came, Acknowledged, Gone], State::Normal),
            (&[Came, Gone, Came], State::Active),
            (&[Came, Acknowledged], State::Acknowledged),
        ] {
            let after = |state: Option<State>, turn: &Turn| state?.after(*turn);
            let ended = turns.iter().fold(Some(State::Normal), after);
            assert_eq!(ended, Some(ends), "{turns:?}");
        }
        for (state, turn) in [
            (State::Normal, Acknowledged),
            (State::Normal, Gone),
            (State::Acknowledged, Acknowledged),
            (State::Active, Came),
        ] {
            assert_eq!(state.after(turn), None);
        }
        for state in State::ALL {
            assert_eq!(State::of(state.word()), Some(state));
        }
        assert_eq!(State::of("on"), None);
    }
}
