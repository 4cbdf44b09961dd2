//! The picture itself is read: power is followed along its wires, and must come to the same cells as acc does.

use std::collections::HashMap;
use unoclp_core::{Board, Image, Loader, Plc};
use unoclp_draw::{Cell, Ladder, Medium, Names, Picture, Style, Symbol};
use unoclp_testing::rounds;

/// Random numbers below a limit: Marsaglia's xorshift.
struct Random(u64);

impl Random {
    fn below(&mut self, limit: u64) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0 % limit
    }
}

/// A rung of contacts of inputs, branches, AND blocks, stores, recalls and coils: all that a wire can do.
fn rung(random: &mut Random) -> Vec<String> {
    let mut codes = Vec::new();
    let (mut depth, mut stored) = (0, Vec::new());
    for _ in 0..random.below(16) {
        match random.below(12) {
            0..6 => {
                let sign = if random.below(2) == 0 { "" } else { "-" };
                codes.push(format!("{sign}82730{}", 1 + random.below(4)));
            }
            6..8 if depth < 8 => {
                depth += 1;
                let block = random.below(4) == 0;
                codes.push(if block { "6540" } else { "40" }.to_owned());
                if random.below(2) == 0 && !stored.is_empty() {
                    let point = stored[random.below(stored.len() as u64) as usize];
                    codes.push(format!("40410{point}"));
                }
            }
            8..10 if depth > 0 => {
                depth -= 1;
                codes.push("41".to_owned());
            }
            10 if !matches!(codes.last().map(String::as_str), Some("40" | "6540")) => {
                let point = 1 + random.below(3);
                stored.push(point);
                codes.push(format!("40410{point}"));
            }
            11 => codes.push(format!("8777{:02}", 1 + random.below(64))),
            _ => {}
        }
    }
    codes.extend((0..depth).map(|_| "41".to_owned()));
    codes.push("877901".to_owned());
    codes
}

#[test]
fn power_flows_in_random_pictures_as_it_does_in_the_scan() {
    let mut random = Random(0x9E37_79B9_7F4A_7C15);
    let (mut named, mut broken) = (0, 0);
    let rungs = rounds(3_000);
    for number in 0..rungs {
        let codes = rung(&mut random);
        let file = format!("0\n{}\n", codes.join("\n"));
        let mut memory = vec![0; 2_000];
        let mut loader = Loader::new(&mut memory, Board::UNO);
        file.bytes().for_each(|byte| loader.push(byte).unwrap());
        let mut plc = Plc::new(loader.finish().unwrap());
        let ladder = Ladder::new(plc.steps());
        let width = if number % 2 == 0 { 200 } else { 56 };
        let style = Style {
            width,
            names: &Names::new(),
            medium: Medium::PLAIN,
        };
        let drawing = ladder.draw(&style);
        let picture = &drawing.rungs[0];
        named += u32::from(picture.to_string().contains('•'));
        broken += u32::from(picture.to_string().contains('→'));
        for inputs in 0..16 {
            let mut flow = vec![None; plc.steps().count()];
            plc.scan_observed(Image(inputs), 0, |step, after| flow[step] = Some(after.acc))
                .unwrap();
            let power = ladder.nets.power(&flow);
            let followed = Wires::new(&ladder, picture).follow(inputs);
            for (row, cells) in picture.rows.iter().enumerate() {
                for (column, cell) in cells.iter().enumerate() {
                    // What is within a symbol is not a wire.
                    if cell.element.is_none() && "─│├┤┬└┘".contains(cell.ch) {
                        let (_, on) = cell.shown(&power);
                        assert_eq!(
                            on,
                            followed[&(row, column)],
                            "row {row}, column {column}, inputs {inputs:04b}\n{picture}\n{file}"
                        );
                    }
                }
            }
        }
    }
    // Both kinds of connections have been met.
    assert!(
        named > rungs / 30 && broken > rungs / 30,
        "{named} {broken}"
    );
}

/// A place in the picture: row and column.
type At = (usize, usize);

/// The wires of a picture.
struct Wires<'w> {
    ladder: &'w Ladder,
    rows: &'w [Vec<Cell>],
}

