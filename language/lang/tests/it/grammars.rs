//! The tables of `docs/grammar-tests.md` name each production and statement of the three sources, and cases that are there.

use std::collections::HashSet;
use std::fs;
use std::path::Path;

/// The productions, words and rules of the paper about InterSCL, in its order.
const ISCL: [&str; 45] = [
    "Programa → BLOCO Corpo END_BLOCK",
    "Corpo → Declaracoes Comandos",
    "Declaracoes → Declaracoes SEMICOLON Declaracoes",
    "Declaracoes → $",
    "Declaracao → Tipo ID",
    "Tipo → INT",
    "Tipo → REAL",
    "Tipo → BOOL",
    "Expressao → ExpressaoLogica (OR ExpressaoLogica)",
    "ExpressaoLogica → ExpressaoRelacional (AND ExpressaoRelacional)",
    "ExpressaoRelacional → ExpressaoAritmetica (EQ | NEQ | LT | LE | GT | GE) ExpressaoAritmetica",
    "ExpressaoRelacional → NOT ExpressaoAritmetica",
    "ExpressaoAritmetica → Termo (PLUS | MINUS Termo)",
    "Termo → Fator (MUL | DIV Fator)",
    "Fator → ID",
    "Fator → NUMBER_LITERAL",
    "Fator → BOOLEAN_LITERAL",
    "Fator → LPAREN Expressao RPAREN",
    "Comandos → Comandos SEMICOLON Comandos",
    "Comandos → $",
    "Comando → ID ASSIGN Expressao",
    "Comando → ComandoBloco",
    "Comando → PRINT LPAREN ID RPAREN",
    "ComandoBloco → IfStatement | WhileStatement | ForStatement",
    "IfStatement → IF Expressao THEN Comandos END_IF",
    "IfStatement → IF Expressao THEN Comandos ELSE Comandos END_IF",
    "WhileStatement → WHILE Expressao DO Comandos END_FOR",
    "BLOCO, END_BLOCK, IF, THEN, ELSE, END_IF, WHILE, DO, END_WHILE, FOR, TO, END_FOR, PRINT",
    "INT, REAL, BOOL",
    "OR, AND, NOT",
    "ID",
    "NUMBER_LITERAL",
    "BOOLEAN_LITERAL (TRUE, FALSE)",
    "ASSIGN (:=)",
    "EQ (=), NEQ (<>), LT (<), LE (<=), GT (>), GE (>=)",
    "PLUS (+), MINUS (-), MUL (*), DIV (/)",
    "LPAREN ((), RPAREN ())",
    "SEMICOLON (;)",
    "COMMENT (//...)",
    "Tipagem Estática Básica",
    "Escopo Global",
    "Ordem de Execução Sequencial",
    "Ausência de Funções e Blocos Compostos",
    "Sem Integração com Hardware",
    "Sem Interface Gráfica",
];

/// The statements of the help page about LCE, in its order.
const LCE: [&str; 27] = [
    "obrigatório ser variável ou pode ser constante",
    "tipo Variant",
    "V0 R:= 100000.125;",
    "o sinal de decimal é o ponto e não a vírgula",
    "V1 R:= V0; → 100000.125",
    "V1 := V0; → 100000",
    "V1 D:= V0; → 100000",
    "V1 W:= V0; → 34464",
    "V1 B:= V0; → 160",
    "R, D, W e B, e também bit",
    "aciona V0;",
    "liga V0;",
    "desliga V0;",
    "se (V0) { ... }",
    "operadores +, -, *, /",
    "operadores & (and), | (ou) e ^ (ou exclusivo)",
    "qualificadores B, W, D e R antes dos operadores",
    "D é o padrão",
    "V0 R:= AIW0 R+ (AIW1 R/ 8);",
    "espaço entre operador e operando e nunca entre tipo da operação e operador",
    "R não pode ser utilizado com operadores lógicos",
    "constantes no sistema decimal",
    "2#1000 = 8",
    "16#1C = 28",
    "não são permitidos números negativos quando utilizados tais formatos",
    "as variáveis são sensíveis ao caso",
    "// comentário",
];

/// The productions of IEC 61131-3, B.1.3.1 to B.1.3.3, in its order.
const TYPES: &str = include_str!("../iec-types.txt");

/// The names of notations in the Portuguese page, where they are words.
const IL_PT: [(&str, &str); 4] = [
    ("PT omitido", "PT left out"),
    ("funções da norma", "standard functions"),
    ("blocos da norma", "standard blocks"),
    ("comentários aninhados", "nested comments"),
];

/// How books and tools write Instruction List.
const IL: [&str; 24] = [
    "END",
    "OUT T0 K50",
    "OUT C1 K3",
    "MPS MRD MPP, LPS LRD LPP",
    "LDP LDF",
    "PLS PLF",
    "DIFU DIFD RSET TIM CNT",
    "PT, PV, CLK",
    "ST T0.IN, CAL T0",
    "T1 (IN := …)",
    "PT left out",
    "SR, RS",
    "VAR_EXTERNAL",
    "VAR_IN_OUT",
    "standard functions",
    "standard blocks",
    "ADD 2, 4, 7",
    "+10, UINT#16#F",
    "nested comments",
    "AND( I2 OR I3 )",
    "I 0.0",
    "%M0",
    "X0",
    "CONFIGURATION … END_CONFIGURATION",
];

