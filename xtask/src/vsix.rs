//! `cargo xtask vsix`: the extension for Visual Studio Code, `target/unoclp.vsix`, which starts `unoclp lsp`.

use std::path::PathBuf;
use std::process::Command;

use anyhow::{Result, ensure};

use crate::node::NPM;
use crate::shell::{self, root, say};

/// Where its sources are.
const ROOM: &str = "page/vscode";
/// What comes of them.
const MADE: &str = "target/unoclp.vsix";

/// Installs the packages that its lock file names, bundles and packs it.
///
/// # Errors
/// If npm or the packer fails.
pub fn make() -> Result<PathBuf> {
    let npm = |arguments: &[&str]| {
        let mut npm = Command::new(NPM);
        npm.current_dir(root().join(ROOM)).args(arguments);
        shell::run(&mut npm)
    };
    npm(&["ci", "--ignore-scripts", "--no-audit", "--no-fund"])?;
    npm(&["run", "--silent", "package"])?;
    let made = root().join(MADE);
    ensure!(made.is_file(), "{MADE} was not built");
    Ok(made)
}

/// The command.
///
/// # Errors
/// As [`make`].
pub fn run() -> Result<()> {
    make()?;
    say(&format!("{MADE}: code --install-extension {MADE}"));
    Ok(())
}
