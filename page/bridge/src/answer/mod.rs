//! What a page is answered: the types, and what TypeScript calls them, from one definition.
//!
//! - [`answer`], [`spoken`]: make a type of Rust that is written as JSON, and what the page is compiled with
//! - `typed`: what else may stand in one; `types`: how they are written; `elsewhere`: those of other rooms
//! - `contract`: the types of the page, compared
//!
//! Owns the form of answers. Must not know what is in one.

#[cfg(test)]
mod contract;
#[cfg(test)]
mod elsewhere;
#[cfg(test)]
mod typed;
#[cfg(test)]
mod types;

#[cfg(test)]
pub use contract::{answers, compare};
#[cfg(test)]
pub use typed::Typed;
#[cfg(test)]
pub use types::{Row, Types};

/// Makes a struct that is an answer, or stands in one: `struct Rust as "TypeScript" { field: Type }`. Where TypeScript knows more of
/// a field than Rust, that stands after `=>`. Its keys have humps.
macro_rules! answer {
    (
        $(#[doc = $about:literal])* $(#[derive($($derive:ident),*)])?
        $vis:vis struct $name:ident as $typed:literal {
            $($(#[doc = $doc:literal])* $own:vis $field:ident: $type:ty $(=> $known:literal)?),* $(,)?
        }
    ) => {
        $(#[doc = $about])*
        #[derive(Debug, serde::Serialize $($(, $derive)*)?)]
        #[serde(rename_all = "camelCase")]
        $vis struct $name {
            $($(#[doc = $doc])* $own $field: $type),*
        }

        $crate::answer::declared!($name as $typed, concat!($($about),*), {
            $(concat!($($doc),*), $field: $type $(=> $known)?),*
        });
    };
}

/// Makes an enum that is an answer, or stands in one: `enum Rust as "TypeScript", by "key"` is told by that key, `either` by nothing,
/// `word` is a text.
macro_rules! spoken {
    (
        $(#[doc = $about:literal])*
        $vis:vis enum $name:ident as $typed:literal, by $tag:literal {
            $($(#[doc = $doc:literal])* $variant:ident $(($whole:ty))? $({ $($field:ident: $type:ty),* })?),* $(,)?
        }
    ) => {
        $(#[doc = $about])*
        #[derive(Debug, serde::Serialize)]
        #[serde(tag = $tag, rename_all = "camelCase")]
        $vis enum $name {
            $($(#[doc = $doc])* $variant $(($whole))? $({ $($field: $type),* })?),*
        }

        #[cfg(test)]
        impl $crate::answer::Typed for $name {
            fn name() -> String {
                $typed.to_owned()
            }

            fn declare(all: &mut $crate::answer::Types) {
                use $crate::answer::Row;
                use $crate::answer::Typed;
                let variants = vec![$({
                    let whole: Option<String> = None$(.or(Some(<$whole as Typed>::name())))?;
                    let fields: Vec<Row> = vec![$($(
                        Row::new(stringify!($field), "", <$type as Typed>::name())
                    ),*)?];
                    $crate::answer::Types::variant($tag, stringify!($variant), concat!("", $($doc),*), whole, &fields)
                }),*];
                if all.either($typed, concat!($($about),*), &variants) {
                    $($(<$whole as Typed>::declare(all);)? $($(<$type as Typed>::declare(all);)*)?)*
                }
            }
        }
    };
    (
        $(#[doc = $about:literal])*
        $vis:vis enum $name:ident as $typed:literal, either {
            $($variant:ident($type:ty)),* $(,)?
        }
    ) => {
        $(#[doc = $about])*
        #[derive(Debug, serde::Serialize)]
        #[serde(untagged)]
        $vis enum $name {
            $($variant($type)),*
        }

        #[cfg(test)]
        impl $crate::answer::Typed for $name {
            fn name() -> String {
                $typed.to_owned()
            }
        }
    };
    (
        $(#[doc = $about:literal])*
        $vis:vis enum $name:ident as $typed:literal, word {
            $($(#[doc = $doc:literal])* $variant:ident),* $(,)?
        }
    ) => {
        $(#[doc = $about])*
        #[derive(Debug, serde::Serialize)]
        #[serde(rename_all = "lowercase")]
        $vis enum $name {
            $($(#[doc = $doc])* $variant),*
        }

        #[cfg(test)]
        impl $crate::answer::Typed for $name {
            fn name() -> String {
                $typed.to_owned()
            }

            fn declare(all: &mut $crate::answer::Types) {
                let words = [$(format!("{:?}", stringify!($variant).to_lowercase())),*];
                all.either($typed, concat!($($about),*), &words);
            }
        }
    };
}

/// What TypeScript calls a struct.
macro_rules! declared {
    ($name:ty as $typed:literal, $about:expr, {
        $($doc:expr, $field:ident: $type:ty $(=> $known:literal)?),*
    }) => {
        #[cfg(test)]
        impl $crate::answer::Typed for $name {
            fn name() -> String {
                $typed.to_owned()
            }

            fn declare(all: &mut $crate::answer::Types) {
                use $crate::answer::Row;
                use $crate::answer::Typed;
                let rows = [$({
                    let known: Option<&str> = None$(.or(Some($known)))?;
                    let name = known.map_or_else(<$type as Typed>::name, str::to_owned);
                    Row::new(stringify!($field), $doc, name)
                }),*];
                if all.object($typed, $about, &rows) {
                    $(<$type as Typed>::declare(all);)*
                }
            }
        }
    };
}

pub(crate) use {answer, declared, spoken};
