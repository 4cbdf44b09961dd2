//! The names that a plant's conditions read, and where each value is.

use crate::plant::Plant;
use crate::signal::At;
use unoclp_core::{Board, Point};
use unoclp_lang::typed::Base;

/// What the time is called.
pub(crate) const CLOCK: &str = "clock";

/// The names, each with its type, and where each is.
pub(crate) fn names(plant: &Plant) -> (Vec<(String, Base)>, Vec<At>) {
    let mut names = vec![(CLOCK.to_owned(), Base::Dint)];
    let mut places = vec![At::Clock];
    let Board {
        inputs, outputs, ..
    } = plant.board;
    for number in 1..=outputs {
        names.push((format!("Q{number}"), Base::Bool));
        places.extend(Point::new(number, outputs).map(At::Output));
    }
    for number in 1..=inputs {
        names.push((format!("I{number}"), Base::Bool));
        places.extend(Point::new(number, inputs).map(At::Input));
    }
    for part in &plant.parts {
        for (slot, cell) in part.kind.values.iter().zip(&part.cells) {
            if slot.is_seen {
                let base = if slot.is_flag { Base::Bool } else { Base::Dint };
                names.push((format!("{}.{}", part.name, slot.name), base));
                places.push(At::Cell(*cell));
            }
        }
    }
    (names, places)
}
