//! From stored bytes, as the EEPROM keeps them, to linked bytes.

use super::data::Data;
use super::rows::{self, symbols};
use super::{COUNTER_DATA, Layout, POINTS, TIMER_DATA};
use crate::board::eeprom::Eeprom;
use crate::store::Reader;
use core::mem;
use unoclp_core::isa::{self, FAST_INPUTS, Kind, MARKER_TARGET, Opcode};

/// The word address of a handler.
macro_rules! handler {
    ($name:ident) => {
        symbols::$name as *const () as usize as u16
    };
}

/// What has been read and not been put yet: it depends on what follows.
#[derive(Clone, Copy)]
enum Pending {
    /// Nothing, and acc is 1: a scan or a rung begins.
    Rung,
    /// A coil of this output.
    Coil(u8),
    /// So many contacts in a row, in any order: images that must be 1, and that must be 0.
    Contacts(u8, u8, u8),
    /// Nothing.
    Nothing,
}

/// How much a program takes of run memory, bytes.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Size {
    pub code: u16,
    pub own: u16,
}

struct Linker<'l, 'm> {
    stored: Reader<'l>,
    layout: &'l mut Layout<'m>,
    /// Where linked bytes are put; those beyond are only counted.
    code: &'l mut [u8],
    /// Linked bytes, timers, and bytes of own data so far.
    size: Size,
    timers: u8,
    pending: Pending,
    /// How each open branch is closed, the innermost in the low bits: an index of [`CLOSING`].
    closing: u16,
}

/// A label while a program is linked, in the register with its number: where it stands in the linked
/// and in the stored form.
type Label = [u16; 2];
/// It is not known yet, so it stands further on.
const AHEAD: u8 = 0xFF;

/// One passage through the stored form, which sets up timers and counters too. The registers hold labels
/// meanwhile; behind the first passage they have all of them, and no later one finds others. None where
/// the EEPROM does not hold what was checked.
#[inline(never)]
pub fn pass(layout: &mut Layout<'_>, eeprom: &Eeprom, code: &mut [u8]) -> Option<Size> {
    layout.counters.fill(0);
    let mut linker = Linker {
        stored: layout.stored.read(eeprom),
        layout,
        code,
        size: Size { code: 0, own: 0 },
        timers: 0,
        pending: Pending::Rung,
        closing: 0,
    };
    linker.all()?;
    Some(linker.size)
}

/// Before the first passage: no label is known.
pub fn forget_labels(data: &mut Data) {
    data.registers.as_flattened_mut().fill(AHEAD);
}

impl Linker<'_, '_> {
    // Apart from `pass`, which only fills the linker.
    #[inline(never)]
    fn all(&mut self) -> Option<()> {
        while let Some(byte) = self.stored.next() {
            self.take(byte)?;
        }
        self.handler(handler!(engine_end));
        self.stored.is_whole().then_some(())
    }

    /// Takes the instruction that begins with this byte.
    #[inline(never)]
    fn take(&mut self, byte: u8) -> Option<()> {
        let row = isa::row_of(byte);
        let kind = isa::kind_of(rows::instruction_table, row)?;
        let handler = rows::handler(row);
        let point = byte & 0x0F;
        match byte >> 4 {
            1..=4 => self.contact(byte >> 4, point),
            5 => {
                self.coil(point);
            }
            6 | 7 => self.handler(handler + 4 * u16::from(point % POINTS)),
            8 | 9 => self.handler(handler + 3 * u16::from(point % isa::BRANCH_POINTS)),
            _ if kind == Kind::None => self.plain(byte, handler),
            _ if kind == Kind::Timer => return self.timer(handler),
            _ if kind == Kind::Scale => {
                self.handler(handler);
                return self.copy(8);
            }
            _ => {
                let number = self.stored.next()?;
                return self.numbered(byte, kind, handler, number);
            }
        }
        Some(())
    }

    fn plain(&mut self, byte: u8, mut handler: u16) {
        if byte == Opcode::NewRung as u8 {
            return self.new_rung();
        }
        if byte == Opcode::CloseBranch as u8 {
            handler = match self.closing & 3 {
                0 => handler,
                1 => handler!(engine_close_and),
                _ => handler!(engine_close_xor),
            };
            self.closing >>= 2;
        }
        if byte == Opcode::OpenBranch as u8 {
            self.closing <<= 2;
        }
        if byte == Opcode::OpenAnd as u8 {
            self.closing = self.closing << 2 | 1;
        }
        if byte == Opcode::OpenXor as u8 {
            self.closing = self.closing << 2 | 2;
        }
        self.handler(handler);
        if byte == Opcode::RisingEdge as u8 || byte == Opcode::FallingEdge as u8 {
            self.own(1);
        }
        if byte == Opcode::StoreOutputs as u8 {
            let mask = self.outputs();
            self.put(mask);
        }
    }

