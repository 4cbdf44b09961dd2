//! Texts without their comments.

/// A text without what is between `(*` and `*)`.
pub(crate) fn without(text: &str) -> String {
    let mut said = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find("(*") {
        said.push_str(&rest[..at]);
        rest = rest[at..]
            .find("*)")
            .map_or("", |end| &rest[at + end + 2..]);
    }
    said.push_str(rest);
    said
}
