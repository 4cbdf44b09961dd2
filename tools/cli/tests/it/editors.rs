//! `unoclp lsp`: an editor is helped.

use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};

/// pygls, a client that others have written, asks for everything.
#[test]
fn a_client_of_others_is_answered() {
    let root = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."));
    let client = Command::new(root.join("target/python/bin/python3"))
        .arg(root.join("tools/cli/tests/lsp/client.py"))
        .arg(env!("CARGO_BIN_EXE_unoclp"))
        .output()
        .expect("`cargo xtask setup` brings it");
    let said = String::from_utf8_lossy(&client.stdout);
    let error = String::from_utf8_lossy(&client.stderr);
    assert!(
        client.status.success() && said.ends_with("end\n"),
        "{said}{error}"
    );
}

/// What no editor says, at its standard input.
fn told(input: &str) -> (Option<i32>, String) {
    let mut lsp = Command::new(env!("CARGO_BIN_EXE_unoclp"))
        .args(["lsp", "--lang", "en"])
        .stdin(Stdio::piped())
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut stdin = lsp.stdin.take().unwrap();
    // It may have ended before all is written.
    let _ = stdin.write_all(input.as_bytes());
    drop(stdin);
    let output = lsp.wait_with_output().unwrap();
    (
        output.status.code(),
        String::from_utf8_lossy(&output.stderr).into_owned(),
    )
}

#[test]
fn who_is_no_editor_is_told_so() {
    for input in [
        "",
        "hello\n",
        "Content-Length: 5\r\n\r\n{}{}{",
        "Content-Length: 999999999999\r\n\r\n",
    ] {
        let (code, error) = told(input);
        assert!(
            code == Some(2) && error.contains("docs/editors.md"),
            "{input:?}: {code:?} {error}"
        );
    }
}
