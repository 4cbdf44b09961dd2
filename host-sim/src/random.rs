//! Random valid programs, and random inputs and times to run them with.
//!
//! Everything follows from a seed, so a failure is repeated by its seed alone.

use unoclp_core::isa::{self, Opcode, Operand};
use unoclp_core::{Image, Instruction, Millis, Point, Profile, Target, TimerBlock};

/// A stream of random numbers that its seed decides: SplitMix64 (Steele, Lea and Flood, 2014).
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// The stream of this seed.
    pub fn new(seed: u64) -> Random {
        Random(seed)
    }

    /// The next 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = self.0;
        let z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// A number from 0 to `limit` − 1; 0 where the limit is 0.
    pub fn below(&mut self, limit: u32) -> u32 {
        // The high word of the product is below the limit.
        ((u64::from(limit) * (self.bits() >> 32)) >> 32) as u32
    }

    /// True in this many of a hundred cases.
    pub fn percent(&mut self, cases: u32) -> bool {
        self.below(100) < cases
    }

    /// One of these; none where there are none.
    pub fn pick<T: Copy>(&mut self, from: &[T]) -> Option<T> {
        from.get(self.below(from.len() as u32) as usize).copied()
    }

    /// One of `count` points of the board; `count` is at least 1.
    fn point(&mut self, count: u8) -> Option<Point> {
        Point::new(self.below(count.into()) as u8 + 1, count)
    }
}

/// A random program that every board with this profile accepts: of any size up to nearly full,
/// with every instruction, and written in any of the ways that NC-3 allows.
pub fn random_program(random: &mut Random, board: Profile) -> String {
    let instructions = random_instructions(random, board);
    write(random, &instructions)
}

/// Inputs for the next scan: mostly as they were, sometimes with one changed, seldom all anew.
pub fn random_inputs(random: &mut Random, board: Profile, before: Image) -> Image {
    let mut inputs = before;
    match random.below(100) {
        0..70 => {}
        70..95 => {
            if let Some(point) = random.point(board.inputs) {
                inputs.set(point, !inputs.get(point));
            }
        }
        _ => {
            let existing = u16::MAX.checked_shr(16 - u32::from(board.inputs));
            inputs = Image(random.bits() as u16 & existing.unwrap_or_default());
        }
    }
    inputs
}

/// ms to the next scan: mostly a few, sometimes none or as many as a timer takes, seldom an age.
pub fn random_pause(random: &mut Random) -> Millis {
    match random.below(100) {
        0..80 => random.below(4),
        80..99 => random.below(60),
        _ => random.bits() as Millis,
    }
}

/// The instructions of a program under construction, and the room that is left for more.
struct Draft<'r> {
    random: &'r mut Random,
    board: Profile,
    instructions: Vec<Instruction<'static>>,
    /// Stored bytes left, apart from one for each open branch to be closed.
    stored_left: u32,
    /// Bytes of run memory left, likewise.
    linked_left: u32,
    /// Branches open.
    depth: u8,
    /// The branch points that this rung has stored.
    stored: Vec<u8>,
}

fn random_instructions(random: &mut Random, board: Profile) -> Vec<Instruction<'static>> {
    // As many programs of about 10 bytes as of 100 or of 1000.
    let magnitude = random.below(9);
    let size = random.below(4 << magnitude);
    let mut draft = Draft {
        random,
        board,
        instructions: Vec::new(),
        stored_left: size.min(board.stored_bytes.into()),
        linked_left: board.linked_bytes.into(),
        depth: 0,
        stored: Vec::new(),
    };
    // A program may begin without a new rung.
    if draft.random.percent(20) {
        draft.rung();
    }
    while draft.put(Instruction::plain(Opcode::NewRung)) {
        draft.stored.clear();
        draft.rung();
    }
    draft.instructions
}

