//! The signs and keywords of LCE, and what students write for them.

use unoclp_small::cursor::Keywords;
use unoclp_small::rules::{Rules, Sign};
use unoclp_text::diagnostics::Code;

pub(super) const RULES: Rules = Rules {
    language: "LCE",
    signs: &[
        (":=", Sign::Assign),
        ("<>", Sign::NotEqual),
        ("<=", Sign::LessEqual),
        (">=", Sign::GreaterEqual),
        (":", Sign::Colon),
        (";", Sign::Semicolon),
        (",", Sign::Comma),
        ("(", Sign::Open),
        (")", Sign::Close),
        ("{", Sign::OpenBrace),
        ("}", Sign::CloseBrace),
        ("+", Sign::Plus),
        ("-", Sign::Minus),
        ("−", Sign::Minus),
        ("–", Sign::Minus),
        ("*", Sign::Star),
        ("/", Sign::Slash),
        ("&", Sign::And),
        ("|", Sign::Or),
        ("^", Sign::Xor),
        ("!", Sign::Not),
        ("=", Sign::Equal),
        ("<", Sign::Less),
        (">", Sign::Greater),
        ("\u{37e}", Sign::Semicolon),
    ],
    meant: &[
        ("==", Sign::Equal, "="),
        ("!=", Sign::NotEqual, "<>"),
        ("&&", Sign::And, "&"),
        ("||", Sign::Or, "|"),
        ("=<", Sign::LessEqual, "<="),
        ("=>", Sign::GreaterEqual, ">="),
        ("=:", Sign::Assign, ":="),
        ("<-", Sign::Assign, ":="),
        ("≤", Sign::LessEqual, "<="),
        ("≥", Sign::GreaterEqual, ">="),
        ("≠", Sign::NotEqual, "<>"),
        ("×", Sign::Star, "*"),
        ("÷", Sign::Slash, "/"),
    ],
    foreign: &["+=", "-=", "*=", "/=", "++", "**", "%", "[", "]"],
    points: true,
    titles: &["rede", "network"],
    comment: Code::LceComment,
    comma: Code::LceComma,
};

/// A keyword.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Word {
    None,
    Plc,
    End,
    Var,
    Network,
    Coil,
    On,
    Off,
    If,
    Else,
    Not,
}

/// Each keyword as it is written, in Portuguese and in English.
const WORDS: [(&str, Word); 21] = [
    ("clp", Word::Plc),
    ("plc", Word::Plc),
    ("fim", Word::End),
    ("end", Word::End),
    ("var", Word::Var),
    ("rede", Word::Network),
    ("network", Word::Network),
    ("aciona", Word::Coil),
    ("operate", Word::Coil),
    ("liga", Word::On),
    ("turn_on", Word::On),
    ("desliga", Word::Off),
    ("turn_off", Word::Off),
    ("se", Word::If),
    ("if", Word::If),
    ("senao", Word::Else),
    ("senão", Word::Else),
    ("else", Word::Else),
    ("nao", Word::Not),
    ("não", Word::Not),
    ("NÃO", Word::Not),
];

/// What is written for them elsewhere.
const MEANT: [(&str, Word); 12] = [
    ("acionar", Word::Coil),
    ("ligar", Word::On),
    ("set", Word::On),
    ("turnon", Word::On),
    ("desligar", Word::Off),
    ("reset", Word::Off),
    ("turnoff", Word::Off),
    ("sinao", Word::Else),
    ("elsif", Word::Else),
    ("variaveis", Word::Var),
    ("fimclp", Word::End),
    ("not", Word::Not),
];

impl Keywords for Word {
    const NONE: Word = Word::None;
    const WORDS: &'static [(&'static str, Word)] = &WORDS;
    const MEANT: &'static [(&'static str, Word)] = &MEANT;
}

impl Word {
    /// Whether a command begins with it.
    pub fn begins(self) -> bool {
        matches!(self, Word::Coil | Word::On | Word::Off | Word::If)
    }
}

/// The words of other languages that LCE does not have, and what to write.
pub(super) fn lacking(word: &str) -> Option<(&'static str, &'static str)> {
    if word.len() > 12 {
        return None;
    }
    Some(match word.to_lowercase().as_str() {
        "while" | "enquanto" | "for" | "para" | "repeat" | "repita" => (
            "every scan runs the whole program again; write se (…)",
            "o próprio programa se repete a cada varredura; escreva se (…)",
        ),
        "and" | "e" => ("write &", "escreva &"),
        "or" | "ou" => ("write |", "escreva |"),
        "xor" => ("write ^", "escreva ^"),
        "mod" => (
            "compute the remainder: V0 - V0 / V1 * V1",
            "calcule o resto: V0 - V0 / V1 * V1",
        ),
        "true" | "verdadeiro" => ("write 1", "escreva 1"),
        "false" | "falso" => ("write 0", "escreva 0"),
        "int" | "real" | "bool" | "float" | "inteiro" => (
            "variables have no declared type: V0, V1, … already exist, and var gives them names: V0 = nivel;",
            "as variáveis não têm tipo declarado: V0, V1, … já existem, e var dá nomes a elas: V0 = nivel;",
        ),
        "print" | "imprima" | "escreva" => (
            "store the value in a variable; the simulator shows the variable",
            "guarde o valor em uma variável; o simulador a mostra",
        ),
        _ => return None,
    })
}
