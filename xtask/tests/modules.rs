//! Data goes one way: no circle of modules.

use xtask::modules::circles;
use xtask::shell;

fn has_no_circle(root: &str) {
    let circles = circles(&shell::root().join(root)).expect("the crate can be read");
    let shown: Vec<_> = circles.iter().map(ToString::to_string).collect();
    assert!(shown.is_empty(), "{root}: {}", shown.join("\n"));
}

#[test]
fn the_firmware_has_no_circle_of_modules() {
    has_no_circle("firmware/src/main.rs");
}

#[test]
fn the_core_has_no_circle_of_modules() {
    has_no_circle("core/src/lib.rs");
}

#[test]
fn the_protocol_has_no_circle_of_modules() {
    has_no_circle("modbus/src/lib.rs");
}
