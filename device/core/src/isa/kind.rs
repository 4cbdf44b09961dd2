//! What follows the letters of a code: its number XX, and the lines below it.

/// Declares an enum that tells its variants, and finds one by its discriminant without a table: a chain of
/// comparisons with rising numbers, which a compiler takes for what it is.
macro_rules! numbered {
    ($(#[$about:meta])* pub enum $name:ident { $($(#[$doc:meta])* $variant:ident,)* }) => {
        $(#[$about])*
        pub enum $name {
            $($(#[$doc])* $variant,)*
        }

        impl $name {
            /// Every variant, in the order of the discriminants.
            pub const ALL: &'static [$name] = &[$($name::$variant,)*];

            /// The variant with this discriminant.
            pub(super) const fn of(byte: u8) -> Option<$name> {
                $(if byte == $name::$variant as u8 {
                    return Some($name::$variant);
                })*
                None
            }
        }
    };
}

numbered! {
    /// What stands in the last two digits of a code, and on the lines that follow it. Those without a number come
    /// first, those that name registers last, so that one comparison tells them.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    #[repr(u8)]
    pub enum Kind {
        /// Nothing: the code is complete.
        None,
        /// A timer block. Lines: preset, target.
        Timer,
        /// Lines: four bounds.
        Scale,
        /// Input XX of the board.
        Input,
        /// Output XX of the board.
        Output,
        /// Branch point XX of the rung, 01–08.
        Branch,
        /// Marker XX.
        Marker,
        /// System marker XX, 01–04.
        System,
        /// Timer XX of the program, counted in file order.
        TimerQ,
        /// Counter XX.
        Counter,
        /// Counter XX. Line: preset.
        Count,
        /// Analogue input A XX.
        Analogue,
        /// The output with this number as PWM.
        Pwm,
        /// System reading XX, 01 or 02.
        Reading,
        /// Eight markers: group XX.
        Group,
        /// Bit XX of the value, or so many bits, 00–31.
        Bit,
        /// So many ms, 00–99.
        Time,
        /// Label XX.
        Label,
        /// A jump to label XX.
        Jump,
        /// Strength XX, 01–08. Line: time.
        Filter,
        /// Register XX.
        Register,
        /// Registers from XX on. Lines: `68YY`, the first register to write; how many.
        Move,
        /// Register XX tells the step. Lines: how many steps, then each.
        Drum,
        /// A table of registers from XX on. Line: how many.
        Table,
        /// Register XX; with XX = 99 what was pushed and the value; with XX = 00 a constant. Line then: the
        /// constant.
        Value,
        /// The same of REAL numbers: the line is the 32 bits of one.
        Real,
    }
}

numbered! {
    /// A line that follows a code, by the bytes that store it: 1, 2, 4.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    #[repr(u8)]
    pub enum Line {
        /// What a timer drives: `79XX`, an output, or `77XX`, a marker.
        Target,
        /// `68XX`, a register.
        MoveTo,
        /// How many registers.
        Count,
        /// How many steps, 1–32.
        Steps,
        /// The outputs of a step: a 0 or 1 for each of 01 02 03 04.
        Step,
        /// −32768 to 32767: the lower and upper bound of what comes, and what they become.
        FromLow,
        /// See [`Line::FromLow`].
        FromHigh,
        /// See [`Line::FromLow`].
        ToLow,
        /// See [`Line::FromLow`].
        ToHigh,
        /// A filter's time in ms, 0–30000.
        FilterTime,
        /// Any number.
        Constant,
        /// The bits of a REAL number that is finite.
        Real,
        /// A timer's preset in ms, 0 to 2147483647.
        TimerPreset,
        /// A counter's preset, 0 to 2147483647.
        CounterPreset,
    }
}

impl Line {
    /// How many bytes store it; a constant may take [fewer](super::constant_bytes).
    pub const fn bytes(self) -> u8 {
        match self {
            Line::TimerPreset | Line::CounterPreset | Line::Constant | Line::Real => 4,
            Line::Target | Line::MoveTo | Line::Count | Line::Steps | Line::Step => 1,
            Line::FromLow | Line::FromHigh | Line::ToLow | Line::ToHigh | Line::FilterTime => 2,
        }
    }
}

impl Kind {
    /// Whether the code's last two digits are a number, XX.
    // Apart from `numbers`, of which a compiler makes more code where it has to know only this.
    pub const fn has_number(self) -> bool {
        !matches!(self, Kind::None | Kind::Timer | Kind::Scale)
    }

    /// Whether XX names a register, if it is one's number.
    pub(crate) const fn names_registers(self) -> bool {
        self as u8 >= Kind::Register as u8
    }

    /// Whether XX names where an operation takes its operand from: a register, a constant, what was pushed.
    pub const fn is_value(self) -> bool {
        matches!(self, Kind::Value | Kind::Real)
    }

    /// The first line that follows a code with this XX.
    pub const fn first_line(self, xx: u8) -> Option<Line> {
        self.behind(xx).0
    }

    /// How many bytes store what follows a code with this XX; the steps of a drum not among them.
    pub(crate) const fn line_bytes(self, xx: u8) -> u8 {
        self.behind(xx).1
    }

    /// The first line after a code with this XX, and the bytes that store all lines.
    const fn behind(self, xx: u8) -> (Option<Line>, u8) {
        match self {
            Kind::Timer => (Some(Line::TimerPreset), 5),
            Kind::Count => (Some(Line::CounterPreset), 4),
            Kind::Value if xx == 0 => (Some(Line::Constant), 4),
            Kind::Real if xx == 0 => (Some(Line::Real), 4),
            Kind::Table => (Some(Line::Count), 1),
            Kind::Move => (Some(Line::MoveTo), 2),
            Kind::Drum => (Some(Line::Steps), 1),
            Kind::Scale => (Some(Line::FromLow), 8),
            Kind::Filter => (Some(Line::FilterTime), 2),
            // The line of the file that it stands on: no line of its own says it.
            Kind::Jump => (None, 2),
            Kind::None
            | Kind::Input
            | Kind::Output
            | Kind::Branch
            | Kind::Marker
            | Kind::System => (None, 0),
            Kind::TimerQ | Kind::Counter | Kind::Register | Kind::Analogue | Kind::Pwm => (None, 0),
            Kind::Reading | Kind::Group | Kind::Bit | Kind::Time | Kind::Label => (None, 0),
            Kind::Value | Kind::Real => (None, 0),
        }
    }
}
