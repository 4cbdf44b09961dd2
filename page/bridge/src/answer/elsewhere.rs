//! Answers that another room has the types of. A field more there does not compile here.

use super::declared;
use unoclp_edit::{At, Entry, Shelf, Shown};
use unoclp_words::Both;

macro_rules! elsewhere {
    ($($name:ident as $typed:literal, $about:literal {
        $($(#[doc = $doc:literal])* $field:ident: $type:ty $(=> $known:literal)?),* $(,)?
    })*) => {
        $(
            declared!($name as $typed, $about, {
                $(concat!("", $($doc),*), $field: $type $(=> $known)?),*
            });

            const _: fn($name) = |own| {
                let $name { $($field),* } = own;
                $(let _: $type = $field;)*
            };
        )*
    };
}

elsewhere! {
    At as "At", "What is at the cursor." {
        what: &'static str => "\"rung\" | \"path\" | \"element\" | \"branch\" | \"run\"",
        /// What a person hears of it.
        say: Both,
        /// Its rung, from 1.
        rung: usize,
        /// What its rung is about.
        comment: String,
        /// What of it can be changed.
        fields: Vec<Shown>,
    }
    Shown as "Field", "A field with what is in it." {
        key: String,
        name: Both,
        value: String,
        /// `point`: an address or a name; `value`: that or a number.
        kind: &'static str => "\"point\" | \"value\" | \"number\" | \"name\"",
    }
    Shelf as "Shelf", "A group of the palette." {
        name: Both,
        items: Vec<Entry>,
    }
    Entry as "Entry", "An element of the palette." {
        /// What `insert` and `put` take.
        id: String,
        name: Both,
        /// The key that inserts it; empty without one.
        key: String,
        /// What is on its button.
        face: String,
    }
}
