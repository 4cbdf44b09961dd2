//! `unoclp serve`.

use super::Spoken;
use crate::outcome::Outcome;
use clap::Args;
use std::net::SocketAddr;
use std::path::PathBuf;

/// Where the page is served, and which boards are shared.
#[derive(Args)]
pub struct Doors {
    /// Where to serve the page; port 0 selects a free one
    #[arg(long, value_name = "ADDRESS:PORT", default_value = "127.0.0.1:8420")]
    http: SocketAddr,
    /// Share the board at this serial port: /dev/ttyACM0, /dev/ttyUSB0, COM3 …
    #[arg(long)]
    port: Option<String>,
    /// Show the exercises and machines of this folder on the page too
    #[arg(long, value_name = "FOLDER")]
    exercises: Option<PathBuf>,
    /// Share the boards of this site file
    #[arg(long, value_name = "SITE.toml", conflicts_with_all = ["http", "port", "address", "rate", "parity"])]
    site: Option<PathBuf>,
    #[command(flatten)]
    spoken: Spoken,
}

/// Serves the page until Ctrl-C, and shares the boards if there are some.
#[cfg(feature = "page")]
pub fn serve(doors: Doors) -> Outcome {
    use crate::own::Own;
    use crate::shared::{page, share, share_site};
    use crate::site_file;
    let Doors {
        http,
        port,
        exercises,
        site,
        spoken,
    } = doors;
    let open = |folder: &std::path::Path| Own::open(folder, unoclp_client::AT_A_LINE);
    let own = exercises.as_deref().map(open).transpose()?;
    let page = move |path: &str| {
        let file = page(path)?;
        Some(match &own {
            Some(own) => own.among(path, file),
            None => file,
        })
    };
    let Some(path) = site else {
        let place = port.map(|port| spoken.at(port));
        share(http, place, page)?;
        return Ok(true);
    };
    match site_file::open(&path)? {
        Ok(site) => {
            share_site(&path, &site, page)?;
            Ok(true)
        }
        Err(mistakes) => {
            for mistake in mistakes {
                anstream::eprintln!("{mistake}");
            }
            Ok(false)
        }
    }
}

/// Says how to get the page.
#[cfg(not(feature = "page"))]
pub fn serve(doors: Doors) -> Outcome {
    let Doors {
        http,
        port,
        exercises,
        site,
        spoken,
    } = doors;
    // What was asked for waits for a program that has the page.
    drop((http, port.map(|port| spoken.at(port)), exercises, site));
    Err(anyhow::anyhow!(crate::messages::no_page()))
}
