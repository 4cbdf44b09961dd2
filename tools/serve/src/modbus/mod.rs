//! Modbus TCP: each board of a site is a unit, and a frame has the rights that the site gives to all of them.
//!
//! - `frame`: frames of Modbus TCP, and the same as a board takes them
//! - `rights`: what may be written
//!
//! Readings go to the board as those of who watches. What the site lets write goes there too, while nobody controls the
//! board: a person goes before a machine, which never takes the control itself. Commands, forcing, settings and uploads
//! have no name in a site, so they never pass here.

pub(crate) mod frame;
mod rights;

use crate::gateway::{Gateway, PROMPT};
use crate::orders::may_write;
use crate::slots::{Slot, Slots};
use crate::tokens::Role;
use frame::Head;
use rights::Rights;
use std::io::{self, ErrorKind};
use std::net::{IpAddr, SocketAddr, TcpListener};
use std::sync::Arc;
use std::time::Duration;
use tokio::io::{AsyncReadExt, AsyncWriteExt};
use tokio::net::TcpStream;
use tokio::time::timeout;
use unoclp_modbus::Exception;
use unoclp_modbus::client::Request;
use unoclp_site::Grant;

/// Connections at a time, and of one address. One more takes the place of the one that has been idle longest.
const CONNECTIONS: usize = 64;
const CONNECTIONS_EACH: usize = 32;

/// A Modbus TCP server that is bound to its address.
#[derive(Debug)]
pub struct Modbus {
    listener: TcpListener,
    address: SocketAddr,
    write: Vec<Grant>,
}

/// What every connection is answered from.
pub(crate) struct Units {
    units: Vec<(u8, Arc<Gateway>)>,
    rights: Rights,
}

impl Modbus {
    /// Takes this address, port 0 a free one; lets write what these grants say.
    ///
    /// # Errors
    /// Where it is somebody else's, or none of this PC.
    pub fn bind(address: SocketAddr, write: Vec<Grant>) -> io::Result<Modbus> {
        let listener = TcpListener::bind(address)?;
        listener.set_nonblocking(true)?;
        let address = listener.local_addr()?;
        Ok(Modbus {
            listener,
            address,
            write,
        })
    }

    /// Where it is.
    pub fn address(&self) -> SocketAddr {
        self.address
    }
}

/// Serves these units forever.
///
/// # Errors
/// Where the system takes the address away.
pub(crate) async fn serve(modbus: Modbus, units: Vec<(u8, Arc<Gateway>)>) -> io::Result<()> {
    let listener = tokio::net::TcpListener::from_std(modbus.listener)?;
    let rights = Rights::new(modbus.write);
    let units = Arc::new(Units { units, rights });
    let slots = Slots::new(CONNECTIONS, CONNECTIONS_EACH);
    loop {
        match listener.accept().await {
            Ok((stream, from)) => {
                let slot = slots.take(from.ip());
                let units = units.clone();
                tokio::spawn(async move {
                    tokio::select! {
                        // How a connection has ended is nobody's concern.
                        _ = units.answer_all(stream, from.ip(), &slot) => {}
                        () = slot.is_given_up() => {}
                    }
                });
            }
            // A client that is gone already, or too many open files: the next one may come.
            Err(_) => tokio::time::sleep(Duration::from_millis(10)).await,
        }
    }
}

impl Units {
    /// Answers one request after the other, until the client leaves, is slow, or says what is no frame.
    async fn answer_all(&self, mut stream: TcpStream, from: IpAddr, slot: &Slot) -> io::Result<()> {
        loop {
            let mut head = [0; frame::HEAD];
            let (first, rest) = head.split_at_mut(1);
            // A client may be silent for as long as it likes, but not within a frame.
            stream.read_exact(first).await?;
            timeout(PROMPT, stream.read_exact(rest)).await??;
            let head = Head::of(head).ok_or(ErrorKind::InvalidData)?;
            let mut request = vec![0; head.length];
            timeout(PROMPT, stream.read_exact(&mut request)).await??;
            slot.is_used();
            let answer = head.frame(&self.answer(from, head.unit, &request).await);
            timeout(PROMPT, stream.write_all(&answer)).await??;
        }
    }

    /// The answer to a request, both without unit and checksum.
    async fn answer(&self, from: IpAddr, unit: u8, request: &[u8]) -> Vec<u8> {
        let board = self.units.iter().find(|(of, _)| *of == unit);
        let address = board.map_or(unit, |(_, gateway)| gateway.line.address());
        let Some(request) = frame::to_board(address, request) else {
            // It is longer than any.
            return frame::refusal(request, Exception::IllegalDataValue);
        };
        let reply = match board {
            Some((_, gateway)) => self.ask(from, unit, gateway, request).await,
            None => request.refusal(Exception::GatewayPathUnavailable).to_vec(),
        };
        frame::from_board(&reply)
    }

    async fn ask(&self, from: IpAddr, unit: u8, gateway: &Gateway, request: Request) -> Vec<u8> {
        if request.only_reads() {
            return gateway.line.ask(request, Role::Watch).await;
        }
        let allowed = match self.rights.of(unit, &request) {
            Ok(while_kept) => may_write(gateway, while_kept).await,
            Err(exception) => Err(exception),
        };
        match allowed {
            Ok(()) => {
                let reply = gateway.line.ask(request.clone(), Role::Control).await;
                if matches!(request.answer(&reply), Some(Ok(_))) {
                    gateway.deeds.client(from, &gateway.name, &request);
                }
                reply
            }
            Err(exception) => request.refusal(exception).to_vec(),
        }
    }
}
