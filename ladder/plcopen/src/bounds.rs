//! What a file may hold, counted before it is read: what is read takes no longer than its size says.
//!
//! The reader looks at each attribute once for each other one of the same element, and at each prefix once for each element
//! that declares one; whoever walks a tree goes as deep as that is.

use std::collections::HashSet;
use unoclp_lang::{Span, Word};

/// The largest file that is read, in bytes; those of other languages are bounded likewise.
pub(crate) const LARGEST: usize = 1 << 20;

/// The most attributes of an element.
const ATTRIBUTES: usize = 200;

/// The most prefixes of namespaces in a file.
const PREFIXES: usize = 30;

/// The most elements within each other.
const DEPTH: usize = 200;

/// The most bytes of an attribute.
const LONGEST: usize = 1 << 12;

/// What a text has too much of, and where; none where it may be read.
pub(crate) fn beyond(text: &str) -> Option<(Span, Word)> {
    if text.len() > LARGEST {
        let size = format!("{} > {LARGEST} bytes", text.len());
        return Some((Span::default(), size.into()));
    }
    let mut prefixes = HashSet::new();
    let mut depth = 0_usize;
    let mut at = 0;
    while let Some(start) = text.get(at..)?.find('<').map(|found| at + found) {
        let rest = &text[start..];
        let end = |mark: &str| rest.find(mark).map_or(text.len(), |end| start + end);
        at = match () {
            () if rest.starts_with("<!--") => end("-->"),
            () if rest.starts_with("<![CDATA[") => end("]]>"),
            () if rest.starts_with("<?") => end("?>"),
            () => {
                let tag = Tag::read(rest);
                prefixes.extend(tag.prefixes);
                match () {
                    () if rest.starts_with("</") => depth = depth.saturating_sub(1),
                    () if !tag.is_empty => depth += 1,
                    () => {}
                }
                let over = [
                    (tag.attributes > ATTRIBUTES, attributes()),
                    (tag.longest > LONGEST, longest()),
                    (prefixes.len() > PREFIXES, namespaces()),
                    (depth > DEPTH, nesting()),
                ];
                if let Some((_, what)) = over.into_iter().find(|(is_over, _)| *is_over) {
                    let (start, end) = (start as u32, start as u32);
                    return Some((Span { start, end }, what));
                }
                start + tag.bytes
            }
        };
    }
    None
}

/// A tag as far as it is counted.
#[derive(Default)]
struct Tag<'t> {
    bytes: usize,
    attributes: usize,
    /// The bytes of its longest attribute.
    longest: usize,
    prefixes: Vec<&'t str>,
    /// Whether it is an element without content.
    is_empty: bool,
}

impl<'t> Tag<'t> {
    /// The tag at the beginning of this text.
    fn read(text: &'t str) -> Tag<'t> {
        let mut tag = Tag::default();
        let (mut quote, mut name) = (None, 0);
        let mut last = b' ';
        for (at, byte) in text.bytes().enumerate() {
            tag.bytes = at + 1;
            match (quote, byte) {
                (Some((mark, from)), _) if byte == mark => {
                    tag.longest = tag.longest.max(at - from);
                    quote = None;
                }
                (Some(_), _) => {}
                (None, b'"' | b'\'') => quote = Some((byte, at)),
                (None, b'>') => {
                    tag.is_empty = last == b'/';
                    return tag;
                }
                (None, b'=') => {
                    tag.attributes += 1;
                    let written = text.get(name..at).unwrap_or_default().trim();
                    // One more than there may be is enough.
                    if let Some(prefix) = written.strip_prefix("xmlns:")
                        && tag.prefixes.len() <= PREFIXES
                    {
                        tag.prefixes.push(prefix);
                    }
                }
                _ => {}
            }
            // A name begins after a space or a value, and may have spaces before its sign.
            let is_between = last.is_ascii_whitespace() || matches!(last, b'"' | b'\'');
            if quote.is_none() && is_between && byte != b'=' && !byte.is_ascii_whitespace() {
                name = at;
            }
            last = byte;
        }
        tag
    }
}

fn attributes() -> Word {
    let en = format!("more than {ATTRIBUTES} attributes in one element");
    (en, format!("mais de {ATTRIBUTES} atributos em um elemento")).into()
}

fn longest() -> Word {
    let en = format!("an attribute of more than {LONGEST} bytes");
    (en, format!("um atributo com mais de {LONGEST} bytes")).into()
}

fn namespaces() -> Word {
    let en = format!("more than {PREFIXES} namespaces");
    (en, format!("mais de {PREFIXES} espaços de nomes")).into()
}

fn nesting() -> Word {
    let en = format!("more than {DEPTH} nested elements");
    (en, format!("mais de {DEPTH} elementos aninhados")).into()
}
