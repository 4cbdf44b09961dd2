//! The thread that reports, and what comes in.

use crate::change::Change;
use crate::connection::{Input, Link, limit};
use crate::plain::Plain;
use crate::session::Session;
use crate::shared::{Carry, Shared, State, Tell, Unready};
use crate::sparkplug::Node;
use crate::tls;
use rumqttc::{MqttOptions, TlsConfiguration, Transport};
use std::io;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread::{self, JoinHandle};
use std::time::{Instant, SystemTime, UNIX_EPOCH};
use tokio::sync::mpsc::{Sender, channel, unbounded_channel};
use unoclp_site::{Mqtt, Site};

/// What waits for the thread: readings of boards. Of more, the newest go, and are counted.
const READINGS: usize = 4_096;

/// The way to the thread. With the last of it the broker is told goodbye.
pub struct Reporter {
    inputs: Vec<Sender<Input>>,
    shared: Vec<Arc<Shared>>,
    dropped: AtomicU64,
    thread: Option<JoinHandle<()>>,
}

impl Reporter {
    /// Begins to report this site, and to take commands. `ca` is what the file of the certificate holds.
    ///
    /// # Errors
    /// [`Unready`].
    pub fn begin(
        site: &Site,
        mqtt: &Mqtt,
        ca: Option<&[u8]>,
        carry: Carry,
        tell: Tell,
    ) -> Result<Reporter, Unready> {
        let mut sessions: Vec<Box<dyn Session>> = vec![Box::new(Plain::new(site, mqtt))];
        if let Some(of) = &mqtt.sparkplug {
            sessions.push(Box::new(Node::new(site, mqtt, of, first_birth())));
        }
        let begin = Instant::now();
        let (mut inputs, mut all_shared, mut links) = (Vec::new(), Vec::new(), Vec::new());
        for session in sessions {
            let (send, receive) = channel(READINGS);
            let (outcome, outcomes) = unbounded_channel();
            // Only one of the connections tells.
            let tell = Some(tell.clone()).filter(|_| inputs.is_empty());
            let shared = Arc::new(Shared::new(tell));
            links.push(Link {
                session,
                options: options(mqtt, ca)?,
                inputs: receive,
                outcomes,
                outcome,
                carry: carry.clone(),
                shared: shared.clone(),
                begin,
            });
            inputs.push(send);
            all_shared.push(shared);
        }
        let runtime = tokio::runtime::Builder::new_current_thread()
            .enable_all()
            .build()
            .map_err(Unready::System)?;
        let thread = thread::Builder::new().name("mqtt".to_owned());
        let thread = thread.spawn(move || {
            runtime.block_on(async {
                let running: Vec<_> = links
                    .into_iter()
                    .map(|link| tokio::spawn(link.run()))
                    .collect();
                for link in running {
                    // One that has failed has said so.
                    let _ = link.await;
                }
            });
        });
        Ok(Reporter {
            inputs,
            shared: all_shared,
            dropped: AtomicU64::new(0),
            thread: Some(thread.map_err(Unready::System)?),
        })
    }

    /// Points of boards have changed.
    pub fn changed(&self, changes: Vec<Change>) {
        let changes: Arc<[Change]> = changes.into();
        for input in &self.inputs {
            if input.try_send(Input::Changed(changes.clone())).is_err() {
                self.dropped
                    .fetch_add(changes.len() as u64, Ordering::Relaxed);
            }
        }
    }

    /// A board is there, or away.
    pub fn presence(&self, board: &str, up: bool) {
        for input in &self.inputs {
            // A thread that does not take it has more to do than it can.
            let _ = input.try_send(Input::Presence(board.to_owned(), up));
        }
    }

    /// How it stands.
    pub fn state(&self) -> State {
        let mut state = State {
            wanted: self.shared.len() as u64,
            dropped: self.dropped.load(Ordering::Relaxed),
            ..State::default()
        };
        for shared in &self.shared {
            let (is_connected, stand) = shared.now();
            state.connected += u64::from(is_connected);
            state.waiting += stand.waiting as u64;
            state.dropped += stand.dropped;
        }
        state
    }
}

impl Drop for Reporter {
    fn drop(&mut self) {
        for input in &self.inputs {
            // Where there is no room for it, the end of the way says the same.
            let _ = input.try_send(Input::Stop);
        }
        self.inputs.clear();
        if let Some(thread) = self.thread.take() {
            // One that has failed has said so.
            let _ = thread.join();
        }
    }
}

fn options(mqtt: &Mqtt, ca: Option<&[u8]>) -> Result<MqttOptions, Unready> {
    let mut random = [0; 8];
    getrandom::fill(&mut random).map_err(|error| Unready::System(io::Error::other(error)))?;
    // Each server takes one of 23 letters.
    let id = format!("unoclp-{:016x}", u64::from_ne_bytes(random));
    let mut options = MqttOptions::new(id, (mqtt.broker.host.clone(), mqtt.broker.port));
    limit(&mut options);
    match (&mqtt.user, &mqtt.password) {
        (Some(user), Some(password)) => {
            options.set_credentials(user, password.0.clone());
        }
        (Some(user), None) => {
            options.set_username(user);
        }
        (None, _) => {}
    }
    if mqtt.broker.tls {
        let config = TlsConfiguration::Rustls(tls::client(ca)?);
        options.set_transport(Transport::Tls(config));
    }
    Ok(options)
}

/// Where births are counted from: after a restart another one than before, since the last death may still come.
fn first_birth() -> u8 {
    let since = SystemTime::now().duration_since(UNIX_EPOCH);
    since.map_or(0, |since| (since.as_secs() % 256) as u8)
}
