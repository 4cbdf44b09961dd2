//! What the addresses stand for: the tables of `docs/modbus.md`.

/// Coils.
pub mod coil {
    /// Output 01.
    pub const OUTPUTS: u16 = 0;
    /// Marker M 01.
    pub const MARKERS: u16 = 16;
}

/// Discrete inputs.
pub mod discrete {
    /// Input 01.
    pub const INPUTS: u16 = 0;
}

/// Input registers.
pub mod input {
    /// Analogue input A 00.
    pub const ANALOGUE: u16 = 0;
    /// The first register of the diagnostics: those that follow here are read together.
    pub const STATE: u16 = 16;
    /// See [`flag`](super::flag).
    pub const FLAGS: u16 = 17;
    /// The number of the fault.
    pub const FAULT: u16 = 18;
    /// The cause of the start.
    pub const CAUSE: u16 = 19;
    /// The line of the fault, 32 bits.
    pub const LINE: u16 = 20;
    /// ms since the start, 32 bits.
    pub const UPTIME: u16 = 22;
    /// The last scan time, µs; the least and the most follow.
    pub const SCAN_TIME: u16 = 24;
    /// Bytes that the stack has never used.
    pub const FREE_STACK: u16 = 27;
    /// Bytes of the stored form of the program.
    pub const PROGRAM_BYTES: u16 = 28;
    /// The check sum of the program.
    pub const PROGRAM_CRC: u16 = 29;
    /// The reading of the 1.1 V reference.
    pub const SUPPLY: u16 = 30;
    /// Restarts since power-up.
    pub const RESTARTS: u16 = 31;
    /// Faults since power-up; the last register of the diagnostics.
    pub const FAULTS: u16 = 32;
    /// Elapsed time of timer T 01, 32 bits.
    pub const TIMERS: u16 = 128;
    /// Value of counter C 01, 32 bits.
    pub const COUNTERS: u16 = 320;
}

/// Holding registers.
pub mod holding {
    /// Register D 01, 32 bits.
    pub const REGISTERS: u16 = 0;
    /// Preset of timer T 01, 32 bits.
    pub const TIMERS: u16 = 128;
    /// Preset of counter C 01, 32 bits.
    pub const COUNTERS: u16 = 320;
    /// Takes a [`Command`](super::Command).
    pub const COMMAND: u16 = 400;
    /// The inputs that are forced, and behind it to what.
    pub const FORCED_INPUTS: u16 = 402;
    /// The outputs that are forced, and behind it to what.
    pub const FORCED_OUTPUTS: u16 = 404;
    /// The address; rate, parity and direction pin follow.
    pub const SETTINGS: u16 = 410;
    /// The window for blocks of an upload.
    pub const UPLOAD: u16 = 1000;
}

/// Bits of [`input::FLAGS`].
pub mod flag {
    /// A5 is closed.
    pub const STOP_SWITCH: u16 = 1 << 0;
    /// STOP by command.
    pub const STOPPED: u16 = 1 << 1;
    /// Something is forced.
    pub const FORCED: u16 = 1 << 2;
    /// An upload is under way.
    pub const UPLOAD: u16 = 1 << 3;
    /// The card failed.
    pub const CARD_FAILED: u16 = 1 << 4;
}

/// What may be written to [`holding::COMMAND`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u16)]
pub enum Command {
    /// RUN, from the beginning.
    Run = 1,
    /// STOP; ends an upload.
    Stop = 2,
    /// One single scan, in STOP.
    Scan = 3,
    /// The whole start-up anew.
    Restart = 4,
    /// Begin an upload.
    Upload = 5,
}

/// What a board does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum State {
    /// It scans.
    Run,
    /// It does not; all outputs are off.
    Stop,
    /// It shows a fault; all outputs are off.
    Fault,
}

impl State {
    /// The state of a value of [`input::STATE`]. A later firmware's would be none of these.
    pub const fn of(word: u16) -> Option<State> {
        match word {
            1 => Some(State::Run),
            2 => Some(State::Stop),
            3 => Some(State::Fault),
            _ => None,
        }
    }

    /// The state's name.
    pub const fn name(self) -> &'static str {
        match self {
            State::Run => "RUN",
            State::Stop => "STOP",
            State::Fault => "FAULT",
        }
    }
}

/// The cause of a start ([`input::CAUSE`]) in words.
pub const fn cause(word: u16) -> &'static str {
    match word {
        1 => "power",
        2 => "reset",
        3 => "watchdog",
        4 => "no reset",
        5 => "command",
        _ => "unknown",
    }
}

/// The number that two words hold, the high one first.
pub const fn number(high: u16, low: u16) -> u32 {
    (high as u32) << 16 | low as u32
}

/// The most text that a block of an upload holds, bytes.
pub const BLOCK_BYTES: usize = 244;

#[cfg(test)]
mod tests {
    use super::*;

    const PAGE: &str = include_str!("../../docs/modbus.md");

