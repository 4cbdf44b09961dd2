//! What the command line says, in the two languages that it speaks: one table, in which no text is without its twin.
//!
//! Owns the words, and which language this process speaks. Must not know who says them, nor where.

use std::fmt::Display;
use std::sync::OnceLock;
use unoclp_core::Cause;
use unoclp_lang::Lang;
use unoclp_source::diagnosis;

static SPOKEN: OnceLock<Lang> = OnceLock::new();

/// Speaks this language from now on. A process chooses once, before it says anything.
pub fn speak(lang: Lang) {
    // The first choice holds.
    let _ = SPOKEN.set(lang);
}

/// The language of this process; English before it has chosen.
pub fn spoken() -> Lang {
    #[cfg(test)]
    if let Some(lang) = tests::SPOKEN_HERE.get() {
        return lang;
    }
    SPOKEN.get().copied().unwrap_or_default()
}

/// The one of these two that is spoken.
pub fn either<T>(english: T, portuguese: T) -> T {
    match spoken() {
        Lang::En => english,
        Lang::Pt => portuguese,
    }
}

/// A fault without its place: `fault 75: too many jumps back in one scan (NC-19)`.
pub fn fault(cause: Cause) -> String {
    let (number, text) = (cause.number(), diagnosis::cause(cause, spoken()));
    format!("{} {number}: {text}", either("fault", "falha"))
}

/// `name(value, …) "English" "Portuguese";` becomes a function that gives the text in the language that is spoken.
macro_rules! messages {
    ($($name:ident($($value:ident),*) $english:literal $portuguese:literal;)*) => {
        $(
            #[doc = $english]
            pub fn $name($($value: impl Display),*) -> String {
                match spoken() {
                    Lang::En => format!($english),
                    Lang::Pt => format!($portuguese),
                }
            }
        )*

        /// All of them: name, English, Portuguese.
        pub const ALL: &[(&str, &str, &str)] = &[$((stringify!($name), $english, $portuguese)),*];
    };
}

messages! {
    cannot_read(file, error)
        "{file} cannot be read ({error}); check its name and folder"
        "não foi possível ler {file} ({error}); confira o nome e a pasta";
    cannot_write(file)
        "{file} cannot be written"
        "não foi possível gravar {file}";
    is_read(file)
        "{file} is what the command reads; name another file to write"
        "{file} é o arquivo que o comando lê; indique outro para gravar";
    is_compiled(file)
        "{file} is what is compiled; name another file with -o"
        "{file} é o que se compila; indique outro arquivo com -o";
    is_something_else(file, kind)
        "{file} is there already, and is not {kind}; it is left as it is. Name another file, or delete it"
        "{file} já existe e não é {kind}; ficou como estava. Indique outro arquivo ou apague-o";
    a_drawing() "an SVG drawing" "um desenho SVG";
    a_trace() "a VCD trace" "um registro VCD";
    a_program() "numeric code" "código numérico";
    forced(points)
        "forced: {points}"
        "forçados: {points}";
    forced_before(points)
        "forced since before: {points}; x lets all go"
        "já estavam forçados: {points}; x libera tudo";
    stays_forced(points)
        "still forced: {points}; a monitor lets them go with x, and so does a restart"
        "continuam forçados: {points}; um monitor os libera com x, um reinício também";
    let_go(points)
        "no longer forced: {points}"
        "não estão mais forçados: {points}";
    stays_on(outputs)
        "{outputs} stays on: no rung writes it; it goes off at STOP"
        "{outputs} continua ligada: nenhum degrau a escreve; ela desliga em STOP";
    may_stay_on(outputs)
        "{outputs} is on, and stays so unless the program writes it; it goes off at STOP"
        "{outputs} está ligada e assim fica se o programa não a escrever; ela desliga em STOP";
    interrupted_with_old(state)
        "interrupted; the board is in {state}, and keeps the program that it had"
        "interrompido; a placa está em {state} e mantém o programa que tinha";
    interrupted_with_new(state)
        "interrupted; the board is in {state}, and keeps the new program"
        "interrompido; a placa está em {state} e já tem o programa novo";
    interrupted_unknown(error)
        "interrupted; the board no longer answers ({error}): whether it runs, and which program it keeps, is open"
        "interrompido; a placa não responde mais ({error}): não se sabe se ela roda nem que programa ela tem";
    too_small(columns, lines)
        "this screen is too small: {columns} x {lines}"
        "esta tela é pequena demais: {columns} x {lines}";
    needs(columns, lines)
        "at least {columns} x {lines} is needed"
        "é preciso pelo menos {columns} x {lines}";
    q_quits() "q quits" "q encerra";
    too_large(file, bytes)
        "{file} has more than {bytes} bytes; no program is as long"
        "{file} tem mais de {bytes} bytes; nenhum programa é tão longo";
    in_fault_later(ms)
        "in FAULT, within the first {ms} ms of its scans:"
        "em FAULT nos primeiros {ms} ms de varreduras:";
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use std::cell::Cell;

    thread_local! {
        /// The language of a test, apart from the others of the process.
        pub(crate) static SPOKEN_HERE: Cell<Option<Lang>> = const { Cell::new(None) };
    }

    /// The values that a text names, in order of their names.
    fn values(text: &str) -> Vec<&str> {
        let parts = text.split('{').skip(1);
        let mut names: Vec<&str> = parts
            .map(|part| part.split(['}', ':']).next().unwrap_or_default())
            .collect();
        names.sort_unstable();
        names.dedup();
        names
    }

    #[test]
    fn every_message_says_the_same_in_both_languages() {
        for (name, english, portuguese) in ALL {
            assert_eq!(values(english), values(portuguese), "{name}");
            assert!(!portuguese.trim().is_empty(), "{name}");
            assert_ne!(english, portuguese, "{name}");
        }
    }
}
