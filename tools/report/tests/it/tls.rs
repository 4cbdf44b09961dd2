//! An encrypted connection, and one that is cut.

use crate::broker::{Broker, Listener};
use crate::site::{Reporting, site};
use std::io::copy;
use std::net::{Shutdown, TcpListener, TcpStream};
use std::thread;

/// A way to this port of this PC, and what cuts it.
pub fn cut(port: u16) -> (impl FnOnce(), String) {
    let listener = TcpListener::bind("127.0.0.1:0").unwrap();
    let through = listener.local_addr().unwrap().to_string();
    let (send, cuts) = std::sync::mpsc::channel();
    thread::spawn(move || {
        // One connection passes; those after it find nobody.
        let (near, _) = listener.accept().unwrap();
        drop(listener);
        let far = TcpStream::connect(("127.0.0.1", port)).unwrap();
        send.send(far.try_clone().unwrap()).unwrap();
        let (mut from, mut to) = (near.try_clone().unwrap(), far.try_clone().unwrap());
        thread::spawn(move || copy(&mut from, &mut to));
        let (mut from, mut to) = (far, near);
        let _ = copy(&mut from, &mut to);
    });
    let cut = move || {
        let far: TcpStream = cuts.recv().unwrap();
        far.shutdown(Shutdown::Both).unwrap();
    };
    (cut, through)
}

#[test]
fn an_encrypted_broker_is_trusted_by_its_certificate() {
    let signed = rcgen::generate_simple_self_signed(vec!["localhost".to_owned()]).unwrap();
    let (certificate, key) = (signed.cert.pem(), signed.signing_key.serialize_pem());
    let broker = Broker::of(
        "allow_anonymous true\ncertfile {}/cert.pem\nkeyfile {}/key.pem\n",
        &[("cert.pem", &certificate), ("key.pem", &key)],
    );
    let url = format!("mqtts://localhost:{}", broker.port);
    let more = "ca = \"ca.pem\"\n";
    let reporting = Reporting::new(&site(&url, more), Some(certificate.as_bytes()), Ok(()));
    reporting.until(|state| state.connected == 1);
    assert_eq!(reporting.told.recv().unwrap(), None);
    let other = rcgen::generate_simple_self_signed(vec!["localhost".to_owned()]).unwrap();
    let reporting = Reporting::new(&site(&url, more), Some(other.cert.pem().as_bytes()), Ok(()));
    let told = reporting.told.recv().unwrap().unwrap();
    assert!(told.starts_with("Tls("), "{told}");
    // The same certificate under another name.
    let url = format!("mqtts://127.0.0.1:{}", broker.port);
    let reporting = Reporting::new(&site(&url, more), Some(certificate.as_bytes()), Ok(()));
    let told = reporting.told.recv().unwrap().unwrap();
    assert!(told.starts_with("Tls("), "{told}");
}

#[test]
fn a_broker_that_refuses_is_told_once_and_tried_again() {
    let mut broker = Broker::of("allow_anonymous false\n", &[]);
    let url = format!("mqtt://127.0.0.1:{}", broker.port);
    let more = "user = \"gateway\"\npassword = \"wrong\"\n";
    let reporting = Reporting::new(&site(&url, more), None, Ok(()));
    assert_eq!(
        reporting.told.recv().unwrap().as_deref(),
        Some("NotAllowed")
    );
    broker.kill();
    let broker_again = Broker::at(broker.port, "allow_anonymous true\n");
    assert_eq!(reporting.told.recv().unwrap(), None);
    let listener = Listener::new(&broker_again, "unoclp/$status");
    assert_eq!(listener.next().text(), "online");
}
