//! From stored bytes, as the EEPROM keeps them, to linked bytes: by `link.s`.

use super::data::Data;
use super::layout::{Layout, POINTS};
use crate::board::eeprom::Eeprom;
use crate::store::Reader;
use core::ffi::c_void;
use unoclp_core::Cause;

/// How much a program takes of run memory, bytes.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Size {
    pub code: u16,
    pub own: u16,
}

/// One passage, as `link.s` knows it: addresses, but for what says otherwise.
#[repr(C)]
pub(super) struct Job {
    /// A [`Reader`].
    pub(super) reader: *mut c_void,
    /// Where the next linked byte is put, and from where on they are only counted.
    pub(super) put: u16,
    pub(super) limit: u16,
    /// The lowest own data so far.
    pub(super) own: u16,
    /// The data of the next timer, of the first, and after the last.
    pub(super) timer: u16,
    pub(super) timers: u16,
    pub(super) timers_end: u16,
    /// The data of the first counter, and after the last.
    pub(super) counters: u16,
    pub(super) counters_end: u16,
    /// Where the address of the next number that is kept is put, and after that of the last.
    pub(super) kept: u16,
    pub(super) kept_end: u16,
    /// How many stored bytes have been read, each constant counted as 4 (NC-19).
    pub(super) position: u16,
    /// How each open branch is closed, two bits each, the innermost in the lowest: by OR, AND, XOR.
    pub(super) closing: u16,
    /// Where the target of the jump stands that is open (NC-28): of an IF or an ELS, the innermost.
    pub(super) open: u16,
    /// The outputs that are not PWM, as they stand in the images.
    pub(super) outputs: u8,
    /// The outputs 05 to 08 that are not PWM, from bit 0 on.
    #[cfg(mega)]
    pub(super) more_outputs: u8,
    /// The port of the contacts that are pending, counted from 1; 0 of the images.
    #[cfg(mega)]
    pub(super) port: u8,
    pub(super) jumps_back: bool,
    /// What has been read and not been put yet.
    pub(super) pending: u8,
    pub(super) ones: u8,
    pub(super) zeros: u8,
    pub(super) count: u8,
    /// Where acc was last known to be: a branch point from 0, [`HEAD`], or none.
    pub(super) base: u8,
    /// The contact that came last: its bit, and whether it is normally open.
    pub(super) last: u8,
    pub(super) normally_open: u8,
}

/// [`Job::pending`] where a rung has begun.
pub(super) const RUNG: u8 = 1;
/// The head of a rung, beside the branch points.
pub(super) const HEAD: u8 = 8;
/// Of a label that is not known yet, so it stands further on.
const AHEAD: u8 = 0xFF;

// SAFETY: `link.s` defines it so.
unsafe extern "C" {
    fn engine_link(job: &mut Job);
}

/// For `link.s`: the next stored byte, less than 0 at the end.
#[unsafe(no_mangle)]
unsafe extern "C" fn engine_next(reader: *mut c_void) -> i16 {
    // SAFETY: it is the one that `pass` has put into the job, and lends for as long.
    let reader = unsafe { &mut *reader.cast::<Reader<'_>>() };
    reader.next().map_or(-1, i16::from)
}

/// One passage through the stored form, which sets up timers and counters too. The registers hold labels
/// meanwhile, the places of each in the linked and in the stored form; after the first passage they have
/// all of them, and no later one finds others. Only what fits is written to `code`.
///
/// # Errors
/// [`Cause::NoStoredProgram`] where the EEPROM does not hold what was checked.
#[inline(never)]
pub fn pass(layout: &mut Layout<'_>, eeprom: &Eeprom, code: &mut [u8]) -> Result<Size, Cause> {
    layout.memory.counters.fill(0);
    let mut reader = layout.stored.read(eeprom);
    let timers = layout.timer(0);
    let own_end = layout.own_end();
    let counters = layout.memory.counters.as_ptr() as usize as u16;
    let mut job = Job {
        reader: (&raw mut reader).cast(),
        put: layout.begin,
        limit: match code.len() as u16 {
            0 => 0,
            length => layout.begin + length,
        },
        own: own_end,
        timer: timers,
        timers,
        timers_end: timers + layout.memory.timers.len() as u16,
        counters,
        counters_end: counters + layout.memory.counters.len() as u16,
        kept: own_end,
        kept_end: own_end + 2 * u16::from(layout.stored.numbers),
        position: 0,
        closing: 0,
        open: layout.begin,
        outputs: !(layout.stored.needs.pwm as u8) << POINTS,
        #[cfg(mega)]
        more_outputs: !(layout.stored.needs.pwm as u8) >> POINTS,
        #[cfg(mega)]
        port: 0,
        jumps_back: false,
        pending: RUNG,
        ones: 0,
        zeros: 0,
        count: 0,
        base: HEAD,
        last: 0,
        normally_open: 0,
    };
    // SAFETY: it writes linked bytes from the first up to the limit, which are those of `code`; the
    // data of timers and counters and the addresses of what is kept, which are those of the layout; and the registers, by their own
    // address. All of them are borrowed here.
    unsafe { engine_link(&mut job) };
    layout.jumps_back |= job.jumps_back;
    let size = Size {
        code: job.put.wrapping_sub(layout.begin),
        own: own_end.wrapping_sub(job.own),
    };
    if reader.is_whole() {
        Ok(size)
    } else {
        Err(Cause::NoStoredProgram)
    }
}

/// Before the first passage: no label is known.
pub fn forget_labels(data: &mut Data) {
    data.registers.as_flattened_mut().fill(AHEAD);
}

/// After a passage: whether it has found any.
pub fn has_labels(data: &Data) -> bool {
    data.registers
        .as_flattened()
        .iter()
        .any(|&byte| byte != AHEAD)
}
