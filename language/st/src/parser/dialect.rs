//! Words of other dialects that begin what this language has not, told by name.

use super::super::token::Kind;
use super::super::words::Keyword;
use super::Parser;
use unoclp_text::diagnostics::Code;

/// What a word belongs to, and what to take in its place.
fn meaning(upper: &str) -> Option<(&'static str, &'static str)> {
    Some(match upper {
        "METHOD" | "PROPERTY" => (
            "unoclp has no classes; write a FUNCTION, or a FUNCTION_BLOCK with inputs",
            "o unoclp não tem classes; escreva uma FUNCTION, ou um FUNCTION_BLOCK com entradas",
        ),
        "CLASS" | "INTERFACE" => (
            "unoclp has no classes; write a FUNCTION_BLOCK",
            "o unoclp não tem classes; escreva um FUNCTION_BLOCK",
        ),
        "EXTENDS" | "IMPLEMENTS" => (
            "unoclp has no classes; declare an instance of the other block in this one",
            "o unoclp não tem classes; declare neste bloco uma instância do outro",
        ),
        "NAMESPACE" => (
            "unoclp has no namespaces; declare the units without one",
            "o unoclp não tem namespaces; declare as unidades sem namespace",
        ),
        _ => return None,
    })
}

impl Parser<'_, '_> {
    /// Tells a word that belongs to another dialect, with a name behind it, and reads no further: one mistake, one message.
    pub(super) fn other_dialect(&mut self) -> bool {
        let token = self.token();
        let begins = !self.list
            && token.kind == Kind::Word
            && self.keyword() == Keyword::None
            && self.ahead(1).kind == Kind::Word;
        let upper = match begins {
            true => self.slice(token.span).to_uppercase(),
            false => return false,
        };
        let Some(help) = meaning(&upper) else {
            return false;
        };
        self.tell(Code::StUnsupported, token.span, [upper.into(), help.into()]);
        self.dead = true;
        true
    }
}
