//! Whatever bytes come as Instruction List: what is told of them stands in them and can be shown, and what
//! is made of them loads, and reads back as itself.

use crate::common::{LARGE, large, plc};
use unoclp_lang::{Lang, TextLanguage, compile, compile_text, show, to_il};

/// What holds of all bytes; the target `il` of `proof/fuzz/` looks for those of which it does not.
pub fn hold(bytes: &[u8]) {
    let text = String::from_utf8_lossy(bytes);
    let compiled = compile_text(&text, TextLanguage::Il, unoclp_core::Board::UNO);
    for diagnostic in compiled.diagnostics.iter() {
        assert!(
            text.get(diagnostic.span.range()).is_some(),
            "{diagnostic:?}"
        );
        assert!(!diagnostic.message(Lang::Pt).is_empty());
    }
    let renderer = annotate_snippets::Renderer::plain();
    let shown = show("x.il", &text, &compiled.diagnostics, Lang::En, &renderer);
    assert_eq!(shown.is_empty(), compiled.diagnostics.is_empty());
    assert_eq!(compiled.file().is_none(), compiled.has_errors());

    // On a board where size decides nothing.
    let compiled = compile(&text, TextLanguage::Il, &large());
    if let Some(file) = compiled.file() {
        let mut memory = vec![0; LARGE.plc_bytes()];
        plc(&file, &mut memory, LARGE);
        let back = to_il(file.as_bytes(), LARGE).unwrap_or_else(|fault| panic!("{fault}\n{file}"));
        let again = compile(&back, TextLanguage::Il, &large());
        assert!(
            !again.has_errors(),
            "{file}\n{back}\n{:#?}",
            again.diagnostics
        );
        assert_eq!(again.codes(), compiled.codes(), "{file}\n{back}");
    }
}

#[test]
fn every_file_of_the_corpus() {
    unoclp_testing::each_of_corpus("il", hold);
}
