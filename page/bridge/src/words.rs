//! What is told to a page in words: always in both languages, so that a page changes its language without asking again.

use serde::Serialize;
use unoclp_client::Failure;
use unoclp_client::diagnostics::Trouble;
use unoclp_client::start::NotFound;
use unoclp_client::upload::{Behind, Broken};
use unoclp_lang::Diagnostic;
use unoclp_modbus::Exception;
use unoclp_program::{Lang, NoProgram, diagnosis};

/// A text in both languages.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Both {
    /// English.
    pub en: String,
    /// Brazilian Portuguese.
    pub pt: String,
}

/// Why there is no answer.
#[derive(Debug)]
pub enum No {
    /// Something is wrong, which is told.
    Told(Both),
    /// Something is wrong with a field that a person has filled in.
    At(Box<Amiss>),
    /// It takes the module that has everything.
    More,
}

/// What is wrong with a field, and what could stand in it instead.
#[derive(Debug, Serialize)]
pub struct Amiss {
    en: String,
    pt: String,
    /// Its key.
    field: String,
    offers: Vec<Offer>,
}

/// What could stand in a field instead.
#[derive(Debug, Serialize)]
pub struct Offer {
    /// What the field has then.
    pub value: String,
    pub say: Both,
    /// Whether the person is asked no more.
    pub sure: bool,
}

impl No {
    /// The same as of this field, with offers.
    pub fn at(self, field: &str, offers: Vec<Offer>) -> No {
        match self {
            No::Told(Both { en, pt }) => No::At(Box::new(Amiss {
                en,
                pt,
                field: field.to_owned(),
                offers,
            })),
            other => other,
        }
    }
}

impl From<Amiss> for Both {
    fn from(amiss: Amiss) -> Both {
        Both {
            en: amiss.en,
            pt: amiss.pt,
        }
    }
}

impl From<No> for Both {
    fn from(no: No) -> Both {
        match no {
            No::Told(told) => told,
            No::At(amiss) => (*amiss).into(),
            // It was asked for before.
            No::More => both(faulty),
        }
    }
}

impl From<Both> for No {
    fn from(told: Both) -> No {
        No::Told(told)
    }
}

/// What is said in each language.
pub fn both(say: impl Fn(Lang) -> String) -> Both {
    Both {
        en: say(Lang::En),
        pt: say(Lang::Pt),
    }
}

/// What is wrong, and what to do.
pub fn told(diagnostic: &Diagnostic, lang: Lang) -> String {
    format!("{}: {}", diagnostic.message(lang), diagnostic.help(lang))
}

