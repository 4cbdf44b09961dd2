//! `unoclp flash`: what is refused before a board is touched. What it does to a board is in `tools/boot/` and `proof/uno-sim/`.

use crate::common::{empty_folder, outcome_in};
use std::fs;
use std::path::Path;

const NO_PORT: &[&str] = &["--port", "/dev/no-such-port"];

/// The hex of this board in the repository.
fn firmware(board: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../firmware");
    let path = folder.join(format!("unoclp-{board}.hex"));
    path.to_str().unwrap().to_owned()
}

fn said(arguments: &[&str], language: &str) -> (i32, String) {
    let all = [&["flash"], arguments, NO_PORT].concat();
    let (code, out, err) = outcome_in(&all, language);
    assert_eq!(out, "");
    (code, err)
}

#[test]
fn a_file_that_is_no_firmware_for_the_board_is_refused() {
    let folder = empty_folder("flash");
    let good = fs::read_to_string(firmware("uno")).unwrap();
    let put = |name: &str, text: &str| {
        let path = folder.join(name);
        fs::write(&path, text).unwrap();
        path.to_str().unwrap().to_owned()
    };
    let program = put("program.txt", "0\n827301\n");
    let changed = put("changed.hex", &good.replacen("0C", "0D", 1));
    let cut = put("cut.hex", &good[..good.len() - 13]);
    let other = put("other.hex", ":0400000011241FBEEA\n:00000001FF\n");
    let (uno, nano) = (firmware("uno"), firmware("nano"));
    let cases: [(&[&str], &str); 6] = [
        (&[&program], "FW-11: line 1 "),
        (&[&changed], "FW-12: line 1 "),
        (&[&cut], "FW-13: "),
        (&[&other], "FW-15: "),
        (&[&uno, "--board", "nano"], "FW-16: the file takes "),
        (&[&uno, "--board", "nano-old"], "FW-16: "),
    ];
    for (arguments, number) in cases {
        let (code, err) = said(arguments, "C.UTF-8");
        assert!(code == 2 && err.contains(number), "{arguments:?}: {err}");
        let (code, err) = said(arguments, "pt_BR.UTF-8");
        let number = number.split(' ').next().unwrap();
        assert!(code == 2 && err.contains(number), "{arguments:?}: {err}");
    }
    // What is right comes as far as to the port; so do the ones that the command carries.
    let right: [&[&str]; 5] = [
        &[&uno],
        &[&nano, "--board", "nano"],
        &[&nano],
        &[],
        &["--board", "nano-old"],
    ];
    for arguments in right {
        let (code, err) = said(arguments, "C.UTF-8");
        assert_eq!(code, 2);
        assert!(err.contains("there is no port /dev/no-such-port"), "{err}");
    }
}

#[test]
fn a_file_that_cannot_be_read_is_named() {
    let (code, err) = said(&["no.hex"], "C.UTF-8");
    assert!(code == 2 && err.contains("no.hex cannot be read"), "{err}");
}
