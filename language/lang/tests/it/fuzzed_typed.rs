//! Whatever bytes come as a text of a typed language: what is told of them stands in them and can be shown, and what
//! is made of them runs.

use unoclp_core::{Board, Inputs, Plc};
use unoclp_lang::run::Machine;
use unoclp_lang::{Diagnostic, Lang, Severity, TextLanguage, compile_text, show};

/// What holds of all bytes, of which the first chooses the language; the target `typed` of `proof/fuzz/` looks for those of
/// which it does not.
pub fn hold(bytes: &[u8]) {
    let Some((first, rest)) = bytes.split_first() else {
        return;
    };
    let language = match first % 4 {
        0 => TextLanguage::St,
        1 => TextLanguage::Scl,
        2 => TextLanguage::Iscl,
        _ => TextLanguage::Lce,
    };
    let text = String::from_utf8_lossy(rest);
    let made = compile_text(&text, language, Board::UNO);
    for diagnostic in made.diagnostics.iter() {
        assert!(
            text.get(diagnostic.span.range()).is_some(),
            "{diagnostic:?}"
        );
        for lang in [Lang::En, Lang::Pt] {
            assert!(!diagnostic.message(lang).is_empty());
        }
    }
    let renderer = annotate_snippets::Renderer::plain();
    let shown = show("x.st", &text, &made.diagnostics, Lang::En, &renderer);
    assert_eq!(shown.is_empty(), made.diagnostics.is_empty());
    let is_error = |d: &Diagnostic| d.severity() == Severity::Error;
    assert_eq!(
        made.program.is_none(),
        made.diagnostics.iter().any(is_error)
    );
    if let Some(tree) = &made.tree {
        let mut machine = Machine::new(tree).with_steps(2_000);
        for scan in 0..3 {
            let _ = machine.scan(scan * 40);
        }
    }
    if let Some((mut checked, _)) = made.program {
        let mut plc = Plc::new(checked.lend());
        for scan in 0..3 {
            let _ = plc.scan(Inputs::default(), scan * 40);
        }
    }
}

#[test]
fn every_file_of_the_corpus() {
    unoclp_testing::each_of_corpus("typed", hold);
}
