//! The names of the topics (*Sparkplug 3.0.0*, chapter 4).

use unoclp_site::Sparkplug;

/// Those of an edge node.
#[derive(Clone, Debug)]
pub(super) struct Topics {
    group: String,
    node: String,
    host: Option<String>,
}

/// What has come.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Came {
    /// The state of the primary host.
    State,
    /// A command for the node.
    Node,
    /// A command for a device.
    Device(String),
}

impl Topics {
    pub fn new(of: &Sparkplug) -> Topics {
        Topics {
            group: of.group.clone(),
            node: of.node.clone(),
            host: of.host.clone(),
        }
    }

    /// A message of the node: `NBIRTH`, `NDEATH`, `NCMD`.
    pub fn node(&self, verb: &str) -> String {
        format!("spBv1.0/{}/{verb}/{}", self.group, self.node)
    }

    /// A message of a device: `DBIRTH`, `DDEATH`, `DDATA`, `DCMD`.
    pub fn device(&self, verb: &str, device: &str) -> String {
        format!("{}/{device}", self.node(verb))
    }

    /// The state of the primary host, if there is one.
    pub fn state(&self) -> Option<String> {
        let host = self.host.as_ref()?;
        Some(format!("spBv1.0/STATE/{host}"))
    }

    /// All that is asked for.
    pub fn filters(&self) -> Vec<String> {
        let commands = [self.node("NCMD"), self.device("DCMD", "+")];
        commands.into_iter().chain(self.state()).collect()
    }

    /// What a topic brings; none of another one.
    pub fn came(&self, topic: &str) -> Option<Came> {
        if self.state().is_some_and(|state| topic == state) {
            return Some(Came::State);
        }
        if topic == self.node("NCMD") {
            return Some(Came::Node);
        }
        let device = topic.strip_prefix(&self.node("DCMD"))?.strip_prefix('/')?;
        Some(Came::Device(device.to_owned()))
    }
}