impl<'w> Wires<'w> {
    fn new(ladder: &'w Ladder, picture: &'w Picture) -> Wires<'w> {
        Wires {
            ladder,
            rows: &picture.rows,
        }
    }

    fn cell(&self, (row, column): At) -> Option<&'w Cell> {
        self.rows.get(row)?.get(column)
    }

    /// Left, right, up, down.
    fn arms(&self, at: At) -> [bool; 4] {
        let last = self.rows[at.0].len() - 1;
        let Some(cell) = self.cell(at).filter(|cell| cell.element.is_none()) else {
            return [false; 4];
        };
        match cell.ch {
            // The right rail leads nothing back.
            '│' | '┤' if at.1 == last => [false; 4],
            '─' => [true, true, false, false],
            '│' => [false, false, true, true],
            '├' => [false, true, true, true],
            '┤' => [true, false, true, true],
            '┬' => [true, true, false, true],
            '└' => [false, true, true, false],
            '┘' => [true, false, true, false],
            _ => [false; 4],
        }
    }

    /// The name that stands here, read to the right or to the left: `a`, `•1`.
    fn name(&self, at: At, towards: isize) -> String {
        let mut name = String::new();
        let mut column = at.1;
        while let Some(cell) = self.cell((at.0, column))
            && cell.element.is_none()
            && !" ─│├┤┬└┘→".contains(cell.ch)
        {
            match towards {
                1.. => name.push(cell.ch),
                _ => name.insert(0, cell.ch),
            }
            column = column.saturating_add_signed(towards);
        }
        name
    }

    /// Which cells carry power, by nothing but the picture and the inputs.
    fn follow(&self, inputs: u128) -> HashMap<At, bool> {
        let mut on: HashMap<At, bool> = HashMap::new();
        for (row, cells) in self.rows.iter().enumerate() {
            for column in 0..cells.len() {
                on.insert((row, column), column == 0);
            }
        }
        let mut names: Vec<String> = Vec::new();
        loop {
            let before = (on.values().filter(|on| **on).count(), names.len());
            for (row, cells) in self.rows.iter().enumerate() {
                for column in 0..cells.len() {
                    self.spread((row, column), inputs, &mut on, &mut names);
                }
            }
            if before == (on.values().filter(|on| **on).count(), names.len()) {
                return on;
            }
        }
    }

    /// Lets power go on from this cell to those around it.
    fn spread(&self, at: At, inputs: u128, on: &mut HashMap<At, bool>, names: &mut Vec<String>) {
        let (row, column) = at;
        let cell = &self.rows[row][column];
        let blank_before = self
            .cell((row, column.wrapping_sub(1)))
            .is_none_or(|cell| cell.ch == ' ');
        // Where a line or path begins.
        let begins = match cell.ch {
            _ if !blank_before || column == 0 || cell.net.is_none() => false,
            '├' => !self.parts(at),
            '•' => names.contains(&self.name(at, 1)),
            'a'..='z' => names.contains(&self.name(at, 1)),
            _ => false,
        };
        if begins {
            on.insert(at, true);
        }
        if !on[&at] {
            return;
        }
        let neighbours = [
            (row, column.wrapping_sub(1)),
            (row, column + 1),
            (row.wrapping_sub(1), column),
            (row + 1, column),
        ];
        // A rail that a path begins with leads nowhere but to the right.
        let start = cell.ch == '├' && blank_before && column > 0 && !self.parts(at);
        for (way, next) in neighbours.into_iter().enumerate() {
            let opposite = [1, 0, 3, 2][way];
            // Power flows to the right, and up and down; never back.
            let leads = self.arms(at)[way] && way > 0 && !(start && way > 1);
            let wired = self.cell(next).is_some() && self.arms(next)[opposite];
            let next_starts = self.cell(next).is_some_and(|cell| cell.ch == '├')
                && way > 1
                && next.1 > 0
                && self
                    .cell((next.0, next.1 - 1))
                    .is_some_and(|cell| cell.ch == ' ' && !self.parts(next));
            if leads && wired && !next_starts {
                on.insert(next, true);
            }
        }
        let Some(next) = self.cell((row, column + 1)) else {
            return;
        };
        match cell.element {
            // Into a name: what is stored or goes on elsewhere has it.
            None if next.element.is_none() && self.arms(at)[1] && next.ch == '→' => {
                names.push(self.name((row, column + 2), 1));
                names.sort();
                names.dedup();
            }
            None if next.element.is_none() && self.arms(at)[1] && next.ch == '•' => {
                names.push(self.name((row, column + 1), 1));
                names.sort();
                names.dedup();
                on.insert((row, column + 1), true);
            }
            // Through a name, to the wire after it.
            None if !" ─│├┤┬└┘".contains(cell.ch)
                && next.element.is_none()
                && next.ch != ' '
                && (self.arms((row, column + 1)) == [false; 4]
                    || self.arms((row, column + 1))[0]) =>
            {
                on.insert((row, column + 1), true);
            }
            // Into a symbol.
            None if self.arms(at)[1] && next.element.is_some() => {
                self.enter((row, column + 1), inputs, on);
            }
            _ => {}
        }
    }

    /// Whether a `├` is one of several joints below each other.
    fn parts(&self, (row, column): At) -> bool {
        let above = self.cell((row.wrapping_sub(1), column));
        above.is_some_and(|cell| "┬├│".contains(cell.ch) && cell.net.is_some())
    }

    /// Power comes to a symbol from the left.
    fn enter(&self, (row, column): At, inputs: u128, on: &mut HashMap<At, bool>) {
        let Some(index) = self.rows[row][column].element else {
            return;
        };
        let mut end = column;
        while self
            .cell((row, end))
            .is_some_and(|cell| cell.element == Some(index))
        {
            end += 1;
        }
        let conducts = match &self.ladder.elements[index].symbol {
            Symbol::Contact { closed, text } => {
                let input: u16 = text[1..].parse().unwrap();
                (inputs >> (input - 1) & 1 != 0) != *closed
            }
            Symbol::Coil { .. } => true,
            // The second input comes from below, at the middle.
            Symbol::Box { .. } => {
                let middle = column + (end - column) / 2;
                on.get(&(row + 1, middle)).copied().unwrap_or(false)
            }
            other => panic!("{other:?}"),
        };
        if conducts && self.cell((row, end)).is_some() && self.arms((row, end))[0] {
            on.insert((row, end), true);
        }
    }
}
