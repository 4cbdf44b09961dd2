//! A board on simavr that keeps its program already.

use super::{EngineError, UnoEngine, told};
use crate::{Slot, Uno};
use unoclp_core::Program;
use unoclp_host_sim::engine::Refusal;
use unoclp_modbus::eeprom::program as kept;

/// How long a board waits for a card that is not there, ms.
const EMPTY_SLOT: u8 = 240;
/// By how much its clock is put forward meanwhile, ms.
const FORWARD: u8 = 24;

impl UnoEngine {
    /// Powers a board that has kept this program, with no card in its slot, and follows its start-up. That takes much
    /// less time than to read a card and to keep what is on it. All else in its EEPROM is as the chip comes.
    ///
    /// # Errors
    /// Where it comes neither to the first scan nor to a fault, or an output moves.
    pub fn start_kept(
        &mut self,
        program: &Program<'_>,
    ) -> Result<Result<(), Refusal>, EngineError> {
        self.analogue = Default::default();
        self.registers = program.registers() as u8;
        let stored = program.stored();
        let head = kept::head(stored.len() as u16);
        let [high, low] = kept::sum(stored).to_be_bytes();
        let all = [&[kept::VALID][..], &head, &[low, high], stored].concat();
        let mut uno = Uno::with_program(self.program.clone(), Slot::Empty)?;
        uno.write_eeprom(kept::MARK, &all)?;
        // It waits for a card by its clock, which no program sees yet.
        for _ in 0..EMPTY_SLOT / FORWARD {
            uno.run_ms(1).map_err(|halt| told(&uno, halt))?;
            let now = uno.read_ram(self.millis, 1)?.first().copied();
            let now = now.unwrap_or_default().saturating_add(FORWARD);
            uno.write_ram(self.millis, &[now])?;
        }
        self.uno = Some(uno);
        self.follow_start()
    }
}
