//! The instruction table: every instruction, once.

use super::{Class, Kind, Row};

/// Hands the rows of the instruction table to a macro, which takes from each what it needs: the table of
/// this crate its code and its form, the firmware its stored byte, the compiler and the ladder their words. What
/// stands after the macro's name comes before the rows. What an instruction takes of a board's run memory, and the
/// label of its handler there, stand with the board's engine: [`uno_engine!`](crate::uno_engine).
///
/// A row is, in this order:
///
/// - the [`Opcode`](crate::isa::Opcode), its [`Kind`](crate::isa::Kind) and its [`Class`](crate::isa::Class);
/// - the code, with XX = 00 where it has an XX, and its letters;
/// - the byte that stores it, and how many bytes of run memory are data of its own
///   ([`Row::own`](crate::isa::Row::own));
/// - the effect in one line;
/// - how Instruction List says it: the line, or of a contact, a load and a store the operand alone, which
///   several operators may take. Empty where it has no words for it;
/// - how a ladder shows it: the text of the symbol that its class has.
///
/// In the last two, `XX` is the point by its name, `operand` what follows the code, and `value` what the value
/// accumulator holds.
#[macro_export]
macro_rules! instructions {
    ($consumer:ident $($before:tt)*) => { $consumer! { $($before)*
        NewRung           None     Rung         787600    "NL"   0x01 0 "new rung: acc := 1; the branch points of the previous rung are cleared"
            "" "";
        OpenBranch        None     OpenOr       40        "("    0x02 0 "open an OR branch: push acc; acc := 1"
            "OR" "";
        CloseBranch       None     Close        41        ")"    0x03 0 "close the branch: acc := popped value OR acc; after 6540 AND, after 8840 XOR"
            "" "";
        OnDelay           Timer    Timer        847978    "TON"  0x04 0 "on-delay timer: IN = acc; acc := Q; output := Q"
            "TON" "TON";
        OffDelay          Timer    Timer        847970    "TOF"  0x05 0 "off-delay timer: IN = acc; acc := Q; output := Q"
            "TOF" "TOF";
        Not               None     Logic        787984    "NOT"  0x06 0 "acc := NOT acc"
            "NOT" "NOT";
        RisingEdge        None     Logic        6985      "EU"   0x07 1 "acc := 1 if acc has risen since this code was last reached"
            "EU" "P";
        FallingEdge       None     Logic        6968      "ED"   0x08 1 "acc := 1 if acc has fallen since this code was last reached"
            "ED" "N";
        OpenAnd           None     OpenAnd      6540      "A("   0x09 0 "open an AND block: push acc; acc := 1"
            "AND" "";
        OpenXor           None     OpenXor      8840      "X("   0x0A 0 "open an XOR block: push acc; acc := 1"
            "XOR" "";
        Return            None     Leave        826984    "RET"  0x0B 0 "return: if acc = 1, the program ends for this scan"
            "RETC" "<RET>";
        ReturnNot         None     Leave        -826984   "-RET" 0x0C 0 "return: if acc = 0, the program ends for this scan"
            "RETCN" "<RET>";
        Negate            None     Operation    786971    "NEG"  0x0D 0 "value := -value"
            "NEG" "NEG";
        SquareRoot        None     Operation    838182    "SQR"  0x0E 0 "value := integer square root of value; if negative: 0, and S 04 := 1"
            "SQRT" "SQR";
        Pulse             Timer    Timer        8480      "TP"   0x0F 0 "pulse timer: IN = acc; acc := Q; output := Q"
            "TP" "TP";
        InputContact      Input    Contact      827300    "RI"   0x10 0 "contact, normally open: acc := acc AND input XX"
            "XX" "XX";
        InputContactNot   Input    Contact      -827300   "-RI"  0x20 0 "contact, normally closed: acc := acc AND NOT input XX"
            "XX" "XX";
        OutputContact     Output   Contact      827900    "RO"   0x30 0 "contact: acc := acc AND output XX, as it is now in the image"
            "XX" "XX";
        OutputContactNot  Output   Contact      -827900   "-RO"  0x40 0 "contact: acc := acc AND NOT output XX, as it is now in the image"
            "XX" "XX";
        Coil              Output   Coil         877900    "WO"   0x50 0 "coil: output XX := acc"
            "ST XX" "";
        SetCoil           Output   Coil         83877900  "SWO"  0x60 0 "set coil: if acc = 1, output XX := 1"
            "S XX" "S";
        ResetCoil         Output   Coil         82877900  "RWO"  0x70 0 "reset coil: if acc = 1, output XX := 0"
            "R XX" "R";
        StoreBranch       Branch   StorePoint   404100    "()"   0x80 0 "OR store: store acc as branch point XX"
            "" "";
        RecallBranch      Branch   RecallPoint  404100    "()"   0x90 0 "as the very next code after 40, 6540 or 8840: acc := the stored value of branch point XX"
            "" "";
        RetentiveOnDelay  Timer    Timer        847982    "TOR"  0xA0 0 "retentive on-delay timer: IN = acc; acc := Q; output := Q"
            "TONR" "TOR";
        NegatedCoil       Output   Coil         -877900   "-WO"  0xA1 0 "negated coil: output XX := NOT acc"
            "STN XX" "/";
        MarkerContact     Marker   Contact      827700    "RM"   0xA2 0 "contact: acc := acc AND marker XX"
            "XX" "XX";
        MarkerContactNot  Marker   Contact      -827700   "-RM"  0xA3 0 "contact: acc := acc AND NOT marker XX"
            "XX" "XX";
        SystemContact     System   Contact      828300    "RS"   0xA4 0 "contact: acc := acc AND system marker XX"
            "XX" "XX";
        SystemContactNot  System   Contact      -828300   "-RS"  0xA5 0 "contact: acc := acc AND NOT system marker XX"
            "XX" "XX";
        TimerContact      TimerQ   Contact      828400    "RT"   0xA6 0 "contact: acc := acc AND Q of timer XX"
            "XX.Q" "XX";
        TimerContactNot   TimerQ   Contact      -828400   "-RT"  0xA7 0 "contact: acc := acc AND NOT Q of timer XX"
            "XX.Q" "XX";
        CounterContact    Counter  Contact      826700    "RC"   0xA8 0 "contact: acc := acc AND (counter XX has reached its preset)"
            "XX.QU" "XX";
        CounterContactNot Counter  Contact      -826700   "-RC"  0xA9 0 "contact: acc := acc AND NOT (counter XX has reached its preset)"
            "XX.QU" "XX";
        ZeroContact       Counter  Condition    829000    "RZ"   0xAA 0 "contact: acc := acc AND (counter XX is 0 or less)"
            "XX.QD" "XX <= 0";
        ZeroContactNot    Counter  Condition    -829000   "-RZ"  0xAB 0 "contact: acc := acc AND NOT (counter XX is 0 or less)"
            "XX.QD" "XX > 0";
        XorInput          Input    Xor          887300    "XI"   0xAC 0 "acc := acc XOR input XX"
            "XOR XX" "XOR XX";
        XorInputNot       Input    Xor          -887300   "-XI"  0xAD 0 "acc := acc XOR NOT input XX"
            "XORN XX" "XOR /XX";
        XorOutput         Output   Xor          887900    "XO"   0xAE 0 "acc := acc XOR output XX, as it is now in the image"
            "XOR XX" "XOR XX";
        XorOutputNot      Output   Xor          -887900   "-XO"  0xAF 0 "acc := acc XOR NOT output XX, as it is now in the image"
            "XORN XX" "XOR /XX";
        XorMarker         Marker   Xor          887700    "XM"   0xB0 0 "acc := acc XOR marker XX"
            "XOR XX" "XOR XX";
        XorMarkerNot      Marker   Xor          -887700   "-XM"  0xB1 0 "acc := acc XOR NOT marker XX"
            "XORN XX" "XOR /XX";
        MarkerCoil        Marker   Coil         877700    "WM"   0xB2 0 "coil: marker XX := acc"
            "ST XX" "";
        NegatedMarkerCoil Marker   Coil         -877700   "-WM"  0xB3 0 "negated coil: marker XX := NOT acc"
            "STN XX" "/";
        SetMarker         Marker   Coil         83877700  "SWM"  0xB4 0 "set coil: if acc = 1, marker XX := 1"
            "S XX" "S";
        ResetMarker       Marker   Coil         82877700  "RWM"  0xB5 0 "reset coil: if acc = 1, marker XX := 0"
            "R XX" "R";
        ResetTimer        TimerQ   Coil         82878400  "RWT"  0xB6 0 "reset: if acc = 1, timer XX is as if it had never been started"
            "R XX" "R";
        ResetCounter      Counter  Coil         82876700  "RWC"  0xB7 0 "reset: if acc = 1, counter XX := 0"
            "R XX" "R";
        LoadCounter       Counter  Coil         83876700  "SWC"  0xB8 0 "load: if acc = 1, counter XX := its preset"
            "S XX" "L";
        CountUp           Count    Count        67848500  "CTU"  0xB9 0 "up-counter: if acc has risen, counter XX + 1; acc := counter XX has reached its preset"
            "CTU XX, operand" "CTU XX operand";
        CountDown         Count    Count        67846800  "CTD"  0xBA 0 "down-counter: if acc has risen, counter XX - 1; acc := counter XX is 0 or less"
            "CTD XX, operand" "CTD XX operand";
        Load              Value    Load         766800    "LD"   0xBB 0 "value := register XX"
            "operand" "operand";
        LoadAnalogue      Analogue Load         76686500  "LDA"  0xBC 0 "value := analogue input A XX, 0 to 1023"
            "XX" "XX";
        LoadTimer         TimerQ   Load         76688400  "LDT"  0xBD 0 "value := elapsed time of timer XX, ms"
            "XX.ET" "XX";
        LoadCount         Counter  Load         76686700  "LDC"  0xBE 0 "value := counter XX"
            "XX.CV" "XX";
        LoadSystem        Reading  Load         76688300  "LDS"  0xBF 0 "value := system reading XX: 01 time of the last scan in µs, 02 time stamp of this scan in ms"
            "" "XX";
        LoadMarkers       Group    Load         76687700  "LDM"  0xC0 0 "value := eight markers as bits: group 01 is M 01 to M 08"
            "XX" "XX";
        LoadInputs        None     Load         76687300  "LDI"  0xC1 0 "value := all inputs as bits, input 01 the lowest"
            "IB0" "I";
        LoadOutputs       None     Load         76687900  "LDO"  0xC2 0 "value := all outputs as bits, output 01 the lowest"
            "QB0" "Q";
        LoadBit           None     LoadResult   76686600  "LDB"  0xC3 0 "value := acc"
            "" "LD RESULT";
        Store             Register Store        838400    "ST"   0xC4 0 "if acc = 1, register XX := value"
            "XX" "ST XX";
        StoreCount        Counter  Store        83846700  "STC"  0xC5 0 "if acc = 1, counter XX := value"
            "XX.CV" "ST XX";
        StorePwm          Pwm      Store        83848000  "STP"  0xC6 0 "if acc = 1, PWM of output XX := value, limited to 0 to 255"
            "XX" "ST PWM XX";
        StoreMarkers      Group    Store        83847700  "STM"  0xC7 0 "if acc = 1, eight markers := the low bits of value"
            "XX" "ST XX";
        StoreOutputs      None     Store        83847900  "STO"  0xC8 0 "if acc = 1, all outputs := the low bits of value"
            "QB0" "ST Q";
        PresetCounter     Counter  Store        80866700  "PVC"  0xC9 0 "if acc = 1, preset of counter XX := value, at least 0"
            "XX.PV" "PRESET XX";
        PresetTimer       TimerQ   Store        80868400  "PVT"  0xCA 0 "if acc = 1, preset of timer XX := value, at least 0"
            "XX.PT" "PRESET XX";
        Add               Value    Operation    65686800  "ADD"  0xCB 0 "value := value + operand"
            "ADD operand" "ADD operand";
        Subtract          Value    Operation    83856600  "SUB"  0xCC 0 "value := value - operand"
            "SUB operand" "SUB operand";
        Multiply          Value    Operation    77857600  "MUL"  0xCD 0 "value := value * operand"
            "MUL operand" "MUL operand";
        Divide            Value    Operation    68738600  "DIV"  0xCE 0 "value := value / operand, without the fraction; division by 0: 0, and S 04 := 1"
            "DIV operand" "DIV operand";
        Modulo            Value    Operation    77796800  "MOD"  0xCF 0 "value := remainder of value / operand; division by 0: 0, and S 04 := 1"
            "MOD operand" "MOD operand";
        AndWord           Value    Operation    65786800  "AND"  0xD0 0 "value := value AND operand, bit by bit"
            "AND operand" "AND operand";
        OrWord            Value    Operation    798200    "OR"   0xD1 0 "value := value OR operand, bit by bit"
            "OR operand" "OR operand";
        XorWord           Value    Operation    88798200  "XOR"  0xD2 0 "value := value XOR operand, bit by bit"
            "XOR operand" "XOR operand";
        ShiftLeft         Bit      Operation    83727600  "SHL"  0xD3 0 "value := value shifted left by XX bits"
            "SHL XX" "SHL XX";
        ShiftRight        Bit      Operation    83728200  "SHR"  0xD4 0 "value := value shifted right by XX bits; zeros are shifted in"
            "SHR XX" "SHR XX";
        Greater           Value    Comparison   718400    "GT"   0xD5 0 "comparison: acc := acc AND (value > operand)"
            "GT operand" "value > operand";
        GreaterOrEqual    Value    Comparison   716900    "GE"   0xD6 0 "comparison: acc := acc AND (value >= operand)"
            "GE operand" "value >= operand";
        Equal             Value    Comparison   698100    "EQ"   0xD7 0 "comparison: acc := acc AND (value = operand)"
            "EQ operand" "value = operand";
        NotEqual          Value    Comparison   786900    "NE"   0xD8 0 "comparison: acc := acc AND (value <> operand)"
            "NE operand" "value <> operand";
        LessOrEqual       Value    Comparison   766900    "LE"   0xD9 0 "comparison: acc := acc AND (value <= operand)"
            "LE operand" "value <= operand";
        Less              Value    Comparison   768400    "LT"   0xDA 0 "comparison: acc := acc AND (value < operand)"
            "LT operand" "value < operand";
        BitContact        Bit      ValueContact 66738400  "BIT"  0xDB 0 "contact: acc := acc AND bit XX of value"
            "" "value.XX";
        BitContactNot     Bit      ValueContact -66738400 "-BIT" 0xDC 0 "contact: acc := acc AND NOT bit XX of value"
            "" "value.XX";
        Move              Move     Store        77798600  "MOV"  0xDD 0 "block move: if acc = 1, copy registers from XX on"
            "" "MOV operand";
        Drum              Drum     Store        68827700  "DRM"  0xDE 0 "sequencer: if acc = 1, outputs 01-04 := the step selected by register XX"
            "" "DRM XX";
        Scale             Scale    Operation    836776    "SCL"  0xDF 0 "linear scaling: value := value from one range to another"
            "" "SCL operand";
        Filter            Filter   Operation    70768400  "FLT"  0xE0 9 "first-order filter: value := value, smoothed by strength XX"
            "" "FLT operand";
        Integrate         Register Store        73788400  "INT"  0xE1 7 "integration: if acc = 1, register XX + value per second"
            "" "INT XX";
        InputFilter       Time     Setting      707300    "FI"   0xE2 0 "input filter: an input must keep a level for XX ms"
            "" "INPUT FILTER XX ms";
        Label             Label    Label        766600    "LB"   0xE3 0 "label XX, at the start of a rung"
            "" "";
        Jump              Jump     Leave        74778000  "JMP"  0xE4 0 "jump: if acc = 1, continue at label XX"
            "JMPC XX" ">> XX";
        JumpNot           Jump     Leave        -74778000 "-JMP" 0xE5 0 "jump: if acc = 0, continue at label XX"
            "JMPCN XX" ">> XX";
        KeepRegister      Register Setting      756800    "KD"   0xE6 6 "register XX is kept through STOP and a power cut"
            "" "KEEP XX";
        KeepCounter       Counter  Setting      756700    "KC"   0xE7 6 "the count of counter XX is kept through STOP and a power cut"
            "" "KEEP XX";
        Push              None     Operation    808372    "PSH"  0xE8 0 "push value; an operation with number 99 takes it as its left operand"
            "PUSH" "PUSH";
        RealAdd           Real     Operation    82656800  "RAD"  0xE9 0 "REAL: value := value + operand; not finite: 0, and S 04 := 1"
            "REAL_ADD operand" "REAL ADD operand";
        RealSubtract      Real     Operation    82838500  "RSU"  0xEA 0 "REAL: value := value - operand; not finite: 0, and S 04 := 1"
            "REAL_SUB operand" "REAL SUB operand";
        RealMultiply      Real     Operation    82778500  "RMU"  0xEB 0 "REAL: value := value * operand; not finite: 0, and S 04 := 1"
            "REAL_MUL operand" "REAL MUL operand";
        RealDivide        Real     Operation    82687300  "RDI"  0xEC 0 "REAL: value := value / operand; not finite: 0, and S 04 := 1"
            "REAL_DIV operand" "REAL DIV operand";
        RealFromSigned    None     Operation    738482    "ITR"  0xED 0 "value := value, a signed integer, as a REAL"
            "DINT_TO_REAL" "DINT_TO_REAL";
        RealFromUnsigned  None     Operation    858482    "UTR"  0xEE 0 "value := value, an unsigned integer, as a REAL"
            "UDINT_TO_REAL" "UDINT_TO_REAL";
        RealRound         None     Operation    827868    "RND"  0xEF 0 "value := value, a REAL, as the nearest whole number, ties to even; beyond 32 bits: 0, and S 04 := 1"
            "REAL_TO_DINT" "REAL_TO_DINT";
        RealCut           None     Operation    848267    "TRC"  0xF0 0 "value := value, a REAL, without its fraction; beyond 32 bits: 0, and S 04 := 1"
            "TRUNC" "TRUNC";
        RealNegate        None     Operation    827871    "RNG"  0xF1 0 "REAL: value := -value"
            "REAL_NEG" "REAL NEG";
        RealAbsolute      None     Operation    826566    "RAB"  0xF2 0 "REAL: value := value without its sign"
            "REAL_ABS" "REAL ABS";
        RealRoot          None     Operation    828284    "RRT"  0xF3 0 "REAL: value := square root of value; if negative: 0, and S 04 := 1"
            "REAL_SQRT" "REAL SQRT";
        RealComparable    None     Operation    677782    "CMR"  0xF4 0 "value := an integer that keeps the order of the REAL numbers"
            "REAL_ORDER" "REAL ORDER";
        LoadTable         Table    Operation    76688800  "LDX"  0xF5 0 "value := register XX + value; outside the table: 0, and S 04 := 1"
            "TABLE_LD operand" "TABLE operand";
        StoreTable        Table    Store        83848800  "STX"  0xF6 0 "if acc = 1, register XX + the pushed value := value; outside the table: S 04 := 1"
            "TABLE_ST operand" "ST TABLE operand";
        ExtendSign        Bit      Operation    83888400  "SXT"  0xF7 0 "value := its low XX bits, the highest of them as the sign"
            "SIGNED XX" "SIGNED XX";
        ExtendZero        Bit      Operation    90888400  "ZXT"  0xF8 0 "value := its low XX bits"
            "UNSIGNED XX" "UNSIGNED XX";
        UnsignedDivide    Value    Operation    85688600  "UDV"  0xF9 0 "value := value / operand, both unsigned; division by 0: 0, and S 04 := 1"
            "UDIV operand" "UDIV operand";
        UnsignedModulo    Value    Operation    85777900  "UMO"  0xFA 0 "value := remainder of value / operand, both unsigned; division by 0: 0, and S 04 := 1"
            "UMOD operand" "UMOD operand";
        UnsignedGreaterOrEqual Value Comparison 85716900  "UGE"  0xFB 0 "comparison: acc := acc AND (value >= operand), both unsigned"
            "UGE operand" "value >= operand";
        UnsignedLess      Value    Comparison   85768400  "ULT"  0xFC 0 "comparison: acc := acc AND (value < operand), both unsigned"
            "ULT operand" "value < operand";
        If                None     If           7370      "IF"   0xFD 0 "if acc = 1, continue here, otherwise after the matching ELS or END; a new rung"
            "IF" "IF";
        Else              None     Part         697683    "ELS"  0xFE 0 "continue here if acc was 0 at the matching IF; a new rung"
            "ELSE" "ELSE";
        EndIf             None     Part         697868    "END"  0xFF 0 "the end of an IF; a new rung"
            "END_IF" "END_IF";
    } };
}

macro_rules! table {
    ($($name:ident $kind:ident $class:ident $code:literal $letters:literal $stored:literal $own:literal
        $effect:literal $il:literal $picture:literal;)*) => {
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
