//! The work that a text makes grows as the text does, whatever shape it has: counted in allocations and bytes.

use stats_alloc::{INSTRUMENTED_SYSTEM, Region, Stats, StatsAlloc};
use std::alloc::System;
use std::hint::black_box;
use unoclp_lang::{Options, compile};

#[global_allocator]
static COUNTED: &StatsAlloc<System> = &INSTRUMENTED_SYSTEM;

fn work(text: &str) -> Stats {
    let region = Region::new(COUNTED);
    black_box(compile(text, &Options::default()));
    region.change()
}

/// Writes a text of this size.
type Shape = fn(usize) -> String;

/// Each shape as deep or as long as it is asked for; the first three are what a person would call nested.
const SHAPES: [(&str, Shape); 7] = [
    ("closed parentheses", |n| {
        format!("LD I1\n{}{}ST Q1\n", "AND( I2\n".repeat(n), ")\n".repeat(n))
    }),
    ("explicit parentheses", |n| {
        let open = "OR(\nLD I2\n".repeat(n);
        format!("LD I1\n{open}{}ST Q1\n", ")\n".repeat(n))
    }),
    ("numbers in parentheses", |n| {
        let open = "ADD( D2\n".repeat(n);
        format!("LD D1\n{open}{}ST D1\n", ")\n".repeat(n))
    }),
    ("stores in parentheses", |n| {
        format!("LD I1\n{}", "AND( I2\nST Q1\n".repeat(n))
    }),
    ("open parentheses", |n| {
        format!("LD I1\n{}", "AND( I2\n".repeat(n))
    }),
    ("parentheses on one line", |n| {
        format!("LD I1\nAND{}", "(".repeat(n))
    }),
    ("words that are no operators, with parentheses", |n| {
        "XLD( Z9.9\n".repeat(n)
    }),
];

/// All the bytes of a run together are more than are ever held at once.
fn within_64_mb(text: &str) {
    let stats = work(text);
    assert!(stats.bytes_allocated <= 64 << 20, "{stats:?}");
}

#[test]
fn parentheses_take_work_in_proportion_to_their_number() {
    for (_, text) in &SHAPES[..3] {
        within_64_mb(&text(100_000));
    }
    for (shape, text) in SHAPES {
        let (few, many) = (work(&text(10_000)), work(&text(100_000)));
        for (what, few, many) in [
            ("allocations", few.allocations, many.allocations),
            ("bytes", few.bytes_allocated, many.bytes_allocated),
        ] {
            assert!(many <= 14 * few, "{shape}: {what}: {few}, {many}");
        }
    }
}
