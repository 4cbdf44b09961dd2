//! What there is to say of a board, in the two languages that the tools speak: one table for the terminal, the page and the
//! gateway.
//!
//! Owns which text is meant. Must not know who shows it, nor which key or button a person presses there.

use crate::client::Failure;
use crate::diagnostics::Trouble;
#[cfg(feature = "more")]
use crate::download::Unread;
use crate::event::{Again, Away, Behind, Broken, Done, Pass, Refusal, Settled, Undone, Unsettled};
use crate::identity::Identity;
use crate::settings::RATES;
use crate::start::NotFound;
use crate::{AT_A_LINE, point};
use unoclp_lang::no_such_point;
use unoclp_modbus::Exception;
use unoclp_point::Address;
use unoclp_program::diagnosis;
use unoclp_words::Lang;

unoclp_words::messages! {
    silent() "the board does not answer" "a placa não responde";
    garbled()
        "the board's answers are unreadable; check the rate and the parity"
        "as respostas da placa são ilegíveis; verifique a taxa e a paridade";
    connection_lost(why) "the connection was lost: {why}" "a conexão caiu: {why}";
    foreign(what)
        "this device does not run unoclp{what}; install the firmware"
        "este dispositivo não roda o unoclp{what}; grave o firmware";
    but_a(identity) " but \"{identity}\"" ", e sim \"{identity}\"";
    no_board() "no board is connected" "nenhuma placa conectada";
    refused_locked() "this operation is locked on the board" "esta operação está bloqueada na placa";
    refused_address() "this board has no such point" "esta placa não tem esse ponto";
    refused_value() "the board does not accept that value" "a placa não aceita esse valor";
    refused_now() "the board cannot do that now" "a placa não consegue fazer isso agora";
    refused_busy()
        "the board is busy; if it has stored settings or programs too often, try again in an hour, or after a power cycle"
        "a placa está ocupada; se gravou ajustes ou programas vezes demais, tente de novo em uma hora, ou desligue e ligue a placa";
    refused_way()
        "the gateway has no board at this address"
        "o gateway não tem nenhuma placa nesse endereço";
    refused_silent()
        "the gateway gets no answer from the board"
        "o gateway não recebe resposta da placa";
    refused_in_fault() "the board is in FAULT; restart it" "a placa está em FAULT; reinicie-a";
    refused_by_switch()
        "the STOP switch holds the board in STOP"
        "a chave STOP mantém a placa em STOP";
    refused_in_upload()
        "an upload is in progress; restart the board to cancel it"
        "há um envio em andamento; reinicie a placa para cancelá-lo";
    refused_scan()
        "single scans work in STOP only; stop the board first"
        "uma varredura única só é possível em STOP; pare a placa antes";
    commands_locked()
        "commands are locked on this board"
        "os comandos estão bloqueados nesta placa";
    writing_locked()
        "writing and forcing are locked on this board"
        "a escrita e o forçamento estão bloqueados nesta placa";
    no_point(name) "{name} is not a point that can be set" "{name} não é um ponto que se possa alterar";
    to_unlock()
        "to unlock, reset the board with the STOP pin (A5 on a UNO) and inputs 01 to 04 connected to GND, then write any setting"
        "para desbloquear, faça o reset com o pino STOP (A5 em um UNO) e as entradas 01 a 04 ligados ao GND e grave qualquer ajuste";
    fault(number, text) "fault {number}: {text}" "falha {number}: {text}";
    fault_line(number, line, text) "fault {number}, line {line}: {text}" "falha {number}, linha {line}: {text}";
    unknown_fault() "unknown to this version of unoclp" "desconhecida por esta versão do unoclp";
    not_stopped(failure) "could not stop the board: {failure}" "não foi possível parar a placa: {failure}";
    stop_locked()
        "commands are locked, so only the STOP pin can stop the board: connect it to GND (A5 on a UNO) and try again"
        "os comandos estão bloqueados; só o pino STOP pode parar a placa: ligue-o ao GND (A5 em um UNO) e tente de novo";
    upload_not_begun()
        "the board did not start the upload; is another client keeping it in RUN?"
        "a placa não começou o envio; outro cliente a mantém em RUN?";
    unknown_state()
        "this version of unoclp does not know the board's state"
        "esta versão do unoclp não conhece o estado da placa";
    upload_locked(to_unlock)
        "uploads are locked on this board; {to_unlock}"
        "os envios estão bloqueados nesta placa; {to_unlock}";
    firmware_too_old(board, needs)
        "the board's firmware is older than some instructions of this program: it stores \
         programs in form {board}, but this program needs form {needs}. The board keeps its old program; install the new firmware"
        "o firmware da placa é mais antigo que algumas instruções deste programa: ele guarda \
         programas na forma {board}, mas este programa precisa da forma {needs}. A placa mantém o programa antigo; grave o firmware novo";
    upload_ended()
        "another client ended the upload; the board keeps its old program"
        "outro cliente encerrou o envio; a placa mantém o programa antigo";
    keeps_another(bytes, sum, sent_bytes, sent_sum)
        "the board has {bytes} bytes with checksum {sum}, not the {sent_bytes} bytes with {sent_sum} that were sent; is it running a different version of the firmware?"
        "a placa tem {bytes} bytes com soma de verificação {sum}, e não os {sent_bytes} bytes com {sent_sum} que foram enviados; o firmware dela é de outra versão?";
    upload_before(failure) "the upload did not start: {failure}" "o envio não começou: {failure}";
    upload_off(pass, bytes, all, failure, kept)
        "the upload failed while {pass}, at byte {bytes} of {all}: {failure}. The board is in STOP; {kept}; upload again"
        "o envio falhou na {pass}, no byte {bytes} de {all}: {failure}. A placa está em STOP; {kept}; envie de novo";
    may_keep_new() "it may have the new program" "talvez já tenha o programa novo";
    keeps_old() "it keeps its old program" "ela mantém o programa antigo";
    checking() "checking" "conferência";
    storing() "storing" "gravação";
    not_started(failure)
        "the program is stored, but the board does not start it: {failure}"
        "o programa está gravado, mas a placa não o inicia: {failure}";
    runs() "the program is stored and runs" "o programa está gravado e em execução";
    stays() "the program is stored; the board is in STOP" "o programa está gravado; a placa está em STOP";
    switch_holds()
        "the program is stored; the STOP switch keeps the board in STOP"
        "o programa está gravado; a chave STOP mantém a placa em STOP";
    in_fault_until()
        "the program is stored; the board is in FAULT and will run it after the next restart"
        "o programa está gravado; a placa está em FAULT e vai executá-lo depois do próximo reinício";
    card_wins()
        "the board stored the program, but at the restart it loaded another PROGRAM.TXT from its card; remove the card, or copy the program to it"
        "a placa gravou o programa, mas, ao reiniciar, leu outro PROGRAM.TXT do cartão dela; retire o cartão ou grave nele o programa";
    restarted_with(trouble)
        "the program is stored, but after the restart the board reports {trouble}"
        "o programa está gravado, mas, ao reiniciar, a placa informa: {trouble}";
    stopped_with(what) "the program is stored, but stopped with {what}" "o programa está gravado, mas parou com {what}";
    unread_empty() "the board has no program" "a placa não tem programa";
    unread_untold()
        "this board's firmware cannot send its program: it is an older version, or the firmware of a Nano"
        "o firmware desta placa não envia o programa: é mais antigo, ou é o de um Nano";
    unread_other()
        "the board's answer is not a valid program; read it again"
        "a placa enviou um programa desconhecido; leia de novo";
    no_rate(rate, rates)
        "the board does not support {rate} baud; it supports {rates}"
        "a placa não aceita {rate} baud; ela aceita {rates}";
    lock_grows(to_unlock)
        "a client can only add to a lock; {to_unlock}"
        "um cliente só pode ampliar um bloqueio; {to_unlock}";
    settings_locked(to_unlock)
        "the settings of the board are locked; {to_unlock}"
        "os ajustes da placa estão bloqueados; {to_unlock}";
    settings_not_taken(failure) "the board rejected the settings: {failure}" "a placa recusou os ajustes: {failure}";
    settings_not_kept()
        "the board could not store the settings: its EEPROM is failing"
        "a placa não conseguiu guardar os ajustes: a EEPROM dela está falhando";
    settings_kept() "the board keeps these settings" "a placa guarda esses ajustes";
    settings_next()
        "the board stored these settings and uses them after its next start"
        "a placa guardou esses ajustes e passa a usá-los na próxima partida";
    but_stop(said) "{said}; it is in STOP now" "{said}; agora ela está em STOP";
}

