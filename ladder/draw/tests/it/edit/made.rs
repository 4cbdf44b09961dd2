//! Documents and elements that others make.

use super::canvas::of_codes;
use unoclp_core::Target;
use unoclp_core::isa::Opcode;
use unoclp_draw::Names;
use unoclp_draw::edit::{Document, Draft, Refusal, Step};
use unoclp_point::Address;

#[test]
fn a_document_of_rungs_has_their_codes_and_says_what_it_is_given() {
    let of = of_codes("0 827301 40 827901 41 -827302 877901 787600 827303 877902");
    let rungs = of.rungs().cloned().collect();
    let names = Names::from([(Address::Input(1), "start".to_owned())]);
    let title = vec!["a title".to_owned()];
    let made = Document::of_rungs(rungs, title.clone(), names.clone());
    assert_eq!(made.codes(), of.codes());
    assert_eq!(made.title(), title);
    assert_eq!(made.table().names(), names);
    let named = [1, 2].map(|input| made.table().get(Address::Input(input)).is_some());
    assert_eq!(named, [true, false]);
    assert_eq!(of.clone().with_names(names.clone()).codes(), of.codes());
    assert_eq!(of.with_names(names.clone()).table().names(), names);
}

#[test]
fn only_a_comparison_has_a_load_and_only_a_load() {
    let [load, not] = [Opcode::Load, Opcode::Not].map(|opcode| Step::new(opcode).with_number(1));
    let greater = Step::new(Opcode::Greater).with_number(1);
    let is_one = |load: &Step, step: &Step| Draft::comparison(Some(load.clone()), step.clone());
    assert!(is_one(&load, &greater).is_ok());
    for (load, step) in [(&not, &greater), (&load, &not), (&not, &not)] {
        assert_eq!(is_one(load, step).err(), Some(Refusal::NotAnElement));
    }
}

#[test]
fn a_timer_says_what_it_drives() {
    let lines = [Some(500), Some(7901)];
    let target = |opcode| Step::new(opcode).with_lines(lines).target();
    assert_eq!(target(Opcode::OnDelay), Some(Target::Output(1)));
    assert_eq!(target(Opcode::Add), None);
}
