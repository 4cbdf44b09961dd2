//! The words for what a board tells, and for what can go wrong with one: most are the client's, in the language of this
//! process; the others are those of a terminal.
//!
//! Owns which text is meant. Must not know what a board is asked, nor when.

use super::spoken::spoken;
use super::table::*;
use std::path::Path;
use unoclp_boot::Stage;
use unoclp_client::diagnostics::Trouble;
use unoclp_client::event::{Behind, Pass, Undone, Unsettled};
use unoclp_client::identity::Identity;
use unoclp_client::map;
use unoclp_client::settings::Settings;
use unoclp_client::watch::Forced;
use unoclp_client::{Failure, Line, Parity, lock as bits, words};
use unoclp_program::{Lang, shown};

macro_rules! of_clients {
    ($($(#[$about:meta])* $name:ident as $own:ident($($value:ident: $type:ty),*);)*) => {
        $(
            $(#[$about])*
            pub fn $own($($value: $type),*) -> String {
                words::$name(spoken() $(, $value)*)
            }
        )*
    };
}

of_clients! {
    /// The fault that a board tells: `fault 24, line 7: no such code`.
    trouble as trouble(trouble: Trouble);
    /// Why a request has no result.
    failure as failure(why: &Failure);
    /// Why an order is not done.
    undone as undone(why: &Undone);
    /// Why a board does not keep settings.
    unsettled as unsettled(why: &Unsettled);
    /// What became of a board after an upload.
    behind as behind(behind: Behind);
    /// What a passage of the text of an upload is for.
    pass as pass(pass: Pass);
    /// ` but "ACME Meter 3"`, after `no unoclp`; nothing if it does not say what it is.
    what as foreign(identity: Option<&Identity>);
    /// That no board is there.
    no_board as no_board_there();
    /// That a board keeps settings.
    settings_kept as settings_kept();
    /// How a lock is lifted.
    to_unlock as to_unlock();
}

/// A supply in mV, as people read it: `5.01`, in Portuguese `5,01`.
pub fn volts(supply: u32) -> String {
    let volts = format!("{:.2}", f64::from(supply) / 1000.0);
    match spoken() {
        Lang::En => volts,
        Lang::Pt => volts.replace('.', ","),
    }
}

/// The cause of a board's start.
pub fn start(cause: u16) -> String {
    match map::cause(cause) {
        "power" => power(),
        "unknown" => unknown(),
        "no reset" => no_reset(),
        "command" => command(),
        // The words of the data sheet: watchdog, reset.
        other => other.to_owned(),
    }
}

/// `address 1 at 115200 baud, no parity`
pub fn spoken_line(of: Line) -> String {
    line(of.address, of.rate, parity(of.parity))
}

/// `no parity`
pub fn parity(parity: Parity) -> String {
    match parity {
        Parity::None => parity_none(),
        Parity::Even => parity_even(),
        Parity::Odd => parity_odd(),
    }
}

/// `address 1, 115200 baud, no parity, direction pin off, nothing locked`
pub fn settings(of: Settings) -> String {
    let direction = if of.direction { pin_on() } else { pin_off() };
    let line = settings_line(of.address, of.rate, parity(of.parity), direction);
    match of.lock {
        Some(of) => format!("{line}, {}", lock(of)),
        None => line,
    }
}

/// `locked: upload, commands`
pub fn lock(of: u8) -> String {
    let all = [
        (bits::UPLOAD, lock_upload()),
        (bits::SETTINGS, lock_settings()),
        (bits::COMMANDS, lock_commands()),
        (bits::WRITING, lock_writing()),
    ];
    let set = all.into_iter().filter(|(bit, _)| of & bit != 0);
    let set: Vec<String> = set.map(|(_, name)| name).collect();
    match set.is_empty() {
        true => nothing_locked(),
        false => locked(set.join(", ")),
    }
}

/// Why the history in this file, or at this server, cannot be used.
pub fn store_failure(store: &str, failure: &unoclp_history::Failure) -> String {
    use unoclp_history::Failure::{Busy, Foreign, Full, Other, ReadOnly, Version};
    match failure {
        Foreign => history_foreign(store),
        Version(version) => history_version(store, version),
        Full => history_full(store),
        ReadOnly => history_read_only(store),
        Busy => history_fails(store, held()),
        Other(why) if store.contains("://") => history_away(store, why),
        Other(why) => history_fails(store, why),
    }
}

/// Why the journal in this file cannot be used.
pub fn journal_failure(file: &Path, failure: &unoclp_history::Failure) -> String {
    use unoclp_history::Failure::{Busy, Foreign, Full, Other, ReadOnly, Version};
    let file = shown(file);
    match failure {
        Foreign => journal_foreign(file),
        Version(version) => journal_version(file, version),
        Full => journal_full(file),
        ReadOnly => history_read_only(file),
        Busy => journal_held(file),
        Other(why) => history_fails(file, why),
    }
}

/// Why the record in this file cannot be used.
pub fn record_failure(file: &Path, failure: &unoclp_history::Failure) -> String {
    use unoclp_history::Failure::{Busy, Foreign, Full, Other, ReadOnly, Version};
    let file = shown(file);
    match failure {
        Foreign => record_foreign(file),
        Version(version) => record_version(file, version),
        Full => record_full(file),
        ReadOnly => history_read_only(file),
        Busy => history_fails(file, held()),
        Other(why) => history_fails(file, why),
    }
}

/// What stays forced at a board that is left, and how long.
pub fn left_forced(forced: Forced) -> String {
    match forced.seconds() {
        Some(seconds) => stays_forced_for(forced, seconds),
        None => stays_forced(forced),
    }
}

/// What is done with a firmware.
pub fn stage(stage: Stage) -> String {
    match stage {
        Stage::Meeting => calling_boot_loader(),
        Stage::Writing => writing_firmware(),
        Stage::Comparing => comparing_firmware(),
        Stage::Finishing => starting_firmware(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::messages::SPOKEN_HERE;
    use unoclp_lang::Lang;

    /// What is said in both languages.
    fn said<T>(say: impl Fn() -> T) -> [T; 2] {
        [Lang::En, Lang::Pt].map(|lang| {
            SPOKEN_HERE.set(Some(lang));
            let said = say();
            SPOKEN_HERE.set(None);
            said
        })
    }

    #[test]
    fn settings_are_told() {
        let direction = true;
        let (address, rate, parity) = (3, 9600, Parity::Odd);
        for (lock, english, portuguese) in [
            (None, "", ""),
            (Some(0), ", nothing locked", ", nada bloqueado"),
            (
                Some(0b101),
                ", locked: upload, commands",
                ", bloqueado: envio, comandos",
            ),
            (
                Some(0b1010),
                ", locked: settings, writing",
                ", bloqueado: ajustes, escrita",
            ),
        ] {
            let kept = Settings {
                address,
                rate,
                parity,
                direction,
                lock,
            };
            let says = [
                "address 3, 9600 baud, odd parity, direction pin on".to_owned() + english,
                "endereço 3, 9600 baud, paridade ímpar, pino de direção ativo".to_owned()
                    + portuguese,
            ];
            assert_eq!(said(|| settings(kept)), says);
        }
    }
}
