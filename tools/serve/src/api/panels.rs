//! What stands on panels, and that a value is set there.

use super::answers::{BindOf, ItemOf, NameOf, PanelOf, Taken, Texts};
use super::gate::{Api, Caller};
use super::past::No;
use crate::guard::Who;
use crate::orders;
use crate::sharing::Unit;
use serde::Deserialize;
use std::sync::Arc;
use unoclp_modbus::Exception;
use unoclp_modbus::map::Width;
use unoclp_site::{Bind, Grant, Item, Look, Panel, Role as May, Text};

/// The panels of a site, and the points that a panel may have.
#[derive(Clone)]
pub(crate) struct Sheets {
    panels: Arc<[Panel]>,
    names: Arc<[NameOf]>,
    /// The units of the boards, in the order of the gateways.
    units: Arc<[u8]>,
}

/// What is set.
#[derive(Debug, Deserialize)]
struct Set {
    board: String,
    point: String,
    value: f64,
}

impl Sheets {
    /// These panels of these boards.
    pub fn new(panels: Vec<Panel>, boards: &[Unit]) -> Sheets {
        let names = boards.iter().filter_map(|board| {
            let watched = board.watched.as_ref()?;
            let points = watched.points.recorded(watched.points.program.is_some());
            Some(points.into_iter().map(|point| NameOf {
                board: board.gateway.name.clone(),
                bit: point.read.width == Width::Bit,
                writes: !point.write.is_empty(),
                point: point.name,
            }))
        });
        Sheets {
            names: names.flatten().collect(),
            panels: panels.into(),
            units: boards.iter().map(|board| board.unit).collect(),
        }
    }

    /// The points that a panel may have.
    pub fn names(&self) -> Vec<NameOf> {
        self.names.to_vec()
    }

    /// The panels.
    pub fn panels(&self) -> Vec<PanelOf> {
        self.panels.iter().map(panel).collect()
    }

    /// How this value of a point is written.
    fn grant(&self, set: &Set) -> Result<&Grant, No> {
        let items = self.panels.iter().flat_map(|panel| &panel.items);
        let of_point = |item: &&Item| item.board == set.board && item.point == set.point;
        let mut why = No::Panel;
        for item in items.filter(of_point) {
            let [least, most] = match item.look {
                Look::Set => item.range,
                _ => [0.0, 1.0],
            };
            match &item.grant {
                Some(grant) if (least..=most).contains(&set.value) => return Ok(grant),
                Some(_) => why = No::Value,
                None => {}
            }
        }
        Err(why)
    }
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
        let grant = self.sheets.grant(&set)?;
        let at = self
            .sheets
            .units
            .iter()
            .position(|unit| *unit == grant.unit);
        let gateway = at.and_then(|at| self.gateways.get(at)).ok_or(No::Panel)?;
        let written = orders::write(gateway, grant, set.value).await;
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

fn panel(of: &Panel) -> PanelOf {
    PanelOf {
        name: of.name.clone(),
        title: texts(&of.title),
        columns: of.columns,
        drawing: of.drawing.clone(),
        items: of.items.iter().map(item).collect(),
        binds: of.binds.iter().map(bind).collect(),
        made: of.is_made,
    }
}

fn item(of: &Item) -> ItemOf {
    let [least, most] = of.range;
    ItemOf {
        show: of.look.word(),
        board: of.board.clone(),
        point: of.point.clone(),
        label: texts(&of.label),
        unit: of.unit.clone(),
        least,
        most,
        at: of.at,
        size: of.size,
    }
}

fn bind(of: &Bind) -> BindOf {
    let [least, most] = of.range;
    BindOf {
        id: of.id.clone(),
        board: of.board.clone(),
        point: of.point.clone(),
        does: of.does.word(),
        least,
        most,
    }
}

fn texts(of: &Text) -> Texts {
    Texts {
        en: of.en.clone(),
        pt: of.pt.clone(),
    }
}
