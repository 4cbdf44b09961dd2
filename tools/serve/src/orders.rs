//! What others than visitors want, as a broker brings it: values that they write, by a name that the site lists, and alarms
//! that they acknowledge.
//!
//! Owns when such a value goes to its board: while the board keeps the program that gives the name, and while nobody
//! controls it, as with a frame of Modbus TCP. Must not know who has sent it, nor whether the site lets them.

use crate::deeds::BROKER;
use crate::gateway::{Gateway, kept_by};
use crate::tokens::Role;
use std::fmt;
use std::sync::Arc;
use std::time::Instant;
use tokio::sync::mpsc::{Receiver, Sender, channel};
use unoclp_alarm::{Alarms, NotDone, State};
use unoclp_client::diagnostics::Kept;
use unoclp_modbus::client::{NoReply, Request};
use unoclp_modbus::{Exception, Table};
use unoclp_site::Grant;

/// Orders that wait; more are refused.
const WAITING: usize = 64;

/// A value for a point.
pub struct Order {
    /// The point, as the site lets it be written.
    pub grant: Grant,
    /// Its value.
    pub value: f64,
    /// Hears what has become of it.
    pub done: Done,
}

/// Hears what has become of an order.
pub type Done = Box<dyn FnOnce(Result<(), Exception>) + Send>;

/// That an alarm is acknowledged.
pub struct Acknowledgement {
    /// What it is called.
    pub alarm: String,
    /// Hears what has become of it.
    pub done: Box<dyn FnOnce(Result<(), NotDone>) + Send>,
}

/// What waits.
pub(crate) enum Wanted {
    Order(Order),
    Acknowledgement(Acknowledgement),
}

/// The way for orders, and for what acknowledges alarms.
#[derive(Clone, Debug)]
pub struct Orders(Sender<Wanted>);

/// Where they come out.
#[derive(Debug)]
pub struct Ordered(pub(crate) Receiver<Wanted>);

impl fmt::Debug for Order {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (grant, value) = (&self.grant, self.value);
        f.debug_struct("Order")
            .field("grant", grant)
            .field("value", &value)
            .finish_non_exhaustive()
    }
}

impl fmt::Debug for Acknowledgement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Acknowledgement")
            .field("alarm", &self.alarm)
            .finish_non_exhaustive()
    }
}

impl Orders {
    /// A way, and its end.
    pub fn new() -> (Orders, Ordered) {
        let (send, receive) = channel(WAITING);
        (Orders(send), Ordered(receive))
    }

    /// Sends an order on its way. It is refused at once where too many wait.
    pub fn send(&self, order: Order) {
        use tokio::sync::mpsc::error::TrySendError::{Closed, Full};
        match self.0.try_send(Wanted::Order(order)) {
            Err(Full(Wanted::Order(order))) => (order.done)(Err(Exception::ServerDeviceBusy)),
            Err(Closed(Wanted::Order(order))) => (order.done)(Err(Exception::GatewayTargetSilent)),
            _ => {}
        }
    }

    /// Sends an acknowledgement on its way. Where too many wait, it is refused at once.
    pub fn acknowledge(&self, acknowledgement: Acknowledgement) {
        use tokio::sync::mpsc::error::TrySendError::{Closed, Full};
        let sent = self.0.try_send(Wanted::Acknowledgement(acknowledgement));
        if let Err(Full(Wanted::Acknowledgement(of)) | Closed(Wanted::Acknowledgement(of))) = sent {
            (of.done)(Err(NotDone::Ended));
        }
    }
}

/// Does what is wanted, one after the other, for as long as any may come.
pub(crate) async fn attend(
    ordered: Ordered,
    units: Vec<(u8, Arc<Gateway>)>,
    alarms: Option<Arc<Alarms>>,
) {
    let Ordered(mut wanted) = ordered;
    while let Some(wanted) = wanted.recv().await {
        let Order { grant, value, done } = match wanted {
            Wanted::Order(order) => order,
            Wanted::Acknowledgement(Acknowledgement { alarm, done }) => {
                let outcome = acknowledge(alarms.clone(), &alarm, BROKER).await;
                if let (Ok(_), Some((_, gateway))) = (&outcome, units.first()) {
                    gateway.deeds.broker_acknowledged(&alarm);
                }
                done(outcome.map(drop));
                continue;
            }
        };
        let board = units.iter().find(|(unit, _)| *unit == grant.unit);
        done(match board {
            Some((_, gateway)) => {
                let written = write(gateway, &grant, value).await;
                if written.is_ok() {
                    let deeds = &gateway.deeds;
                    deeds.broker(&gateway.name, &grant.point, value);
                }
                written
            }
            None => Err(Exception::GatewayPathUnavailable),
        });
    }
}

/// Acknowledges an alarm. Gives how it stands then.
///
/// # Errors
/// [`NotDone`].
pub(crate) async fn acknowledge(
    alarms: Option<Arc<Alarms>>,
    alarm: &str,
    who: &str,
) -> Result<State, NotDone> {
    let alarms = alarms.ok_or(NotDone::NoAlarm)?;
    let (alarm, who) = (alarm.to_owned(), who.to_owned());
    // The thread that judges may be at another one.
    let done = tokio::task::spawn_blocking(move || alarms.acknowledge(&alarm, &who));
    done.await.unwrap_or(Err(NotDone::Ended))
}

/// Writes a value, if a machine may now.
///
/// # Errors
/// The exception that refuses it.
pub(crate) async fn write(gateway: &Gateway, grant: &Grant, value: f64) -> Result<(), Exception> {
    let request = request(gateway.line.address(), grant, value)?;
    may_write(gateway, grant.while_kept).await?;
    let reply = gateway.line.ask(request.clone(), Role::Control).await;
    match request.answer(&reply) {
        Some(Ok(_)) => Ok(()),
        Some(Err(NoReply::Refused(exception))) => Err(exception),
        Some(Err(NoReply::Garbled)) | None => Err(Exception::GatewayTargetSilent),
    }
}

/// The request that writes a value.
fn request(address: u8, grant: &Grant, value: f64) -> Result<Request, Exception> {
    let wrong = Exception::IllegalDataValue;
    let place = *grant.places.first().ok_or(Exception::IllegalFunction)?;
    let words = grant.kind.words(place, value).ok_or(wrong)?;
    match (place.table, &*words) {
        (Table::Coils, &[bit]) => Ok(Request::write_coil(address, place.first, bit != 0)),
        (Table::HoldingRegisters, words) => {
            Request::write_words(address, place.first, words).ok_or(wrong)
        }

        _ => Err(Exception::IllegalFunction),
    }
}

/// Whether a machine may write now: only while the board keeps this program, and nobody controls it.
///
/// # Errors
/// The exception that refuses it.
pub(crate) async fn may_write(
    gateway: &Gateway,
    while_kept: Option<Kept>,
) -> Result<(), Exception> {
    if let Some(kept) = while_kept
        && kept_by(gateway).await? != kept
    {
        return Err(Exception::ServerDeviceFailure);
    }
    match gateway.control().is_held(Instant::now()) {
        true => Err(Exception::ServerDeviceBusy),
        false => Ok(()),
    }
}
