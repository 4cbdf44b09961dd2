//! The pins of the UNO's standard wiring, seen from outside (docs/numeric-code.md, "Pins of the UNO").

use crate::avr::{Avr, reg};
use crate::chip::Chip;

/// Outputs there are: points 01 to 04, pins D6 to D9.
pub const OUTPUTS: usize = 4;

/// A pin whose changes are recorded.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Pin {
    /// Output 0 to 3: points 01 to 04, pins D6 to D9.
    Output(u8),
    /// The LED L on the board, pin D13.
    Led,
    /// Pin A4 as an output: the direction of an RS-485 driver, high to send.
    Direction,
}

/// A change of one pin.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Edge {
    /// When: cycles since power-up, at the end of the instruction that did it.
    pub cycle: u64,
    /// Which pin.
    pub pin: Pin,
    /// To what level; a pin that is no longer driven counts as low.
    pub high: bool,
}

/// A pin of an output, by the data address of its direction register, which the port's follows.
const fn pin(ddr: u16, bit: u8) -> (u16, u8) {
    (ddr, bit)
}

/// Outputs 01 to 16 of the Mega.
const MEGA_OUTPUTS: [(u16, u8); 16] = {
    const E: u16 = 0x2D;
    const G: u16 = 0x33;
    const H: u16 = 0x101;
    const L: u16 = 0x10A;
    [
        pin(E, 4),
        pin(E, 5),
        pin(G, 5),
        pin(E, 3),
        pin(H, 3),
        pin(H, 4),
        pin(H, 5),
        pin(H, 6),
        pin(L, 0),
        pin(L, 1),
        pin(L, 2),
        pin(L, 3),
        pin(L, 4),
        pin(L, 5),
        pin(L, 6),
        pin(L, 7),
    ]
};

/// Direction registers of the ports that the levels of the Mega depend on: B, D, E, G, H, L.
const MEGA_PORTS: [u16; 6] = [0x24, 0x2A, 0x2D, 0x33, 0x101, 0x10A];

/// The registers that decide on the levels. Compared after every instruction, so they are one word: DDRB to PORTD as they
/// lie in data space, and SPE in place of PINC; PIND is left out.
#[derive(Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct PinRegisters(u64);

/// The same of either chip.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Registers {
    Uno(PinRegisters),
    /// DDR and PORT of [`MEGA_PORTS`].
    Mega([[u8; 2]; 6]),
}

impl Registers {
    #[inline(always)]
    pub fn of(avr: &Avr) -> Registers {
        match avr.chip() {
            Chip::Atmega328p => Registers::Uno(PinRegisters::of(avr)),
            Chip::Atmega2560 => {
                Registers::Mega(MEGA_PORTS.map(|ddr| [avr.register(ddr), avr.register(ddr + 1)]))
            }
        }
    }

    pub fn levels(self) -> Levels {
        match self {
            Registers::Uno(registers) => registers.levels(),
            Registers::Mega(registers) => mega_levels(registers),
        }
    }
}

impl PinRegisters {
    #[inline]
    pub fn of(avr: &Avr) -> PinRegisters {
        PinRegisters::new(avr.eight_registers(reg::DDRB), avr.register(reg::SPCR))
    }

    #[inline]
    fn new(ports: [u8; 8], spcr: u8) -> PinRegisters {
        const DDR_AND_PORT: u64 = u64::from_le_bytes([0xFF, 0xFF, 0, 0xFF, 0xFF, 0, 0xFF, 0xFF]);
        let spi_on = u64::from(spcr & 0x40) << 16;
        PinRegisters(u64::from_le_bytes(ports) & DDR_AND_PORT | spi_on)
    }

    pub fn levels(self) -> Levels {
        let [ddrb, portb, spi_on, ddrc, portc, _, ddrd, portd] = self.0.to_le_bytes();
        let (high_b, high_d) = (ddrb & portb, ddrd & portd);
        Levels {
            outputs: (high_d >> 6 | (high_b & 0x03) << 2).into(),
            is_output: (ddrd >> 6 | (ddrb & 0x03) << 2).into(),
            direction: ddrc & portc & 0x10 != 0,
            // While the SPI is on, D13 is its clock, which rests low in mode 0; single clocks are not recorded.
            led: high_b & 0x20 != 0 && spi_on == 0,
            card_selected: ddrb & !portb & 0x04 != 0,
        }
    }
}

/// What the pins show. A pin is high where it is an output (DDR = 1) and set (PORT = 1).
#[derive(Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct Levels {
    /// Bit n: output n.
    pub outputs: u32,
    /// Bit n: the pin of output n is driven.
    pub is_output: u32,
    /// A4 is driven high.
    pub direction: bool,
    pub led: bool,
    /// D10, the card's CS, is driven low. A pin that is not driven is pulled up on the card module.
    pub card_selected: bool,
}

impl Levels {
    /// Those of a copy of data space; registers that it lacks are 0.
    pub fn of_data(chip: Chip, data: &[u8]) -> Levels {
        let register = |address: u16| data.get(usize::from(address)).copied().unwrap_or(0);
        match chip {
            Chip::Atmega328p => {
                let ports = std::array::from_fn(|n| register(reg::DDRB + n as u16));
                PinRegisters::new(ports, register(reg::SPCR)).levels()
            }
            Chip::Atmega2560 => {
                mega_levels(MEGA_PORTS.map(|ddr| [register(ddr), register(ddr + 1)]))
            }
        }
    }

    /// The edges that lead from `self` to `next`.
    pub fn edges_to(self, next: Levels, cycle: u64) -> impl Iterator<Item = Edge> {
        let changed = self.outputs ^ next.outputs;
        let outputs = (0..u32::BITS as u8)
            .filter(move |n| changed >> n & 1 == 1)
            .map(move |n| Edge {
                cycle,
                pin: Pin::Output(n),
                high: next.outputs >> n & 1 == 1,
            });
        let led = (Pin::Led, self.led, next.led);
        let direction = (Pin::Direction, self.direction, next.direction);
        let others = [led, direction].into_iter();
        let others = others.filter(|(_, before, high)| before != high);
        outputs.chain(others.map(move |(pin, _, high)| Edge { cycle, pin, high }))
    }
}

/// What the pins of a Mega show, from the direction and port registers of [`MEGA_PORTS`].
fn mega_levels(registers: [[u8; 2]; 6]) -> Levels {
    let [b, d, ..] = registers;
    let mut levels = Levels {
        direction: d[0] & d[1] & 1 << 1 != 0,
        led: b[0] & b[1] & 1 << 7 != 0,
        card_selected: b[0] & !b[1] & 1 != 0,
        ..Levels::default()
    };
    for (output, (ddr, bit)) in MEGA_OUTPUTS.into_iter().enumerate() {
        let port = MEGA_PORTS.iter().position(|&port| port == ddr);
        let [ddr, port] = port.map_or([0; 2], |port| registers[port]);
        levels.is_output |= u32::from(ddr >> bit & 1) << output;
        levels.outputs |= (u32::from(ddr & port) >> bit & 1) << output;
    }
    levels
}
