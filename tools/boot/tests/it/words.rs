//! What is said of each failure, and where it is described.

use std::collections::BTreeSet;
use unoclp_boot::{Failure, Model, Stage, Trouble, Unfit};
use unoclp_words::Lang;

/// One of each.
fn all(lang: Lang) -> Vec<(u8, String)> {
    let unfit = [
        Unfit::NotHex { line: 3 },
        Unfit::Damaged { line: 3 },
        Unfit::CutShort,
        Unfit::Twice { address: 0x20 },
        Unfit::OtherChip { model: Model::Uno },
        Unfit::TooLarge {
            bytes: 31_738,
            model: Model::Nano,
        },
    ];
    let troubles = [
        Trouble::Silent,
        Trouble::Foreign,
        Trouble::OtherChip {
            signature: [0x1E, 0x98, 0x01],
            model: Model::Uno,
        },
        Trouble::BrokenOff,
        Trouble::Garbled,
        Trouble::Differs {
            address: 0x80,
            written: 1,
            read: 0,
        },
        Trouble::Lost("unplugged".to_owned()),
    ];
    let failures = troubles.map(|trouble| Failure {
        trouble,
        stage: Stage::Writing,
    });
    let unfit = unfit.iter().map(|unfit| (unfit.number(), unfit.text(lang)));
    let failures = failures
        .iter()
        .map(|failure| (failure.number(), failure.text(lang)));
    unfit.chain(failures).collect()
}

#[test]
fn each_failure_says_its_number_what_is_wrong_and_what_the_board_holds() {
    let english = all(Lang::En);
    assert_eq!(
        english[0].1,
        "FW-11: line 3 is not Intel HEX; name a firmware file that ends in .hex"
    );
    assert_eq!(
        english[11].1,
        "FW-26: at address 0x0080 the flash holds 00, but 01 was written; try again. If it happens twice, use another \
         cable. The board has no firmware now, and its outputs are off; its boot loader still \
         works, so try again"
    );
    let untouched = Failure {
        trouble: Trouble::Silent,
        stage: Stage::Meeting,
    };
    let text = untouched.text(Lang::Pt);
    assert!(
        text.ends_with("A placa ainda tem o firmware antigo"),
        "{text}"
    );
    for (number, text) in english.into_iter().chain(all(Lang::Pt)) {
        assert!(text.starts_with(&format!("FW-{number}: ")), "{text}");
    }
}

#[test]
fn the_pages_describe_each_number_and_no_other() {
    let numbers: BTreeSet<String> = all(Lang::En)
        .into_iter()
        .map(|(number, _)| format!("FW-{number}"))
        .collect();
    let pages = [
        include_str!("../../../../docs/flash.md"),
        include_str!("../../../../docs/flash.pt-BR.md"),
    ];
    for page in pages {
        let anchors = page.split("<a id=\"").skip(1);
        let anchors = anchors.filter_map(|rest| rest.split('"').next());
        let anchors: BTreeSet<String> = anchors.map(str::to_owned).collect();
        assert_eq!(anchors, numbers);
    }
}
