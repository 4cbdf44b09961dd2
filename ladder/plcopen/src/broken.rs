//! Why a text is no XML, in both languages; where it is, the diagnostic says.

use roxmltree::Error;
use unoclp_lang::Word;

/// The reason of the reader.
pub(crate) fn reason(error: &Error) -> Word {
    let both = |en: &str, pt: &str| Word::from((en, pt));
    let named = |en: &str, pt: &str, name: &str| {
        Word::from((format!("{en} `{name}`"), format!("{pt} `{name}`")))
    };
    match error {
        Error::NoRootNode => both("it has no element", "ele não tem nenhum elemento"),
        Error::UnclosedRootNode | Error::UnexpectedEndOfStream => both(
            "it ends before its last element is closed",
            "ele termina antes de o último elemento ser fechado",
        ),
        Error::DtdDetected => both(
            "`<!DOCTYPE`, which may contain entities, is not allowed",
            "`<!DOCTYPE`, que pode ter entidades, não é permitido",
        ),
        Error::UnexpectedCloseTag(expected, actual, _) => Word::from((
            format!("`</{actual}>` is where `</{expected}>` should be"),
            format!("`</{actual}>` está onde deveria estar `</{expected}>`"),
        )),
        Error::UnknownEntityReference(name, _) => named(
            "there is no entity",
            "não existe a entidade",
            &format!("&{name};"),
        ),
        Error::MalformedEntityReference(_) => both(
            "a bare `&`, which XML writes as `&amp;`",
            "um `&` solto, que em XML se escreve `&amp;`",
        ),
        Error::InvalidAttributeValue(_) => both(
            "a bare `<` in an attribute, which XML writes as `&lt;`",
            "um `<` solto em um atributo, que em XML se escreve `&lt;`",
        ),
        Error::DuplicatedAttribute(name, _) => named(
            "an element repeats the attribute",
            "um elemento repete o atributo",
            name,
        ),
        Error::UnknownNamespace(prefix, _) => {
            named("an undeclared prefix", "um prefixo não declarado", prefix)
        }
        Error::DuplicatedNamespace(prefix, _) => named(
            "an element redeclares the prefix",
            "um elemento declara de novo o prefixo",
            prefix,
        ),
        Error::InvalidXmlPrefixUri(_)
        | Error::UnexpectedXmlUri(_)
        | Error::UnexpectedXmlnsUri(_)
        | Error::InvalidElementNamePrefix(_) => both(
            "a reserved XML namespace is declared or used incorrectly",
            "um espaço de nomes reservado do XML está declarado ou usado incorretamente",
        ),
        Error::UnexpectedDeclaration(_) => both(
            "`<?xml` may appear only at the very beginning",
            "`<?xml` só pode estar bem no início",
        ),
        Error::NonXmlChar(sign, _) => named(
            "XML does not allow the character",
            "o XML não permite o caractere",
            &format!("U+{:04X}", u32::from(*sign)),
        ),
        Error::InvalidComment(_) => both("a comment contains `--`", "um comentário tem `--`"),
        Error::InvalidCharacterData(_) => {
            both("`]]>` appears outside CDATA", "`]]>` está fora de CDATA")
        }
        Error::InvalidName(_) => both(
            "a name that XML does not allow",
            "um nome que o XML não permite",
        ),
        Error::InvalidChar(expected, ..) => due(&char::from(*expected).to_string()),
        Error::InvalidChar2(expected, ..) | Error::InvalidString(expected, _) => due(expected),
        Error::NodesLimitReached
        | Error::AttributesLimitReached
        | Error::NamespacesLimitReached => {
            both("it has too many elements", "ele tem elementos demais")
        }
        // Of document types, which are refused, and what has no words of its own.
        _ => both(
            "this is neither an element nor text",
            "isto não é elemento nem texto",
        ),
    }
}

/// What is missing: a sign, or in the reader's words a kind of them.
fn due(expected: &str) -> Word {
    let pt = match expected {
        "a quote" => "aspas",
        "a whitespace" | "space" => "um espaço",
        own => own,
    };
    match pt == expected {
        true => Word::from((
            format!("`{expected}` is missing"),
            format!("falta `{expected}`"),
        )),
        false => Word::from((format!("{expected} is missing"), format!("falta {pt}"))),
    }
}
