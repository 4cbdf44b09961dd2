//! The symbols of a power circuit (IEC 60617), three wires side by side.

use super::brush::Brush;
use crate::parts::electric::{contactor, fuse, motor, overload};

/// Where the three wires are.
const WIRES: [i32; 3] = [14, 30, 46];

pub(crate) fn fuse(b: &mut Brush<'_>) {
    let (blown, live) = (b.is(fuse::V::blown), b.get(fuse::V::current) > 0);
    let class = if live { "hot" } else { "wire" };
    for (twin, x) in WIRES.into_iter().enumerate() {
        b.twin = twin;
        b.rect([x - 5, 22, 10, 34], 1, "body");
        let way = if blown {
            format!("M{x} 0V30M{x} 50V80")
        } else {
            format!("M{x} 0V80")
        };
        b.live("wire").path(way, class);
    }
    b.twin = 0;
    b.live("blown").shown(blown, |b| {
        b.path("M4 18L56 60M56 18L4 60", "hot");
    });
    let label = b.label();
    b.text([60, 44], "tag", label);
}

pub(crate) fn contactor(b: &mut Brush<'_>) {
    let (closed, coil) = (b.is(contactor::V::closed), b.is(contactor::V::coil));
    for (twin, x) in WIRES.into_iter().enumerate() {
        b.twin = twin;
        b.live("ends").path(
            format!("M{x} 0V22M{x} 54V80"),
            if closed { "hot" } else { "wire" },
        );
        b.path(format!("M{} 22a4 4 0 0 1 8 0", x - 4), "wire");
        let way = if closed {
            format!("M{x} 54L{x} 22")
        } else {
            format!("M{x} 54L{} 24", x - 10)
        };
        b.live("blade")
            .path(way, if closed { "hot" } else { "wire" });
    }
    b.twin = 0;
    let x = if closed { 14 } else { 9 };
    b.live("link").path(format!("M{x} 38H62"), "dash");
    b.live("coil")
        .rect([62, 28, 18, 22], 2, if coil { "red-on" } else { "body" });
    let label = b.label();
    b.text([62, 22], "tag", label);
}

pub(crate) fn overload(b: &mut Brush<'_>) {
    let (tripped, heat) = (b.is(overload::V::tripped), b.get(overload::V::heat));
    b.rect([2, 18, 56, 44], 3, "body");
    b.live("heat").rect(
        [3, 61 - heat * 42 / 1000, 54, heat * 42 / 1000],
        0,
        "heat glow",
    );
    let class = if b.get(overload::V::current) > 0 {
        "hot"
    } else {
        "wire"
    };
    for (twin, x) in WIRES.into_iter().enumerate() {
        b.twin = twin;
        b.live("wire")
            .path(format!("M{x} 0V28H{}V40H{x}V80", x + 8), class);
    }
    b.twin = 0;
    b.live("state")
        .circle([69, 46], 7, if tripped { "red-on" } else { "green-off" });
    let label = b.label();
    b.text([62, 32], "tag", label);
}

pub(crate) fn motor(b: &mut Brush<'_>) {
    let (turns, angle) = (b.is(motor::V::turns), b.get(motor::V::angle) / 1000);
    let live = b.get(motor::V::current) > 0;
    for (twin, (x, end)) in WIRES.into_iter().zip([26, 18, 26]).enumerate() {
        b.twin = twin;
        b.live("wire")
            .path(format!("M{x} 0V{end}"), if live { "hot" } else { "wire" });
    }
    b.twin = 0;
    b.circle([30, 52], 34, "body");
    b.live("rim")
        .circle([30, 52], 29, if turns { "green-on glow" } else { "cool" });
    b.text([30, 52], "title mid", "M");
    b.text([30, 68], "small", "3 ~");
    b.live("shaft").turned(angle, [30, 52], |b| {
        b.path("M30 18L25 27H35ZM30 86L25 77H35Z", "solid");
    });
    let speed = format!("{} rpm", b.get(motor::V::speed));
    b.live("speed").text([104, 62], "small", speed);
    let label = b.label();
    b.text([72, 42], "tag", label);
}
