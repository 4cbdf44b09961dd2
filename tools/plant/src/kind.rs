//! The form of the table of kinds: what a part is given, what it has, how it may fail, what it does in a millisecond.
//!
//! The reader, the checks, the rules' names, the pages and the pictures are all made from its rows.

use crate::unit::Unit;

/// The groups of kinds, in the order of the pages.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Group {
    /// What a person presses and sees.
    Panel,
    /// Contactors and what they switch.
    Electric,
    /// What flows.
    Fluid,
    /// What warms and cools.
    Heat,
    /// What moves to and fro.
    Motion,
    /// What carries things.
    Transport,
    /// What drives and walks.
    Traffic,
}

/// A kind of part.
pub struct Kind {
    /// How a file names it.
    pub name: &'static str,
    /// Its group.
    pub group: Group,
    /// What it is, in English and Portuguese.
    pub about: [&'static str; 2],
    /// The size of its symbol.
    pub size: [i32; 2],
    /// What a part of it is given.
    pub fields: &'static [Field],
    /// What a part of it has.
    pub values: &'static [Slot],
    /// How it may fail.
    pub faults: &'static [Fault],
}

/// What a part is given.
pub struct Field {
    /// The key.
    pub name: &'static str,
    /// What it takes.
    pub form: Form,
    /// What it is, in English and Portuguese.
    pub about: [&'static str; 2],
}

/// What a field takes.
#[derive(Clone, Copy)]
pub enum Form {
    /// A quantity from the first to the second number; the third where it is not given.
    Number(Unit, i32, i32, i32),
    /// What drives it, on or off: an output, or a value of another part.
    Drive,
    /// The same, and it may be left out: then it is off.
    MayDrive,
    /// What drives it, from nothing to all: an output, its PWM, or a value of another part.
    Duty,
    /// The input that it switches, if any.
    Sense,
    /// The analogue input that it sets, if any.
    Reading,
    /// Another part, of one of these kinds.
    Part(&'static [&'static str]),
    /// The same, and it may be left out.
    MayPart(&'static [&'static str]),
    /// A value of another part.
    Value,
    /// One of these words; the first where it is not given.
    Choice(&'static [&'static str]),
}

