//! Names within texts, as far as an editor has to know them.

/// The words of a text, with the places at which they begin; neither comments nor texts in quotes.
fn words(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    let mut at = 0;
    std::iter::from_fn(move || {
        loop {
            let rest = text.get(at..)?;
            let first = rest.chars().next()?;
            let passed = |end: &str, skip: usize| {
                let inner = rest.get(skip..).unwrap_or_default();
                inner
                    .find(end)
                    .map_or(rest.len(), |found| skip + found + end.len())
            };
            match () {
                () if is_word(first) => {
                    let end = rest.find(|c| !is_word(c)).unwrap_or(rest.len());
                    let word = (at, &rest[..end]);
                    at += end;
                    return Some(word);
                }
                () if rest.starts_with("(*") => at += passed("*)", 2),
                () if rest.starts_with("//") => at += passed("\n", 2),
                () if first == '\'' => at += passed("'", 1),
                () => at += first.len_utf8(),
            }
        }
    })
}

/// The first name of this letter that no word of a text is.
pub(super) fn free(letter: &str, text: &str) -> String {
    let taken: std::collections::HashSet<String> =
        words(text).map(|(_, word)| word.to_uppercase()).collect();
    let mut numbers = 1..;
    let names = numbers
        .by_ref()
        .map(|number: u32| format!("{letter}{number}"));
    let mut names = names.filter(|name| !taken.contains(name));
    names.next().unwrap_or_default()
}

/// The places at which a name stands by itself, and not as a member of something else.
fn places<'t>(text: &'t str, name: &'t str) -> impl Iterator<Item = usize> {
    let own = words(text).filter(move |(_, word)| word.eq_ignore_ascii_case(name));
    own.map(|(at, _)| at).filter(move |at| {
        let before = text[..*at].trim_end();
        !before.ends_with(['.', '#'])
    })
}

/// Whether a name stands in a text.
pub(super) fn uses(text: &str, name: &str) -> bool {
    places(text, name).next().is_some()
}

/// A text with another name in the place of one.
pub(super) fn renamed(text: &str, old: &str, new: &str) -> String {
    let mut renamed = String::with_capacity(text.len());
    let mut from = 0;
    for at in places(text, old) {
        renamed.push_str(&text[from..at]);
        renamed.push_str(new);
        from = at + old.len();
    }
    renamed.push_str(&text[from..]);
    renamed
}
