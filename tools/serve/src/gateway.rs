//! One visitor's way to the board: a WebSocket, on which each binary message is a Modbus request or its answer, whole.
//!
//! The first message of the visitor is a text, the token, empty where none is asked for. The gateway's texts are JSON:
//! `{"role": "watch", "address": 1, "name": "COM3"}` once the visitor is let in, of a user of the site also who it is and what
//! it may do (`"user": "ana", "may": "operate"`), and `{"board": true}` or `{"board": false, "why": "…"}` then and
//! whenever that changes. A visitor has one request under way at a time.
//!
//! Until its token is seen, a visitor has the slot of a connection; from then on one of the board.

use crate::control::Control;
use crate::deeds::Deeds;
use crate::forcing::forces;
use crate::guard::{Guard, Stays, Who};
use crate::line::Line;
use crate::owner::Presence;
use crate::slots::{Slot, Slots};
use crate::tokens::{Role, Visitor};
use axum::extract::ws::{CloseFrame, Message, WebSocket, close_code};
use serde_json::json;
use std::collections::BTreeMap;
use std::convert::Infallible;
use std::net::IpAddr;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};
use tokio::sync::Notify;
use tokio::time::timeout;
use unoclp_client::diagnostics::{Diagnostics, Kept};
use unoclp_modbus::Exception;
use unoclp_modbus::client::Request;
use unoclp_modbus::map::{State, flag, input};

/// Within this a visitor sends the head of its request and the token, and takes a part of what is sent: a slower one is
/// dropped.
pub(crate) const PROMPT: Duration = Duration::from_secs(5);
/// After so long without a message a visitor is asked for a sign of life,
const QUIET: Duration = Duration::from_secs(20);
/// and dropped after so many that stay without one.
const SIGNS: u32 = 3;
/// The longest message, bytes: no request is longer.
pub(crate) const LONGEST: usize = 256;

/// A board, and what all its visitors share.
#[derive(Debug)]
pub(crate) struct Gateway {
    pub line: Line,
    /// What the board is called.
    pub name: String,
    pub control: Mutex<Control>,
    /// Somebody has forced points, or let them go.
    pub forced: Notify,
    /// Held by who does so.
    pub forcing: tokio::sync::Mutex<()>,
    /// Who is let in.
    pub guard: Guard,
    /// What is done to it is recorded there.
    pub deeds: Arc<Deeds>,
    pub places: Places,
    values: Mutex<Values>,
    condition: Mutex<Option<Condition>>,
}

/// What a board does, as it has told last.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Condition {
    pub state: State,
    /// The number of its fault, and the line, where it is in FAULT; 0: none.
    pub fault: u16,
    pub line: u32,
    pub is_forced: bool,
}

/// What the points of a board were when they were last read; none of a point that is not known any more.
pub(crate) type Values = BTreeMap<String, Option<f64>>;

/// Places for visitors, of all boards together.
#[derive(Clone, Debug)]
pub(crate) struct Places {
    /// For all who have shown a token.
    pub watchers: Slots,
    /// For those alone who may control.
    pub controllers: Slots,
}

/// Why a visitor is no longer served.
enum Left {
    /// By itself, or its connection is gone.
    Gone,
    /// It takes too long.
    Slow,
    /// Its token is none, or it says what is no request.
    Wrong,
    /// There were too many tries from its address.
    Often,
    /// There is no room for it, or its place is another's.
    Full,
}

/// Serves a visitor from this address until it leaves; it has the slot of its connection.
pub(crate) async fn serve(
    gateway: Arc<Gateway>,
    visitor: Visitor,
    address: IpAddr,
    slot: Arc<Slot>,
    mut socket: WebSocket,
) {
    let Err(left) = welcome(&gateway, visitor, address, slot, &mut socket).await;
    gateway.control().leave(visitor);
    let (code, reason) = match left {
        Left::Gone => return,
        Left::Slow => (close_code::POLICY, "too slow"),
        Left::Wrong => (close_code::POLICY, "not allowed"),
        Left::Often => (close_code::AGAIN, "too many tries"),
        Left::Full => (close_code::AGAIN, "too many visitors"),
    };
    let reason = reason.into();
    let close = Message::Close(Some(CloseFrame { code, reason }));
    // Whoever does not take this either is gone.
    drop(timeout(PROMPT, socket.send(close)).await);
}

