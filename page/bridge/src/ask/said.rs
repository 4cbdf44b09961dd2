//! What may stand in an ask and is one of several, told by a word under `do`: its reader, and what TypeScript calls it, from one
//! table.

use super::field::Field;
#[cfg(feature = "full")]
use crate::draw::As;
use crate::given::{Given, wrong};
use crate::words::Both;
use unoclp_draw::edit::{Along, Coil, Direction, Edge, Id, Place, Way};
#[cfg(feature = "full")]
use unoclp_program::drawn::WriteAs;

/// Makes of the rows of a table a reader and what the page is compiled with: `"word" { field: Type } => what that is;`.
macro_rules! said {
    (
        $(#[doc = $about:literal])* $vis:vis mod $module:ident as $typed:literal;
        ($($known:ident: $of:ty),*) -> $made:ty;
        $($(#[doc = $doc:literal])* $word:literal { $($field:ident: $type:ty),* $(,)? } => $make:expr;)*
    ) => {
        $(#[doc = $about])*
        $vis mod $module {
            use super::*;

            /// As a request gives it.
            ///
            /// # Errors
            /// Where there is no such word, or something that it takes is missing or something else.
            pub fn read(given: &mut $crate::given::Given $(, $known: $of)*) -> Result<$made, $crate::words::No> {
                let what = given.text("do")?;
                Ok(match what.as_str() {
                    $($word => {
                        $(let $field = <$type as $crate::ask::Field>::read(given, stringify!($field))?;)*
                        $make
                    })*
                    _ => return Err($crate::given::wrong(&what).into()),
                })
            }

            /// What TypeScript calls it, what it is about, and its rows.
            #[cfg(test)]
            pub fn declared() -> $crate::ask::Said {
                $crate::ask::Said {
                    typed: $typed,
                    about: concat!($($about),*).trim(),
                    rows: vec![$($crate::ask::Row {
                        about: concat!($($doc),*).trim(),
                        ask: $word,
                        fields: vec![$((
                            stringify!($field),
                            <$type as $crate::ask::Field>::TYPE,
                        )),*],
                        answer: String::new(),
                    }),*],
                }
            }
        }
    };
}

pub(crate) use said;

/// One of several that are told by a word.
#[cfg(test)]
pub struct Said {
    pub typed: &'static str,
    pub about: &'static str,
    pub rows: Vec<super::Row>,
}

macro_rules! one_of {
    ($($(#[$only:meta])* $type:ty as $name:literal { $($word:literal => $value:expr),* $(,)? })*) => {
        $($(#[$only])* impl Field for $type {
            const TYPE: &'static str = $name;

            fn read(given: &mut Given, key: &str) -> Result<Self, Both> {
                match given.text(key)?.as_str() {
                    $($word => Ok($value),)*
                    _ => Err(wrong(key)),
                }
            }
        })*

        /// Types of a word each: what TypeScript calls one, and its words.
        #[cfg(test)]
        pub const WORDS: &[(&str, &[&str])] = &[$(($name, &[$($word),*])),*];
    };
}

one_of! {
    Place as "Place" { "before" => Place::Before, "behind" => Place::Behind, "beside" => Place::Beside }
    Along as "Along" { "back" => Along::Back, "forth" => Along::Forth }
    Direction as "Direction" {
        "left" => Direction::Left, "right" => Direction::Right, "up" => Direction::Up, "down" => Direction::Down,
    }
    Coil as "Coil" {
        "normal" => Coil::Normal, "negated" => Coil::Negated, "set" => Coil::Set, "reset" => Coil::Reset, "load" => Coil::Load,
    }
    Edge as "Edge" { "rising" => Edge::Rising, "falling" => Edge::Falling }
    #[cfg(feature = "full")]
    As as "As" {
        "ladder" => As::Ladder, "il" => As::Il, "st" => As::St, "numeric" => As::Numeric, "svg" => As::Svg,
        "picture" => As::Picture, "svg-fbd" => As::SvgFbd, "xml" => As::Xml, "xml-fbd" => As::XmlFbd,
    }
    #[cfg(feature = "full")]
    WriteAs as "DrawnAs" { "numeric" => WriteAs::Numeric, "il" => WriteAs::Il }
}

/// Null where there is none.
pub struct OrNull<T>(pub Option<T>);

impl Field for OrNull<bool> {
    const TYPE: &'static str = "boolean | null";

    fn read(given: &mut Given, key: &str) -> Result<Self, Both> {
        given.truth_if(key).map(OrNull)
    }
}

impl Field for OrNull<Edge> {
    const TYPE: &'static str = "Edge | null";

    fn read(given: &mut Given, key: &str) -> Result<Self, Both> {
        match given.is_there(key) {
            true => Edge::read(given, key).map(|edge| OrNull(Some(edge))),
            false => Ok(OrNull(None)),
        }
    }
}

impl Field for Id {
    const TYPE: &'static str = "number";

    fn read(given: &mut Given, key: &str) -> Result<Self, Both> {
        given.number(key).map(Id)
    }
}

impl Field for Way {
    const TYPE: &'static str = "boolean";

    fn read(given: &mut Given, key: &str) -> Result<Self, Both> {
        Ok(match given.truth(key)? {
            true => Way::Out,
            false => Way::In,
        })
    }
}

#[cfg(feature = "full")]
impl Field for Vec<unoclp_edit::Field> {
    const TYPE: &'static str = "readonly { readonly key: string; readonly value: string }[]";

    fn read(given: &mut Given, key: &str) -> Result<Self, Both> {
        let fields = given.list(key)?.into_iter();
        let field = |value| {
            let mut given = Given::of(value).ok_or_else(|| wrong(key))?;
            Ok(unoclp_edit::Field {
                key: given.text("key")?,
                value: given.text("value")?.trim().to_owned(),
            })
        };
        fields.map(field).collect()
    }
}