    /// An instruction with an XX.
    #[inline(never)]
    fn numbered(&mut self, byte: u8, kind: Kind, mut handler: u16, number: u8) -> Option<()> {
        match kind {
            Kind::Time => return Some(()),
            Kind::Label => {
                self.label(number);
                return Some(());
            }
            Kind::Jump => return self.jump(byte, handler, number),
            Kind::Input if number > FAST_INPUTS => {
                handler = if byte == Opcode::XorInput as u8 {
                    handler!(engine_xor_cell)
                } else {
                    handler!(engine_xor_cell_not)
                };
            }
            _ => {}
        }
        self.handler(handler);
        match kind {
            Kind::Input if number <= FAST_INPUTS => self.put(bit(number)),
            Kind::Output => self.put(bit(number + POINTS)),
            Kind::Bit => self.put(number),
            Kind::Value if number == 0 => {
                self.put(0);
                return self.copy(4);
            }
            Kind::Filter => {
                self.own(9);
                self.put(number);
                return self.copy(2);
            }
            Kind::Register if byte == Opcode::Integrate as u8 => {
                self.own(7);
                self.object(kind, number, 0);
            }
            Kind::Analogue => self.object(kind, number + 1, 0),
            Kind::TimerQ if byte == Opcode::PresetTimer as u8 => self.object(kind, number, 5),
            Kind::Counter if byte == Opcode::PresetCounter as u8 => self.object(kind, number, 4),
            _ => self.object(kind, number, 0),
        }
        match kind {
            Kind::Count => {
                let first = usize::from(number).wrapping_sub(1) * COUNTER_DATA + 4;
                for index in first..first + 4 {
                    *self.layout.counters.get_mut(index)? = self.stored.next()?;
                }
            }
            Kind::Move => {
                let to = self.stored.next()?;
                self.object(kind, to, 0);
                let count = self.stored.next()?;
                self.put(count << 2);
            }
            Kind::Drum => {
                let steps = self.stored.next()?;
                self.put(steps);
                let mask = self.outputs();
                for _ in 0..steps {
                    let step = self.stored.next()?;
                    self.put(step << 4 & mask);
                }
            }
            _ => {}
        }
        Some(())
    }

    fn new_rung(&mut self) {
        match self.pending {
            Pending::Rung => {}
            Pending::Coil(output) => {
                let handler = handler!(engine_coil_new_rung) + 4 * u16::from(output % POINTS);
                self.pending = Pending::Nothing;
                self.handler(handler);
            }
            _ => self.handler(handler!(engine_new_rung)),
        }
        self.pending = Pending::Rung;
    }

    /// A contact: of an input or an output, normally open or closed.
    fn contact(&mut self, which: u8, point: u8) {
        let is_input = which <= 2;
        let is_open = which & 1 != 0;
        if is_input && point >= FAST_INPUTS {
            self.handler(if is_open {
                handler!(engine_cell)
            } else {
                handler!(engine_cell_not)
            });
            return self.object(Kind::Input, point + 1, 0);
        }
        let (count, mut ones, mut zeros) = match self.pending {
            Pending::Contacts(count, ones, zeros) => (count, ones, zeros),
            _ => {
                self.flush();
                (0, 0, 0)
            }
        };
        let bit = bit(point + if is_input { 1 } else { 1 + POINTS });
        if is_open {
            ones |= bit;
        } else {
            zeros |= bit;
        }
        self.pending = Pending::Contacts(count.saturating_add(1), ones, zeros);
    }

    fn coil(&mut self, output: u8) {
        self.flush();
        self.pending = Pending::Coil(output);
    }

    fn timer(&mut self, handler: u16) -> Option<()> {
        self.handler(handler);
        let first = usize::from(self.timers) * TIMER_DATA;
        let data = self.layout.timers.get_mut(first..first + TIMER_DATA)?;
        self.timers += 1;
        for (index, byte) in data.iter_mut().enumerate() {
            *byte = if index < 5 { 0 } else { self.stored.next()? };
        }
        let target = self.stored.next()?;
        match target.checked_sub(MARKER_TARGET - 1) {
            None => self.coil(target),
            Some(marker) => {
                self.handler(handler!(engine_cell_coil));
                self.object(Kind::Marker, marker, 0);
            }
        }
        Some(())
    }

    fn label(&mut self, number: u8) {
        self.flush();
        let linked = self.layout.begin.wrapping_add(self.size.code);
        // It begins two bytes before.
        let stored = self.stored.position() - 2;
        self.handler(handler!(engine_label));
        self.address(self.layout.timer(self.timers));
        if let Some(label) = self.label_place(number) {
            let [[a, b], [c, d]] = [linked, stored].map(u16::to_le_bytes);
            *label = [a, b, c, d];
        }
        self.pending = Pending::Rung;
    }

