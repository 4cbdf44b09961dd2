//! What is shared, and how it is wired: boards with their names and units, who is let in, and places for visitors.

use crate::api::{Metrics, Past};
use crate::deeds::Deeds;
use crate::gateway::{Gateway, Places};
use crate::guard::Guard;
use crate::line::Line;
use crate::modbus::Modbus;
use crate::news::Tell;
use crate::orders::Ordered;
use crate::poll::{Keep, Watched};
use crate::slots::Slots;
use std::sync::Arc;
use unoclp_alarm::Alarms;
use unoclp_client::diagnostics::Kept;
use unoclp_record::Record;
use unoclp_site::Panel;

/// Visitors of the board at a time, and those of one address; more are refused.
const VISITORS: usize = 64;
/// Visitors who may control for whom there is always room.
const CONTROLLERS: usize = 8;
/// Boards that are shared.
pub struct Sharing {
    /// The boards. The first is the one of a page that names none.
    pub boards: Vec<SharedBoard>,
    /// Who may do what.
    pub guard: Guard,
    /// The server that shares them over Modbus TCP, if one does.
    pub modbus: Option<Modbus>,
    /// Values that others write, if any may come.
    pub orders: Option<Ordered>,
    /// The numbers of what follows, for `/metrics`.
    pub metrics: Option<Metrics>,
    /// What points were, if that is kept.
    pub past: Option<Arc<dyn Past>>,
    /// The alarms, if there are some.
    pub alarms: Option<Arc<Alarms>>,
    /// The panels: what is on them may be written by who operates.
    pub panels: Vec<Panel>,
    /// Where it is recorded who does what, if it is.
    pub record: Option<Arc<Record>>,
    /// Who keeps what the points of boards that are watched were, if anybody does.
    pub keep: Option<Keep>,
    /// Who is told what becomes of them, if anybody is.
    pub tell: Option<Tell>,
}

/// A board that is shared.
#[derive(Debug)]
pub struct SharedBoard {
    /// The line to it.
    pub line: Line,
    /// What it is called in the page, and in its address.
    pub name: String,
    /// Its unit in Modbus TCP.
    pub unit: u8,
    /// The program that it shall keep, if one is known.
    pub program: Option<Kept>,
    /// What is read of it again and again.
    pub watched: Option<Watched>,
}

/// A board, and the way to it.
pub(crate) struct Unit {
    pub unit: u8,
    pub gateway: Arc<Gateway>,
    pub program: Option<Kept>,
    pub watched: Option<Watched>,
}

/// Boards whose visitors have their places.
#[derive(Default)]
pub(crate) struct Wired {
    pub boards: Vec<Unit>,
    pub modbus: Option<Modbus>,
    pub orders: Option<Ordered>,
    pub metrics: Option<Metrics>,
    pub past: Option<Arc<dyn Past>>,
    pub alarms: Option<Arc<Alarms>>,
    pub panels: Vec<Panel>,
    pub keep: Option<Keep>,
    pub tell: Option<Tell>,
}

impl Sharing {
    pub(crate) fn wire(self) -> Wired {
        let Sharing {
            boards,
            guard,
            modbus,
            orders,
            metrics,
            past,
            alarms,
            panels,
            record,
            keep,
            tell,
        } = self;
        let deeds = Arc::new(Deeds::new(record));
        let places = Places {
            watchers: Slots::new(VISITORS, VISITORS),
            controllers: Slots::new(CONTROLLERS, CONTROLLERS),
        };
        let unit = |board| {
            let SharedBoard {
                line,
                name,
                unit,
                program,
                watched,
            } = board;
            let gateway = Gateway::new(line, name, guard.clone(), deeds.clone(), places.clone());
            Unit {
                unit,
                gateway: Arc::new(gateway),
                program,
                watched,
            }
        };
        Wired {
            boards: boards.into_iter().map(unit).collect(),
            modbus,
            orders,
            metrics,
            past,
            alarms,
            panels,
            keep,
            tell,
        }
    }
}
