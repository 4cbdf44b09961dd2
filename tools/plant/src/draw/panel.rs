//! The symbols of what a person presses and sees.

use super::brush::{Brush, colour};
use crate::parts::panel::{bar, button, buzzer, dial, emergency, key, lamp, number, switch, tower};

/// Where the label stands.
const NAME: [i32; 2] = [30, 82];

fn collar(b: &mut Brush<'_>) {
    b.circle([30, 34], 28, "rim");
    b.circle([30, 34], 23, "deep");
}

pub(crate) fn button(b: &mut Brush<'_>) {
    cap(b, button::V::pressed.into(), button::F::colour.into());
}

/// A cap of the colour of this field, which goes down with this flag.
pub(super) fn cap(b: &mut Brush<'_>, pressed: usize, field: usize) {
    collar(b);
    let pressed = b.is(pressed);
    let class = colour(b.given(field), true);
    b.live("cap")
        .circle([30, 34], if pressed { 16 } else { 20 }, class);
    b.live("shine")
        .ellipse([25, 27], if pressed { [6, 4] } else { [9, 6] }, "shine");
    b.name(NAME);
}

pub(crate) fn switch(b: &mut Brush<'_>) {
    let on = b.is(switch::V::on);
    lever(b, on, false);
}

pub(crate) fn key(b: &mut Brush<'_>) {
    let on = b.is(key::V::on);
    lever(b, on, true);
}

fn lever(b: &mut Brush<'_>, on: bool, key: bool) {
    b.circle([30, 34], 28, "rim");
    b.circle([30, 34], 20, "metal");
    // The signs of off and on (IEC 60417), and no text: what a control is called is its label alone.
    b.circle([8, 8], 4, "thin");
    b.line([52, 4], [52, 12], "thin");
    let degrees = if on { 40 } else { -40 };
    b.live("lever").turned(degrees, [30, 34], |b| match key {
        true => {
            b.circle([30, 34], 9, "dark");
            b.rect([27, 8, 6, 28], 2, "yellow-on");
            b.circle([30, 9], 8, "yellow-on");
            b.circle([30, 8], 3, "paper");
        }
        false => b.rect([24, 8, 12, 46], 5, "dark"),
    });
    b.name(NAME);
}

pub(crate) fn emergency(b: &mut Brush<'_>) {
    b.rect([0, 4, 60, 60], 8, "yellow-on");
    b.circle([30, 34], 26, "rim");
    let pressed = b.is(emergency::V::pressed);
    b.live("cap")
        .circle([30, 34], if pressed { 19 } else { 23 }, "red-on");
    b.path("M20 30A12 12 0 0 1 40 30M40 30l1 -7M40 30l-7 -1", "thin");
    b.name(NAME);
}

pub(crate) fn lamp(b: &mut Brush<'_>) {
    let lit = b.is(lamp::V::lit);
    let class = colour(b.given(lamp::F::colour), lit);
    let glow = format!("{} glow", if lit { class } else { "paper" });
    b.live("glow")
        .circle([30, 34], if lit { 33 } else { 1 }, glow);
    b.circle([30, 34], 26, "rim");
    b.live("lens").circle([30, 34], 21, class);
    b.path("M15 19L45 49M45 19L15 49", "thin");
    b.ellipse([23, 25], [8, 5], "shine");
    b.name(NAME);
}

pub(crate) fn tower(b: &mut Brush<'_>) {
    let lights = [
        (1, b.is(tower::V::red), "red"),
        (2, b.is(tower::V::yellow), "yellow"),
        (0, b.is(tower::V::green), "green"),
    ];
    for (at, (name, lit, id)) in lights.into_iter().enumerate() {
        b.live(id)
            .rect([10, 4 + 24 * at as i32, 24, 23], 4, colour(name, lit));
    }
    b.rect([18, 76, 8, 26], 0, "metal");
    b.rect([8, 100, 28, 7], 2, "dark");
    b.name([22, 120]);
}

pub(crate) fn buzzer(b: &mut Brush<'_>) {
    collar(b);
    for (x, y) in [
        (22, 27),
        (30, 24),
        (38, 27),
        (22, 37),
        (30, 34),
        (38, 37),
        (30, 44),
    ] {
        b.circle([x, y], 3, "soft");
    }
    let sounds = b.is(buzzer::V::sounds);
    b.live("sound").shown(sounds, |b| {
        b.path("M62 22A22 22 0 0 1 62 46M70 16A32 32 0 0 1 70 52", "ink");
    });
    b.name(NAME);
}

pub(crate) fn dial(b: &mut Brush<'_>) {
    for step in 0..=10 {
        b.turned(step * 27 - 135, [30, 34], |b| {
            b.line([30, 2], [30, 7], "thin")
        });
    }
    let turned = b.get(dial::V::turned);
    b.live("knob")
        .turned(turned * 270 / 1000 - 135, [30, 34], |b| {
            b.circle([30, 34], 22, "dark");
            b.line([30, 16], [30, 28], "hot");
        });
    b.name(NAME);
}

pub(crate) fn bar(b: &mut Brush<'_>) {
    let share = b.get(bar::V::share);
    b.rect([10, 4, 24, 100], 3, "body");
    let height = share * 96 / 1000;
    b.live("bar")
        .rect([12, 102 - height, 20, height], 0, "water");
    for step in 0..=4 {
        b.line([34, 6 + step * 24], [39, 6 + step * 24], "thin");
    }
    b.name([22, 120]);
}

pub(crate) fn number(b: &mut Brush<'_>) {
    let shown = b.get(number::V::shown);
    digits(b, shown);
}

/// A display with a number.
pub(super) fn digits(b: &mut Brush<'_>, shown: i32) {
    b.rect([0, 10, 84, 40], 5, "dark");
    b.rect([5, 15, 74, 30], 3, "deep");
    b.live("digits").text([42, 37], "digits", shown.to_string());
    b.name([42, 66]);
}
