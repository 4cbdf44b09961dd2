//! Which symbol each kind has.

use super::brush::Brush;
use super::{electric, fluid, heat, motion, panel, traffic, transport};
use crate::kind::Kind;

/// Draws a part.
pub(super) type Symbol = fn(&mut Brush<'_>);

/// The symbol of a kind; none of a kind that is not there, which a test would find.
pub(super) fn of(kind: &Kind) -> Option<Symbol> {
    Some(match kind.name {
        "button" => panel::button,
        "switch" => panel::switch,
        "key" => panel::key,
        "emergency" => panel::emergency,
        "lamp" => panel::lamp,
        "tower" => panel::tower,
        "buzzer" => panel::buzzer,
        "dial" => panel::dial,
        "bar" => panel::bar,
        "number" => panel::number,
        "fuse" => electric::fuse,
        "contactor" => electric::contactor,
        "overload" => electric::overload,
        "motor" => electric::motor,
        "tank" => fluid::tank,
        "valve" => fluid::valve,
        "pump" => fluid::pump,
        "stirrer" => fluid::stirrer,
        "float" => fluid::float,
        "level" => fluid::transmitter,
        "oven" => heat::oven,
        "heater" => heat::heater,
        "fan" => heat::fan,
        "thermometer" => heat::thermometer,
        "cylinder" => motion::cylinder,
        "gate" => motion::gate,
        "door" => motion::door,
        "elevator" => motion::elevator,
        "call" => motion::call,
        "bin" => transport::bin,
        "belt" => transport::belt,
        "feeder" => transport::feeder,
        "eye" => transport::eye,
        "inductive" => transport::inductive,
        "height" => transport::height,
        "pusher" => transport::pusher,
        "filler" => transport::filler,
        "counter" => transport::counter,
        "light" => traffic::light,
        "road" => traffic::road,
        "junction" => traffic::junction,
        "walk" => traffic::walk,
        "lane" => traffic::lane,
        _ => return None,
    })
}
