//! The work that a text makes grows as the text does, whatever shape it has: counted in allocations and bytes.

#[path = "it/shapes.rs"]
mod shapes;

use shapes::{IL, ISCL, LCE, ST, Shape, TYPED_IL};
use stats_alloc::{INSTRUMENTED_SYSTEM, Region, Stats, StatsAlloc};
use std::alloc::System;
use std::hint::black_box;
use unoclp_core::Board;
use unoclp_lang::{TextLanguage, compile_text};

#[global_allocator]
static COUNTED: &StatsAlloc<System> = &INSTRUMENTED_SYSTEM;

/// Compiles a text.
type Compiler = fn(&str);

fn work(text: &str, compiler: Compiler) -> Stats {
    let region = Region::new(COUNTED);
    compiler(text);
    region.change()
}

fn il(text: &str) {
    black_box(compile_text(
        text,
        TextLanguage::Il,
        unoclp_core::Board::UNO,
    ));
}

fn typed(text: &str, language: TextLanguage) {
    black_box(compile_text(text, language, Board::UNO));
}

/// One test, for what others allocate meanwhile would count too.
#[test]
fn any_text_takes_work_in_proportion_to_its_size() {
    nested_parentheses_take_at_most_64_mb();
    grows_as_the_text(&IL, il);
    grows_as_the_text(&ST, |text| typed(text, TextLanguage::St));
    grows_as_the_text(&ISCL, |text| typed(text, TextLanguage::Iscl));
    grows_as_the_text(&LCE, |text| typed(text, TextLanguage::Lce));
    grows_as_the_text(&TYPED_IL, |text| typed(text, TextLanguage::Il));
}

/// Of the first three shapes, which are what a person would call nested; all the bytes of a run together are more
/// than are ever held at once.
fn nested_parentheses_take_at_most_64_mb() {
    for (shape, text) in &IL[..3] {
        let stats = work(&text(100_000), il);
        assert!(stats.bytes_allocated <= 64 << 20, "{shape}: {stats:?}");
    }
}

/// From 64 KB to 512 KB: eightfold text takes hardly more than eightfold work. Where a list has been given more room
/// once more than its length asks for, the last doubling shows the same.
fn grows_as_the_text(shapes: &[(&str, Shape)], compiler: Compiler) {
    for (shape, text) in shapes {
        let pieces = 1_000 * (64 << 10) / text(1_000).len();
        let works = [1, 4, 8].map(|times| work(&text(times * pieces), compiler));
        for (what, [few, half, many]) in [
            ("allocations", works.map(|work| work.allocations)),
            ("bytes", works.map(|work| work.bytes_allocated)),
        ] {
            let holds = many <= 11 * few || 4 * many <= 11 * half;
            assert!(holds, "{shape}: {what}: {few}, {half}, {many}");
        }
    }
}
