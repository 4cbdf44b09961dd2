//! Power and resets: how the program comes to start, and with what left behind.

use super::Uno;
use crate::Halt;
use crate::avr::reg;
use crate::chip::Chip;
use crate::eeprom::Moment;
use crate::pins::Levels;

/// Bits of MCUSR: the reset came from the power, or from the button.
const PORF: u8 = 1 << 0;
const EXTRF: u8 = 1 << 1;

impl Uno {
    /// Presses the reset button. RAM, EEPROM and card stay as they are; the card is not powered again, and a byte that is
    /// being written to the EEPROM is written to its end. MCUSR gets EXTRF besides what it had. Nothing happens where
    /// the power is off ([`Halt::PowerCut`]).
    pub fn reset(&mut self) {
        if self.halt == Some(Halt::PowerCut) {
            return;
        }
        let cause = self.avr.register(reg::MCUSR);
        self.avr.set_register(reg::MCUSR, cause | EXTRF);
        self.restart();
    }

    /// Takes the power away, where it is not off already, and gives it back. EEPROM and card image stay, except for a
    /// byte or a block that is being written: that byte is left erased (0xFF), that block as it was before it came. The
    /// card is powered again. RAM and working registers get arbitrary values, others than the last time but the same in
    /// each run; MCUSR is PORF alone. Buttons and cycles go on.
    pub fn power_up(&mut self) {
        self.wired.power_cycle();
        self.power_ups += 1;
        scramble(self.avr.data_mut(), self.program.chip, self.power_ups);
        self.avr.set_register(reg::MCUSR, PORF);
        self.restart();
        self.resets = 0;
        self.stack.restart(&self.avr);
    }

    /// Cuts the power as soon as the `nth` byte that the program begins to write to the EEPROM from now on is written;
    /// 1 is the next. The run ends with [`Halt::PowerCut`]. A later call replaces this one; [`Uno::power_up`] forgets it.
    ///
    /// # Panics
    /// Where `nth` is 0.
    pub fn cut_power_after_eeprom_write(&mut self, nth: usize) {
        self.cut_power(nth, Moment::End);
    }

    /// The same in the middle of that write, which leaves the byte erased (0xFF).
    ///
    /// # Panics
    /// Where `nth` is 0.
    pub fn cut_power_during_eeprom_write(&mut self, nth: usize) {
        self.cut_power(nth, Moment::Middle);
    }

    fn cut_power(&mut self, nth: usize, moment: Moment) {
        assert!(nth > 0, "writes to the EEPROM are counted from 1");
        self.wired.eeprom.cut_power(nth, moment);
    }

    /// Says whether the stock boot loader of the UNO is on the chip. After a reset or at power-up it starts the program
    /// with MCUSR cleared and the watchdog off, whatever the cause; so for the program they look alike. Without it, as
    /// at first, the program starts with MCUSR as the chip set it, and after a watchdog reset with the watchdog on at
    /// 16 ms. A start of which nothing has been executed yet since the board was made counts already.
    ///
    /// The second for which it waits for an upload after the button is left out, as is its use of RAM.
    pub fn set_boot_loader(&mut self, present: bool) {
        self.boot_loader = present;
        if self.cycles() == 0 {
            self.run_boot_loader();
        }
    }

    /// Sets the supply voltage (AVCC), mV; 5000 at first. The converter measures against it: the internal reference of
    /// 1.1 V reads as 1100 × 1024 / `mv`. The chip runs on at any voltage.
    pub fn set_supply(&mut self, mv: u16) {
        self.wired.inputs.supply_mv = mv;
        self.apply_inputs();
    }

    /// Resets the chip, whose MCUSR tells the cause.
    fn restart(&mut self) {
        self.wired.cycles_before += self.avr.cycle();
        self.avr.reset();
        self.halt = None;
        self.settle_after_reset();
        self.watch_pins();
    }

    /// The power has gone, and all pins with it.
    pub(super) fn lose_power(&mut self) {
        self.halt = Some(Halt::PowerCut);
        self.record_pins(Levels::default());
    }

    /// What follows a reset, also one by the watchdog, which simavr does by itself.
    pub(super) fn settle_after_reset(&mut self) {
        self.resets += 1;
        self.wired.after_reset();
        // It was found when the board was made, so it is there.
        let _ = self.avr.unwire_timers();
        // simavr has started the watchdog (where WDRF is set) on the clock before the reset, so it would come late.
        self.avr.restart_watchdog();
        self.run_boot_loader();
    }

    fn run_boot_loader(&mut self) {
        if self.boot_loader {
            self.avr.set_register(reg::MCUSR, 0);
            // Its timer then does nothing, and is replaced once the watchdog is switched on again.
            self.avr.set_register(reg::WDTCSR, 0);
        }
    }
}

/// Fills working registers and RAM with arbitrary bytes, others for each `seed`, and leaves the I/O registers alone.
pub(super) fn scramble(data: &mut [u8], chip: Chip, seed: u32) {
    let mut state = 0x9E37_79B9u32.wrapping_add(seed.wrapping_mul(0x85EB_CA6B));
    let (registers, rest) = data.split_at_mut(0x20);
    let ram = rest.iter_mut().skip(chip.ram_start() as usize - 0x20);
    for byte in registers.iter_mut().chain(ram) {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        *byte = state.to_be_bytes()[0];
    }
}
