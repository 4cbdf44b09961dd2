//! A client that others have written understands the server, and is understood.

use crate::common::answer;
use crate::common::recorder::{Call, Recorder, bit_at, word_at};
use rmodbus::client::ModbusRequest;
use rmodbus::{ErrorKind, ModbusProto};
use unoclp_modbus::{Crc, Table};

const SERVER: u8 = 17;

fn client() -> ModbusRequest {
    ModbusRequest::new(SERVER, ModbusProto::Rtu)
}

/// The serial line: the client's CRC is checked and cut, the server's appended.
fn send(device: &mut Recorder, mut request: Vec<u8>) -> Vec<u8> {
    assert_eq!(Crc::of(&request).value(), 0, "{request:02x?}");
    request.truncate(request.len() - 2);
    let mut reply = answer(device, &request).unwrap();
    reply.extend(Crc::of(&reply).to_bytes());
    reply
}

#[test]
fn it_reads_bits() {
    for (first, count) in [(0, 1), (0, 10), (0x1001, 2000), (0x1000, 13), (0xFFFF, 1)] {
        for table in [Table::Coils, Table::DiscreteInputs] {
            let (mut client, mut request) = (client(), vec![]);
            match table {
                Table::Coils => client.generate_get_coils(first, count, &mut request),
                _ => client.generate_get_discretes(first, count, &mut request),
            }
            .unwrap();
            let mut bits = vec![];
            let reply = send(&mut Recorder::default(), request);
            client.parse_bool(&reply, &mut bits).unwrap();
            let expected: Vec<bool> = (0..count).map(|n| bit_at(table, first + n)).collect();
            assert_eq!(bits, expected, "{table:?} {first:#x}, {count}");
        }
    }
}

#[test]
fn it_reads_words() {
    for (first, count) in [(0, 1), (0, 10), (0x1001, 125), (0x1000, 2), (0xFFFF, 1)] {
        for table in [Table::HoldingRegisters, Table::InputRegisters] {
            let (mut client, mut request) = (client(), vec![]);
            match table {
                Table::HoldingRegisters => client.generate_get_holdings(first, count, &mut request),
                _ => client.generate_get_inputs(first, count, &mut request),
            }
            .unwrap();
            let mut words = vec![];
            let reply = send(&mut Recorder::default(), request);
            client.parse_u16(&reply, &mut words).unwrap();
            let expected: Vec<u16> = (0..count).map(|n| word_at(table, first + n)).collect();
            assert_eq!(words, expected, "{table:?} {first:#x}, {count}");
        }
    }
}

#[test]
fn it_writes_a_coil_and_a_register() {
    let mut device = Recorder::default();
    let mut client = client();
    let mut request = vec![];
    client.generate_set_coil(9, true, &mut request).unwrap();
    client.parse_ok(&send(&mut device, request)).unwrap();
    let mut request = vec![];
    client.generate_set_coil(8, false, &mut request).unwrap();
    client.parse_ok(&send(&mut device, request)).unwrap();
    assert_eq!(
        device.writes(),
        [Call::SetBit(9, true), Call::SetBit(8, false)]
    );

    let mut device = Recorder::default();
    let mut request = vec![];
    client
        .generate_set_holding(0xFFFF, 0x1234, &mut request)
        .unwrap();
    client.parse_ok(&send(&mut device, request)).unwrap();
    assert_eq!(device.writes(), [Call::SetWord(0xFFFF, 0x1234)]);
}

#[test]
fn it_writes_several() {
    for count in [1_u16, 2, 7, 8, 9, 1967, 1968] {
        let mut device = Recorder::default();
        let (mut client, mut request) = (client(), vec![]);
        let bits: Vec<bool> = (0..count).map(|n| n % 3 == 0).collect();
        client
            .generate_set_coils_bulk(0x1001, &bits, &mut request)
            .unwrap();
        client.parse_ok(&send(&mut device, request)).unwrap();
        let writes: Vec<Call> = (0x1001..)
            .zip(bits)
            .map(|(a, on)| Call::SetBit(a, on))
            .collect();
        assert_eq!(device.writes(), writes);
    }
    for count in [1_u16, 2, 122, 123] {
        let mut device = Recorder::default();
        let (mut client, mut request) = (client(), vec![]);
        let words: Vec<u16> = (0..count).map(|n| n * 517).collect();
        client
            .generate_set_holdings_bulk(0x1001, &words, &mut request)
            .unwrap();
        client.parse_ok(&send(&mut device, request)).unwrap();
        let writes: Vec<Call> = (0x1001..)
            .zip(words)
            .map(|(a, word)| Call::SetWord(a, word))
            .collect();
        assert_eq!(device.writes(), writes);
    }
}

#[test]
fn it_understands_refusals() {
    let refusal = |generate: &dyn Fn(&mut ModbusRequest, &mut Vec<u8>)| {
        let (mut client, mut request) = (client(), vec![]);
        generate(&mut client, &mut request);
        client.parse_ok(&send(&mut Recorder::default(), request))
    };
    let get = |first, count| {
        refusal(&move |client, request| {
            client.generate_get_holdings(first, count, request).unwrap()
        })
    };
    assert_eq!(get(9, 2), Err(ErrorKind::IllegalDataAddress));
    assert_eq!(get(0xFFFF, 2), Err(ErrorKind::IllegalDataAddress));
    assert_eq!(get(0, 0), Err(ErrorKind::IllegalDataValue));
    assert_eq!(get(0x1000, 126), Err(ErrorKind::IllegalDataValue));
    let set = |value| {
        refusal(&move |client, request| client.generate_set_holding(0, value, request).unwrap())
    };
    assert_eq!(set(0xBAD0), Err(ErrorKind::IllegalDataValue));
    assert_eq!(set(0xDEA0), Err(ErrorKind::SlaveDeviceFailure));
    let too_many = refusal(&|client, request| {
        client
            .generate_set_holdings_bulk(0x1000, &[0; 124], request)
            .unwrap();
    });
    assert_eq!(too_many, Err(ErrorKind::IllegalDataValue));
}
