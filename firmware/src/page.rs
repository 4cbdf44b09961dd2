//! The page: 512 bytes of RAM with two lives. While a card is read they hold a block of it; from then on
//! the data of the running program, the frame of the Modbus server, and the settings.

use crate::engine::Data;
use crate::settings::Settings;
use unoclp_card::Block;
use unoclp_modbus::Frame;

/// The name is for the engine's assembly.
#[unsafe(export_name = "PAGE")]
static mut PAGE: Block = [0; 512];

/// The page.
///
/// # Safety
///
/// To be called once.
pub unsafe fn take() -> &'static mut Block {
    let page = &raw mut PAGE;
    // SAFETY: there is no other way to it, and this one is taken once.
    unsafe { &mut *page }
}

/// The second life.
#[repr(C)]
pub struct Running {
    /// The frame of the server.
    pub frame: Frame,
    /// The data of the program; the engine's assembly knows it as `ENGINE`.
    pub data: Data,
    /// What is set.
    pub settings: Settings,
}

const _: () = {
    assert!(size_of::<Running>() <= size_of::<Block>());
    assert!(align_of::<Running>() == 1);
    assert!(core::mem::offset_of!(Running, data) == 256);
};

/// Begins the second life, with all zeros.
pub fn running(page: &mut Block) -> &mut Running {
    page.fill(0);
    // SAFETY: it fits, as asserted above, needs no alignment, and is made of integers, of which any bits
    // are a value. The block is borrowed for as long.
    unsafe { &mut *(&raw mut *page).cast() }
}
