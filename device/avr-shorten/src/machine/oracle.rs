//! Where the machine's values come from: both versions of a function ask the same questions, and get the
//! same answers.

/// Answers by numbers alone, so that it does not matter who asks first, or how often.
pub struct Oracle {
    /// Each seed but the first answers some of the questions in place of those before it.
    seeds: Vec<u64>,
    constants: Constants,
}

/// How many answers stay for one that changes with one more seed.
pub const CHANGED: u64 = 16;

/// What is asked for.
#[derive(Clone, Copy)]
#[allow(missing_docs, reason = "the fields are what the question is about")]
pub enum Question {
    /// A register at the entry.
    Register(u8),
    /// The flags at the entry.
    Flags,
    /// The stack pointer at the entry.
    Stack,
    /// A byte of memory, as the call with this number has left it.
    Memory { address: u16, call: u32 },
    /// Whether a call writes to a byte of memory.
    Writes { address: u16, call: u32 },
    /// A read of an I/O register, the first, the second and so on.
    Io { address: u16, nth: u32 },
    /// A register after a call.
    Result { register: u8, call: u32 },
    /// What a call leaves in a register that nobody may look at, in one version and in the other.
    Junk {
        register: u8,
        call: u32,
        version: u8,
    },
    /// A byte of program memory.
    Program(u16),
}

impl Oracle {
    /// An oracle for a run. With one more seed, one in [`CHANGED`] of its answers is another.
    pub fn new(seeds: &[u64], constants: Constants) -> Self {
        let seeds = seeds.iter().map(|&seed| mix(seed)).collect();
        Oracle { seeds, constants }
    }

    /// The answer.
    pub fn answer(&self, question: Question) -> u64 {
        let (kind, a, b, c): (u64, u64, u64, u64) = match question {
            Question::Register(n) => (1, n.into(), 0, 0),
            Question::Flags => (2, 0, 0, 0),
            Question::Stack => (3, 0, 0, 0),
            Question::Memory { address, call } => (4, address.into(), call.into(), 0),
            Question::Writes { address, call } => (5, address.into(), call.into(), 0),
            Question::Io { address, nth } => (6, address.into(), nth.into(), 0),
            Question::Result { register, call } => (7, register.into(), call.into(), 0),
            Question::Junk {
                register,
                call,
                version,
            } => (8, register.into(), call.into(), version.into()),
            Question::Program(address) => (9, address.into(), 0, 0),
        };
        let key = kind << 60 ^ a << 40 ^ b << 8 ^ c;
        let answers = |seed: &u64| mix(seed.wrapping_add(key));
        let (first, later) = self.seeds.split_first().unwrap_or((&0, &[]));
        let chosen = later.iter().rev().map(answers);
        let mut chosen = chosen.filter(|answer| answer >> 32 & (CHANGED - 1) == 0);
        mix(chosen.next().unwrap_or_else(|| answers(first)))
    }

    /// The answer as a byte: often 0, or a value that the code compares with, or one beside it, or half of a
    /// word that it compares with where the other half is the next answer.
    pub fn byte(&self, question: Question) -> u8 {
        let answer = self.answer(question);
        if question.begins_word()
            && let Some([low, _]) = self.word(answer)
        {
            return low;
        }
        if let Some(before) = question.before().filter(|before| before.begins_word())
            && let Some([_, high]) = self.word(self.answer(before))
        {
            return high;
        }
        let byte = (answer >> 8) as u8;
        let place = (answer >> 16) as usize % self.constants.bytes.len().max(1);
        let known = self.constants.bytes.get(place).copied().unwrap_or(byte);
        match answer % 16 {
            0..=2 => 0,
            3..=4 => byte % 4,
            5 => 0xFF,
            6..=8 => known,
            9 => known.wrapping_add(1),
            10 => known.wrapping_sub(1),
            _ => byte,
        }
    }

    /// The word that begins where one may, if this answer has it begin.
    fn word(&self, answer: u64) -> Option<[u8; 2]> {
        let place = (answer >> 8) as usize % self.constants.words.len().max(1);
        let word = *self.constants.words.get(place)?;
        (answer >> 4 & 0xF < 3).then_some(word)
    }
}

impl Question {
    /// The question for the low byte, if this one may be for the high byte of a word.
    fn before(self) -> Option<Self> {
        Some(match self {
            Question::Register(n) => Question::Register(n.checked_sub(1)?),
            Question::Memory { address, call } => Question::Memory {
                address: address.wrapping_sub(1),
                call,
            },
            Question::Result { register, call } => Question::Result {
                register: register.checked_sub(1)?,
                call,
            },
            _ => return None,
        })
    }

    /// Whether a word may begin here: in registers it does so at even numbers.
    fn begins_word(self) -> bool {
        match self {
            Question::Register(register) | Question::Result { register, .. } => register % 2 == 0,
            Question::Memory { .. } => true,
            _ => false,
        }
    }
}

/// Values that code compares with.
#[derive(Clone, Debug, Default)]
pub struct Constants {
    /// Bytes.
    pub bytes: Vec<u8>,
    /// Words, the low byte first.
    pub words: Vec<[u8; 2]>,
}

/// The first random bits of this seed.
pub fn mix(mut n: u64) -> u64 {
    unoclp_random::bits(&mut n)
}
