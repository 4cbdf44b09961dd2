//! The symbols of what drives and walks.

use super::brush::{Brush, colour, display};
use super::picture::Value;
use crate::parts::traffic::{junction, lane, light, road, walk};

pub(crate) fn light(b: &mut Brush<'_>) {
    let walks = b.given(light::F::shows) == 1;
    let foot = if walks { 70 } else { 96 };
    b.rect([22, foot, 6, 130 - foot], 0, "metal");
    b.rect([6, 0, 38, if walks { 70 } else { 98 }], 8, "deep");
    let (red, yellow, green) = (
        b.is(light::V::red),
        b.is(light::V::yellow),
        b.is(light::V::green),
    );
    b.live("red").circle([25, 19], 12, colour(1, red));
    if !walks {
        b.live("yellow").circle([25, 49], 12, colour(2, yellow));
    }
    b.live("green")
        .circle([25, if walks { 51 } else { 79 }], 12, colour(0, green));
    b.name([25, -6]);
}

fn car(b: &mut Brush<'_>) {
    b.rect([0, 0, 44, 24], 7, "car");
    b.rect([26, 3, 9, 18], 3, "glass");
    b.rect([7, 3, 6, 18], 2, "glass");
}

pub(crate) fn road(b: &mut Brush<'_>) {
    b.rect([0, 10, 420, 70], 0, "road");
    b.rect([0, 6, 420, 4], 0, "kerb");
    b.rect([0, 80, 420, 4], 0, "kerb");
    for dash in 0..10 {
        b.rect([6 + 44 * dash, 43, 20, 3], 0, "mark");
    }
    b.rect([246, 12, 5, 66], 0, "mark");
    for stripe in 0..6 {
        b.rect([262, 14 + 11 * stripe, 46, 6], 0, "mark");
    }
    let waiting = b.get(road::V::waiting);
    for place in 0..5 {
        b.twin = place as usize + 1;
        let there = waiting > place;
        b.live("car")
            .shown(there, |b| b.moved(198 - 50 * place, 50, car));
    }
    b.twin = 0;
    let (passes, on, takes) = (
        b.is(road::V::passes),
        b.get(road::V::on),
        b.given(road::F::takes),
    );
    let x = 250 + (takes - on).max(0) * 120 / takes.max(1);
    let moved = [("transform", Value::Moved(x, 50)), display(passes)];
    b.live("passing").group(&moved, car);
    let hit = b.is(road::V::hit);
    b.live("hit").shown(hit, |b| b.moved(285, 20, burst));
    b.live("queue").text(
        [24, 30],
        "small mark",
        if waiting > 5 {
            format!("+{}", waiting - 5)
        } else {
            String::new()
        },
    );
    b.name([60, 100]);
}

/// What shows that something was hit, from its upper point on.
fn burst(b: &mut Brush<'_>) {
    b.path(
        "M0 0l6 14l16 -4l-10 13l12 10l-16 1l-2 16l-10 -12l-13 9l3 -16l-14 -7l15 -6Z",
        "red-on",
    );
}

/// A car that drives down.
fn car_down(b: &mut Brush<'_>) {
    b.rect([0, 0, 24, 44], 7, "car");
    b.rect([3, 26, 18, 9], 3, "glass");
    b.rect([3, 7, 18, 6], 2, "glass");
}

