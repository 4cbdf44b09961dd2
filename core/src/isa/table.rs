//! The instruction table: every instruction, once.

use super::{Kind, Row};

macro_rules! instructions {
    ($($name:ident $kind:ident $code:literal $letters:literal $stored:literal $run:literal $effect:literal;)*) => {
        /// The instruction table, in the order of the stored bytes. Of two rows that a code fits, the
        /// first is meant.
        pub const TABLE: &[Row] = &[$(Row {
            code: $code,
            letters: $letters,
            kind: Kind::$kind,
            stored: $stored,
            run: $run,
            effect: $effect,
        },)*];

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
                            stored: $stored,
                            run: $run,
                            effect: $effect,
                        }
                    },)*
                }
            }
        }
    };
}

// A recall has the code of a store, and comes after it: the loader tells them apart by what stands before.
instructions! {
    NewRung           None      787600    "NL"   0x01  1 "new rung: acc := 1; the branch points of the rung before are forgotten";
    OpenBranch        None      40        "("    0x02  1 "open an OR branch: push acc; acc := 1";
    CloseBranch       None      41        ")"    0x03  1 "close the branch: acc := popped value OR acc; after 6540 AND, after 8840 XOR";
    OnDelay           Timer     847978    "TON"  0x04 11 "on-delay timer: IN = acc; acc := Q; output := Q";
    OffDelay          Timer     847970    "TOF"  0x05 11 "off-delay timer: IN = acc; acc := Q; output := Q";
    Not               None      787984    "NOT"  0x06  2 "acc := NOT acc";
    RisingEdge        None      6985      "EU"   0x07  5 "acc := 1 if acc has risen since the scan before";
    FallingEdge       None      6968      "ED"   0x08  5 "acc := 1 if acc has fallen since the scan before";
    OpenAnd           None      6540      "A("   0x09  3 "open an AND block: push acc; acc := 1";
    OpenXor           None      8840      "X("   0x0A  3 "open an XOR block: push acc; acc := 1";
    Return            None      826984    "RET"  0x0B  2 "return: if acc = 1, the program ends for this scan";
    ReturnNot         None      -826984   "-RET" 0x0C  2 "return: if acc = 0, the program ends for this scan";
    Negate            None      786971    "NEG"  0x0D  2 "value := -value";
    SquareRoot        None      838182    "SQR"  0x0E  2 "value := whole square root of value; of a negative one 0, and S 04 := 1";
    Pulse             Timer     8480      "TP"   0x0F 12 "pulse timer: IN = acc; acc := Q; output := Q";
    InputContact      Input     827300    "RI"   0x10  1 "contact, normally open: acc := acc AND input XX";
    InputContactNot   Input     -827300   "-RI"  0x20  1 "contact, normally closed: acc := acc AND NOT input XX";
    OutputContact     Output    827900    "RO"   0x30  1 "contact: acc := acc AND output XX, as the image stands now";
    OutputContactNot  Output    -827900   "-RO"  0x40  1 "contact: acc := acc AND NOT output XX, as the image stands now";
    Coil              Output    877900    "WO"   0x50  1 "coil: output XX := acc";
    SetCoil           Output    83877900  "SWO"  0x60  1 "set coil: if acc = 1, output XX := 1";
    ResetCoil         Output    82877900  "RWO"  0x70  1 "reset coil: if acc = 1, output XX := 0";
    StoreBranch       Branch    404100    "()"   0x80  1 "OR store: remember acc as branch point XX";
    RecallBranch      Branch    404100    "()"   0x90  1 "as the very next code after 40, 6540 or 8840: acc := what branch point XX remembers";
    RetentiveOnDelay  Timer     847982    "TOR"  0xA0 12 "retentive on-delay timer: IN = acc; acc := Q; output := Q";
    NegatedCoil       Output    -877900   "-WO"  0xA1  3 "negated coil: output XX := NOT acc";
    MarkerContact     Marker    827700    "RM"   0xA2  3 "contact: acc := acc AND marker XX";
    MarkerContactNot  Marker    -827700   "-RM"  0xA3  3 "contact: acc := acc AND NOT marker XX";
    SystemContact     System    828300    "RS"   0xA4  3 "contact: acc := acc AND system marker XX";
    SystemContactNot  System    -828300   "-RS"  0xA5  3 "contact: acc := acc AND NOT system marker XX";
    TimerContact      TimerQ    828400    "RT"   0xA6  3 "contact: acc := acc AND Q of timer XX";
    TimerContactNot   TimerQ    -828400   "-RT"  0xA7  3 "contact: acc := acc AND NOT Q of timer XX";
    CounterContact    Counter   826700    "RC"   0xA8  4 "contact: acc := acc AND (counter XX has reached its preset)";
    CounterContactNot Counter   -826700   "-RC"  0xA9  4 "contact: acc := acc AND NOT (counter XX has reached its preset)";
    ZeroContact       Counter   829000    "RZ"   0xAA  4 "contact: acc := acc AND (counter XX is 0 or less)";
    ZeroContactNot    Counter   -829000   "-RZ"  0xAB  4 "contact: acc := acc AND NOT (counter XX is 0 or less)";
    XorInput          Input     887300    "XI"   0xAC  4 "acc := acc XOR input XX";
    XorInputNot       Input     -887300   "-XI"  0xAD  4 "acc := acc XOR NOT input XX";
    XorOutput         Output    887900    "XO"   0xAE  3 "acc := acc XOR output XX, as the image stands now";
    XorOutputNot      Output    -887900   "-XO"  0xAF  3 "acc := acc XOR NOT output XX, as the image stands now";
    XorMarker         Marker    887700    "XM"   0xB0  4 "acc := acc XOR marker XX";
    XorMarkerNot      Marker    -887700   "-XM"  0xB1  4 "acc := acc XOR NOT marker XX";
    MarkerCoil        Marker    877700    "WM"   0xB2  3 "coil: marker XX := acc";
    NegatedMarkerCoil Marker    -877700   "-WM"  0xB3  4 "negated coil: marker XX := NOT acc";
    SetMarker         Marker    83877700  "SWM"  0xB4  4 "set coil: if acc = 1, marker XX := 1";
    ResetMarker       Marker    82877700  "RWM"  0xB5  4 "reset coil: if acc = 1, marker XX := 0";
    ResetTimer        TimerQ    82878400  "RWT"  0xB6  4 "reset: if acc = 1, timer XX is as if it had never been started";
    ResetCounter      Counter   82876700  "RWC"  0xB7  4 "reset: if acc = 1, counter XX := 0";
    LoadCounter       Counter   83876700  "SWC"  0xB8  4 "load: if acc = 1, counter XX := its preset";
    CountUp           Count     67848500  "CTU"  0xB9  4 "up-counter: if acc has risen, counter XX + 1; acc := counter XX has reached its preset";
    CountDown         Count     67846800  "CTD"  0xBA  4 "down-counter: if acc has risen, counter XX - 1; acc := counter XX is 0 or less";
    Load              Value     766800    "LD"   0xBB  4 "value := register XX";
    LoadAnalogue      Analogue  76686500  "LDA"  0xBC  4 "value := analogue input A XX, 0 to 1023";
    LoadTimer         TimerQ    76688400  "LDT"  0xBD  4 "value := elapsed time of timer XX, ms";
    LoadCount         Counter   76686700  "LDC"  0xBE  4 "value := counter XX";
    LoadSystem        Reading   76688300  "LDS"  0xBF  4 "value := system reading XX: 01 time of the last scan in µs, 02 time stamp of this scan in ms";
    LoadMarkers       Group     76687700  "LDM"  0xC0  4 "value := eight markers as bits: group 01 is M 01 to M 08";
    LoadInputs        None      76687300  "LDI"  0xC1  2 "value := all inputs as bits, input 01 the lowest";
    LoadOutputs       None      76687900  "LDO"  0xC2  2 "value := all outputs as bits, output 01 the lowest";
    LoadBit           None      76686600  "LDB"  0xC3  2 "value := acc";
    Store             Register  838400    "ST"   0xC4  4 "if acc = 1, register XX := value";
    StoreCount        Counter   83846700  "STC"  0xC5  4 "if acc = 1, counter XX := value";
    StorePwm          Pwm       83848000  "STP"  0xC6  4 "if acc = 1, PWM of output XX := value, cut to 0 to 255";
    StoreMarkers      Group     83847700  "STM"  0xC7  4 "if acc = 1, eight markers := the low bits of value";
    StoreOutputs      None      83847900  "STO"  0xC8  3 "if acc = 1, all outputs := the low bits of value";
    PresetCounter     Counter   80866700  "PVC"  0xC9  4 "if acc = 1, preset of counter XX := value, at least 0";
    PresetTimer       TimerQ    80868400  "PVT"  0xCA  4 "if acc = 1, preset of timer XX := value, at least 0";
    Add               Value     65686800  "ADD"  0xCB  4 "value := value + operand";
    Subtract          Value     83856600  "SUB"  0xCC  4 "value := value - operand";
    Multiply          Value     77857600  "MUL"  0xCD  4 "value := value * operand";
    Divide            Value     68738600  "DIV"  0xCE  4 "value := value / operand, without the fraction; by 0: 0, and S 04 := 1";
    Modulo            Value     77796800  "MOD"  0xCF  4 "value := rest of value / operand; by 0: 0, and S 04 := 1";
    AndWord           Value     65786800  "AND"  0xD0  4 "value := value AND operand, bit by bit";
    OrWord            Value     798200    "OR"   0xD1  4 "value := value OR operand, bit by bit";
    XorWord           Value     88798200  "XOR"  0xD2  4 "value := value XOR operand, bit by bit";
    ShiftLeft         Bit       83727600  "SHL"  0xD3  3 "value := value shifted left by XX bits";
    ShiftRight        Bit       83728200  "SHR"  0xD4  3 "value := value shifted right by XX bits; zeros come in";
    Greater           Value     718400    "GT"   0xD5  4 "comparison: acc := acc AND (value > operand)";
    GreaterOrEqual    Value     716900    "GE"   0xD6  4 "comparison: acc := acc AND (value >= operand)";
    Equal             Value     698100    "EQ"   0xD7  4 "comparison: acc := acc AND (value = operand)";
    NotEqual          Value     786900    "NE"   0xD8  4 "comparison: acc := acc AND (value <> operand)";
    LessOrEqual       Value     766900    "LE"   0xD9  4 "comparison: acc := acc AND (value <= operand)";
    Less              Value     768400    "LT"   0xDA  4 "comparison: acc := acc AND (value < operand)";
    BitContact        Bit       66738400  "BIT"  0xDB  3 "contact: acc := acc AND bit XX of value";
    BitContactNot     Bit       -66738400 "-BIT" 0xDC  3 "contact: acc := acc AND NOT bit XX of value";
    Move              Move      77798600  "MOV"  0xDD  7 "block move: if acc = 1, copy registers from XX on";
    Drum              Drum      68827700  "DRM"  0xDE  5 "sequencer: if acc = 1, outputs 01-04 := the step that register XX tells";
    Scale             Scale     836776    "SCL"  0xDF 10 "linear scaling: value := value from one range to another";
    Filter            Filter    70768400  "FLT"  0xE0 16 "first-order filter: value := value, smoothed by strength XX";
    Integrate         Register  73788400  "INT"  0xE1 13 "integration: if acc = 1, register XX + value per second";
    InputFilter       Time      707300    "FI"   0xE2  0 "input filter: an input must keep a level for XX ms";
    Label             Label     766600    "LB"   0xE3  4 "label XX, at the head of a rung";
    Jump              Jump      74778000  "JMP"  0xE4  8 "jump: if acc = 1, go on at label XX";
    JumpNot           Jump      -74778000 "-JMP" 0xE5  8 "jump: if acc = 0, go on at label XX";
}
