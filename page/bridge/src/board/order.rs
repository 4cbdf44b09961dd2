//! What may be ordered of a board.

#[cfg(feature = "full")]
use super::wanted::Wanted;
use crate::given::{Given, wrong};
use crate::program::analysis;
use crate::words::No;
use std::rc::Rc;
use unoclp_workspace::{Analysis, Workspace};

/// What may be ordered of a board.
pub enum Order {
    /// RUN, from the beginning.
    Run,
    /// STOP.
    Stop,
    /// One single scan; in RUN, STOP comes first, and the scan goes on from where the program is.
    Scan,
    /// The whole start-up again.
    Restart,
    /// Force an input or output, from 1, or let it go.
    Force {
        output: bool,
        number: u8,
        to: Option<bool>,
    },
    /// Close the contact of an input, from 1, or open it; of the core alone: a board has contacts of its own.
    Press { input: u8, closed: bool },
    /// Turn the knob of an analogue input, from 0, to a reading; of the core alone.
    Turn { input: u8, reading: u16 },
    /// Let all points go.
    Release,
    /// Set an output, a marker, a register or a preset once.
    Set { point: String, value: i32 },
    /// Put this program on the board, and watch it from then on. It runs then, unless it stays in STOP.
    Upload { text: Rc<Analysis>, stay: bool },
    /// Watch this program from now on; it is said to be on the board.
    Watch { text: Rc<Analysis> },
    /// Read the program that it keeps.
    #[cfg(feature = "full")]
    Fetch,
    /// Read the settings.
    Settings,
    /// Change the settings: the lock holds at once, all else from the next start on.
    #[cfg(feature = "full")]
    Settle { settings: Wanted },
}

impl Order {
    /// As a request gives it.
    ///
    /// # Errors
    /// Where there is no such order, it lacks something, or it takes the module that has everything.
    pub fn of(mut given: Given, workspace: &mut Workspace) -> Result<Order, No> {
        let mut known = |given: &mut Given| {
            let analysis = analysis(given, workspace)?;
            // What is wrong with a program is told when its turn comes.
            analysis.check().ok_or(No::More)?;
            Ok::<_, No>(analysis)
        };
        let what = given.text("do")?;
        Ok(match what.as_str() {
            "run" => Order::Run,
            "stop" => Order::Stop,
            "scan" => Order::Scan,
            "restart" => Order::Restart,
            "release" => Order::Release,
            "settings" => Order::Settings,
            "force" => Order::Force {
                output: given.truth("output")?,
                number: given.number("number")?,
                to: given.truth_if("to")?,
            },
            "press" => Order::Press {
                input: given.number("input")?,
                closed: given.truth("closed")?,
            },
            "turn" => Order::Turn {
                input: given.number("input")?,
                reading: given.number("reading")?,
            },
            "set" => Order::Set {
                point: given.text("point")?,
                value: given.number("value")?,
            },
            "upload" => Order::Upload {
                text: known(&mut given)?,
                stay: given.truth_if("stay")?.unwrap_or_default(),
            },
            "watch" => Order::Watch {
                text: known(&mut given)?,
            },
            #[cfg(not(feature = "full"))]
            "settle" | "fetch" => return Err(No::More),
            #[cfg(feature = "full")]
            "fetch" => Order::Fetch,
            #[cfg(feature = "full")]
            "settle" => Order::Settle {
                settings: Wanted::of(&mut given.below("settings")?)?,
            },
            _ => return Err(wrong(&what).into()),
        })
    }
}