/// Looks at the token, and serves whoever has a right one.
async fn welcome(
    gateway: &Gateway,
    visitor: Visitor,
    address: IpAddr,
    slot: Arc<Slot>,
    socket: &mut WebSocket,
) -> Result<Infallible, Left> {
    let who = tokio::select! {
        who = who(gateway, address, socket) => who?,
        () = slot.is_given_up() => return Err(Left::Full),
    };
    let seat = gateway.slot(who.role(), address).ok_or(Left::Full)?;
    drop(slot);
    tokio::select! {
        left = visit(gateway, visitor, &who, address, &seat, socket) => left,
        () = seat.is_given_up() => Err(Left::Full),
    }
}

/// Who a visitor is by the token that it sends first.
async fn who(gateway: &Gateway, from: IpAddr, socket: &mut WebSocket) -> Result<Who, Left> {
    match timeout(PROMPT, socket.recv()).await {
        Ok(Some(Ok(Message::Text(token)))) => {
            let who = gateway.guard.who(&token, from).await;
            who.map_err(|stays| match stays {
                Stays::Wrong => Left::Wrong,
                Stays::Often => Left::Often,
            })
        }
        Ok(Some(Ok(_))) => Err(Left::Wrong),
        Ok(_) => Err(Left::Gone),
        Err(_) => Err(Left::Slow),
    }
}

impl Gateway {
    /// A board that nobody visits yet.
    pub fn new(
        line: Line,
        name: String,
        guard: Guard,
        deeds: Arc<Deeds>,
        places: Places,
    ) -> Gateway {
        Gateway {
            line,
            name,
            control: Mutex::default(),
            forced: Notify::new(),
            forcing: tokio::sync::Mutex::default(),
            guard,
            deeds,
            places,
            values: Mutex::default(),
            condition: Mutex::default(),
        }
    }

    pub fn control(&self) -> std::sync::MutexGuard<'_, Control> {
        self.control.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// What its points were when they were last read, where they are read.
    pub fn values(&self) -> std::sync::MutexGuard<'_, Values> {
        self.values.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// What it does, as it has told last.
    pub fn condition(&self) -> std::sync::MutexGuard<'_, Option<Condition>> {
        let condition = self.condition.lock();
        condition.unwrap_or_else(PoisonError::into_inner)
    }

    /// Room for a visitor, if there is some.
    fn slot(&self, role: Role, address: IpAddr) -> Option<Slot> {
        let kept = match role {
            Role::Control => self.places.controllers.ask(address),
            Role::Watch => None,
        };
        kept.or_else(|| self.places.watchers.ask(address))
    }
}

async fn visit(
    gateway: &Gateway,
    visitor: Visitor,
    who: &Who,
    from: IpAddr,
    seat: &Slot,
    socket: &mut WebSocket,
) -> Result<Infallible, Left> {
    say(socket, welcomed(gateway, who)).await?;
    let mut presence = gateway.line.presence();
    let mut signs = 0;
    loop {
        let told = presence.borrow_and_update().clone();
        say(socket, of(&told)).await?;
        loop {
            tokio::select! {
                changed = presence.changed() => match changed {
                    Ok(()) => break,
                    Err(_) => return Err(Left::Gone),
                },
                came = timeout(QUIET, socket.recv()) => match came {
                    Err(_) if signs == SIGNS => return Err(Left::Slow),
                    Err(_) => {
                        signs += 1;
                        send(socket, Message::Ping(Default::default())).await?;
                    }
                    Ok(Some(Ok(Message::Binary(frame)))) => {
                        signs = 0;
                        seat.is_used();
                        let request = Request::forwarded(&frame).ok_or(Left::Wrong)?;
                        let answer = answer(gateway, visitor, who, from, request).await;
                        send(socket, Message::Binary(answer.into())).await?;
                    }
                    Ok(Some(Ok(Message::Ping(_) | Message::Pong(_)))) => signs = 0,
                    Ok(Some(Ok(Message::Text(_)))) => return Err(Left::Wrong),
                    Ok(Some(Ok(Message::Close(_))) | Some(Err(_)) | None) => return Err(Left::Gone),
                },
            }
        }
    }
}