/// A crossing stands where the road of a `road` has its own, so that a `walk` fits both.
pub(crate) fn junction(b: &mut Brush<'_>) {
    b.rect([0, 150, 520, 70], 0, "road");
    b.rect([380, 0, 70, 330], 0, "road");
    for y in [146, 220] {
        b.rect([0, y, 376, 4], 0, "kerb");
        b.rect([454, y, 66, 4], 0, "kerb");
    }
    for x in [376, 450] {
        b.rect([x, 0, 4, 150], 0, "kerb");
        b.rect([x, 220, 4, 110], 0, "kerb");
    }
    for dash in [0, 1, 2, 3, 4, 5, 7] {
        b.rect([6 + 44 * dash, 183, 20, 3], 0, "mark");
    }
    b.rect([470, 183, 20, 3], 0, "mark");
    for dash in [0, 1, 2, 5, 6] {
        b.rect([413, 6 + 46 * dash, 3, 20], 0, "mark");
    }
    b.rect([246, 152, 5, 66], 0, "mark");
    b.rect([382, 134, 66, 5], 0, "mark");
    for stripe in 0..6 {
        b.rect([262, 154 + 11 * stripe, 46, 6], 0, "mark");
    }
    let (across, down) = (
        b.get(junction::V::waiting_across),
        b.get(junction::V::waiting_down),
    );
    for place in 0..5 {
        b.twin = place as usize + 1;
        b.live("across")
            .shown(across > place, |b| b.moved(198 - 50 * place, 190, car));
    }
    for place in 0..2 {
        b.twin = place as usize + 1;
        b.live("down")
            .shown(down > place, |b| b.moved(386, 84 - 50 * place, car_down));
    }
    b.twin = 0;
    let takes = b.given(junction::F::takes);
    // How much of its way a car has gone that still takes so long.
    let gone = |on: i32, way: i32| (takes - on).max(0) * way / takes.max(1);
    let x = 250 + gone(b.row(junction::V::on, 0), 220);
    let moved = [
        ("transform", Value::Moved(x, 190)),
        display(b.is(junction::V::passes_across)),
    ];
    b.live("passing").group(&moved, car);
    let y = 138 + gone(b.row(junction::V::on, 1), 140);
    let moved = [
        ("transform", Value::Moved(386, y)),
        display(b.is(junction::V::passes_down)),
    ];
    b.live("driving").group(&moved, car_down);
    let (hit, crashed) = (b.is(junction::V::hit), b.is(junction::V::crashed));
    b.live("hit").shown(hit, |b| b.moved(285, 160, burst));
    b.live("crashed")
        .shown(crashed, |b| b.moved(408, 166, burst));
    let more = |waiting: i32, shown: i32| match waiting > shown {
        true => format!("+{}", waiting - shown),
        false => String::new(),
    };
    b.live("queue")
        .text([24, 170], "small mark", more(across, 5));
    b.live("queue_down")
        .text([432, 16], "small mark", more(down, 2));
    b.name([60, 244]);
}

fn person(b: &mut Brush<'_>) {
    b.circle([8, 6], 6, "skin");
    b.rect([1, 12, 14, 17], 5, "cloth");
}

pub(crate) fn walk(b: &mut Brush<'_>) {
    let waiting = b.get(walk::V::waiting);
    for place in 0..4 {
        b.twin = place as usize + 1;
        b.live("person")
            .shown(waiting > place, |b| b.moved(50 + 20 * place, 160, person));
    }
    b.twin = 0;
    let (walks, on, takes) = (
        b.is(walk::V::walks),
        b.get(walk::V::on),
        b.given(walk::F::takes),
    );
    let y = 128 - (takes - on).max(0) * 120 / takes.max(1);
    let moved = [("transform", Value::Moved(66, y)), display(walks)];
    b.live("walking").group(&moved, person);
    b.rect([14, 150, 18, 44], 3, "metal");
    let pressed = b.is(walk::V::pressed) || b.get(walk::V::presses) > 0;
    b.live("button").circle(
        [23, 164],
        6,
        if pressed { "yellow-on" } else { "yellow-off" },
    );
    b.name([60, 210]);
}

pub(crate) fn lane(b: &mut Brush<'_>) {
    b.rect([0, 24, 420, 70], 0, "road");
    b.rect([0, 20, 420, 4], 0, "kerb");
    b.rect([0, 94, 420, 4], 0, "kerb");
    let waiting = b.get(lane::V::waiting);
    for place in 0..3 {
        b.twin = place as usize + 1;
        b.live("car")
            .shown(waiting > place, |b| b.moved(116 - 50 * place, 46, car));
    }
    b.twin = 0;
    let (passes, on, takes) = (
        b.is(lane::V::passes),
        b.get(lane::V::on),
        b.given(lane::F::takes),
    );
    let x = 130 + (takes - on).max(0) * 110 / takes.max(1);
    let moved = [("transform", Value::Moved(x, 46)), display(passes)];
    b.live("passing").group(&moved, car);
    let (inside, spaces) = (b.get(lane::V::inside), b.given(lane::F::spaces));
    for place in 0..6 {
        b.twin = place as usize + 1;
        let x = 262 + 50 * (place % 3);
        let y = 30 + 34 * (place / 3);
        b.rect([x - 2, y - 3, 48, 30], 2, "shine");
        b.live("parked")
            .shown(inside > place, |b| b.moved(x, y, car));
    }
    b.twin = 0;
    b.live("inside")
        .text([340, 114], "label", format!("{inside} / {spaces}"));
    b.name([60, 114]);
}
