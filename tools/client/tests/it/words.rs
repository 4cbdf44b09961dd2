//! What a person is told, in both languages.

use unoclp_client::start::NotFound;
use unoclp_client::words::{no_such, not_found};
use unoclp_point::Address;
use unoclp_words::Lang;

#[test]
fn why_there_is_no_board_is_said_for_each_reason() {
    for lang in [Lang::En, Lang::Pt] {
        let told = [NotFound::Silent, NotFound::Garbled, NotFound::Foreign(None)]
            .map(|why| not_found(lang, &why));
        assert!(told.iter().all(|text| text.contains(' ')), "{told:?}");
        assert!(told[0] != told[1] && told[1] != told[2], "{told:?}");
    }
}

#[test]
fn a_point_that_no_client_writes_is_named() {
    for point in [Address::Input(1), Address::Output(99)] {
        for lang in [Lang::En, Lang::Pt] {
            let told = no_such(lang, point);
            assert!(told.contains(&point.to_string()), "{told}");
        }
    }
}
