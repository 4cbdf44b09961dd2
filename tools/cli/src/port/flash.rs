//! A firmware through the boot loader of the board at a port.

use super::{NotOpened, Place, Port};
use crate::messages;
use serialport::ClearBuffer;
use std::ops::ControlFlow;
use std::thread;
use std::time::Duration;
use unoclp_boot::{Failure, Model, Next, Writer};
use unoclp_client::{Line, Parity, Patience};

/// For how long DTR is off: the capacitor between it and the chip's reset charges meanwhile.
const OFF: Duration = Duration::from_millis(100);

impl Port {
    /// Opens the port of a board for its boot loader.
    ///
    /// # Errors
    /// If the port is not there or may not be used.
    pub fn open_for_boot_loader(port: &str, model: Model) -> Result<Port, NotOpened> {
        let line = Line {
            rate: model.rate(),
            parity: Parity::None,
            ..Line::default()
        };
        let port = port.to_owned();
        let (port, _) = Port::open(&Place { port, line }, Patience::default())?;
        Ok(port)
    }

    /// Writes a firmware, attended every 10 ms or sooner, until `attend` breaks it off.
    pub fn flash<B>(
        &mut self,
        writer: &mut Writer,
        mut attend: impl FnMut(&Writer) -> ControlFlow<B>,
    ) -> ControlFlow<B, Result<(), Failure>> {
        let mut came = Vec::new();
        loop {
            attend(writer)?;
            let step = writer.step(self.begun.elapsed(), &came);
            came.clear();
            if step.reset {
                self.reset();
            }
            let carried = match step.next {
                Next::Done(outcome) => return ControlFlow::Continue(outcome),
                Next::Wait(until) => self.carry(&step.send, until, &mut came),
            };
            if let Err(error) = carried {
                writer.lose(messages::io(&error));
            }
        }
    }

    /// Resets the board by DTR and RTS, one of which is wired to do so. A port without them says so, and the board is
    /// then reset by hand: that the boot loader does not answer is told where nobody does.
    fn reset(&mut self) {
        for on in [false, true] {
            let _ = self.port.write_data_terminal_ready(on);
            let _ = self.port.write_request_to_send(on);
            if !on {
                thread::sleep(OFF);
            }
        }
        // Where that fails, so does what comes next.
        let _ = self.port.clear(ClearBuffer::Input);
    }
}
