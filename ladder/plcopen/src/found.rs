//! The mistakes that were found, each at its place in the file.

use roxmltree::Node;
use unoclp_lang::{Code, Diagnostic, Severity, Span, Told, Word};

/// More than this are only counted.
const MOST: usize = 100;

/// The diagnostics of a file, as they are found.
#[derive(Clone, Default)]
pub(crate) struct Found {
    told: Told,
    errors: usize,
}

impl Found {
    /// Tells it at the start tag of this element.
    pub(crate) fn tell<const N: usize>(&mut self, code: Code, at: Node<'_, '_>, words: [Word; N]) {
        self.tell_at(code, span(at), words);
    }

    pub(crate) fn tell_at<const N: usize>(&mut self, code: Code, span: Span, words: [Word; N]) {
        self.take(Diagnostic::new(code, span, words.into()));
    }

    /// Takes a diagnostic that somebody else has made.
    pub(crate) fn take(&mut self, diagnostic: Diagnostic) {
        if self.told.listed.contains(&diagnostic) {
            return;
        }
        self.errors += usize::from(diagnostic.severity() == Severity::Error);
        if self.told.listed.len() < MOST {
            self.told.listed.push(diagnostic);
            return;
        }
        self.told.more += 1;
        // No warning takes the place of an error.
        let is_warning = |told: &Diagnostic| told.severity() != Severity::Error;
        if !is_warning(&diagnostic)
            && let Some(last) = self.told.listed.iter().rposition(is_warning)
        {
            self.told.listed[last] = diagnostic;
        }
    }

    /// The codes of the errors that are listed.
    pub(crate) fn errors(&self) -> impl Iterator<Item = Code> {
        let told = self.told.listed.iter();
        let errors = told.filter(|told| told.severity() == Severity::Error);
        errors.map(|told| told.code)
    }

    /// Whether each error has one of these codes.
    pub(crate) fn is_only(&self, codes: &[Code]) -> bool {
        self.errors().count() == self.errors && self.errors().all(|code| codes.contains(&code))
    }

    /// Keeps what has such a code.
    pub(crate) fn retain(&mut self, keeps: impl Fn(&Code) -> bool) {
        self.told.listed.retain(|told| keeps(&told.code));
    }

    pub(crate) fn has_errors(&self) -> bool {
        self.errors > 0
    }

    /// Whether it has been told that the program does not fit.
    pub(crate) fn is_too_long(&self) -> bool {
        self.told.iter().any(|told| told.code == Code::DoesNotFit)
    }

    pub(crate) fn finish(mut self) -> Told {
        let place = |d: &Diagnostic| (d.span.start, d.span.end, d.code);
        self.told.listed.sort_by_key(place);
        self.told
    }
}

/// Where the start tag of an element stands, or a piece of text.
pub(crate) fn span(at: Node<'_, '_>) -> Span {
    let range = at.range();
    let text = at.document().input_text();
    let all = text.get(range.clone()).unwrap_or_default();
    let length = match at.is_element() {
        true => all.find('>').map_or(all.len(), |end| end + 1),
        false => all.len(),
    };
    // One line of it is enough to find it.
    let line = all[..length].find('\n').unwrap_or(length);
    Span {
        start: range.start as u32,
        end: (range.start + line) as u32,
    }
}
