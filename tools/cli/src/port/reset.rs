//! The board at a port, reset for its boot loader.

use super::{NotOpened, Place, Port};
use serialport::ClearBuffer;
use std::thread;
use std::time::Duration;
use unoclp_boot::Model;
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

    /// Resets the board by DTR and RTS, one of which is wired to do so. A port without them says so, and the board is
    /// then reset by hand: that the boot loader does not answer is told where nobody does.
    pub(super) fn reset(&mut self) {
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