/// A fault that a board tells: `fault 24, line 7: no such code`.
pub fn trouble(lang: Lang, trouble: Trouble) -> String {
    let text = match trouble.fault() {
        Some(fault) => diagnosis::cause(fault.cause, lang).to_owned(),
        None => unknown_fault(lang),
    };
    match trouble.line {
        Some(line) => fault_line(lang, trouble.number, line, text),
        None => fault(lang, trouble.number, text),
    }
}

/// Why a request has no result.
pub fn failure(lang: Lang, failure: &Failure) -> String {
    match failure {
        Failure::Silent => silent(lang),
        Failure::Garbled => garbled(lang),
        Failure::Lost(why) => connection_lost(lang, why),
        Failure::Refused(exception) => refused(lang, *exception),
    }
}

fn refused(lang: Lang, exception: Exception) -> String {
    match exception {
        Exception::IllegalFunction => refused_locked(lang),
        Exception::IllegalDataAddress => refused_address(lang),
        Exception::IllegalDataValue => refused_value(lang),
        Exception::ServerDeviceFailure => refused_now(lang),
        Exception::ServerDeviceBusy => refused_busy(lang),
        Exception::GatewayPathUnavailable => refused_way(lang),
        Exception::GatewayTargetSilent => refused_silent(lang),
    }
}

