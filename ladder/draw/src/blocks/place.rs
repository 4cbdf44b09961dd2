//! In which column and row each block of a rung stands, and the ways of the wires.
//!
//! Each wire comes straight from the left in a row of its own, and a block is as high as its inputs lie apart. What several
//! blocks take leads straight to the first of them; to each other one it goes down beside the block that gives it. Outputs
//! stand at the right.

use super::graph::{Graph, Kind};

/// Where the blocks of a rung stand.
pub(crate) struct Placed {
    /// By their vertices.
    pub spots: Vec<Spot>,
    /// How many rows there are.
    pub rows: usize,
    /// The columns, and how many wires go down after each.
    pub columns: Vec<usize>,
}

/// Where a block stands.
#[derive(Clone, Default)]
pub(crate) struct Spot {
    pub column: usize,
    /// Its first row, where it gives what it gives.
    pub row: usize,
    /// How its inputs come, from top to bottom.
    pub routes: Vec<Route>,
    is_placed: bool,
}

/// The way of a wire to an input.
#[derive(Clone, Copy)]
pub(crate) struct Route {
    /// The row in which it comes to the input.
    pub row: usize,
    /// Of one that goes down before: which of those after its column.
    pub down: Option<usize>,
}

impl Spot {
    /// Its last row.
    pub(crate) fn last(&self) -> usize {
        self.routes.last().map_or(self.row, |route| route.row)
    }
}

impl Placed {
    /// `rows` says how many rows the text of a block takes.
    pub(crate) fn of(graph: &Graph<'_>, rows: &dyn Fn(usize) -> usize) -> Placed {
        let mut placed = Placed {
            spots: vec![Spot::default(); graph.vertices.len()],
            rows: 0,
            columns: Vec::new(),
        };
        for (at, vertex) in graph.vertices.iter().enumerate() {
            // What leads to a block has been made before it.
            let before = vertex
                .inputs
                .iter()
                .map(|pin| placed.spots[pin.from].column + 1);
            placed.spots[at].column = before.max().unwrap_or(0);
        }
        let last = placed.spots.iter().map(|spot| spot.column).max();
        placed.columns = vec![0; last.unwrap_or(0) + 1];
        for (spot, vertex) in placed.spots.iter_mut().zip(&graph.vertices) {
            if matches!(vertex.kind, Kind::Output(_) | Kind::Store(_)) {
                spot.column = last.unwrap_or(0);
            }
        }
        for end in &graph.ends {
            placed.place(graph, *end, rows);
        }
        placed
    }

    fn place(&mut self, graph: &Graph<'_>, at: usize, rows: &dyn Fn(usize) -> usize) {
        if std::mem::replace(&mut self.spots[at].is_placed, true) {
            return;
        }
        let mut routes = Vec::new();
        for pin in &graph.vertices[at].inputs {
            if !self.spots[pin.from].is_placed {
                self.place(graph, pin.from, rows);
                let row = self.spots[pin.from].row;
                routes.push(Route { row, down: None });
                continue;
            }
            let column = self.spots[pin.from].column;
            let down = Some(self.columns[column]);
            self.columns[column] += 1;
            let row = self.next(1);
            routes.push(Route { row, down });
        }
        let row = match routes.first() {
            Some(first) => first.row,
            None => self.next(1),
        };
        let spot = &mut self.spots[at];
        (spot.row, spot.routes) = (row, routes);
        // What a long text takes below it stays free.
        let end = row + rows(at);
        self.rows = self.rows.max(end);
    }

    fn next(&mut self, count: usize) -> usize {
        let row = self.rows;
        self.rows += count;
        row
    }
}
