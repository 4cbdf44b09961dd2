//! Random programs of what the board's counters and timers do beside their calls, each as a text in Instruction List
//! and as a tree.

use unoclp_lang::Span;
use unoclp_lang::typed::{
    Base, Binary, Cell, Compare, Convert, Expr, ExprKind, Index, Order, Place, Root, Standard,
    Stmt, StmtKind, Store, Tree, TypeId, Unit, UnitKind, Value,
};
use unoclp_point::Address;
use unoclp_testing::Random;

pub(super) const POINTS: u32 = 4;
const OUTPUTS: u32 = POINTS;
pub(super) const REGISTERS: u32 = 2 * POINTS;
pub(super) const MARKERS: u32 = 3 * POINTS;
const COUNTERS: u32 = 4 * POINTS;
const COUNTER: u32 = Standard::Counter.cells();
const TIMERS: u32 = COUNTERS + 3 * COUNTER;
const TIMER: u32 = Standard::Ton.cells();
const MORE: u32 = TIMERS + 3 * TIMER;
const GROUPS: u32 = MORE + 2 * POINTS;

/// From where a block has its preset.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Preset {
    /// Each call says the same.
    Same(i128),
    /// Each call says one of its own.
    Own,
    /// Each call takes it from a register.
    Register,
    /// Stores say it.
    Stored,
}

pub(super) struct Writer {
    pub random: Random,
    pub text: String,
    pub tree: Tree,
    pub body: Vec<Stmt>,
    presets: [Preset; 3],
    timers: [(Standard, Preset); 3],
    called: [bool; 3],
    /// The constant presets that the calls of each counter give.
    given: [Vec<i128>; 3],
}

pub(super) fn read(cell: u32, base: Base) -> Expr {
    expr(ExprKind::Read(Box::new(place(cell))), base)
}

pub(super) fn expr(kind: ExprKind, base: Base) -> Expr {
    let (ty, at) = (TypeId::of(base), Span::default());
    Expr { kind, base, ty, at }
}

pub(super) fn whole(number: i128, base: Base) -> Expr {
    expr(ExprKind::Constant(Value::Int(number)), base)
}

pub(super) fn place(offset: u32) -> Place {
    Place {
        root: Root::Static,
        offset,
        indices: Vec::new(),
        at: Span::default(),
    }
}

pub(super) fn statement(kind: StmtKind) -> Stmt {
    let at = Span::default();
    Stmt { kind, at }
}

pub(super) fn assign(cell: u32, value: Expr) -> Stmt {
    let base = value.base;
    statement(StmtKind::Assign(place(cell), value, Store::Narrow(base)))
}

fn cells(block: Standard, preset: i128) -> Vec<Cell> {
    let made = block.parts().iter().map(|part| {
        let number = match part.0 {
            "PV" | "PT" => preset,
            "QU" => (preset <= 0).into(),
            "QD" => 1,
            _ => 0,
        };
        cell(part.1, number)
    });
    made.collect()
}

fn cell(base: Base, number: i128) -> Cell {
    Cell {
        base,
        initial: Value::Int(number),
        retain: false,
        scratch: false,
    }
}

