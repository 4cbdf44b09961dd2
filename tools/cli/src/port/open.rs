//! Opening the serial port.
//!
//! On a UNO the line DTR of the USB port resets the board when it goes from off to on. Linux and macOS turn
//! it on whenever a port is opened, and off when it is closed, unless the port's HUPCL is cleared. So that is
//! cleared here: the first opening since the board was plugged in may reset it, later ones do not. On
//! Windows DTR stays off.

use super::place::Place;
use crate::messages;
use serialport::{ErrorKind, SerialPort};
use std::io;
use std::time::Duration;
use unoclp_client::Parity;

/// A parity as ports call it.
pub(super) fn parity(parity: Parity) -> serialport::Parity {
    match parity {
        Parity::None => serialport::Parity::None,
        Parity::Even => serialport::Parity::Even,
        Parity::Odd => serialport::Parity::Odd,
    }
}

/// Why a port cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum NotOpened {
    /// There is none of that name.
    #[error("{}", messages::no_port(port, ports(available)))]
    Missing {
        /// The name.
        port: String,
        /// The ports that there are.
        available: Vec<String>,
    },
    /// It is somebody else's.
    #[error("{}", messages::port_denied(port, permission()))]
    Denied {
        /// The name.
        port: String,
    },
    /// Another program has it.
    #[error("{}", messages::port_busy(port))]
    Busy {
        /// The name.
        port: String,
    },
    /// It is something else.
    #[error("{}", messages::no_serial_port(port))]
    NoPort {
        /// The name.
        port: String,
    },
    /// Something else.
    #[error("{}", messages::port_not_opened(port, reason))]
    Other {
        /// The name.
        port: String,
        /// What the system says.
        reason: String,
    },
}

/// Opens the port of a place. Also tells whether that has probably reset a UNO there.
///
/// # Errors
/// Where the port is not there or may not be used.
pub(super) fn open(place: &Place) -> Result<(Box<dyn SerialPort>, bool), NotOpened> {
    let may_reset = keep_dtr(&place.port).map_err(|error| not_opened(&place.port, error))?;
    let port = serialport::new(&place.port, place.line.rate)
        .parity(parity(place.line.parity))
        .timeout(Duration::ZERO)
        .preserve_dtr_on_open()
        .open();
    match port {
        Ok(port) => Ok((port, may_reset)),
        Err(error) => Err(match error.kind() {
            ErrorKind::Io(kind) => not_opened(&place.port, io::Error::new(kind, error.description)),
            // On Unix it has just been there.
            ErrorKind::NoDevice if cfg!(unix) || is_available(&place.port) => NotOpened::Busy {
                port: place.port.clone(),
            },
            ErrorKind::NoDevice => missing(&place.port),
            _ => NotOpened::Other {
                port: place.port.clone(),
                reason: error.description,
            },
        }),
    }
}

fn not_opened(port: &str, error: io::Error) -> NotOpened {
    let port = port.to_owned();
    match error.kind() {
        io::ErrorKind::NotFound => missing(&port),
        io::ErrorKind::PermissionDenied => NotOpened::Denied { port },
        io::ErrorKind::ResourceBusy => NotOpened::Busy { port },
        _ if is_no_terminal(&error) => NotOpened::NoPort { port },
        _ => NotOpened::Other {
            port,
            reason: messages::io(&error),
        },
    }
}

fn missing(port: &str) -> NotOpened {
    NotOpened::Missing {
        port: port.to_owned(),
        available: available(),
    }
}

/// The ports of this PC, as far as it tells.
fn available() -> Vec<String> {
    let ports = serialport::available_ports().unwrap_or_default();
    ports.into_iter().map(|port| port.port_name).collect()
}

fn is_available(port: &str) -> bool {
    available().iter().any(|name| name == port)
}

fn ports(available: &[String]) -> String {
    if available.is_empty() {
        return messages::no_ports();
    }
    messages::ports(available.join(", "))
}

fn permission() -> String {
    if cfg!(target_os = "linux") {
        messages::join_group()
    } else {
        messages::check_who()
    }
}

/// Sees to it that DTR stays on when the port is closed; tells whether it did not before, so that opening
/// it now has turned DTR on.
#[cfg(unix)]
fn keep_dtr(port: &str) -> io::Result<bool> {
    use rustix::fs::{Mode, OFlags};
    use rustix::termios::{ControlModes, OptionalActions, tcgetattr, tcsetattr};
    // Without waiting for a carrier.
    let flags = OFlags::RDWR | OFlags::NOCTTY | OFlags::NONBLOCK | OFlags::CLOEXEC;
    let port = rustix::fs::open(port, flags, Mode::empty())?;
    let mut modes = tcgetattr(&port)?;
    let hangs_up = modes.control_modes.contains(ControlModes::HUPCL);
    if hangs_up {
        modes.control_modes.remove(ControlModes::HUPCL);
        tcsetattr(&port, OptionalActions::Now, &modes)?;
    }
    Ok(hangs_up)
}

#[cfg(not(unix))]
fn keep_dtr(_: &str) -> io::Result<bool> {
    Ok(false)
}

#[cfg(unix)]
fn is_no_terminal(error: &io::Error) -> bool {
    let code = error.raw_os_error();
    code == Some(rustix::io::Errno::NOTTY.raw_os_error())
        || error.kind() == io::ErrorKind::IsADirectory
}

#[cfg(not(unix))]
fn is_no_terminal(_: &io::Error) -> bool {
    false
}
