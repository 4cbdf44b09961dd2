//! The one owner of a line: a thread, which asks its boards one request at a time.

use crate::tokens::Role;
use crate::turns::Turns;
use std::sync::mpsc::{self, RecvTimeoutError};
use std::time::{Duration, Instant};
use tokio::sync::{oneshot, watch};
use unoclp_modbus::Exception;
use unoclp_modbus::client::Request;

/// How long an answer serves others who ask the same: then twenty who watch cost the board what one does.
const FRESH: Duration = Duration::from_millis(50);
/// How often a board that is away is looked for.
const AGAIN: Duration = Duration::from_secs(1);
/// The longest time for which it is not looked for where others are at its line, who wait meanwhile: it doubles up to this.
const RARELY: Duration = Duration::from_secs(32);
/// So many requests without an answer, one after another, and a board counts as away.
const SILENT: u32 = 3;

/// The line to a board, or to several, as whoever has its port lends it.
pub trait Board: Send {
    /// Finds the board of this address. A line that is open stays so, because opening it could reset the board.
    ///
    /// # Errors
    /// Why it is not there, for people.
    fn find(&mut self, address: u8) -> Result<(), String>;

    /// Sends a request, and gives the whole frame that answers it.
    ///
    /// # Errors
    /// [`NoAnswer`].
    fn ask(&mut self, request: &Request) -> Result<Vec<u8>, NoAnswer>;
}

/// Why there is no answer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NoAnswer {
    /// None came that is one.
    Silent,
    /// The line is gone, and why.
    Gone(String),
}

/// Whether the board is there; else why not.
pub(crate) type Presence = Result<(), String>;

/// A request, and where its answer goes.
#[derive(Debug)]
pub(crate) struct Job {
    pub request: Request,
    pub role: Role,
    pub answer: oneshot::Sender<Vec<u8>>,
}

impl Job {
    fn refuse(self, exception: Exception) {
        let refusal = self.request.refusal(exception).to_vec();
        // Whoever has left is not told.
        drop(self.answer.send(refusal));
    }
}

/// A board of the line.
struct Seat {
    address: u8,
    tell: watch::Sender<Presence>,
    /// When it is looked for; none while it is there.
    away: Option<Instant>,
    /// How long it is left alone when it is not found.
    pause: Duration,
    /// Requests that it has not answered, one after another.
    silent: u32,
}

/// What the thread has.
pub(crate) struct Owner<B> {
    board: B,
    queue: mpsc::Receiver<Job>,
    turns: Turns<Job>,
    seats: Vec<Seat>,
    /// Answers to requests that only read, and when these were sent.
    fresh: Vec<(Request, Vec<u8>, Instant)>,
}

impl<B: Board> Owner<B> {
    pub fn new(board: B, queue: mpsc::Receiver<Job>) -> Owner<B> {
        Owner {
            board,
            queue,
            turns: Turns::default(),
            seats: Vec::new(),
            fresh: Vec::new(),
        }
    }

    /// One more board, and whether it is there, as it changes.
    pub fn seat(&mut self, address: u8) -> watch::Receiver<Presence> {
        let (tell, presence) = watch::channel(Err(String::new()));
        self.seats.push(Seat {
            address,
            tell,
            away: Some(Instant::now()),
            pause: AGAIN,
            silent: 0,
        });
        presence
    }

    /// Serves until nobody is left who asks.
    pub fn run(mut self) {
        loop {
            self.look(Instant::now());
            let due = self.seats.iter().filter_map(|seat| seat.away).min();
            let Some(next) = self.next(due) else { return };
            if let Some(job) = next {
                self.serve(job);
            }
        }
    }

