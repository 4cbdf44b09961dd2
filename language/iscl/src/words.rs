//! The signs and keywords of InterSCL, and what students write for them.

use unoclp_small::cursor::{Keywords, named};
use unoclp_small::rules::{Rules, Sign};
use unoclp_text::diagnostics::Code;

pub(super) const RULES: Rules = Rules {
    language: "InterSCL",
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
        ("+", Sign::Plus),
        ("-", Sign::Minus),
        ("−", Sign::Minus),
        ("–", Sign::Minus),
        ("*", Sign::Star),
        ("/", Sign::Slash),
        ("=", Sign::Equal),
        ("<", Sign::Less),
        (">", Sign::Greater),
        ("\u{37e}", Sign::Semicolon),
    ],
    meant: &[
        ("==", Sign::Equal, "="),
        ("!=", Sign::NotEqual, "<>"),
        ("&&", Sign::And, "AND"),
        ("&", Sign::And, "AND"),
        ("||", Sign::Or, "OR"),
        ("|", Sign::Or, "OR"),
        ("!", Sign::Not, "NOT"),
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
    foreign: &["+=", "-=", "*=", "/=", "++", "**", "%", "{", "}", "[", "]"],
    points: false,
    titles: &[],
    comment: Code::IsclComment,
    comma: Code::IsclComma,
};

/// A keyword.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Word {
    None,
    Block,
    EndBlock,
    If,
    Then,
    Else,
    Elsif,
    EndIf,
    While,
    Do,
    EndWhile,
    For,
    To,
    EndFor,
    Print,
    Int,
    Real,
    Bool,
    Or,
    And,
    Not,
    True,
    False,
    At,
}

/// Each keyword as it is written.
const WORDS: [(&str, Word); 24] = [
    ("BLOCO", Word::Block),
    ("BLOCK", Word::Block),
    ("END_BLOCK", Word::EndBlock),
    ("IF", Word::If),
    ("THEN", Word::Then),
    ("ELSE", Word::Else),
    ("ELSIF", Word::Elsif),
    ("END_IF", Word::EndIf),
    ("WHILE", Word::While),
    ("DO", Word::Do),
    ("END_WHILE", Word::EndWhile),
    ("FOR", Word::For),
    ("TO", Word::To),
    ("END_FOR", Word::EndFor),
    ("PRINT", Word::Print),
    ("INT", Word::Int),
    ("REAL", Word::Real),
    ("BOOL", Word::Bool),
    ("OR", Word::Or),
    ("AND", Word::And),
    ("NOT", Word::Not),
    ("TRUE", Word::True),
    ("FALSE", Word::False),
    ("AT", Word::At),
];

/// What is written for them elsewhere.
const MEANT: [(&str, Word); 31] = [
    ("END_BLOCO", Word::EndBlock),
    ("ENDBLOCK", Word::EndBlock),
    ("FIM_BLOCO", Word::EndBlock),
    ("ENDIF", Word::EndIf),
    ("FIM_SE", Word::EndIf),
    ("FIMSE", Word::EndIf),
    ("ENDWHILE", Word::EndWhile),
    ("ENDFOR", Word::EndFor),
    ("SE", Word::If),
    ("ENTAO", Word::Then),
    ("ENTÃO", Word::Then),
    ("SENAO", Word::Else),
    ("SENÃO", Word::Else),
    ("ENQUANTO", Word::While),
    ("PARA", Word::For),
    ("ATE", Word::To),
    ("ATÉ", Word::To),
    ("FACA", Word::Do),
    ("FAÇA", Word::Do),
    ("ESCREVA", Word::Print),
    ("IMPRIMA", Word::Print),
    ("PRINTF", Word::Print),
    ("WRITE", Word::Print),
    ("INTEGER", Word::Int),
    ("INTEIRO", Word::Int),
    ("FLOAT", Word::Real),
    ("DOUBLE", Word::Real),
    ("BOOLEAN", Word::Bool),
    ("LOGICO", Word::Bool),
    ("OU", Word::Or),
    ("NAO", Word::Not),
];

impl Keywords for Word {
    const NONE: Word = Word::None;
    const WORDS: &'static [(&'static str, Word)] = &WORDS;
    const MEANT: &'static [(&'static str, Word)] = &MEANT;

    fn meant(word: &str) -> Word {
        // No word of the table has more than 9 letters.
        match word.len() > 12 {
            true => Word::None,
            false => named(&MEANT, &word.to_uppercase()),
        }
    }
}

impl Word {
    /// Whether it names a type.
    pub fn is_type(self) -> bool {
        matches!(self, Word::Int | Word::Real | Word::Bool)
    }

    /// Whether it ends a part, or begins the other half of IF.
    pub fn is_end(self) -> bool {
        use Word::{Else, Elsif, EndBlock, EndFor, EndIf, EndWhile};
        matches!(self, Else | Elsif | EndBlock | EndFor | EndIf | EndWhile)
    }

    /// Whether a command begins with it.
    pub fn begins(self) -> bool {
        matches!(self, Word::If | Word::While | Word::For | Word::Print)
    }
}

/// The words of Structured Text that InterSCL does not have, and what to write.
pub(super) fn lacking(word: &str) -> Option<(&'static str, &'static str)> {
    Some(match word.to_ascii_uppercase().as_str() {
        "CASE" => (
            "write an IF for each value: IF x = 1 THEN … END_IF",
            "escreva um IF para cada valor: IF x = 1 THEN … END_IF",
        ),
        "REPEAT" | "UNTIL" => (
            "write WHILE … DO … END_WHILE",
            "escreva WHILE … DO … END_WHILE",
        ),
        "EXIT" | "BREAK" | "CONTINUE" => (
            "end the loop with the condition of the WHILE",
            "encerre o laço com a condição do WHILE",
        ),
        "RETURN" => (
            "put an IF around the statements to skip",
            "ponha um IF em volta dos comandos a pular",
        ),
        "MOD" => (
            "compute the remainder: a - a / b * b",
            "calcule o resto: a - a / b * b",
        ),
        "XOR" => (
            "for an exclusive OR of BOOL values, write a <> b",
            "para o OU exclusivo de valores BOOL, escreva a <> b",
        ),
        "BY" => (
            "FOR counts in steps of 1; use WHILE for other steps",
            "FOR conta de 1 em 1; para outros passos, use WHILE",
        ),
        _ => return None,
    })
}
