//! The certificate with which the page of a site is served.
//!
//! Owns where it is kept, and the words for what is wrong with it. Must not know how a connection is encrypted.

use crate::messages;
use crate::site_file::beside;
use anyhow::anyhow;
use std::io::Write;
use std::path::Path;
use unoclp_program::shown;
use unoclp_serve::{Identity, Tls, Unfit};
use unoclp_site::{Encryption, Site};

/// How the connections of a site are encrypted, if they are.
///
/// # Errors
/// Where the certificate cannot be used, or kept.
pub fn tls(file: &Path, site: &Site) -> anyhow::Result<Option<Tls>> {
    let (certificate, key) = match &site.http.tls {
        Encryption::None => return Ok(None),
        Encryption::Files { cert, key } => (beside(file, cert), beside(file, key)),
        Encryption::SelfSigned => {
            // The same after each restart: who has trusted it goes on.
            let paths = ["cert.pem", "key.pem"].map(|end| file.with_extension(end));
            if !paths.iter().all(|path| path.exists()) {
                make(site, &paths)?;
            }
            let [certificate, key] = paths;
            (certificate, key)
        }
    };
    let read = |path: &Path| {
        let wrong = |why| anyhow!(messages::cannot_read(shown(path), messages::io(&why)));
        std::fs::read_to_string(path).map_err(wrong)
    };
    let identity = Identity {
        certificate: read(&certificate)?,
        key: read(&key)?,
    };
    let tls = Tls::new(&identity).map_err(|why| match why {
        Unfit::NoCertificate => anyhow!(messages::cert_none(shown(&certificate))),
        Unfit::NoKey => anyhow!(messages::key_none(shown(&key))),
        Unfit::Refused(why) => anyhow!(messages::cert_refused(
            shown(&certificate),
            shown(&key),
            why
        )),
    })?;
    Ok(Some(tls))
}

fn make(site: &Site, [certificate, key]: &[std::path::PathBuf; 2]) -> anyhow::Result<()> {
    let mut names = vec!["localhost".to_owned(), "127.0.0.1".to_owned()];
    let address = site.http.listen.ip();
    if !address.is_unspecified() {
        names.push(address.to_string());
    }
    #[cfg(unix)]
    names.extend(
        rustix::system::uname()
            .nodename()
            .to_str()
            .ok()
            .map(str::to_owned),
    );
    let made = Identity::self_signed(names).map_err(|why| anyhow!("{why:?}"))?;
    write(certificate, &made.certificate)?;
    write(key, &made.key)
}

/// Writes a file that nobody else may read.
fn write(path: &Path, text: &str) -> anyhow::Result<()> {
    let wrong = |why| anyhow!(messages::cannot_write(shown(path), messages::io(&why)));
    let mut options = std::fs::OpenOptions::new();
    options.write(true).create(true).truncate(true);
    #[cfg(unix)]
    std::os::unix::fs::OpenOptionsExt::mode(&mut options, 0o600);
    let mut file = options.open(path).map_err(wrong)?;
    file.write_all(text.as_bytes()).map_err(wrong)
}
