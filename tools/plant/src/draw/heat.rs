//! The symbols of what warms and cools.

use super::brush::Brush;
use super::fluid::instrument;
use super::picture::Value;
use crate::parts::heat::{fan, heater, oven, thermometer};
use crate::unit::Unit;

pub(crate) fn oven(b: &mut Brush<'_>) {
    let temperature = b.get(oven::V::temperature);
    let share = (temperature / 3000).clamp(0, 100);
    b.rect([0, 0, 140, 112], 8, "dark");
    b.rect([12, 12, 116, 74], 4, "cool");
    let glow = [
        ("class", "heat".into()),
        ("opacity", Value::Hundredths(share.min(99))),
    ];
    b.live("glow")
        .group(&glow, |b| b.rect([12, 12, 116, 74], 4, ""));
    let shown = Unit::MilliC.shown(i64::from(temperature / 100 * 100));
    b.live("temperature").text([70, 54], "title mid", shown);
    b.rect([40, 94, 60, 8], 4, "metal");
    let burnt = b.is(oven::V::burnt);
    b.live("burnt").shown(burnt, |b| {
        b.path("M12 12L128 86M128 12L12 86", "hot");
    });
    b.name([70, 130]);
}

pub(crate) fn heater(b: &mut Brush<'_>) {
    let power = b.get(heater::V::power);
    b.live("coil").path(
        "M4 24H14L20 10L30 38L40 10L50 38L60 10L66 24H76",
        if power > 0 { "hot" } else { "ink" },
    );
    b.live("power")
        .text([40, 50], "small", format!("{}%", power / 10));
    b.name([40, 64]);
}

pub(crate) fn fan(b: &mut Brush<'_>) {
    let (runs, angle) = (b.is(fan::V::runs), b.get(fan::V::angle));
    b.live("rim")
        .circle([30, 30], 28, if runs { "green-on glow" } else { "body" });
    b.circle([30, 30], 28, "ink");
    b.live("blades").turned(angle, [30, 30], |b| {
        b.path("M30 30C22 20 26 8 34 6C40 12 36 22 30 30C40 22 52 26 54 34C48 40 38 36 30 30C38 40 34 52 26 54C20 48 24 38 30 30C20 38 8 34 6 26C12 20 22 24 30 30", "steel");
    });
    b.name([30, 74]);
}

pub(crate) fn thermometer(b: &mut Brush<'_>) {
    let reading = b.get(thermometer::V::reading);
    instrument(b, "TT", reading);
}
