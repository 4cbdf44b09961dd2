//! Texts that are traps by their shape, each as deep or as long as it is asked for.

/// Writes a text of this size.
pub type Shape = fn(usize) -> String;

#[allow(dead_code, reason = "of Instruction List the work alone is counted")]
pub const IL: [(&str, Shape); 11] = [
    ("closed parentheses", |n| {
        format!("LD I1\n{}{}ST Q1\n", "AND( I2\n".repeat(n), ")\n".repeat(n))
    }),
    ("explicit parentheses", |n| {
        let open = "OR(\nLD I2\n".repeat(n);
        format!("LD I1\n{open}{}ST Q1\n", ")\n".repeat(n))
    }),
    ("numbers in parentheses", |n| {
        let open = "ADD( D2\n".repeat(n);
        format!("LD D1\n{open}{}ST D1\n", ")\n".repeat(n))
    }),
    ("stores in parentheses", |n| {
        format!("LD I1\n{}", "AND( I2\nST Q1\n".repeat(n))
    }),
    ("open parentheses", |n| {
        format!("LD I1\n{}", "AND( I2\n".repeat(n))
    }),
    ("parentheses on one line", |n| {
        format!("LD I1\nAND{}", "(".repeat(n))
    }),
    ("words that are no operators, with parentheses", |n| {
        "XLD( Z9.9\n".repeat(n)
    }),
    ("variables that a call lends", |n| {
        let names: String = (0..n).map(|i| format!("a{i} : BOOL;\n")).collect();
        let given: Vec<String> = (0..n).map(|i| format!("a{i} := M1")).collect();
        format!(
            "FUNCTION_BLOCK f\nVAR_IN_OUT\n{names}END_VAR\nLD a0\nST a1\nEND_FUNCTION_BLOCK\nVAR x : f; END_VAR\nCAL x({})\n",
            given.join(", ")
        )
    }),
    ("inputs that there are not", |n| {
        let given: Vec<String> = (0..n).map(|i| format!("b{i} := I1")).collect();
        format!(
            "FUNCTION_BLOCK f\nVAR_INPUT a : BOOL; END_VAR\nLD a\nST Q1\nEND_FUNCTION_BLOCK\nVAR x : f; END_VAR\nCAL x({})\n",
            given.join(", ")
        )
    }),
    ("names of nothing", |n| {
        (0..n).map(|i| format!("LD a{i}\nST b{i}\n")).collect()
    }),
    ("blocks", |n| {
        (0..n)
            .map(|i| format!("VAR t{i} : TON; END_VAR\nCAL t{i}(IN := I1, PT := T#1s)\n"))
            .collect()
    }),
];

