//! A text as its words and its declarations have it.

use std::collections::{HashMap, HashSet};
use unoclp_lang::outline::{Named, Outline, What};
use unoclp_lang::{Colour, Span, TextLanguage};

/// A word of a text.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Word<'t> {
    pub span: Span,
    pub text: &'t str,
    pub colour: Option<Colour>,
}

impl Word<'_> {
    /// Whether it is a name, by its form.
    pub fn is_name(self) -> bool {
        self.colour.is_none()
            && self
                .text
                .starts_with(|c: char| c.is_alphabetic() || c == '_')
    }
}

/// None: the word stands in no parentheses.
pub(crate) const NO_OPENER: usize = usize::MAX;

/// A text in a language, so that one can ask for its words by their places.
pub(crate) struct Reader<'t> {
    pub text: &'t str,
    pub language: TextLanguage,
    pub words: Vec<Word<'t>>,
    pub outline: Outline,
    /// For each word the `(` or `[` that it stands in, or that it closes.
    pub openers: Vec<usize>,
    /// The words that name a type, a block or a function by where they stand, by their first bytes: a variable of that name
    /// is not meant.
    pub types: HashSet<u32>,
    /// The words that name a program so.
    pub programs: HashSet<u32>,
    /// Declarations by what they belong to and by their names, folded; without the programs, whose names others may have.
    names: HashMap<(Option<usize>, String), usize>,
    /// The programs by their names.
    runs: HashMap<String, usize>,
    /// The units, in the order of their places: none stands in another.
    units: Vec<usize>,
    /// Values of enumerations, which need no type before them.
    values: HashMap<String, usize>,
}

impl<'t> Reader<'t> {
    /// It takes a time in proportion to the text.
    pub fn new(text: &'t str, language: TextLanguage) -> Reader<'t> {
        let word = |(span, colour): (Span, Option<Colour>)| Word {
            span,
            text: text.get(span.range()).unwrap_or_default(),
            colour,
        };
        let words = language.words(text).into_iter().map(word);
        let words = words.filter(|word| !word.text.trim().is_empty());
        let words: Vec<Word<'_>> = words.flat_map(parted).collect();
        let outline = language.outline(text);
        let mut reader = Reader {
            text,
            language,
            openers: Vec::new(),
            types: HashSet::new(),
            programs: configured(&words).collect(),
            words,
            outline,
            names: HashMap::new(),
            runs: HashMap::new(),
            units: Vec::new(),
            values: HashMap::new(),
        };
        reader.openers = openers(&reader.words);
        reader.types = reader.typed();
        for (at, named) in reader.outline.named.iter().enumerate() {
            let key = (named.within, reader.fold(reader.written(named.name)));
            if named.what.is_unit() {
                reader.units.push(at);
            }
            if named.what == What::Value {
                reader.values.entry(key.1.clone()).or_insert(at);
            }
            // The first one counts: a second is a mistake that the compiler tells.
            match named.what {
                What::Program => reader.runs.entry(key.1).or_insert(at),
                _ => reader.names.entry(key).or_insert(at),
            };
        }
        reader
    }

    /// The words that declarations have for types: none of them stands in parentheses.
    fn typed(&self) -> HashSet<u32> {
        let mut all = HashSet::new();
        for span in self.outline.named.iter().filter_map(|named| named.ty) {
            let first = |byte: u32| self.words.partition_point(|word| word.span.start < byte);
            for at in first(span.start)..first(span.end) {
                let opener = self.opener(at).map(|opener| self.words[opener].span.start);
                if opener.is_none_or(|opener| opener < span.start) {
                    all.insert(self.words[at].span.start);
                }
            }
        }
        all
    }

    /// What is written there.
    pub fn written(&self, span: Span) -> &'t str {
        self.text.get(span.range()).unwrap_or_default()
    }

    /// A name as all its spellings have it.
    pub fn fold(&self, name: &str) -> String {
        match self.outline.letters_apart {
            true => name.to_owned(),
            false => name.to_uppercase(),
        }
    }

    /// A declaration by its place among all.
    pub fn named(&self, at: usize) -> Option<&Named> {
        self.outline.named.get(at)
    }

    /// The program of this name.
    pub fn program(&self, name: &str) -> Option<usize> {
        self.runs.get(&self.fold(name)).copied()
    }

    /// The declaration of this name in a unit or type, or among those of all but programs.
    pub fn find(&self, within: Option<usize>, name: &str) -> Option<usize> {
        self.names.get(&(within, self.fold(name))).copied()
    }

