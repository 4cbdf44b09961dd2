//! The command `unoclp-uno-sim demo`: the first thing that a newcomer sees.

use crate::common::state;
use std::path::Path;
use std::process::Command;
use unoclp_uno_sim::firmware_file;

#[test]
fn the_demonstration_shows_a_scan_of_microseconds() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let image = Path::new(env!("CARGO_TARGET_TMPDIR")).join("demo.img");
    let program = std::fs::read_to_string(root.join("programs/motor.txt")).unwrap();
    std::fs::write(&image, state::image(&program).build().unwrap()).unwrap();
    let demo = Command::new(env!("CARGO_BIN_EXE_unoclp-uno-sim"))
        .args(["demo", "--elf"])
        .arg(firmware_file().unwrap())
        .args([
            "--card".as_ref(),
            image.as_os_str(),
            "--scenario".as_ref(),
            root.join("programs/demo.toml").as_os_str(),
        ])
        .output()
        .unwrap();
    let said = String::from_utf8(demo.stdout).unwrap();
    assert!(demo.status.success(), "{said}");
    assert!(said.contains("Every LED did what was expected"), "{said}");
    let most = said.split("most ").nth(1).expect("the state of the card");
    let most: u32 = most.split_whitespace().next().unwrap().parse().unwrap();
    // As docs/benchmarks.md has it: a small program, and what goes on beside its scans.
    assert!((1..1_000).contains(&most), "{said}");
}
