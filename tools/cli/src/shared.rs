//! The page inside this program, and the board at a serial port as the gateway takes it.

use crate::messages;
use crate::port::{Found, Place, Port, find};
use anyhow::{Context, anyhow};
use rust_embed::RustEmbed;
use std::borrow::Cow;
use std::net::SocketAddr;
use std::time::Duration;
use unoclp_client::{Failure, Patience};
use unoclp_modbus::client::Request;
use unoclp_serve::{Board, Line, NoAnswer, Pages, Server, Sharing, Tokens};

/// What `cargo xtask lab --build` has built.
#[derive(RustEmbed)]
#[folder = "../../target/lab/page"]
struct Files;

/// A file of the page.
pub fn page(path: &str) -> Option<Cow<'static, [u8]>> {
    Files::get(path).map(|file| file.data)
}

/// Serves the page at this address, and shares the board at this place, until the program ends. Says where.
///
/// # Errors
/// Where the address cannot be served from.
pub fn share(http: SocketAddr, place: Option<Place>, pages: Pages) -> anyhow::Result<()> {
    let wrong = |error| anyhow!(messages::not_served(http, messages::io(&error)));
    let server = Server::bind(http).map_err(wrong)?;
    let page = format!("http://{}/", server.address());
    // By the fragment the page knows that there is a board behind it.
    let board = if place.is_some() && server.is_local() {
        "#board"
    } else {
        ""
    };
    println!("{page}{board}");
    let sharing = match place {
        None => None,
        Some(place) => {
            let tokens = match server.is_local() {
                true => None,
                false => Some(Tokens::random().context("getrandom")?),
            };
            match &tokens {
                None => println!("{}", messages::shared(&place.port)),
                Some(Tokens { watch, control }) => {
                    let with = |token| format!("{page}#board={token}");
                    println!("{}", messages::watch_at(with(watch)));
                    println!("{}", messages::control_at(with(control)));
                    println!("{}", messages::open_to_network());
                }
            }
            let address = place.line.address;
            let name = place.port.clone();
            let board = AtPort { place, port: None };
            Some(Sharing {
                line: Line::begin(board, address),
                name,
                tokens,
            })
        }
    };
    server.run(pages, sharing).map_err(wrong)
}

/// How long an answer is waited for that a visitor has asked for. A visitor asks again, so it is sent once.
const PATIENCE: Patience = Patience {
    answer: Duration::from_secs(1),
    attempts: 1,
    start: Duration::from_secs(8),
    store: Duration::from_secs(8),
};

/// The board at a serial port.
struct AtPort {
    place: Place,
    port: Option<Port>,
}

impl Board for AtPort {
    fn find(&mut self) -> Result<(), String> {
        self.port = None;
        let Found { port, .. } = find(&self.place, PATIENCE).map_err(|why| why.to_string())?;
        self.port = Some(port);
        Ok(())
    }

    fn ask(&mut self, request: &Request) -> Result<Vec<u8>, NoAnswer> {
        let Some(port) = &mut self.port else {
            return Err(NoAnswer::Silent);
        };
        let answered = port.talk(async |client| {
            // Storing a program takes longer than any answer to a question.
            match request.only_reads() {
                true => client.forward(request).await,
                false => client.forward_within(PATIENCE.store, request).await,
            }
        });
        answered.map_err(|failure| match failure {
            Failure::Lost(why) => NoAnswer::Gone(messages::port_gone(why)),
            _ => NoAnswer::Silent,
        })
    }
}
