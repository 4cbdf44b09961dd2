//! The Debian package: the program with its service, made by `dpkg-deb`.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result};

use crate::shell::{self, exists, output, root};

/// What stands around the program.
const FROM: &str = "tools/cli/debian";
/// Files that are the same for every machine: where they come from, where they go, and with which rights.
const FILES: [(&str, &str, u32); 4] = [
    (
        "tools/cli/debian/unoclp.service",
        "lib/systemd/system/unoclp.service",
        0o644,
    ),
    (
        "tools/cli/debian/sysusers.conf",
        "usr/lib/sysusers.d/unoclp.conf",
        0o644,
    ),
    ("docs/site.md", "usr/share/doc/unoclp/site.md", 0o644),
    (
        "docs/site.pt-BR.md",
        "usr/share/doc/unoclp/site.pt-BR.md",
        0o644,
    ),
];
/// What runs at installation and removal.
const SCRIPTS: [&str; 3] = ["postinst", "prerm", "postrm"];

/// Whether a package can be made here.
pub fn can_be_made() -> bool {
    exists("dpkg-deb")
}

/// Makes the package of this program in a folder, with these papers for its documentation; gives its file.
///
/// # Errors
/// If a file cannot be read or written, or `dpkg-deb` fails.
pub fn make(program: &Path, papers: &[(String, Vec<u8>)], folder: &Path) -> Result<PathBuf> {
    let tree = folder.join("deb");
    if tree.exists() {
        fs::remove_dir_all(&tree).with_context(|| format!("cannot empty {}", tree.display()))?;
    }
    let bytes =
        |file: &Path| fs::read(file).with_context(|| format!("cannot read {}", file.display()));
    put(&tree.join("usr/bin/unoclp"), &bytes(program)?, 0o755)?;
    for (from, to, rights) in FILES {
        put(&tree.join(to), &bytes(&root().join(from))?, rights)?;
    }
    for (name, bytes) in papers {
        put(&tree.join("usr/share/doc/unoclp").join(name), bytes, 0o644)?;
    }
    for script in SCRIPTS {
        let bytes = bytes(&root().join(FROM).join(script))?;
        put(&tree.join("DEBIAN").join(script), &bytes, 0o755)?;
    }
    let machine = output(Command::new("dpkg").arg("--print-architecture"));
    let machine = machine.context("dpkg does not print its architecture")?;
    put(
        &tree.join("DEBIAN/control"),
        control(&machine).as_bytes(),
        0o644,
    )?;
    let package = folder.join(format!(
        "unoclp_{}_{machine}.deb",
        env!("CARGO_PKG_VERSION")
    ));
    let mut build = Command::new("dpkg-deb");
    build
        .args(["--root-owner-group", "--build"])
        .arg(&tree)
        .arg(&package);
    // The same files make the same package.
    shell::run(
        build
            .env("SOURCE_DATE_EPOCH", "0")
            .stdout(std::process::Stdio::null()),
    )?;
    fs::remove_dir_all(&tree).with_context(|| format!("cannot remove {}", tree.display()))?;
    Ok(package)
}

fn control(machine: &str) -> String {
    // `glibc 2.36`: what the program was linked with, an earlier one need not have.
    let libc = output(Command::new("getconf").arg("GNU_LIBC_VERSION")).unwrap_or_default();
    let libc = libc.strip_prefix("glibc ").unwrap_or("2.36");
    format!(
        "Package: unoclp\n\
         Version: {}\n\
         Architecture: {machine}\n\
         Maintainer: unoclp <unoclp@localhost>\n\
         Section: electronics\n\
         Priority: optional\n\
         Depends: libc6 (>= {libc}), libgcc-s1, systemd\n\
         Suggests: mosquitto, postgresql\n\
         Description: PLC on Arduino boards: programs, boards, and the gateway of a site\n \
         Checks, compiles and simulates programs, uploads them to boards, and shares boards\n \
         in browsers, over Modbus TCP and over MQTT, with a history. The service unoclp starts\n \
         only if /var/lib/unoclp/site.toml exists.\n",
        env!("CARGO_PKG_VERSION")
    )
}

