//! The thin layer over simavr: one ATmega328P at 16 MHz, and every call into C that needs no callback.
//!
//! simavr keeps the whole chip in one `avr_t`. Between two steps nothing else touches it; during a step the callbacks
//! registered with [`Avr::on`] run, and may raise IRQs. So this type gives out no reference that could outlive a call.

use crate::Error;
use crate::elf::RAM_END;
use simavr_ffi as ffi;
use std::ffi::c_void;
use std::mem::MaybeUninit;
use std::ptr::NonNull;

/// Clock of the UNO, Hz.
pub const CLOCK_HZ: u32 = 16_000_000;

/// Data addresses of the registers that are looked at from outside (ATmega328P datasheet, section 30).
pub mod reg {
    /// Port B (D8 to D13), direction.
    pub const DDRB: u16 = 0x24;
    /// Port D (D0 to D7), direction.
    pub const DDRD: u16 = 0x2A;
    /// Port D, output; each port's output register follows its direction register.
    pub const PORTD: u16 = 0x2B;
    /// SPI control register; SPE is bit 6.
    pub const SPCR: u16 = 0x4C;
    /// Why the chip was reset; EXTRF is bit 1.
    pub const MCUSR: u16 = 0x54;
    /// Watchdog control; WDE is bit 3, WDIE bit 6.
    pub const WDTCSR: u16 = 0x60;
    /// Timer 1, which interrupts are on.
    pub const TIMSK1: u16 = 0x6F;
    /// USART control and status B; RXEN0 is bit 4.
    pub const UCSR0B: u16 = 0xC1;
    /// Stack pointer: SPL, then SPH.
    pub const SP: u16 = 0x5D;
}

/// What simavr says of the CPU after a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cpu {
    /// Running, or asleep with something that can wake it.
    Alive,
    /// Asleep with interrupts off.
    Done,
    /// Ran out of flash, or met an invalid opcode.
    Crashed,
}

/// An IRQ of simavr: a wire between the chip and the world. Valid as long as the [`Avr`] it came from.
#[derive(Clone, Copy)]
pub struct Irq(NonNull<ffi::avr_irq_t>);

/// The function type of simavr's callbacks: IRQ, value, and the parameter given to [`Avr::on`].
pub type Notify = unsafe extern "C" fn(*mut ffi::avr_irq_t, u32, *mut c_void);

/// The simulated chip.
pub struct Avr {
    avr: NonNull<ffi::avr_t>,
}

impl Avr {
    /// A chip fresh from the factory, just powered.
    pub fn new() -> Result<Avr, Error> {
        // SAFETY: the name is a C string; simavr copies nothing of it.
        let avr = unsafe { ffi::avr_make_mcu_by_name(c"atmega328p".as_ptr()) };
        let avr = NonNull::new(avr).ok_or(Error::Simavr("it was built without this chip"))?;
        // SAFETY: `avr` is a chip that simavr has just allocated and that nobody else knows.
        let status = unsafe { ffi::avr_init(avr.as_ptr()) };
        let avr = Avr { avr };
        if status != 0 {
            return Err(Error::Simavr("avr_init failed"));
        }
        // SAFETY: as above; the fields are plain values, and a callback that does nothing.
        unsafe {
            let avr = &mut *avr.avr.as_ptr();
            avr.frequency = CLOCK_HZ;
            // Quiet: simavr would print. What it has to say of the program is found in other ways.
            avr.set_log(0);
            // By default a sleeping chip makes the process sleep too, to keep pace with real time.
            avr.sleep = Some(sleep_no_time);
        }
        Ok(avr)
    }

    /// One instruction, with the interrupts and peripherals that are due after it.
    #[inline]
    pub fn step(&mut self) -> Cpu {
        // SAFETY: the chip is initialised, and `&mut self` keeps everybody else out. This is what `avr_run` calls where no
        // debugger is attached.
        let state = unsafe {
            ffi::avr_callback_run_raw(self.avr.as_ptr());
            (*self.avr.as_ptr()).state
        };
        match state as u32 {
            ffi::cpu_Done => Cpu::Done,
            ffi::cpu_Crashed | ffi::cpu_Stopped => Cpu::Crashed,
            _ => Cpu::Alive,
        }
    }

    /// Makes the next [`Avr::step`], and the one that is under way, return [`Cpu::Crashed`].
    ///
    /// # Safety
    /// To be called from a callback only, with the chip of that callback.
    pub unsafe fn crash(avr: NonNull<ffi::avr_t>) {
        // SAFETY: the caller's; `state` is a plain value.
        unsafe { (*avr.as_ptr()).state = ffi::cpu_Crashed as i32 };
    }

