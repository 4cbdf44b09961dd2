//! What may stand in an ask.

use crate::draw::Speak;
use crate::facts;
pub use crate::given::Given;
#[cfg(feature = "full")]
use crate::given::wrong;
#[cfg(feature = "full")]
use crate::slow::Left;
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
    Trail, "readonly (readonly [from: number, to: number, acc: boolean, value: number | null, inputs: number | null, outputs: number | null])[]", trail;
    Steps, "readonly number[] | null", |given, key| match given.is_there(key) {
        true => given.list(key)?.iter().map(|step| index(step).ok_or_else(|| wrong(key))).collect::<Result<_, _>>().map(|steps| Steps(Some(steps))),
        false => Ok(Steps(None)),
    };
    Option<Given>, "Act | null", Given::below_if;
    Log, "readonly Act[]", |given, key| given.list(key).map(Log);
    Blocks, "CardImage[\"blocks\"]", |given, _| crate::card::blocks(given).map(Blocks);
    Text, "Text", |given, key| given.below(key).map(Text);
}

/// What a scan has left, as far as it has come.
#[cfg(feature = "full")]
pub struct Trail(pub Vec<Left>);

/// Instructions, from 0; none: any.
#[cfg(feature = "full")]
pub struct Steps(pub Option<Vec<usize>>);

#[cfg(feature = "full")]
fn trail(given: &mut Given, key: &str) -> Result<Trail, Both> {
    let left = |value: &Value| match value.as_array()?.as_slice() {
        [from, to, acc, value, inputs, outputs] => Some(Left {
            from: index(from)?,
            to: index(to)?,
            acc: acc.as_bool()?,
            value: value.as_i64().and_then(|value| i32::try_from(value).ok()),
            inputs: points(inputs),
            outputs: points(outputs),
        }),
        _ => None,
    };
    fn points(value: &Value) -> Option<u32> {
        value.as_i64().map(|points| points as u32)
    }
    let list = given.list(key)?;
    let trail: Option<Vec<Left>> = list.iter().map(left).collect();
    trail.map(Trail).ok_or_else(|| wrong(key))
}

#[cfg(feature = "full")]
fn index(value: &Value) -> Option<usize> {
    usize::try_from(value.as_u64()?).ok()
}

/// A text with its name.
#[cfg(feature = "full")]
pub struct Text(pub Given);