unoclp_words::messages! {
    no_request(why) "the page has asked what cannot be understood: {why}" "a página pediu algo incompreensível: {why}";
    no_such_board(name) "there is no board {name}: ask for uno, nano or pc" "não existe a placa {name}: peça uno, nano ou pc";
    no_board(session) "there is no conversation {session}" "não existe a conversa {session}";
    too_long(most) "the text is longer than {most} bytes" "o texto passa de {most} bytes";
    faulty() "the program has errors; the problems say which" "o programa tem erros; veja os problemas";
    no_scenario(line, why) "the check itself is wrong, line {line}: {why}" "a própria verificação está errada, linha {line}: {why}";
    no_card(why) "the card cannot be made: {why}" "não é possível criar o cartão: {why}";
    no_machine() "this file is no machine" "este arquivo não é uma máquina";
    other_language(language)
        "this exercise asks for a program in `{language}`; let the name of yours end so"
        "este exercício pede um programa em `{language}`; o nome do seu deve terminar assim";
    hidden_chances()
        "when other things come by chance, the machine does not do what it should; how they come is hidden"
        "quando o acaso traz outras coisas, a máquina não faz o que deve; quais são, é oculto";
    no_find() "this exercise hides no fault" "este exercício não esconde uma falha";
    cannot_fail(name)
        "the exercise hides a fault that the machine {name} cannot have"
        "o exercício esconde uma falha que a máquina {name} não pode ter";
    machine_first() "open a machine first" "abra uma máquina antes";
    fault_stuck() "stuck" "travado";
    fault_open() "wire broken" "fio partido";
    fault_short() "short circuit" "em curto";
    fault_welded() "contacts welded" "contatos soldados";
    fault_jammed() "jammed" "emperrado";
    fault_slow() "slow" "lento";
    fault_leaking() "leaks" "com vazamento";
    fault_bouncing() "bounces" "trepida";
    own_contacts() "the board has contacts of its own; force the input instead" "a placa tem contatos próprios; force a entrada";
    no_settings() "a program on this computer has no settings" "um programa neste computador não tem configurações";
    none_given() "no program has been given yet; press Run" "nenhum programa foi enviado ainda; aperte Executar";
    no_point(name) "{name} is no point that can be set" "{name} não é um ponto que se possa alterar";
    no_model(name) "no board is called {name}" "nenhuma placa se chama {name}";
    no_flash() "no firmware is on its way" "nenhum firmware está a caminho";
    silent() "the board does not answer" "a placa não responde";
    garbled() "what the board answers cannot be read; look at rate and parity" "não dá para ler o que a placa responde; verifique a taxa e a paridade";
    lost(why) "the line is gone: {why}" "a linha caiu: {why}";
    refused_locked() "the board is locked against this" "a placa está bloqueada para isso";
    refused_address() "this board does not have that" "esta placa não tem isso";
    refused_value() "the board does not take that value" "a placa não aceita esse valor";
    refused_now() "the board cannot do that now; see its state" "a placa não pode fazer isso agora; veja o estado dela";
    refused_busy() "the board is busy" "a placa está ocupada";
    no_address(address, least, most) "address {address}: a board has one from {least} to {most}" "endereço {address}: uma placa tem um de {least} a {most}";
    no_rate(rate, rates) "a board has no rate of {rate} baud; it has {rates}" "uma placa não tem a taxa de {rate} baud; ela tem {rates}";
    lock_grows() "over the line a lock can only grow; A5 and the inputs 01 to 04 to ground at a reset lift it" "pela linha um bloqueio só pode crescer; A5 e as entradas 01 a 04 no GND em um reset o retiram";
    settings_locked() "the settings of the board are locked; A5 and the inputs 01 to 04 to ground at a reset unlock them" "os ajustes da placa estão bloqueados; A5 e as entradas 01 a 04 no GND em um reset os desbloqueiam";
    settings_not_kept() "the board does not keep the settings: its EEPROM fails" "a placa não guarda os ajustes: a sua EEPROM falha";
    settings_kept() "the board keeps these settings" "a placa guarda esses ajustes";
    settings_next() "the board keeps these settings, and uses them from its next start on" "a placa guarda esses ajustes, e os usa a partir do próximo início";
    but_stop(said) "{said}; it is in STOP now" "{said}; agora ela está em STOP";
    refused_way() "the gateway shares no board of this address" "o gateway não compartilha nenhuma placa com esse endereço";
    refused_silent() "the gateway gets no answer from the board" "o gateway não recebe resposta da placa";
    program_empty() "there is no program yet" "ainda não há programa";
    program_binary() "this is no text" "isto não é texto";
    program_other() "this begins in none of the languages" "isto não começa em nenhuma das linguagens";
    languages() "a program is numeric code, Instruction List, Structured Text, InterSCL, LCE or PLCopen XML" "um programa é código numérico, Lista de Instruções, Texto Estruturado, InterSCL, LCE ou PLCopen XML";
    foreign() "what answers there is not unoclp; put the firmware on" "o que responde ali não é o unoclp; grave o firmware";
    unlike() "the board runs another program than the one shown" "a placa executa outro programa, e não o mostrado";
    upload_locked() "the board is locked against uploads" "a placa está bloqueada para envios";
    upload_not_begun() "the board does not take a program now" "a placa não aceita um programa agora";
    upload_too_old() "the firmware of the board is too old for this program; put the new one on" "o firmware da placa é antigo demais para este programa; grave o novo";
    upload_ended() "somebody else has ended the upload" "outra pessoa encerrou o envio";
    upload_other() "the board keeps another program than was sent; upload again" "a placa guardou outro programa, e não o enviado; envie de novo";
    upload_off(why) "the upload was broken off: {why}; upload again" "o envio foi interrompido: {why}; envie de novo";
    fault(number, text) "fault {number}: {text}" "falha {number}: {text}";
    fault_line(number, line, text) "fault {number}, line {line}: {text}" "falha {number}, linha {line}: {text}";
    unknown_fault() "unknown to this page" "desconhecida por esta página";
    behind_run() "the program is stored and runs" "o programa está gravado e em execução";
    behind_stop() "the program is stored; the board is in STOP" "o programa está gravado; a placa está em STOP";
    behind_switch() "the program is stored; the STOP switch holds the board" "o programa está gravado; a chave STOP segura a placa";
    behind_card() "the board has loaded the program of the card in its slot; take the card out first" "a placa carregou o programa do cartão; retire o cartão antes";
    behind_fault(what) "the program is stored, and stopped with {what}" "o programa está gravado, e parou com {what}";
}