    fn jump(&mut self, byte: u8, handler: u16, number: u8) -> Option<()> {
        let line = [self.stored.next()?, self.stored.next()?];
        let position = self.stored.position();
        let [a, b, c, d] = *self.label_place(number)?;
        let [linked, stored]: Label = [[a, b], [c, d]].map(u16::from_le_bytes);
        if stored > position {
            self.handler(handler);
            self.address(linked);
            return Some(());
        }
        self.layout.jumps_back = true;
        self.handler(if byte == Opcode::Jump as u8 {
            handler!(engine_jump_back)
        } else {
            handler!(engine_jump_back_not)
        });
        self.address(linked);
        for byte in (position - stored).to_le_bytes().into_iter().chain(line) {
            self.put(byte);
        }
        Some(())
    }

    fn label_place(&mut self, number: u8) -> Option<&mut [u8; 4]> {
        let index = usize::from(number).wrapping_sub(1);
        self.layout.data.registers.get_mut(index)
    }

    /// The outputs that are not PWM, as they stand in the images.
    fn outputs(&self) -> u8 {
        !self.layout.needs.pwm << 4
    }

    /// Puts the address of what an instruction of this kind names, so many bytes into it.
    fn object(&mut self, kind: Kind, number: u8, offset: u16) {
        let data = &*self.layout.data;
        let at = |place: *const u8| place as usize as u16;
        let (first, size) = match kind {
            Kind::Marker => (at(data.markers.as_ptr()), 1),
            Kind::Group => (at(data.markers.as_ptr()), 8),
            Kind::System => (at(data.system.as_ptr()), 1),
            // Of inputs those from 05 on.
            Kind::Input => (at(data.inputs.as_ptr()) - u16::from(FAST_INPUTS), 1),
            Kind::Analogue => (at(data.analogue.as_ptr().cast()), 2),
            Kind::Pwm => (at(data.pwm.as_ptr()), 1),
            Kind::Reading => (at(data.readings.as_ptr().cast()), 4),
            Kind::TimerQ => (self.layout.timer(0), TIMER_DATA as u16),
            Kind::Counter | Kind::Count => {
                (at(self.layout.counters.as_ptr()), COUNTER_DATA as u16)
            }
            _ => (at(data.registers.as_flattened().as_ptr()), 4),
        };
        let place = u16::from(number.wrapping_sub(1)) * size;
        self.address(first.wrapping_add(place).wrapping_add(offset));
    }

    /// Puts the address of so many bytes of own data.
    fn own(&mut self, bytes: u8) {
        self.size.own += u16::from(bytes);
        self.address(self.layout.own_end.wrapping_sub(self.size.own));
    }

    fn address(&mut self, address: u16) {
        let [low, high] = address.to_le_bytes();
        self.put(high);
        self.put(low);
    }

    /// Puts so many of the next stored bytes.
    fn copy(&mut self, bytes: u8) -> Option<()> {
        for _ in 0..bytes {
            let byte = self.stored.next()?;
            self.put(byte);
        }
        Some(())
    }

    /// Puts a handler, after what is pending.
    #[inline(never)]
    fn handler(&mut self, handler: u16) {
        self.flush();
        let [low, high] = handler.to_le_bytes();
        if high != 0 {
            self.put(handler!(engine_escape) as u8);
        }
        self.put(low);
    }

    #[inline(never)]
    fn put(&mut self, byte: u8) {
        if let Some(place) = self.code.get_mut(usize::from(self.size.code)) {
            *place = byte;
        }
        self.size.code += 1;
    }

    fn flush(&mut self) {
        match mem::replace(&mut self.pending, Pending::Nothing) {
            Pending::Rung | Pending::Nothing => {}
            Pending::Coil(output) => {
                self.put(handler!(engine_coil) as u8 + 3 * (output % POINTS));
            }
            Pending::Contacts(count, ones, zeros) => self.contacts(count, ones, zeros),
        }
    }

    fn contacts(&mut self, count: u8, ones: u8, zeros: u8) {
        if count > 2 {
            self.put(handler!(engine_contacts) as u8);
            // A point that must be 1 and 0: what is asked for leaves it out, so it is never 1.
            self.put(ones ^ zeros);
            self.put(ones);
            return;
        }
        for image in 0..8 {
            if ones >> image & 1 != 0 {
                self.put(handler!(engine_contact) as u8 + 4 * image);
            }
            if zeros >> image & 1 != 0 {
                self.put(handler!(engine_contact_not) as u8 + 4 * image);
            }
        }
    }
}

/// The bit of the images with this number, from 1.
fn bit(number: u8) -> u8 {
    1 << (number.wrapping_sub(1) & 7)
}
