//! That a value is set on a panel.

use super::answers::Taken;
use super::gate::{Api, Caller};
use super::past::No;
use crate::guard::Who;
use crate::orders;
use serde::Deserialize;
use unoclp_modbus::Exception;
use unoclp_site::Role as May;

/// What is set.
#[derive(Debug, Deserialize)]
struct Set {
    board: String,
    point: String,
    value: f64,
    /// A button is pressed, and will be heard of again.
    hold: Option<Hold>,
}

/// What is said of a button.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
enum Hold {
    /// It is pressed,
    Begin,
    /// and is so still.
    Still,
}

impl Api {
    /// Somebody sets a value on a panel.
    pub(super) async fn write(
        &self,
        who: Who,
        Caller(from): Caller,
        body: &[u8],
    ) -> Result<Taken, No> {
        if who.may < May::Operate {
            return Err(No::Role);
        }
        let set: Set = serde_json::from_slice(body).map_err(|_| No::Value)?;
        let grant = self.sheets.grant(&set.board, &set.point, set.value)?;
        let at = self.sheets.board(grant.unit);
        let gateway = at.and_then(|at| self.gateways.get(at)).ok_or(No::Panel)?;
        match set.hold {
            Some(_) if set.value == 0.0 => return Err(No::Value),
            Some(Hold::Still) => {
                let is_held = self.holding.hear(grant);
                return match is_held {
                    true => Ok(Taken { value: set.value }),
                    false => Err(No::Held),
                };
            }
            // Before it is written: what has been written must end.
            Some(Hold::Begin) => self.holding.press(gateway, grant, &who.name),
            None => {}
        }
        let written = orders::write(gateway, grant, set.value).await;
        let is_over = match &written {
            Ok(()) => set.hold.is_none(),
            // A board that was silent may have heard it.
            Err(Exception::GatewayTargetSilent) => false,
            Err(_) => set.hold.is_some(),
        };
        if is_over {
            self.holding.forget(grant);
        }
        written.map_err(|exception| match exception {
            Exception::ServerDeviceBusy => No::Controlled,
            Exception::ServerDeviceFailure => No::Program,
            Exception::IllegalDataValue => No::Value,
            Exception::IllegalFunction => No::Role,
            _ => No::Away,
        })?;
        let deeds = &gateway.deeds;
        deeds.panel(&who, from, &set.board, &set.point, set.value);
        deeds.settle().await;
        Ok(Taken { value: set.value })
    }
}
