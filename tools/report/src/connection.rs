//! A connection to a broker, which comes back by itself.
//!
//! Each connection is a clean session: what a broker has not confirmed is said again from the journal, in order.

use crate::alarm::Alarm;
use crate::change::Change;
use crate::command::{Refusal, Wish};
use crate::session::{Message, Now, Out, Session};
use crate::shared::{Carry, Shared, Trouble};
use rumqttc::{
    AsyncClient, ConnectReturnCode, ConnectionError, Event, EventLoop, Incoming, LastWill,
    MqttOptions, PublishNoticeError, PublishOptions, QoS,
};
use std::collections::VecDeque;
use std::future::{Future, pending};
use std::pin::Pin;
use std::sync::Arc;
use std::time::{Duration, Instant};
use tokio::sync::Notify;
use tokio::sync::mpsc::{Receiver, UnboundedReceiver, UnboundedSender, channel};
use tokio::time::{MissedTickBehavior, interval, sleep, timeout};
use unoclp_journal::{Reader, now};

/// Messages that a broker has not confirmed, at most.
const UNSURE: usize = 64;
/// The longest message that is taken, bytes: a host may set all points of a board at once.
const LONGEST: usize = 64 << 10;
/// A connection is tried again after this, then after twice as long, and so on, up to
const SOON: Duration = Duration::from_millis(500);
/// this.
const LATE: Duration = Duration::from_secs(30);
/// How long a broker has to take a connection, and to take what is said at the end.
const PATIENCE: Duration = Duration::from_secs(10);
const FAREWELL: Duration = Duration::from_secs(2);
const TICK: Duration = Duration::from_millis(500);
/// Entries of the journal that are read at a time.
const ENTRIES: usize = 256;

/// What comes from the gateway.
pub(crate) enum Input {
    Changed(Arc<[Change]>),
    Presence(String, bool),
    Alarm(Box<Alarm>),
    Stop,
}

/// What has become of a wish.
pub(crate) type Outcome = (Wish, Result<(), Refusal>);

/// One session, and the way of all its connections.
pub(crate) struct Link {
    pub session: Box<dyn Session>,
    /// The options of each connection, but for the will.
    pub options: MqttOptions,
    pub inputs: Receiver<Input>,
    pub outcomes: UnboundedReceiver<Outcome>,
    pub outcome: UnboundedSender<Outcome>,
    pub carry: Carry,
    pub shared: Arc<Shared>,
    /// The journal, and who says that there is more in it.
    pub reader: Reader,
    pub more: Arc<Notify>,
    pub begin: Instant,
}

/// Why a connection has ended.
enum End {
    /// It is meant: nothing follows.
    Stop,
    /// Another shall follow at once.
    Leave,
    /// It is lost.
    Lost(Trouble),
}

/// A message on its way, and what tells that the broker has it.
type Unsure = (Message, Pin<Box<dyn Future<Output = bool> + Send>>);

impl Link {
    /// Connects again and again, until it is told to stop.
    pub async fn run(mut self) {
        let mut wait = SOON;
        loop {
            let begun = Instant::now();
            let mut unsure = VecDeque::new();
            let end = self.connection(&mut unsure).await;
            let unsure = unsure.into_iter().map(|(message, _): Unsure| message);
            self.session.lost(unsure.collect());
            self.shared.connected(false);
            match end {
                End::Stop => return,
                End::Leave => continue,
                End::Lost(why) => self.shared.trouble(why),
            }
            // One that has held for long is tried again soon.
            if begun.elapsed() > LATE {
                wait = SOON;
            }
            if self.pause(wait).await {
                return;
            }
            wait = (wait * 2).min(LATE);
        }
    }

    fn now(&self) -> Now {
        Now {
            at: now(),
            since: self.begin.elapsed(),
        }
    }

    /// Takes what comes while there is no connection; true at the end.
    async fn pause(&mut self, time: Duration) -> bool {
        let over = sleep(time);
        tokio::pin!(over);
        loop {
            tokio::select! {
                () = &mut over => return false,
                input = self.inputs.recv() => if self.takes(input) { return true },
                Some((wish, outcome)) = self.outcomes.recv() => {
                    let now = self.now();
                    self.session.done(&wish, outcome, now);
                }
            }
        }
    }