fn put(file: &Path, bytes: &[u8], rights: u32) -> Result<()> {
    shell::make_folder_of(file)?;
    let cannot = || format!("cannot write {}", file.display());
    fs::write(file, bytes).with_context(cannot)?;
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        fs::set_permissions(file, fs::Permissions::from_mode(rights)).with_context(cannot)?;
    }
    let _ = rights;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn told(program: &str, arguments: &[&str], package: &Path) -> String {
        let mut command = Command::new(program);
        command.args(arguments).arg(package);
        output(&mut command).expect("Debian has it")
    }

    #[test]
    fn a_package_has_program_service_and_user_and_is_the_same_each_time() {
        let folder = root().join("target/tmp/deb");
        let program = folder.join("unoclp");
        put(&program, b"#!/bin/sh\necho unoclp\n", 0o755).unwrap();
        let papers = [("copyright".to_owned(), b"MIT OR Apache-2.0\n".to_vec())];
        let package = make(&program, &papers, &folder).unwrap();
        let first = fs::read(&package).unwrap();
        assert_eq!(
            fs::read(make(&program, &papers, &folder).unwrap()).unwrap(),
            first
        );
        let files = told("dpkg-deb", &["--contents"], &package);
        for (rights, file) in [
            ("-rwxr-xr-x root/root", "./usr/bin/unoclp"),
            (
                "-rw-r--r-- root/root",
                "./lib/systemd/system/unoclp.service",
            ),
            ("-rw-r--r-- root/root", "./usr/lib/sysusers.d/unoclp.conf"),
            ("-rw-r--r-- root/root", "./usr/share/doc/unoclp/copyright"),
        ] {
            let is_there = |line: &str| line.starts_with(rights) && line.ends_with(file);
            assert!(files.lines().any(is_there), "{file}\n{files}");
        }
        let about = told("dpkg-deb", &["--info"], &package);
        for line in ["Package: unoclp", "postinst", "Depends: libc6 (>= 2."] {
            assert!(about.contains(line), "{line}\n{about}");
        }
    }

    /// Each line of the unit is a key that systemd knows; it says so itself where it is here.
    #[test]
    fn the_service_is_one_that_systemd_takes() {
        let unit = fs::read_to_string(root().join(FROM).join("unoclp.service")).unwrap();
        for line in unit.lines().filter(|line| !line.is_empty()) {
            let is_right = line.starts_with('#') || line.starts_with('[') || line.contains('=');
            assert!(is_right, "{line}");
        }
        for needed in ["User=unoclp", "NoNewPrivileges=yes", "ProtectSystem=strict"] {
            assert!(unit.lines().any(|line| line == needed), "{needed}");
        }
        if !exists("systemd-analyze") {
            return;
        }
        let folder = root().join("target/tmp/unit");
        // Its program is none that is installed here.
        let here = unit.replace("/usr/bin/unoclp ", "/bin/true ");
        let file = folder.join("unoclp.service");
        put(&file, here.as_bytes(), 0o644).unwrap();
        let verified = Command::new("systemd-analyze")
            .args(["verify", "--man=no"])
            .arg(&file)
            .output()
            .unwrap();
        let said = String::from_utf8_lossy(&verified.stderr);
        let ours: Vec<&str> = said
            .lines()
            .filter(|line| line.contains("unoclp.service"))
            .collect();
        assert_eq!(ours, [""; 0]);
    }

    #[test]
    fn the_scripts_are_right_for_a_shell() {
        for script in SCRIPTS {
            let file = root().join(FROM).join(script);
            let checked = Command::new("sh").arg("-n").arg(file).status().unwrap();
            assert!(checked.success(), "{script}");
        }
    }
}
