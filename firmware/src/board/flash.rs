//! Texts in program memory: on this chip a string literal would be copied into RAM.

use core::arch::asm;

/// Bytes that stand in program memory. They can be read only through a [`FlashText`]: an ordinary
/// reference to them would read RAM at the same address.
#[repr(transparent)]
pub struct InFlash<const N: usize>([u8; N]);

impl<const N: usize> InFlash<N> {
    /// The bytes of a text, and a NUL behind it; for [`flash_text!`], which knows N.
    pub const fn new(text: &str) -> InFlash<N> {
        let mut bytes = [0; N];
        // It would end the text early.
        let mut index = 0;
        while index < text.len() {
            assert!(text.as_bytes()[index] != 0);
            index += 1;
        }
        let (place, _) = bytes.split_at_mut(N - 1);
        place.copy_from_slice(text.as_bytes());
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

/// What is left of a text in program memory: gives its bytes in order, up to the NUL, and stays there.
#[derive(Clone)]
pub struct FlashText(*const u8);

impl FlashText {
    /// The byte at this place, up to the NUL; none for that.
    pub fn at(&self, index: u8) -> Option<u8> {
        FlashText(self.0.wrapping_add(index.into())).next()
    }
}

impl Iterator for FlashText {
    type Item = u8;

    #[inline(never)]
    fn next(&mut self) -> Option<u8> {
        let byte: u8;
        // SAFETY: `lpm` reads program memory and changes nothing; the address is that of a byte of the
        // text or of its NUL, which `InFlash::text` was promised to stand there, below 64 KiB.
        unsafe {
            asm!(
                "lpm {byte}, Z",
                byte = out(reg) byte,
                in("Z") self.0,
                options(pure, readonly, nostack, preserves_flags),
            );
        }
        if byte == 0 {
            return None;
        }
        self.0 = self.0.wrapping_add(1);
        Some(byte)
    }
}

/// A string constant as a [`FlashText`].
macro_rules! flash_text {
    ($text:expr) => {{
        const TEXT: &str = $text;
        #[unsafe(link_section = ".progmem.data")]
        static BYTES: $crate::board::flash::InFlash<{ TEXT.len() + 1 }> =
            $crate::board::flash::InFlash::new(TEXT);
        // SAFETY: the line above puts it there.
        unsafe { BYTES.text() }
    }};
}
pub(crate) use flash_text;