fn read(path: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../..")
        .join(path);
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The rows of the table after a heading: its source, and its cases.
fn rows(page: &str, heading: &str) -> Vec<(String, String)> {
    let (_, behind) = page.split_once(heading).unwrap();
    let table = behind.split("\n## ").next().unwrap();
    let rows = table.lines().filter(|line| line.starts_with("| ")).skip(2);
    rows.map(|row| {
        let row = row.replace("\\|", "\u{1}");
        let cells: Vec<String> = row
            .trim_matches('|')
            .split('|')
            .map(|cell| cell.trim().replace('\u{1}', "|"))
            .collect();
        let [source, cases] = cells.try_into().unwrap();
        (source, cases)
    })
    .collect()
}

/// `lce.toml: liga sets`, for each case that there is.
fn cases() -> HashSet<String> {
    let mut all = HashSet::new();
    for (folder, file) in [
        ("typed", "iscl.toml"),
        ("typed", "iscl-mistakes.toml"),
        ("typed", "lce.toml"),
        ("typed", "lce-mistakes.toml"),
        ("typed", "types.toml"),
        ("typed", "values.toml"),
        ("typed", "il.toml"),
        ("cases", "inputs.toml"),
        ("cases", "makers.toml"),
        ("cases", "shared.toml"),
        ("cases", "writings.toml"),
    ] {
        let text = read(&format!("language/lang/tests/{folder}/{file}"));
        let names = text.lines().filter_map(|line| {
            let name = line.strip_prefix("name = \"")?;
            name.strip_suffix('"')
        });
        all.extend(names.map(|name| format!("{file}: {name}")));
    }
    let runs = read("tools/cli/tests/it/run.rs");
    let names = runs.split("#[test]\nfn ").skip(1);
    all.extend(names.filter_map(|test| Some(format!("run.rs: {}", test.split_once('(')?.0))));
    all
}

#[test]
fn each_production_and_statement_has_its_cases() {
    let known = cases();
    for page in ["docs/grammar-tests.md", "docs/grammar-tests.pt-BR.md"] {
        let text = read(page);
        let types: Vec<&str> = TYPES.lines().collect();
        let (list, translated) = match page.contains("pt-BR") {
            true => ("\n## Lista de Instruções\n", &IL_PT[..]),
            false => ("\n## Instruction List\n", &[][..]),
        };
        for (heading, sources) in [
            ("\n## InterSCL\n", &ISCL[..]),
            ("\n## LCE\n", &LCE[..]),
            ("\n## IEC 61131-3, B.1.3\n", &types[..]),
            (list, &IL[..]),
        ] {
            let rows = rows(&text, heading);
            let named: Vec<&str> = rows.iter().map(|row| english(&row.0, translated)).collect();
            assert_eq!(named, sources, "{page}");
            for (source, cases) in &rows {
                assert!(!cases.is_empty(), "{page}: {source}");
                for case in split(cases, &known) {
                    assert!(known.contains(case), "{page}: {source}: {case}");
                }
            }
        }
    }
}

/// The name that the lists above have for a row.
fn english<'r>(row: &'r str, translated: &[(&str, &'r str)]) -> &'r str {
    let twin = translated.iter().find(|(name, _)| *name == row);
    twin.map_or(row, |(_, name)| name)
}

/// No production of the standard is left out: what one names, another one makes.
#[test]
fn each_production_of_the_norm_has_those_it_names() {
    let made: HashSet<&str> = TYPES
        .lines()
        .filter_map(|line| line.split(' ').next())
        .collect();
    // What B.1.2 and B.1 make.
    let others = [
        "constant",
        "identifier",
        "integer",
        "signed_integer",
        "character_string",
        "non_generic_type_name",
    ];
    for line in TYPES.lines() {
        let (_, names) = line.split_once("= ").unwrap();
        let words = names.split(|c: char| !c.is_ascii_lowercase() && c != '_');
        for word in words.filter(|word| word.len() > 1) {
            assert!(
                made.contains(word) || others.contains(&word),
                "{word} in {line}"
            );
        }
    }
    assert_eq!(made.len(), 46);
}

/// The cases of a cell; a name may have a `;` itself.
fn split<'c>(cell: &'c str, known: &HashSet<String>) -> Vec<&'c str> {
    let mut all = Vec::new();
    let mut rest = cell;
    while !rest.is_empty() {
        let ends = rest.match_indices("; ").map(|(at, _)| at);
        let mut ends = ends.chain([rest.len()]);
        let end = ends.find(|end| known.contains(&rest[..*end]));
        let end = end.unwrap_or(rest.len());
        all.push(&rest[..end]);
        rest = rest[end..].strip_prefix("; ").unwrap_or_default();
    }
    all
}

/// Each mistake is one message, which says what it is in both languages.
#[test]
fn there_are_twenty_mistakes_of_each() {
    for file in ["iscl-mistakes.toml", "lce-mistakes.toml"] {
        let text = read(&format!("language/lang/tests/typed/{file}"));
        let table: toml::Table = toml::from_str(&text).unwrap();
        let cases = table["case"].as_array().unwrap();
        for case in cases {
            let of = |key: &str| case[key].as_array().unwrap().len();
            assert_eq!(
                (of("told"), of("says"), of("diz")),
                (1, 1, 1),
                "{}",
                case["name"]
            );
        }
        assert!(cases.len() >= 20, "{file}");
    }
}
