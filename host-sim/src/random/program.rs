//! The instructions of a random program.

use super::stream::Random;
use unoclp_core::isa::{self, Class, Kind, Opcode, Operand, Value};
use unoclp_core::{Board, Instruction, KEPT, Target, TimerBlock};

/// A rung, with the new rung that begins it.
type Rung = Vec<Instruction<'static>>;

/// Rungs that take about as many bytes as the board has, or fewer. They name timers and labels that are
/// still to be found: see [`resolve`].
pub(super) fn random_rungs(random: &mut Random, board: Board) -> Vec<Rung> {
    // As many programs of about 10 bytes as of 100 or of 1000, and on a larger board of what fills it.
    let larger = if board.engine.links && board.linked_bytes > 4_000 {
        3
    } else {
        0
    };
    let magnitude = random.below(9 + larger);
    let size = random.below(4 << magnitude) as usize;
    let mut draft = Draft {
        size: size.min(board.linked_bytes.into()),
        analogue: some(random, board.analogue),
        pwm: some(random, board.outputs) & board.pwm.0,
        old: random.percent(20),
        random,
        board,
        rung: Rung::new(),
        taken: 0,
        depth: 0,
        points: Vec::new(),
        timers: 0,
        pushed: 0,
        ifs: Vec::new(),
        registers: board.engine.near_registers,
    };
    // Seldom: they take much of run memory.
    if draft.random.percent(8) {
        draft.registers = draft
            .random
            .number(board.engine.near_registers, isa::REGISTERS);
    }
    let mut rungs = Vec::new();
    // A program may begin without a new rung.
    let mut begins = draft.random.percent(80);
    while draft.taken + 1 < draft.size {
        let bracket = draft.bracket();
        // At the head of a program, and after a bracket, a rung needs no code to begin it.
        if begins && !bracket {
            draft.put(Instruction::plain(Opcode::NewRung));
        }
        draft.rung();
        begins = !draft.begin_if() || draft.random.percent(30);
        rungs.push(std::mem::take(&mut draft.rung));
    }
    rungs
}

/// Some of so many points, a bit for each.
fn some(random: &mut Random, count: u8) -> u128 {
    match 1_u32.checked_shl(count.into()) {
        Some(bits) => random.below(bits).into(),
        None => {
            let all = u128::from(random.bits()) << 64 | u128::from(random.bits());
            all & ((1 << count) - 1)
        }
    }
}

/// Has timers call one of their kind that stands before them again (NC-30).
fn call_again(random: &mut Random, instructions: &mut [Instruction<'static>]) {
    let mut before: Vec<Opcode> = Vec::new();
    for step in instructions {
        let Operand::Timer(block) = &mut step.operand else {
            continue;
        };
        let own = (1..=isa::CALLED_AGAIN).zip(&before);
        let alike = own.filter(|(_, kind)| **kind == step.opcode);
        let alike: Vec<u8> = alike.map(|(number, _)| number).collect();
        match random.pick(&alike) {
            Some(number) if random.percent(50) => block.target = Target::Timer(number),
            _ => before.push(step.opcode),
        }
    }
}

/// The instructions of these rungs, in which every timer and label that is named exists. Most jumps lead
/// forward, and in most programs all do.
pub(super) fn resolve(
    random: &mut Random,
    rungs: &[Rung],
    board: Board,
) -> Vec<Instruction<'static>> {
    let mut instructions = kept(random, board);
    instructions.extend(rungs.concat());
    // Of rungs that were dropped an END may be missing.
    let count = |opcode| {
        instructions
            .iter()
            .filter(|step| step.opcode == opcode)
            .count()
    };
    for _ in count(Opcode::EndIf)..count(Opcode::If) {
        instructions.push(Instruction::plain(Opcode::EndIf));
    }
    if random.percent(30) {
        call_again(random, &mut instructions);
    }
    let timers = instructions.iter().filter(|step| step.is_own_timer());
    let timers = timers.count().min(board.timers.into()) as u8;
    // Each label once: the first of its number stays.
    let mut labels: Vec<(usize, u8)> = Vec::new();
    let mut defined = Vec::new();
    instructions.retain(|step| match step.number() {
        Some(label) if step.opcode == Opcode::Label => {
            let new = !defined.contains(&label);
            defined.push(label);
            new
        }
        _ => true,
    });
    for (at, step) in instructions.iter().enumerate() {
        labels.extend(
            step.number()
                .filter(|_| step.opcode == Opcode::Label)
                .map(|label| (at, label)),
        );
    }
    let back = random.percent(20);
    for (at, step) in instructions.iter_mut().enumerate() {
        let not = Instruction::plain(Opcode::Not);
        match (step.opcode.row().kind, step.number()) {
            (Kind::TimerQ, Some(number)) => {
                *step = match timers {
                    0 => not,
                    _ => Instruction::numbered(step.opcode, number % timers + 1),
                };
            }
            (Kind::Jump, Some(number)) => {
                let ahead = labels.iter().filter(|(place, _)| *place > at);
                let mut choice: Vec<u8> = ahead.map(|(_, label)| *label).collect();
                // Those that loop have named their own label, which is before them.
                let own = labels
                    .iter()
                    .any(|&(place, label)| place < at && label == number);
                if own && (back && random.percent(10) || is_loop(number)) {
                    choice = vec![number];
                }
                *step = match random.pick(&choice) {
                    Some(label) => jump(step.opcode, label),
                    None => not,
                };
            }
            _ => {}
        }
    }
    instructions
}

