//! The page: 512 bytes of RAM with two lives; and run memory, which stands right after. While a card is read the page
//! holds a block of it; from then on the frame of the Modbus server, the settings, and the data of the running program.

use crate::engine::Data;
use crate::instructions::BOARD;
use crate::settings::Settings;
use unoclp_card::Block;
use unoclp_modbus::Frame;

/// Run memory: the code of the program and the data of its instructions, and a byte for the end.
pub type RunMemory = [u8; BOARD.linked_bytes as usize + 1];

/// Both, in this order: the registers of the program go on from one to the other.
#[repr(C)]
struct Ram {
    page: Block,
    memory: RunMemory,
}

/// The name is for the engine's assembly. Of all sections for what is 0 at first, the linker takes this one first, so
/// that it stands at the beginning of RAM: the engine reaches the end of the page by one byte. `cargo xtask firmware`
/// checks it.
#[unsafe(export_name = "PAGE")]
#[unsafe(link_section = ".bss")]
static mut RAM: Ram = Ram {
    page: [0; 512],
    memory: [0; size_of::<RunMemory>()],
};

/// The page and run memory.
///
/// # Safety
///
/// To be called once.
pub unsafe fn take() -> (&'static mut Block, &'static mut RunMemory) {
    let ram = &raw mut RAM;
    // SAFETY: there is no other way to it, and this one is taken once.
    let Ram { page, memory } = unsafe { &mut *ram };
    (page, memory)
}

/// The second life.
#[cfg(not(mega))]
#[repr(C)]
pub struct Running {
    /// The frame of the server.
    pub frame: Frame,
    /// What is set.
    pub settings: Settings,
    /// So that the data ends where the page does.
    unused:
        [u8; size_of::<Block>() - size_of::<Frame>() - size_of::<Settings>() - size_of::<Data>()],
    /// The data of the program; the engine's assembly knows it as `ENGINE`.
    pub data: Data,
}

/// The second life where there is room for the frame elsewhere.
#[cfg(mega)]
#[repr(C)]
pub struct Running {
    /// What is set.
    pub settings: Settings,
    /// So that the data ends where the page does.
    unused: [u8; size_of::<Block>() - size_of::<Settings>() - size_of::<Data>()],
    /// The data of the program; the engine's assembly knows it as `ENGINE`.
    pub data: Data,
}

#[cfg(mega)]
static mut FRAMES: [Frame; 2] = [[0; size_of::<Frame>()]; 2];

/// The frames of the server, one for each line.
///
/// # Safety
///
/// To be called once.
#[cfg(mega)]
pub unsafe fn frames() -> &'static mut [Frame; 2] {
    let frames = &raw mut FRAMES;
    // SAFETY: there is no other way to them, and this one is taken once.
    unsafe { &mut *frames }
}

const _: () = {
    assert!(size_of::<Running>() == size_of::<Block>());
    assert!(align_of::<Running>() == 1);
};

/// Begins the second life, with all zeros.
pub fn running(page: &mut Block) -> &mut Running {
    page.fill(0);
    // SAFETY: it fits, as asserted above, needs no alignment, and is made of integers, of which any bits
    // are a value. The block is borrowed for as long.
    unsafe { &mut *(&raw mut *page).cast() }
}
