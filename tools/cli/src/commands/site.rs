//! `unoclp site`.

use crate::outcome::Outcome;
use clap::Subcommand;
use std::path::{Path, PathBuf};
use unoclp_cli::{messages, site_file};
use unoclp_site::plan;

/// What may be done with a site file.
#[derive(Subcommand)]
pub enum OfSite {
    /// Say what a gateway would do by it, or every mistake with its line
    Check {
        /// The site file (.toml)
        #[arg(value_name = "SITE.toml")]
        site: PathBuf,
    },
}

/// Does it.
pub fn site(of: &OfSite) -> Outcome {
    let OfSite::Check { site } = of;
    check(site)
}

fn check(path: &Path) -> Outcome {
    match site_file::open(path)? {
        Ok(site) => {
            say!("{}", plan(&site, messages::spoken()).trim_end());
            Ok(true)
        }
        Err(mistakes) => {
            for mistake in mistakes {
                say!("{mistake}");
            }
            Ok(false)
        }
    }
}