/// What a program keeps, at its head: in most programs nothing (NC-21).
fn kept(random: &mut Random, board: Board) -> Vec<Instruction<'static>> {
    let mut kept = Vec::new();
    while kept.len() < KEPT.into() && random.percent(20) {
        let step = match random.percent(50) {
            true => Instruction::numbered(Opcode::KeepRegister, kept_register(random, board)),
            false => Instruction::numbered(Opcode::KeepCounter, random.number(1, board.counters)),
        };
        if !kept.contains(&step) {
            kept.push(step);
        }
    }
    kept
}

fn kept_register(random: &mut Random, board: Board) -> u8 {
    let last = match random.percent(3) {
        true => isa::REGISTERS,
        false => board.engine.near_registers,
    };
    random.number(1, last)
}

/// Labels from this one on are of loops that come to an end.
const LOOPS: u8 = 25;

fn is_loop(label: u8) -> bool {
    label >= LOOPS
}

fn jump(opcode: Opcode, label: u8) -> Instruction<'static> {
    // The line is that of the file, which the loader finds.
    let operand = Operand::Jump { label, line: 0 };
    Instruction { opcode, operand }
}

/// Rungs under construction, and what they may use.
struct Draft<'r> {
    random: &'r mut Random,
    board: Board,
    /// Bytes that the program is to take.
    size: usize,
    /// Analogue inputs that may be used, bit 0 A 00; of the pins that they share, the others are inputs.
    analogue: u128,
    /// Outputs that are PWM, bit 0 output 01.
    pwm: u128,
    /// Whether only contacts, coils, branches and timers occur.
    old: bool,
    rung: Rung,
    /// Bytes taken so far, about.
    taken: usize,
    /// Branches and blocks open.
    depth: u8,
    /// The branch points that this rung has stored.
    points: Vec<u8>,
    timers: u8,
    /// Values pushed in this rung.
    pushed: u8,
    /// The IFs that are open, and of each whether its ELS has come.
    ifs: Vec<bool>,
    /// The highest register that may be named.
    registers: u8,
}

