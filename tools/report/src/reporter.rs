//! The thread that reports, and what comes in.

use crate::alarm::Alarm;
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
use tokio::sync::Notify;
use tokio::sync::mpsc::{Sender, channel, unbounded_channel};
use unoclp_journal::{Journal, Reader};
use unoclp_site::{Mqtt, Site};

/// What waits for the thread: readings of boards. Of more, the newest go, and are counted.
const READINGS: usize = 4_096;

/// Who reads the journal: what is told by topics,
const PLAIN: &str = "mqtt";
/// and over Sparkplug B.
const SPARKPLUG: &str = "sparkplug";

/// The way to the thread. With the last of it the broker is told goodbye.
pub struct Reporter {
    inputs: Vec<Sender<Input>>,
    shared: Vec<Arc<Shared>>,
    readers: Vec<Reader>,
    dropped: AtomicU64,
    thread: Option<JoinHandle<()>>,
}

impl Reporter {
    /// Who reads the journal for this.
    pub fn readers(mqtt: &Mqtt) -> Vec<&'static str> {
        let sparkplug = mqtt.sparkplug.as_ref().map(|_| SPARKPLUG);
        [PLAIN].into_iter().chain(sparkplug).collect()
    }

    /// Begins to report this site, and to take commands. What is told is read from this journal, which has
    /// [`readers`](Self::readers). `ca` is what the file of the certificate holds.
    ///
    /// # Errors
    /// [`Unready`].
    pub fn begin(
        site: &Site,
        mqtt: &Mqtt,
        ca: Option<&[u8]>,
        journal: &Journal,
        carry: Carry,
        tell: Tell,
    ) -> Result<Reporter, Unready> {
        let mut sessions: Vec<(Box<dyn Session>, Reader)> = Vec::new();
        let reader = journal.reader(PLAIN);
        sessions.push((Box::new(Plain::new(site, mqtt, reader.place())), reader));
        if let Some(of) = &mqtt.sparkplug {
            let reader = journal.reader(SPARKPLUG);
            let past = (reader.place(), reader.last());
            let node = Node::new(site, mqtt, of, first_birth(), past);
            sessions.push((Box::new(node), reader));
        }
        let begin = Instant::now();
        let (mut inputs, mut all_shared, mut links) = (Vec::new(), Vec::new(), Vec::new());
        let mut readers = Vec::new();
        for (session, reader) in sessions {
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
                reader: reader.clone(),
                more: listening(&reader),
                begin,
            });
            readers.push(reader);
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
            readers,
            dropped: AtomicU64::new(0),
            thread: Some(thread.map_err(Unready::System)?),
        })
    }

    /// Points of boards have changed; they are put into the journal too.
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

    /// An alarm stands so from now on.
    pub fn alarm(&self, alarm: &Alarm) {
        for input in &self.inputs {
            // A thread that does not take it has more to do than it can.
            let _ = input.try_send(Input::Alarm(Box::new(alarm.clone())));
        }
    }

    /// How it stands.
    pub fn state(&self) -> State {
        let mut state = State {
            wanted: self.shared.len() as u64,
            dropped: self.dropped.load(Ordering::Relaxed),
            ..State::default()
        };
        for (shared, reader) in self.shared.iter().zip(&self.readers) {
            let (is_connected, dropped) = shared.now();
            state.connected += u64::from(is_connected);
            state.waiting += reader.last().saturating_sub(reader.place());
            state.dropped += dropped + reader.dropped();
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

/// Hears when there is more in a journal.
fn listening(reader: &Reader) -> Arc<Notify> {
    let more = Arc::new(Notify::new());
    let heard = more.clone();
    reader.listen(move || heard.notify_one());
    more
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
