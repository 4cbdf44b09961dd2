//! What is asked of a history, and what it gives.

/// What a point was, over a time.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Query {
    /// The board.
    pub board: String,
    /// The point.
    pub point: String,
    /// From this moment on, ms since 1970,
    pub from: i64,
    /// and until before this one.
    pub to: i64,
    /// One row for so many ms; 0: each change is one.
    pub step: i64,
    /// At most so many rows, the earliest.
    pub most: usize,
}

/// What a point was, over a step or from a change on.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Where it begins, ms since 1970.
    pub at: i64,
    /// The least value in it; none if the board was away throughout.
    pub least: Option<f64>,
    /// The most.
    pub most: Option<f64>,
    /// What it was at the end; none if the board was away then.
    pub last: Option<f64>,
}

impl Row {
    fn of(at: i64, value: Option<f64>) -> Row {
        Row {
            at,
            least: value,
            most: value,
            last: value,
        }
    }

    /// Takes in a later one.
    pub(crate) fn extend(&mut self, later: &Row) {
        self.least = with(self.least, later.least, f64::min);
        self.most = with(self.most, later.most, f64::max);
        self.last = later.last;
    }

    /// The same, as the first of what begins here.
    fn beginning(self, at: i64) -> Row {
        Row { at, ..self }
    }
}

fn with(one: Option<f64>, other: Option<f64>, choose: fn(f64, f64) -> f64) -> Option<f64> {
    match (one, other) {
        (Some(one), Some(other)) => Some(choose(one, other)),
        (one, other) => one.or(other),
    }
}

/// The answer to a query, as what is found comes.
#[derive(Debug)]
pub(crate) struct Answer<'q> {
    query: &'q Query,
    rows: Vec<Row>,
}

impl<'q> Answer<'q> {
    /// Begins with what the point was before, if that is known.
    pub fn new(query: &'q Query, before: Option<Option<f64>>) -> Answer<'q> {
        let first = before.map(|value| Row::of(query.from, value));
        Answer {
            query,
            rows: first.into_iter().collect(),
        }
    }

    /// Takes in what was found next; false if no more is wanted.
    pub fn take(&mut self, row: Row) -> bool {
        let at = match self.query.step {
            ..=0 => row.at,
            step => self.query.from + (row.at - self.query.from).div_euclid(step) * step,
        };
        let is_full = self.rows.len() >= self.query.most;
        let last = self.rows.last_mut();
        match last.filter(|last| self.query.step > 0 && last.at == at) {
            Some(last) => last.extend(&row),
            None if is_full => return false,
            None => self.rows.push(row.beginning(at)),
        }
        true
    }

    /// All rows.
    pub fn rows(self) -> Vec<Row> {
        self.rows
    }
}
