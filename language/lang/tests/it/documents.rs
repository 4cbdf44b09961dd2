//! The pages about diagnostics say what the compiler says.

use std::fs;
use std::path::Path;
use unoclp_core::Board;
use unoclp_lang::{
    Code, Diagnostic, Lang, Lines, Options, Severity, Span, TextLanguage, check, compile,
    compile_text,
};

const PAGES: [(&str, &str, Lang, [&str; 2]); 10] = [
    (
        "docs/il-diagnostics.md",
        "IL-",
        Lang::En,
        ["Error", "Warning"],
    ),
    (
        "docs/il-diagnostics.pt-BR.md",
        "IL-",
        Lang::Pt,
        ["Erro", "Aviso"],
    ),
    (
        "docs/st-diagnostics.md",
        "ST-",
        Lang::En,
        ["Error", "Warning"],
    ),
    (
        "docs/st-diagnostics.pt-BR.md",
        "ST-",
        Lang::Pt,
        ["Erro", "Aviso"],
    ),
    (
        "docs/interscl-diagnostics.md",
        "ISCL-",
        Lang::En,
        ["Error", "Warning"],
    ),
    (
        "docs/interscl-diagnostics.pt-BR.md",
        "ISCL-",
        Lang::Pt,
        ["Erro", "Aviso"],
    ),
    (
        "docs/lce-diagnostics.md",
        "LCE-",
        Lang::En,
        ["Error", "Warning"],
    ),
    (
        "docs/lce-diagnostics.pt-BR.md",
        "LCE-",
        Lang::Pt,
        ["Erro", "Aviso"],
    ),
    (
        "docs/plcopen-diagnostics.md",
        "XML-",
        Lang::En,
        ["Error", "Warning"],
    ),
    (
        "docs/plcopen-diagnostics.pt-BR.md",
        "XML-",
        Lang::Pt,
        ["Erro", "Aviso"],
    ),
];

/// The codes of a table.
fn codes(table: &str) -> impl Iterator<Item = Code> {
    let all = Code::ALL.iter().copied();
    all.filter(move |code| code.to_string().starts_with(table))
}

/// The entries of a page: the code's number, its heading, and what follows.
fn entries(page: &str) -> Vec<(String, String)> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../..")
        .join(page);
    let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{page}: {error}"));
    let entries = text.split("<a id=\"").skip(1);
    entries
        .map(|entry| {
            let (id, rest) = entry.split_once("\"></a>\n\n## ").unwrap();
            assert!(rest.starts_with(&format!("{id} — ")), "{page}: {id}");
            (id.to_owned(), rest.to_owned())
        })
        .collect()
}

/// A message with … for what each place adds.
fn template(code: Code, lang: Lang) -> String {
    let words = ["…"; 5].map(Into::into).to_vec();
    Diagnostic::new(code, Span::default(), words).message(lang)
}

#[test]
fn every_code_has_its_entry() {
    for (page, table, lang, [error, warning]) in PAGES {
        let entries = entries(page);
        let ids: Vec<&str> = entries.iter().map(|(id, _)| id.as_str()).collect();
        let names: Vec<String> = codes(table).map(|code| code.to_string()).collect();
        assert_eq!(ids, names, "{page}");
        for ((id, entry), code) in entries.iter().zip(codes(table)) {
            let heading = format!("{id} — {}\n", template(code, lang));
            assert!(entry.starts_with(&heading), "{page}: {heading}");
            let severity = if code.severity() == Severity::Error {
                error
            } else {
                warning
            };
            assert!(
                entry.contains(&format!("\n\n**{severity}.** ")),
                "{page}: {id}"
            );
        }
    }
}

