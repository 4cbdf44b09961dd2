//! The one owner of the line: a thread, which asks the board one request at a time.

use std::sync::mpsc::{self, RecvTimeoutError};
use std::thread;
use std::time::{Duration, Instant};
use tokio::sync::{oneshot, watch};
use unoclp_modbus::Exception;
use unoclp_modbus::client::Request;

/// How long an answer serves others who ask the same: then twenty who watch cost the board what one does.
const FRESH: Duration = Duration::from_millis(50);
/// How often a board that is away is looked for.
const AGAIN: Duration = Duration::from_secs(1);
/// Requests that wait; more are refused.
const QUEUE: usize = 64;

/// The board, as whoever has its port lends it.
pub trait Board: Send {
    /// Opens the line and finds the board.
    ///
    /// # Errors
    /// Why it is not there, for people.
    fn find(&mut self) -> Result<(), String>;

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

/// The line to a board, to be shared.
#[derive(Clone, Debug)]
pub struct Line {
    jobs: mpsc::SyncSender<Job>,
    presence: watch::Receiver<Presence>,
    address: u8,
}

/// A request, and where its answer goes.
#[derive(Debug)]
struct Job {
    request: Request,
    answer: oneshot::Sender<Vec<u8>>,
}

impl Job {
    fn refuse(self, exception: Exception) {
        let refusal = self.request.refusal(exception).to_vec();
        // Whoever has left is not told.
        drop(self.answer.send(refusal));
    }
}

impl Line {
    /// Begins to look for the board, whose address this is. The thread ends with the last of this line.
    pub fn begin(board: impl Board + 'static, address: u8) -> Line {
        let (jobs, queue) = mpsc::sync_channel(QUEUE);
        let (tell, presence) = watch::channel(Err(String::new()));
        let owner = Owner {
            board,
            tell,
            fresh: Vec::new(),
        };
        thread::spawn(move || owner.run(&queue));
        Line {
            jobs,
            presence,
            address,
        }
    }

    /// The board's address.
    pub(crate) fn address(&self) -> u8 {
        self.address
    }

    /// Whether the board is there, as it changes.
    pub(crate) fn presence(&self) -> watch::Receiver<Presence> {
        self.presence.clone()
    }

    /// The answer to a request: of the board, or why there is none.
    pub(crate) async fn ask(&self, request: Request) -> Vec<u8> {
        let busy = request.refusal(Exception::ServerDeviceBusy);
        let silent = request.refusal(Exception::GatewayTargetSilent);
        let (answer, wait) = oneshot::channel();
        match self.jobs.try_send(Job { request, answer }) {
            Ok(()) => wait.await.unwrap_or_else(|_| silent.to_vec()),
            Err(_) => busy.to_vec(),
        }
    }
}

/// What the thread has.
struct Owner<B> {
    board: B,
    tell: watch::Sender<Presence>,
    /// Answers to requests that only read, and when these were sent.
    fresh: Vec<(Request, Vec<u8>, Instant)>,
}

impl<B: Board> Owner<B> {
    fn run(mut self, queue: &mpsc::Receiver<Job>) {
        loop {
            let gone = match self.board.find() {
                Ok(()) => {
                    self.tell(Ok(()));
                    self.serve(queue)
                }
                Err(why) => Some(why),
            };
            let Some(why) = gone else { return };
            self.tell(Err(why));
            if Owner::<B>::refuse(queue, Instant::now() + AGAIN).is_none() {
                return;
            }
        }
    }

    /// Tells whoever asks until then that nobody is there; `None` once nobody is left who asks.
    fn refuse(queue: &mpsc::Receiver<Job>, until: Instant) -> Option<()> {
        loop {
            match queue.recv_timeout(until.saturating_duration_since(Instant::now())) {
                Ok(job) => job.refuse(Exception::GatewayTargetSilent),
                Err(RecvTimeoutError::Timeout) => return Some(()),
                Err(RecvTimeoutError::Disconnected) => return None,
            }
        }
    }

    /// Answers until the line is gone, and gives why; `None` once nobody is left who asks.
    fn serve(&mut self, queue: &mpsc::Receiver<Job>) -> Option<String> {
        loop {
            let job = queue.recv().ok()?;
            // Whoever has left needs no answer.
            if job.answer.is_closed() {
                continue;
            }
            match self.answer(&job.request, Instant::now()) {
                // Whoever leaves meanwhile needs none either.
                Ok(reply) => drop(job.answer.send(reply)),
                Err(NoAnswer::Silent) => job.refuse(Exception::GatewayTargetSilent),
                Err(NoAnswer::Gone(why)) => {
                    job.refuse(Exception::GatewayTargetSilent);
                    return Some(why);
                }
            }
        }
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

    fn tell(&self, presence: Presence) {
        self.tell.send_if_modified(|told| {
            let changes = *told != presence;
            *told = presence;
            changes
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use unoclp_modbus::Table;

    /// Counts what it is asked, and answers with the count.
    struct Counter(u8);

    impl Board for Counter {
        fn find(&mut self) -> Result<(), String> {
            Ok(())
        }

        fn ask(&mut self, _: &Request) -> Result<Vec<u8>, NoAnswer> {
            self.0 += 1;
            Ok(vec![self.0])
        }
    }

    #[test]
    fn what_many_ask_at_once_the_board_is_asked_once() {
        let mut owner = Owner {
            board: Counter(0),
            tell: watch::channel(Ok(())).0,
            fresh: Vec::new(),
        };
        let begin = Instant::now();
        let coils = Request::read(1, Table::Coils, 0, 4);
        let inputs = Request::read(1, Table::DiscreteInputs, 0, 4);
        let stop = Request::write_word(1, 400, 2);
        for (request, after, expected) in [
            (&coils, 0, 1),
            (&coils, 49, 1),
            (&inputs, 49, 2),
            (&coils, 50, 3),
            (&inputs, 60, 2),
            (&stop, 61, 4),
            (&stop, 62, 5),
            (&coils, 63, 6),
            (&inputs, 64, 7),
        ] {
            let now = begin + Duration::from_millis(after);
            assert_eq!(
                owner.answer(request, now),
                Ok(vec![expected]),
                "after {after} ms"
            );
        }
    }
}
