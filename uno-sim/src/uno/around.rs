//! Around the chip: buttons, switch, outputs, card slot and serial line.

use super::{FIRST_INPUT, STOP_PIN, Slot, Uno};
use crate::avr::{Irq, reg};
use crate::pins::{Edge, POINTS};
use crate::sd::SdCard;
use std::borrow::Cow;

impl Uno {
    /// Closes or opens the button of input `index`, 0 to 3 (points 01 to 04, pins D2 to D5). A closed button connects
    /// the pin to ground. An open one leaves it to the internal pull-up; without that it keeps its level, which is low
    /// after power-up, so that a program that forgot the pull-up is seen to.
    ///
    /// # Panics
    /// Where `index` is above 3.
    pub fn set_input(&mut self, index: usize, closed: bool) {
        assert!(index < POINTS, "input {index}: there are inputs 0 to 3");
        let bit = 1 << index;
        self.set_inputs(if closed {
            self.closed | bit
        } else {
            self.closed & !bit
        });
    }

    /// Closes the buttons whose bits are set (bit n: input n) and opens the others.
    pub fn set_inputs(&mut self, closed: u8) {
        self.closed = closed & ((1 << POINTS) - 1);
        self.apply_inputs();
    }

    /// The buttons that are closed: bit n is input n.
    pub fn inputs(&self) -> u8 {
        self.closed
    }

    /// Closes or opens the switch RUN/STOP, which connects A5 to ground while it is closed (STOP). Open, it leaves the pin
    /// to the internal pull-up, as a button does.
    pub fn set_stop(&mut self, closed: bool) {
        self.stop = closed;
        self.close(reg::DDRC, STOP_PIN as usize, self.stop_irq, closed);
        self.avr.set_external(b'C', u8::from(closed) << STOP_PIN, 0);
    }

    /// True while the switch RUN/STOP is closed (STOP).
    pub fn stop(&self) -> bool {
        self.stop
    }

    /// The outputs that are on, from DDR and PORT: bit n is output n (points 01 to 04, pins D6 to D9).
    pub fn outputs(&self) -> u8 {
        self.levels.outputs
    }

    /// True while the LED L is on. While the SPI is on it counts as off, though its clock makes the LED flicker.
    pub fn led(&self) -> bool {
        self.levels.led
    }

    /// Every change of the outputs and of the LED L so far, in order of time.
    pub fn edges(&self) -> &[Edge] {
        &self.edges
    }

    /// The same, and forgets them.
    pub fn take_edges(&mut self) -> Vec<Edge> {
        std::mem::take(&mut self.edges)
    }

    /// The card in the slot.
    pub fn card(&self) -> Option<&SdCard> {
        match &self.wired.slot {
            Slot::Card(card) => Some(card),
            Slot::Empty => None,
        }
    }

    /// The card in the slot, to give it a fault.
    pub fn card_mut(&mut self) -> Option<&mut SdCard> {
        match &mut self.wired.slot {
            Slot::Card(card) => Some(card),
            Slot::Empty => None,
        }
    }

    /// Puts something else into the slot and gives back what was there. A card that comes back has to be powered anew
    /// by the caller: [`SdCard::power_cycle`].
    pub fn swap_slot(&mut self, slot: Slot) -> Slot {
        let selected = self.levels.card_selected;
        let old = std::mem::replace(&mut self.wired.slot, slot);
        self.wired.select_card(selected);
        old
    }

    /// All bytes that the program has sent and that have not been taken.
    pub fn serial_bytes(&self) -> &[u8] {
        &self.wired.sent
    }

    /// The same as text; what is not UTF-8 is replaced.
    pub fn serial(&self) -> Cow<'_, str> {
        String::from_utf8_lossy(&self.wired.sent)
    }

    /// All bytes that the program has sent, and forgets them.
    pub fn take_serial(&mut self) -> Vec<u8> {
        std::mem::take(&mut self.wired.sent)
    }

    /// Sends bytes to the program, one after the other at the speed it has set. With its receiver off they are lost.
    /// simavr buffers 64 bytes where the chip buffers two, so a program that reads too late loses nothing here.
    pub fn send_serial(&mut self, bytes: &[u8]) {
        self.wired.send_serial(bytes);
    }

    /// Puts the levels of the buttons on the pins.
    fn apply_inputs(&mut self) {
        for (n, irq) in self.input_irqs.into_iter().enumerate() {
            let pin = FIRST_INPUT as usize + n;
            self.close(reg::DDRD, pin, irq, self.closed >> n & 1 == 1);
        }
        // simavr raises the pull-ups anew on each write to PORT or DDR, unless it knows of a level from outside.
        self.avr.set_external(b'D', self.closed << FIRST_INPUT, 0);
    }

    /// Connects a pin of the port with this DDR to ground, or leaves it to the pull-up.
    fn close(&mut self, ddr: u16, pin: usize, irq: Irq, closed: bool) {
        let pulled_up = !self.avr.register(ddr) & self.avr.register(ddr + 1);
        let level = match (closed, pulled_up >> pin & 1) {
            (true, _) => 0,
            (false, 1) => 1,
            (false, _) => return,
        };
        // SAFETY: the chip is alive, and no callback of ours is on this IRQ.
        unsafe { irq.raise(level) };
    }
}