impl Writer {
    pub(super) fn new(seed: u64) -> Writer {
        let mut random = Random(seed);
        let mut preset = |most: usize| match random.below(5) {
            0 => Preset::Own,
            1 => Preset::Register,
            2 => Preset::Stored,
            _ => Preset::Same(random.below(most) as i128),
        };
        let presets = [preset(4), preset(4), preset(4)];
        let times = [preset(200), preset(200), preset(200)];
        let kinds = [Standard::Ton, Standard::Tof, Standard::Tp, Standard::Tonr];
        let timers = times.map(|preset| (random.pick(&kinds), preset));
        let mut tree = Tree::default();
        type Point = fn(u8) -> Address;
        let kinds: [(Base, Point); 4] = [
            (Base::Bool, Address::Input),
            (Base::Bool, Address::Output),
            (Base::Dint, Address::Register),
            (Base::Bool, Address::Marker),
        ];
        for (base, point) in kinds {
            for number in 1..=POINTS as u8 {
                tree.points.push((tree.cells.len() as u32, point(number)));
                tree.cells.push(cell(base, 0));
            }
        }
        for counter in 1..=3 {
            let number = tree.cells.len() as u32 + Standard::Counter.number().unwrap();
            tree.points.push((number, Address::Count(counter)));
            tree.cells.extend(cells(Standard::Counter, 0));
        }
        for (block, _) in timers {
            tree.cells.extend(cells(block, 0));
        }
        for point in [Address::Marker, Address::Input] {
            for number in 5..=8 {
                tree.points.push((tree.cells.len() as u32, point(number)));
                tree.cells.push(cell(Base::Bool, 0));
            }
        }
        for point in [Address::Group(1), Address::Inputs(0), Address::Outputs(0)] {
            tree.points.push((tree.cells.len() as u32, point));
            tree.cells.push(cell(Base::Usint, 0));
        }
        let mut text = String::from("VAR\n");
        for (at, (block, _)) in timers.iter().enumerate() {
            text += &format!("t{} : {};\n", at + 1, block.name());
        }
        // So no result of the compiler's own stands in one of these.
        for marker in 1..=8 {
            text += &format!("a{marker} AT M{marker} : BOOL;\n");
        }
        text += "END_VAR\n";
        Writer {
            random,
            text,
            tree,
            body: Vec::new(),
            presets,
            timers,
            called: [false; 3],
            given: Default::default(),
        }
    }

    /// The program, with a call of each timer.
    pub(super) fn finish(mut self) -> (String, Tree) {
        for at in 0..3 {
            if !self.called[at] {
                self.timer(at);
            }
        }
        // A counter begins with the preset that all its calls say.
        for (at, given) in (0..).zip(&self.given) {
            let same = given
                .first()
                .filter(|first| given.iter().all(|one| one == *first));
            let first = counter(at) as usize;
            let cells = cells(Standard::Counter, same.copied().unwrap_or(0));
            self.tree.cells[first..first + cells.len()].clone_from_slice(&cells);
        }
        self.tree.units.push(Unit {
            name: "main".to_owned(),
            kind: UnitKind::Program,
            own: Vec::new(),
            locals: Vec::new(),
            references: 0,
            body: self.body,
            at: Span::default(),
        });
        self.tree.programs.push(0);
        (self.text, self.tree)
    }

    fn line(&mut self, line: String) {
        self.text += &line;
        self.text.push('\n');
    }

    /// A bit that can be read.
    fn bit(&mut self) -> (String, Expr) {
        let number = self.random.below(POINTS as usize) as u32;
        let (name, cell) = match self.random.below(10) {
            0..5 => (format!("I{}", number + 1), number),
            5 => (format!("Q{}", number + 1), OUTPUTS + number),
            6 => (format!("M{}", number + 1), MARKERS + number),
            7 => (format!("C{}.QU", number % 3 + 1), counter(number % 3) + 5),
            8 => (format!("C{}.QD", number % 3 + 1), counter(number % 3) + 6),
            _ => (format!("t{}.Q", number % 3 + 1), timer(number % 3) + 2),
        };
        (name, read(cell, Base::Bool))
    }

    fn register(&mut self) -> (String, u32) {
        let number = self.random.below(POINTS as usize) as u32;
        (format!("D{}", number + 1), REGISTERS + number)
    }

    pub(super) fn instruction(&mut self) {
        match self.random.below(14) {
            0..3 => self.coil(),
            3..6 => self.counter(),
            6 => self.order_counter(),
            7 => self.order_timer(),
            8 => self.count_to_register(),
            9 => self.elapsed(),
            10 => self.add(),
            11 => self.group(),
            12 => self.table(),
            _ => {
                let at = self.random.below(3);
                if !self.called[at] {
                    self.timer(at);
                }
            }
        }
    }

