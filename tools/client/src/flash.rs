//! A firmware for the board at the other end of a line, by its boot loader.

use crate::client::Client;
use crate::event::Event;
use crate::link::Format;
use unoclp_boot::{Failure, Next, Writer};
use unoclp_modbus::map::Parity;

/// Writes a firmware at the rate of the boot loader, which the board is reset for; tells how far it is.
///
/// # Errors
/// Why it is not on the board, and what the board holds.
pub async fn flash(
    client: &mut Client,
    writer: &mut Writer,
    tell: &mut dyn FnMut(Event<'_>),
) -> Result<(), Failure> {
    let usual = client.link().format();
    client.link().speak(Format {
        rate: writer.rate(),
        parity: Parity::None,
    });
    let written = write(client, writer, tell).await;
    client.link().speak(usual);
    written
}

async fn write(
    client: &mut Client,
    writer: &mut Writer,
    tell: &mut dyn FnMut(Event<'_>),
) -> Result<(), Failure> {
    let mut came = Vec::new();
    loop {
        let step = writer.step(client.now(), &came);
        came.clear();
        tell(Event::Flashing(writer.progress()));
        if step.reset {
            client.link().reset();
        }
        if !step.send.is_empty() {
            client.link().send(&step.send);
        }
        match step.next {
            Next::Done(outcome) => return outcome,
            Next::Wait(until) => {
                if let Err(gone) = client.link().receive(&mut came, until).await {
                    writer.lose(gone.0);
                }
            }
        }
    }
}
