//! The names of the topics. What no point and no board can be called begins with `$`.

/// All below one.
#[derive(Clone, Debug)]
pub(super) struct Topics {
    above: String,
}

/// Of which point a topic of a command speaks.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Asked {
    pub board: String,
    pub point: String,
}

impl Topics {
    pub fn new(above: &str) -> Topics {
        Topics {
            above: above.to_owned(),
        }
    }

    /// Whether the gateway is there.
    pub fn gateway(&self) -> String {
        format!("{}/$status", self.above)
    }

    /// Whether a board is there.
    pub fn board(&self, board: &str) -> String {
        format!("{}/{board}/$status", self.above)
    }

    /// Which commands for a board are refused.
    pub fn refused(&self, board: &str) -> String {
        format!("{}/{board}/$refused", self.above)
    }

    /// How an alarm stands.
    pub fn alarm(&self, alarm: &str) -> String {
        format!("{}/$alarm/{alarm}", self.above)
    }

    /// All of them.
    pub fn alarms(&self) -> String {
        self.alarm("+")
    }

    /// Of which alarm a topic speaks; none of another topic.
    pub fn alarm_of<'t>(&self, topic: &'t str) -> Option<&'t str> {
        let below = topic.strip_prefix(&*self.above)?;
        let alarm = below.strip_prefix("/$alarm/")?;
        Some(alarm).filter(|alarm| !alarm.contains('/'))
    }

    /// That an alarm is acknowledged.
    pub fn acknowledge(&self, alarm: &str) -> String {
        format!("{}/acknowledge", self.alarm(alarm))
    }

    /// Which alarm shall be acknowledged; none of another topic.
    pub fn acknowledged<'t>(&self, topic: &'t str) -> Option<&'t str> {
        self.alarm_of(topic.strip_suffix("/acknowledge")?)
    }

    /// Which alarms are not acknowledged.
    pub fn alarm_refused(&self) -> String {
        self.alarm("$refused")
    }

    /// What a point is.
    pub fn point(&self, board: &str, point: &str) -> String {
        format!("{}/{board}/{}", self.above, level(point))
    }

    /// What a point shall be.
    pub fn command(&self, board: &str, point: &str) -> String {
        format!("{}/set", self.point(board, point))
    }

    /// All commands.
    pub fn commands(&self) -> String {
        format!("{}/+/+/set", self.above)
    }

    /// Of which point a command speaks; none of another topic.
    pub fn asked(&self, topic: &str) -> Option<Asked> {
        let below = topic.strip_prefix(&*self.above)?.strip_prefix('/')?;
        let (board, point) = below.strip_suffix("/set")?.split_once('/')?;
        Some(Asked {
            board: board.to_owned(),
            point: point.to_owned(),
        })
    }
}

/// A name as a level of a topic: without what MQTT takes for something else.
fn level(name: &str) -> String {
    name.replace(['/', '+', '#', '\0'], "_")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_topic_of_a_command_leads_back_to_its_point() {
        let topics = Topics::new("unoclp");
        assert_eq!(topics.point("b", "x.y"), "unoclp/b/x.y");
        assert_eq!(topics.point("b", "x/+#y"), "unoclp/b/x___y");
        let asked = topics.asked(&topics.command("b", "x"));
        assert_eq!(
            asked,
            Some(Asked {
                board: "b".into(),
                point: "x".into()
            })
        );
        let acknowledge = topics.acknowledge("hot");
        assert_eq!(topics.acknowledged(&acknowledge), Some("hot"));
        assert_eq!(topics.alarm_of(&acknowledge), None);
        assert_eq!(topics.acknowledged("unoclp/b/acknowledge"), None);
        for topic in [
            "unoclp/b/x",
            "unoclp/set",
            "other/b/x/set",
            "unoclpb/x/set",
            "",
        ] {
            assert_eq!(topics.asked(topic), None, "{topic}");
        }
    }
}
