//! What is known of each board: its points, their values, and which names hold.

use crate::change::Change;
use std::collections::BTreeMap;
use unoclp_modbus::map::Width;
use unoclp_site::{Kind, Point, Points, Site};

/// What a point is, since when, and which of all samples said so.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Sample {
    pub value: Option<f64>,
    /// ms since 1970.
    pub at: i64,
    pub number: u64,
}

/// A board.
#[derive(Clone, Debug)]
pub(crate) struct Board {
    pub name: String,
    /// Whether it is there; none as long as nobody has said so.
    pub up: Option<bool>,
    /// What its points are.
    pub values: BTreeMap<String, Sample>,
    /// The points by the names of its program,
    named: Vec<Point>,
    /// by those that every board has,
    own: Vec<Point>,
    /// and whether the former hold; none as long as no value has come.
    holds: Option<bool>,
}

/// The changes of one board.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct News {
    pub board: String,
    pub turn: Turn,
    /// In order.
    pub samples: Vec<(String, Sample)>,
}

/// What a batch of changes has done to a board.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Turn {
    /// It has other points than before.
    pub is_other: bool,
    /// Points that it had, and has no more.
    pub gone: Vec<String>,
}

impl Board {
    fn new(name: &str, points: &Points) -> Board {
        Board {
            name: name.to_owned(),
            up: None,
            values: BTreeMap::new(),
            named: points.recorded(true),
            own: points.recorded(false),
            holds: None,
        }
    }

    /// The points that it has now, none as long as no value has come.
    pub fn points(&self) -> &[Point] {
        match self.holds {
            None => &[],
            Some(true) => &self.named,
            Some(false) => &self.own,
        }
    }

    /// The point of this name, whether the name holds now or not.
    pub fn point(&self, name: &str) -> Option<&Point> {
        let now = self.points().iter();
        let mut all = now.chain(&self.named).chain(&self.own);
        all.find(|point| point.name == name)
    }

    /// Takes the changes of one reading.
    fn take(&mut self, changes: &[(&Change, u64)]) -> Turn {
        for (change, number) in changes {
            let sample = Sample {
                value: change.value,
                at: change.at,
                number: *number,
            };
            self.values.insert(change.point.clone(), sample);
        }
        let is_known = |point: &Point| {
            let mut values = changes.iter().filter(|(change, _)| change.value.is_some());
            values.any(|(change, _)| change.point == point.name)
        };
        // A name that both have says nothing.
        let alone = |of: &[Point], others: &[Point]| {
            let is_there = |point: &Point| others.iter().any(|other| other.name == point.name);
            of.iter().any(|point| is_known(point) && !is_there(point))
        };
        let holds = if alone(&self.named, &self.own) {
            true
        } else if alone(&self.own, &self.named) {
            false
        } else if self.holds.is_none() && self.named.iter().any(is_known) {
            true
        } else {
            return Turn::default();
        };
        if self.holds == Some(holds) {
            return Turn::default();
        }
        let before = self.points().to_vec();
        self.holds = Some(holds);
        let is_gone = |point: &Point| !self.points().iter().any(|now| now.name == point.name);
        let gone = before.into_iter().filter(is_gone).map(|point| point.name);
        let gone: Vec<String> = gone.collect();
        self.values.retain(|name, _| !gone.contains(name));
        Turn {
            is_other: true,
            gone,
        }
    }
}

/// All boards of a site.
#[derive(Clone, Debug)]
pub(crate) struct Boards {
    pub all: Vec<Board>,
}

impl Boards {
    /// Those of this site.
    pub fn new(site: &Site) -> Boards {
        let board = |of: &unoclp_site::Board| Board::new(&of.name, &of.points);
        Boards {
            all: site.boards().map(board).collect(),
        }
    }

    /// The board of this name.
    pub fn of(&self, name: &str) -> Option<&Board> {
        self.all.iter().find(|board| board.name == name)
    }

    /// The same, to change it.
    pub fn of_mut(&mut self, name: &str) -> Option<&mut Board> {
        self.all.iter_mut().find(|board| board.name == name)
    }

    /// Takes changes, each with its number. Gives each board that has some.
    pub fn take<'c>(&mut self, changes: impl Iterator<Item = (&'c Change, u64)>) -> Vec<News> {
        let mut of_boards: Vec<(&str, Vec<(&Change, u64)>)> = Vec::new();
        for (change, number) in changes {
            match of_boards.iter_mut().find(|(name, _)| *name == change.board) {
                Some((_, of)) => of.push((change, number)),
                None => of_boards.push((&change.board, vec![(change, number)])),
            }
        }
        let take = |(name, changes): (&str, Vec<(&Change, u64)>)| {
            let board = self.all.iter_mut().find(|board| board.name == name)?;
            let turn = board.take(&changes);
            let sample = |(change, number): &(&Change, u64)| {
                let sample = Sample {
                    value: change.value,
                    at: change.at,
                    number: *number,
                };
                (change.point.clone(), sample)
            };
            Some(News {
                board: name.to_owned(),
                turn,
                samples: changes.iter().map(sample).collect(),
            })
        };
        of_boards.into_iter().filter_map(take).collect()
    }
}

/// How a point is told to others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Shape {
    /// True or false.
    Bit,
    /// A number without a sign.
    Unsigned,
    /// A number with a sign.
    Signed,
    /// IEEE 754 single.
    Real,
}

/// How this point is told.
pub(crate) fn shape(point: &Point) -> Shape {
    match (point.read.width, point.kind) {
        (Width::Bit, _) => Shape::Bit,
        (_, Kind::Unsigned) => Shape::Unsigned,
        (_, Kind::Signed) => Shape::Signed,
        (_, Kind::Real) => Shape::Real,
    }
}
