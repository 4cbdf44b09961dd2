//! A tap on the way from a gateway to a broker: it notes which messages the broker has confirmed, whatever becomes of it then.

use std::io::{Read, Write};
use std::net::{Shutdown, TcpListener, TcpStream};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;

/// Packets of MQTT 3.1.1, by the upper half of their first byte.
const PUBLISH: u8 = 3;
const PUBACK: u8 = 4;

/// A message that a broker has confirmed: its topic and its payload.
pub type Confirmed = (String, Vec<u8>);

/// A tap. It passes on until the process ends.
pub struct Tap {
    /// Where the gateway finds it.
    pub port: u16,
    confirmed: Arc<Mutex<Vec<Confirmed>>>,
}

impl Tap {
    /// One on the way to the broker at this port, which need not be there.
    ///
    /// # Errors
    /// Where the system has no port.
    pub fn new(broker: u16) -> std::io::Result<Tap> {
        let listener = TcpListener::bind("127.0.0.1:0")?;
        let port = listener.local_addr()?.port();
        let confirmed = Arc::<Mutex<Vec<Confirmed>>>::default();
        let noted = confirmed.clone();
        thread::spawn(move || {
            for gateway in listener.incoming().flatten() {
                let noted = noted.clone();
                // Without a broker the connection ends, as it would there.
                if let Ok(broker) = TcpStream::connect(("127.0.0.1", broker)) {
                    thread::spawn(move || pass(&gateway, &broker, &noted));
                }
            }
        });
        Ok(Tap { port, confirmed })
    }

    /// What a broker has confirmed, in that order.
    pub fn confirmed(&self) -> Vec<Confirmed> {
        let confirmed = self.confirmed.lock();
        confirmed.unwrap_or_else(PoisonError::into_inner).clone()
    }
}

/// Passes both ways, until one of them ends.
fn pass(gateway: &TcpStream, broker: &TcpStream, noted: &Arc<Mutex<Vec<Confirmed>>>) {
    /// The number of a message, and the message.
    type OnItsWay = Mutex<Vec<(u16, Confirmed)>>;
    let under_way = OnItsWay::default();
    thread::scope(|scope| {
        scope.spawn(|| {
            relay(gateway, broker, |head, body| {
                // Those that need no confirming are none of ours.
                if head >> 4 == PUBLISH
                    && head & 0b110 != 0
                    && let Some(message) = message(body)
                {
                    let under_way = under_way.lock();
                    under_way
                        .unwrap_or_else(PoisonError::into_inner)
                        .push(message);
                }
            });
        });
        relay(broker, gateway, |head, body| {
            let number = body.first_chunk::<2>().copied().map(u16::from_be_bytes);
            if head >> 4 != PUBACK {
                return;
            }
            let mut under_way = under_way.lock().unwrap_or_else(PoisonError::into_inner);
            let at = under_way.iter().position(|(of, _)| Some(*of) == number);
            if let Some(at) = at {
                let (_, message) = under_way.remove(at);
                let noted = noted.lock();
                noted.unwrap_or_else(PoisonError::into_inner).push(message);
            }
        });
    });
}

/// Passes one way, packet by packet, after each was looked at.
fn relay(mut from: &TcpStream, mut to: &TcpStream, mut look: impl FnMut(u8, &[u8])) {
    while let Some((packet, begin)) = packet(&mut from) {
        let head = packet.first().copied().unwrap_or_default();
        look(head, packet.get(begin..).unwrap_or_default());
        if to.write_all(&packet).is_err() {
            break;
        }
    }
    // Whoever has ended it already needs no more.
    let _ = from.shutdown(Shutdown::Both);
    let _ = to.shutdown(Shutdown::Both);
}

/// The next packet, and where its body begins.
fn packet(from: &mut &TcpStream) -> Option<(Vec<u8>, usize)> {
    let mut packet = vec![byte(from)?];
    let mut length = 0_usize;
    for shift in [0, 7, 14, 21] {
        let part = byte(from)?;
        packet.push(part);
        length |= usize::from(part & 0x7F) << shift;
        if part & 0x80 == 0 {
            break;
        }
    }
    let begin = packet.len();
    packet.resize(begin + length, 0);
    from.read_exact(packet.get_mut(begin..)?).ok()?;
    Some((packet, begin))
}

fn byte(from: &mut &TcpStream) -> Option<u8> {
    let mut byte = [0];
    from.read_exact(&mut byte).ok()?;
    byte.first().copied()
}

/// A message that is to be confirmed, and its number.
fn message(body: &[u8]) -> Option<(u16, Confirmed)> {
    let (length, rest) = body.split_first_chunk::<2>()?;
    let (topic, rest) = rest.split_at_checked(u16::from_be_bytes(*length).into())?;
    let (number, payload) = rest.split_first_chunk::<2>()?;
    let topic = String::from_utf8_lossy(topic).into_owned();
    Some((u16::from_be_bytes(*number), (topic, payload.to_vec())))
}
