//! Which handler runs which instruction.

use crate::board::flash::Table;
use unoclp_core::isa;

/// A handler; it is never called from here.
pub type Handler = unsafe extern "C" fn();

macro_rules! handlers {
    ($($name:ident $run:literal $handler:ident;)*) => {
        /// The handlers in the order of the instruction table. Instructions without a handler of their own
        /// name any.
        #[unsafe(link_section = ".progmem.data")]
        #[unsafe(export_name = "ENGINE_HANDLERS")]
        static HANDLERS: Table<Handler, { isa::TABLE.len() }> = Table::new([$({
            // SAFETY: this is the label of a handler. It is not called: only its address is used.
            unsafe extern "C" {
                fn $handler();
            }
            $handler
        },)*]);
    };
}

unoclp_core::uno_engine!(handlers);
