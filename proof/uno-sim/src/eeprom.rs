//! The EEPROM and its control register, with the time that a write takes (ATmega328P datasheet, section 8.6).
//!
//! simavr writes a byte at once. The chip takes 3.4 ms, in which the program runs on, the next write is ignored, and
//! the power can fail. So simavr's own EEPROM is not used. This model knows nothing of simavr: the callbacks of
//! `wiring` tell it what the program does, and the time.
//!
//! Not modelled: the interrupt EE_READY, which a program that asks for it never gets.

/// Cycles of a byte write at 16 MHz: 3.4 ms (datasheet, table 8-1: erase and write in one operation).
pub const EEPROM_WRITE_CYCLES: u64 = 54_400;
/// Cycles of erasing or writing alone: 1.8 ms (table 8-1).
const HALF_WRITE_CYCLES: u64 = 28_800;
/// Cycles after which the chip takes EEMPE back.
const ARMED_CYCLES: u64 = 4;
/// What an erased byte holds.
const ERASED: u8 = 0xFF;

/// Bits of EECR. EERIE and EEPM are stored as they are written.
const EERE: u8 = 1 << 0;
const EEPE: u8 = 1 << 1;
const EEMPE: u8 = 1 << 2;
const EERIE: u8 = 1 << 3;
const EEPM: u8 = 3 << 4;

/// A write of one byte that has come to its end, also where the old and the new value are the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EepromWrite {
    /// When it ended: cycles since the board was made.
    pub cycle: u64,
    /// Address in the EEPROM, 0 to 0x3FF.
    pub address: u16,
    /// What the byte held.
    pub before: u8,
    /// What it holds now. After a power cut in the middle that is not what the program wanted.
    pub after: u8,
}

/// What a write to EECR sets off.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Action {
    /// Nothing that can be seen.
    Nothing,
    /// This byte goes into EEDR.
    Read(u8),
    /// [`Eeprom::is_due`] wants to be called at this cycle.
    Programming {
        /// Cycles since the board was made.
        due: u64,
    },
}

/// Mode of programming, from the EEPM bits (table 8-1).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Mode {
    EraseAndWrite,
    Erase,
    Write,
}

/// When the power goes, seen from a write.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Moment {
    /// Half of its time is over.
    Middle,
    /// It has just ended.
    End,
}

#[derive(Clone, Copy, Debug)]
struct Programming {
    mode: Mode,
    address: u16,
    data: u8,
    due: u64,
    cut: Option<Moment>,
}

/// The EEPROM. All times are cycles since the board was made.
pub(crate) struct Eeprom {
    bytes: Vec<u8>,
    /// EERIE and EEPM.
    control: u8,
    /// When EEMPE was set.
    armed: Option<u64>,
    programming: Option<Programming>,
    /// The write, by its place in the log, at which the power is to go.
    cut: Option<(usize, Moment)>,
    writes: Vec<EepromWrite>,
}

impl Eeprom {
    /// As from the factory: erased.
    pub fn new(len: usize) -> Eeprom {
        Eeprom {
            bytes: vec![ERASED; len],
            control: 0,
            armed: None,
            programming: None,
            cut: None,
            writes: Vec::new(),
        }
    }

    /// What it holds. A byte that is being written still has its old value.
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// The same for writing from outside, at once.
    pub fn bytes_mut(&mut self) -> &mut [u8] {
        &mut self.bytes
    }

    /// All writes of the program that have ended.
    pub fn writes(&self) -> &[EepromWrite] {
        &self.writes
    }

    /// How often each byte has been erased or written, also where it kept its value.
    pub fn wear(&self) -> Vec<u32> {
        let mut wear = vec![0; self.bytes.len()];
        for write in &self.writes {
            wear[usize::from(write.address)] += 1;
        }
        wear
    }

    /// A write is going on. EEAR cannot be changed then.
    pub fn is_busy(&self) -> bool {
        self.programming.is_some()
    }

    /// EECR, as the program reads it.
    pub fn control(&self, now: u64) -> u8 {
        let armed = if self.is_armed(now) { EEMPE } else { 0 };
        let busy = if self.is_busy() { EEPE } else { 0 };
        self.control | armed | busy
    }