    /// Looks for one of the boards that are away, where it is time; the others wait until then.
    fn look(&mut self, now: Instant) {
        let is_due = |seat: &Seat| seat.away.is_some_and(|due| due <= now);
        let away = self
            .seats
            .iter()
            .enumerate()
            .filter(|(_, seat)| is_due(seat));
        let Some((index, _)) = away.min_by_key(|(_, seat)| seat.away) else {
            return;
        };
        let others = self.seats.iter().any(|seat| seat.away.is_none());
        let found = self.board.find(self.seats[index].address);
        let seat = &mut self.seats[index];
        if found.is_ok() {
            (seat.away, seat.pause, seat.silent) = (None, AGAIN, 0);
        } else {
            seat.away = Some(Instant::now() + seat.pause);
            seat.pause = match others {
                true => (seat.pause * 2).min(RARELY),
                false => AGAIN,
            };
        }
        seat.tell(found);
    }

    fn serve(&mut self, job: Job) {
        let address = job.request.server();
        let seat = |of: &&mut Seat| of.address == address;
        let is_there = self
            .seats
            .iter_mut()
            .find(seat)
            .is_some_and(|seat| seat.away.is_none());
        if !is_there {
            return job.refuse(Exception::GatewayTargetSilent);
        }
        let answered = self.answer(&job.request, Instant::now());
        match answered {
            Ok(reply) => {
                self.hear(address, true);
                // Whoever leaves meanwhile needs no answer.
                drop(job.answer.send(reply));
            }
            Err(NoAnswer::Silent) => {
                self.hear(address, false);
                job.refuse(Exception::GatewayTargetSilent);
            }
            Err(NoAnswer::Gone(why)) => {
                job.refuse(Exception::GatewayTargetSilent);
                for seat in &mut self.seats {
                    seat.away = Some(Instant::now() + AGAIN);
                    seat.tell(Err(why.clone()));
                }
            }
        }
    }

    /// This board has answered, or not. One that stays silent is away; it would keep the others of its line waiting.
    fn hear(&mut self, address: u8, answers: bool) {
        let Some(seat) = self.seats.iter_mut().find(|seat| seat.address == address) else {
            return;
        };
        seat.silent = if answers { 0 } else { seat.silent + 1 };
        if seat.silent >= SILENT {
            // Why, it tells once it is looked for.
            seat.away = Some(Instant::now());
        }
    }

    /// Whose turn it is, of all who have asked by now; nobody's where nobody asks until then. `None` once nobody is left
    /// who asks.
    fn next(&mut self, until: Option<Instant>) -> Option<Option<Job>> {
        loop {
            while let Ok(job) = self.queue.try_recv() {
                self.wait(job);
            }
            match self.turns.next() {
                // Whoever has left needs no answer.
                Some(job) if job.answer.is_closed() => {}
                Some(job) => return Some(Some(job)),
                None => {
                    let came = match until {
                        None => self
                            .queue
                            .recv()
                            .map_err(|_| RecvTimeoutError::Disconnected),
                        Some(until) => {
                            let left = until.saturating_duration_since(Instant::now());
                            self.queue.recv_timeout(left)
                        }
                    };
                    match came {
                        Ok(job) => self.wait(job),
                        Err(RecvTimeoutError::Timeout) => return Some(None),
                        Err(RecvTimeoutError::Disconnected) => return None,
                    }
                }
            }
        }
    }

    fn wait(&mut self, job: Job) {
        let request = job.request.clone();
        self.turns.wait(&request, job.role, job);
    }

    fn answer(&mut self, request: &Request, now: Instant) -> Result<Vec<u8>, NoAnswer> {
        self.fresh.retain(|(_, _, came)| now - *came < FRESH);
        if let Some((_, reply, _)) = self.fresh.iter().find(|(asked, _, _)| asked == request) {
            return Ok(reply.clone());
        }
        let reply = self.board.ask(request)?;
        if request.only_reads() {
            self.fresh.push((request.clone(), reply.clone(), now));
        } else {
            // What was read before may be so no longer.
            self.fresh.clear();
        }
        Ok(reply)
    }
}

impl Seat {
    fn tell(&self, presence: Presence) {
        self.tell.send_if_modified(|told| {
            let changes = *told != presence;
            *told = presence;
            changes
        });
    }
}

#[cfg(test)]
mod tests;
