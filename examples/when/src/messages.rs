//! What WHEN alone says of a text; the rest it has of unoclp.

use unoclp_text::diagnostics::{Code, Row, Severity, Words};

macro_rules! row {
    ($name:ident $number:literal $message:literal $help:literal $mensagem:literal $ajuda:literal) => {
        pub(crate) const $name: Code = Code::of(&Row {
            table: "WHEN",
            number: $number,
            severity: Severity::Error,
            english: Words {
                message: $message,
                help: $help,
            },
            portuguese: Words {
                message: $mensagem,
                help: $ajuda,
            },
        });
    };
}

row! { EXPECTED 1
"{0} stands where {1} is expected" "write `lamp is output 1` or `lamp when start and not stop`"
"{0} está onde se espera {1}" "escreva `lamp is output 1` ou `lamp when start and not stop`" }
row! { NOT_DECLARED 2
"nothing says what `{0}` is" "{1}"
"nada diz o que `{0}` é" "{1}" }
row! { TOO_DEEP 3
"this line is too long or nests too deeply" "write a part of it as a rule of its own"
"esta linha é longa ou profunda demais" "escreva uma parte dela como uma regra própria" }
row! { TOO_LONG 4
"{0} is longer than a timer can wait" "the longest time is 2147483647 ms"
"{0} é mais do que um temporizador pode esperar" "o maior tempo é 2147483647 ms" }
