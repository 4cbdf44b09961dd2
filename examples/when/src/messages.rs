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
"{0} was found, but {1} is expected here" "write `lamp is output 1` or `lamp when start and not stop`"
"{0} apareceu aqui, mas o esperado é {1}" "escreva `lamp is output 1` ou `lamp when start and not stop`" }
row! { NOT_DECLARED 2
"`{0}` is not defined" "{1}"
"`{0}` não foi definido" "{1}" }
row! { TOO_DEEP 3
"this line is too long or too deeply nested" "write part of the line as a separate rule"
"esta linha é longa demais ou tem aninhamento demais" "escreva parte da linha como uma regra separada" }
row! { TOO_LONG 4
"{0} is too long for a timer" "the longest time is 2147483647 ms"
"{0} é longo demais para um temporizador" "o maior tempo é 2147483647 ms" }
