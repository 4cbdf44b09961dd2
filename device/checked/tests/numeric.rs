//! The map of numeric code: what each line of a file comes to.

use unoclp_checked::numeric;
use unoclp_core::{Board, Cause, Plc};

#[test]
fn a_file_has_a_title_and_each_step_its_place() {
    // A mark, line ends of both kinds, blanks, a rule, comments after codes, and no end of the last line.
    let file = "\u{FEFF}/ Pump\r\n/ ------\r\n//\r\n/   I1  start\r\n/\r\n\t 0 / here\r\n\r\n/ Fill\n/\n/\n\
        / slowly\n  827301/ RI\n\n/ for 5 s\n847978\n/ the preset\n 5000 / ms\n  7901\n/ the end\n\t-787984";
    let faults = numeric(file.as_bytes(), Board::UNO).unwrap_err();
    assert_eq!(faults[0].fault.cause, Cause::UnknownCode);
    let file = file.replace("-787984", "787984");
    let (checked, map) = numeric(file.as_bytes(), Board::UNO).unwrap();
    assert_eq!(checked.program().steps().count(), 3);
    assert_eq!(map.title, ["Pump", "", "  I1  start"]);
    let places: Vec<_> = map.steps.iter().collect();
    let [contact, timer, not] = places[..] else {
        panic!("{map:#?}")
    };
    assert_eq!((contact.line, contact.column, contact.last), (12, 3, 12));
    assert_eq!(contact.comments, ["Fill", "", "slowly"]);
    assert_eq!((timer.line, timer.column, timer.last), (15, 1, 18));
    assert_eq!(timer.comments, ["for 5 s"]);
    assert_eq!((not.line, not.column, not.last), (20, 2, 20));
    assert_eq!(not.comments, ["the end"]);

    assert_eq!(map.lines(0, 3), Some((12, 20)));
    assert_eq!(map.lines(1, 1), Some((15, 18)));
    assert_eq!(map.lines(2, 2), None, "there is no fourth step");
    for line in 15..=18 {
        assert_eq!(map.of_code(line), Some(timer));
    }
    assert_eq!(map.of_code(6), None);
    assert_eq!(map.about(1).collect::<Vec<_>>(), ["for 5 s"]);
}

#[test]
fn the_first_bytes_of_a_file_are_no_blanks() {
    let (_, map) = numeric(b"\xEF\xBB\xBF0\n827301\n", Board::UNO).unwrap();
    assert_eq!((map.steps[0].line, map.steps[0].column), (2, 1));
}

#[test]
fn faults_are_told_in_order_with_their_bytes() {
    let faults = numeric(b"0\n1\n40\n8x\n", Board::UNO).unwrap_err();
    let told: Vec<_> = faults
        .iter()
        .map(|told| (told.fault.cause, told.fault.line, told.told_at))
        .collect();
    assert_eq!(
        told,
        [
            (Cause::UnknownCode, Some(2), Some(3)),
            (Cause::StrayCharacter, Some(4), Some(8)),
            (Cause::BranchLeftOpen, Some(3), None),
        ]
    );
    assert!(numeric(b"", Board::UNO).is_err());
}

#[test]
fn a_lent_program_runs_in_its_own_memory() {
    let (mut checked, _) = numeric(b"0\n827301\n847978\n5000\n7901\n", Board::UNO).unwrap();
    let stored = checked.program().stored().to_vec();
    let mut plc = Plc::new(checked.lend());
    assert_eq!(plc.stored(), stored);
    plc.scan(unoclp_core::Image(1), 0).unwrap();
    assert_eq!(plc.timers(0).count(), 1);
    assert_eq!(checked.program().stored(), stored);
}