    /// Takes an input; true at the end.
    fn takes(&mut self, input: Option<Input>) -> bool {
        let now = self.now();
        match input {
            Some(Input::Changed(changes)) => self.session.changed(&changes, now),
            Some(Input::Alarm(alarm)) => self.session.alarm(&alarm, now),
            Some(Input::Presence(board, up)) => self.session.presence(&board, up, now),
            Some(Input::Stop) | None => return true,
        }
        self.shared.dropped(self.session.dropped());
        false
    }

    async fn connection(&mut self, unsure: &mut VecDeque<Unsure>) -> End {
        let will = self.session.will();
        let mut options = self.options.clone();
        let qos = qos(&will);
        options.set_last_will(LastWill::new(will.topic, will.payload, qos, will.retain));
        let (client, events) = AsyncClient::builder(options).capacity(2 * UNSURE).build();
        let (send, mut events_come) = channel(UNSURE);
        let polling = poll(events, send);
        tokio::pin!(polling);
        let mut ticks = interval(TICK);
        ticks.set_missed_tick_behavior(MissedTickBehavior::Delay);
        let begin = Instant::now();
        let mut is_connected = false;
        // Whether the polling has ended: it must not be asked again.
        let mut is_over = false;
        loop {
            self.read();
            if is_connected && let Some(end) = self.send(&client, unsure) {
                return match end {
                    End::Leave if !is_over => {
                        leave(&client, polling, unsure, |told| self.is_told(told)).await
                    }
                    other => other,
                };
            }
            self.shared.dropped(self.session.dropped());
            if let Some(number) = self.session.told().filter(|_| unsure.is_empty()) {
                self.reader.take(number.min(self.reader.last()));
            }
            tokio::select! {
                // It ends with the connection, after what has come is taken.
                () = &mut polling, if !is_over => is_over = true,
                event = events_come.recv() => match event {
                    None => return End::Lost(Trouble::Closed),
                    Some(Err(why)) => return End::Lost(why),
                    Some(Ok(Incoming::ConnAck(_))) => {
                        is_connected = true;
                        self.shared.connected(true);
                        let now = self.now();
                        self.session.connected(now);
                    }
                    Some(Ok(Incoming::Publish(publish))) => {
                        let now = self.now();
                        if let Ok(topic) = std::str::from_utf8(&publish.topic) {
                            self.session.heard(topic, &publish.payload, publish.retain, now);
                        }
                    }
                    Some(Ok(_)) => {}
                },
                input = self.inputs.recv() => if self.takes(input) {
                    if is_connected && !is_over {
                        let now = self.now();
                        for message in self.session.farewell(now) {
                            publish(&client, message, unsure);
                        }
                        let end = leave(&client, polling, unsure, |told| self.is_told(told)).await;
                        return match end {
                            End::Leave => End::Stop,
                            other => other,
                        };
                    }
                    return End::Stop;
                },
                Some((wish, outcome)) = self.outcomes.recv() => {
                    let now = self.now();
                    self.session.done(&wish, outcome, now);
                }
                has_it = oldest(unsure) => match has_it {
                    true => self.is_told(unsure.pop_front()),
                    false => return End::Lost(Trouble::Closed),
                },
                () = self.more.notified() => {}
                _ = ticks.tick() => {
                    let now = self.now();
                    self.session.tick(now);
                    if !is_connected && begin.elapsed() > PATIENCE {
                        return End::Lost(Trouble::Slow);
                    }
                }
            }
        }
    }

    /// Reads on in the journal, as far as the session wants.
    fn read(&mut self) {
        while let Some(after) = self.session.wants() {
            let now = self.now();
            let last = self.reader.last();
            let entries = match last > after {
                true => self.reader.read(after, ENTRIES),
                false => Ok(Vec::new()),
            };
            // Who writes the journal says what is wrong with it.
            let Ok(entries) = entries else {
                return;
            };
            self.session.read(&entries, last.max(after), now);
            if entries.is_empty() {
                return;
            }
        }
    }

    /// The broker has this.
    fn is_told(&self, unsure: Option<Unsure>) {
        if let Some(number) = unsure.and_then(|(message, _)| message.number) {
            self.reader.take(number);
        }
    }