/// Of each two examples, the first is what the code is told of, and the second is a program without it.
#[test]
fn examples() {
    // Projects in XML are too long for a page: `plcopen/tests/cases.toml` has them.
    for (page, table, ..) in PAGES.into_iter().filter(|(_, table, ..)| *table != "XML-") {
        for ((id, entry), code) in entries(page).iter().zip(codes(table)) {
            let blocks: Vec<&str> = entry.split("```\n").skip(1).step_by(2).collect();
            let [wrong, right] = blocks[..] else {
                let long = [
                    Code::NoneLeft,
                    Code::DoesNotFit,
                    Code::StTooDeep,
                    Code::StLongIf,
                    Code::StLongNames,
                    Code::StChartTooLarge,
                    Code::BoardNoneLeft,
                    Code::BoardLabels,
                    Code::BoardTooLarge,
                    // Told of a program, and not of a text.
                    Code::BackNoWords,
                    Code::BackIntoPart,
                    Code::BackTimerInLoop,
                    Code::BackEarlyTime,
                    Code::BackNoRegister,
                    Code::BackPartOfArray,
                ];
                assert!(long.contains(&code), "{page}: {id}");
                continue;
            };
            let told = |text| match table {
                "IL-" => compile_text(text, TextLanguage::Il, unoclp_core::Board::UNO).diagnostics,
                "ISCL-" => check(text, TextLanguage::Iscl, unoclp_core::Board::UNO).diagnostics,
                "LCE-" => check(text, TextLanguage::Lce, unoclp_core::Board::UNO).diagnostics,
                // Of points that no board has.
                _ if code == Code::StMoved => check(text, TextLanguage::St, Board::PC).diagnostics,
                // Those about the board.
                _ if code.number() > 200 => {
                    compile_text(text, TextLanguage::St, Board::UNO).diagnostics
                }
                _ => check(text, TextLanguage::St, unoclp_core::Board::UNO).diagnostics,
            };
            let wrong = told(wrong);
            assert!(
                wrong.iter().any(|d| d.code == code),
                "{page}: {id}: {wrong:#?}"
            );
            let right = told(right);
            let error = right.iter().find(|d| d.severity() == Severity::Error);
            assert_eq!(error, None, "{page}: {id}");
            assert!(!right.iter().any(|d| d.code == code), "{page}: {id}");
        }
    }
}

/// The codes that have no short example.
#[test]
fn what_a_board_has_not_enough_of() {
    let names: String = (0..70).map(|n| format!("LD a{n}\nST b{n}\n")).collect();
    let told = compile_text(&names, TextLanguage::Il, unoclp_core::Board::UNO).diagnostics;
    assert!(told.iter().any(|d| d.code == Code::NoneLeft));

    let long = "LD I1\nST Q1\n".repeat(500);
    let told = compile_text(&long, TextLanguage::Il, unoclp_core::Board::UNO).diagnostics;
    let place = told
        .iter()
        .find(|d| d.code == Code::DoesNotFit)
        .map(|d| d.span.start);
    // 900 bytes: the first rung takes 2, each further one 3. After 300 rungs there is room for an NL.
    assert_eq!(place.map(|start| Lines::new(&long).line(start)), Some(601));
}

#[test]
fn a_nano_says_in_all_cases_that_it_has_no_real_numbers() {
    let text = "VAR r : REAL; END_VAR\nr := r + 1.5;\n";
    let told = compile_text(text, TextLanguage::St, Board::NANO).diagnostics;
    let says = [
        (Lang::En, "a Nano has no REAL numbers"),
        (Lang::Pt, "um Nano não tem números REAL"),
    ];
    for (lang, part) in says {
        let message = told.iter().map(|d| d.message(lang)).next();
        assert!(
            message.as_deref().is_some_and(|m| m.contains(part)),
            "{message:?}"
        );
    }
}

#[test]
fn both_languages_have_help_or_none() {
    for &code in Code::ALL {
        let diagnostic = Diagnostic::new(code, Span::default(), Vec::new());
        let [en, pt] = [Lang::En, Lang::Pt].map(|lang| diagnostic.help(lang).is_empty());
        assert_eq!(en, pt, "{code}");
    }
}

/// What addresses mean stands in one table, in each language.
#[test]
fn addresses() {
    for page in ["docs/instruction-list.md", "docs/instruction-list.pt-BR.md"] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("../..")
            .join(page);
        let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{page}: {error}"));
        let (_, rest) = text.split_once("<!-- addresses:begin -->").unwrap();
        let (table, _) = rest.split_once("<!-- addresses:end -->").unwrap();
        let rows: Vec<Vec<&str>> = table
            .lines()
            .filter(|line| line.starts_with("| `"))
            .map(|row| row.trim_matches('|').split('|').map(str::trim).collect())
            .collect();
        assert!(rows.len() > 30, "{page}");
        for row in rows {
            let [written, of, _, code] = row[..] else {
                panic!("{page}: {row:?}")
            };
            let written = written.trim_matches('`');
            let number = code.starts_with("766");
            let store = if number { "ST D9" } else { "ST M20" };
            let options = Options {
                dialect: unoclp_lang::Dialect::named(of),
                ..Options::on(unoclp_core::Board::UNO)
            };
            let compiled = compile(
                &format!("LD {written}\n{store}"),
                TextLanguage::Il,
                &options,
            );
            assert_eq!(compiled.codes()[1].to_string(), code, "{page}: {written}");
            assert!(
                !compiled.has_errors(),
                "{page}: {written}: {:?}",
                compiled.diagnostics
            );
        }
    }
}