/// The answer to a request: the board's, or why it does not reach it.
async fn answer(
    gateway: &Gateway,
    visitor: Visitor,
    who: &Who,
    from: IpAddr,
    request: Request,
) -> Vec<u8> {
    let role = who.role();
    let forces = role == Role::Control && forces(&request);
    let _turn = match forces {
        true => Some(gateway.forcing.lock().await),
        false => None,
    };
    let address = gateway.line.address();
    let admitted = gateway
        .control()
        .admit(visitor, who.may, &request, address, Instant::now());
    if let Err(exception) = admitted {
        return request.refusal(exception).to_vec();
    }
    if forces {
        // It is looked at once the lock is free.
        gateway.forced.notify_one();
    }
    let reply = gateway.line.ask(request.clone(), role).await;
    if matches!(request.answer(&reply), Some(Ok(_))) {
        gateway.control().done(visitor, &request);
        gateway.deeds.visitor(who, from, &gateway.name, &request);
    }
    reply
}

/// Which program the board keeps. What it does is told too, and noted.
pub(crate) async fn kept_by(gateway: &Gateway) -> Result<Kept, Exception> {
    let (table, first, count) = Diagnostics::asked(input::PROGRAM_SUM);
    let request = Request::read(gateway.line.address(), table, first, count);
    let reply = gateway.line.ask(request.clone(), Role::Control).await;
    let Some(Ok(reply)) = request.answer(&reply) else {
        return Err(Exception::GatewayTargetSilent);
    };
    let words: Vec<u16> = reply.words().collect();
    let told = Diagnostics::of(&words);
    *gateway.condition() = condition(&told);
    Ok(told.program)
}

/// What a board does; none of a state that is not known.
fn condition(board: &Diagnostics) -> Option<Condition> {
    let state = board.state?;
    let trouble = board.trouble.filter(|_| state == State::Fault);
    Some(Condition {
        state,
        fault: trouble.map_or(0, |trouble| trouble.number),
        line: trouble.and_then(|trouble| trouble.line).unwrap_or(0),
        is_forced: board.has(flag::FORCED),
    })
}

/// What a visitor is told once it is let in.
fn welcomed(gateway: &Gateway, who: &Who) -> serde_json::Value {
    let (role, address) = (who.role().name(), gateway.line.address());
    match gateway.guard {
        Guard::Users(_) => json!({
            "role": role, "address": address, "name": gateway.name, "user": &*who.name, "may": who.may.word(),
        }),
        _ => json!({ "role": role, "address": address, "name": gateway.name }),
    }
}

fn of(presence: &Presence) -> serde_json::Value {
    match presence {
        Ok(()) => json!({ "board": true }),
        Err(why) => json!({ "board": false, "why": why }),
    }
}

async fn say(socket: &mut WebSocket, value: serde_json::Value) -> Result<(), Left> {
    send(socket, Message::Text(value.to_string().into())).await
}

async fn send(socket: &mut WebSocket, message: Message) -> Result<(), Left> {
    match timeout(PROMPT, socket.send(message)).await {
        Ok(Ok(())) => Ok(()),
        Ok(Err(_)) => Err(Left::Gone),
        Err(_) => Err(Left::Slow),
    }
}