/// A fault that a board tells.
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
        Failure::Lost(why) => lost(lang, why),
        Failure::Refused(exception) => match exception {
            Exception::IllegalFunction => refused_locked(lang),
            Exception::IllegalDataAddress => refused_address(lang),
            Exception::IllegalDataValue => refused_value(lang),
            Exception::ServerDeviceFailure => refused_now(lang),
            Exception::ServerDeviceBusy => refused_busy(lang),
            Exception::GatewayPathUnavailable => refused_way(lang),
            Exception::GatewayTargetSilent => refused_silent(lang),
        },
    }
}

/// How a part of a machine fails.
#[cfg(feature = "full")]
pub fn fails(lang: Lang, fault: unoclp_plant::Fault) -> String {
    use unoclp_plant::Fault;
    let told = match fault {
        Fault::Stuck => fault_stuck,
        Fault::Open => fault_open,
        Fault::Short => fault_short,
        Fault::Welded => fault_welded,
        Fault::Jammed => fault_jammed,
        Fault::Slow => fault_slow,
        Fault::Leaking => fault_leaking,
        Fault::Bouncing => fault_bouncing,
    };
    told(lang)
}

/// Why a text is no program.
pub fn no_program(lang: Lang, why: NoProgram) -> String {
    match why {
        NoProgram::Empty => program_empty(lang),
        NoProgram::Binary => program_binary(lang),
        NoProgram::Other => program_other(lang),
    }
}

/// Why there is no board.
pub fn not_found(lang: Lang, why: &NotFound) -> String {
    match why {
        NotFound::Silent => silent(lang),
        NotFound::Garbled => garbled(lang),
        NotFound::Foreign(_) => foreign(lang),
        NotFound::Failed(why) => failure(lang, why),
    }
}

/// Why a program was not uploaded.
pub fn broken(lang: Lang, broken: &Broken) -> String {
    match broken {
        Broken::NotBegun => upload_not_begun(lang),
        Broken::Locked => upload_locked(lang),
        Broken::TooOld { .. } => upload_too_old(lang),
        Broken::Fault(fault) => trouble(lang, *fault),
        Broken::Ended => upload_ended(lang),
        Broken::Other { .. } => upload_other(lang),
        Broken::Before(why) | Broken::Off { failure: why, .. } => {
            upload_off(lang, failure(lang, why))
        }
    }
}

/// What became of the board behind an upload.
pub fn behind(lang: Lang, behind: Behind) -> String {
    match behind {
        Behind::Run => behind_run(lang),
        Behind::Stop => behind_stop(lang),
        Behind::Switch => behind_switch(lang),
        Behind::Card => behind_card(lang),
        Behind::Faulty | Behind::Failing(None) => behind_fault(lang, "FAULT"),
        Behind::Trouble(what) | Behind::Failing(Some(what)) => {
            behind_fault(lang, trouble(lang, what))
        }
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn every_text_says_the_same_in_both_languages() {
        let none: Vec<&str> = Vec::new();
        assert_eq!(unoclp_words::gaps(super::ALL), none);
    }
}
