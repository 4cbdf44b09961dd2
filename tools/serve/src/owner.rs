//! The one owner of the line: a thread, which asks the board one request at a time.

use crate::tokens::Role;
use crate::turns::Turns;
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
/// Requests that come while the board answers one; more are refused. Each visitor has one under way, so there is room for
/// all of them.
const QUEUE: usize = 128;

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
    role: Role,
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
        let owner = Owner::new(board, queue, tell);
        thread::spawn(move || owner.run());
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

    /// The answer to a request of somebody with this role: of the board, or why there is none.
    pub(crate) async fn ask(&self, request: Request, role: Role) -> Vec<u8> {
        let busy = request.refusal(Exception::ServerDeviceBusy);
        let silent = request.refusal(Exception::GatewayTargetSilent);
        let (answer, wait) = oneshot::channel();
        let job = Job {
            request,
            role,
            answer,
        };
        match self.jobs.try_send(job) {
            Ok(()) => wait.await.unwrap_or_else(|_| silent.to_vec()),
            Err(_) => busy.to_vec(),
        }
    }
}

/// What the thread has.
struct Owner<B> {
    board: B,
    queue: mpsc::Receiver<Job>,
    turns: Turns<Job>,
    tell: watch::Sender<Presence>,
    /// Answers to requests that only read, and when these were sent.
    fresh: Vec<(Request, Vec<u8>, Instant)>,
}

impl<B: Board> Owner<B> {
    fn new(board: B, queue: mpsc::Receiver<Job>, tell: watch::Sender<Presence>) -> Owner<B> {
        Owner {
            board,
            queue,
            turns: Turns::default(),
            tell,
            fresh: Vec::new(),
        }
    }

    fn run(mut self) {
        loop {
            let gone = match self.board.find() {
                Ok(()) => {
                    self.tell(Ok(()));
                    self.serve()
                }
                Err(why) => Some(why),
            };
            let Some(why) = gone else { return };
            self.tell(Err(why));
            if self.refuse(Instant::now() + AGAIN).is_none() {
                return;
            }
        }
    }

    /// Tells whoever asks until then that nobody is there; `None` once nobody is left who asks.
    fn refuse(&mut self, until: Instant) -> Option<()> {
        loop {
            while let Some(job) = self.turns.next() {
                job.refuse(Exception::GatewayTargetSilent);
            }
            let left = until.saturating_duration_since(Instant::now());
            match self.queue.recv_timeout(left) {
                Ok(job) => self.wait(job),
                Err(RecvTimeoutError::Timeout) => return Some(()),
                Err(RecvTimeoutError::Disconnected) => return None,
            }
        }
    }

    /// Answers until the line is gone, and gives why; `None` once nobody is left who asks.
    fn serve(&mut self) -> Option<String> {
        loop {
            let job = self.next()?;
            match self.answer(&job.request, Instant::now()) {
                // Whoever leaves meanwhile needs no answer.
                Ok(reply) => drop(job.answer.send(reply)),
                Err(NoAnswer::Silent) => job.refuse(Exception::GatewayTargetSilent),
                Err(NoAnswer::Gone(why)) => {
                    job.refuse(Exception::GatewayTargetSilent);
                    return Some(why);
                }
            }
        }
    }

    /// Whose turn it is, of all who have asked by now; `None` once nobody is left who asks.
    fn next(&mut self) -> Option<Job> {
        loop {
            while let Ok(job) = self.queue.try_recv() {
                self.wait(job);
            }
            match self.turns.next() {
                // Whoever has left needs no answer.
                Some(job) if job.answer.is_closed() => {}
                Some(job) => return Some(job),
                None => {
                    let job = self.queue.recv().ok()?;
                    self.wait(job);
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
        let (_, queue) = mpsc::channel();
        let mut owner = Owner::new(Counter(0), queue, watch::channel(Ok(())).0);
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

    /// Says when it is asked something, and answers when it is let.
    struct Gate {
        asked: mpsc::Sender<Vec<u8>>,
        let_go: mpsc::Receiver<()>,
    }

    impl Board for Gate {
        fn find(&mut self) -> Result<(), String> {
            Ok(())
        }

        fn ask(&mut self, request: &Request) -> Result<Vec<u8>, NoAnswer> {
            // After the end of the test nobody is left.
            let _ = self.asked.send(request.bytes().to_vec());
            let _ = self.let_go.recv();
            Ok(Vec::new())
        }
    }

    #[tokio::test]
    async fn at_most_one_reading_goes_before_a_write_whoever_watches() {
        let (asked, asks) = mpsc::channel();
        let (let_go, gate) = mpsc::channel();
        let board = Gate {
            asked,
            let_go: gate,
        };
        let line = Line::begin(board, 1);
        let visit = async |request: Request, role: Role| {
            let line = line.clone();
            tokio::spawn(async move { line.ask(request, role).await });
            // It is in the queue before the next one.
            tokio::task::yield_now().await;
        };
        let watched: Vec<Request> = (0..60)
            .map(|first| Request::read(1, Table::HoldingRegisters, first, 2))
            .collect();
        for request in &watched {
            visit(request.clone(), Role::Watch).await;
        }
        // The board is asked the first one when the others come.
        assert_eq!(asks.recv().unwrap(), watched[0].bytes());
        let own = Request::read(1, Table::Coils, 0, 4);
        let write = Request::write_coil(1, 0, true);
        let stop = Request::write_word(1, 400, 2);
        for request in [&own, &write, &stop] {
            visit(request.clone(), Role::Control).await;
        }
        for expected in [&stop, &write, &own].into_iter().chain(&watched[1..]) {
            let_go.send(()).unwrap();
            assert_eq!(asks.recv().unwrap(), expected.bytes());
        }
    }
}