    fn coil(&mut self) {
        let (name, mut value) = self.bit();
        self.line(format!("LD {name}"));
        if self.random.percent(40) {
            let (name, other) = self.bit();
            self.line(format!("AND {name}"));
            let kind = ExprKind::Binary(Binary::And, value.into(), other.into());
            value = expr(kind, Base::Bool);
        }
        let number = self.random.below(POINTS as usize) as u32;
        let (name, cell) = match self.random.percent(50) {
            true => (format!("Q{}", number + 1), OUTPUTS + number),
            false => (format!("M{}", number + 1), MARKERS + number),
        };
        self.line(format!("ST {name}"));
        self.body.push(assign(cell, value));
    }

    fn add(&mut self) {
        let ((from, read_from), (to, cell)) = (self.register(), self.register());
        let by = self.random.below(5) as i128 - 1;
        self.line(format!("LD {from}\nADD {by}\nST {to}"));
        let sum = ExprKind::Binary(
            Binary::Add,
            read(read_from, Base::Dint).into(),
            whole(by, Base::Dint).into(),
        );
        self.body.push(assign(cell, expr(sum, Base::Dint)));
    }

    /// Eight bits as one number, read and stored.
    fn group(&mut self) {
        let (register, cell) = self.register();
        let of = self.random.below(3);
        let name = ["MB1", "IB0", "QB0"][of];
        let group = GROUPS + of as u32;
        if of == 1 || self.random.percent(40) {
            self.line(format!("LD {name}\nST {register}"));
            let read = read(group, Base::Usint);
            let value = expr(ExprKind::Convert(Convert::Keep, read.into()), Base::Dint);
            return self.body.push(assign(cell, value));
        }
        self.line(format!("LD {register}\nST {name}"));
        let read = read(cell, Base::Dint);
        let value = expr(ExprKind::Convert(Convert::Wrap, read.into()), Base::Usint);
        self.body.push(assign(group, value));
    }

    /// All registers as a table.
    fn table(&mut self) {
        let ((subscript, at), (register, cell)) = (self.register(), self.register());
        let mut table = place(REGISTERS);
        table.indices.push(Index {
            subscript: read(at, Base::Dint),
            low: 0,
            count: POINTS,
            stride: 1,
        });
        if self.random.percent(50) {
            self.line(format!("LD {subscript}\nTABLE_LD D1, 4\nST {register}"));
            let value = expr(ExprKind::Read(table.into()), Base::Dint);
            return self.body.push(assign(cell, value));
        }
        self.line(format!(
            "LD {subscript}\nPUSH\nLD {register}\nTABLE_ST D1, 4"
        ));
        let store = Store::Narrow(Base::Dint);
        let kind = StmtKind::Assign(table, read(cell, Base::Dint), store);
        self.body.push(statement(kind));
    }

    fn counter(&mut self) {
        let at = self.random.below(3);
        let first = counter(at as u32);
        let mut given = Vec::new();
        for (part, name) in (0..).zip(["CU", "CD", "R", "LD"]) {
            let needed =
                part == 0 && self.random.percent(80) || part > 0 && self.random.percent(30);
            if needed || part == 1 && given.is_empty() {
                let (bit, value) = self.bit();
                given.push(format!("{name} := {bit}"));
                self.body.push(assign(first + part, value));
            } else if part > 1 {
                // What resets and loads it does so in its own call.
                self.body.push(assign(first + part, whole(0, Base::Bool)));
            }
        }
        let preset = match self.presets[at] {
            Preset::Same(_) | Preset::Own => {
                let own = self.random.below(4) as i128;
                let preset = match self.presets[at] {
                    Preset::Same(preset) => preset,
                    _ => own,
                };
                self.given[at].push(preset);
                Some((preset.to_string(), whole(preset, Base::Dint)))
            }
            Preset::Register => {
                let (name, cell) = self.register();
                Some((name, read(cell, Base::Dint)))
            }
            Preset::Stored => None,
        };
        if let Some((name, value)) = preset {
            given.push(format!("PV := {name}"));
            self.body.push(assign(first + 4, value));
        }
        let call = StmtKind::Standard(Standard::Counter, place(first));
        self.body.push(statement(call));
        self.line(format!("CAL C{} ({})", at + 1, given.join(", ")));
    }

