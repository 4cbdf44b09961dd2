//! The symbols of what carries things. A belt is drawn as long as its symbol, whatever its length.

use super::brush::{Brush, display};
use super::panel::digits;
use super::picture::Value;
use crate::parts::transport::{
    BOTTLE, METAL, MOST, TALL, belt, bin, counter, eye, feeder, filler, height, inductive, pusher,
};

pub(crate) fn belt(b: &mut Brush<'_>) {
    let way = b.get(belt::V::way);
    b.rect([0, 50, 320, 22], 11, "dark");
    let long = b.given(belt::F::long).max(1);
    for (twin, x) in [11, 85, 160, 235, 309].into_iter().enumerate() {
        b.twin = twin;
        b.circle([x, 61], 8, "metal");
        b.live("roller")
            .turned(way * 3 % 360, [x, 61], |b| b.line([x, 55], [x, 67], "thin"));
    }
    for at in 0..MOST {
        b.twin = at + 1;
        let (nature, fill) = (b.row(belt::V::nature, at), b.row(belt::V::fill, at));
        let x = (i64::from(b.row(belt::V::place, at)) * 320 / (i64::from(long) * 1000)) as i32;
        let moved = [("transform", Value::Moved(x, 50)), display(nature != 0)];
        b.live("thing").group(&moved, |b| {
            let bottle = nature & BOTTLE != 0;
            let class = match (bottle, nature & METAL != 0) {
                (true, _) => "bottle",
                (_, true) => "steel",
                (_, false) => "plastic",
            };
            let way = match (bottle, nature & TALL != 0) {
                (true, _) => "M-4 -42V-34C-12 -30 -12 -26 -12 0H12C12 -26 12 -30 4 -34V-42Z",
                (_, true) => "M-13 0V-36H13V0Z",
                (_, false) => "M-13 0V-22H13V0Z",
            };
            b.live("shape").path(way, class);
            let tall = if bottle {
                fill.min(1000) * 28 / 1000
            } else {
                0
            };
            b.live("fill").rect([-10, -tall - 1, 20, tall], 2, "water");
        });
    }
    b.twin = 0;
    b.rect([30, 72, 8, 18], 0, "metal");
    b.rect([282, 72, 8, 18], 0, "metal");
    let jammed = b.is(belt::V::jammed);
    b.live("jammed")
        .shown(jammed, |b| b.text([300, 20], "warn", "!"));
    b.name([160, 92]);
}

pub(crate) fn feeder(b: &mut Brush<'_>) {
    b.path("M4 4H86L58 56H32Z", "metal");
    b.rect([30, 56, 30, 8], 1, "dark");
    let left = b.given(feeder::F::most) - b.get(feeder::V::made);
    b.live("left").shown(left > 0, |b| {
        b.rect([24, 12, 16, 14], 1, "plastic");
        b.rect([46, 14, 16, 14], 1, "steel");
        b.rect([36, 32, 16, 14], 1, "plastic");
    });
    b.name([45, -6]);
}

fn sensor(b: &mut Brush<'_>, sees: bool, letters: &str) {
    b.rect([8, 0, 24, 34], 4, "dark");
    b.live("lens")
        .circle([20, 12], 6, if sees { "red-on" } else { "red-off" });
    b.text([20, 30], "small", letters);
    b.live("beam")
        .path("M20 34V66", if sees { "hot" } else { "dash" });
    b.name([20, -6]);
}

pub(crate) fn eye(b: &mut Brush<'_>) {
    let sees = b.is(eye::V::sees);
    sensor(b, sees, "");
}

pub(crate) fn inductive(b: &mut Brush<'_>) {
    let sees = b.is(inductive::V::sees);
    sensor(b, sees, "");
    b.path("M12 24c2 -6 4 -6 5 0c1 -6 4 -6 5 0c1 -6 4 -6 5 0", "shine");
}

pub(crate) fn height(b: &mut Brush<'_>) {
    let sees = b.is(height::V::sees);
    sensor(b, sees, "");
    b.path("M20 19V29M16 25l4 4l4 -4", "shine");
}

pub(crate) fn pusher(b: &mut Brush<'_>) {
    let out = b.get(pusher::V::position) * 44 / 1000;
    b.rect([16, 0, 28, 50], 4, "metal");
    b.live("rod")
        .group(&[("transform", Value::Moved(0, out))], |b| {
            b.rect([27, 44, 6, 20], 0, "steel");
            b.rect([10, 60, 40, 8], 2, "dark");
        });
    let hits = b.is(pusher::V::hits);
    b.live("hits")
        .shown(hits, |b| b.text([30, 92], "warn", "!"));
    b.name([30, -6]);
}

pub(crate) fn filler(b: &mut Brush<'_>) {
    b.rect([4, 0, 62, 44], 6, "water");
    b.rect([4, 0, 62, 44], 6, "ink");
    b.path("M22 44H48L40 60H30Z", "metal");
    let (pours, spills) = (b.is(filler::V::pours), b.is(filler::V::spills));
    b.live("stream")
        .rect([32, 60, 6, if pours { 40 } else { 0 }], 0, "water");
    b.live("spill")
        .shown(spills, |b| b.ellipse([35, 104], [26, 5], "water"));
    b.name([35, -6]);
}

pub(crate) fn bin(b: &mut Brush<'_>) {
    b.path("M4 6L14 74H96L106 6", "metal");
    let count = b.get(bin::V::count).to_string();
    b.live("count").text([55, 48], "title mid", count);
    let wrong = b.get(bin::V::wrong);
    b.live("wrong")
        .shown(wrong > 0, |b| b.text([96, 4], "warn", "!"));
    b.name([55, 92]);
}

pub(crate) fn counter(b: &mut Brush<'_>) {
    let count = b.get(counter::V::count);
    digits(b, count);
}
