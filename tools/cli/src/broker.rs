//! The broker of a site: what it is told, and what it brings to the boards.
//!
//! Owns how reports and boards are wired, and the words for what is wrong. Must not know topics and payloads.

use crate::messages;
use crate::site_file::beside;
use anyhow::anyhow;
use std::path::Path;
use std::sync::Arc;
use unoclp_journal::Journal;
use unoclp_modbus::Exception;
use unoclp_program::shown;
use unoclp_report::{Carry, Command, Refusal, Reporter, Tell, Trouble, Unready, Wish};
use unoclp_serve::{Acknowledgement, NotDone, Order, Ordered, Orders};
use unoclp_site::{Broker, Mqtt, Site};

/// Begins to report a site. What the broker brings comes out at the other end.
///
/// # Errors
/// Where the certificate of the site file cannot be used, or the system refuses.
pub fn begin(
    file: &Path,
    site: &Site,
    mqtt: &Mqtt,
    journal: &Journal,
) -> anyhow::Result<(Arc<Reporter>, Ordered)> {
    let ca = mqtt.ca.as_ref().map(|name| beside(file, name));
    let pem = ca.as_ref().map(|ca| {
        let wrong = |why| anyhow!(messages::cannot_read(shown(ca), messages::io(&why)));
        std::fs::read(ca).map_err(wrong)
    });
    let pem = pem.transpose()?;
    let (orders, ordered) = Orders::new();
    let begun = Reporter::begin(
        site,
        mqtt,
        pem.as_deref(),
        journal,
        carry(orders),
        tell(mqtt.broker.clone()),
    );
    let reporter = begun.map_err(|why| match (why, &ca) {
        (Unready::NoCertificate, Some(ca)) => anyhow!(messages::no_certificate(shown(ca))),
        (Unready::NoCertificate | Unready::NoTrust, _) => anyhow!(messages::no_trust()),
        (Unready::System(why), _) => anyhow!(messages::io(&why)),
    })?;
    Ok((Arc::new(reporter), ordered))
}

fn carry(orders: Orders) -> Carry {
    Arc::new(move |wish, done| match wish {
        Wish::Set(Command { grant, value, .. }) => orders.send(Order {
            grant,
            value,
            done: Box::new(move |result| done(result.map_err(refusal))),
        }),
        Wish::Acknowledge(alarm) => orders.acknowledge(Acknowledgement {
            alarm,
            done: Box::new(move |result| done(result.map_err(not_acknowledged))),
        }),
    })
}

/// Why an alarm is not acknowledged, as a broker is told.
fn not_acknowledged(why: NotDone) -> Refusal {
    match why {
        NotDone::NoAlarm => Refusal::NoAlarm,
        NotDone::Nothing => Refusal::Nothing,
        NotDone::Ended => Refusal::Ending,
    }
}

/// The exception of a gateway or a board, as a broker is told.
fn refusal(exception: Exception) -> Refusal {
    match exception {
        Exception::IllegalFunction | Exception::IllegalDataAddress => Refusal::Board,
        Exception::IllegalDataValue => Refusal::OutOfRange,
        Exception::ServerDeviceFailure => Refusal::OtherProgram,
        Exception::ServerDeviceBusy => Refusal::Controlled,
        Exception::GatewayPathUnavailable | Exception::GatewayTargetSilent => Refusal::Away,
    }
}

fn tell(broker: Broker) -> Tell {
    Arc::new(move |trouble| match trouble {
        None => println!("{}", messages::mqtt_there(&broker)),
        Some(trouble) => println!("{}", messages::mqtt_away(&broker, why(trouble))),
    })
}

/// Why a broker is away, in words.
fn why(trouble: &Trouble) -> String {
    match trouble {
        Trouble::Io(why) => messages::io(why),
        Trouble::Tls(why) => messages::mqtt_no_trust(why),
        Trouble::NotAllowed => messages::mqtt_not_allowed(),
        Trouble::Refused => messages::mqtt_refused(),
        Trouble::Slow => messages::mqtt_slow(),
        Trouble::Closed => messages::mqtt_closed(),
        Trouble::Other(why) => messages::mqtt_other(why),
    }
}
