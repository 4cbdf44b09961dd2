//! The gateway lets go what is forced, once whoever forced it is gone.

use crate::forcing::{forced, let_go};
use crate::gateway::Gateway;
use std::sync::Arc;
use std::time::{Duration, Instant};
use tokio::time::sleep_until;
use unoclp_modbus::Exception;

/// How often a board that does not say what is forced is asked again.
const AGAIN: Duration = Duration::from_secs(1);

/// Lets go in time, forever.
pub(crate) async fn attend(gateway: Arc<Gateway>) {
    let mut presence = gateway.line.presence();
    loop {
        let next = step(&gateway).await;
        let wait = async {
            match next {
                Some(next) => sleep_until(next.into()).await,
                None => std::future::pending().await,
            }
        };
        tokio::select! {
            () = wait => {}
            () = gateway.forced.notified() => {}
            changed = presence.changed() => if changed.is_err() { return },
        }
    }
}

/// Lets go if it is time; gives when to look again, if not only when somebody forces or the board comes back.
async fn step(gateway: &Gateway) -> Option<Instant> {
    // Nobody forces meanwhile.
    let _turn = gateway.forcing.lock().await;
    let asked = Instant::now();
    match forced(&gateway.line).await {
        Ok(forced) => {
            let due = gateway.control().forcing.learn(forced, asked)?;
            if Instant::now() < due {
                return Some(due);
            }
            let_go(&gateway.line, forced).await;
        }
        // A board without an end of forcing.
        Err(Exception::IllegalDataAddress) => return None,
        Err(_) => {}
    }
    Some(Instant::now() + AGAIN)
}