/// ` but "ACME Meter 3"`; nothing of what does not say what it is.
pub fn what(lang: Lang, identity: Option<&Identity>) -> String {
    match identity {
        Some(identity) => but_a(lang, format!("{} {identity}", identity.vendor)),
        None => String::new(),
    }
}

/// Why there is no board.
pub fn not_found(lang: Lang, why: &NotFound) -> String {
    match why {
        NotFound::Silent => silent(lang),
        NotFound::Garbled => garbled(lang),
        NotFound::Foreign(identity) => foreign(lang, what(lang, identity.as_ref())),
        NotFound::Failed(why) => failure(lang, why),
    }
}

/// Why there is no board, or no longer one.
pub fn away(lang: Lang, away: &Away) -> String {
    match away {
        Away::NotFound(why) => not_found(lang, why),
        Away::Gone(why) => failure(lang, why),
    }
}

/// What has come of an order, where that is more than it says itself.
pub fn done(lang: Lang, done: Done) -> Option<String> {
    match done {
        Done::Plainly => None,
        #[cfg(feature = "more")]
        Done::Flashed => None,
        Done::Uploaded(is) => Some(behind(lang, is)),
        #[cfg(feature = "more")]
        Done::Settled(is) => Some(settled(lang, is)),
    }
}

/// Why an order is not done.
pub fn undone(lang: Lang, undone: &Undone) -> String {
    match undone {
        Undone::Away(why) => away(lang, why),
        Undone::Lost(why) => failure(lang, why),
        Undone::Refused(why) => refusal(lang, *why),
        Undone::NoPoint(point) => no_such(lang, *point),
        Undone::NotStopped(Failure::Refused(Exception::IllegalFunction)) => stop_locked(lang),
        Undone::NotStopped(why) => not_stopped(lang, failure(lang, why)),
        Undone::Broken(why) => broken(lang, why),
        Undone::NotStarted(why) => not_started(lang, failure(lang, why)),
        #[cfg(feature = "more")]
        Undone::Unread(why) => unread(lang, why),
        #[cfg(feature = "more")]
        Undone::Unsettled(why) => unsettled(lang, why),
        #[cfg(feature = "more")]
        Undone::NotFlashed(why) => why.text(lang),
    }
}

/// What stands in the way of an order.
pub fn refusal(lang: Lang, refusal: Refusal) -> String {
    match refusal {
        Refusal::InFault => refused_in_fault(lang),
        Refusal::Switch => refused_by_switch(lang),
        Refusal::InUpload => refused_in_upload(lang),
        Refusal::NotInStop => refused_scan(lang),
        Refusal::CommandsLocked => commands_locked(lang),
        Refusal::WritingLocked => writing_locked(lang),
        Refusal::Other(exception) => refused(lang, exception),
    }
}

