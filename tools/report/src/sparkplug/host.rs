//! Whether the primary host application is there (*Sparkplug 3.0.0*, 5.3): its STATE says so, with the time since when.

use serde_json::Value;

/// The primary host, if there is one.
#[derive(Debug)]
pub(super) struct Host {
    is_needed: bool,
    is_there: bool,
    /// The latest time that a STATE has said.
    latest: Option<u64>,
}

/// What a STATE has changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Turn {
    Same,
    There,
    Away,
}

impl Host {
    pub fn new(is_needed: bool) -> Host {
        Host {
            is_needed,
            is_there: false,
            latest: None,
        }
    }

    /// Whether anything may be told.
    pub fn is_there(&self) -> bool {
        self.is_there || !self.is_needed
    }

    /// With a new connection it is not known any more.
    pub fn forget(&mut self) {
        self.is_there = false;
    }

    /// Takes a STATE. One that is older than another tells of a host that has come back since.
    pub fn heard(&mut self, payload: &[u8]) -> Turn {
        let state: Option<Value> = serde_json::from_slice(payload).ok();
        let said = state.and_then(|state| {
            let online = state.get("online")?.as_bool()?;
            Some((online, state.get("timestamp")?.as_u64()?))
        });
        let Some((online, at)) = said.filter(|(_, at)| Some(*at) >= self.latest) else {
            return Turn::Same;
        };
        self.latest = Some(at);
        match (self.is_there, online) {
            (false, true) => {
                self.is_there = true;
                Turn::There
            }
            (true, false) => {
                self.is_there = false;
                Turn::Away
            }
            _ => Turn::Same,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_state_counts_unless_it_is_older_or_none() {
        let mut host = Host::new(true);
        assert!(!host.is_there() && Host::new(false).is_there());
        for (payload, turn) in [
            ("", Turn::Same),
            ("ONLINE", Turn::Same),
            (r#"{"online":true}"#, Turn::Same),
            (r#"{"online":"true","timestamp":5}"#, Turn::Same),
            (r#"{"online":false,"timestamp":5}"#, Turn::Same),
            (r#"{"online":true,"timestamp":5}"#, Turn::There),
            (r#"{"online":true,"timestamp":6}"#, Turn::Same),
            (r#"{"online":false,"timestamp":5}"#, Turn::Same),
            (r#"{"online":false,"timestamp":6}"#, Turn::Away),
            (r#"{"online":true,"timestamp":-1}"#, Turn::Same),
            (r#"{"online":true,"timestamp":7}"#, Turn::There),
        ] {
            assert_eq!(host.heard(payload.as_bytes()), turn, "{payload}");
        }
    }
}
