//! `unoclp serve`.

use super::Spoken;
use crate::outcome::Outcome;
use clap::Args;
use std::net::SocketAddr;

/// Where the page is served, and which board is shared.
#[derive(Args)]
pub struct Doors {
    /// Where to serve the page; port 0 takes a free one
    #[arg(long, value_name = "ADDRESS:PORT", default_value = "127.0.0.1:8420")]
    http: SocketAddr,
    /// Share the board at this serial port: /dev/ttyACM0, /dev/ttyUSB0, COM3 …
    #[arg(long)]
    port: Option<String>,
    #[command(flatten)]
    spoken: Spoken,
}

/// Serves the page until Ctrl-C, and shares the board if there is one.
#[cfg(feature = "page")]
pub fn serve(doors: Doors) -> Outcome {
    use unoclp_cli::shared::{page, share};
    let Doors { http, port, spoken } = doors;
    let place = port.map(|port| spoken.at(port));
    share(http, place, page)?;
    Ok(true)
}

/// Says how to get the page.
#[cfg(not(feature = "page"))]
pub fn serve(doors: Doors) -> Outcome {
    let Doors { http, port, spoken } = doors;
    // What was asked for waits for a program that has the page.
    drop((http, port.map(|port| spoken.at(port))));
    Err(anyhow::anyhow!(unoclp_cli::messages::no_page()))
}
