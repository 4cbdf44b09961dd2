//! What is told to a page in words: always in both languages, so that a page changes its language without asking again.

use unoclp_client::Failure;
use unoclp_client::diagnostics::Trouble;
use unoclp_client::start::NotFound;
use unoclp_client::upload::{Behind, Broken};
use unoclp_lang::Diagnostic;
use unoclp_modbus::Exception;
use unoclp_program::{Lang, NoProgram, diagnosis};

pub use unoclp_words::{Both, both};

/// Why there is no answer.
#[derive(Debug)]
pub enum No {
    /// Something is wrong, which is told.
    Told(Both),
    /// Something of a drawing is not done.
    #[cfg(feature = "full")]
    Amiss(Box<unoclp_edit::Amiss>),
    /// It takes the module that has everything.
    More,
}

impl From<No> for Both {
    fn from(no: No) -> Both {
        match no {
            No::Told(told) => told,
            #[cfg(feature = "full")]
            No::Amiss(amiss) => amiss.told,
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

#[cfg(feature = "full")]
impl From<unoclp_edit::Amiss> for No {
    fn from(amiss: unoclp_edit::Amiss) -> No {
        No::Amiss(Box::new(amiss))
    }
}

/// What is wrong, and what to do.
pub fn told(diagnostic: &Diagnostic, lang: Lang) -> String {
    format!("{}: {}", diagnostic.message(lang), diagnostic.help(lang))
}

unoclp_words::messages! {
    no_request(why) "the page sent a request that cannot be understood: {why}" "a página enviou um pedido incompreensível: {why}";
    no_such_board(name) "there is no board {name}: ask for uno, nano or pc" "não existe a placa {name}: peça uno, nano ou pc";
    no_board(session) "there is no conversation {session}" "não existe a conversa {session}";
    no_version(version) "the page asked about text {version}, which is no longer known; change the text and try again" "a página perguntou pelo texto {version}, que não é mais conhecido; altere o texto e tente de novo";
    too_long(most) "the text is longer than {most} bytes" "o texto passa de {most} bytes";
    faulty() "the program has errors; see the problems" "o programa tem erros; veja os problemas";
    no_scenario(line, why) "the check itself has an error in line {line}: {why}" "a própria verificação tem um erro na linha {line}: {why}";
    no_card(why) "the card cannot be made: {why}" "não é possível criar o cartão: {why}";
    no_machine() "this file is not a machine" "este arquivo não é uma máquina";
    other_language(language)
        "this exercise asks for a program in `{language}`; give your file that ending"
        "este exercício pede um programa em `{language}`; dê essa extensão ao seu arquivo";
    hidden_chances()
        "with other, hidden chances, the machine does not do what it should"
        "com outros acasos, ocultos, a máquina não faz o que deve";
    no_find() "this exercise has no hidden fault" "este exercício não tem uma falha escondida";
    cannot_fail(name)
        "the hidden fault of this exercise is none that the machine {name} can have"
        "a falha escondida deste exercício não existe na máquina {name}";
    machine_first() "open a machine first" "abra uma máquina antes";
    fault_stuck() "stuck" "travado";
    fault_open() "wire broken" "fio partido";
    fault_short() "short circuit" "em curto";
    fault_welded() "contacts welded" "contatos soldados";
    fault_jammed() "jammed" "emperrado";
    fault_slow() "slow" "lento";
    fault_leaking() "leaks" "com vazamento";
    fault_bouncing() "bounces" "trepida";
    own_contacts() "real contacts drive the board's inputs; force the input instead" "contatos reais comandam as entradas da placa; force a entrada";
    no_settings() "a program on this computer has no settings" "um programa neste computador não tem configurações";
    own_program() "this computer runs the program that the page has" "este computador executa o programa que a página tem";
    none_given() "no program has been given yet; press Run" "nenhum programa foi enviado ainda; aperte Executar";
    no_point(name) "{name} is not a point that can be set" "{name} não é um ponto que se possa alterar";
    no_model(name) "no board is called {name}" "nenhuma placa se chama {name}";
    no_flash() "no firmware is being written" "nenhum firmware está sendo gravado";
    silent() "the board does not answer" "a placa não responde";
    garbled() "the board's answers are unreadable; check the rate and the parity" "as respostas da placa são ilegíveis; verifique a taxa e a paridade";
    lost(why) "the connection is lost: {why}" "a conexão caiu: {why}";
    refused_locked() "the board is locked against this" "a placa está bloqueada para isso";
    refused_address() "this board has no such point" "esta placa não tem esse ponto";
    refused_value() "the board does not accept that value" "a placa não aceita esse valor";
    refused_now() "the board cannot do that now; see its state" "a placa não pode fazer isso agora; veja o estado dela";
    refused_busy() "the board is busy" "a placa está ocupada";
    no_address(address, least, most) "address {address} is not valid; a board has an address from {least} to {most}" "o endereço {address} não é válido; uma placa tem um endereço de {least} a {most}";
    no_rate(rate, rates) "a board does not support {rate} baud; it supports {rates}" "uma placa não aceita {rate} baud; ela aceita {rates}";
    lock_grows() "a client can only add to a lock; to lift it, reset the board with A5 and the inputs 01 to 04 to ground" "um cliente só pode ampliar um bloqueio; para retirá-lo, faça o reset com A5 e as entradas 01 a 04 no GND";
    settings_locked() "the settings of the board are locked; to unlock them, reset the board with A5 and the inputs 01 to 04 to ground" "os ajustes da placa estão bloqueados; para desbloqueá-los, faça o reset com A5 e as entradas 01 a 04 no GND";
    settings_not_kept() "the board could not store the settings: its EEPROM is failing" "a placa não conseguiu guardar os ajustes: a EEPROM dela falha";
    settings_kept() "the board keeps these settings" "a placa guarda esses ajustes";
    settings_next() "the board stored these settings and uses them after its next start" "a placa guardou esses ajustes e os usa a partir do próximo início";
    but_stop(said) "{said}; it is in STOP now" "{said}; agora ela está em STOP";
    refused_way() "the gateway shares no board with this address" "o gateway não compartilha nenhuma placa com esse endereço";
    refused_silent() "the gateway gets no answer from the board" "o gateway não recebe resposta da placa";
    program_empty() "there is no program yet" "ainda não há programa";
    program_binary() "this is not text" "isto não é texto";
    program_other() "its first lines match none of the languages" "o começo do texto não é de nenhuma das linguagens";
    languages(all) "a program is {all}" "um programa é {all}";
    foreign() "this device does not run unoclp; install the firmware" "este dispositivo não roda o unoclp; grave o firmware";
    unread_empty() "the board holds no program" "a placa não tem programa";
    unread_untold() "this board's firmware cannot send its program: it is an older one, or that of a Nano" "o firmware desta placa não envia o programa: é mais antigo, ou é o de um Nano";
    unread_other() "this is no program that this page knows; read it again" "isto não é um programa que esta página conheça; leia de novo";
    unlike() "the board runs a different program from the one shown" "a placa executa um programa diferente do mostrado";
    upload_locked() "the board is locked against uploads" "a placa está bloqueada para envios";
    upload_not_begun() "the board does not accept a program now" "a placa não aceita um programa agora";
    upload_too_old() "the board's firmware is too old for this program; install the new one" "o firmware da placa é antigo demais para este programa; grave o novo";
    upload_ended() "another client ended the upload" "outro cliente encerrou o envio";
    upload_other() "the board stored a different program from the one sent; upload again" "a placa guardou um programa diferente do enviado; envie de novo";
    upload_off(why) "the upload failed: {why}; upload again" "o envio falhou: {why}; envie de novo";
    fault(number, text) "fault {number}: {text}" "falha {number}: {text}";
    fault_line(number, line, text) "fault {number}, line {line}: {text}" "falha {number}, linha {line}: {text}";
    unknown_fault() "unknown to this page" "desconhecida por esta página";
    behind_run() "the program is stored and runs" "o programa está gravado e em execução";
    behind_stop() "the program is stored; the board is in STOP" "o programa está gravado; a placa está em STOP";
    behind_switch() "the program is stored; the STOP switch holds the board" "o programa está gravado; a chave STOP segura a placa";
    behind_card() "the board loaded the program from its card; remove the card first" "a placa leu o programa do cartão; retire o cartão antes";
    behind_fault(what) "the program is stored, but stopped with {what}" "o programa está gravado, mas parou com {what}";
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
