//! Which wires carry power: each is a net, whose state follows from acc after the steps of a scan.

/// A net of a ladder: all wires of it carry power together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Net(u32);

impl Net {
    /// Its number among the nets of its ladder, by which a drawing can name it.
    pub const fn number(self) -> u32 {
        self.0
    }
}

/// Where the power of a net comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Feed {
    /// The left rail: power in every scan.
    Rail,
    /// acc after this step.
    Step(usize),
    /// Both nets at once: an element that stands after the first, and whose own condition is the second.
    Both(Net, Net),
    /// Either net, or both: paths that join.
    Either(Net, Net),
}

/// The nets of a ladder. Each is made of nets before it, so one pass tells the state of all.
#[derive(Clone, Debug)]
pub struct Nets(Vec<Feed>);

impl Nets {
    /// The net that never lacks power while the program runs.
    pub(crate) const RAIL: Net = Net(0);

    pub(crate) fn new() -> Nets {
        Nets(vec![Feed::Rail])
    }

    pub(crate) fn add(&mut self, source: Feed) -> Net {
        self.0.push(source);
        Net(self.0.len() as u32 - 1)
    }

    /// How many there are beside that of the rail.
    pub(crate) fn own(&self) -> u32 {
        self.0.len() as u32 - 1
    }

    /// Which nets carry power after a scan: `flow` is acc after each step of the program, none for steps
    /// that were not run, and empty before the first scan.
    pub fn power(&self, flow: &[Option<bool>]) -> Power {
        let mut power = Power(Vec::with_capacity(self.0.len()));
        for source in &self.0 {
            power.0.push(match *source {
                Feed::Rail => !flow.is_empty(),
                Feed::Step(step) => flow.get(step).copied().flatten().unwrap_or(false),
                Feed::Both(one, other) => power.at(one) && power.at(other),
                Feed::Either(one, other) => power.at(one) || power.at(other),
            });
        }
        power
    }
}

/// Which nets carry power.
#[derive(Clone, Debug, Default)]
pub struct Power(Vec<bool>);

impl Power {
    /// The numbers of those that do, in rising order.
    pub fn on(&self) -> impl Iterator<Item = u32> {
        let nets = (0..).zip(&self.0);
        nets.filter_map(|(number, on)| on.then_some(number))
    }

    /// Whether this net does.
    pub fn at(&self, net: Net) -> bool {
        self.0.get(net.0 as usize).copied().unwrap_or(false)
    }
}
