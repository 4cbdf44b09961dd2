//! What can be wrong with a plant's file, as values and in words.

use crate::words;
use unoclp_keyed::{Amiss, Reason};
use unoclp_lang::Diagnostic;
use unoclp_words::Lang;

/// A mistake in a plant's file, and where it stands.
pub type Mistake = unoclp_keyed::Mistake<Wrong>;

macro_rules! wrongs {
    ($($(#[$about:meta])* $name:ident $({ $($(#[$of:meta])* $value:ident: $type:ty),* })? => $word:ident;)*) => {
        /// What is wrong.
        #[derive(Clone, Debug, PartialEq, Eq)]
        pub enum Wrong {
            $($(#[$about])* $name $({ $($(#[$of])* $value: $type),* })?,)*
            /// What is wrong with any file.
            Keys(Amiss),
            /// A rule is no condition.
            NoCondition {
                /// What the language says of it.
                told: Option<Box<Diagnostic>>,
            },
        }

        impl Reason for Wrong {
            fn text(&self, lang: Lang) -> String {
                match self {
                    $(Wrong::$name $({ $($value),* })? => words::$word(lang $($(, $value)*)?),)*
                    Wrong::Keys(amiss) => amiss.text(lang),
                    Wrong::NoCondition { told: None } => words::no_condition(lang, "", ""),
                    Wrong::NoCondition { told: Some(told) } => {
                        let help = told.help(lang);
                        let help = if help.is_empty() { help } else { format!("; {help}") };
                        words::no_condition(lang, told.message(lang), help)
                    }
                }
            }
        }
    };
}

wrongs! {
    /// A number is out of its range.
    Range {
        /// The key.
        key: String,
        /// The least.
        from: String,
        /// The most.
        to: String
    } => range;
    /// No whole number.
    NoNumber {
        /// The key.
        key: String,
        /// What was given.
        given: String
    } => no_number;
    /// No number with its unit.
    NoUnit {
        /// The key.
        key: String,
        /// What was given.
        given: String,
        /// The units.
        known: String,
        /// One that is right.
        example: String
    } => no_unit;
    /// A name that cannot be one.
    Name {
        /// What was given.
        given: String
    } => name;
    /// Two parts are called the same.
    TwoNames {
        /// The name.
        name: String
    } => two_names;
    /// There are no parts.
    NoPart => no_part;
    /// There are too many parts.
    TooMany {
        /// What.
        key: &'static str,
        /// The most.
        most: usize
    } => too_many;
    /// There is no part of this name.
    NoSuchPart {
        /// The name.
        name: String,
        /// Those that there are.
        known: String
    } => no_such_part;
    /// A part is of another kind.
    OtherKind {
        /// Its name.
        name: String,
        /// Its kind.
        kind: &'static str,
        /// The kinds that would be right.
        known: String
    } => other_kind;
    /// A part has no such value.
    NoSuchValue {
        /// The part.
        name: String,
        /// The value.
        value: String,
        /// Those that it has.
        known: String
    } => no_such_value;
    /// Nothing that can drive a part.
    NoSignal {
        /// What was given.
        given: String
    } => no_signal;
    /// No input.
    NoInput {
        /// What was given.
        given: String
    } => no_input;
    /// No analogue input.
    NoAnalogue {
        /// What was given.
        given: String
    } => no_analogue;
    /// The board has no such point.
    NoPoint {
        /// The point.
        point: String,
        /// The board.
        board: &'static str,
        /// What it has.
        known: String
    } => no_point;
    /// An input is named twice.
    TwoUses {
        /// The point.
        point: String,
        /// The other part.
        other: String
    } => two_uses;
    /// Two points share a pin.
    SharedPin {
        /// The point.
        point: String,
        /// The other point.
        other: String
    } => shared_pin;
    /// An output is used with and without PWM.
    BothWays {
        /// The output.
        point: String
    } => both_ways;
    /// Parts need each other in a circle.
    Cycle {
        /// Which.
        way: String
    } => cycle;
    /// Nobody can change a value by hand.
    NotByHand {
        /// The value.
        path: String,
        /// Those that can be.
        known: String
    } => not_by_hand;
    /// A part cannot fail so.
    NoFault {
        /// The kind.
        kind: &'static str,
        /// The fault.
        given: String,
        /// Those that it can have.
        known: String
    } => no_fault;
    /// A fault comes neither at a time nor on a condition.
    NeverComes => never_comes;
    /// Something is to happen after the end.
    TooLate {
        /// The key.
        key: &'static str,
        /// The end.
        until: String
    } => too_late;
}

impl From<Amiss> for Wrong {
    fn from(amiss: Amiss) -> Wrong {
        Wrong::Keys(amiss)
    }
}
