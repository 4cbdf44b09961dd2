//! What connects the chip with the world: IRQs, callbacks of registers, and timers.

use super::Avr;
use crate::Error;
use simavr_ffi as ffi;
use std::ffi::c_void;
use std::mem::MaybeUninit;
use std::ptr::NonNull;

/// An IRQ of simavr: a wire between the chip and the world. Valid as long as the [`Avr`] it came from.
#[derive(Clone, Copy)]
pub struct Irq(NonNull<ffi::avr_irq_t>);

/// One of the chip's interrupts. Valid as long as the [`Avr`] it came from.
#[derive(Clone, Copy)]
pub struct Interrupt(NonNull<ffi::avr_int_vector_t>);

/// The function type of simavr's callbacks: IRQ, value, and the parameter given to [`Avr::on`].
pub type Notify = unsafe extern "C" fn(*mut ffi::avr_irq_t, u32, *mut c_void);

/// What is called when the program writes to an I/O register: chip, data address, value, and the parameter given to
/// [`Avr::on_write`].
pub type Write = unsafe extern "C" fn(*mut ffi::avr_t, ffi::avr_io_addr_t, u8, *mut c_void);

/// What is called when the program reads an I/O register: chip, data address, and the parameter given to
/// [`Avr::on_read`]. It gives the value that is read.
pub type Read = unsafe extern "C" fn(*mut ffi::avr_t, ffi::avr_io_addr_t, *mut c_void) -> u8;

/// What is called when a time is over: chip, cycle at which it was, and the parameter given to [`Avr::after`]. It gives
/// the cycle at which it wants to be called again, or 0.
pub type Timer = unsafe extern "C" fn(*mut ffi::avr_t, u64, *mut c_void) -> u64;

impl Avr {
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

    /// Takes the compare units of the timers off their pins, to which simavr connects them at each reset.
    pub fn unwire_timers(&mut self) -> Result<(), Error> {
        for &(timer, unit, port, pin) in self.chip().wired_units() {
            let from = self.irq(timer, ffi::TIMER_IRQ_OUT_COMP + unit)?;
            let to = self.irq(port, pin)?;
            // SAFETY: both are IRQs of this chip.
            unsafe { ffi::avr_unconnect_irq(from.0.as_ptr(), to.0.as_ptr()) };
        }
        Ok(())
    }

    /// Sets the flags of USART0, and of USART1: none, so that it neither prints nor makes the process sleep.
    pub fn quiet_uart(&mut self) {
        let mut flags = 0u32;
        // SAFETY: this request takes a `uint32_t` and copies from it. A chip without the port refuses it.
        unsafe {
            self.ioctl(*b"uas0", (&raw mut flags).cast());
            self.ioctl(*b"uas1", (&raw mut flags).cast());
        }
    }

    /// # Safety
    /// `parameter` is what the request takes.
    pub(super) unsafe fn ioctl(&mut self, request: [u8; 4], parameter: *mut c_void) -> i32 {
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

    /// The interrupt with this number in the table of vectors, in which the reset has 0.
    pub fn interrupt(&self, number: u8) -> Result<Interrupt, Error> {
        // SAFETY: the chip is alive, and nothing writes while `&self` is held; the first `vector_count` are pointers to
        // what lives as long as the chip.
        let vector = unsafe {
            let table = &(*self.as_ptr().as_ptr()).interrupts;
            let mut vectors = table.vector[..usize::from(table.vector_count)].iter();
            vectors.find(|vector| (***vector).vector == number)
        };
        vector
            .and_then(|&vector| NonNull::new(vector))
            .map(Interrupt)
            .ok_or(Error::Simavr("an interrupt is missing"))
    }

    /// Has `notify` called with `parameter` each time the IRQ is raised.
    ///
    /// # Safety
    /// `irq` belongs to this chip; `parameter` is what `notify` expects, and stays valid as long as the chip.
    pub unsafe fn on(&mut self, irq: Irq, notify: Notify, parameter: *mut c_void) {
        // SAFETY: the caller's.
        unsafe { ffi::avr_irq_register_notify(irq.0.as_ptr(), Some(notify), parameter) };
    }

    /// Has `write` called with `parameter` when the program writes to an I/O register, in place of what simavr does there.
    ///
    /// # Safety
    /// `parameter` is what `write` expects, and stays valid as long as the chip.
    pub unsafe fn on_write(&mut self, address: u16, write: Write, parameter: *mut c_void) {
        // SAFETY: the chip is alive, and `&mut self` keeps everybody else out; the rest is the caller's.
        let register = unsafe { &mut (*self.as_ptr().as_ptr()).io[io(address)] };
        register.w.c = Some(write);
        register.w.param = parameter;
    }

    /// Has `read` called with `parameter` when the program reads an I/O register, in place of what simavr does there.
    ///
    /// # Safety
    /// `parameter` is what `read` expects, and stays valid as long as the chip.
    pub unsafe fn on_read(&mut self, address: u16, read: Read, parameter: *mut c_void) {
        // SAFETY: as in `on_write`.
        let register = unsafe { &mut (*self.as_ptr().as_ptr()).io[io(address)] };
        register.r.c = Some(read);
        register.r.param = parameter;
    }

    /// Has `timer` called with `parameter` after so many cycles, at the end of an instruction. A reset forgets it.
    ///
    /// # Safety
    /// `avr` is an initialised chip; `parameter` is what `timer` expects, and stays valid as long as the chip.
    pub unsafe fn after(
        avr: NonNull<ffi::avr_t>,
        cycles: u64,
        timer: Timer,
        parameter: *mut c_void,
    ) {
        // SAFETY: the caller's.
        unsafe { ffi::avr_cycle_timer_register(avr.as_ptr(), cycles, Some(timer), parameter) };
    }
}

/// Place of an I/O register in simavr's table: its data address without the working registers.
fn io(address: u16) -> usize {
    usize::from(address) - 0x20
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

impl Interrupt {
    /// The IRQ that goes to 0 as the CPU takes the interrupt.
    pub fn pending(self) -> Irq {
        // SAFETY: the vector is alive; its first IRQ is the one of AVR_INT_IRQ_PENDING.
        Irq(unsafe { NonNull::from(&mut (*self.0.as_ptr()).irq[0]) })
    }

    /// Asks for the interrupt, whose flag and enable bit are set, or takes that back.
    ///
    /// # Safety
    /// `avr` is the chip that it came from. Callbacks registered on [`Interrupt::pending`] run now, with 1, so no
    /// reference to what they use may be held.
    pub unsafe fn request(self, avr: NonNull<ffi::avr_t>, wanted: bool) {
        // SAFETY: the caller's. What was asked for stays in simavr's queue, which skips it where it is not pending.
        unsafe {
            if wanted {
                ffi::avr_raise_interrupt(avr.as_ptr(), self.0.as_ptr());
            } else {
                (*self.0.as_ptr()).set_pending(0);
            }
        }
    }
}