impl Draft<'_> {
    fn put(&mut self, instruction: Instruction<'static>) {
        let more = match instruction.operand {
            Operand::Drum { steps, .. } => steps.len(),
            Operand::Value(Value::Constant(number)) => {
                let stored = isa::stored_constant(number);
                usize::from(self.board.engine.operand_bytes(stored)) + 1
            }
            Operand::Value(_) => 2,
            _ => 0,
        };
        self.taken +=
            usize::from(self.board.engine.run_bytes(instruction.opcode).max(2)) - 1 + more;
        self.rung.push(instruction);
    }

    /// Adds the instructions of a rung; its branches are closed in the end.
    fn rung(&mut self) {
        self.points.clear();
        if !self.old && self.random.percent(10) {
            return self.counted_loop();
        }
        if !self.old && self.random.percent(20) {
            let label = self.random.number(1, LOOPS - 1);
            self.put(Instruction::numbered(Opcode::Label, label));
        }
        if !self.old && self.random.percent(40) {
            self.beat();
        }
        // Mostly short: the longer a rung, the more seldom its coils see a 1.
        let most = self.random.below(24);
        for _ in 0..self.random.below(most + 1) {
            if let Some(instruction) = self.instruction() {
                let acts = matches!(
                    instruction.opcode.class(),
                    Class::Coil | Class::Timer | Class::Count | Class::Store | Class::Leave
                );
                if acts && self.random.percent(50) {
                    self.enliven();
                }
                self.put(instruction);
                self.follow(instruction);
            }
        }
        while self.pushed > 0 {
            let opcode = self.random.pick(&[
                Opcode::Subtract,
                Opcode::XorWord,
                Opcode::Load,
                Opcode::RealAdd,
                Opcode::UnsignedDivide,
                Opcode::Greater,
            ]);
            self.put(popping(opcode.unwrap_or(Opcode::Add)));
            self.pushed -= 1;
        }
        while self.depth > 0 {
            self.put(Instruction::plain(Opcode::CloseBranch));
            self.depth -= 1;
        }
        // Most rungs end so, or nothing would be seen of them.
        if self.random.percent(80) {
            self.enliven();
            self.end();
        }
    }

    /// Has acc follow an input again: after a few contacts in series it is 0 forever.
    fn enliven(&mut self) {
        let Some(input) = self.xx(Kind::Input) else {
            return;
        };
        let xor = self.random.pick(&[Opcode::XorInput, Opcode::XorInputNot]);
        match xor.filter(|_| !self.old && self.random.percent(60)) {
            Some(xor) => self.put(Instruction::numbered(xor, input)),
            None if self.depth == isa::DEEPEST => {}
            None => {
                self.put(Instruction::plain(Opcode::OpenBranch));
                self.put(Instruction::numbered(Opcode::InputContact, input));
                self.put(Instruction::plain(Opcode::CloseBranch));
            }
        }
    }

    /// Counts a register, and has acc follow one of its bits.
    fn beat(&mut self) {
        let register = self.register();
        let load = Operand::Value(Value::Register(register));
        let step = Operand::Value(Value::Constant(self.random.below(5) as i32 + 1));
        self.put(Instruction {
            opcode: Opcode::Load,
            operand: load,
        });
        self.put(Instruction {
            opcode: Opcode::Add,
            operand: step,
        });
        self.put(Instruction::numbered(Opcode::Store, register));
        let bit = self.random.number(0, 3);
        self.put(Instruction::numbered(Opcode::BitContact, bit));
    }

    /// A coil, or a store of what the next rung and the next scan see changed.
    fn end(&mut self) {
        let opcode = match self.random.below(if self.old { 60 } else { 100 }) {
            0..60 => Opcode::Coil,
            60..75 => Opcode::MarkerCoil,
            75..80 => Opcode::StoreMarkers,
            _ => Opcode::Store,
        };
        if opcode == Opcode::Store && self.random.percent(60) {
            let (add, step) = (
                self.random
                    .pick(&[Opcode::Add, Opcode::Subtract, Opcode::XorWord]),
                self.random.below(9),
            );
            self.put(Instruction {
                opcode: add.unwrap_or(Opcode::Add),
                operand: Operand::Value(Value::Constant(step as i32 + 1)),
            });
        }
        let end = self.with_operand(opcode);
        end.into_iter().for_each(|end| self.put(end));
    }

    /// Perhaps ends a part of an IF; whether it does.
    fn bracket(&mut self) -> bool {
        let Some(with_else) = self.ifs.last_mut() else {
            return false;
        };
        let opcode = match self.random.below(10) {
            0..2 if !*with_else => {
                *with_else = true;
                Opcode::Else
            }
            2..5 => {
                self.ifs.pop();
                Opcode::EndIf
            }
            _ => return false,
        };
        self.put(Instruction::plain(opcode));
        true
    }

    /// Perhaps ends the rung with an IF; whether it does.
    fn begin_if(&mut self) -> bool {
        let most = usize::from(isa::DEEPEST);
        let may = !self.old && self.ifs.len() < most && self.random.percent(8);
        if may {
            self.enliven();
            self.put(Instruction::plain(Opcode::If));
            self.ifs.push(false);
        }
        may
    }

    /// Counts a register round and round, a few times in each scan.
    fn counted_loop(&mut self) {
        let label = self.random.number(LOOPS, self.board.labels);
        let register = self.random.number(1, self.registers);
        let constant = |opcode, number| Instruction {
            opcode,
            operand: Operand::Value(Value::Constant(number)),
        };
        let load = Operand::Value(Value::Register(register));
        self.put(Instruction::numbered(Opcode::Label, label));
        self.put(Instruction {
            opcode: Opcode::Load,
            operand: load,
        });
        self.put(constant(Opcode::Add, 1));
        self.put(constant(Opcode::AndWord, 7));
        self.put(Instruction::numbered(Opcode::Store, register));
        self.put(constant(Opcode::NotEqual, 0));
        self.put(jump(Opcode::Jump, label));
    }

    /// Any instruction that is allowed here.
    fn instruction(&mut self) -> Option<Instruction<'static>> {
        let opened = self.rung.last().is_some_and(|last| last.opcode.opens());
        let opcode = match self.random.below(if self.old { 100 } else { 216 }) {
            0..20 => Opcode::InputContact,
            20..40 => Opcode::InputContactNot,
            40..47 => Opcode::OutputContact,
            47..54 => Opcode::OutputContactNot,
            54..64 => self.random.pick(match self.old {
                true => &[Opcode::OpenBranch],
                false => &[Opcode::OpenBranch, Opcode::OpenAnd, Opcode::OpenXor],
            })?,
            64..74 => Opcode::CloseBranch,
            74..80 => Opcode::StoreBranch,
            80..86 => Opcode::Coil,
            86..90 => Opcode::SetCoil,
            90..94 => Opcode::ResetCoil,
            94..97 => Opcode::OnDelay,
            97..100 => Opcode::OffDelay,
            100..107 => Opcode::Push,
            107..110 => Opcode::LoadTable,
            110..113 => Opcode::StoreTable,
            113..116 => self.random.pick(&[
                Opcode::RealAdd,
                Opcode::RealSubtract,
                Opcode::RealMultiply,
                Opcode::RealDivide,
            ])?,
            _ => self.random.pick(Opcode::ALL)?,
        };
        let may = match opcode.class() {
            // They have their own places.
            Class::Rung | Class::RecallPoint | Class::Label => false,
            Class::If | Class::Part => false,
            _ if matches!(opcode, Opcode::KeepRegister | Opcode::KeepCounter) => false,
            _ if opcode == Opcode::Push => self.pushed < isa::DEEPEST,
            _ if opcode == Opcode::StoreTable => self.pushed > 0,
            Class::OpenOr | Class::OpenAnd | Class::OpenXor => self.depth < isa::DEEPEST,
            Class::Close => self.depth > 0,
            // Right after an opening code this would recall.
            Class::StorePoint => !opened,
            // Returns end the scan, so they are seldom.
            Class::Leave => {
                let jumps = opcode.row().kind == Kind::Jump;
                self.depth == 0 && self.pushed == 0 && (jumps || !self.random.percent(80))
            }
            Class::Contact | Class::Condition | Class::ValueContact | Class::Comparison => true,
            Class::Xor | Class::Logic | Class::Coil | Class::Timer | Class::Count => true,
            Class::Load | Class::LoadResult | Class::Operation | Class::Store => true,
            Class::Setting => true,
        };
        let may = may.then(|| self.with_operand(opcode)).flatten();
        // Few values are an index of a table.
        let index = matches!(opcode, Opcode::Push | Opcode::LoadTable);
        if may.is_some() && index && !opened && self.random.percent(50) {
            let index = self.random.below(8) as i32;
            self.put(Instruction {
                opcode: Opcode::Load,
                operand: Operand::Value(Value::Constant(index)),
            });
        }
        may
    }

    /// Notes what an added instruction means for those after it; after an opening code, perhaps recalls.
    fn follow(&mut self, instruction: Instruction<'static>) {
        match (instruction.opcode, instruction.number()) {
            (Opcode::Push, _) => self.pushed += 1,
            (Opcode::StoreTable, _) => self.pushed -= 1,
            _ if instruction.operand == Operand::Value(Value::Popped) => self.pushed -= 1,
            (Opcode::StoreBranch, point) => self.points.extend(point),
            (Opcode::CloseBranch, _) => self.depth -= 1,
            (opcode, _) if opcode.opens() => {
                self.depth += 1;
                if let Some(point) = self.random.pick(&self.points)
                    && self.random.percent(60)
                {
                    self.put(Instruction::numbered(Opcode::RecallBranch, point));
                }
            }
            // How long a scan takes differs from machine to machine, so nothing is made of it.
            (Opcode::LoadSystem, Some(1)) => self.put(Instruction {
                opcode: Opcode::AndWord,
                operand: Operand::Value(Value::Constant(0)),
            }),
            _ => {}
        }
    }

    /// An instruction with an operand that exists; none where there is no such.
    fn with_operand(&mut self, opcode: Opcode) -> Option<Instruction<'static>> {
        let kind = opcode.row().kind;
        let operand = match kind {
            Kind::None => Operand::None,
            Kind::Timer => Operand::Timer(self.timer()?),
            Kind::Count => Operand::Count {
                counter: self.random.number(1, self.board.counters),
                preset: match self.random.below(10) {
                    0..8 => self.random.below(6) as i32,
                    _ => (self.random.bits() as u32 >> 1).cast_signed(),
                },
            },
            Kind::Value | Kind::Real => Operand::Value(match self.random.below(100) {
                ..50 if self.pushed > 0 => Value::Popped,
                ..60 => Value::Register(self.register()),
                _ if kind == Kind::Real => Value::Constant(self.real()),
                _ => Value::Constant(self.constant()),
            }),
            Kind::Table => {
                let first = self.register();
                let most = (self.registers + 1 - first).min(10);
                Operand::Table {
                    first,
                    length: self.random.number(1, most),
                }
            }
            Kind::Move => {
                let count = match self.random.percent(80) {
                    true => self.random.number(1, 5),
                    false => self.random.number(1, self.registers),
                };
                let last = self.registers + 1 - count;
                let (from, to) = (self.random.number(1, last), self.random.number(1, last));
                Operand::Move { from, to, count }
            }
            Kind::Drum => {
                let from = self.random.below(STEPS.len() as u32 - 1) as usize;
                let most = (STEPS.len() - from).min(32);
                let count = 1 + self.random.below(most as u32) as usize;
                Operand::Drum {
                    register: self.register(),
                    steps: &STEPS[from..from + count],
                }
            }
            Kind::Scale => {
                let (one, other) = (self.bound(), self.bound());
                if one == other {
                    return None;
                }
                Operand::Scale {
                    from: [one.min(other), one.max(other)],
                    to: [self.bound(), self.bound()],
                }
            }
            Kind::Filter => Operand::Filter {
                strength: self.random.number(1, 8),
                time: match self.random.below(10) {
                    0..3 => 0,
                    3..9 => self.random.below(50) as u16,
                    _ => self.random.below(30_001) as u16,
                },
            },
            Kind::Jump => return Some(jump(opcode, self.random.number(1, LOOPS - 1))),
            Kind::Input | Kind::Output | Kind::Branch | Kind::Marker | Kind::System => {
                Operand::Number(self.xx(kind)?)
            }
            Kind::TimerQ | Kind::Counter | Kind::Register | Kind::Analogue | Kind::Pwm => {
                Operand::Number(self.xx(kind)?)
            }
            Kind::Reading | Kind::Group | Kind::Bit | Kind::Time | Kind::Label => {
                Operand::Number(self.xx(kind)?)
            }
        };
        Some(Instruction { opcode, operand })
    }

    /// XX of a code of this kind that has nothing else.
    /// Whether one of a few points is taken, where there are so many that programs would seldom name one twice.
    fn near(&mut self) -> bool {
        self.board.inputs > 2 * isa::POINTS && self.random.percent(70)
    }

    fn xx(&mut self, kind: Kind) -> Option<u8> {
        let allowed = |mask: u128, first: u8, count: u8| -> Vec<u8> {
            (0..count)
                .filter(|bit| mask >> bit & 1 != 0)
                .map(|bit| first + bit)
                .collect()
        };
        // Pins that are used in another way are none.
        let choice = match kind {
            Kind::Input if self.near() => vec![1, 2, 16, 17, 18, 98],
            Kind::Output if self.near() => {
                let near = [1, 3, 16, 17, 65, 99].into_iter();
                near.filter(|n| self.pwm >> (n - 1) & 1 == 0).collect()
            }
            Kind::Input => match self.board.shared_from {
                0 => (1..=self.board.inputs).collect(),
                first => allowed(!(self.analogue << (first - 1)), 1, self.board.inputs),
            },
            Kind::Output => allowed(!self.pwm, 1, self.board.outputs),
            Kind::Pwm => allowed(self.pwm, 1, self.board.outputs),
            Kind::Analogue => allowed(self.analogue, 0, self.board.analogue),
            Kind::Marker if self.random.percent(80) => vec![1, 2, 8, 9, 57, 63, 64],
            Kind::Marker => (1..=self.board.markers).collect(),
            Kind::System => (1..=isa::SYSTEM_MARKERS).collect(),
            Kind::Branch => (1..=isa::BRANCH_POINTS).collect(),
            Kind::TimerQ => (0..self.board.timers).collect(),
            Kind::Counter => (1..=self.board.counters).collect(),
            Kind::Register => vec![self.register()],
            Kind::Reading => vec![1, 2],
            Kind::Group => (1..=self.board.groups()).collect(),
            Kind::Bit => (0..32).collect(),
            Kind::Time => vec![0, 1, 5, 20, 99],
            // Labels have their own places, and the others have more than a number.
            Kind::Label | Kind::Jump | Kind::None | Kind::Timer | Kind::Count => return None,
            Kind::Value | Kind::Move | Kind::Drum | Kind::Scale | Kind::Filter => return None,
            Kind::Real | Kind::Table => return None,
        };
        self.random.pick(&choice)
    }

    /// A register, most often one of the first few.
    fn register(&mut self) -> u8 {
        match self.random.percent(80) {
            true => self.random.number(1, 6),
            false => self.random.number(1, self.registers),
        }
    }

    fn constant(&mut self) -> i32 {
        match self.random.below(10) {
            0..4 => self.random.pick(EDGES).unwrap_or_default(),
            4..7 => self.random.below(200) as i32 - 100,
            7 => self.real(),
            _ => self.random.bits() as i32,
        }
    }

    /// The bits of a REAL that is finite.
    fn real(&mut self) -> i32 {
        let number = match self.random.below(10) {
            0..4 => self.random.pick(REALS).unwrap_or_default(),
            4..7 => (self.random.below(4_000) as f32 - 2_000.0) / 8.0,
            7 => f32::from_bits(self.random.below(0x0100_0000)),
            _ => f32::from_bits(self.random.bits() as u32),
        };
        match number.is_finite() {
            true => number.to_bits().cast_signed(),
            false => 0,
        }
    }

    fn bound(&mut self) -> i16 {
        match self.random.below(10) {
            0..2 => self
                .random
                .pick(&[i16::MIN, 0, 1023, i16::MAX])
                .unwrap_or_default(),
            2..7 => self.random.below(2_000) as i16 - 1_000,
            _ => self.random.bits() as i16,
        }
    }

    fn timer(&mut self) -> Option<TimerBlock> {
        if self.timers >= self.board.timers {
            return None;
        }
        self.timers += 1;
        let preset = match self.random.below(100) {
            0..60 => self.random.below(51),
            60..90 => self.random.below(2_001),
            _ => self.random.bits() as u32 >> 1,
        };
        let target = match self.old || self.random.percent(50) {
            true => Target::Output(self.xx(Kind::Output)?),
            false => Target::Marker(self.xx(Kind::Marker)?),
        };
        Some(TimerBlock { preset, target })
    }
}

/// Numbers at which arithmetic may go wrong.
const EDGES: &[i32] = &[
    0,
    1,
    -1,
    2,
    10,
    255,
    256,
    -256,
    1000,
    32767,
    -32768,
    65536,
    i32::MAX,
    i32::MIN,
];

/// REAL numbers at which arithmetic may go wrong.
const REALS: &[f32] = &[
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.5,
    -2.5,
    0.1,
    1e-20,
    16_777_216.0,
    2_147_483_648.0,
    -2_147_483_648.0,
    f32::MIN_POSITIVE,
    f32::MAX,
    f32::MIN,
];

/// What pops a value and has no other operand.
fn popping(opcode: Opcode) -> Instruction<'static> {
    Instruction {
        opcode,
        operand: Operand::Value(Value::Popped),
    }
}

/// Steps of drums, of which each takes a part.
const STEPS: [u8; 48] = {
    let mut steps = [0; 48];
    let mut at = 0;
    while at < steps.len() {
        steps[at] = (at * 7 + at / 5) as u8 & 0x0F;
        at += 1;
    }
    steps
};
