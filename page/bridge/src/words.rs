//! What is told to a page in words: always in both languages, so that a page changes its language without asking again. What a
//! board tells is `client::words`.

use unoclp_program::{Lang, NoProgram};

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

unoclp_words::messages! {
    no_request(why) "the page sent a request that cannot be understood: {why}" "a página enviou um pedido incompreensível: {why}";
    no_such_board(name, known) "there is no board {name}; known boards: {known}" "não existe a placa {name}; placas conhecidas: {known}";
    no_board(session) "there is no session {session}" "não existe a sessão {session}";
    no_version(version) "the page asked about version {version} of the text, which no longer exists; edit the text and try again" "a página perguntou pela versão {version} do texto, que não existe mais; edite o texto e tente de novo";
    too_long(most) "the text is longer than {most} bytes" "o texto passa de {most} bytes";
    faulty() "the program has errors; see the problems" "o programa tem erros; veja os problemas";
    unfit(board, line, why) "the {board} cannot run this program: line {line}: {why}; nothing was sent" "o {board} não executa este programa: linha {line}: {why}; nada foi enviado";
    no_scenario(line, why) "the check itself has an error in line {line}: {why}" "a própria verificação tem um erro na linha {line}: {why}";
    no_card(why) "the card cannot be made: {why}" "não é possível criar o cartão: {why}";
    no_machine() "this file is not a machine" "este arquivo não é uma máquina";
    other_language(language)
        "this exercise asks for a program in `{language}`; give your file that extension"
        "este exercício pede um programa em `{language}`; dê essa extensão ao seu arquivo";
    hidden_chances()
        "with other, hidden random values, the machine does not do what it should"
        "com outros valores aleatórios, ocultos, a máquina não faz o que deve";
    no_find() "this exercise has no hidden fault" "este exercício não tem nenhuma falha escondida";
    cannot_fail(name)
        "the machine {name} cannot have the hidden fault of this exercise"
        "a máquina {name} não pode ter a falha escondida deste exercício";
    machine_first() "open a machine first" "abra uma máquina antes";
    fault_stuck() "stuck" "travado";
    fault_open() "wire broken" "fio partido";
    fault_short() "short circuit" "em curto";
    fault_welded() "contacts welded" "contatos soldados";
    fault_jammed() "jammed" "emperrado";
    fault_slow() "slow" "lento";
    fault_leaking() "leaking" "com vazamento";
    fault_bouncing() "bouncing contacts" "contatos com trepidação";
    own_contacts() "real contacts drive the board's inputs; force the input instead" "contatos reais comandam as entradas da placa; em vez disso, force a entrada";
    no_settings() "a program on this computer has no settings" "um programa neste computador não tem ajustes";
    own_program() "this computer is running the program open on the page" "este computador executa o programa aberto na página";
    none_runs() "nothing is running; press Run" "nenhum programa está em execução aqui; aperte Executar";
    none_given() "no program has been sent yet; press Run" "nenhum programa foi enviado ainda; aperte Executar";
    no_model(name) "no board is called {name}" "nenhuma placa se chama {name}";
    no_address(address, least, most) "address {address} is not valid; a board has an address from {least} to {most}" "o endereço {address} não é válido; uma placa tem um endereço de {least} a {most}";
    program_empty() "there is no program yet" "ainda não há programa";
    program_binary() "this is a binary file, not text" "este é um arquivo binário, não um texto";
    program_other() "its first lines match none of the languages" "as primeiras linhas não são de nenhuma das linguagens";
    languages(all) "a program is {all}" "um programa é {all}";
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

#[cfg(test)]
mod tests {
    #[test]
    fn every_text_says_the_same_in_both_languages() {
        let none: Vec<&str> = Vec::new();
        assert_eq!(unoclp_words::gaps(super::ALL), none);
    }
}
