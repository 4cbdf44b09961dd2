//! What the text editor of a page is offered and told, with places as a browser counts them: in units of UTF-16.

use crate::answer::answer;
use crate::draw::Speak;
use crate::tell::{Units, byte};
use crate::words::{No, both};
use unoclp_assist as assist;
use unoclp_assist::{Edit, Kind};
use unoclp_program::{Lang, Refused};
use unoclp_workspace::Analysis;

answer! {
    /// What may stand at a place.
    pub struct Offers as "Offers" {
        /// Where the word begins that is written there, units of UTF-16 from the beginning of the text.
        from: usize,
        offers: Vec<Offer>,
    }
}

answer! {
    /// Something that may stand there.
    pub struct Offer as "Offer" {
        label: String,
        kind: &'static str => "\"variable\" | \"property\" | \"function\" | \"type\" | \"enum\" | \"constant\" | \"keyword\"",
        /// Its type, or what it takes.
        detail: String,
        /// What is written, where that is not the label.
        insert: Option<String>,
    }
}

answer! {
    /// What a word stands for.
    pub struct Meant as "Meant" {
        from: usize,
        to: usize,
        head: String,
        lines: Vec<String>,
        /// The variable or point whose live value it is.
        value: Option<String>,
    }
}

answer! {
    /// A place at which a name is used.
    pub struct UsedAt as "UsedAt" {
        /// From 1.
        line: u32,
        from: usize,
        to: usize,
        declares: bool,
        writes: bool,
    }
}

answer! {
    /// A change of a text.
    pub struct Change as "Change" {
        from: usize,
        to: usize,
        insert: String,
    }
}

answer! {
    /// A way to mend a mistake.
    pub struct Mended as "Mended" {
        title: String,
        changes: Vec<Change>,
    }
}

/// What may stand at a unit of UTF-16.
pub fn complete(analysis: &Analysis, at: usize, speak: Speak) -> Offers {
    let text = analysis.written().text();
    let (span, offers) = assist::complete(analysis.written(), byte(&text, at), speak.into());
    let offer = |offer: assist::Offer| Offer {
        kind: match offer.kind {
            Kind::Variable => "variable",
            Kind::Member => "property",
            Kind::Function => "function",
            Kind::Type => "type",
            Kind::Value => "enum",
            Kind::Place => "constant",
            Kind::Word => "keyword",
        },
        label: offer.label,
        detail: offer.detail,
        insert: offer.insert,
    };
    Offers {
        from: Units::new(&text).of(span.start as usize),
        offers: offers.into_iter().map(offer).collect(),
    }
}

/// What stands at a unit of UTF-16; none where nothing is known of it.
pub fn meant(analysis: &Analysis, at: usize, speak: Speak) -> Option<Meant> {
    let text = analysis.written().text();
    let told = assist::hover(analysis, byte(&text, at), speak.into())?;
    let mut units = Units::new(&text);
    Some(Meant {
        from: units.of(told.span.start as usize),
        to: units.of(told.span.end as usize),
        head: told.head,
        lines: told.lines,
        value: told.value,
    })
}

/// Where what stands at a unit of UTF-16 is used, its declaration among them.
pub fn uses(analysis: &Analysis, at: usize) -> Vec<UsedAt> {
    let text = analysis.written().text();
    let lines = unoclp_lang::Lines::new(&text);
    let at = byte(&text, at);
    let declaration = assist::declaration(analysis.written(), at);
    let mut units = Units::new(&text);
    let uses = assist::uses(analysis.written(), at).into_iter();
    uses.map(|own| UsedAt {
        line: lines.line(own.span.start),
        from: units.of(own.span.start as usize),
        to: units.of(own.span.end as usize),
        declares: declaration == Some(own.span),
        writes: own.writes,
    })
    .collect()
}

/// What gives the name at a unit of UTF-16 another.
///
/// # Errors
/// Why it cannot have that.
pub fn rename(analysis: &Analysis, at: usize, name: &str) -> Result<Vec<Change>, No> {
    let text = analysis.written().text();
    let edits = assist::rename(analysis, byte(&text, at), name);
    let edits = edits.map_err(|why| No::Told(both(|lang| why.message(lang))))?;
    Ok(changes(&text, edits))
}

/// What places the words of a text well.
pub fn form(analysis: &Analysis) -> Vec<Change> {
    let text = analysis.written().text();
    changes(&text, assist::format(analysis.written(), None))
}

/// What can be done about the mistakes between two units of UTF-16.
pub fn remedies(analysis: &Analysis, from: usize, to: usize, speak: Speak) -> Vec<Mended> {
    let text = analysis.written().text();
    let (from, to) = (byte(&text, from), byte(&text, to));
    let told = match analysis.check() {
        Some(Ok(source)) => source.language.warnings(),
        Some(Err(Refused::Text { diagnostics, .. })) => Some(diagnostics),
        _ => None,
    };
    let told = told.map_or(&[][..], |told| &told.listed);
    let here = told
        .iter()
        .filter(|about| about.span.start <= to && from <= about.span.end);
    let lang: Lang = speak.into();
    here.flat_map(|about| assist::remedies(analysis.written(), about, lang))
        .map(|remedy| Mended {
            title: remedy.title,
            changes: changes(&text, remedy.edits),
        })
        .collect()
}

fn changes(text: &str, edits: Vec<Edit>) -> Vec<Change> {
    let mut units = Units::new(text);
    let change = |edit: Edit| Change {
        from: units.of(edit.span.start as usize),
        to: units.of(edit.span.end as usize),
        insert: edit.text,
    };
    edits.into_iter().map(change).collect()
}