/// That no client writes this point: a board at a line has none such, or it is none that can be set.
pub fn no_such(lang: Lang, point: Address) -> String {
    match no_such_point(point, AT_A_LINE).filter(|_| !point::is_written(point)) {
        Some(lacking) => format!("{}: {}", lacking.message(lang), lacking.help(lang)),
        None => no_point(lang, point),
    }
}

/// What a passage of the text of an upload is for.
pub fn pass(lang: Lang, pass: Pass) -> String {
    match pass {
        Pass::Check => checking(lang),
        Pass::Store => storing(lang),
    }
}

/// Why a program was not uploaded.
pub fn broken(lang: Lang, broken: &Broken) -> String {
    match broken {
        Broken::NotBegun => upload_not_begun(lang),
        Broken::UnknownState => unknown_state(lang),
        Broken::Locked => upload_locked(lang, to_unlock(lang)),
        Broken::TooOld { board, needs } => firmware_too_old(lang, board, needs),
        Broken::Fault(fault) => trouble(lang, *fault),
        Broken::Ended => upload_ended(lang),
        Broken::Other { kept, sent } => {
            let sum = |sum| format!("{sum:04X}");
            keeps_another(lang, kept.bytes, sum(kept.sum), sent.bytes, sum(sent.sum))
        }
        Broken::Before(why) => upload_before(lang, failure(lang, why)),
        Broken::Off {
            pass: of,
            bytes,
            of: all,
            stored,
            failure: why,
        } => {
            let kept = match stored {
                true => may_keep_new(lang),
                false => keeps_old(lang),
            };
            upload_off(lang, pass(lang, *of), bytes, all, failure(lang, why), kept)
        }
    }
}

/// What became of the board after an upload.
pub fn behind(lang: Lang, behind: Behind) -> String {
    match behind {
        Behind::Run => runs(lang),
        Behind::Stop => stays(lang),
        Behind::Switch => switch_holds(lang),
        Behind::Faulty => in_fault_until(lang),
        Behind::Card => card_wins(lang),
        Behind::Trouble(what) => restarted_with(lang, trouble(lang, what)),
        Behind::Failing(None) => stopped_with(lang, "FAULT"),
        Behind::Failing(Some(what)) => stopped_with(lang, trouble(lang, what)),
    }
}

/// Why the program of a board was not read.
#[cfg(feature = "more")]
pub fn unread(lang: Lang, why: &Unread) -> String {
    match why {
        Unread::Empty => unread_empty(lang),
        Unread::Untold => unread_untold(lang),
        Unread::Other => unread_other(lang),
        Unread::Failed(why) => failure(lang, why),
    }
}

/// Why a board does not keep settings.
pub fn unsettled(lang: Lang, why: &Unsettled) -> String {
    match why {
        Unsettled::Rate(rate) => no_rate(lang, rate, RATES.map(|rate| rate.to_string()).join(", ")),
        Unsettled::LockShrinks => lock_grows(lang, to_unlock(lang)),
        Unsettled::Locked => settings_locked(lang, to_unlock(lang)),
        Unsettled::NotTaken(why) => settings_not_taken(lang, failure(lang, why)),
        Unsettled::NotKept => settings_not_kept(lang),
    }
}