    /// The rows of the table under this heading, cell by cell.
    fn table(heading: &str) -> Vec<Vec<String>> {
        let section = PAGE.split(&format!("\n## {heading}\n")).nth(1).unwrap();
        let section = section.split("\n## ").next().unwrap();
        let rows = section.lines().filter(|line| line.starts_with('|'));
        let cells = |row: &str| -> Vec<String> {
            let cells = row.trim_matches('|').split('|');
            cells.map(|cell| cell.trim().to_owned()).collect()
        };
        rows.map(cells).collect()
    }

    /// The row of the table under this heading that begins with this address or range.
    fn row(heading: &str, addresses: &str) -> String {
        let rows = table(heading);
        let found = rows.iter().find(|row| row[0] == addresses);
        found
            .unwrap_or_else(|| panic!("{heading} has no {addresses}"))
            .join(" ")
    }

    #[test]
    fn the_page_has_these_addresses() {
        let coils = "Coils and discrete inputs";
        let inputs = "Input registers";
        let holdings = "Holding registers";
        let list = |first: u16, count: u16| {
            let all: Vec<String> = (first..first + count).map(|at| at.to_string()).collect();
            all.join(", ")
        };
        let range = |first: u16, count: u16| format!("{first}–{}", first + count - 1);
        use input as i;
        for (heading, addresses, text) in [
            (coils, range(coil::OUTPUTS, 4), "output 01–04"),
            (coils, range(coil::MARKERS, 64), "marker M 01–64"),
            (coils, range(discrete::INPUTS, 8), "input 01–08"),
            (inputs, range(i::ANALOGUE, 5), "analogue input A 00–04"),
            (inputs, list(i::STATE, 1), "state"),
            (inputs, list(i::FLAGS, 1), "bits"),
            (inputs, list(i::FAULT, 1), "number of the fault"),
            (inputs, list(i::CAUSE, 1), "cause of the start"),
            (inputs, list(i::LINE, 2), "line of the fault"),
            (inputs, list(i::UPTIME, 2), "uptime"),
            (
                inputs,
                list(i::SCAN_TIME, 3),
                "scan time: last, least, most",
            ),
            (inputs, list(i::FREE_STACK, 1), "free stack"),
            (inputs, list(i::PROGRAM_BYTES, 1), "bytes of the program"),
            (inputs, list(i::PROGRAM_CRC, 1), "its check sum"),
            (inputs, list(i::SUPPLY, 1), "supply"),
            (inputs, list(i::RESTARTS, 2), "restarts, faults"),
            (inputs, range(i::TIMERS, 2 * 87), "timer T 01–87: elapsed"),
            (inputs, range(i::COUNTERS, 2 * 16), "counter C 01–16: value"),
            (holdings, range(holding::REGISTERS, 64), "register D 01–32"),
            (
                holdings,
                range(holding::TIMERS, 2 * 87),
                "timer T 01–87: preset",
            ),
            (
                holdings,
                range(holding::COUNTERS, 2 * 16),
                "counter C 01–16: preset",
            ),
            (holdings, list(holding::COMMAND, 1), "command"),
            (holdings, list(holding::FORCED_INPUTS, 1), "inputs forced"),
            (holdings, list(holding::FORCED_INPUTS + 1, 1), "to what"),
            (holdings, list(holding::FORCED_OUTPUTS, 1), "outputs forced"),
            (holdings, list(holding::FORCED_OUTPUTS + 1, 1), "to what"),
            (holdings, range(holding::SETTINGS, 4), "settings"),
            (holdings, range(holding::UPLOAD, 123), "upload"),
        ] {
            let row = row(heading, &addresses);
            assert!(row.contains(text), "{row:?} is not {text:?}");
        }
        assert_eq!(input::FAULTS, input::RESTARTS + 1);
    }

    #[test]
    fn the_page_has_these_values() {
        let row = |heading, first: &str| row(heading, first);
        let states = row("Input registers", "16");
        for word in 1..=3 {
            let state = State::of(word).unwrap();
            assert!(states.contains(&format!("{word} {}", state.name())));
        }
        assert_eq!((State::of(0), State::of(4)), (None, None));

        let bits = row("Input registers", "17");
        for (flag, text) in [
            (flag::STOP_SWITCH, "A5 is closed"),
            (flag::STOPPED, "STOP by command"),
            (flag::FORCED, "something is forced"),
            (flag::UPLOAD, "an upload is under way"),
            (flag::CARD_FAILED, "the card failed"),
        ] {
            let bit = flag.trailing_zeros();
            assert!(bits.contains(&format!("{bit}: {text}")), "{bits}");
        }

        let causes = row("Input registers", "19");
        for (word, text) in [(1, "power"), (2, "reset"), (3, "watchdog"), (5, "command")] {
            assert_eq!(cause(word), text);
            assert!(causes.contains(&format!("{word} {text}")), "{causes}");
        }

        for (command, text) in [
            (Command::Run, "RUN"),
            (Command::Stop, "STOP"),
            (Command::Scan, "one single scan"),
            (Command::Restart, "restart"),
            (Command::Upload, "begin an upload"),
        ] {
            let row = row("RUN, STOP and commands", &(command as u16).to_string());
            assert!(row.contains(text), "{row}");
        }
        assert!(PAGE.contains(&format!("1 to {BLOCK_BYTES}; the text follows")));
    }
}
