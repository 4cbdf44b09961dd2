//! What TypeScript calls what stands in an answer.

use super::Types;
use std::collections::BTreeMap;
use unoclp_words::Both;

/// What may stand in an answer.
pub trait Typed {
    /// What TypeScript calls it.
    fn name() -> String;

    /// Adds its declaration, and those of all that it holds.
    fn declare(_: &mut Types) {}
}

macro_rules! named {
    ($($type:ty),* => $name:literal) => {
        $(impl Typed for $type {
            fn name() -> String {
                $name.to_owned()
            }
        })*
    };
}

named!(u8, u16, u32, u64, usize, i32, f32 => "number");
named!(bool => "boolean");
named!(String, &'static str => "string");
named!(() => "null");

/// A name that more may stand behind.
fn one(name: String) -> String {
    match name.contains(' ') {
        true => format!("({name})"),
        false => name,
    }
}

fn tuple(names: &[String]) -> String {
    format!("readonly [{}]", names.join(", "))
}

impl<T: Typed> Typed for Option<T> {
    fn name() -> String {
        format!("{} | null", T::name())
    }

    fn declare(all: &mut Types) {
        T::declare(all);
    }
}

impl<T: Typed> Typed for Box<T> {
    fn name() -> String {
        T::name()
    }

    fn declare(all: &mut Types) {
        T::declare(all);
    }
}

impl<T: Typed> Typed for Vec<T> {
    fn name() -> String {
        format!("readonly {}[]", one(T::name()))
    }

    fn declare(all: &mut Types) {
        T::declare(all);
    }
}

impl<T: Typed, const N: usize> Typed for [T; N] {
    fn name() -> String {
        tuple(&vec![T::name(); N])
    }

    fn declare(all: &mut Types) {
        T::declare(all);
    }
}

impl<T: Typed> Typed for BTreeMap<String, T> {
    fn name() -> String {
        format!("Readonly<Record<string, {}>>", T::name())
    }

    fn declare(all: &mut Types) {
        T::declare(all);
    }
}

impl<A: Typed, B: Typed> Typed for (A, B) {
    fn name() -> String {
        tuple(&[A::name(), B::name()])
    }

    fn declare(all: &mut Types) {
        A::declare(all);
        B::declare(all);
    }
}

impl<A: Typed, B: Typed, C: Typed> Typed for (A, B, C) {
    fn name() -> String {
        tuple(&[A::name(), B::name(), C::name()])
    }

    fn declare(all: &mut Types) {
        A::declare(all);
        B::declare(all);
        C::declare(all);
    }
}

super::declared!(Both as "Both", "A text in both languages.", { "", en: String, "", pt: String });