/// What became of a board whose settings were written.
pub fn settled(lang: Lang, settled: Settled) -> String {
    let said = match settled.is_for_next {
        true => settings_next(lang),
        false => settings_kept(lang),
    };
    match settled.again {
        Again::WasNot | Again::Runs => said,
        Again::Held | Again::Locked => but_stop(lang, said),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostics::Kept;

    fn said<T>(say: impl Fn(Lang) -> T) -> [T; 2] {
        [Lang::En, Lang::Pt].map(say)
    }

    #[test]
    fn every_text_says_the_same_in_both_languages() {
        assert_eq!(unoclp_words::gaps(ALL), [""; 0]);
    }

    #[test]
    fn each_end_of_an_upload_has_a_text_of_its_own() {
        let fault = Trouble {
            number: 24,
            line: None,
        };
        let ends = [
            (Behind::Run, "runs"),
            (Behind::Stop, "STOP"),
            (Behind::Switch, "the STOP switch"),
            (Behind::Faulty, "is in FAULT"),
            (Behind::Card, "PROGRAM.TXT"),
            (Behind::Trouble(fault), "fault 24"),
            (Behind::Failing(None), "FAULT"),
            (Behind::Failing(Some(fault)), "fault 24"),
        ];
        for (end, says) in ends {
            let text = behind(Lang::En, end);
            assert!(text.contains(says), "{end:?}: {text}");
        }
    }

    #[test]
    fn why_a_program_is_not_read_is_told() {
        let [english, portuguese] = said(|lang| unread(lang, &Unread::Empty));
        assert_eq!(english, "the board has no program");
        assert_eq!(portuguese, "a placa não tem programa");
        let silent = unread(Lang::En, &Unread::Failed(Failure::Silent));
        assert!(silent.contains("does not answer"), "{silent}");
    }

    #[test]
    fn trouble_reads_as_everywhere() {
        let told = |number, line| said(|lang| trouble(lang, Trouble { number, line }));
        let known = told(24, Some(7));
        assert_eq!(known[0], "fault 24, line 7: no such code");
        assert_eq!(known[1], "falha 24, linha 7: código inexistente");
        let unknown = told(99, Some(7));
        let says = "fault 99, line 7: unknown to this version of unoclp";
        assert_eq!(unknown[0], says);
        let unknown = told(99, None);
        let says = "falha 99: desconhecida por esta versão do unoclp";
        assert_eq!(unknown[1], says);
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
        let [english, portuguese] = said(|lang| broken(lang, &off(Pass::Check, false)));
        let says = "the upload failed while checking, at byte 488 of 900: the connection was lost: \
                    unplugged. The board is in STOP; it keeps its old program; upload again";
        assert_eq!(english, says);
        let says = "o envio falhou na conferência, no byte 488 de 900: a conexão caiu: \
                    unplugged. A placa está em STOP; ela mantém o programa antigo; envie de novo";
        assert_eq!(portuguese, says);
        let [english, portuguese] = said(|lang| broken(lang, &off(Pass::Store, true)));
        assert!(english.contains("while storing") && english.contains("may have"));
        assert!(portuguese.contains("na gravação") && portuguese.contains("talvez já tenha"));
        let sent = Kept {
            sum: 2,
            bytes: 1,
            ..Kept::default()
        };
        let kept = Kept::default();
        let [english, _] = said(|lang| broken(lang, &Broken::Other { kept, sent }));
        assert!(english.contains("not the 1 bytes with 0002"), "{english}");
    }

    #[test]
    fn what_answers_is_told() {
        let meter = Identity {
            vendor: "ACME".to_owned(),
            product: "Meter".to_owned(),
            version: "3".to_owned(),
        };
        let [english, portuguese] = said(|lang| what(lang, Some(&meter)));
        assert_eq!(english, " but \"ACME Meter 3\"");
        assert_eq!(portuguese, ", e sim \"ACME Meter 3\"");
        assert_eq!(what(Lang::En, None), "");
    }

    #[test]
    fn what_came_of_settings_is_told() {
        let told = |is_for_next, again| {
            let settled = Done::Settled(Settled { is_for_next, again });
            done(Lang::En, settled).expect("a text")
        };
        let kept = "the board keeps these settings";
        assert_eq!(told(false, Again::WasNot), kept);
        assert_eq!(
            told(false, Again::Held),
            format!("{kept}; it is in STOP now")
        );
        assert!(told(true, Again::Runs).contains("after its next start"));
        assert_eq!(done(Lang::En, Done::Plainly), None);
        let [english, portuguese] = said(|lang| unsettled(lang, &Unsettled::Rate(300)));
        assert!(english.contains("300 baud; it supports"), "{english}");
        assert!(portuguese.contains("300 baud; ela aceita"), "{portuguese}");
        let why = Unsettled::NotTaken(Failure::Silent);
        assert!(unsettled(Lang::En, &why).contains("the board does not answer"));
    }
}
