//! What is handed out, as programs read it: a bill of materials in CycloneDX with the crates and npm packages in it, and
//! the SHA-256 sums of the files.
//!
//! Tools such as cargo-cyclonedx see crates alone. `NOTICE` is made from all parts, and so is this.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use serde_json::{Value, json};
use sha2::{Digest, Sha256};

use crate::notice::{Kind, Parts};

/// The bill of materials, CycloneDX 1.5. The same parts make the same bytes: it has no time and no serial number.
pub fn bill(parts: &Parts, version: &str) -> Value {
    let components: Vec<Value> = parts.all().map(component).collect();
    json!({
        "bomFormat": "CycloneDX",
        "specVersion": "1.5",
        "version": 1,
        "metadata": {
            "component": {
                "type": "application",
                "bom-ref": "unoclp",
                "name": "unoclp",
                "version": version,
                "licenses": [{ "expression": "MIT OR Apache-2.0" }],
            },
        },
        "components": components,
        "dependencies": [{
            "ref": "unoclp",
            "dependsOn": parts.all().map(address).collect::<Vec<_>>(),
        }],
    })
}

fn component(part: (Kind, &str, &str, &str)) -> Value {
    let (_, name, version, licence) = part;
    let address = address(part);
    json!({
        "type": "library",
        "bom-ref": address,
        "name": name,
        "version": version,
        "purl": address,
        "licenses": [{ "expression": expression(licence) }],
    })
}

/// A part as registries name it (a package URL).
fn address((kind, name, version, _): (Kind, &str, &str, &str)) -> String {
    let kind = match kind {
        Kind::Crate => "cargo",
        Kind::Package => "npm",
    };
    format!("pkg:{kind}/{}@{version}", name.replace('@', "%40"))
}

/// A licence as SPDX writes it: older crates have a stroke for OR.
fn expression(licence: &str) -> String {
    licence.replace(" / ", "/").replace('/', " OR ")
}

/// Writes the bill and the sums of these files beside them, named so, and says where.
///
/// # Errors
/// If a file cannot be read or written.
pub fn write(parts: &Parts, files: &[PathBuf], name: &str, folder: &Path) -> Result<[PathBuf; 2]> {
    let bill_file = folder.join(format!("{name}.cdx.json"));
    let text = serde_json::to_string_pretty(&bill(parts, env!("CARGO_PKG_VERSION")))?;
    let cannot = |file: &Path| format!("cannot write {}", file.display());
    fs::write(&bill_file, text + "\n").with_context(|| cannot(&bill_file))?;
    let mut sums = String::new();
    for file in files.iter().chain([&bill_file]) {
        let read = fs::read(file);
        let bytes = read.with_context(|| format!("cannot read {}", file.display()))?;
        let name = file.file_name().unwrap_or_default().to_string_lossy();
        sums += &sum(&bytes, &name);
    }
    let sums_file = folder.join(format!("{name}.sha256"));
    fs::write(&sums_file, sums).with_context(|| cannot(&sums_file))?;
    Ok([bill_file, sums_file])
}

/// A line as `sha256sum --check` reads it.
fn sum(bytes: &[u8], name: &str) -> String {
    format!("{:x}  {name}\n", Sha256::digest(bytes))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_part_has_the_address_of_its_registry() {
        let kit = (Kind::Package, "@codemirror/view", "6.1.0", "MIT");
        assert_eq!(address(kit), "pkg:npm/%40codemirror/view@6.1.0");
        let serde = (Kind::Crate, "serde", "1.0.0", "MIT OR Apache-2.0");
        assert_eq!(address(serde), "pkg:cargo/serde@1.0.0");
    }

    #[test]
    fn an_old_licence_is_written_as_spdx_has_it() {
        assert_eq!(expression("MIT/Apache-2.0"), "MIT OR Apache-2.0");
        assert_eq!(expression("Unlicense OR MIT"), "Unlicense OR MIT");
    }

    #[test]
    fn a_sum_is_that_of_sha256sum() {
        let empty = "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855";
        assert_eq!(sum(b"", "unoclp"), format!("{empty}  unoclp\n"));
    }
}
