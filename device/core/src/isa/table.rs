//! The instruction table: every instruction, once.

use super::{Class, Kind, Row};

/// Hands the rows of the instruction table to a macro, which takes from each what it needs: the table of
/// this crate its code and its form, the firmware its handler, the compiler and the ladder their words. What
/// stands behind the macro's name comes before the rows.
///
/// A row is, in this order:
///
/// - the [`Opcode`](crate::isa::Opcode), its [`Kind`](crate::isa::Kind) and its [`Class`](crate::isa::Class);
/// - the code, with XX = 00 where it has an XX, and its letters;
/// - the byte that stores it, the bytes of run memory ([`Row::run`](crate::isa::Row::run)), and how many of them are
///   data of its own ([`Row::own`](crate::isa::Row::own));
/// - the effect in one line;
/// - the label of its handler in a board's engine. Where several rows share a handler, they share a label;
/// - how Instruction List says it: the line, or of a contact, a load and a store the operand alone, which
///   several operators may take. Empty where it has no words for it;
/// - how a ladder shows it: the text of the symbol that its class has.
///
/// In the last two, `XX` is the point by its name, `operand` what follows the code, and `value` what the value
/// accumulator holds.
#[macro_export]
macro_rules! instructions {
    ($consumer:ident $($before:tt)*) => { $consumer! { $($before)*
        NewRung           None     Rung         787600    "NL"   0x01  1 0 "new rung: acc := 1; the branch points of the rung before are forgotten"
            engine_new_rung "" "";
        OpenBranch        None     OpenOr       40        "("    0x02  1 0 "open an OR branch: push acc; acc := 1"
            engine_open_branch "OR" "";
        CloseBranch       None     Close        41        ")"    0x03  1 0 "close the branch: acc := popped value OR acc; after 6540 AND, after 8840 XOR"
            engine_close_branch "" "";
        OnDelay           Timer    Timer        847978    "TON"  0x04 11 0 "on-delay timer: IN = acc; acc := Q; output := Q"
            engine_on_delay "TON" "TON";
        OffDelay          Timer    Timer        847970    "TOF"  0x05 11 0 "off-delay timer: IN = acc; acc := Q; output := Q"
            engine_off_delay "TOF" "TOF";
        Not               None     Logic        787984    "NOT"  0x06  2 0 "acc := NOT acc"
            engine_not "NOT" "NOT";
        RisingEdge        None     Logic        6985      "EU"   0x07  5 1 "acc := 1 if acc has risen since the scan before"
            engine_rise "EU" "P";
        FallingEdge       None     Logic        6968      "ED"   0x08  5 1 "acc := 1 if acc has fallen since the scan before"
            engine_fall "ED" "N";
        OpenAnd           None     OpenAnd      6540      "A("   0x09  3 0 "open an AND block: push acc; acc := 1"
            engine_open_branch "AND" "";
        OpenXor           None     OpenXor      8840      "X("   0x0A  3 0 "open an XOR block: push acc; acc := 1"
            engine_open_branch "XOR" "";
        Return            None     Leave        826984    "RET"  0x0B  2 0 "return: if acc = 1, the program ends for this scan"
            engine_return "RETC" "<RET>";
        ReturnNot         None     Leave        -826984   "-RET" 0x0C  2 0 "return: if acc = 0, the program ends for this scan"
            engine_return_not "RETCN" "<RET>";
        Negate            None     Operation    786971    "NEG"  0x0D  2 0 "value := -value"
            engine_negate "NEG" "NEG";
        SquareRoot        None     Operation    838182    "SQR"  0x0E  2 0 "value := whole square root of value; of a negative one 0, and S 04 := 1"
            engine_square_root "SQRT" "SQR";
        Pulse             Timer    Timer        8480      "TP"   0x0F 12 0 "pulse timer: IN = acc; acc := Q; output := Q"
            engine_pulse "TP" "TP";
        InputContact      Input    Contact      827300    "RI"   0x10  1 0 "contact, normally open: acc := acc AND input XX"
            engine_contact "XX" "XX";
        InputContactNot   Input    Contact      -827300   "-RI"  0x20  1 0 "contact, normally closed: acc := acc AND NOT input XX"
            engine_contact_not "XX" "XX";
        OutputContact     Output   Contact      827900    "RO"   0x30  1 0 "contact: acc := acc AND output XX, as the image stands now"
            engine_contact "XX" "XX";
        OutputContactNot  Output   Contact      -827900   "-RO"  0x40  1 0 "contact: acc := acc AND NOT output XX, as the image stands now"
            engine_contact_not "XX" "XX";
        Coil              Output   Coil         877900    "WO"   0x50  1 0 "coil: output XX := acc"
            engine_coil "ST XX" "";
        SetCoil           Output   Coil         83877900  "SWO"  0x60  1 0 "set coil: if acc = 1, output XX := 1"
            engine_set_coil "S XX" "S";
        ResetCoil         Output   Coil         82877900  "RWO"  0x70  1 0 "reset coil: if acc = 1, output XX := 0"
            engine_reset_coil "R XX" "R";
        StoreBranch       Branch   StorePoint   404100    "()"   0x80  1 0 "OR store: remember acc as branch point XX"
            engine_store_branch "" "";
        RecallBranch      Branch   RecallPoint  404100    "()"   0x90  1 0 "as the very next code after 40, 6540 or 8840: acc := what branch point XX remembers"
            engine_recall_branch "" "";
        RetentiveOnDelay  Timer    Timer        847982    "TOR"  0xA0 12 0 "retentive on-delay timer: IN = acc; acc := Q; output := Q"
            engine_retentive "TONR" "TOR";
        NegatedCoil       Output   Coil         -877900   "-WO"  0xA1  3 0 "negated coil: output XX := NOT acc"
            engine_coil_not "STN XX" "/";
        MarkerContact     Marker   Contact      827700    "RM"   0xA2  2 0 "contact: acc := acc AND marker XX"
            engine_cell "XX" "XX";
        MarkerContactNot  Marker   Contact      -827700   "-RM"  0xA3  2 0 "contact: acc := acc AND NOT marker XX"
            engine_cell_not "XX" "XX";
        SystemContact     System   Contact      828300    "RS"   0xA4  2 0 "contact: acc := acc AND system marker XX"
            engine_cell "XX" "XX";
        SystemContactNot  System   Contact      -828300   "-RS"  0xA5  2 0 "contact: acc := acc AND NOT system marker XX"
            engine_cell_not "XX" "XX";
        TimerContact      TimerQ   Contact      828400    "RT"   0xA6  3 0 "contact: acc := acc AND Q of timer XX"
            engine_far_cell "XX.Q" "XX";
        TimerContactNot   TimerQ   Contact      -828400   "-RT"  0xA7  3 0 "contact: acc := acc AND NOT Q of timer XX"
            engine_far_cell_not "XX.Q" "XX";
        CounterContact    Counter  Contact      826700    "RC"   0xA8  4 0 "contact: acc := acc AND (counter XX has reached its preset)"
            engine_reached "XX.QU" "XX";
        CounterContactNot Counter  Contact      -826700   "-RC"  0xA9  4 0 "contact: acc := acc AND NOT (counter XX has reached its preset)"
            engine_reached_not "XX.QU" "XX";
        ZeroContact       Counter  Condition    829000    "RZ"   0xAA  4 0 "contact: acc := acc AND (counter XX is 0 or less)"
            engine_zero "XX.QD" "XX <= 0";
        ZeroContactNot    Counter  Condition    -829000   "-RZ"  0xAB  4 0 "contact: acc := acc AND NOT (counter XX is 0 or less)"
            engine_zero_not "XX.QD" "XX > 0";
        XorInput          Input    Xor          887300    "XI"   0xAC  4 0 "acc := acc XOR input XX"
            engine_xor "XOR XX" "XOR XX";
        XorInputNot       Input    Xor          -887300   "-XI"  0xAD  4 0 "acc := acc XOR NOT input XX"
            engine_xor_not "XORN XX" "XOR /XX";
        XorOutput         Output   Xor          887900    "XO"   0xAE  3 0 "acc := acc XOR output XX, as the image stands now"
            engine_xor "XOR XX" "XOR XX";
        XorOutputNot      Output   Xor          -887900   "-XO"  0xAF  3 0 "acc := acc XOR NOT output XX, as the image stands now"
            engine_xor_not "XORN XX" "XOR /XX";
        XorMarker         Marker   Xor          887700    "XM"   0xB0  4 0 "acc := acc XOR marker XX"
            engine_xor_cell "XOR XX" "XOR XX";
        XorMarkerNot      Marker   Xor          -887700   "-XM"  0xB1  4 0 "acc := acc XOR NOT marker XX"
            engine_xor_cell_not "XORN XX" "XOR /XX";
        MarkerCoil        Marker   Coil         877700    "WM"   0xB2  2 0 "coil: marker XX := acc"
            engine_cell_coil "ST XX" "";
        NegatedMarkerCoil Marker   Coil         -877700   "-WM"  0xB3  4 0 "negated coil: marker XX := NOT acc"
            engine_cell_coil_not "STN XX" "/";
        SetMarker         Marker   Coil         83877700  "SWM"  0xB4  4 0 "set coil: if acc = 1, marker XX := 1"
            engine_cell_set "S XX" "S";
        ResetMarker       Marker   Coil         82877700  "RWM"  0xB5  4 0 "reset coil: if acc = 1, marker XX := 0"
            engine_cell_reset "R XX" "R";
        ResetTimer        TimerQ   Coil         82878400  "RWT"  0xB6  4 0 "reset: if acc = 1, timer XX is as if it had never been started"
            engine_reset_timer "R XX" "R";
        ResetCounter      Counter  Coil         82876700  "RWC"  0xB7  4 0 "reset: if acc = 1, counter XX := 0"
            engine_reset_counter "R XX" "R";
        LoadCounter       Counter  Coil         83876700  "SWC"  0xB8  4 0 "load: if acc = 1, counter XX := its preset"
            engine_load_counter "S XX" "L";
        CountUp           Count    Count        67848500  "CTU"  0xB9  4 0 "up-counter: if acc has risen, counter XX + 1; acc := counter XX has reached its preset"
            engine_count_up "CTU XX, operand" "CTU XX operand";
        CountDown         Count    Count        67846800  "CTD"  0xBA  4 0 "down-counter: if acc has risen, counter XX - 1; acc := counter XX is 0 or less"
            engine_count_down "CTD XX, operand" "CTD XX operand";
        Load              Value    Load         766800    "LD"   0xBB  1 0 "value := register XX"
            engine_load "operand" "operand";
        LoadAnalogue      Analogue Load         76686500  "LDA"  0xBC  4 0 "value := analogue input A XX, 0 to 1023"
            engine_load_word "XX" "XX";
        LoadTimer         TimerQ   Load         76688400  "LDT"  0xBD  4 0 "value := elapsed time of timer XX, ms"
            engine_load_timer "XX.ET" "XX";
        LoadCount         Counter  Load         76686700  "LDC"  0xBE  4 0 "value := counter XX"
            engine_load "XX.CV" "XX";
        LoadSystem        Reading  Load         76688300  "LDS"  0xBF  3 0 "value := system reading XX: 01 time of the last scan in µs, 02 time stamp of this scan in ms"
            engine_load "" "XX";
        LoadMarkers       Group    Load         76687700  "LDM"  0xC0  4 0 "value := eight markers as bits: group 01 is M 01 to M 08"
            engine_load_markers "XX" "XX";
        LoadInputs        None     Load         76687300  "LDI"  0xC1  2 0 "value := all inputs as bits, input 01 the lowest"
            engine_load_inputs "IB0" "I";
        LoadOutputs       None     Load         76687900  "LDO"  0xC2  2 0 "value := all outputs as bits, output 01 the lowest"
            engine_load_outputs "QB0" "Q";
        LoadBit           None     LoadResult   76686600  "LDB"  0xC3  2 0 "value := acc"
            engine_load_bit "" "LD RESULT";
        Store             Register Store        838400    "ST"   0xC4  2 0 "if acc = 1, register XX := value"
            engine_store "XX" "ST XX";
        StoreCount        Counter  Store        83846700  "STC"  0xC5  4 0 "if acc = 1, counter XX := value"
            engine_store "XX.CV" "ST XX";
        StorePwm          Pwm      Store        83848000  "STP"  0xC6  4 0 "if acc = 1, PWM of output XX := value, cut to 0 to 255"
            engine_store_pwm "XX" "ST PWM XX";
        StoreMarkers      Group    Store        83847700  "STM"  0xC7  4 0 "if acc = 1, eight markers := the low bits of value"
            engine_store_markers "XX" "ST XX";
        StoreOutputs      None     Store        83847900  "STO"  0xC8  3 0 "if acc = 1, all outputs := the low bits of value"
            engine_store_outputs "QB0" "ST Q";
        PresetCounter     Counter  Store        80866700  "PVC"  0xC9  4 0 "if acc = 1, preset of counter XX := value, at least 0"
            engine_preset "XX.PV" "PRESET XX";
        PresetTimer       TimerQ   Store        80868400  "PVT"  0xCA  4 0 "if acc = 1, preset of timer XX := value, at least 0"
            engine_preset "XX.PT" "PRESET XX";
        Add               Value    Operation    65686800  "ADD"  0xCB  1 0 "value := value + operand"
            engine_add "ADD operand" "ADD operand";
        Subtract          Value    Operation    83856600  "SUB"  0xCC  1 0 "value := value - operand"
            engine_subtract "SUB operand" "SUB operand";
        Multiply          Value    Operation    77857600  "MUL"  0xCD  2 0 "value := value * operand"
            engine_multiply "MUL operand" "MUL operand";
        Divide            Value    Operation    68738600  "DIV"  0xCE  2 0 "value := value / operand, without the fraction; by 0: 0, and S 04 := 1"
            engine_divide "DIV operand" "DIV operand";
        Modulo            Value    Operation    77796800  "MOD"  0xCF  2 0 "value := rest of value / operand; by 0: 0, and S 04 := 1"
            engine_modulo "MOD operand" "MOD operand";
        AndWord           Value    Operation    65786800  "AND"  0xD0  2 0 "value := value AND operand, bit by bit"
            engine_and "AND operand" "AND operand";
        OrWord            Value    Operation    798200    "OR"   0xD1  2 0 "value := value OR operand, bit by bit"
            engine_or "OR operand" "OR operand";
        XorWord           Value    Operation    88798200  "XOR"  0xD2  2 0 "value := value XOR operand, bit by bit"
            engine_exor "XOR operand" "XOR operand";
        ShiftLeft         Bit      Operation    83727600  "SHL"  0xD3  3 0 "value := value shifted left by XX bits"
            engine_shift_left "SHL XX" "SHL XX";
        ShiftRight        Bit      Operation    83728200  "SHR"  0xD4  3 0 "value := value shifted right by XX bits; zeros come in"
            engine_shift_right "SHR XX" "SHR XX";
        Greater           Value    Comparison   718400    "GT"   0xD5  2 0 "comparison: acc := acc AND (value > operand)"
            engine_greater "GT operand" "value > operand";
        GreaterOrEqual    Value    Comparison   716900    "GE"   0xD6  2 0 "comparison: acc := acc AND (value >= operand)"
            engine_greater_or_equal "GE operand" "value >= operand";
        Equal             Value    Comparison   698100    "EQ"   0xD7  2 0 "comparison: acc := acc AND (value = operand)"
            engine_equal "EQ operand" "value = operand";
        NotEqual          Value    Comparison   786900    "NE"   0xD8  2 0 "comparison: acc := acc AND (value <> operand)"
            engine_not_equal "NE operand" "value <> operand";
        LessOrEqual       Value    Comparison   766900    "LE"   0xD9  2 0 "comparison: acc := acc AND (value <= operand)"
            engine_less_or_equal "LE operand" "value <= operand";
        Less              Value    Comparison   768400    "LT"   0xDA  2 0 "comparison: acc := acc AND (value < operand)"
            engine_less "LT operand" "value < operand";
        BitContact        Bit      ValueContact 66738400  "BIT"  0xDB  3 0 "contact: acc := acc AND bit XX of value"
            engine_bit "" "value.XX";
        BitContactNot     Bit      ValueContact -66738400 "-BIT" 0xDC  3 0 "contact: acc := acc AND NOT bit XX of value"
            engine_bit_not "" "value.XX";
        Move              Move     Store        77798600  "MOV"  0xDD  7 0 "block move: if acc = 1, copy registers from XX on"
            engine_move "" "MOV operand";
        Drum              Drum     Store        68827700  "DRM"  0xDE  5 0 "sequencer: if acc = 1, outputs 01-04 := the step that register XX tells"
            engine_drum "" "DRM XX";
        Scale             Scale    Operation    836776    "SCL"  0xDF 10 0 "linear scaling: value := value from one range to another"
            engine_scale "" "SCL operand";
        Filter            Filter   Operation    70768400  "FLT"  0xE0 16 9 "first-order filter: value := value, smoothed by strength XX"
            engine_filter "" "FLT operand";
        Integrate         Register Store        73788400  "INT"  0xE1 13 7 "integration: if acc = 1, register XX + value per second"
            engine_integrate "" "INT XX";
        InputFilter       Time     Setting      707300    "FI"   0xE2  0 0 "input filter: an input must keep a level for XX ms"
            engine_end "" "INPUT FILTER XX ms";
        Label             Label    Label        766600    "LB"   0xE3  4 0 "label XX, at the head of a rung"
            engine_label "" "";
        Jump              Jump     Leave        74778000  "JMP"  0xE4  8 0 "jump: if acc = 1, go on at label XX"
            engine_jump "JMPC XX" ">> XX";
        JumpNot           Jump     Leave        -74778000 "-JMP" 0xE5  8 0 "jump: if acc = 0, go on at label XX"
            engine_jump_not "JMPCN XX" ">> XX";
        KeepRegister      Register Setting      756800    "KD"   0xE6  6 6 "register XX is kept over STOP and over a power cut"
            engine_end "" "KEEP XX";
        KeepCounter       Counter  Setting      756700    "KC"   0xE7  6 6 "the number of counter XX is kept over STOP and over a power cut"
            engine_end "" "KEEP XX";
        Push              None     Operation    808372    "PSH"  0xE8  2 0 "push value; an operation with number 99 takes it as its left operand"
            engine_push "PUSH" "PUSH";
        RealAdd           Real     Operation    82656800  "RAD"  0xE9  2 0 "REAL: value := value + operand; not finite: 0, and S 04 := 1"
            engine_real_add "REAL_ADD operand" "REAL ADD operand";
        RealSubtract      Real     Operation    82838500  "RSU"  0xEA  2 0 "REAL: value := value - operand; not finite: 0, and S 04 := 1"
            engine_real_subtract "REAL_SUB operand" "REAL SUB operand";
        RealMultiply      Real     Operation    82778500  "RMU"  0xEB  2 0 "REAL: value := value * operand; not finite: 0, and S 04 := 1"
            engine_real_multiply "REAL_MUL operand" "REAL MUL operand";
        RealDivide        Real     Operation    82687300  "RDI"  0xEC  2 0 "REAL: value := value / operand; not finite: 0, and S 04 := 1"
            engine_real_divide "REAL_DIV operand" "REAL DIV operand";
        RealFromSigned    None     Operation    738482    "ITR"  0xED  2 0 "value := value, a whole number with a sign, as a REAL"
            engine_real_from_signed "DINT_TO_REAL" "DINT_TO_REAL";
        RealFromUnsigned  None     Operation    858482    "UTR"  0xEE  2 0 "value := value, a whole number without a sign, as a REAL"
            engine_real_from_unsigned "UDINT_TO_REAL" "UDINT_TO_REAL";
        RealRound         None     Operation    827868    "RND"  0xEF  2 0 "value := value, a REAL, as the nearest whole number, halves to even; beyond 32 bits: 0, and S 04 := 1"
            engine_real_round "REAL_TO_DINT" "REAL_TO_DINT";
        RealCut           None     Operation    848267    "TRC"  0xF0  2 0 "value := value, a REAL, without its fraction; beyond 32 bits: 0, and S 04 := 1"
            engine_real_cut "TRUNC" "TRUNC";
        RealNegate        None     Operation    827871    "RNG"  0xF1  2 0 "REAL: value := -value"
            engine_real_negate "REAL_NEG" "REAL NEG";
        RealAbsolute      None     Operation    826566    "RAB"  0xF2  2 0 "REAL: value := value without its sign"
            engine_real_absolute "REAL_ABS" "REAL ABS";
        RealRoot          None     Operation    828284    "RRT"  0xF3  2 0 "REAL: value := square root of value; of a negative one 0, and S 04 := 1"
            engine_real_root "REAL_SQRT" "REAL SQRT";
        RealComparable    None     Operation    677782    "CMR"  0xF4  2 0 "value := a whole number that compares with others as the REAL did"
            engine_real_comparable "REAL_ORDER" "REAL ORDER";
        LoadTable         Table    Operation    76688800  "LDX"  0xF5  5 0 "value := register XX + value; outside the table 0, and S 04 := 1"
            engine_load_table "TABLE_LD operand" "TABLE operand";
        StoreTable        Table    Store        83848800  "STX"  0xF6  5 0 "if acc = 1, register XX + the pushed value := value; outside the table S 04 := 1"
            engine_store_table "TABLE_ST operand" "ST TABLE operand";
        ExtendSign        Bit      Operation    83888400  "SXT"  0xF7  3 0 "value := its low XX bits, the highest of them as the sign"
            engine_extend_sign "SIGNED XX" "SIGNED XX";
        ExtendZero        Bit      Operation    90888400  "ZXT"  0xF8  3 0 "value := its low XX bits"
            engine_extend_zero "UNSIGNED XX" "UNSIGNED XX";
        UnsignedDivide    Value    Operation    85688600  "UDV"  0xF9  2 0 "value := value / operand, both without signs; by 0: 0, and S 04 := 1"
            engine_unsigned_divide "UDIV operand" "UDIV operand";
        UnsignedModulo    Value    Operation    85777900  "UMO"  0xFA  2 0 "value := rest of value / operand, both without signs; by 0: 0, and S 04 := 1"
            engine_unsigned_modulo "UMOD operand" "UMOD operand";
        UnsignedGreaterOrEqual Value Comparison 85716900  "UGE"  0xFB  2 0 "comparison: acc := acc AND (value >= operand), both without signs"
            engine_unsigned_greater_or_equal "UGE operand" "value >= operand";
        UnsignedLess      Value    Comparison   85768400  "ULT"  0xFC  2 0 "comparison: acc := acc AND (value < operand), both without signs"
            engine_unsigned_less "ULT operand" "value < operand";
        If                None     If           7370      "IF"   0xFD  4 0 "if acc = 1, go on here, else behind the ELS or END that belongs to it; a new rung"
            engine_jump_not "IF" "IF";
        Else              None     Part         697683    "ELS"  0xFE  9 0 "from here on if acc at its IF was 0; a new rung"
            engine_jump "ELSE" "ELSE";
        EndIf             None     Part         697868    "END"  0xFF  4 0 "the end of an IF; a new rung"
            engine_label "END_IF" "END_IF";
    } };
}

