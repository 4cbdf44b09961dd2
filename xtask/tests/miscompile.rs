//! The check for products against the compiler itself: `fixtures/lost-product` loses one when it is compiled
//! with LLVM's defaults, and has none of the compiler's with the flags of the project. It needs the AVR tools:
//! `cargo xtask test` runs it.

use std::fs;

use xtask::mulcheck::{self, Report};
use xtask::{shell, toolchain::Toolchain};

/// The flags of `.cargo/config.toml` without the remedy.
const WITHOUT: [&str; 5] = [
    "-Clinker=avr-gcc",
    "-Ctarget-cpu=atmega328p",
    "-Zunstable-options",
    "-Cpanic=immediate-abort",
    "-Cjump-tables=no",
];

/// `mul` in `firmware/src/runtime.s`, which is linked to the fixture; the compiler makes none.
const PRODUCTS: usize = 4;

fn build(target: &str, flags: Option<&[&str]>) -> Report {
    let toolchain = Toolchain::find().expect("a Rust that compiles for AVR");
    let fixture = shell::root().join("xtask/fixtures/lost-product/Cargo.toml");
    let target = shell::root().join(target);
    let mut cargo = toolchain.cargo("build");
    cargo.arg("--manifest-path").arg(fixture);
    cargo
        .arg("--profile=firmware")
        .arg("--target-dir")
        .arg(&target);
    if let Some(flags) = flags {
        // In place of those that cargo finds in .cargo/config.toml.
        cargo.env("CARGO_ENCODED_RUSTFLAGS", flags.join("\x1f"));
    }
    shell::run(&mut cargo).expect("the fixture compiles");
    let elf = fs::read(target.join("avr-none/firmware/lost-product.elf")).expect("an ELF");
    mulcheck::check(&elf).expect("an ELF that can be checked")
}

#[test]
fn a_product_of_the_compiler_is_found() {
    let report = build("target/avr-fixture/without", Some(&WITHOUT));
    let functions: Vec<&str> = report.foreign.iter().map(|(_, name)| &**name).collect();
    assert_eq!(functions, ["case"], "{report}");
}

#[test]
fn with_the_flags_of_the_project_all_products_are_written_by_hand() {
    let report = build("target/avr-fixture/with", None);
    assert_eq!(report.products, PRODUCTS, "{report}");
    assert_eq!(report.foreign, [], "{report}");
}