impl Draft<'_> {
    /// Adds an instruction if there is room for it; says whether there was.
    fn put(&mut self, instruction: Instruction<'static>) -> bool {
        let (stored, linked) = match instruction.opcode {
            // Its byte was set aside when the branch was opened.
            Opcode::CloseBranch => (0, 0),
            Opcode::OpenBranch => (2, 2),
            Opcode::OnDelay | Opcode::OffDelay => (6, 11),
            Opcode::InputContact | Opcode::InputContactNot => (1, 3),
            _ => (1, 1),
        };
        let fits = stored <= self.stored_left && linked <= self.linked_left;
        if fits {
            self.stored_left -= stored;
            self.linked_left -= linked;
            self.instructions.push(instruction);
        }
        fits
    }

    /// Adds the instructions of a rung; its branches are closed in the end.
    fn rung(&mut self) {
        // Mostly short: the longer a rung, the more seldom its coils see a 1.
        let most = self.random.below(24);
        for _ in 0..self.random.below(most + 1) {
            let instruction = self.instruction();
            if let Some(instruction) = instruction
                && self.put(instruction)
            {
                self.follow(instruction);
            }
        }
        while self.depth > 0 {
            self.put(Instruction::plain(Opcode::CloseBranch));
            self.depth -= 1;
        }
        // Most rungs end in a coil, or nothing would be seen of them.
        if let Some(coil) = self.random.point(self.board.outputs)
            && self.random.percent(80)
        {
            self.put(Instruction::numbered(Opcode::Coil, coil.number()));
        }
    }

    /// Any instruction that is allowed here.
    fn instruction(&mut self) -> Option<Instruction<'static>> {
        let board = self.board;
        let instruction = match self.random.below(100) {
            0..20 => self.numbered(Opcode::InputContact, board.inputs)?,
            20..40 => self.numbered(Opcode::InputContactNot, board.inputs)?,
            40..47 => self.numbered(Opcode::OutputContact, board.outputs)?,
            47..54 => self.numbered(Opcode::OutputContactNot, board.outputs)?,
            54..64 if self.depth < isa::DEEPEST => Instruction::plain(Opcode::OpenBranch),
            64..74 if self.depth > 0 => Instruction::plain(Opcode::CloseBranch),
            // Right after an open branch this would recall.
            74..80
                if !self
                    .instructions
                    .last()
                    .is_some_and(|last| last.opcode.opens()) =>
            {
                self.numbered(Opcode::StoreBranch, isa::BRANCH_POINTS)?
            }
            80..86 => self.numbered(Opcode::Coil, board.outputs)?,
            86..90 => self.numbered(Opcode::SetCoil, board.outputs)?,
            90..94 => self.numbered(Opcode::ResetCoil, board.outputs)?,
            94..97 => self.timer(Opcode::OnDelay)?,
            97..100 => self.timer(Opcode::OffDelay)?,
            _ => return None,
        };
        Some(instruction)
    }

    /// Notes what an added instruction means for those after it; after an open branch, perhaps
    /// recalls.
    fn follow(&mut self, instruction: Instruction<'static>) {
        match instruction.opcode {
            Opcode::StoreBranch => self.stored.extend(instruction.number()),
            Opcode::CloseBranch => self.depth -= 1,
            Opcode::OpenBranch => {
                self.depth += 1;
                if let Some(point) = self.random.pick(&self.stored)
                    && self.random.percent(60)
                {
                    self.put(Instruction::numbered(Opcode::RecallBranch, point));
                }
            }
            _ => {}
        }
    }

    fn numbered(&mut self, opcode: Opcode, count: u8) -> Option<Instruction<'static>> {
        let point = self.random.point(count)?;
        Some(Instruction::numbered(opcode, point.number()))
    }

    fn timer(&mut self, opcode: Opcode) -> Option<Instruction<'static>> {
        let preset = match self.random.below(100) {
            0..60 => self.random.below(51),
            60..90 => self.random.below(2_001),
            _ => self.random.bits() as Millis & LONGEST_PRESET,
        };
        let output = self.random.point(self.board.outputs)?;
        let target = Target::Output(output.number());
        let operand = Operand::Timer(TimerBlock { preset, target });
        Some(Instruction { opcode, operand })
    }
}

