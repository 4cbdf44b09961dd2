//! Texts in program memory: on this chip a string literal would be copied into RAM.
//!
//! They are packed: a code from 0x80 on stands for two codes, by a table that `build.rs` learns from
//! the texts themselves.

use core::arch::asm;
use unoclp_core::Cause;

/// What the codes from 0x80 on stand for.
const PAIRS: &[[u8; 2]] = &include!(concat!(env!("OUT_DIR"), "/pairs.rs"));
const FIRST_PAIR: u8 = 0x80;

#[unsafe(link_section = ".progmem.data")]
static PAIRS_IN_FLASH: InFlash<{ 2 * PAIRS.len() }> =
    InFlash(*PAIRS.as_flattened().as_array().unwrap());

/// Bytes that stand in program memory. They can be read only through a [`FlashText`]: an ordinary
/// reference to them would read RAM at the same address.
#[repr(transparent)]
pub struct InFlash<const N: usize>([u8; N]);

impl<const N: usize> InFlash<N> {
    /// These codes, and a NUL after them.
    pub const fn new(codes: &Codes) -> InFlash<N> {
        let mut bytes = [0; N];
        let (place, _) = bytes.split_at_mut(N - 1);
        place.copy_from_slice(codes.0.split_at(N - 1).0);
        InFlash(bytes)
    }

    /// The text.
    ///
    /// # Safety
    ///
    /// `self` must be a static in section `.progmem.data`.
    pub const unsafe fn text(&'static self) -> FlashText {
        FlashText((&raw const self.0).cast())
    }
}

/// A table that stands in program memory.
#[repr(transparent)]
pub struct Table<T, const N: usize>([T; N]);

impl<T, const N: usize> Table<T, N> {
    /// These.
    pub const fn new(table: [T; N]) -> Table<T, N> {
        Table(table)
    }

    /// Reads bytes of the table from this place on, with anything beyond its end.
    ///
    /// # Safety
    ///
    /// `self` must be a static in section `.progmem.data`.
    #[inline(never)]
    pub unsafe fn read(&'static self, at: usize, bytes: &mut [u8]) {
        load_all((&raw const self.0).cast::<u8>().wrapping_add(at), bytes);
    }
}

/// The most codes that a text may have before it is packed.
const LONGEST: usize = 4096;

/// Codes and how many of them there are, while the compiler works them out.
pub struct Codes([u8; LONGEST], usize);

impl Codes {
    /// A text as it stands.
    pub const fn plain(text: &str) -> Codes {
        let mut codes = Codes([0; LONGEST], 0);
        codes.add(text);
        codes
    }

    /// A text, packed.
    pub const fn packed(text: &str) -> Codes {
        let mut codes = Codes::plain(text);
        codes.pack(0);
        codes
    }

    /// Of every fault its number, its text, packed, and an LF. One text, because a table of pointers
    /// to texts would stand in RAM.
    pub const fn faults() -> Codes {
        let mut codes = Codes([0; LONGEST], 0);
        let mut index = 0;
        while index < Cause::ALL.len() {
            let cause = Cause::ALL[index];
            codes.put(cause.number());
            let start = codes.1;
            codes.add(cause.text());
            codes.pack(start);
            codes.put(b'\n');
            index += 1;
        }
        codes
    }

    /// How many codes.
    pub const fn len(&self) -> usize {
        self.1
    }

    const fn add(&mut self, text: &str) {
        let mut index = 0;
        while index < text.len() {
            self.put(text.as_bytes()[index]);
            index += 1;
        }
    }

    const fn put(&mut self, code: u8) {
        // NUL ends a text.
        assert!(code != 0 && code < FIRST_PAIR);
        self.0[self.1] = code;
        self.1 += 1;
    }

    /// Replaces pairs from here on, in the order in which they were learnt.
    const fn pack(&mut self, start: usize) {
        let mut pair = 0;
        while pair < PAIRS.len() {
            let [first, second] = PAIRS[pair];
            let (mut from, mut to) = (start, start);
            while from < self.1 {
                let found =
                    from + 1 < self.1 && self.0[from] == first && self.0[from + 1] == second;
                self.0[to] = if found {
                    FIRST_PAIR + pair as u8
                } else {
                    self.0[from]
                };
                from += 1 + found as usize;
                to += 1;
            }
            self.1 = to;
            pair += 1;
        }
    }
}

/// What is left of a text in program memory: gives its codes in order, up to the NUL, and stays there.
#[derive(Clone)]
pub struct FlashText(*const u8);

impl Default for FlashText {
    /// An empty text.
    fn default() -> FlashText {
        flash_text!("")
    }
}

impl FlashText {
    /// The code at this place, up to the NUL; none for that.
    pub fn at(&self, index: u8) -> Option<u8> {
        FlashText(self.0.wrapping_add(index.into())).next()
    }
}

impl Iterator for FlashText {
    type Item = u8;

    // A call would take more, and its caller's text would have to stand in memory.
    #[inline(always)]
    fn next(&mut self) -> Option<u8> {
        let byte = load(self.0);
        if byte == 0 {
            return None;
        }
        self.0 = self.0.wrapping_add(1);
        Some(byte)
    }
}

/// The two codes that this one stands for; none where it is a character.
#[inline(always)]
pub fn pair(code: u8) -> Option<[u8; 2]> {
    let index = code.checked_sub(FIRST_PAIR)?;
    let place = (&raw const PAIRS_IN_FLASH)
        .cast::<u8>()
        .wrapping_add(2 * usize::from(index));
    Some([load(place), load(place.wrapping_add(1))])
}

/// The byte of program memory at this address.
#[inline(always)]
fn load(place: *const u8) -> u8 {
    let byte: u8;
    // SAFETY: `lpm` reads program memory, below 64 KiB, and changes nothing. Any address has a byte.
    unsafe {
        asm!(
            "lpm {byte}, Z",
            byte = out(reg) byte,
            in("Z") place,
            options(pure, readonly, nostack, preserves_flags),
        );
    }
    byte
}

/// Copies bytes of program memory, from this address on: 9 cycles each.
#[inline(never)]
fn load_all(place: *const u8, bytes: &mut [u8]) {
    // SAFETY: as above; and the bytes written are those that are lent.
    unsafe {
        asm!(
            "rjmp 2f",
            "1: lpm {byte}, Z+",
            "st X+, {byte}",
            "2: sbiw {count}, 1",
            "brcc 1b",
            byte = out(reg) _,
            count = inout(reg_iw) bytes.len() => _,
            inout("X") bytes.as_mut_ptr() => _,
            inout("Z") place => _,
            options(nostack),
        );
    }
}

/// These [`Codes`] as a [`FlashText`].
macro_rules! flash_codes {
    ($codes:expr) => {{
        const CODES: $crate::board::flash::Codes = $codes;
        #[unsafe(link_section = ".progmem.data")]
        static BYTES: $crate::board::flash::InFlash<{ CODES.len() + 1 }> =
            $crate::board::flash::InFlash::new(&CODES);
        // SAFETY: the line above puts it there.
        unsafe { BYTES.text() }
    }};
}
pub(crate) use flash_codes;

/// A string constant as a packed [`FlashText`].
macro_rules! flash_text {
    ($text:expr) => {
        $crate::board::flash::flash_codes!($crate::board::flash::Codes::packed($text))
    };
}
pub(crate) use flash_text;
