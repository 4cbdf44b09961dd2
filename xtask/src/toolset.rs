//! What turns the source into a firmware, and the pinned set of it: `firmware/tools.toml`.
//!
//! Another tool set makes another firmware, and the suite has run on that of the pinned one alone.

use std::collections::BTreeMap;
use std::fmt;
use std::fs;
use std::path::PathBuf;
use std::process::{Command, Stdio};

use anyhow::{Context, Result};
use serde::{Deserialize, Serialize};

use crate::shell;

/// What stands above the pinned set.
const ABOVE: &str = "\
# What builds the tested firmware. Another tool set builds another firmware, which the suite has not run on: `cargo xtask
# firmware` calls it untested, and a test fails. `cargo xtask firmware --keep` writes this file. `tools` has the
# version that each tool reports; `debian` has the versions of the Debian packages that `cargo xtask setup` asks for.

";

/// rustc, and what assembles and links, each as it says that it is.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Tools {
    rustc: String,
    avr_gcc: String,
    avr_as: String,
    avr_libc: String,
}

/// What is pinned.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Pinned {
    /// The tools of the tested firmware.
    pub tools: Tools,
    /// The versions of Debian's packages that they come in.
    pub debian: BTreeMap<String, String>,
}

impl Pinned {
    /// That of the repository.
    ///
    /// # Errors
    /// If the file is not there, or is not one.
    pub fn read() -> Result<Pinned> {
        let path = path();
        let text = fs::read_to_string(&path);
        let text = text.with_context(|| format!("cannot read {}", path.display()))?;
        toml::from_str(&text).with_context(|| format!("{} is wrong", path.display()))
    }

    /// Whether this is what its rustc says that it is.
    pub fn has_rustc(&self, version: &str) -> bool {
        self.tools.rustc == version
    }
}

fn path() -> PathBuf {
    shell::root().join("firmware/tools.toml")
}

impl Tools {
    /// This rustc, and what this machine has beside it.
    ///
    /// # Errors
    /// If one does not say what it is.
    pub fn with(rustc: String) -> Result<Tools> {
        Ok(Tools {
            rustc,
            avr_gcc: first_line("avr-gcc")?,
            avr_as: first_line("avr-as")?,
            avr_libc: avr_libc()?,
        })
    }

    /// Those that have built `target/firmware`.
    ///
    /// # Errors
    /// If nothing was built.
    pub fn of_build() -> Result<Tools> {
        let text = fs::read_to_string(noted()).context("`cargo xtask firmware` notes it")?;
        toml::from_str(&text).with_context(|| format!("{} is wrong", noted().display()))
    }

    /// Notes that they have built `target/firmware`.
    ///
    /// # Errors
    /// If that is not possible.
    pub fn note(&self) -> Result<()> {
        let path = noted();
        let text = toml::to_string(self)?;
        fs::write(&path, text).with_context(|| format!("cannot write {}", path.display()))
    }

    /// Pins them, with the packages that this machine has them from.
    ///
    /// # Errors
    /// If the file cannot be read or written.
    pub fn pin(&self) -> Result<()> {
        let mut debian = Pinned::read()?.debian;
        for (package, version) in &mut debian {
            if let Some(installed) = installed(package) {
                *version = installed;
            }
        }
        let tools = self.clone();
        let text = toml::to_string(&Pinned { tools, debian })?;
        let path = path();
        fs::write(&path, format!("{ABOVE}{text}"))
            .with_context(|| format!("cannot write {}", path.display()))
    }

    /// Where others differ from these: a line for each tool.
    pub fn difference(&self, others: &Tools) -> String {
        let pairs = self.named().into_iter().zip(others.named());
        let unlike = pairs.filter(|(own, other)| own != other);
        unlike
            .map(|((name, own), (_, other))| {
                format!("  {name}: \"{other}\" in place of \"{own}\"\n")
            })
            .collect()
    }

    fn named(&self) -> [(&'static str, &str); 4] {
        [
            ("rustc", &self.rustc),
            ("avr-gcc", &self.avr_gcc),
            ("avr-as", &self.avr_as),
            ("avr-libc", &self.avr_libc),
        ]
    }
}

impl fmt::Display for Tools {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let named = self.named().map(|(_, version)| version);
        f.write_str(&named.join("; "))
    }
}

/// The version of an installed package of Debian's.
pub fn installed(package: &str) -> Option<String> {
    const STATUS: &str = "${db:Status-Status} ${Version}";
    let status = shell::output(Command::new("dpkg-query").args(["-W", "-f", STATUS, package]))?;
    status.strip_prefix("installed ").map(str::to_owned)
}

fn first_line(program: &str) -> Result<String> {
    let text = shell::output(Command::new(program).arg("--version"));
    let text = text.with_context(|| format!("{program} is not installed, or not in PATH"))?;
    Ok(text.lines().next().unwrap_or_default().to_owned())
}

/// `2.0.0`
fn avr_libc() -> Result<String> {
    const NAME: &str = "__AVR_LIBC_VERSION_STRING__";
    let mut gcc = Command::new("avr-gcc");
    gcc.args(["-E", "-dM", "-include", "avr/version.h", "-xc", "-"]);
    let text = shell::output(gcc.stdin(Stdio::null()));
    let version = text.as_deref().and_then(|text| {
        let line = text.lines().find(|line| line.contains(NAME))?;
        line.split('"').nth(1)
    });
    let version = version.context("avr-libc does not state its version")?;
    Ok(version.to_owned())
}

/// Where the tools of the last build are noted.
fn noted() -> PathBuf {
    shell::root().join("target/firmware/tools.toml")
}

#[cfg(test)]
mod tests {
    use super::{Pinned, Tools};

    #[test]
    fn the_difference_names_each_tool_that_is_another() {
        let pinned = Pinned::read().unwrap().tools;
        assert_eq!(pinned.difference(&pinned), "");
        let other = Tools {
            rustc: "rustc 1.97.0".to_owned(),
            ..pinned.clone()
        };
        let told = pinned.difference(&other);
        let expected = format!(
            "  rustc: \"rustc 1.97.0\" in place of \"{}\"\n",
            pinned.rustc
        );
        assert_eq!(told, expected);
    }
}