pub const ST: [(&str, Shape); 47] = [
    ("parentheses", |n| {
        format!("x := {}1{};", "(".repeat(n), ")".repeat(n))
    }),
    ("open parentheses", |n| format!("x := {}", "(".repeat(n))),
    ("a long sum", |n| {
        format!("VAR x : INT; END_VAR x := 1{};", " + x".repeat(n))
    }),
    ("powers", |n| {
        format!("VAR x : INT; END_VAR x := 1{};", " ** 2".repeat(n))
    }),
    ("NOT", |n| format!("x := {}TRUE;", "NOT ".repeat(n))),
    ("minus", |n| format!("x := {}1;", "- ".repeat(n))),
    ("IF", |n| "IF x THEN ".repeat(n)),
    ("IF, closed", |n| {
        format!("{}{}", "IF TRUE THEN\n".repeat(n), "END_IF;\n".repeat(n))
    }),
    ("ELSE IF", |n| {
        format!("IF x THEN {}", "ELSE IF y THEN ".repeat(n))
    }),
    ("CASE", |n| "CASE x OF 1: ".repeat(n)),
    ("calls in calls", |n| {
        format!("x := {}1{};", "ABS(".repeat(n), ")".repeat(n))
    }),
    ("subscripts", |n| {
        format!("x := {}1{};", "a[".repeat(n), "]".repeat(n))
    }),
    ("members", |n| {
        format!("VAR a : INT; END_VAR x := a{};", ".b".repeat(n))
    }),
    ("arrays of arrays", |n| {
        format!("VAR a : {}INT; END_VAR", "ARRAY[1..1] OF ".repeat(n))
    }),
    ("structures", |n| {
        format!("TYPE t : {}", "STRUCT a : ".repeat(n))
    }),
    ("first values", |n| {
        format!("VAR a : ARRAY[1..2] OF INT := {}", "[".repeat(n))
    }),
    ("open comments", |n| "(* ".repeat(n)),
    ("closed comments", |n| {
        format!("{}{}", "(* ".repeat(n), "*) ".repeat(n))
    }),
    ("units without their ends", |n| {
        "FUNCTION f : INT\n".repeat(n)
    }),
    ("lines for a debugger in one line", |n| {
        "(*DBG: *) ;".repeat(n) + "x"
    }),
    ("units in C without their ends", |n| {
        "FUNCTION f : INT {{ x }}\n".repeat(n)
    }),
    ("open texts", |n| "x := 'a\n".repeat(n)),
    ("operands of a function", |n| {
        format!("VAR x : INT; END_VAR x := ADD(x{});", ", x".repeat(n))
    }),
    ("names of nothing", |n| {
        (0..n).map(|i| format!("a{i} := b{i};\n")).collect()
    }),
    ("types in a row", |n| {
        let types: String = (1..n).map(|i| format!("T{} : T{};\n", i, i - 1)).collect();
        format!("TYPE {types} END_TYPE VAR x : T5; END_VAR x := x;")
    }),
    ("blocks in blocks", |n| {
        let block = |i: usize| {
            format!(
                "FUNCTION_BLOCK B{i} VAR b : B{}; END_VAR b(); END_FUNCTION_BLOCK\n",
                i + 1
            )
        };
        (0..n).map(block).collect::<String>() + "PROGRAM p VAR b : B0; END_VAR b(); END_PROGRAM"
    }),
    ("functions in functions", |n| {
        let f = |i: usize| format!("FUNCTION F{i} : INT F{i} := F{}(); END_FUNCTION\n", i + 1);
        let all: String = (0..n).map(f).collect();
        format!(
            "{all}FUNCTION F{n} : INT F{n} := 1; END_FUNCTION PROGRAM p VAR x : INT; END_VAR x := F0(); END_PROGRAM"
        )
    }),
    ("large arrays", |n| {
        let all: String = (0..n)
            .map(|i| format!("a{i} : ARRAY[1..99999] OF LREAL;\n"))
            .collect();
        format!("VAR {all} END_VAR a0[1] := 1.0;")
    }),
    ("times in a sum", |n| {
        format!("VAR t : TIME; END_VAR t := t{};", " + T#1s".repeat(n))
    }),
    ("declarations without VAR", |n| "x : INT;\n".repeat(n)),
    ("units without their words", |n| {
        "Scale : REAL VAR_INPUT x : INT; END_VAR\n".repeat(n)
    }),
    ("names of one length", |n| {
        let all: String = (0..n).map(|i| format!("name{i:06} : INT;\n")).collect();
        format!("VAR {all} END_VAR\n") + &"nome000001 := 1; nqme000002 := 1;\n".repeat(20)
    }),
    ("THEN alone", |n| "x THEN y := 1;\n".repeat(n)),
    ("END_VAR alone", |n| "END_VAR ".repeat(n)),
    ("ELSE IF in IF", |n| {
        "IF x THEN y := 1; ELSE IF x THEN y := 2; END_IF;\n".repeat(n)
    }),
    ("braces", |n| "IF x { y++; } ".repeat(n)),
    ("a long name of many elements", |n| {
        let name = "a".repeat(n);
        format!("VAR {name} : ARRAY[1..99999] OF INT; x : INT; END_VAR x := 1;")
    }),
    ("names of a large structure", |n| {
        let members: String = (0..n).map(|i| format!("a{i} : INT;\n")).collect();
        let names: String = (0..n).map(|i| format!("T{i} : S;\n")).collect();
        format!(
            "TYPE S : STRUCT {members} END_STRUCT;\n{names} END_TYPE VAR x : INT; END_VAR x := 1;"
        )
    }),
    ("names of names of a type", |n| {
        let names: String = (1..n).map(|i| format!("T{i} : T{};\n", i - 1)).collect();
        let uses: String = (0..n).map(|i| format!("v{i} : T{};\n", n - 1)).collect();
        format!("TYPE T0 : INT; {names} END_TYPE VAR {uses} x : INT; END_VAR x := 1;")
    }),
    ("ELSIF", |n| {
        let arms = "ELSIF x = 2 THEN x := 3;\n".repeat(n);
        format!("VAR x : INT; END_VAR IF x = 1 THEN x := 2;\n{arms}END_IF;")
    }),
    ("structures in structures, each behind what it holds", |n| {
        let all: String = (1..n)
            .map(|i| format!("T{i} : STRUCT a : T{}; END_STRUCT;\n", i - 1))
            .collect();
        format!(
            "TYPE T0 : STRUCT a : INT; END_STRUCT; {all} END_TYPE VAR x : T{}; y : INT; END_VAR y := 1;",
            n - 1
        )
    }),
    ("arrays in arrays, each behind what it holds", |n| {
        let all: String = (1..n)
            .map(|i| format!("T{i} : ARRAY[1..1] OF T{};\n", i - 1))
            .collect();
        format!(
            "TYPE T0 : INT; {all} END_TYPE VAR x : T{}; y : INT; END_VAR y := 1;",
            n - 1
        )
    }),
    ("blocks in blocks, each behind what it holds", |n| {
        let all: String = (1..n)
            .map(|i| {
                format!(
                    "FUNCTION_BLOCK B{i} VAR b : B{}; END_VAR b(); END_FUNCTION_BLOCK\n",
                    i - 1
                )
            })
            .collect();
        format!(
            "FUNCTION_BLOCK B0 VAR x : INT; END_VAR x := 1; END_FUNCTION_BLOCK {all} PROGRAM p VAR b : B{}; END_VAR b(); END_PROGRAM",
            n - 1
        )
    }),
    ("IF in functions in functions", |n| {
        let (calls, deep) = (n.min(50), n.min(190));
        let (open, close) = ("IF x > 0 THEN ".repeat(deep), "END_IF; ".repeat(deep));
        let all: String = (0..calls)
            .map(|i| format!("FUNCTION F{i} : INT VAR_INPUT x : INT; END_VAR {open} F{i} := F{}(x); {close} END_FUNCTION\n", i + 1))
            .collect();
        format!(
            "{all}FUNCTION F{calls} : INT VAR_INPUT x : INT; END_VAR F{calls} := x; END_FUNCTION PROGRAM p VAR x : INT; END_VAR x := F0(x); END_PROGRAM"
        )
    }),
    ("sums in functions in functions", |n| {
        let (calls, terms) = (n.min(50), n.min(140));
        let sum = " + x".repeat(terms);
        let all: String = (0..calls)
            .map(|i| format!("FUNCTION F{i} : INT VAR_INPUT x : INT; END_VAR F{i} := F{}(x{sum}){sum}; END_FUNCTION\n", i + 1))
            .collect();
        format!(
            "{all}FUNCTION F{calls} : INT VAR_INPUT x : INT; END_VAR F{calls} := x{sum}; END_FUNCTION PROGRAM p VAR x : INT; END_VAR x := F0(x); END_PROGRAM"
        )
    }),
    ("operands of a comparison", |n| {
        format!(
            "VAR x : INT; b : BOOL; END_VAR b := GT(x{});",
            ", x".repeat(n)
        )
    }),
    ("operands of MUX", |n| {
        format!("VAR x : INT; END_VAR x := MUX(x{});", ", x".repeat(n + 1))
    }),
];

