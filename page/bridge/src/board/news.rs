//! What a page is told of a board.

use super::watched::Live;
use crate::answer::{answer, spoken};
use crate::facts::numbers;
use crate::words::{Both, both};
use unoclp_client::diagnostics::{self, Diagnostics};
use unoclp_client::map::{State, cause, flag};
use unoclp_client::settings::Settings;
use unoclp_client::watch::{Forces, Meter, Reading};
use unoclp_client::words;

pub(super) use crate::program::Stored as Kept;

spoken! {
    /// What a page is told.
    pub enum News as "News", by "news" {
        /// A board has answered; and which it is, as a request names it, where that is known.
        Found { identity: String, board: Option<&'static str> },
        /// There is no board, or no longer one. It is sought on.
        Lost { why: Both },
        /// All that there is to show.
        Seen(Box<Seen>),
        /// So many bytes of an upload have been sent.
        Sent { order: u32, bytes: usize, of: usize },
        /// The board stores what was uploaded.
        Storing { order: u32 },
        /// So many requests of so many have been answered on the way of a firmware.
        Flashing { order: u32, done: usize, of: usize },
        /// What the board keeps since an upload.
        Stored(Kept),
        /// The program that the board keeps, as numeric code.
        Fetched { order: u32, code: String },
        /// What the board keeps for its next start.
        Settings(Line),
        /// Something ordered was done, and what there is to say of it.
        Done { order: u32, said: Option<Both> },
        /// Something ordered was not done, and why.
        Undone { order: u32, why: Both },
    }
}

answer! {
    /// A reading.
    #[derive(Default)]
    pub struct Seen as "Seen" {
        /// ms since the board's start.
        pub(super) at: u32,
        /// `RUN`, `STOP`, `FAULT`; `EMPTY`: nobody has given it a program yet.
        pub(super) state: &'static str => "\"RUN\" | \"STOP\" | \"FAULT\" | \"EMPTY\" | \"?\"",
        pub(super) switched_off: bool,
        pub(super) card_failed: bool,
        pub(super) fault: Option<Trouble>,
        pub(super) cause: &'static str,
        /// µs: last, least, most.
        pub(super) scan_times: [u16; 3],
        pub(super) free_stack: u16,
        pub(super) supply: u32,
        pub(super) restarts: u16,
        pub(super) faults: u16,
        pub(super) kept: Kept,
        /// Whether the board keeps the program that is watched; none: none is.
        pub(super) same: Option<bool>,
        /// The numbers of those that are 1.
        pub(super) inputs: Vec<u8>,
        pub(super) outputs: Vec<u8>,
        /// Outputs with PWM, and what of 255; those of the core alone, since a line tells none.
        pub(super) dimmed: Vec<(u8, u8)>,
        /// The numbers of those that are forced, and to what.
        pub(super) forced_inputs: Vec<(u8, bool)>,
        pub(super) forced_outputs: Vec<(u8, bool)>,
        /// Seconds without a request that end it; 0, 255: none do.
        pub(super) forcing_ends: Option<u8>,
        /// The numbers of those that are 1.
        pub(super) markers: Vec<u8>,
        pub(super) analogue: Vec<u16>,
        /// From 01 on.
        pub(super) registers: Vec<i32>,
        /// Elapsed and preset, from 01 on.
        pub(super) timers: Vec<[i32; 2]>,
        pub(super) counters: Vec<[i32; 2]>,
        /// None where another program runs than the one that is watched, or none does.
        pub(super) live: Option<Live>,
    }
}

answer! {
    /// A fault.
    pub(super) struct Trouble as "Trouble" {
        number: u16,
        /// Of the text of the program that is watched.
        line: Option<u32>,
        text: Both,
    }
}

impl Trouble {
    /// Of a fault, with its line of the text where that is known.
    pub(super) fn of(fault: diagnostics::Trouble, line: Option<u32>) -> Trouble {
        let line = line.or(fault.line);
        Trouble {
            number: fault.number,
            line,
            text: both(|lang| words::trouble(lang, diagnostics::Trouble { line, ..fault })),
        }
    }
}

impl Seen {
    /// From a reading; `line` is where a fault stands in the text.
    pub fn of(
        reading: &Reading,
        same: Option<bool>,
        line: Option<u32>,
        live: Option<Live>,
    ) -> Seen {
        let board: &Diagnostics = &reading.diagnostics;
        let meters = |meters: &[Meter]| {
            let pair = |meter: &Meter| [meter.value, meter.preset];
            meters.iter().map(pair).collect()
        };
        let trouble = board.trouble.filter(|_| !board.waits_for_program());
        let markers = reading.markers.unwrap_or_default();
        Seen {
            at: board.uptime,
            state: match board.waits_for_program() {
                true => "EMPTY",
                false => board.state.map_or("?", State::name),
            },
            switched_off: board.has(flag::STOP_SWITCH),
            card_failed: board.has(flag::CARD_FAILED),
            fault: trouble.map(|trouble| Trouble::of(trouble, line)),
            cause: cause(board.cause),
            scan_times: board.scan_times,
            free_stack: board.free_stack,
            supply: board.supply,
            restarts: board.restarts,
            faults: board.faults,
            kept: board.program.into(),
            same,
            inputs: numbers(reading.inputs),
            outputs: numbers(reading.outputs),
            dimmed: Vec::new(),
            forced_inputs: forced(reading.forced_inputs),
            forced_outputs: forced(reading.forced_outputs),
            forcing_ends: reading.forcing_ends,
            markers: numbers(markers),
            analogue: reading.analogue.clone(),
            registers: reading.registers.clone(),
            timers: meters(&reading.timers),
            counters: meters(&reading.counters),
            live,
        }
    }
}

/// The points that are forced, and to what.
fn forced(forces: Forces) -> Vec<(u8, bool)> {
    let to = |number: u8| (number, forces.to >> (number - 1) & 1 != 0);
    numbers(forces.points).into_iter().map(to).collect()
}

answer! {
    /// The settings as a page has them.
    #[derive(Clone)]
    pub struct Line as "Settings" {
        pub address: u8,
        pub rate: u32,
        /// 0 none, 1 even, 2 odd.
        pub parity: u16,
        pub direction: bool,
        pub lock: Option<u8>,
    }
}

impl From<Settings> for Line {
    fn from(settings: Settings) -> Line {
        Line {
            address: settings.address,
            rate: settings.rate,
            parity: settings.parity as u16,
            direction: settings.direction,
            lock: settings.lock,
        }
    }
}
