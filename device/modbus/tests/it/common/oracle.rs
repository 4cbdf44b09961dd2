//! The protocol a second time, by the book and without slices: what must come of a request to the recorder.

use unoclp_modbus::{Access, Table};

use super::recorder::{Call, WINDOW, bit_at, check, check_block, exists, text, word_at};

/// The reply, if there is one, and what is written.
pub fn oracle(request: &[u8]) -> (Option<Vec<u8>>, Vec<Call>) {
    let [server, function, ref rest @ ..] = *request else {
        return (None, vec![]);
    };
    let is_write = matches!(function, 5 | 6 | 15 | 16);
    if server == 0 && !is_write {
        return (None, vec![]);
    }
    let mut writes = vec![];
    let reply = match respond(function, rest, &mut writes) {
        Ok(data) => [vec![server, function], data].concat(),
        Err(code) => vec![server, function | 0x80, code],
    };
    ((server != 0).then_some(reply), writes)
}

/// What follows the function code in the response, or an exception code.
fn respond(function: u8, rest: &[u8], writes: &mut Vec<Call>) -> Result<Vec<u8>, u8> {
    match function {
        1 => read_bits(Table::Coils, rest),
        2 => read_bits(Table::DiscreteInputs, rest),
        3 => read_words(Table::HoldingRegisters, rest),
        4 => read_words(Table::InputRegisters, rest),
        5 => {
            let [_, _, value @ ..] = exactly::<4>(rest)?;
            let on = match value {
                [0x00, 0x00] => false,
                [0xFF, 0x00] => true,
                _ => return Err(3),
            };
            let first = number(rest, 0);
            all_exist(Table::Coils, first, 1, Access::Write)?;
            writes.push(Call::SetBit(first as u16, on));
            Ok(rest.to_vec())
        }
        6 => {
            exactly::<4>(rest)?;
            let (first, value) = (number(rest, 0), number(rest, 2) as u16);
            all_exist(Table::HoldingRegisters, first, 1, Access::Write)?;
            check(value).map_err(|exception| exception as u8)?;
            writes.push(Call::SetWord(first as u16, value));
            Ok(rest.to_vec())
        }
        15 => {
            let (first, count, data) = several(rest, 1968, |count| count.div_ceil(8))?;
            all_exist(Table::Coils, first, count, Access::Write)?;
            let bit = |n: usize| data[n / 8] >> (n % 8) & 1 == 1;
            writes.extend((0..count).map(|n| Call::SetBit((first + n) as u16, bit(n))));
            Ok(rest[..4].to_vec())
        }
        16 => {
            let (first, count, data) = several(rest, 123, |count| 2 * count)?;
            if first + count <= 0x1_0000 && first == usize::from(WINDOW) {
                writes.push(Call::Take(WINDOW, data.to_vec()));
                check_block(data).map_err(|exception| exception as u8)?;
                return Ok(rest[..4].to_vec());
            }
            all_exist(Table::HoldingRegisters, first, count, Access::Write)?;
            let values: Vec<u16> = (0..count).map(|n| number(data, 2 * n) as u16).collect();
            for &value in &values {
                check(value).map_err(|exception| exception as u8)?;
            }
            let all = (first..).zip(values);
            writes.extend(all.map(|(address, value)| Call::SetWord(address as u16, value)));
            Ok(rest[..4].to_vec())
        }
        43 => identify(rest),
        _ => Err(1),
    }
}

fn read_bits(table: Table, rest: &[u8]) -> Result<Vec<u8>, u8> {
    let (first, count) = span(table, rest, 2000)?;
    let mut data = vec![0; count.div_ceil(8)];
    for n in 0..count {
        data[n / 8] |= u8::from(bit_at(table, (first + n) as u16)) << (n % 8);
    }
    Ok([vec![data.len() as u8], data].concat())
}

fn read_words(table: Table, rest: &[u8]) -> Result<Vec<u8>, u8> {
    let (first, count) = span(table, rest, 125)?;
    let mut data = vec![2 * count as u8];
    for n in 0..count {
        data.extend(word_at(table, (first + n) as u16).to_be_bytes());
    }
    Ok(data)
}

fn identify(rest: &[u8]) -> Result<Vec<u8>, u8> {
    let (14, _) = rest
        .split_first()
        .map(|(mei, tail)| (*mei, tail))
        .ok_or(3)?
    else {
        return Err(1);
    };
    let [_, code, object] = exactly::<3>(rest)?;
    let objects = match (code, object) {
        (1..=3, 0..=2) => object..3,
        (1..=3, _) => 0..3,
        (4, 0..=2) => object..object + 1,
        (4, _) => return Err(2),
        _ => return Err(3),
    };
    let mut data = vec![14, code, 0x81, 0, 0, objects.len() as u8];
    for object in objects {
        data.extend([object, text(object).len() as u8]);
        data.extend(text(object));
    }
    Ok(data)
}

fn span(table: Table, rest: &[u8], most: usize) -> Result<(usize, usize), u8> {
    exactly::<4>(rest)?;
    let (first, count) = (number(rest, 0), number(rest, 2));
    if !(1..=most).contains(&count) {
        return Err(3);
    }
    all_exist(table, first, count, Access::Read)?;
    Ok((first, count))
}

fn several(
    rest: &[u8],
    most: usize,
    needed: impl Fn(usize) -> usize,
) -> Result<(usize, usize, &[u8]), u8> {
    if rest.len() < 5 {
        return Err(3);
    }
    let (head, data) = rest.split_at(5);
    let (first, count) = (number(head, 0), number(head, 2));
    let sound = (1..=most).contains(&count)
        && usize::from(head[4]) == needed(count)
        && data.len() == needed(count);
    if sound {
        Ok((first, count, data))
    } else {
        Err(3)
    }
}

fn all_exist(table: Table, first: usize, count: usize, access: Access) -> Result<(), u8> {
    let fine = (first..first + count)
        .all(|address| u16::try_from(address).is_ok_and(|address| exists(table, address, access)));
    if fine { Ok(()) } else { Err(2) }
}

fn exactly<const N: usize>(rest: &[u8]) -> Result<[u8; N], u8> {
    rest.try_into().map_err(|_| 3)
}

fn number(bytes: &[u8], at: usize) -> usize {
    usize::from(bytes[at]) * 256 + usize::from(bytes[at + 1])
}
