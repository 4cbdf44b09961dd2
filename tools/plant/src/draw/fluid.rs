//! The symbols of what flows.

use super::brush::Brush;
use crate::parts::fluid::{float, level, pump, stirrer, tank, valve};

pub(crate) fn tank(b: &mut Brush<'_>) {
    let (level, mixed) = (b.get(tank::V::level), b.get(tank::V::mixed));
    let top = 150 - level * 136 / 1000;
    b.rect([0, 4, 120, 152], 12, "body");
    b.live("water").rect(
        [4, top, 112, 152 - top],
        6,
        if mixed >= 900 { "mixed" } else { "water" },
    );
    b.live("wave")
        .rect([4, top, 112, if level > 0 { 4 } else { 0 }], 2, "wave");
    for step in 0..=4 {
        b.line([108, 14 + step * 34], [118, 14 + step * 34], "thin");
    }
    let overflowed = b.is(tank::V::overflowed);
    b.live("spill").shown(overflowed, |b| {
        b.path(
            "M-2 6C-14 10 -10 60 -12 150M122 6C134 10 130 60 132 150",
            "flow",
        );
        b.ellipse([60, 162], [92, 7], "water");
    });
    b.live("level")
        .text([60, 92], "title mid", format!("{}%", level / 10));
    b.name([60, 30]);
}

pub(crate) fn valve(b: &mut Brush<'_>) {
    let position = b.get(valve::V::position);
    b.live("body").path(
        "M4 28V56L56 28V56Z",
        if position > 0 { "green-on" } else { "body" },
    );
    b.line([30, 42], [30, 20], "ink");
    b.live("drive").rect(
        [18, 4, 24, 16],
        3,
        if position > 0 { "green-on" } else { "metal" },
    );
    b.name([30, 72]);
}

pub(crate) fn pump(b: &mut Brush<'_>) {
    let (runs, broken) = (b.is(pump::V::runs), b.is(pump::V::broken));
    let angle = b.get(pump::V::angle);
    b.path("M14 66H66L58 56H22Z", "dark");
    b.path("M40 8H80V24H58", "metal");
    b.live("body")
        .circle([40, 36], 28, if runs { "green-on" } else { "body" });
    b.live("wheel").turned(angle, [40, 36], |b| {
        b.path("M40 36C30 30 30 20 40 14C38 24 42 30 40 36C46 26 56 26 60 36C50 34 46 40 40 36C50 42 50 52 40 58C42 48 38 42 40 36C34 46 24 46 20 36C30 38 34 32 40 36", "ink");
    });
    b.live("broken").shown(broken, |b| {
        b.path("M14 10L66 62M66 10L14 62", "hot");
    });
    b.name([40, 84]);
}

pub(crate) fn stirrer(b: &mut Brush<'_>) {
    let angle = b.get(stirrer::V::angle);
    b.rect([6, -16, 28, 22], 4, "dark");
    b.text([20, 0], "small", "M");
    b.rect([18, 6, 4, 116], 0, "metal");
    let wide = (18 * (90 - (angle % 180 - 90).abs()) / 90).max(4);
    b.live("blades").path(
        format!("M20 112l-{wide} -6v16ZM20 112l{wide} 6v-16Z"),
        "steel",
    );
}

pub(crate) fn float(b: &mut Brush<'_>) {
    let up = b.is(float::V::up);
    b.rect([26, 9, 12, 12], 2, "dark");
    b.live("arm")
        .turned(if up { 24 } else { -20 }, [28, 15], |b| {
            b.line([28, 15], [12, 15], "ink");
            b.ellipse([8, 15], [8, 6], "red-on");
        });
    b.live("contact")
        .circle([46, 15], 4, if up { "green-on" } else { "green-off" });
    let label = b.label();
    b.text([54, 19], "tag", label);
}

pub(crate) fn transmitter(b: &mut Brush<'_>) {
    let reading = b.get(level::V::reading);
    instrument(b, "LT", reading);
}

/// The circle of an instrument with its letters and its reading.
pub(super) fn instrument(b: &mut Brush<'_>, letters: &str, reading: i32) {
    b.circle([25, 25], 23, "body");
    b.line([2, 25], [48, 25], "thin");
    b.text([25, 20], "tag mid", letters);
    b.live("reading")
        .text([25, 38], "small", reading.to_string());
    b.name([25, 64]);
}