/// An end of a range, or what a value begins with.
#[derive(Clone, Copy, Debug)]
pub enum Limit {
    /// This.
    Is(i32),
    /// What this field says.
    Of(&'static str),
    /// What this field says, times a thousand.
    Thousand(&'static str),
}

/// What a part has: a number that never leaves its range.
pub struct Slot {
    /// Its name after the part's: `tank.level`.
    pub name: &'static str,
    /// Whether it is true or false, and not a number.
    pub is_flag: bool,
    /// What it counts.
    pub unit: Unit,
    /// The least.
    pub low: Limit,
    /// The most.
    pub high: Limit,
    /// What it begins with.
    pub first: Limit,
    /// How many there are in a row.
    pub count: usize,
    /// Whether rules may read it.
    pub is_seen: bool,
    /// Whether a person there can change it.
    pub by_hand: bool,
    /// Whether it tells of damage, which stays until the machine is reset.
    pub is_damage: bool,
    /// What it is, in English and Portuguese.
    pub about: [&'static str; 2],
}

/// A slot of a flag.
pub(crate) const FLAG: Slot = Slot {
    name: "",
    is_flag: true,
    unit: Unit::Count,
    low: Limit::Is(0),
    high: Limit::Is(1),
    first: Limit::Is(0),
    count: 1,
    is_seen: true,
    by_hand: false,
    is_damage: false,
    about: [""; 2],
};

/// A flag that a person changes.
pub(crate) const HAND: Slot = Slot {
    by_hand: true,
    ..FLAG
};

/// A flag of damage.
pub(crate) const DAMAGE: Slot = Slot {
    is_damage: true,
    ..FLAG
};

/// A number of this range, which begins with the least.
pub(crate) const fn number(unit: Unit, low: i32, high: i32) -> Slot {
    Slot {
        is_flag: false,
        unit,
        low: Limit::Is(low),
        high: Limit::Is(high),
        first: Limit::Is(if low > 0 { low } else { 0 }),
        ..FLAG
    }
}

/// Things.
pub(crate) const COUNT: Slot = number(Unit::Count, 0, 1_000_000);

/// A part of the whole.
pub(crate) const SHARE: Slot = number(Unit::Permille, 0, 1000);

/// A number that no rule reads.
pub(crate) const fn inner(low: i32, high: i32) -> Slot {
    Slot {
        is_seen: false,
        ..number(Unit::Count, low, high)
    }
}

/// How a part may fail.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Fault {
    /// It stays as it is.
    Stuck,
    /// A wire is broken.
    Open,
    /// Two wires touch.
    Short,
    /// Its contacts stick together.
    Welded,
    /// It is held fast.
    Jammed,
    /// It takes four times as long.
    Slow,
    /// Some passes that should not.
    Leaking,
    /// Its contact chatters.
    Bouncing,
}

impl Fault {
    /// Every fault.
    pub const ALL: [Fault; 8] = [
        Fault::Stuck,
        Fault::Open,
        Fault::Short,
        Fault::Welded,
        Fault::Jammed,
        Fault::Slow,
        Fault::Leaking,
        Fault::Bouncing,
    ];

    /// How a file names it.
    pub const fn name(self) -> &'static str {
        match self {
            Fault::Stuck => "stuck",
            Fault::Open => "open",
            Fault::Short => "short",
            Fault::Welded => "welded",
            Fault::Jammed => "jammed",
            Fault::Slow => "slow",
            Fault::Leaking => "leaking",
            Fault::Bouncing => "bouncing",
        }
    }

    /// The fault that a file names so.
    pub fn named(name: &str) -> Option<Fault> {
        Fault::ALL.into_iter().find(|fault| fault.name() == name)
    }

    /// Its bit among a part's faults.
    pub(crate) const fn bit(self) -> i32 {
        1 << self as i32
    }
}

impl Kind {
    /// The place of a value of this name among its values.
    pub fn value(&self, name: &str) -> Option<usize> {
        self.values.iter().position(|slot| slot.name == name)
    }

    /// The place of a field of this name among its fields.
    pub fn field(&self, name: &str) -> Option<usize> {
        self.fields.iter().position(|field| field.name == name)
    }
}

impl std::fmt::Debug for Kind {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name)
    }
}

/// A row of the table: `F` numbers its fields, `V` its values.
macro_rules! kind {
    (
        $name:literal $group:ident $english:literal $portuguese:literal $size:expr;
        fields { $($field:ident: $form:expr, $field_en:literal $field_pt:literal;)* }
        values { $($value:ident: $slot:expr, $value_en:literal $value_pt:literal;)* }
        faults { $($fault:ident)* }
    ) => {
        /// The places of its fields.
        #[allow(non_camel_case_types, dead_code, clippy::allow_attributes)]
        pub(crate) enum F { $($field,)* }
        /// The places of its values.
        #[allow(non_camel_case_types, dead_code, clippy::allow_attributes)]
        pub(crate) enum V { $($value,)* }
        impl From<F> for usize {
            fn from(field: F) -> usize { field as usize }
        }
        impl From<V> for usize {
            fn from(value: V) -> usize { value as usize }
        }
        /// Its row.
        pub(crate) const KIND: $crate::kind::Kind = $crate::kind::Kind {
            name: $name,
            group: $crate::kind::Group::$group,
            about: [$english, $portuguese],
            size: $size,
            fields: &[$($crate::kind::Field {
                name: stringify!($field),
                form: $form,
                about: [$field_en, $field_pt],
            },)*],
            values: &[$($crate::kind::Slot {
                name: stringify!($value),
                about: [$value_en, $value_pt],
                ..$slot
            },)*],
            faults: &[$($crate::kind::Fault::$fault,)*],
        };
    };
}
pub(crate) use kind;
