//! Who the server is, where its connections are encrypted.
//!
//! Owns certificates and their keys, as texts in PEM. Must not know where these are kept.

use rustls::ServerConfig;
use rustls::crypto::ring;
use rustls::pki_types::pem::PemObject;
use rustls::pki_types::{CertificateDer, PrivateKeyDer};
use std::fmt::Write;
use std::sync::Arc;
use tokio_rustls::TlsAcceptor;

/// A certificate and its key, both in PEM.
#[derive(Clone)]
pub struct Identity {
    /// The certificate, and those that lead to an authority.
    pub certificate: String,
    /// Its key.
    pub key: String,
}

/// Why nobody can be served with a certificate.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Unfit {
    /// There is no certificate in PEM.
    NoCertificate,
    /// There is no key in PEM.
    NoKey,
    /// They do not belong together, or are of no use.
    Refused(String),
}

/// How connections are encrypted.
#[derive(Clone)]
pub struct Tls {
    pub(crate) acceptor: TlsAcceptor,
    fingerprint: String,
}

impl std::fmt::Debug for Tls {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Tls {}", self.fingerprint)
    }
}

impl Identity {
    /// One that nobody else has signed, for these names.
    ///
    /// # Errors
    /// Where the system has no random numbers, or a name is none.
    pub fn self_signed(names: Vec<String>) -> Result<Identity, Unfit> {
        let signed = rcgen::generate_simple_self_signed(names);
        let signed = signed.map_err(|why| Unfit::Refused(why.to_string()))?;
        Ok(Identity {
            certificate: signed.cert.pem(),
            key: signed.signing_key.serialize_pem(),
        })
    }
}

impl Tls {
    /// That of a certificate and its key.
    ///
    /// # Errors
    /// [`Unfit`].
    pub fn new(identity: &Identity) -> Result<Tls, Unfit> {
        let chain = CertificateDer::pem_slice_iter(identity.certificate.as_bytes());
        let chain: Result<Vec<_>, _> = chain.collect();
        let chain = chain.map_err(|_| Unfit::NoCertificate)?;
        let fingerprint = fingerprint(chain.first().ok_or(Unfit::NoCertificate)?);
        let key = PrivateKeyDer::from_pem_slice(identity.key.as_bytes());
        let key = key.map_err(|_| Unfit::NoKey)?;
        let config = ServerConfig::builder_with_provider(Arc::new(ring::default_provider()))
            .with_safe_default_protocol_versions()
            .and_then(|builder| builder.with_no_client_auth().with_single_cert(chain, key))
            .map_err(|why| Unfit::Refused(why.to_string()))?;
        Ok(Tls {
            acceptor: TlsAcceptor::from(Arc::new(config)),
            fingerprint,
        })
    }

    /// By this a person knows the certificate: SHA-256, as browsers show it.
    pub fn fingerprint(&self) -> &str {
        &self.fingerprint
    }
}

fn fingerprint(certificate: &CertificateDer<'_>) -> String {
    let digest = ::ring::digest::digest(&::ring::digest::SHA256, certificate);
    let mut text = String::new();
    for byte in digest.as_ref() {
        // To a string nothing fails.
        let _ = write!(text, "{}{byte:02X}", if text.is_empty() { "" } else { ":" });
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_certificate_needs_its_own_key() {
        let [one, two] = [(); 2].map(|()| Identity::self_signed(vec!["localhost".into()]).unwrap());
        let fingerprint = Tls::new(&one).unwrap().fingerprint().to_owned();
        assert_eq!(fingerprint.len(), 32 * 3 - 1);
        assert_ne!(Tls::new(&two).unwrap().fingerprint(), fingerprint);
        let with = |certificate: &str, key: &str| {
            let identity = Identity {
                certificate: certificate.into(),
                key: key.into(),
            };
            Tls::new(&identity).unwrap_err()
        };
        assert!(matches!(
            with(&one.certificate, &two.key),
            Unfit::Refused(_)
        ));
        assert_eq!(with("", &one.key), Unfit::NoCertificate);
        assert_eq!(with(&one.key, &one.key), Unfit::NoCertificate);
        assert_eq!(with(&one.certificate, "x"), Unfit::NoKey);
    }
}
