//! The animation of README shows what the firmware of now does with the machine: it says in a comment which pictures it
//! has, and the firmware makes them again.

use crate::common;
use std::fs;
use std::path::Path;
use unoclp_cli::film::every;

#[path = "../../examples/film/pictures.rs"]
mod pictures;

/// As long as the command in `examples/film/main.rs` says, ms.
const SPAN: u64 = 12_000;

#[test]
fn the_moving_picture_of_readme_is_what_the_firmware_does() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let gif = fs::read(root.join("docs/machine.gif")).unwrap();
    assert!(gif.len() <= 1_500_000, "{} bytes", gif.len());
    let file = |name: &str| root.join(name).to_str().unwrap().to_owned();
    let (program, machine) = (
        file("programs/plants/filling.st"),
        file("programs/plants/filling.toml"),
    );
    let seen =
        pictures::pictures(common::firmware(), &program, &machine, SPAN, every(SPAN)).unwrap();
    let mark = pictures::mark(&seen);
    assert!(seen.len() > 100, "{mark}");
    let has = gif.windows(mark.len()).any(|part| part == mark.as_bytes());
    assert!(
        has,
        "it is another one now ({mark}); the command in examples/film/main.rs makes it"
    );
}