/// The longest preset, in ms (NC-9).
const LONGEST_PRESET: Millis = i32::MAX.cast_unsigned();

/// Writes a program file, in one of the many ways to do so (NC-2, NC-3).
fn write(random: &mut Random, instructions: &[Instruction<'static>]) -> String {
    let line_end = if random.percent(30) { "\r\n" } else { "\n" };
    // Programs are either plain or decorated here and there.
    let decorated = if random.percent(50) { 10 } else { 0 };
    let mut text = String::new();
    if random.percent(decorated) {
        text.push('\u{FEFF}');
    }
    let codes = instructions
        .iter()
        .flat_map(|instruction| instruction.codes());
    for code in std::iter::once(isa::START).chain(codes) {
        if random.percent(decorated) {
            text.push_str(random.pick(BLANK_LINES).unwrap_or_default());
            text.push_str(line_end);
        }
        if random.percent(decorated) {
            text.push_str(random.pick(&[" ", "\t", "    "]).unwrap_or_default());
        }
        if code < 0 {
            text.push('-');
        }
        if random.percent(decorated) {
            text.push_str("000");
        }
        text.push_str(&code.unsigned_abs().to_string());
        if random.percent(decorated) {
            text.push_str(random.pick(AFTER_CODES).unwrap_or_default());
        }
        text.push_str(line_end);
    }
    if random.percent(decorated) {
        text.truncate(text.len() - line_end.len());
    }
    text
}

/// Lines without a code.
const BLANK_LINES: &[&str] = &[
    "",
    "  ",
    "\t",
    "/",
    "/ a comment",
    "  / partida do motor: ação",
];

/// What may stand between a code and the end of its line.
const AFTER_CODES: &[&str] = &[" ", "\t ", "/", " / 827301", "\t// I1 \u{2192} Q1"];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{BOARD, engine};

    #[test]
    fn random_programs_are_valid_and_together_use_everything() {
        let mut seen = Vec::new();
        let (mut smallest, mut largest) = (usize::MAX, 0);
        for seed in 0..500 {
            let text = random_program(&mut Random::new(seed), BOARD);
            let mut memory = vec![0; usize::from(BOARD.linked_bytes)];
            let program = engine::load(text.as_bytes(), &mut memory)
                .unwrap_or_else(|fault| panic!("seed {seed}: {fault}\n{text}"));
            smallest = smallest.min(program.stored_bytes());
            largest = largest.max(program.stored_bytes());
            seen.extend(program.steps().map(|step| step.opcode.row().stored));
        }
        for row in isa::TABLE {
            assert!(seen.contains(&row.stored), "{} never occurs", row.letters);
        }
        assert_eq!(smallest, 0);
        assert!(largest > usize::from(BOARD.stored_bytes) * 9 / 10);
    }

    #[test]
    fn the_seed_decides_the_program() {
        let program = |seed| random_program(&mut Random::new(seed), BOARD);
        assert_eq!(program(7), program(7));
        assert_ne!(program(7), program(8));
    }

    #[test]
    fn numbers_stay_below_their_limit_and_reach_it() {
        let mut random = Random::new(1);
        let mut seen = [false; 5];
        for _ in 0..200 {
            seen[random.below(5) as usize] = true;
        }
        assert_eq!(seen, [true; 5]);
        assert_eq!(random.below(0), 0);
    }

    #[test]
    fn inputs_change_and_stay_on_the_board() {
        let mut random = Random::new(1);
        let mut inputs = Image::default();
        let (mut ever, mut held) = (0, 0);
        for _ in 0..1_000 {
            let next = random_inputs(&mut random, BOARD, inputs);
            held += usize::from(next == inputs);
            ever |= next.0;
            inputs = next;
        }
        assert_eq!(ever, 0b1111);
        assert!((500..900).contains(&held), "{held}");
    }
}
