//! The line to a board, as visitors ask through it.

use crate::owner::{Board, Job, Owner, Presence};
use crate::tokens::Role;
use std::sync::mpsc;
use std::thread;
use tokio::sync::{oneshot, watch};
use unoclp_modbus::Exception;
use unoclp_modbus::client::Request;

/// Requests that come while the board answers one; more are refused. Each visitor has one under way, so there is room for
/// all of them.
const QUEUE: usize = 128;

/// The line to a board, to be shared.
#[derive(Clone, Debug)]
pub struct Line {
    jobs: mpsc::SyncSender<Job>,
    presence: watch::Receiver<Presence>,
    address: u8,
}

impl Line {
    /// Begins to look for the board, whose address this is. The thread ends with the last of this line.
    pub fn begin(board: impl Board + 'static, address: u8) -> Line {
        let (jobs, queue) = mpsc::sync_channel(QUEUE);
        let mut owner = Owner::new(board, queue);
        let presence = owner.seat(address);
        thread::spawn(move || owner.run());
        Line {
            jobs,
            presence,
            address,
        }
    }

    /// The same for the boards at these addresses, which share a line: one thread asks all of them.
    pub fn begin_shared(board: impl Board + 'static, addresses: &[u8]) -> Vec<Line> {
        let (jobs, queue) = mpsc::sync_channel(QUEUE.saturating_mul(addresses.len().max(1)));
        let mut owner = Owner::new(board, queue);
        let lines = addresses.iter().map(|&address| Line {
            jobs: jobs.clone(),
            presence: owner.seat(address),
            address,
        });
        let lines = lines.collect();
        thread::spawn(move || owner.run());
        lines
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
