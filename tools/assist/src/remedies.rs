//! What a diagnostic says one could do, done.

use crate::reader::Reader;
use crate::{Edit, language, words};
use unoclp_lang::outline::What;
use unoclp_lang::typed::Base;
use unoclp_lang::{Code, Diagnostic, Lang, Span, Word};
use unoclp_program::Written;

/// A way to mend a mistake.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Remedy {
    /// What it does, in words.
    pub title: String,
    /// What it changes.
    pub edits: Vec<Edit>,
}

/// Those whose second word takes the place of the first.
const SAYS_WHAT: [Code; 6] = [
    Code::StOtherWord,
    Code::OtherWord,
    Code::DecimalComma,
    Code::IsclComma,
    Code::LceComma,
    Code::TimePrefix,
];

/// What can be done about this; nothing where only a person knows.
pub fn remedies(written: &Written, about: &Diagnostic, lang: Lang) -> Vec<Remedy> {
    let text = written.text();
    let at = text.get(about.span.range()).unwrap_or_default();
    let mut all = Vec::new();
    let replace = |by: &str| Remedy {
        title: words::write_instead(lang, by),
        edits: vec![Edit {
            span: about.span,
            text: by.to_owned(),
        }],
    };
    for word in about.words() {
        // What is near a name takes its place, where nothing but the name is marked.
        if let Word::Near(name) = word
            && !at.is_empty()
            && at.chars().all(|c| c.is_alphanumeric() || c == '_')
        {
            all.push(replace(name));
        }
    }
    let word = |place: usize| match about.words().get(place) {
        Some(Word::Text(word)) => Some(word.as_str()),
        _ => None,
    };
    let is = |codes: &[Code]| codes.contains(&about.code);
    // The message names what stands there, and what to write.
    let quotes = word(0) == Some(at);
    if is(&[Code::StStray, Code::StrayCharacter]) && !at.is_empty() {
        all.push(Remedy {
            title: words::delete_it(lang, at),
            edits: vec![Edit {
                span: about.span,
                text: String::new(),
            }],
        });
    } else if is(&SAYS_WHAT) && quotes {
        all.extend(word(1).filter(|by| is_code(by)).map(replace));
    } else if is(&[Code::TimeUnit]) && quotes {
        all.extend([replace(&format!("{at}s")), replace(&format!("{at}ms"))]);
    } else if is(&[Code::StEqualsForAssign]) {
        all.extend(sign(about.span, at, "=", ":=", lang));
    } else if is(&[Code::StAssignForEquals]) {
        all.extend(sign(about.span, at, ":=", "=", lang));
    } else if is(&[Code::LabelColon]) {
        all.push(insert(about.span.end, ":", lang));
    } else if is(&[Code::StUndeclared, Code::Undeclared, Code::IsclUndeclared]) {
        all.extend(declared(written, &text, about, lang));
    }
    all
}

/// Whether it is what one writes, and no words about that.
fn is_code(text: &str) -> bool {
    !text.is_empty() && !text.contains(' ')
}

fn insert(at: u32, sign: &str, lang: Lang) -> Remedy {
    let span = Span { start: at, end: at };
    Remedy {
        title: words::insert_it(lang, sign),
        edits: vec![Edit {
            span,
            text: sign.to_owned(),
        }],
    }
}

/// One sign in the marked text in the place of another.
fn sign(span: Span, at: &str, wrong: &str, right: &str, lang: Lang) -> Option<Remedy> {
    let start = span.start + at.find(wrong)? as u32;
    let end = start + wrong.len() as u32;
    Some(Remedy {
        title: words::write_instead(lang, right),
        edits: vec![Edit {
            span: Span { start, end },
            text: right.to_owned(),
        }],
    })
}

/// A declaration of the marked name, after the last one of its unit.
fn declared(written: &Written, text: &str, about: &Diagnostic, lang: Lang) -> Vec<Remedy> {
    let name = text.get(about.span.range()).unwrap_or_default();
    let Some(language) = language(written).filter(|_| unoclp_lang::is_name(name)) else {
        return Vec::new();
    };
    let reader = Reader::new(text, language);
    let unit = reader.unit_at(about.span.start);
    let mut own = reader.outline.named.iter().filter(|named| {
        let is_var = named
            .section
            .is_some_and(|own| reader.written(own).eq_ignore_ascii_case("VAR"));
        named.what == What::Variable
            && named.within == unit
            && (is_var || language.name() == "iscl")
    });
    let Some(last) = own.next_back() else {
        return Vec::new();
    };
    // After the line on which the last one stands.
    let end = last.whole.end as usize;
    let Some(line) = text.get(end..).and_then(|rest| rest.find('\n')) else {
        return Vec::new();
    };
    let start = text[..last.whole.start as usize]
        .rfind('\n')
        .map_or(0, |at| at + 1);
    let indent = &text[start..last.whole.start as usize];
    let indent = if indent.trim().is_empty() {
        indent
    } else {
        "  "
    };
    let types = match language.name() {
        "iscl" => [Base::Bool, Base::Int],
        _ => [Base::Bool, Base::Dint],
    };
    let declare = |ty: Base| {
        let ty = ty.name();
        let line_of = match language.name() {
            "iscl" => format!("{indent}{ty} {name};\n"),
            _ => format!("{indent}{name} : {ty};\n"),
        };
        let at = (end + line + 1) as u32;
        Remedy {
            title: words::declare(lang, name, ty),
            edits: vec![Edit {
                span: Span { start: at, end: at },
                text: line_of,
            }],
        }
    };
    types.into_iter().map(declare).collect()
}
