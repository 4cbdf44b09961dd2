//! Which points of the board a program has: those that addresses name, and those that are allotted.
//!
//! | address | point |
//! | --- | --- |
//! | `%IX0.0` … | inputs 01 … |
//! | `%QX0.0` … | outputs 01 … |
//! | `%MX0.0` … | markers 01 … |
//! | `%MW1` …, `%MD1` … | registers 01 … |
//! | `%IW0` … | analogue inputs 00 … |
//! | `%QW1` … | PWM of outputs 01 … |
//!
//! How many there are is the board's to say.

use unoclp_core::Board;
use unoclp_core::isa::REGISTERS;
use unoclp_draw::Address;

/// What an address names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Point {
    /// A bit, a register or an analogue input.
    At(Address),
    /// The PWM of an output.
    Pwm(u8),
}

/// The points that are still free.
pub(crate) struct Points {
    pub(crate) board: Board,
    markers: u128,
    registers: u128,
    counters: u128,
    labels: u128,
    timers: u8,
}

impl Points {
    pub(crate) fn new(board: Board) -> Points {
        Points {
            board,
            markers: 0,
            registers: 0,
            counters: 0,
            labels: 0,
            timers: 0,
        }
    }

    /// The point that an address names: `%IX0.0`; none where the board has none.
    pub(crate) fn address(&self, address: &str) -> Option<Point> {
        let address = address.trim().strip_prefix('%')?.to_ascii_uppercase();
        let digits = address.find(|c: char| c.is_ascii_digit())?;
        let (letters, numbers) = address.split_at(digits);
        let (first, bit) = match numbers.split_once('.') {
            Some((first, bit)) => (first.parse().ok()?, Some(bit.parse::<u8>().ok()?)),
            None => (numbers.parse::<u8>().ok()?, None),
        };
        let bit_of = |most: u8| {
            let number = match bit {
                Some(bit) if bit < 8 => first.checked_mul(8)?.checked_add(bit)?,
                Some(_) => return None,
                // Without a bit it is the number of the point, as in other languages.
                None => first.checked_sub(1)?,
            };
            (number < most).then_some(number + 1)
        };
        let word = |least: u8, most: u8| {
            (bit.is_none() && (least..=most).contains(&first)).then_some(first)
        };
        Some(match letters {
            "I" | "IX" => Point::At(Address::Input(bit_of(self.board.inputs)?)),
            "Q" | "QX" => Point::At(Address::Output(bit_of(self.board.outputs)?)),
            "M" | "MX" => Point::At(Address::Marker(bit_of(self.board.markers)?)),
            "MW" | "MD" => Point::At(Address::Register(word(1, REGISTERS)?)),
            "IW" => Point::At(Address::Analogue(word(
                0,
                self.board.analogue.checked_sub(1)?,
            )?)),
            "QW" => Point::Pwm(word(1, self.board.outputs)?),
            _ => return None,
        })
    }

    /// Leaves out the point of this address where others are allotted.
    pub(crate) fn take(&mut self, address: &str) {
        match self.address(address) {
            Some(Point::At(Address::Marker(number))) => self.markers |= 1 << number,
            Some(Point::At(Address::Register(number))) => self.registers |= 1 << number,
            _ => {}
        }
    }

    /// A marker; one that is kept over a power cut, where that is asked for.
    pub(crate) fn marker(&mut self, retain: bool) -> Option<u8> {
        let mut numbers = self.board.markers_that(retain);
        let number = numbers.find(|number| self.markers >> number & 1 == 0)?;
        self.markers |= 1 << number;
        Some(number)
    }

    /// A register.
    pub(crate) fn register(&mut self) -> Option<u8> {
        let number = (1..=REGISTERS).find(|number| self.registers >> number & 1 == 0)?;
        self.registers |= 1 << number;
        Some(number)
    }

    /// A counter: of one that is called C1, C2 … the one with that number, where it is free.
    pub(crate) fn counter(&mut self, name: &str) -> Option<u8> {
        let own = name.strip_prefix(['C', 'c']).and_then(|n| n.parse().ok());
        let most = self.board.counters;
        let is_free = |number: &u8| (1..=most).contains(number) && self.counters >> number & 1 == 0;
        let number = own.filter(is_free).or_else(|| (1..=most).find(is_free))?;
        self.counters |= 1 << number;
        Some(number)
    }

    /// The label with the number that its name says, L1, L2 …, where it is free.
    pub(crate) fn own_label(&mut self, name: &str) -> Option<u8> {
        let own: u8 = name.strip_prefix(['L', 'l'])?.parse().ok()?;
        let is_free = (1..=self.board.labels).contains(&own) && self.labels >> own & 1 == 0;
        if !is_free {
            return None;
        }
        self.labels |= 1 << own;
        Some(own)
    }

    /// A label.
    pub(crate) fn label(&mut self) -> Option<u8> {
        let number = (1..=self.board.labels).find(|number| self.labels >> number & 1 == 0)?;
        self.labels |= 1 << number;
        Some(number)
    }

    /// A timer, by the order in which they are allotted.
    pub(crate) fn timer(&mut self) -> Option<u8> {
        self.timers = (self.timers < self.board.timers).then_some(self.timers + 1)?;
        Some(self.timers)
    }
}

/// How an address is written.
pub(crate) fn written(point: Address) -> Option<String> {
    Some(match point {
        Address::Input(number) => format!("%IX0.{}", number.checked_sub(1)?),
        Address::Output(number) => format!("%QX0.{}", number.checked_sub(1)?),
        Address::Marker(number) => {
            let number = number.checked_sub(1)?;
            format!("%MX{}.{}", number / 8, number % 8)
        }
        Address::Register(number) => format!("%MD{number}"),
        Address::Analogue(number) => format!("%IW{number}"),
        _ => return None,
    })
}
