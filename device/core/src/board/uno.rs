//! The Arduino UNO and the Arduino Nano, and the engine of their firmware.

use super::{Board, Engine};
use crate::Image;
use crate::isa::{MARKER_TARGET, Opcode, TABLE, packed_rows};

/// Hands the rows of the engine of `firmware/` to a macro, in the order of the
/// [instruction table](crate::isa::TABLE). What stands after the macro's name comes before the rows.
///
/// A row is the [`Opcode`](crate::isa::Opcode), its bytes of run memory ([`Engine::run_bytes`](crate::Engine::run_bytes)), and the
/// label of its handler. Where several rows share a handler, they share a label.
#[macro_export]
macro_rules! uno_engine {
    ($consumer:ident $($before:tt)*) => { $consumer! { $($before)*
        NewRung                 1 engine_new_rung;
        OpenBranch              1 engine_open_branch;
        CloseBranch             1 engine_close_branch;
        OnDelay                11 engine_on_delay;
        OffDelay               11 engine_off_delay;
        Not                     2 engine_not;
        RisingEdge              5 engine_rise;
        FallingEdge             5 engine_fall;
        OpenAnd                 3 engine_open_branch;
        OpenXor                 3 engine_open_branch;
        Return                  2 engine_return;
        ReturnNot               2 engine_return_not;
        Negate                  2 engine_negate;
        SquareRoot              2 engine_square_root;
        Pulse                  12 engine_pulse;
        InputContact            1 engine_contact;
        InputContactNot         1 engine_contact_not;
        OutputContact           1 engine_contact;
        OutputContactNot        1 engine_contact_not;
        Coil                    1 engine_coil;
        SetCoil                 1 engine_set_coil;
        ResetCoil               1 engine_reset_coil;
        StoreBranch             1 engine_store_branch;
        RecallBranch            1 engine_recall_branch;
        RetentiveOnDelay       12 engine_retentive;
        NegatedCoil             3 engine_coil_not;
        MarkerContact           2 engine_cell;
        MarkerContactNot        2 engine_cell_not;
        SystemContact           2 engine_cell;
        SystemContactNot        2 engine_cell_not;
        TimerContact            3 engine_far_cell;
        TimerContactNot         3 engine_far_cell_not;
        CounterContact          4 engine_reached;
        CounterContactNot       4 engine_reached_not;
        ZeroContact             4 engine_zero;
        ZeroContactNot          4 engine_zero_not;
        XorInput                4 engine_xor;
        XorInputNot             4 engine_xor_not;
        XorOutput               3 engine_xor;
        XorOutputNot            3 engine_xor_not;
        XorMarker               4 engine_xor_cell;
        XorMarkerNot            4 engine_xor_cell_not;
        MarkerCoil              2 engine_cell_coil;
        NegatedMarkerCoil       4 engine_cell_coil_not;
        SetMarker               4 engine_cell_set;
        ResetMarker             4 engine_cell_reset;
        ResetTimer              4 engine_reset_timer;
        ResetCounter            4 engine_reset_counter;
        LoadCounter             4 engine_load_counter;
        CountUp                 4 engine_count_up;
        CountDown               4 engine_count_down;
        Load                    1 engine_load;
        LoadAnalogue            4 engine_load_word;
        LoadTimer               4 engine_load_timer;
        LoadCount               4 engine_load;
        LoadSystem              3 engine_load;
        LoadMarkers             4 engine_load_markers;
        LoadInputs              2 engine_load_inputs;
        LoadOutputs             2 engine_load_outputs;
        LoadBit                 2 engine_load_bit;
        Store                   2 engine_store;
        StoreCount              4 engine_store;
        StorePwm                4 engine_store_pwm;
        StoreMarkers            4 engine_store_markers;
        StoreOutputs            3 engine_store_outputs;
        PresetCounter           4 engine_preset;
        PresetTimer             4 engine_preset;
        Add                     1 engine_add;
        Subtract                1 engine_subtract;
        Multiply                2 engine_multiply;
        Divide                  2 engine_divide;
        Modulo                  2 engine_modulo;
        AndWord                 2 engine_and;
        OrWord                  2 engine_or;
        XorWord                 2 engine_exor;
        ShiftLeft               3 engine_shift_left;
        ShiftRight              3 engine_shift_right;
        Greater                 2 engine_greater;
        GreaterOrEqual          2 engine_greater_or_equal;
        Equal                   2 engine_equal;
        NotEqual                2 engine_not_equal;
        LessOrEqual             2 engine_less_or_equal;
        Less                    2 engine_less;
        BitContact              3 engine_bit;
        BitContactNot           3 engine_bit_not;
        Move                    7 engine_move;
        Drum                    5 engine_drum;
        Scale                  10 engine_scale;
        Filter                 16 engine_filter;
        Integrate              13 engine_integrate;
        InputFilter             0 engine_end;
        Label                   4 engine_label;
        Jump                    8 engine_jump;
        JumpNot                 8 engine_jump_not;
        KeepRegister            6 engine_end;
        KeepCounter             6 engine_end;
        Push                    2 engine_push;
        RealAdd                 2 engine_real_add;
        RealSubtract            2 engine_real_subtract;
        RealMultiply            2 engine_real_multiply;
        RealDivide              2 engine_real_divide;
        RealFromSigned          2 engine_real_from_signed;
        RealFromUnsigned        2 engine_real_from_unsigned;
        RealRound               2 engine_real_round;
        RealCut                 2 engine_real_cut;
        RealNegate              2 engine_real_negate;
        RealAbsolute            2 engine_real_absolute;
        RealRoot                2 engine_real_root;
        RealComparable          2 engine_real_comparable;
        LoadTable               5 engine_load_table;
        StoreTable              5 engine_store_table;
        ExtendSign              3 engine_extend_sign;
        ExtendZero              3 engine_extend_zero;
        UnsignedDivide          2 engine_unsigned_divide;
        UnsignedModulo          2 engine_unsigned_modulo;
        UnsignedGreaterOrEqual  2 engine_unsigned_greater_or_equal;
        UnsignedLess            2 engine_unsigned_less;
        If                      4 engine_jump_not;
        Else                    9 engine_jump;
        EndIf                   4 engine_label;
    } };
}