pub const ISCL: [(&str, Shape); 16] = [
    ("parentheses", |n| {
        format!(
            "BLOCO INT x; x := {}1{}; END_BLOCK",
            "(".repeat(n),
            ")".repeat(n)
        )
    }),
    ("a long sum", |n| {
        format!("BLOCO INT x; x := 1{}; END_BLOCK", " + x".repeat(n))
    }),
    ("NOT", |n| {
        format!("BLOCO BOOL x; x := {}x; END_BLOCK", "NOT ".repeat(n))
    }),
    ("minus", |n| {
        format!("BLOCO INT x; x := {}x; END_BLOCK", "- ".repeat(n))
    }),
    ("IF", |n| {
        format!("BLOCO BOOL x; {}", "IF x THEN ".repeat(n))
    }),
    ("IF, closed", |n| {
        let ifs = "IF x THEN\n".repeat(n);
        format!("BLOCO BOOL x; {ifs}{} END_BLOCK", "END_IF;\n".repeat(n))
    }),
    ("ELSE IF", |n| {
        format!("BLOCO BOOL x; IF x THEN {}", "ELSE IF x THEN ".repeat(n))
    }),
    ("ELSIF", |n| {
        let arms = "ELSIF x THEN x := x; ".repeat(n);
        format!("BLOCO BOOL x; IF x THEN {arms} END_IF END_BLOCK")
    }),
    ("WHILE", |n| "WHILE x DO ".repeat(n)),
    ("CASE", |n| format!("BLOCO {}", "CASE x OF 1: ".repeat(n))),
    ("open comments", |n| format!("BLOCO {}", "(* ".repeat(n))),
    ("open texts", |n| "PRINT('a\n".repeat(n)),
    ("names of nothing", |n| {
        let all: String = (0..n).map(|i| format!("a{i} := b{i};\n")).collect();
        format!("BLOCO {all} END_BLOCK")
    }),
    ("declarations", |n| {
        let all: String = (0..n).map(|i| format!("INT a{i};\n")).collect();
        format!("BLOCO {all} a0 := 1; END_BLOCK")
    }),
    ("END_IF", |n| {
        format!("BLOCO {} END_BLOCK", "END_IF; ".repeat(n))
    }),
    ("braces", |n| {
        format!("BLOCO {}", "IF x { y++; } ".repeat(n))
    }),
];

