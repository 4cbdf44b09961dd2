//! Why an operation is refused.

/// Declares the enum and the list of all its variants.
macro_rules! refusals {
    ($($(#[$doc:meta])* $name:ident = $number:literal,)*) => {
        /// Why an operation is refused. Its discriminant is a number that keeps its meaning.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[repr(u8)]
        pub enum Refusal {
            $($(#[$doc])* $name = $number,)*
        }

        impl Refusal {
            /// Every refusal, in the order of the numbers.
            pub const ALL: &'static [Refusal] = &[$(Refusal::$name,)*];
        }
    };
}

refusals! {
    /// What the cursor or the operation names is not in the document.
    NotThere = 1,
    /// What is selected does not stand in one series.
    NotOneSeries = 2,
    /// It works on elements, and none is selected.
    SelectElements = 3,
    /// It works on one element, and none or several are selected.
    SelectOne = 4,
    /// The element has no opposite: it is no contact, no coil, no comparison.
    NoOpposite = 5,
    /// There is no such coil of this point.
    NoSuchCoil = 6,
    /// This element cannot have that address.
    NotThatAddress = 7,
    /// It makes sense of contacts only.
    ContactsOnly = 8,
    /// An IF is the last of its rung, and stands in no branch.
    IfEndsRung = 9,
    /// That is no element but a wire: branches, points and rungs have operations of their own.
    NotAnElement = 10,
    /// Branches would stand too deep in each other to be drawn.
    TooDeep = 11,
    /// Nothing has been copied.
    NothingCopied = 12,
    /// What is moved cannot go into itself.
    IntoItself = 13,
    /// The branch cannot begin or end there.
    NoFurther = 14,
    /// There is no rung below to join, or it begins with a label, ELS or END.
    CannotJoin = 15,
    /// A number is out of its range.
    OutOfRange = 16,
    /// Nothing is left to undo.
    NothingToUndo = 17,
    /// Nothing is left to do again.
    NothingToRedo = 18,
    /// Another point has that name.
    NameTaken = 19,
    /// It works on a block, and none is selected.
    SelectBlock = 20,
}

impl Refusal {
    /// Its number, from 1.
    pub fn number(self) -> u8 {
        self as u8
    }
}
