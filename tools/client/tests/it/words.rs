//! What a person is told, in both languages.

use std::collections::HashSet;
use unoclp_client::Failure;
use unoclp_client::event::{Away, Refusal, Undone};
use unoclp_client::start::NotFound;
use unoclp_client::upload::Broken;
use unoclp_client::words::{no_such, not_found, undone};
use unoclp_modbus::Exception;
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

#[test]
fn why_an_order_is_not_done_is_said_for_each_reason() {
    let refused = [
        Refusal::InFault,
        Refusal::Switch,
        Refusal::InUpload,
        Refusal::NotInStop,
        Refusal::CommandsLocked,
        Refusal::WritingLocked,
        Refusal::Other(Exception::IllegalDataAddress),
        Refusal::Other(Exception::IllegalDataValue),
    ];
    let others = [
        Undone::Away(Away::NotFound(NotFound::Silent)),
        Undone::Away(Away::Gone(Failure::Garbled)),
        Undone::Lost(Failure::Refused(Exception::ServerDeviceFailure)),
        Undone::NoPoint(Address::Input(1)),
        Undone::NotStopped(Failure::Silent),
        Undone::NotStopped(Failure::Refused(Exception::IllegalFunction)),
        Undone::Broken(Broken::NotBegun),
        Undone::Broken(Broken::UnknownState),
        Undone::Broken(Broken::Locked),
        Undone::Broken(Broken::Ended),
        Undone::Broken(Broken::Before(Failure::Silent)),
        Undone::NotStarted(Failure::Silent),
    ];
    let all: Vec<Undone> = refused
        .map(Undone::Refused)
        .into_iter()
        .chain(others)
        .collect();
    let told = |lang| all.iter().map(move |why| undone(lang, why));
    let each: HashSet<String> = told(Lang::En).chain(told(Lang::Pt)).collect();
    assert_eq!(each.len(), 2 * all.len(), "{each:#?}");
    assert!(each.iter().all(|text| text.contains(' ')), "{each:#?}");
}
