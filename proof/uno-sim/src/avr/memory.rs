//! Registers, RAM and flash of the chip, as they stand.

use super::Avr;
use simavr_ffi as ffi;
use std::ptr::NonNull;

impl Avr {
    /// One register, as it stands, without the side effects of a read by the program.
    #[inline]
    pub fn register(&self, address: u16) -> u8 {
        // SAFETY: the chip is alive, and nothing writes while `&self` is held.
        unsafe { Avr::register_of(self.avr, address) }
    }

    /// The same from within a callback.
    ///
    /// # Safety
    /// `avr` is an initialised chip, and nothing else writes to it at this moment.
    #[inline]
    pub unsafe fn register_of(avr: NonNull<ffi::avr_t>, address: u16) -> u8 {
        // SAFETY: the caller's; plain value.
        debug_assert!(address <= unsafe { (*avr.as_ptr()).ramend });
        // SAFETY: `data` has RAMEND + 1 bytes; callers name one of the constants in `reg`.
        unsafe { *(*avr.as_ptr()).data.add(usize::from(address)) }
    }

    /// Sets a register from within a callback, without the side effects of a write by the program.
    ///
    /// # Safety
    /// See [`Avr::register_of`].
    pub unsafe fn set_register_of(avr: NonNull<ffi::avr_t>, address: u16, value: u8) {
        // SAFETY: the caller's; plain value.
        debug_assert!(address <= unsafe { (*avr.as_ptr()).ramend });
        // SAFETY: as in `register_of`.
        unsafe { *(*avr.as_ptr()).data.add(usize::from(address)) = value };
    }

    /// The bytes of data space from this address on.
    #[inline]
    pub fn eight_registers(&self, address: u16) -> [u8; 8] {
        debug_assert!(u32::from(address) + 7 <= self.chip().ram_end());
        // SAFETY: as in `register_of`, for eight bytes; they need not be aligned.
        unsafe {
            let data = (*self.avr.as_ptr()).data.add(usize::from(address));
            data.cast::<[u8; 8]>().read()
        }
    }

    /// Sets a register, without the side effects of a write by the program.
    pub fn set_register(&mut self, address: u16, value: u8) {
        self.data_mut()[usize::from(address)] = value;
    }

    fn data_len(&self) -> usize {
        self.chip.ram_end() as usize + 1
    }

    /// Data space, 0 to RAMEND: registers, then RAM.
    pub fn data(&self) -> &[u8] {
        // SAFETY: simavr has allocated RAMEND + 1 bytes, which live as long as `self`; nothing writes meanwhile.
        unsafe { std::slice::from_raw_parts((*self.avr.as_ptr()).data, self.data_len()) }
    }

    /// Data space for writing.
    pub fn data_mut(&mut self) -> &mut [u8] {
        // SAFETY: see `data`; `&mut self` keeps everybody else out.
        unsafe { std::slice::from_raw_parts_mut((*self.avr.as_ptr()).data, self.data_len()) }
    }

    /// Puts a program into flash, from address 0.
    ///
    /// # Panics
    /// Where it is longer than the flash; `Program` has checked that.
    pub fn load_flash(&mut self, program: &[u8]) {
        // SAFETY: the chip is alive, and `&mut self` keeps everybody else out; plain value.
        unsafe { (*self.avr.as_ptr()).codeend = program.len() as u32 };
        self.flash_mut()[..program.len()].copy_from_slice(program);
    }

    /// Has the chip start at this byte address, from now on and after each reset.
    pub fn set_start(&mut self, address: u32) {
        // SAFETY: the chip is alive, and `&mut self` keeps everybody else out; plain values.
        unsafe {
            let avr = &mut *self.avr.as_ptr();
            avr.reset_pc = address;
            avr.pc = address;
        }
    }

    /// All of the flash.
    pub fn flash(&self) -> &[u8] {
        // SAFETY: simavr has allocated flashend + 1 bytes, which live as long as `self`; nothing writes meanwhile.
        unsafe {
            let avr = &*self.avr.as_ptr();
            std::slice::from_raw_parts(avr.flash, avr.flashend as usize + 1)
        }
    }

    /// All of the flash, for writing.
    pub fn flash_mut(&mut self) -> &mut [u8] {
        // SAFETY: see `flash`; `&mut self` keeps everybody else out.
        unsafe {
            let avr = &mut *self.avr.as_ptr();
            std::slice::from_raw_parts_mut(avr.flash, avr.flashend as usize + 1)
        }
    }

    /// One 16-bit word of flash at a byte address; 0xFFFF beyond the end.
    pub fn flash_word(&self, address: u32) -> u16 {
        match self.flash().get(address as usize..address as usize + 2) {
            Some(&[low, high]) => u16::from_le_bytes([low, high]),
            _ => 0xFFFF,
        }
    }
}
