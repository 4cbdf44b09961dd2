//! The check for wrong code against the compiler itself: it must find the product that is lost in
//! `fixtures/lost-product`, and must find nothing in the same source compiled with the flags of
//! the project. It needs the AVR tools: `cargo xtask test` runs it.

use std::fs;

use xtask::r0check::{self, Origin, Report};
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
    r0check::check(&elf).expect("an ELF that can be checked")
}

#[test]
fn the_lost_product_is_found() {
    let report = build("target/avr-fixture/without", Some(&WITHOUT));
    let [finding] = &report.findings.iter().collect::<Vec<_>>()[..] else {
        panic!("expected one finding: {report}");
    };
    assert_eq!(finding.function, "case", "{report}");
    assert!(
        matches!(finding.origins[..], [Origin::Status(_)]),
        "{report}"
    );
}

#[test]
fn the_project_s_flags_keep_the_product() {
    let report = build("target/avr-fixture/with", None);
    assert_eq!(report.products, PRODUCTS, "{report}");
    assert_eq!(report.findings.len(), 0, "{report}");
}