macro_rules! run_bytes {
    ($($name:ident $run:literal $handler:ident;)*) => {
        /// A match without a wildcard: the compiler names an instruction that has no row here.
        pub(super) const fn run_bytes(opcode: Opcode) -> u8 {
            match opcode {
                $(Opcode::$name => $run,)*
            }
        }

        pub(super) const ROWS: &[Opcode] = &[$(Opcode::$name,)*];
    };
}
uno_engine!(run_bytes);

impl Engine {
    /// That of the UNO's firmware, direct threading in assembly.
    pub const UNO: Engine = Engine {
        rows: packed_rows(&{
            assert!(ROWS.len() == TABLE.len());
            let mut run = [0; TABLE.len()];
            let mut row = 0;
            while row < TABLE.len() {
                assert!(
                    ROWS[row] as u8 == TABLE[row].stored,
                    "the rows stand in the table's order"
                );
                run[row] = run_bytes(ROWS[row]);
                row += 1;
            }
            run
        }),
        links: true,
        fast_inputs: 4,
        fast_outputs: MARKER_TARGET,
        near_registers: 32,
    };
}

impl Board {
    /// The Arduino UNO with the standard wiring: eight inputs, of which the last four share their pins
    /// with analogue inputs, and four outputs. A contact or a coil of one takes one byte; a timer block
    /// takes 6 bytes stored and 11 in run memory.
    pub const UNO: Board = Board {
        name: "UNO",
        inputs: 8,
        outputs: 4,
        analogue: 5,
        shared_from: 5,
        pwm: Image(0b1001),
        markers: 64,
        counters: 16,
        // The linker keeps the place of each in a register that is always there.
        labels: 32,
        timers: 99,
        stored_bytes: 900,
        linked_bytes: 960,
        real: true,
        engine: &Engine::UNO,
    };

    /// The Arduino Nano, wired the same: its boot loader takes the room that REAL numbers would.
    pub const NANO: Board = Board {
        name: "Nano",
        real: false,
        ..Board::UNO
    };
}

/// The firmware has room for just these.
#[cfg(all(target_arch = "avr", not(mega)))]
const _: () = {
    use crate::width::{ANALOGUE, INPUTS, LABELS};
    let board = Board::UNO;
    assert!(board.inputs == INPUTS && board.labels == LABELS && board.analogue == ANALOGUE);
};