    fn order_counter(&mut self) {
        let at = self.random.below(3);
        let (name, condition) = self.bit();
        let (register, cell) = self.register();
        let number = at + 1;
        let (lines, order, always) = match self.random.below(4) {
            0 => (format!("LD {name}\nR C{number}"), Order::Reset, false),
            1 => (format!("LD {name}\nS C{number}"), Order::Load, false),
            2 if self.presets[at] == Preset::Stored => (
                format!("LD {register}\nST C{number}.PV"),
                Order::Preset(read(cell, Base::Dint)),
                true,
            ),
            _ => (
                format!("LD {register}\nST C{number}.CV"),
                Order::Number(read(cell, Base::Dint)),
                true,
            ),
        };
        self.line(lines);
        let place = place(counter(at as u32));
        let order = statement(StmtKind::Order(order, Standard::Counter, place));
        self.ordered(condition, order, always);
    }

    fn order_timer(&mut self) {
        let at = self.random.below(3);
        let (name, condition) = self.bit();
        let (register, cell) = self.register();
        let number = at + 1;
        let (block, preset) = self.timers[at];
        let stores = preset == Preset::Stored && self.random.percent(50);
        let (lines, order) = match stores {
            true => (
                format!("LD {register}\nST t{number}.PT"),
                Order::Preset(read(cell, Base::Time)),
            ),
            false => (format!("LD {name}\nR t{number}"), Order::Reset),
        };
        self.line(lines);
        let order = statement(StmtKind::Order(order, block, place(timer(at as u32))));
        self.ordered(condition, order, stores);
    }

    fn ordered(&mut self, condition: Expr, order: Stmt, always: bool) {
        self.body.push(match always {
            true => order,
            false => statement(StmtKind::If(vec![(condition, vec![order])], Vec::new())),
        });
    }

    fn count_to_register(&mut self) {
        let at = self.random.below(3) as u32;
        let (register, cell) = self.register();
        self.line(format!("LD C{}.CV\nST {register}", at + 1));
        self.body
            .push(assign(cell, read(counter(at) + 7, Base::Dint)));
    }

    fn elapsed(&mut self) {
        let at = self.random.below(3);
        let (register, cell) = self.register();
        self.line(format!("LD t{}.ET\nST {register}", at + 1));
        let first = timer(at as u32);
        let look = StmtKind::Order(Order::Look, self.timers[at].0, place(first));
        self.body.push(statement(look));
        self.body.push(assign(cell, read(first + 3, Base::Dint)));
    }

    fn timer(&mut self, at: usize) {
        self.called[at] = true;
        let (name, on) = self.bit();
        let (block, preset) = self.timers[at];
        let first = timer(at as u32);
        let word = format!("LD {name}\n{} t{}", block.name(), at + 1);
        self.body.push(assign(first, on));
        let (line, preset) = match preset {
            Preset::Same(preset) => (format!("{word}, {preset}"), Some(whole(preset, Base::Time))),
            Preset::Own | Preset::Register => {
                let (name, cell) = self.register();
                (format!("{word}, {name}"), Some(read(cell, Base::Time)))
            }
            Preset::Stored => (word, None),
        };
        self.line(line);
        self.body
            .extend(preset.map(|preset| assign(first + 1, preset)));
        self.body
            .push(statement(StmtKind::Standard(block, place(first))));
    }

    /// Whether a register is above a number, in an output.
    pub(super) fn above(&mut self) {
        let (register, cell) = self.register();
        self.line(format!("LD {register}\nGT 1\nST Q4"));
        let above = ExprKind::Compare(
            Compare::Greater,
            read(cell, Base::Dint).into(),
            whole(1, Base::Dint).into(),
        );
        self.body.push(assign(OUTPUTS + 3, expr(above, Base::Bool)));
    }
}

fn counter(at: u32) -> u32 {
    COUNTERS + at * COUNTER
}

fn timer(at: u32) -> u32 {
    TIMERS + at * TIMER
}
