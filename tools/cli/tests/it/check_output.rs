//! What `unoclp check` says of the faulty programs in `tests/data/check`, each beside its text.
//!
//! Where the text is meant to change: `cd tests/data/check; unoclp check X.txt > X.expected`, and
//! read what came of it.

use annotate_snippets::Renderer;
use std::fs;
use std::path::Path;
use unoclp_checked::numeric;
use unoclp_lang::Lang;
use unoclp_program::diagnosis::show;

#[test]
fn faults_are_shown_as_expected() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/check");
    let mut count = 0;
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|end| end != "txt") {
            continue;
        }
        count += 1;
        let name = path.file_name().unwrap().to_str().unwrap();
        let file = fs::read(&path).unwrap();
        let faults = numeric(&file, unoclp_core::Board::UNO).expect_err(name);
        let shown = show(name, &file, &faults, Lang::En, &Renderer::plain());
        let expected = fs::read_to_string(path.with_extension("expected")).unwrap();
        let expected = expected.replace("\r\n", "\n");
        assert_eq!(shown, expected.trim_end_matches('\n'), "{name}:\n{shown}");
    }
    assert!(count >= 10, "{count} files");
}

#[test]
fn any_bytes_can_be_shown() {
    let mut random = unoclp_host_sim::random::Random::new(5);
    let mut shown = 0;
    for _ in 0..2_000 {
        let alphabet = [
            0, 0x0A, 0x0D, 0x30, 0x2D, 0x2F, 0x80, 0xBB, 0xBF, 0xC3, 0xE2, 0xEF, 0xF0, 0xFF,
        ];
        let length = random.below(40);
        let file: Vec<u8> = (0..length).filter_map(|_| random.pick(&alphabet)).collect();
        if let Err(faults) = numeric(&file, unoclp_core::Board::UNO) {
            assert!(!faults.is_empty());
            let text = show("noise", &file, &faults, Lang::En, &Renderer::plain());
            assert!(!text.contains('\0') && !text.contains('\r'), "{file:?}");
            shown += 1;
        }
    }
    assert!(shown > 1_000, "{shown}");
}
