//! Whom an encrypted connection trusts.

use crate::shared::Unready;
use rustls::crypto::ring;
use rustls::pki_types::CertificateDer;
use rustls::pki_types::pem::PemObject;
use rustls::{ClientConfig, RootCertStore};
use std::sync::Arc;

/// Trusts what these certificates in PEM sign; without them, what the system trusts.
pub(crate) fn client(ca: Option<&[u8]>) -> Result<Arc<ClientConfig>, Unready> {
    let mut roots = RootCertStore::empty();
    match ca {
        None => {
            let found = rustls_native_certs::load_native_certs();
            let (added, _) = roots.add_parsable_certificates(found.certs);
            if added == 0 {
                return Err(Unready::NoTrust);
            }
        }
        Some(pem) => {
            for certificate in CertificateDer::pem_slice_iter(pem) {
                let certificate = certificate.map_err(|_| Unready::NoCertificate)?;
                roots.add(certificate).map_err(|_| Unready::NoCertificate)?;
            }
            if roots.is_empty() {
                return Err(Unready::NoCertificate);
            }
        }
    }
    let builder = ClientConfig::builder_with_provider(Arc::new(ring::default_provider()))
        .with_safe_default_protocol_versions()
        .map_err(|_| Unready::NoTrust)?;
    Ok(Arc::new(
        builder.with_root_certificates(roots).with_no_client_auth(),
    ))
}
