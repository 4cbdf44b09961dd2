//! Which handler runs which instruction.

use crate::board::flash::Table;
use unoclp_core::isa::{self, Opcode};

/// A handler; it is never called from here.
pub type Handler = unsafe extern "C" fn();

/// Declares the handlers of `handlers.s` and `more.s`, and gives them as the instruction table has their
/// instructions.
macro_rules! handlers {
    ($($opcode:ident $handler:ident;)*) => {
        const OPCODES: &[Opcode] = &[$(Opcode::$opcode,)*];

        /// The handlers in the order of the instruction table.
        #[unsafe(link_section = ".progmem.data")]
        #[unsafe(export_name = "ENGINE_HANDLERS")]
        static HANDLERS: Table<Handler, { isa::TABLE.len() }> = Table::new([$(symbols::$handler,)*]);
    };
}

/// What the assembly defines.
pub mod symbols {
    macro_rules! symbols {
        ($($handler:ident)*) => {
            // SAFETY: these are labels of the handlers. They are not called: only their addresses are
            // used.
            unsafe extern "C" {
                $(pub fn $handler();)*
            }
        };
    }
    symbols! {
        engine_new_rung engine_open_branch engine_close_branch engine_on_delay engine_off_delay
        engine_not engine_rise engine_fall engine_return engine_return_not engine_negate
        engine_square_root engine_pulse engine_contact engine_contact_not engine_coil engine_set_coil
        engine_reset_coil engine_store_branch engine_recall_branch engine_retentive engine_coil_not
        engine_cell engine_cell_not engine_reached engine_reached_not engine_zero engine_zero_not
        engine_xor engine_xor_not engine_xor_cell engine_xor_cell_not engine_cell_coil
        engine_cell_coil_not engine_cell_set engine_cell_reset engine_reset_timer engine_reset_counter
        engine_load_counter engine_count_up engine_count_down engine_load engine_load_word
        engine_load_timer engine_load_markers engine_load_inputs engine_load_outputs engine_load_bit
        engine_store engine_store_pwm engine_store_markers engine_store_outputs engine_preset engine_add
        engine_subtract engine_multiply engine_divide engine_modulo engine_and engine_or engine_exor
        engine_shift_left engine_shift_right engine_greater engine_greater_or_equal engine_equal
        engine_not_equal engine_less_or_equal engine_less engine_bit engine_bit_not engine_move
        engine_drum engine_scale engine_filter engine_integrate engine_label engine_jump engine_jump_not
        engine_end
    }
}

// Those without a handler of their own name any.
handlers! {
    NewRung engine_new_rung;
    OpenBranch engine_open_branch;
    CloseBranch engine_close_branch;
    OnDelay engine_on_delay;
    OffDelay engine_off_delay;
    Not engine_not;
    RisingEdge engine_rise;
    FallingEdge engine_fall;
    OpenAnd engine_open_branch;
    OpenXor engine_open_branch;
    Return engine_return;
    ReturnNot engine_return_not;
    Negate engine_negate;
    SquareRoot engine_square_root;
    Pulse engine_pulse;
    InputContact engine_contact;
    InputContactNot engine_contact_not;
    OutputContact engine_contact;
    OutputContactNot engine_contact_not;
    Coil engine_coil;
    SetCoil engine_set_coil;
    ResetCoil engine_reset_coil;
    StoreBranch engine_store_branch;
    RecallBranch engine_recall_branch;
    RetentiveOnDelay engine_retentive;
    NegatedCoil engine_coil_not;
    MarkerContact engine_cell;
    MarkerContactNot engine_cell_not;
    SystemContact engine_cell;
    SystemContactNot engine_cell_not;
    TimerContact engine_cell;
    TimerContactNot engine_cell_not;
    CounterContact engine_reached;
    CounterContactNot engine_reached_not;
    ZeroContact engine_zero;
    ZeroContactNot engine_zero_not;
    XorInput engine_xor;
    XorInputNot engine_xor_not;
    XorOutput engine_xor;
    XorOutputNot engine_xor_not;
    XorMarker engine_xor_cell;
    XorMarkerNot engine_xor_cell_not;
    MarkerCoil engine_cell_coil;
    NegatedMarkerCoil engine_cell_coil_not;
    SetMarker engine_cell_set;
    ResetMarker engine_cell_reset;
    ResetTimer engine_reset_timer;
    ResetCounter engine_reset_counter;
    LoadCounter engine_load_counter;
    CountUp engine_count_up;
    CountDown engine_count_down;
    Load engine_load;
    LoadAnalogue engine_load_word;
    LoadTimer engine_load_timer;
    LoadCount engine_load;
    LoadSystem engine_load;
    LoadMarkers engine_load_markers;
    LoadInputs engine_load_inputs;
    LoadOutputs engine_load_outputs;
    LoadBit engine_load_bit;
    Store engine_store;
    StoreCount engine_store;
    StorePwm engine_store_pwm;
    StoreMarkers engine_store_markers;
    StoreOutputs engine_store_outputs;
    PresetCounter engine_preset;
    PresetTimer engine_preset;
    Add engine_add;
    Subtract engine_subtract;
    Multiply engine_multiply;
    Divide engine_divide;
    Modulo engine_modulo;
    AndWord engine_and;
    OrWord engine_or;
    XorWord engine_exor;
    ShiftLeft engine_shift_left;
    ShiftRight engine_shift_right;
    Greater engine_greater;
    GreaterOrEqual engine_greater_or_equal;
    Equal engine_equal;
    NotEqual engine_not_equal;
    LessOrEqual engine_less_or_equal;
    Less engine_less;
    BitContact engine_bit;
    BitContactNot engine_bit_not;
    Move engine_move;
    Drum engine_drum;
    Scale engine_scale;
    Filter engine_filter;
    Integrate engine_integrate;
    InputFilter engine_end;
    Label engine_label;
    Jump engine_jump;
    JumpNot engine_jump_not;
}

const _: () = {
    let mut row = 0;
    while row < OPCODES.len() {
        assert!(OPCODES[row] as u8 == isa::TABLE[row].stored);
        row += 1;
    }
};
