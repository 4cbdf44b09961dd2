//! The words for what a board tells, and for what can go wrong with one.
//!
//! Owns which text of the table is meant. Must not know what a board is asked, nor when.

use super::spoken::spoken;
use super::table::*;
use std::path::Path;
use unoclp_boot::Stage;
use unoclp_client::diagnostics::Trouble;
use unoclp_client::identity::Identity;
use unoclp_client::map;
use unoclp_client::settings::Settings;
use unoclp_client::upload::{Broken, Pass};
use unoclp_client::watch::Forced;
use unoclp_client::{Failure, Line, Parity, lock as bits};
use unoclp_modbus::Exception;
use unoclp_program::{Lang, diagnosis, shown};

/// The fault that a board tells: `fault 24, line 7: no such code`.
pub fn trouble(trouble: Trouble) -> String {
    let Trouble { number, line } = trouble;
    let text = trouble.fault();
    let text = text.map(|fault| diagnosis::cause(fault.cause, spoken()));
    match (text, line) {
        (Some(text), Some(line)) => fault_of_line(number, line, text),
        (Some(text), None) => fault_of(number, text),
        (None, Some(line)) => unknown_trouble_in_line(number, line),
        (None, None) => unknown_trouble(number),
    }
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

/// ` but "ACME Meter 3"`, after `no unoclp`; nothing if it does not say what it is.
pub fn foreign(identity: Option<&Identity>) -> String {
    match identity {
        Some(identity) => but_a(format!("{} {identity}", identity.vendor)),
        None => String::new(),
    }
}

/// Why a request has no result.
pub fn failure(failure: &Failure) -> String {
    match failure {
        Failure::Silent => silent(),
        Failure::Garbled => garbled(),
        Failure::Refused(exception) => not_done(match exception {
            Exception::IllegalFunction => no_function(),
            Exception::IllegalDataAddress => no_address(),
            Exception::IllegalDataValue => not_that_value(),
            Exception::ServerDeviceFailure => not_now(),
            Exception::ServerDeviceBusy => busy(),
            Exception::GatewayPathUnavailable => no_way(),
            Exception::GatewayTargetSilent => target_silent(),
        }),
        Failure::Lost(why) => port_gone(why),
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

/// What a passage of the text is for.
pub fn pass(pass: Pass) -> String {
    match pass {
        Pass::Check => checking(),
        Pass::Store => storing(),
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

/// Why a program was not uploaded.
pub fn broken(broken: &Broken) -> String {
    match broken {
        Broken::NotBegun => upload_not_begun(),
        Broken::Locked => upload_locked(to_lift()),
        Broken::TooOld { board, needs } => firmware_too_old(*board, *needs),
        Broken::Fault(fault) => trouble(*fault),
        Broken::Ended => upload_ended(),
        Broken::Other { kept, sent } => {
            let sum = |sum| format!("{sum:04X}");
            keeps_another(kept.bytes, sum(kept.sum), sent.bytes, sum(sent.sum))
        }
        Broken::Before(why) => upload_before(failure(why)),
        Broken::Off {
            pass: of,
            bytes,
            of: all,
            stored,
            failure: why,
        } => {
            let kept = if *stored { may_keep_new() } else { keeps_old() };
            upload_off(pass(*of), bytes, all, failure(why), kept)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::messages::SPOKEN_HERE;
    use unoclp_client::diagnostics::Kept;
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
    fn trouble_reads_as_everywhere() {
        let told = |number, line| said(|| trouble(Trouble { number, line }));
        let known = told(24, Some(7));
        assert_eq!(known[0], "fault 24, line 7: no such code");
        assert_eq!(known[1], "falha 24, linha 7: código inexistente");
        let unknown = told(99, Some(7));
        assert_eq!(
            unknown[0],
            "fault 99, line 7: unknown to this version of unoclp"
        );
        let unknown = told(99, None);
        assert_eq!(
            unknown[1],
            "falha 99: desconhecida por esta versão do unoclp"
        );
    }

    #[test]
    fn an_upload_that_is_broken_off_says_where_and_what_the_board_keeps() {
        let off = |pass, stored| Broken::Off {
            pass,
            bytes: 488,
            of: 900,
            stored,
            failure: Failure::Lost("unplugged".to_owned()),
        };
        let [english, portuguese] = said(|| broken(&off(Pass::Check, false)));
        let says = "the upload failed while checking, at byte 488 of 900: the port has disappeared: \
                    unplugged. The board is in STOP; it keeps its old program; upload again";
        assert_eq!(english, says);
        let says = "o envio falhou na conferência, no byte 488 de 900: a porta não está mais disponível: \
                    unplugged. A placa está em STOP; ela mantém o programa antigo; envie de novo";
        assert_eq!(portuguese, says);
        let [english, portuguese] = said(|| broken(&off(Pass::Store, true)));
        assert!(english.contains("while storing") && english.contains("may have"));
        assert!(portuguese.contains("na gravação") && portuguese.contains("talvez já tenha"));
        let (kept, sent) = (
            Kept::default(),
            Kept {
                sum: 2,
                bytes: 1,
                ..Kept::default()
            },
        );
        let [english, _] = said(|| broken(&Broken::Other { kept, sent }));
        assert!(english.contains("not the 1 bytes with 0002"), "{english}");
    }

    #[test]
    fn what_answers_is_told() {
        let meter = Identity {
            vendor: "ACME".to_owned(),
            product: "Meter".to_owned(),
            version: "3".to_owned(),
        };
        let [english, portuguese] = said(|| foreign(Some(&meter)));
        assert_eq!(
            (&*english, &*portuguese),
            (" but \"ACME Meter 3\"", ", e sim \"ACME Meter 3\"")
        );
        assert_eq!(foreign(None), "");
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
