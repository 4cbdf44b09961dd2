//! What stands at the input pins: buttons, the switch RUN/STOP, voltages, and the supply they are measured against
//! (docs/numeric-code.md, "Pins of the UNO").

/// Digital inputs there are: points 01 to 08, pins D2 to D5 and A0 to A3.
pub const INPUTS: usize = 8;
/// Analogue inputs there are: points 01 to 05, pins A0 to A4.
pub const ANALOGUE_INPUTS: usize = 5;
/// The most that any board has.
pub(crate) const MOST_ANALOGUE: usize = 8;

/// First pin of port D with a button: input 0 is D2.
pub(crate) const FIRST_D: u8 = 2;
/// Inputs on port D; those after them are on port C, from A0 on.
pub(crate) const INPUTS_D: usize = 4;
/// Pin of port C with the switch RUN/STOP: A5.
const STOP: u8 = 5;
/// Supply of the UNO on USB, mV.
const SUPPLY_MV: u16 = 5000;
/// Steps of the converter from 0 to its reference.
const STEPS: u32 = 1024;

/// What an analogue input is connected to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Analogue {
    /// Nothing: the pull-up decides, and without it the pin is at ground.
    #[default]
    Open,
    /// A voltage, mV.
    Millivolts(u16),
    /// A potentiometer at the supply, turned to where the converter reads this, 0 to 1023, at any supply.
    Reading(u16),
}

/// Pins of a port that are driven from outside, and to what.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Driven {
    pub mask: u8,
    pub levels: u8,
}

/// All of them.
pub(crate) struct Inputs {
    /// Bit n: the button of input n is closed.
    pub closed: u32,
    /// The switch RUN/STOP is closed.
    pub stop: bool,
    pub analogue: [Analogue; MOST_ANALOGUE],
    /// The pins of analogue inputs have buttons and the switch too.
    pub shared: bool,
    /// VCC and AVCC.
    pub supply_mv: u16,
}

impl Inputs {
    /// All open, on USB.
    pub fn new() -> Inputs {
        Inputs {
            closed: 0,
            stop: false,
            analogue: [Analogue::Open; MOST_ANALOGUE],
            shared: true,
            supply_mv: SUPPLY_MV,
        }
    }

    /// Port D.
    pub fn port_d(&self) -> Driven {
        Driven {
            mask: (self.closed as u8) << (8 - INPUTS_D) >> (8 - INPUTS_D) << FIRST_D,
            levels: 0,
        }
    }

    /// Port C. A voltage reads as high from half the supply on; the chip promises low up to 0.3, and high from 0.6.
    pub fn port_c(&self) -> Driven {
        let mut driven = Driven {
            mask: self.to_ground(),
            levels: 0,
        };
        for (pin, _) in self.analogue.iter().enumerate().take(ANALOGUE_INPUTS) {
            if let Some(microvolts) = self.voltage(pin as u8) {
                driven.mask |= 1 << pin;
                let high = 2 * microvolts >= self.supply();
                driven.levels |= u8::from(high) << pin;
            }
        }
        driven
    }

    /// The voltage at a pin of port C, µV.
    pub fn microvolts(&self, pin: u8, pulled_up: bool) -> u32 {
        let open = if pulled_up { self.supply() } else { 0 };
        self.voltage(pin).unwrap_or(open)
    }

    /// The supply, µV.
    pub fn supply(&self) -> u32 {
        u32::from(self.supply_mv) * 1000
    }

    /// Pins of port C whose button or switch is closed.
    fn to_ground(&self) -> u8 {
        self.closed as u8 >> INPUTS_D | u8::from(self.stop) << STOP
    }

    /// What the outside puts on a pin of port C, µV.
    fn voltage(&self, pin: u8) -> Option<u32> {
        if self.shared && self.to_ground() >> pin & 1 == 1 {
            return Some(0);
        }
        match *self.analogue.get(usize::from(pin))? {
            Analogue::Open => None,
            Analogue::Millivolts(mv) => Some(u32::from(mv) * 1000),
            // In the middle of the step.
            Analogue::Reading(steps) => {
                let halves = 2 * u64::from(steps) + 1;
                let microvolts = u64::from(self.supply()) * halves / u64::from(2 * STEPS);
                Some(microvolts as u32)
            }
        }
    }
}
