//! Our client beside one that others have written, and beside our server.

use rmodbus::client::ModbusRequest;
use rmodbus::{ModbusProto, guess_response_frame_len};
use unoclp_modbus::client::{MOST_WORDS, NoReply, Request};
use unoclp_modbus::{Access, Crc, Exception, Exchange, FRAME_BYTES, Points, Table, refuse};

const SERVER: u8 = 17;

/// Every bit and word is told by its address; the words from 1000 on cannot be written.
struct Plain;

impl Points for Plain {
    fn has(&self, _: Table, first: u16, _: u16, _: Access) -> bool {
        first < 5000
    }
    fn bit(&self, _: Table, address: u16) -> bool {
        address.is_multiple_of(3)
    }
    fn word(&self, _: Table, address: u16) -> u16 {
        address.wrapping_mul(257)
    }
    fn set_bit(&mut self, _: u16, _: bool) {}
    fn check_word(&self, address: u16, _: u16) -> Result<(), Exception> {
        match address {
            ..1000 => Ok(()),
            _ => Err(Exception::ServerDeviceFailure),
        }
    }
    fn set_word(&mut self, _: u16, _: u16) {}
    fn identification(&self, object: u8, index: u8) -> Option<u8> {
        let text = ["a vendor", "", "1.2"][usize::from(object)];
        text.as_bytes().get(usize::from(index)).copied()
    }
}

/// The server's answer to a request.
fn answer(request: &Request) -> Vec<u8> {
    let (body, sum) = request.bytes().split_at(request.bytes().len() - 2);
    assert_eq!(sum, Crc::of(body).to_bytes());
    let mut frame = [0; FRAME_BYTES];
    frame[..body.len()].copy_from_slice(body);
    let mut exchange = Exchange::default();
    let mut length = exchange.begin(&mut frame, body.len() as u8, &mut Plain);
    while length.is_none() {
        length = exchange.fill(&mut frame, &mut Plain);
    }
    with_sum(&frame[..length.unwrap_or_default().into()])
}

fn with_sum(frame: &[u8]) -> Vec<u8> {
    [frame, &Crc::of(frame).to_bytes()].concat()
}

/// What they generate.
fn theirs(generate: impl FnOnce(&mut ModbusRequest, &mut Vec<u8>)) -> Vec<u8> {
    let mut request = ModbusRequest::new(SERVER, ModbusProto::Rtu);
    let mut frame = Vec::new();
    generate(&mut request, &mut frame);
    frame
}

#[test]
fn requests_are_those_of_another_client() {
    for (first, count) in [(0, 1), (1, 2), (0x1234, 125), (0xFF00, 100)] {
        let read = |table| Request::read(SERVER, table, first, count).bytes().to_vec();
        assert_eq!(
            read(Table::Coils),
            theirs(|r, f| r.generate_get_coils(first, count, f).unwrap())
        );
        assert_eq!(
            read(Table::DiscreteInputs),
            theirs(|r, f| r.generate_get_discretes(first, count, f).unwrap())
        );
        assert_eq!(
            read(Table::HoldingRegisters),
            theirs(|r, f| r.generate_get_holdings(first, count, f).unwrap())
        );
        assert_eq!(
            read(Table::InputRegisters),
            theirs(|r, f| r.generate_get_inputs(first, count, f).unwrap())
        );
    }
    for value in [0, 1, 0x1234, 0xFFFF] {
        assert_eq!(
            Request::write_word(SERVER, value, 7).bytes(),
            theirs(|r, f| r.generate_set_holding(value, 7, f).unwrap())
        );
    }
    for count in [1, 2, 60, MOST_WORDS] {
        let words: Vec<u16> = (0..count as u16).map(|word| word * 500).collect();
        assert_eq!(
            Request::write_words(SERVER, 402, &words).unwrap().bytes(),
            theirs(|r, f| r.generate_set_holdings_bulk(402, &words, f).unwrap())
        );
    }
    assert_eq!(Request::write_words(SERVER, 0, &[0; MOST_WORDS + 1]), None);
}

#[test]
fn answers_are_read_as_another_client_reads_them() {
    for count in [1, 7, 8, 9, 100, 125] {
        let request = Request::read(SERVER, Table::InputRegisters, 300, count);
        let came = answer(&request);
        let mut theirs = Vec::new();
        let mut parser = ModbusRequest::new(SERVER, ModbusProto::Rtu);
        parser
            .generate_get_inputs(300, count, &mut Vec::new())
            .unwrap();
        parser.parse_u16(&came, &mut theirs).unwrap();
        let reply = request.answer(&came).unwrap().unwrap();
        assert_eq!(reply.words().collect::<Vec<_>>(), theirs);

        let request = Request::read(SERVER, Table::Coils, 300, count);
        let came = answer(&request);
        let mut theirs = Vec::new();
        let mut parser = ModbusRequest::new(SERVER, ModbusProto::Rtu);
        parser
            .generate_get_coils(300, count, &mut Vec::new())
            .unwrap();
        parser.parse_bool(&came, &mut theirs).unwrap();
        let reply = request.answer(&came).unwrap().unwrap();
        let bits: Vec<_> = reply.bits().take(count.into()).collect();
        assert_eq!(bits, theirs[..count.into()]);
    }
}

