//! Around the chip: inputs, outputs and card slot.

use super::{Slot, Uno};
use crate::avr::Irq;
use crate::chip::Chip;
use crate::inputs::{Analogue, Driven, INPUTS};
use crate::pins::Edge;
use crate::pwm::Pwm;
use crate::sd::SdCard;

impl Uno {
    /// Closes or opens the button of input `index`, 0 to 7 (points 01 to 08, pins D2 to D5 and A0 to A3). A closed button
    /// connects the pin to ground. An open one leaves it to the internal pull-up; without that it keeps its level, which
    /// is low after power-up, so that a program that forgot the pull-up is seen to.
    ///
    /// # Panics
    /// Where `index` is above 7.
    pub fn set_input(&mut self, index: usize, closed: bool) {
        assert!(index < INPUTS, "input {index}: there are inputs 0 to 7");
        let bit = 1 << index;
        let others = self.inputs() & !bit;
        self.set_inputs(others | if closed { bit } else { 0 });
    }

    /// Closes the buttons whose bits are set (bit n: input n) and opens the others.
    pub fn set_inputs(&mut self, closed: u8) {
        self.set_all_inputs(closed.into());
    }

    /// The same of a board with more of them.
    pub fn set_all_inputs(&mut self, closed: u32) {
        self.wired.inputs.closed = closed;
        self.apply_inputs();
    }

    /// The buttons that are closed: bit n is input n.
    pub fn inputs(&self) -> u8 {
        self.wired.inputs.closed as u8
    }

    /// Connects analogue input `index`, 0 to 4 (points 01 to 05, pins A0 to A4) to something; at first it is open. A
    /// button on the same pin that is closed has the pin at ground all the same.
    ///
    /// # Panics
    /// Where `index` is above 4, or a reading above 1023.
    pub fn set_analogue(&mut self, index: usize, analogue: Analogue) {
        assert!(
            index < usize::from(self.chip().board().analogue),
            "analogue input {index}: there are fewer"
        );
        if let Analogue::Reading(reading) = analogue {
            assert!(reading <= 1023, "the converter never reads {reading}");
        }
        self.wired.inputs.analogue[index] = analogue;
        self.apply_inputs();
    }

    /// Closes or opens the switch RUN/STOP, which connects A5 to ground while it is closed (STOP). Open, it leaves the pin
    /// to the internal pull-up, as a button does.
    pub fn set_stop(&mut self, closed: bool) {
        self.wired.inputs.stop = closed;
        self.apply_inputs();
    }

    /// True while the switch RUN/STOP is closed (STOP).
    pub fn stop(&self) -> bool {
        self.wired.inputs.stop
    }

    /// The outputs that are on, from DDR and PORT: bit n is output n (points 01 to 04, pins D6 to D9).
    pub fn outputs(&self) -> u8 {
        self.levels.outputs as u8
    }

    /// The same of a board with more of them.
    pub fn all_outputs(&self) -> u32 {
        self.levels.outputs
    }

    /// The pulses on output `index`, where a timer makes them: output 0 (point 01, D6) or 3 (point 04, D9). The pin has
    /// them in place of its level in [`Uno::outputs`], and there is no [`Edge`] for them. `None` while there are none, so
    /// for the others always.
    pub fn pwm(&self, index: usize) -> Option<Pwm> {
        let pwm = match index {
            _ if self.chip() == Chip::Atmega2560 => Pwm::of_mega(self.avr.data(), index),
            0 => Pwm::of_timer_0(self.avr.data()),
            3 => Pwm::of_timer_1(self.avr.data()),
            _ => None,
        };
        pwm.filter(|_| self.levels.is_output >> index & 1 == 1)
    }

    /// True while A4 is high: the direction of the RS-485 driver, where it is an output.
    pub fn direction(&self) -> bool {
        self.levels.direction
    }

    /// True while the LED L is on. While the SPI is on it counts as off, though its clock makes the LED flicker.
    pub fn led(&self) -> bool {
        self.levels.led
    }

    /// Every change of the outputs, of the LED L and of the direction so far, in order of time.
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

    /// Puts something else into the slot and gives back what was there. A card that comes back has to be powered again
    /// by the caller: [`SdCard::power_cycle`].
    pub fn swap_slot(&mut self, slot: Slot) -> Slot {
        let selected = self.levels.card_selected;
        let old = std::mem::replace(&mut self.wired.slot, slot);
        self.wired.select_card(selected);
        old
    }

    /// Puts the levels of the inputs on the pins.
    pub(super) fn apply_inputs(&mut self) {
        let chip = self.chip();
        for (port, ddr, driven) in chip.input_ports(&self.wired.inputs) {
            for &(_, pin, irq) in self.irqs.iter().filter(|(at, _, _)| *at == port) {
                self.apply(ddr, driven, pin, irq);
            }
        }
        // simavr raises the pull-ups again on each write to PORT or DDR, unless it knows of a level from outside.
        for (port, _, driven) in chip.input_ports(&self.wired.inputs) {
            self.avr.set_external(port, driven.mask, driven.levels);
        }
    }

    /// Puts the level from outside on a pin of the port with this DDR, or that of the pull-up.
    fn apply(&self, ddr: u16, driven: Driven, pin: u8, irq: Irq) {
        let bit = 1 << pin;
        let direction = self.avr.register(ddr);
        let pulled_up = !direction & self.avr.register(ddr + 1);
        let high = match (driven.mask & bit != 0, pulled_up & bit != 0) {
            _ if direction & bit != 0 => return,
            (true, _) => driven.levels & bit != 0,
            (false, true) => true,
            (false, false) => return,
        };
        // SAFETY: the chip is alive, and no callback of ours is on this IRQ.
        unsafe { irq.raise(high.into()) };
    }
}
