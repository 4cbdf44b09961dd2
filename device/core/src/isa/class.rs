//! The part that an instruction plays in a rung.

/// The part that an instruction plays in a rung. Whoever draws, spells or writes instructions treats all of a
/// class alike, so one more of a class that exists changes nothing there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Class {
    /// It begins a rung.
    Rung,
    /// It names a place to jump to, at the head of a rung.
    Label,
    /// It opens a branch that is closed by OR.
    OpenOr,
    /// It opens a block that is closed by AND.
    OpenAnd,
    /// It opens a block that is closed by XOR.
    OpenXor,
    /// It closes the innermost branch or block.
    Close,
    /// It remembers acc as a branch point.
    StorePoint,
    /// It begins a branch with what a branch point remembers.
    RecallPoint,
    /// acc := acc AND a point, inverted where the code is negative.
    Contact,
    /// acc := acc AND what a point is, which takes words to say.
    Condition,
    /// acc := acc AND a bit of the value, inverted where the code is negative.
    ValueContact,
    /// acc := acc AND the value compared with the operand.
    Comparison,
    /// acc := acc XOR a point, inverted where the code is negative.
    Xor,
    /// acc := something made of acc alone.
    Logic,
    /// It drives a bit, a timer or a counter by acc, and leaves acc as it is.
    Coil,
    /// A timer block with its target.
    Timer,
    /// A counter block.
    Count,
    /// value := what it names.
    Load,
    /// value := acc.
    LoadResult,
    /// value := something made of the value, whatever acc is.
    Operation,
    /// Where acc = 1, something other than a bit is written.
    Store,
    /// Where acc = 1, or 0 if the code is negative, the scan goes on elsewhere.
    Leave,
    /// Where acc = 0, the scan goes on after the part that it begins.
    If,
    /// It ends a part that an [`If`](Class::If) has begun, and may begin another.
    Part,
    /// It sets up the board, and does nothing in a scan.
    Setting,
}

impl Class {
    /// Whether it opens a branch or block.
    pub const fn opens(self) -> bool {
        matches!(self, Class::OpenOr | Class::OpenAnd | Class::OpenXor)
    }
}