    /// The program writes `value` to EECR while EEAR and EEDR hold `address` and `data`.
    ///
    /// EEMPE counts from the start of the instruction that sets it, so the program has a cycle or two less than the chip
    /// gives it.
    pub fn set_control(&mut self, value: u8, address: u16, data: u8, now: u64) -> Action {
        if self.is_busy() {
            self.control = self.control & EEPM | value & EERIE;
            return Action::Nothing;
        }
        self.control = value & (EEPM | EERIE);
        // EEAR has ten bits.
        let address = address % self.bytes.len() as u16;
        if value & EEPE != 0 && self.is_armed(now) {
            self.armed = None;
            return match Mode::of(self.control) {
                Some(mode) => self.begin(mode, address, data, now),
                None => Action::Nothing,
            };
        }
        if value & EEMPE != 0 && !self.is_armed(now) {
            self.armed = Some(now);
        }
        if value & EERE != 0 {
            return Action::Read(self.bytes[usize::from(address)]);
        }
        Action::Nothing
    }

    /// The cycle at which [`Eeprom::is_due`] wants to be called.
    pub fn due(&self) -> Option<u64> {
        self.programming.map(|programming| programming.due)
    }

    /// The awaited cycle has come. True where the power goes now.
    pub fn is_due(&mut self) -> bool {
        let Some(Programming {
            mode,
            address,
            data,
            due,
            cut,
        }) = self.programming
        else {
            return false;
        };
        if cut == Some(Moment::Middle) {
            self.power_off(due);
        } else {
            let before = self.bytes[usize::from(address)];
            self.end(address, mode.done(before, data), due);
        }
        cut.is_some()
    }

    /// Has the power cut at the `nth` write that begins from now on, 1 being the next.
    pub fn cut_power(&mut self, nth: usize, moment: Moment) {
        let before = self.writes.len() + usize::from(self.is_busy());
        self.cut = Some((before + nth - 1, moment));
    }

    /// A reset of the chip: a write that is going on does not mind (section 8.4.2).
    pub fn reset(&mut self) {
        self.armed = None;
        self.control &= if self.is_busy() { EEPM } else { 0 };
    }

    /// The power goes: a byte that was being written stays as far as it was.
    pub fn power_off(&mut self, now: u64) {
        if let Some(Programming { mode, address, .. }) = self.programming {
            let before = self.bytes[usize::from(address)];
            self.end(address, mode.broken_off(before), now);
        }
        self.cut = None;
        self.reset();
    }

    fn is_armed(&self, now: u64) -> bool {
        self.armed.is_some_and(|since| now < since + ARMED_CYCLES)
    }

    fn begin(&mut self, mode: Mode, address: u16, data: u8, now: u64) -> Action {
        let cut = self.cut.filter(|&(write, _)| write == self.writes.len());
        let cut = cut.map(|(_, moment)| moment);
        let cycles = match cut {
            Some(Moment::Middle) => mode.cycles() / 2,
            Some(Moment::End) | None => mode.cycles(),
        };
        let due = now + cycles;
        self.programming = Some(Programming {
            mode,
            address,
            data,
            due,
            cut,
        });
        Action::Programming { due }
    }

    fn end(&mut self, address: u16, after: u8, cycle: u64) {
        self.programming = None;
        let byte = &mut self.bytes[usize::from(address)];
        let before = std::mem::replace(byte, after);
        self.writes.push(EepromWrite {
            cycle,
            address,
            before,
            after,
        });
    }
}

impl Mode {
    /// The mode of these EEPM bits; `None` for the combination that is reserved.
    fn of(control: u8) -> Option<Mode> {
        match (control & EEPM) >> 4 {
            0 => Some(Mode::EraseAndWrite),
            1 => Some(Mode::Erase),
            2 => Some(Mode::Write),
            _ => None,
        }
    }

    fn cycles(self) -> u64 {
        match self {
            Mode::EraseAndWrite => EEPROM_WRITE_CYCLES,
            Mode::Erase | Mode::Write => HALF_WRITE_CYCLES,
        }
    }

    /// The byte after a whole operation. Writing alone only clears bits.
    fn done(self, before: u8, data: u8) -> u8 {
        match self {
            Mode::EraseAndWrite => data,
            Mode::Erase => ERASED,
            Mode::Write => before & data,
        }
    }

    /// The byte after an operation that was broken off: erased, but not written.
    fn broken_off(self, before: u8) -> u8 {
        match self {
            Mode::EraseAndWrite | Mode::Erase => ERASED,
            Mode::Write => before,
        }
    }
}
