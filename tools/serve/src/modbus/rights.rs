//! What may be written over Modbus TCP: the points that a site names, and nothing else.

use crate::written::written;
use std::ops::Range;
use unoclp_client::diagnostics::Kept;
use unoclp_modbus::Exception;
use unoclp_modbus::client::Request;
use unoclp_site::Grant;

/// The points of all units that may be written.
pub(super) struct Rights(Vec<Grant>);

impl Rights {
    pub fn new(grants: Vec<Grant>) -> Rights {
        Rights(grants)
    }

    /// Whether this request to this unit writes only what may be written: if so, which program the board must keep for
    /// it, if that matters.
    ///
    /// # Errors
    /// The exception that refuses it.
    pub fn of(&self, unit: u8, request: &Request) -> Result<Option<Kept>, Exception> {
        let (table, addresses) = written(request)?;
        let mut while_kept = None;
        for address in addresses {
            let of_unit = self.0.iter().filter(|grant| grant.unit == unit);
            let grants = of_unit.filter(|grant| {
                let is_there = |range: Range<u16>| range.contains(&address);
                let places = grant.places.iter().filter(|place| place.table == table);
                places.map(|place| place.addresses()).any(is_there)
            });
            // One that holds whichever program the board keeps is enough.
            let needs = grants
                .map(|grant| grant.while_kept)
                .min_by_key(Option::is_some);
            match needs {
                None => return Err(Exception::IllegalFunction),
                Some(None) => {}
                Some(kept) => while_kept = kept,
            }
        }
        Ok(while_kept)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::modbus::frame::to_board;
    use unoclp_modbus::Table;
    use unoclp_modbus::map::Width;
    use unoclp_site::Place;

    fn kept(sum: u16) -> Kept {
        Kept {
            sum,
            ..Kept::default()
        }
    }

    fn grant(unit: u8, table: Table, first: u16, while_kept: Option<Kept>) -> Grant {
        let width = match table {
            Table::Coils => Width::Bit,
            _ => Width::Long,
        };
        Grant {
            unit,
            name: String::new(),
            point: String::new(),
            kind: unoclp_site::Kind::Signed,
            places: vec![Place {
                table,
                first,
                width,
            }],
            while_kept,
        }
    }

    #[test]
    fn what_a_site_names_may_be_written_and_nothing_else() {
        let rights = Rights::new(vec![
            grant(1, Table::HoldingRegisters, 0, None),
            grant(1, Table::HoldingRegisters, 2, Some(kept(7))),
            grant(1, Table::Coils, 16, None),
            grant(1, Table::Coils, 17, Some(kept(7))),
            grant(1, Table::Coils, 17, None),
            grant(2, Table::HoldingRegisters, 400, None),
        ]);
        let (no, wrong) = (
            Err(Exception::IllegalFunction),
            Err(Exception::IllegalDataValue),
        );
        for (request, expected) in [
            (&[6, 0, 0, 0, 5][..], Ok(None)),
            (&[6, 0, 1, 0, 5], Ok(None)),
            (&[6, 0, 2, 0, 5], Ok(Some(kept(7)))),
            (&[6, 0, 4, 0, 5], no),
            (&[6, 1, 0x90, 0, 2], no),
            (&[16, 0, 0, 0, 2, 4, 0, 0, 0, 5], Ok(None)),
            (
                &[16, 0, 0, 0, 4, 8, 0, 0, 0, 5, 0, 0, 0, 5],
                Ok(Some(kept(7))),
            ),
            (&[16, 0, 1, 0, 4, 8, 0, 0, 0, 5, 0, 0, 0, 5], no),
            (&[16, 0, 0, 0, 1, 4, 0, 0, 0, 5], wrong),
            (&[16, 0, 0, 0, 0, 0], wrong),
            (&[16, 0, 0, 0, 2, 4, 0, 0, 0], wrong),
            (&[16, 0xFF, 0xFF, 0, 2, 4, 0, 0, 0, 5], wrong),
            (&[16, 0, 0, 0xFF, 0xFF, 4, 0, 0, 0, 5], wrong),
            (&[5, 0, 16, 0xFF, 0], Ok(None)),
            (&[5, 0, 17, 0xFF, 0], Ok(None)),
            (&[5, 0, 0, 0xFF, 0], no),
            (&[15, 0, 16, 0, 2, 1, 3], Ok(None)),
            (&[15, 0, 15, 0, 2, 1, 3], no),
            (&[15, 0, 16, 0, 9, 1, 3], wrong),
            (&[22, 0, 0, 0, 0, 0, 0], no),
            (&[0x86, 0, 0, 0, 0], no),
            (&[6], wrong),
        ] {
            let request = to_board(1, request).unwrap();
            assert_eq!(rights.of(1, &request), expected, "{:?}", request.bytes());
        }
        let elsewhere = to_board(1, &[6, 0, 0, 0, 5]).unwrap();
        assert_eq!(rights.of(2, &elsewhere), no);
    }
}