macro_rules! table {
    ($($name:ident $kind:ident $class:ident $code:literal $letters:literal $stored:literal $run:literal $own:literal
        $effect:literal $handler:ident $il:literal $picture:literal;)*) => {
        /// The instruction table, in the order of the stored bytes. Of two rows that a code fits, the
        /// first is meant.
        pub const TABLE: &[Row] = &[$(*Opcode::$name.row(),)*];

        /// An instruction without its operand. Its discriminant is the byte that stores it.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        #[repr(u8)]
        pub enum Opcode {
            $(#[doc = $effect] $name = $stored,)*
        }

        impl Opcode {
            /// Every opcode, in the order of the table.
            pub const ALL: &'static [Opcode] = &[$(Opcode::$name,)*];

            /// The opcode of an instruction's first stored byte.
            pub const fn of_stored(byte: u8) -> Option<Opcode> {
                match super::first_of(byte) {
                    $($stored => Some(Opcode::$name),)*
                    _ => None,
                }
            }

            /// The row of the table.
            pub const fn row(self) -> &'static Row {
                match self {
                    $(Opcode::$name => const {
                        &Row {
                            code: $code,
                            letters: $letters,
                            kind: Kind::$kind,
                            class: Class::$class,
                            stored: $stored,
                            run: $run,
                            own: $own,
                            effect: $effect,
                        }
                    },)*
                }
            }
        }
    };
}

// A recall has the code of a store, and comes after it: the loader tells them apart by what stands before.
instructions!(table);