    /// Says what the session has to say, as far as there is room; an end, if it wants one.
    fn send(&mut self, client: &AsyncClient, unsure: &mut VecDeque<Unsure>) -> Option<End> {
        while unsure.len() < UNSURE {
            match self.session.next()? {
                Out::Publish(message) => publish(client, message, unsure),
                Out::Subscribe(filter) => {
                    if client.try_subscribe(filter, QoS::AtLeastOnce).is_err() {
                        return Some(End::Lost(Trouble::Closed));
                    }
                }
                Out::Carry(wish) => {
                    let outcome = self.outcome.clone();
                    let of = wish.clone();
                    let done = Box::new(move |result| {
                        // At the end nobody listens.
                        let _ = outcome.send((of, result));
                    });
                    (self.carry)(wish, done);
                }
                Out::Leave => return Some(End::Leave),
            }
        }
        None
    }
}

/// Waits until the broker has all that was said, and says goodbye: no will follows.
async fn leave(
    client: &AsyncClient,
    polling: Pin<&mut impl Future<Output = ()>>,
    unsure: &mut VecDeque<Unsure>,
    is_told: impl Fn(Option<Unsure>),
) -> End {
    let all = async {
        while !unsure.is_empty() && oldest(unsure).await {
            is_told(unsure.pop_front());
        }
        // A broker that is gone needs no goodbye.
        let _ = client.try_disconnect();
        pending().await
    };
    // The polling ends with the connection.
    let both = async {
        tokio::select! {
            () = polling => {}
            () = all => {}
        }
    };
    drop(timeout(FAREWELL, both).await);
    End::Leave
}

/// Polls a connection until it ends. It is never left within a poll, which would begin a new connection.
async fn poll(mut events: EventLoop, to: tokio::sync::mpsc::Sender<Result<Incoming, Trouble>>) {
    loop {
        let event = match events.poll().await {
            Ok(Event::Incoming(event)) => Ok(event),
            Ok(Event::Outgoing(_)) => continue,
            Err(error) => Err(trouble(error)),
        };
        let is_over = event.is_err();
        // Nobody takes events while the connection is left.
        let is_taken = to.send(event).await.is_ok();
        if is_over || !is_taken {
            return;
        }
    }
}

fn publish(client: &AsyncClient, message: Message, unsure: &mut VecDeque<Unsure>) {
    let options = PublishOptions::new(qos(&message)).retain(message.retain);
    let notice =
        client.try_publish_tracked(message.topic.clone(), message.payload.clone(), options);
    let has_it = async move {
        match notice {
            Ok(notice) => {
                let told: Result<(), PublishNoticeError> = notice.wait_completion_async().await;
                told.is_ok()
            }
            Err(_) => false,
        }
    };
    unsure.push_back((message, Box::pin(has_it)));
}

/// Whether the broker has the oldest message on its way, once that is known.
async fn oldest(unsure: &mut VecDeque<Unsure>) -> bool {
    match unsure.front_mut() {
        Some((_, has_it)) => has_it.await,
        None => pending().await,
    }
}

fn qos(message: &Message) -> QoS {
    match message.sure {
        true => QoS::AtLeastOnce,
        false => QoS::AtMostOnce,
    }
}

fn trouble(error: ConnectionError) -> Trouble {
    match error {
        ConnectionError::Io(error) => Trouble::Io(error),
        ConnectionError::Tls(error) => Trouble::Tls(error.to_string()),
        ConnectionError::NetworkTimeout | ConnectionError::FlushTimeout => Trouble::Slow,
        ConnectionError::ConnectionRefused(
            ConnectReturnCode::BadUserNamePassword | ConnectReturnCode::NotAuthorized,
        ) => Trouble::NotAllowed,
        ConnectionError::ConnectionRefused(_) => Trouble::Refused,
        ConnectionError::RequestsDone => Trouble::Closed,
        other => Trouble::Other(other.to_string()),
    }
}

/// What each connection of a session has.
pub(crate) fn limit(options: &mut MqttOptions) {
    options
        .set_keep_alive(15)
        .set_clean_session(true)
        .set_max_packet_size(LONGEST, 4 * LONGEST);
}
