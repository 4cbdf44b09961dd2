//! The payload of Sparkplug B (*Sparkplug 3.0.0*, chapter 6), as far as an edge node needs it.

use crate::boards::{Shape, shape};
use prost::{Message, Oneof};
use unoclp_site::Point;

/// What a message holds.
#[derive(Clone, PartialEq, Message)]
pub(crate) struct Payload {
    /// ms since 1970.
    #[prost(uint64, optional, tag = "1")]
    pub timestamp: Option<u64>,
    #[prost(message, repeated, tag = "2")]
    pub metrics: Vec<Metric>,
    /// 0 to 255, one more with each message of the node.
    #[prost(uint64, optional, tag = "3")]
    pub seq: Option<u64>,
}

/// What a point is.
#[derive(Clone, PartialEq, Message)]
pub(crate) struct Metric {
    #[prost(string, optional, tag = "1")]
    pub name: Option<String>,
    #[prost(uint64, optional, tag = "3")]
    pub timestamp: Option<u64>,
    #[prost(uint32, optional, tag = "4")]
    pub datatype: Option<u32>,
    /// It was so before what is known now.
    #[prost(bool, optional, tag = "5")]
    pub is_historical: Option<bool>,
    #[prost(bool, optional, tag = "7")]
    pub is_null: Option<bool>,
    #[prost(oneof = "Held", tags = "10, 11, 12, 13, 14, 15")]
    pub value: Option<Held>,
}

/// A value.
#[derive(Clone, PartialEq, Oneof)]
pub(crate) enum Held {
    #[prost(uint32, tag = "10")]
    Int(u32),
    #[prost(uint64, tag = "11")]
    Long(u64),
    #[prost(float, tag = "12")]
    Float(f32),
    #[prost(double, tag = "13")]
    Double(f64),
    #[prost(bool, tag = "14")]
    Boolean(bool),
    #[prost(string, tag = "15")]
    Text(String),
}

/// Data types of Sparkplug B.
pub(crate) mod datatype {
    pub const INT32: u32 = 3;
    pub const INT64: u32 = 4;
    pub const UINT32: u32 = 7;
    pub const FLOAT: u32 = 9;
    pub const BOOLEAN: u32 = 11;
    pub const STRING: u32 = 12;
}

impl Metric {
    /// A point with its value, if that is known.
    pub fn of(point: &Point, value: Option<f64>, at: i64) -> Metric {
        let shape = shape(point);
        let held = |value: f64| match shape {
            Shape::Bit => Held::Boolean(value != 0.0),
            // The 32 bits of a number with a sign stand in one without.
            Shape::Signed => Held::Int((value as i32).cast_unsigned()),
            Shape::Unsigned => Held::Int(value as u32),
            Shape::Real => Held::Float(value as f32),
        };
        let datatype = match shape {
            Shape::Bit => datatype::BOOLEAN,
            Shape::Signed => datatype::INT32,
            Shape::Unsigned => datatype::UINT32,
            Shape::Real => datatype::FLOAT,
        };
        Metric {
            name: Some(point.name.clone()),
            timestamp: Some(time(at)),
            datatype: Some(datatype),
            is_historical: None,
            is_null: value.is_none().then_some(true),
            value: value.map(held),
        }
    }

    /// What a metric of a command asks for a point; none of what is no number.
    pub fn number(&self, point: &Point) -> Option<f64> {
        Some(match *self.value.as_ref()? {
            Held::Text(_) => return None,
            Held::Boolean(on) => f64::from(on),
            Held::Float(value) => value.into(),
            Held::Double(value) => value,
            // A sign stands in the two's complement, of 32 bits or of 64.
            Held::Int(bits) => match shape(point) {
                Shape::Signed | Shape::Real => bits.cast_signed().into(),
                _ => bits.into(),
            },
            Held::Long(bits) => bits.cast_signed() as f64,
        })
    }
}

/// A moment as Sparkplug has it.
pub(crate) fn time(at: i64) -> u64 {
    u64::try_from(at).unwrap_or(0)
}
