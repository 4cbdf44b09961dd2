//! Values that a broker brings: they have the rights of their names, and a person goes before them.

use crate::common::Visitor;
use crate::simulated::kept;
use crate::site::{Site, register};
use std::sync::mpsc::channel;
use unoclp_modbus::client::Request;
use unoclp_modbus::map::Width;
use unoclp_modbus::{Exception, Table};
use unoclp_serve::{Order, Orders};
use unoclp_site::{Grant, Kind, Place};

/// What becomes of this order.
fn ordered(orders: &Orders, grant: Grant, value: f64) -> Result<(), Exception> {
    let (send, done) = channel();
    orders.send(Order {
        grant,
        value,
        done: Box::new(move |outcome| send.send(outcome).unwrap()),
    });
    done.recv().unwrap()
}

fn coil(first: u16) -> Grant {
    Grant {
        kind: Kind::Unsigned,
        places: vec![Place {
            table: Table::Coils,
            first,
            width: Width::Bit,
        }],
        ..register(0, None)
    }
}

#[test]
fn a_value_is_written_while_its_name_holds_and_nobody_controls() {
    let site = Site::new(Vec::new());
    let orders = &site.orders;
    let read = |function, first: u8, count| site.ask(1, &[function, 0, first, 0, count]);
    assert_eq!(ordered(orders, register(0, None), -2.0), Ok(()));
    assert_eq!(read(3, 0, 2), [3, 4, 0xFF, 0xFF, 0xFF, 0xFE]);
    assert_eq!(ordered(orders, coil(17), 1.0), Ok(()));
    assert_eq!(read(1, 16, 2), [1, 1, 0b10]);
    for (grant, value, exception) in [
        (register(0, None), 0.5, Exception::IllegalDataValue),
        (register(0, None), 1e12, Exception::IllegalDataValue),
        (coil(17), 2.0, Exception::IllegalDataValue),
        (register(9_000, None), 1.0, Exception::IllegalDataAddress),
        (
            register(0, Some(kept(9))),
            1.0,
            Exception::ServerDeviceFailure,
        ),
        (
            Grant {
                unit: 9,
                ..register(0, None)
            },
            1.0,
            Exception::GatewayPathUnavailable,
        ),
    ] {
        assert_eq!(ordered(orders, grant, value), Err(exception));
    }
    assert_eq!(ordered(orders, register(0, Some(kept(3))), 5.0), Ok(()));
    let mut person = Visitor::at(site.page, "/line/one", "");
    assert_eq!(person.ask(&Request::write_word(3, 400, 2))[1], 6);
    let outcome = ordered(orders, register(0, None), 6.0);
    assert_eq!(outcome, Err(Exception::ServerDeviceBusy));
    drop(person);
    while ordered(orders, register(0, None), 7.0).is_err() {}
    site.boards.unplug(true);
    let gone = Err(Exception::GatewayTargetSilent);
    while ordered(orders, register(0, None), 8.0) != gone {}
}
