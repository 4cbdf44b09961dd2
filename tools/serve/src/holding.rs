//! Buttons of panels that somebody presses: each is 1 only as long as whoever presses it is heard.
//!
//! Owns how long a button stays pressed without a word, and that it is let go then, however its board is at that moment. Must
//! not know who may press it.

use crate::gateway::Gateway;
use crate::orders;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;
use tokio::sync::Notify;
use tokio::time::{Instant, sleep_until};
use unoclp_modbus::Exception;
use unoclp_site::Grant;

/// How long a button stays pressed without a word.
const ENDS: Duration = Duration::from_secs(3);
/// How often a board that does not take it is told again.
const AGAIN: Duration = Duration::from_secs(1);

/// All buttons that are pressed.
#[derive(Debug, Default)]
pub(crate) struct Holding {
    pressed: Mutex<Vec<Pressed>>,
    changed: Notify,
}

/// A button that is pressed.
#[derive(Clone, Debug)]
struct Pressed {
    gateway: Arc<Gateway>,
    grant: Grant,
    who: Arc<str>,
    /// When it is let go.
    ends: Instant,
    /// It has ended, and its board has not taken it yet.
    is_over: bool,
}

impl Holding {
    /// This button is about to be pressed: it ends though nothing more is heard of it.
    pub fn press(&self, gateway: &Arc<Gateway>, grant: &Grant, who: &Arc<str>) {
        let mut pressed = self.pressed();
        pressed.retain(|of| of.grant != *grant);
        pressed.push(Pressed {
            gateway: gateway.clone(),
            grant: grant.clone(),
            who: who.clone(),
            ends: Instant::now() + ENDS,
            is_over: false,
        });
        self.changed.notify_one();
    }

    /// It is pressed still; false where it is not any more.
    pub fn hear(&self, grant: &Grant) -> bool {
        let mut pressed = self.pressed();
        let of = pressed.iter_mut().find(|of| of.grant == *grant);
        of.is_some_and(|of| {
            let is_in_time = !of.is_over && Instant::now() < of.ends;
            if is_in_time {
                of.ends = Instant::now() + ENDS;
            }
            is_in_time
        })
    }

    /// It is let go.
    pub fn forget(&self, grant: &Grant) {
        self.pressed().retain(|of| of.grant != *grant);
    }

    /// Lets go in time, forever.
    pub async fn attend(&self) {
        loop {
            let next = self.pressed().iter().map(|of| of.ends).min();
            let wait = async {
                match next {
                    Some(next) => sleep_until(next).await,
                    None => std::future::pending().await,
                }
            };
            tokio::select! {
                () = wait => self.let_go(Instant::now()).await,
                () = self.changed.notified() => {}
            }
        }
    }

    /// Lets go all that is pressed, since the gateway ends.
    pub async fn end(&self) {
        let all = self.pressed().iter().map(|of| of.ends).max();
        if let Some(last) = all {
            self.let_go(last).await;
        }
    }

    /// Lets go what ends by then.
    async fn let_go(&self, by: Instant) {
        let due = self
            .pressed()
            .clone()
            .into_iter()
            .filter(|of| of.ends <= by);
        for of in due.collect::<Vec<_>>() {
            let written = orders::write(&of.gateway, &of.grant, 0.0).await;
            if self.is_pressed_again(&of) {
                // Which of the two the board has heard last, nobody knows.
                let _ = orders::write(&of.gateway, &of.grant, 1.0).await;
                continue;
            }
            let mut pressed = self.pressed();
            let Some(at) = pressed.iter().position(|now| now.grant == of.grant) else {
                continue;
            };
            match written {
                Ok(()) => {
                    let deeds = &of.gateway.deeds;
                    deeds.let_go(&of.who, &of.gateway.name, &of.grant.point);
                    pressed.swap_remove(at);
                }
                // The board is away, or somebody controls it: it is told once it can be.
                Err(Exception::GatewayTargetSilent | Exception::ServerDeviceBusy) => {
                    if let Some(now) = pressed.get_mut(at) {
                        (now.ends, now.is_over) = (Instant::now() + AGAIN, true);
                    }
                }
                // The name does not hold any more, so that nothing is pressed by it.
                Err(_) => drop(pressed.swap_remove(at)),
            }
        }
    }

    fn is_pressed_again(&self, before: &Pressed) -> bool {
        let pressed = self.pressed();
        let now = pressed.iter().find(|now| now.grant == before.grant);
        now.is_some_and(|now| now.ends != before.ends)
    }

    fn pressed(&self) -> MutexGuard<'_, Vec<Pressed>> {
        self.pressed.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
