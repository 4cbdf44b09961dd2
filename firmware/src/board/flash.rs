//! Texts in program memory: on this chip a string literal would be copied into RAM.

use core::arch::asm;

/// Bytes that stand in program memory. They can be read only through a [`FlashText`]: an ordinary
/// reference to them would read RAM at the same address.
#[repr(transparent)]
pub struct InFlash<const N: usize>([u8; N]);

impl<const N: usize> InFlash<N> {
    /// The bytes of a text of N bytes; for [`flash_text!`], which knows N.
    pub const fn new(text: &str) -> InFlash<N> {
        let mut bytes = [0; N];
        bytes.copy_from_slice(text.as_bytes());
        InFlash(bytes)
    }

    /// The text.
    ///
    /// # Safety
    ///
    /// `self` must be a static in section `.progmem.data`.
    pub const unsafe fn text(&'static self) -> FlashText {
        FlashText {
            start: (&raw const self.0).cast(),
            length: N as u16,
        }
    }
}

/// A text in program memory.
#[derive(Clone, Copy)]
pub struct FlashText {
    start: *const u8,
    length: u16,
}

impl FlashText {
    /// Its bytes in order.
    pub fn bytes(self) -> impl Iterator<Item = u8> {
        (0..self.length).filter_map(move |index| self.byte(index))
    }

    /// The byte at this index; none behind the end.
    pub fn byte(self, index: u16) -> Option<u8> {
        if index >= self.length {
            return None;
        }
        let byte: u8;
        // SAFETY: `lpm` reads program memory and changes nothing; the address is inside the text,
        // which `InFlash::text` was promised to stand there, below 64 KiB.
        unsafe {
            asm!(
                "lpm {byte}, Z",
                byte = out(reg) byte,
                in("Z") self.start.wrapping_add(usize::from(index)),
                options(pure, readonly, nostack, preserves_flags),
            );
        }
        Some(byte)
    }
}

/// A string constant as a [`FlashText`].
macro_rules! flash_text {
    ($text:expr) => {{
        const TEXT: &str = $text;
        #[unsafe(link_section = ".progmem.data")]
        static BYTES: $crate::board::flash::InFlash<{ TEXT.len() }> =
            $crate::board::flash::InFlash::new(TEXT);
        // SAFETY: the line above puts it there.
        unsafe { BYTES.text() }
    }};
}
pub(crate) use flash_text;
