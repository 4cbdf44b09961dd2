//! What a page may ask, and what it is answered: one table, of which the enums, their readers, the types of the page and the
//! random asks of the tests are made.
//!
//! - `table`: the asks
//! - `field`: what may stand in one, how it is read, and what TypeScript calls it
//! - `said`: what is one of several in one: acts, orders
//! - `contract`: the table in TypeScript; `sample`: asks made at random
//!
//! Owns the form of requests. Must not know what is done for one.

#[cfg(test)]
mod contract;
mod field;
mod said;
#[cfg(test)]
mod sample;
mod table;

pub use field::{Columns, Field, Given as Below};
pub use said::OrNull;
pub(crate) use said::said;
#[cfg(test)]
pub use said::{Said, WORDS};
pub use table::{Answer, First, MORE};
#[cfg(feature = "full")]
pub use table::{More, MoreAnswer};

/// Makes of the rows of a table an enum, its reader and its names, and an enum of what is answered; of each row
/// `Variant "ask" { field: Type } -> Answer;`, where a key that is no name of Rust stands after `as`.
macro_rules! asks {
    ($(#[$about:meta])* $enum:ident -> $told:ident; $(
        $(#[doc = $doc:literal])* $variant:ident $ask:literal { $($field:ident $(as $key:literal)?: $type:ty),* } -> $answer:ty;
    )*) => {
        $(#[$about])*
        pub enum $enum {
            $($(#[doc = $doc])* $variant { $($field: $type),* },)*
        }

        impl $enum {
            /// As a request gives it; none where there is no such ask.
            ///
            /// # Errors
            /// Where something in it is missing, or something else.
            pub fn read(
                ask: &str,
                given: &mut $crate::given::Given,
            ) -> Result<Option<$enum>, $crate::words::Both> {
                Ok(Some(match ask {
                    $($ask => $enum::$variant {
                        $($field: $crate::ask::field::Field::read(
                            given,
                            $crate::ask::key!($field $($key)?),
                        )?,)*
                    },)*
                    _ => return Ok(None),
                }))
            }

            /// Adds what is answered.
            #[cfg(test)]
            pub fn answers(all: &mut $crate::answer::Types) {
                $(<$answer as $crate::answer::Typed>::declare(all);)*
            }

            /// The rows of its table.
            #[cfg(test)]
            pub fn rows() -> Vec<$crate::ask::Row> {
                vec![$($crate::ask::Row {
                    about: concat!($($doc),*).trim(),
                    ask: $ask,
                    fields: vec![$((
                        $crate::ask::key!($field $($key)?),
                        <$type as $crate::ask::field::Field>::TYPE,
                    )),*],
                    answer: <$answer as $crate::answer::Typed>::name(),
                }),*]
            }
        }

        /// What is answered.
        #[derive(serde::Serialize)]
        #[serde(untagged)]
        pub enum $told {
            $($variant($answer),)*
        }
    };
}

macro_rules! key {
    ($field:ident) => {
        stringify!($field)
    };
    ($field:ident $key:literal) => {
        $key
    };
}

use {asks, key};

/// A row of the table.
#[cfg(test)]
pub struct Row {
    pub about: &'static str,
    pub ask: &'static str,
    /// Keys, and what TypeScript calls what stands there; what may be left out ends in `?`.
    pub fields: Vec<(&'static str, &'static str)>,
    pub answer: String,
}