pub const LCE: [(&str, Shape); 17] = [
    ("parentheses", |n| {
        format!("V0 := {}1{};", "(".repeat(n), ")".repeat(n))
    }),
    ("a long sum", |n| format!("V0 := 1{};", " + V0".repeat(n))),
    ("!", |n| format!("V0 := {}1;", "!".repeat(n))),
    ("signs", |n| format!("V0 := {}1;", "- ".repeat(n))),
    ("se", |n| "se (V0) { ".repeat(n)),
    ("se, closed", |n| {
        format!("{} aciona V1; {}", "se (V0) {\n".repeat(n), "}\n".repeat(n))
    }),
    ("senao se", |n| {
        format!("se (V0) {{ }} {}", "senao se (V0) { } ".repeat(n))
    }),
    ("se without parentheses", |n| "se V0 { ".repeat(n)),
    ("se without braces", |n| "se (V0) ".repeat(n)),
    ("braces", |n| "{ ".repeat(n)),
    ("closing braces", |n| "} ".repeat(n)),
    ("coils in se", |n| {
        let coils: String = (0..n).map(|i| format!("aciona V{i}; ")).collect();
        format!("{}{coils}{}", "se (I0.0) { ".repeat(90), "}".repeat(90))
    }),
    ("mixed kinds", |n| {
        (0..n)
            .map(|i| format!("V{i} R:= V{} + 1;\nV{i} := 1;\n", i / 2))
            .collect()
    }),
    ("names", |n| {
        let all: String = (0..n).map(|i| format!("V{i} = a{i};\n")).collect();
        format!("var {all} a0 := 1;")
    }),
    ("names of nothing", |n| {
        (0..n).map(|i| format!("a{i} := b{i};\n")).collect()
    }),
    ("networks", |n| "rede \"x\n".repeat(n)),
    ("types without spaces", |n| {
        format!("V0 R:= V1{};", "R+V1".repeat(n))
    }),
];

/// Instruction List with types.
pub const TYPED_IL: [(&str, Shape); 14] = [
    ("a long sum", |n| {
        format!("VAR r : REAL; END_VAR\nLD r\n{}ST r", "ADD r\n".repeat(n))
    }),
    ("operands", |n| {
        format!(
            "VAR r : REAL; END_VAR\nLD r\nADD r{}\nST r",
            ", r".repeat(n)
        )
    }),
    ("parentheses", |n| {
        format!("VAR r : REAL; END_VAR\nLD r\n{}", "ADD( r\n".repeat(n))
    }),
    ("parentheses of operands", |n| {
        format!("VAR r : REAL; END_VAR\nLD {}r", "(".repeat(n))
    }),
    ("closing parentheses", |n| {
        format!("VAR r : REAL; END_VAR\nLD r\n{}", ")\n".repeat(n))
    }),
    ("labels and jumps", |n| {
        let all: String = (0..n)
            .map(|i| format!("a{i}: ADD r\nJMP a{}\n", i + 1))
            .collect();
        format!("VAR r : REAL; END_VAR\nLD r\n{all}a{n}: ST r")
    }),
    ("jumps back", |n| {
        let all: String = (0..n).map(|i| format!("LD x\nJMPC a{}\n", i / 2)).collect();
        let labels: String = (0..n).map(|i| format!("a{i}: LD x\nST x\n")).collect();
        format!("VAR x : BOOL; r : REAL; END_VAR\n{labels}{all}")
    }),
    ("IF", |n| {
        format!(
            "VAR x : BOOL; r : REAL; END_VAR\n{}",
            "LD x\nIF\n".repeat(n)
        )
    }),
    ("ELSE", |n| {
        format!("VAR x : BOOL; r : REAL; END_VAR\n{}", "ELSE\n".repeat(n))
    }),
    ("MPS", |n| {
        format!(
            "VAR x : BOOL; r : REAL; END_VAR\nLD x\n{}",
            "MPS\nANDN x\n".repeat(n)
        )
    }),
    ("edges", |n| {
        format!(
            "VAR x : BOOL; r : REAL; END_VAR\n{}",
            "LDP x\nST x\n".repeat(n)
        )
    }),
    ("names of nothing", |n| {
        let all: String = (0..n).map(|i| format!("LD a{i}\nST b{i}\n")).collect();
        format!("VAR r : REAL; END_VAR\n{all}")
    }),
    ("operators of nothing", |n| {
        let all: String = (0..n).map(|i| format!("op{i} r\n")).collect();
        format!("VAR r : REAL; END_VAR\n{all}")
    }),
    ("conversions", |n| {
        format!(
            "VAR r : REAL; END_VAR\nLD r\n{}ST r",
            "REAL_TO_DINT\nDINT_TO_REAL\n".repeat(n)
        )
    }),
];
