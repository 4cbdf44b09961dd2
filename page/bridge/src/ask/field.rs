//! What may stand in an ask.

use crate::draw::Speak;
use crate::facts;
pub use crate::given::Given;
use crate::words::Both;
#[cfg(feature = "full")]
use serde_json::Value;
use unoclp_core::Board;
use unoclp_workspace::Version;

/// What may stand in an ask.
pub trait Field: Sized {
    /// What TypeScript calls it; what may be left out ends in `?`.
    #[cfg_attr(
        not(test),
        expect(dead_code, reason = "the contract is written by a test")
    )]
    const TYPE: &'static str;

    /// As a request has it.
    ///
    /// # Errors
    /// Where it is missing, or something else.
    fn read(given: &mut Given, key: &str) -> Result<Self, Both>;
}

macro_rules! fields {
    ($($type:ty, $name:literal, $read:expr;)*) => {
        $(impl Field for $type {
            const TYPE: &'static str = $name;

            fn read(given: &mut Given, key: &str) -> Result<Self, Both> {
                let read: fn(&mut Given, &str) -> Result<Self, Both> = $read;
                read(given, key)
            }
        })*
    };
}

/// A number of columns; what is too large to be one is the largest.
pub struct Columns(pub usize);

/// What was done to a drawing.
#[cfg(feature = "full")]
pub struct Log(pub Vec<Value>);

/// Blocks of a card that are not empty.
#[cfg(feature = "full")]
pub struct Blocks(pub Vec<(u32, String)>);

fields! {
    String, "string", Given::text;
    Option<String>, "string?", Given::text_if;
    bool, "boolean", Given::truth;
    Option<bool>, "boolean?", Given::truth_if;
    u8, "number", Given::number;
    u16, "number", Given::number;
    u32, "number", Given::number;
    i32, "number", Given::number;
    usize, "number", Given::number;
    f64, "number", Given::real;
    Option<u8>, "number?", Given::number_if;
    Option<u16>, "number?", Given::number_if;
    Option<u32>, "number?", Given::number_if;
    Vec<u8>, "readonly number[]", Given::bytes;
    Columns, "number", |given, key| given.columns(key).map(Columns);
    Version, "number", |given, key| given.number(key).map(Version);
    Option<Version>, "number | null", |given, key| Ok(given.number_if(key)?.map(Version));
    Board, "string?", |given, _| facts::board(given);
    Speak, "Speak?", |given, _| Speak::of(given);
    Given, "Order", Given::below;
}

#[cfg(feature = "full")]
fields! {
    Option<Given>, "Act | null", Given::below_if;
    Log, "readonly Act[]", |given, key| given.list(key).map(Log);
    Blocks, "CardImage[\"blocks\"]", |given, _| crate::card::blocks(given).map(Blocks);
    Text, "Text", |given, key| given.below(key).map(Text);
}

/// A text with its name.
#[cfg(feature = "full")]
pub struct Text(pub Given);