    /// The unit in which this byte stands.
    pub fn unit_at(&self, byte: u32) -> Option<usize> {
        let begun = |&unit: &usize| self.outline.named[unit].whole.start <= byte;
        let after = self.units.partition_point(begun);
        let unit = *self.units.get(after.checked_sub(1)?)?;
        (byte <= self.outline.named[unit].whole.end).then_some(unit)
    }

    /// The value of any enumeration that has this name.
    pub fn value(&self, name: &str) -> Option<usize> {
        self.values.get(&self.fold(name)).copied()
    }

    /// The `(` or `[` in which the word at this place stands, or would stand if there were one.
    pub fn opener(&self, at: usize) -> Option<usize> {
        let opener = self.openers.get(at).or(self.openers.last()).copied();
        opener.filter(|opener| *opener != NO_OPENER)
    }

    /// The word at a byte, or that ends there.
    pub fn word_at(&self, byte: u32) -> Option<usize> {
        let after = self.words.partition_point(|word| word.span.start <= byte);
        let at = after.checked_sub(1)?;
        let ends = self.words[at].span.end;
        let touches = byte < ends || byte == ends && self.words[at].is_word();
        // At a border between a word and a sign the word is meant.
        match touches {
            true if !self.words[at].is_word() && at > 0 => {
                let before = self.words[at - 1];
                let is_meant = before.span.end == byte && before.is_word();
                Some(if is_meant { at - 1 } else { at })
            }
            true => Some(at),
            false => None,
        }
    }

    /// The word at a place, or an empty one.
    pub fn text_of(&self, at: Option<usize>) -> &'t str {
        let word = at.and_then(|at| self.words.get(at));
        word.map_or("", |word| word.text)
    }

    /// The members and parameters of a unit or a type.
    pub fn parts(&self, of: usize) -> impl Iterator<Item = usize> + '_ {
        let all = self.outline.named.iter().enumerate();
        all.filter(move |(_, named)| named.within == Some(of))
            .map(|(at, _)| at)
    }
}

impl Word<'_> {
    /// Whether it is made of letters and digits.
    fn is_word(self) -> bool {
        self.text
            .starts_with(|c: char| c.is_alphanumeric() || c == '_' || c == '%')
    }
}

/// A name with its members, which a list has as one word, in its parts.
fn parted(word: Word<'_>) -> Vec<Word<'_>> {
    if !word.is_name() || !word.text.contains('.') {
        return vec![word];
    }
    let mut start = word.span.start;
    let mut parts = Vec::new();
    for part in word.text.split_inclusive('.') {
        let name = part.trim_end_matches('.');
        for text in [name, &part[name.len()..]] {
            let end = start + text.len() as u32;
            if !text.is_empty() {
                parts.push(Word {
                    span: Span { start, end },
                    text,
                    colour: None,
                });
            }
            start = end;
        }
    }
    parts
}

/// The names of the programs that a configuration runs: `PROGRAM instance WITH task : name`, by their first bytes.
fn configured(words: &[Word<'_>]) -> impl Iterator<Item = u32> {
    let is_word = |word: &Word<'_>, says: &str| {
        word.colour == Some(Colour::Word) && word.text.eq_ignore_ascii_case(says)
    };
    let from = words
        .iter()
        .position(|word| is_word(word, "CONFIGURATION"))
        .unwrap_or(words.len());
    let inside = words[from..].windows(6);
    let inside = inside.take_while(move |next| !is_word(&next[0], "END_CONFIGURATION"));
    let runs = inside.filter(move |next| is_word(&next[0], "PROGRAM"));
    runs.filter_map(|next| {
        let colon = next.iter().position(|word| word.text == ":")?;
        next.get(colon + 1).map(|word| word.span.start)
    })
}

/// For each word what is open there, and at last for what would follow. What begins a unit closes all.
fn openers(words: &[Word<'_>]) -> Vec<usize> {
    let mut open = Vec::new();
    let mut all = Vec::with_capacity(words.len() + 1);
    for (at, word) in words.iter().enumerate() {
        all.push(open.last().copied().unwrap_or(NO_OPENER));
        match word.text {
            "(" | "[" => open.push(at),
            ")" | "]" => {
                open.pop();
            }
            _ => {}
        }
    }
    all.push(open.last().copied().unwrap_or(NO_OPENER));
    all
}