#[test]
fn an_identification_is_three_texts() {
    let request = Request::identify(SERVER);
    let came = answer(&request);
    let reply = request.answer(&came).unwrap().unwrap();
    let texts: Vec<_> = reply.texts().collect();
    assert_eq!(texts, [&b"a vendor"[..], b"", b"1.2"]);
}

/// Requests of every kind.
fn requests() -> Vec<Request> {
    let tables = [
        Table::Coils,
        Table::DiscreteInputs,
        Table::HoldingRegisters,
        Table::InputRegisters,
    ];
    let reads = tables.map(|table| Request::read(SERVER, table, 5, 19));
    let writes = [
        Request::write_word(SERVER, 3, 4),
        Request::write_words(SERVER, 3, &[4, 5, 6]).unwrap(),
        Request::identify(SERVER),
    ];
    reads.into_iter().chain(writes).collect()
}

#[test]
fn an_answer_is_complete_at_its_last_byte() {
    for request in requests() {
        let came = answer(&request);
        for length in 0..came.len() {
            assert_eq!(
                request.answer(&came[..length]),
                None,
                "{came:02x?} {length}"
            );
        }
        assert!(request.answer(&came).unwrap().is_ok(), "{came:02x?}");
        if came[1] != 43 {
            let theirs = guess_response_frame_len(&came, ModbusProto::Rtu).unwrap();
            assert_eq!(usize::from(theirs), came.len());
        }
    }
}

#[test]
fn a_refusal_is_told_by_its_code() {
    for code in 0..=u8::MAX {
        let known = Exception::of(code);
        for request in requests() {
            let came = with_sum(&[SERVER, request.bytes()[1] | 0x80, code]);
            let expected = known.map_or(NoReply::Garbled, NoReply::Refused);
            assert_eq!(request.answer(&came), Some(Err(expected)));
        }
    }
    let refused = Request::write_word(SERVER, 1000, 1);
    let came = answer(&refused);
    let failure = NoReply::Refused(Exception::ServerDeviceFailure);
    assert_eq!(refused.answer(&came), Some(Err(failure)));
    for (server, length) in [(SERVER, 3), (0, 0)] {
        let mut frame = [server; FRAME_BYTES];
        assert_eq!(refuse(&mut frame, Exception::IllegalFunction), length);
    }
}

#[test]
fn what_is_no_answer_to_a_request_is_told_apart() {
    let garbled = Some(Err(NoReply::Garbled));
    let requests = requests();
    for (n, request) in requests.iter().enumerate() {
        let sound = answer(request);
        // Each bit of it counts.
        for bit in 0..8 * sound.len() {
            let mut came = sound.clone();
            came[bit / 8] ^= 1 << (bit % 8);
            assert!(!matches!(request.answer(&came), Some(Ok(_))), "{bit}");
        }
        // From another server, to another request, with a byte too many.
        let mut other = sound[..sound.len() - 2].to_vec();
        other[0] += 1;
        assert_eq!(request.answer(&with_sum(&other)), garbled);
        for (m, request) in requests.iter().enumerate() {
            assert!(n == m || request.answer(&sound) == garbled, "{n} {m}");
        }
        let longer = [&sound[..], &[0]].concat();
        assert_eq!(request.answer(&longer), garbled);
    }
    // Less than was asked for, and a write of something else.
    let less = answer(&Request::read(SERVER, Table::HoldingRegisters, 5, 18));
    assert_eq!(requests[2].answer(&less), garbled);
    let other = answer(&Request::write_word(SERVER, 3, 5));
    assert_eq!(requests[4].answer(&other), garbled);
}

#[test]
fn no_bytes_make_it_panic() {
    let requests = requests();
    let mut state = 1_u32;
    let mut random = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 24) as u8
    };
    for _ in 0..20_000 {
        let mut came: Vec<u8> = (0..random() % 40).map(|_| random()).collect();
        if let [server, function, ..] = &mut came[..] {
            *server = SERVER;
            *function = [1, 2, 3, 4, 6, 16, 43, 0x81, *function][usize::from(random() % 9)];
        }
        let came = with_sum(&came);
        for request in &requests {
            if let Some(Ok(reply)) = request.answer(&came) {
                assert!(reply.words().count() * 2 <= came.len());
                assert!(reply.bits().count() <= came.len() * 8);
                assert!(reply.texts().count() <= came.len());
            }
        }
    }
}