    /// Resets the chip: registers to their start values, PC to 0, cycle count to 0. RAM and EEPROM stay.
    pub fn reset(&mut self) {
        // SAFETY: see `step`.
        unsafe { ffi::avr_reset(self.avr.as_ptr()) };
    }

    /// Byte address of the next instruction.
    #[inline]
    pub fn pc(&self) -> u32 {
        // SAFETY: nothing writes to the chip while `&self` is held; plain value. The same holds for the next three.
        unsafe { (*self.avr.as_ptr()).pc }
    }

    /// Cycles since the last reset.
    #[inline]
    pub fn cycle(&self) -> u64 {
        // SAFETY: see `pc`.
        unsafe { (*self.avr.as_ptr()).cycle }
    }

    /// The global interrupt flag.
    pub fn interrupts_on(&self) -> bool {
        // SAFETY: see `pc`.
        unsafe { (*self.avr.as_ptr()).sreg[7] != 0 }
    }

    /// The chip itself, for callbacks.
    pub fn as_ptr(&self) -> NonNull<ffi::avr_t> {
        self.avr
    }

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
        debug_assert!(u32::from(address) <= RAM_END);
        // SAFETY: `data` has RAM_END + 1 bytes; callers name one of the constants in `reg`.
        unsafe { *(*avr.as_ptr()).data.add(usize::from(address)) }
    }

    /// Two registers, `address` the low byte.
    #[inline]
    pub fn register_pair(&self, address: u16) -> u16 {
        debug_assert!(u32::from(address) < RAM_END);
        // SAFETY: as in `register_of`, for two bytes; they need not be aligned.
        let bytes = unsafe {
            (*self.avr.as_ptr())
                .data
                .add(usize::from(address))
                .cast::<[u8; 2]>()
                .read()
        };
        u16::from_le_bytes(bytes)
    }

    /// Sets a register, without the side effects of a write by the program.
    pub fn set_register(&mut self, address: u16, value: u8) {
        self.data_mut()[usize::from(address)] = value;
    }

    /// Data space, 0 to RAMEND: registers, then RAM.
    pub fn data(&self) -> &[u8] {
        // SAFETY: simavr has allocated RAM_END + 1 bytes, which live as long as `self`; nothing writes meanwhile.
        unsafe { std::slice::from_raw_parts((*self.avr.as_ptr()).data, RAM_END as usize + 1) }
    }

    /// Data space for writing.
    pub fn data_mut(&mut self) -> &mut [u8] {
        // SAFETY: see `data`; `&mut self` keeps everybody else out.
        unsafe { std::slice::from_raw_parts_mut((*self.avr.as_ptr()).data, RAM_END as usize + 1) }
    }

    /// Puts a program into flash, from address 0.
    ///
    /// # Panics
    /// Where it is longer than the flash; `Program` has checked that.
    pub fn load_flash(&mut self, program: &[u8]) {
        // SAFETY: simavr has allocated flashend + 1 bytes and 2 more; `&mut self` keeps everybody else out.
        let flash = unsafe {
            let avr = &mut *self.avr.as_ptr();
            avr.codeend = program.len() as u32;
            std::slice::from_raw_parts_mut(avr.flash, avr.flashend as usize + 1)
        };
        flash[..program.len()].copy_from_slice(program);
    }

    /// One 16-bit word of flash at a byte address; 0xFFFF beyond the end.
    pub fn flash_word(&self, address: u32) -> u16 {
        // SAFETY: see `load_flash`.
        let flash = unsafe {
            let avr = &*self.avr.as_ptr();
            std::slice::from_raw_parts(avr.flash, avr.flashend as usize + 1)
        };
        match flash.get(address as usize..address as usize + 2) {
            Some(&[low, high]) => u16::from_le_bytes([low, high]),
            _ => 0xFFFF,
        }
    }

    /// Copies `bytes.len()` bytes of EEPROM from `address`; false where they lie outside.
    pub fn read_eeprom(&mut self, address: u16, bytes: &mut [u8]) -> bool {
        self.eeprom(*b"eegp", address, bytes)
    }

    /// Writes into the EEPROM, at once; false where the bytes lie outside.
    pub fn write_eeprom(&mut self, address: u16, bytes: &[u8]) -> bool {
        self.eeprom(*b"eesp", address, &mut bytes.to_vec())
    }

    fn eeprom(&mut self, request: [u8; 4], offset: u16, bytes: &mut [u8]) -> bool {
        let mut description = ffi::avr_eeprom_desc_t {
            ee: bytes.as_mut_ptr(),
            offset,
            size: bytes.len() as u32,
        };
        // SAFETY: these requests take an `avr_eeprom_desc_t`, copy `size` bytes from or to `ee`, and keep no pointer.
        bytes.is_empty() || unsafe { self.ioctl(request, (&raw mut description).cast()) } == 0
    }

    /// Tells a port which of its pins are driven from outside (`mask`), and to what (`levels`). simavr applies it
    /// whenever the program writes to PORT or DDR, in place of the pull-up.
    pub fn set_external(&mut self, port: u8, mask: u8, levels: u8) {
        // SAFETY: a C struct of plain bits, for which all zeros is a value.
        let mut external: ffi::avr_ioport_external_t =
            unsafe { MaybeUninit::zeroed().assume_init() };
        external.set_mask(mask.into());
        external.set_value(levels.into());
        // SAFETY: this request takes an `avr_ioport_external_t` and copies from it.
        unsafe { self.ioctl([b'i', b'o', b'p', port], (&raw mut external).cast()) };
    }

    /// Sets the flags of USART0: none, so that it neither prints nor makes the process sleep.
    pub fn quiet_uart(&mut self) {
        let mut flags = 0u32;
        // SAFETY: this request takes a `uint32_t` and copies from it.
        unsafe { self.ioctl(*b"uas0", (&raw mut flags).cast()) };
    }

    /// # Safety
    /// `parameter` is what the request takes.
    unsafe fn ioctl(&mut self, request: [u8; 4], parameter: *mut c_void) -> i32 {
        // SAFETY: the chip is alive; the rest is the caller's.
        unsafe { ffi::avr_ioctl(self.avr.as_ptr(), u32::from_be_bytes(request), parameter) }
    }

    /// The IRQ `index` of a peripheral, which is named by simavr's four letters.
    pub fn irq(&self, peripheral: [u8; 4], index: u32) -> Result<Irq, Error> {
        let name = u32::from_be_bytes(peripheral);
        // SAFETY: the chip is alive; simavr only looks the name up.
        let irq = unsafe { ffi::avr_io_getirq(self.avr.as_ptr(), name, index as i32) };
        NonNull::new(irq)
            .map(Irq)
            .ok_or(Error::Simavr("a peripheral is missing"))
    }

    /// The IRQ that is raised for an invalid opcode, with that opcode.
    pub fn bad_opcode_irq(&self) -> Result<Irq, Error> {
        // SAFETY: the chip is alive, and AVR_CORE_BAD_OPCODE (0) is one of its core IRQs.
        let irq = unsafe { ffi::avr_get_core_irq(self.avr.as_ptr(), 0) };
        NonNull::new(irq)
            .map(Irq)
            .ok_or(Error::Simavr("the core has no IRQ"))
    }

    /// Has `notify` called with `parameter` each time the IRQ is raised.
    ///
    /// # Safety
    /// `irq` belongs to this chip; `parameter` is what `notify` expects, and stays valid as long as the chip.
    pub unsafe fn on(&mut self, irq: Irq, notify: Notify, parameter: *mut c_void) {
        // SAFETY: the caller's.
        unsafe { ffi::avr_irq_register_notify(irq.0.as_ptr(), Some(notify), parameter) };
    }
}

impl Irq {
    /// Raises the IRQ: puts `value` on the wire.
    ///
    /// # Safety
    /// The chip is alive. Callbacks registered on the IRQ run now, so no reference to what they use may be held.
    pub unsafe fn raise(self, value: u32) {
        // SAFETY: the caller's.
        unsafe { ffi::avr_raise_irq(self.0.as_ptr(), value) };
    }
}

impl Drop for Avr {
    fn drop(&mut self) {
        // SAFETY: the chip came from simavr's `malloc`, and nobody uses it any more. `avr_terminate` frees what it owns
        // but not itself.
        unsafe {
            ffi::avr_terminate(self.avr.as_ptr());
            libc::free(self.avr.as_ptr().cast());
        }
    }
}

/// Stands in for simavr's sleep: simulated time passes, real time need not.
unsafe extern "C" fn sleep_no_time(_: *mut ffi::avr_t, _: ffi::avr_cycle_count_t) {}
