//! The symbols of what moves to and fro.

use super::brush::Brush;
use super::panel::cap;
use super::picture::Value;
use crate::parts::motion::{call, cylinder, door, elevator, gate};

pub(crate) fn cylinder(b: &mut Brush<'_>) {
    let position = b.get(cylinder::V::position) * 70 / 1000;
    let (home, out) = (b.is(cylinder::V::at_home), b.is(cylinder::V::out));
    b.rect([0, 6, 96, 38], 4, "metal");
    b.rect([6, 12, 84, 26], 0, "paper");
    b.live("rod")
        .group(&[("transform", Value::Moved(position, 0))], |b| {
            b.rect([10, 12, 8, 26], 1, "dark");
            b.rect([18, 21, 86, 8], 0, "steel");
            b.rect([100, 10, 10, 30], 2, "dark");
        });
    b.rect([90, 6, 8, 38], 1, "metal");
    b.live("in")
        .circle([14, 2], 5, if home { "green-on" } else { "green-off" });
    b.live("out")
        .circle([82, 2], 5, if out { "green-on" } else { "green-off" });
    let (hand, hurt) = (b.is(cylinder::V::hand_in), b.is(cylinder::V::hurt));
    b.live("hand").shown(hand || hurt, |b| {
        b.path(
            "M150 50C146 40 152 32 158 36V20a4 4 0 0 1 8 0V34l10 4c4 2 4 8 2 14",
            "skin",
        );
    });
    b.live("hurt")
        .shown(hurt, |b| b.text([166, 14], "warn", "!"));
    b.name([48, 60]);
}

pub(crate) fn gate(b: &mut Brush<'_>) {
    let position = b.get(gate::V::position);
    b.rect([4, 40, 26, 62], 4, "yellow-on");
    b.live("arm").turned(-position * 80 / 1000, [17, 50], |b| {
        b.rect([10, 44, 168, 12], 4, "paper");
        for stripe in 0..5 {
            b.rect([34 + 30 * stripe, 44, 15, 12], 0, "red-on");
        }
        b.rect([10, 44, 168, 12], 4, "ink");
    });
    b.circle([17, 50], 7, "dark");
    let label = b.label();
    b.text([36, 84], "tag", label);
}

pub(crate) fn door(b: &mut Brush<'_>) {
    let position = b.get(door::V::position);
    b.rect([0, 0, 160, 118], 4, "dark");
    b.rect([12, 12, 136, 106], 0, "cool");
    let (stands, crushed) = (b.is(door::V::obstacle), b.is(door::V::crushed));
    b.live("person").shown(stands || crushed, |b| {
        b.circle([80, 66], 9, "skin");
        b.rect([70, 76, 20, 26], 6, "cloth");
        b.rect([72, 100, 6, 18], 2, "dark");
        b.rect([82, 100, 6, 18], 2, "dark");
    });
    // It is rolled up as it opens.
    let height = 106 - position * 100 / 1000;
    b.live("leaf").rect([12, 12, 136, height], 0, "metal");
    for slat in 1..=8 {
        b.twin = slat;
        let y = 12 + height * slat as i32 / 9;
        b.live("slat").line([12, y], [148, y], "thin");
    }
    b.twin = 0;
    b.live("crushed")
        .shown(crushed, |b| b.text([80, 60], "warn", "!"));
    b.line([-12, 118], [172, 118], "floor");
    b.name([80, 138]);
}

pub(crate) fn elevator(b: &mut Brush<'_>) {
    let position = b.get(elevator::V::position);
    let floors = b.given(elevator::F::floors).max(1);
    // From floor to floor, and how tall the car is.
    let storey = 318 / floors;
    let tall = storey - 14;
    b.rect([20, 0, 90, 320], 2, "frame");
    for floor in 0..floors {
        let y = 318 - floor * storey;
        b.line([0, y], [20, y], "floor");
        b.text([8, y - 8], "tag mid", (floor + 1).to_string());
        let here = b.get(elevator::V::floor) == floor + 1;
        b.twin = floor as usize + 1;
        b.live("switch").circle(
            [116, y - storey * 2 / 5],
            5,
            if here { "green-on" } else { "green-off" },
        );
    }
    b.twin = 0;
    let y = 318 - tall - position * storey / 1000;
    b.live("rope").line([65, 0], [65, y], "ink");
    let car = b.part.given.get(elevator::F::door as usize).copied();
    let open = match car {
        Some(crate::signal::Given::Part(door)) => b.run.value(door, door::V::position.into()),
        _ => 0,
    };
    b.live("car")
        .group(&[("transform", Value::Moved(0, y))], |b| {
            b.rect([28, 0, 74, tall], 3, "metal");
            b.rect([34, 8, 62, tall - 8], 0, "yellow-on glow");
            let wide = 31 - open * 28 / 1000;
            b.live("left").rect([34, 8, wide, tall - 8], 0, "steel");
            b.live("right")
                .rect([96 - wide, 8, wide, tall - 8], 0, "steel");
        });
    let crashed = b.is(elevator::V::crashed);
    b.live("crashed")
        .shown(crashed, |b| b.text([65, 20], "warn", "!"));
    b.name([65, 338]);
}

pub(crate) fn call(b: &mut Brush<'_>) {
    // No field has a colour, so it is the first.
    cap(b, call::V::pressed.into(), usize::MAX);
    let waiting = b.is(call::V::waiting);
    b.live("waiting")
        .circle([54, 10], 6, if waiting { "red-on" } else { "red-off" });
}
