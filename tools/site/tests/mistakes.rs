//! Every kind of mistake in a site file is refused with its line, the reason and a remedy, in both languages.

use std::collections::BTreeSet;
use std::mem::discriminant;
use unoclp_program::Lang;
use unoclp_site::{Files, Mistake, Site, Sort, Wrong, plan, read};

/// The folder of the site file.
struct Folder;

const TANK: &str = "PROGRAM tank VAR level AT %IW0 : INT; valve AT %QX0.0 : BOOL; target : DINT; END_VAR\n\
    valve := level > target; target := target + 0; END_PROGRAM\n";

impl Files for Folder {
    fn bytes(&self, name: &str) -> Result<Vec<u8>, String> {
        match name {
            "tank.st" => Ok(TANK.into()),
            "lamp.txt" => Ok("0\n787600\n827301\n877901\n".into()),
            "wrong.st" => Ok("PROGRAM p lamp := ; END_PROGRAM\n".into()),
            "lamp.panel.toml" => Ok("[[item]]\nshow = \"lamp\"\npoint = \"x.Q1\"\n".into()),
            "other.panel.toml" => Ok("[[item]]\nshow = \"lamp\"\npoint = \"x.M1\"\n".into()),
            "turned.panel.toml" => {
                Ok("[[item]]\nshow = \"bar\"\npoint = \"x.A0\"\nmost = -1.5\n".into())
            }
            "long.panel.toml" => Ok(format!("title = \"{}\"\n", "x".repeat(61)).into()),
            "picture.png" => Ok(vec![0xFF; 8]),
            _ => Err("no such file".into()),
        }
    }
}

fn of(text: &str) -> Result<Site, Vec<Mistake>> {
    read(text, &Folder)
}

/// A line with a board.
const LINE: &str = "[[line]]\nport = \"a\"\n[[line.board]]\nname = \"x\"\n";

/// What is wrong, and in which line of the file.
fn mistakes() -> Vec<(String, usize, &'static str)> {
    let with = |more: &str| format!("{LINE}{more}");
    vec![
        ("[[line]\n".into(), 1, "this is not TOML"),
        (with("name = \"y\"\n"), 5, "this is not TOML"),
        (
            with("[mqqt]\n"),
            5,
            "no key `mqqt` here; known keys: `http`, `line`, `modbus`, `mqtt`, `history`, `journal`, `record`, `alarm`, `panel`, `user`",
        ),
        (
            with("[mqtt]\n"),
            5,
            "`broker` is missing; write `broker = \"mqtts://",
        ),
        (
            with("[mqtt]\nbroker = \"10.0.0.7\"\n"),
            6,
            "10.0.0.7 is not a broker's address; write \"mqtt://",
        ),
        (
            with("[mqtt]\nbroker = \"mqtt://me:secret@a\"\n"),
            6,
            "unoclp displays it; write `user` and `password`",
        ),
        (
            with("[mqtt]\nbroker = \"mqtt://a\"\nca = \"ca.pem\"\n"),
            7,
            "write mqtts://, or remove `ca`",
        ),
        (
            with("[mqtt]\nbroker = \"mqtt://a\"\npassword = \"x\"\n"),
            7,
            "does not accept a password without a user",
        ),
        (
            with("[mqtt]\nbroker = \"mqtt://a\"\ntopic = \"a/b\"\n"),
            7,
            "`topic` cannot be \"a/b\"; use at most 32 letters",
        ),
        (
            with("[mqtt]\nbroker = \"mqtt://a\"\nhome_assistant = \"yes\"\n"),
            7,
            "`home_assistant` takes a different kind of value; write `home_assistant = true`",
        ),
        (
            with("[mqtt]\nbroker = \"mqtt://a\"\nsparkplug = {}\n"),
            7,
            "`group` is missing; write `group = \"lab\"`",
        ),
        (
            with("[mqtt]\nbroker = \"mqtt://a\"\nevery = \"1ms\"\n"),
            7,
            "1ms is not a time from 1s to 1d",
        ),
        (
            with("colour = 1\n"),
            5,
            "no key `colour` here; known keys: `address`, `unit`, `name`, `kind`, `program`, `every`",
        ),
        (
            "\n[[line]]\nport = \"a\"\n[[line.board]]\n".into(),
            4,
            "`name` is missing; write `name = \"estufa\"`",
        ),
        (with("[modbus]\n"), 5, "`listen` is missing"),
        (
            with("address = \"1\"\n"),
            5,
            "`address` takes a different kind of value; write `address = 1`",
        ),
        (
            with("[modbus]\nlisten = 5\n"),
            6,
            "`listen` takes a different kind",
        ),
        (
            with("[modbus]\nlisten = \"127.0.0.1:1\"\nwrite = \"x.D1\"\n"),
            7,
            "`write` takes a different kind",
        ),
        (
            with("[modbus]\nlisten = \"127.0.0.1:1\"\nwrite = [5]\n"),
            7,
            "`write` takes a different kind",
        ),
        ("line = 5\n".into(), 1, "`line` takes a different kind"),
        (
            "http = 5\n".to_owned() + LINE,
            1,
            "`http` takes a different kind",
        ),
        (
            with("address = 0\n"),
            5,
            "`address` is out of range; use a number from 1 to 247",
        ),
        (with("unit = 248\n"), 5, "`unit` is out of range"),
        (
            with("unit = 99999999999999999999\n"),
            5,
            "`unit` is out of range",
        ),
        (
            "[[line]]\nport = \"a\"\nrate = 9601\n[[line.board]]\nname = \"x\"\n".into(),
            3,
            "`rate` cannot be 9601; choose 2400, 4800",
        ),
        (
            "[[line]]\nport = \"a\"\nparity = \"mark\"\n[[line.board]]\nname = \"x\"\n".into(),
            3,
            "`parity` cannot be mark; choose \"none\"",
        ),
        (
            with("kind = \"due\"\n"),
            5,
            "`kind` cannot be due; choose \"uno\", \"nano\", \"mega\"",
        ),
        (
            with("[http]\nlisten = \"localhost\"\n"),
            6,
            "localhost is not an address with a port",
        ),
        (
            "[[line]]\ntcp = \"10.0.0.7\"\n[[line.board]]\nname = \"x\"\n".into(),
            2,
            "10.0.0.7 is not a host with a port",
        ),
        (
            with("[http]\nlisten = \"0.0.0.0:8420\"\n"),
            6,
            "0.0.0.0:8420 is open to the network; write `tls = \"self-signed\"`",
        ),
        (String::new(), 1, "there are no lines; add a [[line]]"),
        (
            "\n[[line]]\n[[line.board]]\nname = \"x\"\n".into(),
            2,
            "either `port` or `tcp`",
        ),
        (
            "[[line]]\nport = \"a\"\ntcp = \"b:1\"\n[[line.board]]\nname = \"x\"\n".into(),
            1,
            "either `port` or `tcp`",
        ),
        (
            "[[line]]\ntcp = \"b:1\"\nrate = 9600\n[[line.board]]\nname = \"x\"\n".into(),
            3,
            "a line over TCP has no `rate`; remove it",
        ),
        (
            "\n[[line]]\nport = \"a\"\n".into(),
            2,
            "this line has no boards",
        ),
        (
            with("[[line]]\nport = \"a\"\n[[line.board]]\nname = \"y\"\nunit = 2\n"),
            5,
            "two lines use a",
        ),
        (
            "[[line]]\nport = \"a\"\n[[line.board]]\nname = \"a/b\"\n".into(),
            4,
            "a/b cannot be the name of a board",
        ),
        (
            with("[[line.board]]\nname = \"X\"\naddress = 2\n"),
            6,
            "two boards are called X",
        ),
        (
            with("[[line.board]]\nname = \"y\"\nunit = 2\naddress = 1\n"),
            8,
            "x on this line also has address 1; give one board a different address with `unoclp settings",
        ),
        (
            with("[[line]]\nport = \"b\"\n[[line.board]]\nname = \"y\"\n"),
            7,
            "x also has unit 1",
        ),
        (
            with("[modbus]\nlisten = \"127.0.0.1:8420\"\n"),
            6,
            "two servers listen on 127.0.0.1:8420",
        ),
        (
            with("program = \"none.st\"\n"),
            5,
            "the program none.st cannot be read (no such file)",
        ),
        (
            with("program = \"wrong.st\"\n"),
            5,
            "`unoclp check wrong.st` shows them",
        ),
        (
            with("every = \"5\"\n"),
            5,
            "5 is not a time from 10ms to 1h; write \"100ms\"",
        ),
        (
            with("every = \"2h\"\n"),
            5,
            "2h is not a time from 10ms to 1h",
        ),
        (
            with("[history]\nstore = \"h.db\"\nkeep = \"1m\"\n"),
            7,
            "1m is not a time from 1h to 36500d",
        ),
        (
            with("[history]\nkeep = \"1h\"\n"),
            5,
            "the key `store` is missing; write `store = \"history.db\"`",
        ),
        (
            with("[history]\nstore = \"postgres://x\"\n"),
            6,
            "postgres://x is not a database; write \"history.db\" for a file, or \"postgres://",
        ),
        (
            with("[history]\nstore = \"postgres://me:secret@a/b\"\n"),
            6,
            "unoclp displays it; write \"postgres://gateway@db.example/plant\", and `password`",
        ),
        (
            with("[history]\nstore = \"\"\n"),
            6,
            "`store` cannot be \"\"; choose \"history.db\"",
        ),
        (
            with("[history]\nstore = \"h.db\"\npassword = \"x\"\n"),
            7,
            "a history in a file has no `password`; remove that key",
        ),
        (
            with("[history]\nstore = \"postgres://me@a/b\"\ntls = \"some\"\n"),
            7,
            "`tls` cannot be some; choose \"none\"",
        ),
        (
            with("[history]\nstore = \"h.db\"\n[journal]\nstore = \"h.db\"\n"),
            8,
            "history and journal both use h.db; give each its own file",
        ),
        (
            with("[http]\nlisten = \"127.0.0.1:1\"\ntls = \"some\"\n"),
            7,
            "`tls` cannot be some; choose \"self-signed\", { cert = \"cert.pem\", key = \"key.pem\" }, \"none\"",
        ),
        (
            with("[http]\nlisten = \"127.0.0.1:1\"\ntls = { cert = \"c.pem\" }\n"),
            7,
            "`key` is missing; write `key = \"key.pem\"`",
        ),
        (
            with("[http]\nlisten = \"127.0.0.1:1\"\ntls = 5\n"),
            7,
            "`tls` takes a different kind",
        ),
        (
            with("[journal]\nevery = \"2m\"\n"),
            6,
            "2m is not a time from 10ms to 1m",
        ),
        (
            with("[journal]\nbound = \"10kB\"\n"),
            6,
            "10kB is not a size from 1MB to 1000GB; write \"256MB\"",
        ),
        (
            with("[record]\nbound = 5\n"),
            6,
            "`bound` takes a different kind",
        ),
        (granted("x"), 8, "x names no point; write board and point"),
        (
            granted("y.valve"),
            8,
            "there is no board y; known boards: x",
        ),
        (
            granted("x.flow"),
            8,
            "x has no point flow; you can write target, valve, Q1–Q4",
        ),
        (
            granted("x.level"),
            8,
            "level cannot be written; you can write target, valve",
        ),
        (with("alarm = 5\n"), 5, "there is no key `alarm` here"),
        (
            format!("alarm = 5\n{LINE}"),
            1,
            "`alarm` takes a different kind of value; write `alarm = [{",
        ),
        (
            with("[[alarm]]\nwhen = \"x.I1\"\ntext = \"a\"\n"),
            5,
            "`name` is missing",
        ),
        (
            with("[[alarm]]\nname = \"a b\"\nwhen = \"x.I1\"\ntext = \"a\"\n"),
            6,
            "\"a b\" is not a valid name; use at most 32 letters",
        ),
        (
            with(&(alarm("x.I1") + &alarm("x.I2"))),
            10,
            "two alarms are called a; give each its own name",
        ),
        (
            with("[[alarm]]\nname = \"a\"\ntext = \"a\"\n"),
            5,
            "`when` is missing; write `when = \"estufa.temperature > 80.0\"`",
        ),
        (
            with(&alarm("x.A0")),
            7,
            "this is not a condition in Structured Text: ",
        ),
        (
            with(&alarm("y.A0 > 5")),
            7,
            "this is not a condition in Structured Text: ",
        ),
        (
            with(&alarm("x.level > 5")),
            7,
            "this is not a condition in Structured Text: ",
        ),
        (
            with(&alarm("TRUE")),
            7,
            "this condition reads no point, so it never changes",
        ),
        (
            with(&alarm(&format!("x.I1{}", " OR x.I1".repeat(200)))),
            7,
            "this condition is longer than 1000 characters",
        ),
        (
            with("[[alarm]]\nname = \"a\"\nwhen = \"x.I1\"\ntext = {}\n"),
            8,
            "this alarm has no valid text (one line, at most 200 characters); write `text = {",
        ),
        (
            with("[[alarm]]\nname = \"a\"\nwhen = \"x.I1\"\ntext = \" \"\n"),
            8,
            "this alarm has no valid text",
        ),
        (
            with(&(alarm("x.I1") + "for = \"2d\"\n")),
            9,
            "2d is not a time from 0s to 1d",
        ),
        (
            with(&(alarm("x.I1") + "severity = \"fatal\"\n")),
            9,
            "`severity` cannot be fatal; choose \"low\", \"medium\", \"high\"",
        ),
        (
            with(&panel("gone.toml")),
            6,
            "gone.toml cannot be read (no such file); check its path",
        ),
        (
            with(&panel("picture.png")),
            6,
            "picture.png is not a text file of at most 256 KB",
        ),
        (
            with(&(panel("lamp.panel.toml") + &panel("lamp.panel.toml"))),
            8,
            "two panels are called lamp",
        ),
        (
            with(&panel("other.panel.toml")),
            6,
            "other.panel.toml:3: x has no point M1 to show; known points: I1, I2",
        ),
        (
            with(&panel("turned.panel.toml")),
            6,
            "turned.panel.toml:4: `least` must be below `most`",
        ),
        (
            with(&panel("long.panel.toml")),
            6,
            "long.panel.toml:1: this label is longer than 60 characters",
        ),
        (
            with(&(user(KEY) + &user(KEY))),
            10,
            "two users are called u; give each its own name",
        ),
        (
            with(
                "[[user]]\nname = \"u\"\nrole = \"root\"\nkey = \"KEY\"\n"
                    .replace("KEY", KEY)
                    .as_str(),
            ),
            7,
            "`role` cannot be root; choose \"watch\", \"operate\", \"engineer\"",
        ),
        (
            with(&user("secret")),
            8,
            "this is not a valid user key; run `unoclp site key NAME` to make one",
        ),
        (
            with("[[user]]\nname = \"u\"\nrole = \"watch\"\n"),
            5,
            "`key` is missing",
        ),
    ]
}

/// The key of a token that nobody has.
const KEY: &str = "$argon2id$v=19$m=19456,t=2,p=1$L3hEO3slRORTRquJ6rc2NQ$xsOcju+puetB/lz7kXih3imyoiHWTWIncXuvq3xL00s";

/// An alarm with this condition.
fn alarm(when: &str) -> String {
    format!("[[alarm]]\nname = \"a\"\nwhen = \"{when}\"\ntext = \"it is so\"\n")
}

/// A panel in this file.
fn panel(file: &str) -> String {
    format!("[[panel]]\nfile = \"{file}\"\n")
}

/// A user with this key.
fn user(key: &str) -> String {
    format!("[[user]]\nname = \"u\"\nrole = \"operate\"\nkey = \"{key}\"\n")
}

/// A file that lets write this point.
fn granted(point: &str) -> String {
    format!(
        "{LINE}program = \"tank.st\"\n[modbus]\nlisten = \"127.0.0.1:1502\"\nwrite = [\"{point}\"]\n"
    )
}

#[test]
fn each_mistake_is_refused_with_line_reason_and_remedy() {
    let mut kinds = Vec::new();
    for (text, line, says) in mistakes() {
        let mistakes = of(&text).expect_err(says);
        let told: Vec<String> = mistakes
            .iter()
            .map(|wrong| wrong.text("s.toml", Lang::En))
            .collect();
        assert_eq!(mistakes[0].line, line, "{told:?}\n{text}");
        assert_eq!(mistakes.len(), 1, "{told:?}\n{text}");
        assert!(
            told[0].starts_with(&format!("s.toml:{line}: ")) && told[0].contains(says),
            "{told:?}"
        );
        let portuguese = mistakes[0].text("s.toml", Lang::Pt);
        assert_ne!(portuguese, told[0]);
        // What is wrong with any file has kinds of its own.
        let amiss = match &mistakes[0].wrong {
            Wrong::Keys(amiss) => Some(discriminant(amiss)),
            _ => None,
        };
        kinds.push((discriminant(&mistakes[0].wrong), amiss));
    }
    let different: usize = (0..kinds.len())
        .filter(|&at| !kinds[..at].contains(&kinds[at]))
        .count();
    assert_eq!(different, KINDS);
}

/// The kinds of [`Wrong`]: a new one has its case above.
const KINDS: usize = 48;

#[test]
fn all_mistakes_are_told_at_once_in_the_order_of_the_lines() {
    let text = "[[line]]\nport = \"a\"\nrate = 1\n[[line.board]]\naddress = 300\n[modbus]\nlisten = \"x\"\n";
    let lines: Vec<usize> = of(text)
        .unwrap_err()
        .iter()
        .map(|wrong| wrong.line)
        .collect();
    assert_eq!(lines, [3, 4, 5, 7]);
}

#[test]
fn no_text_brings_the_reader_down() {
    let whole = granted("x.target");
    let mut told = BTreeSet::new();
    for end in 0..whole.len() {
        for broken in [
            whole[..end].to_owned(),
            whole[..end].to_owned() + "\"" + &whole[end..],
        ] {
            told.insert(of(&broken).is_ok());
        }
    }
    assert_eq!(told.len(), 2, "some are right, some are not");
}

#[test]
fn a_right_file_says_what_it_would_do() {
    let text = granted("x.TARGET").replace("[modbus]", "address = 3\nunit = 7\nevery = \"250ms\"\n[history]\nstore = \"h.db\"\nkeep = \"30d\"\n[modbus]")
        + "[http]\nlisten = \"0.0.0.0:80\"\ntls = \"none\"\n[[line]]\ntcp = \"10.0.0.7:502\"\n[[line.board]]\nname = \"y\"\n";
    let site = of(&text).unwrap();
    assert_eq!(
        site.boards().map(|board| board.unit).collect::<Vec<_>>(),
        [7, 1]
    );
    let grant = &site.modbus.as_ref().unwrap().write[0];
    assert_eq!(grant.while_kept, site.lines[0].boards[0].points.program);
    assert_eq!(grant.unit, 7);
    let told = plan(&site, Lang::En);
    for part in [
        "page: http://0.0.0.0:80/, open to the network, not encrypted",
        "line a: 115200 baud, no parity",
        "board x (UNO): address 3, unit 7, read every 250ms",
        "program tank.st: its names (3) apply while the board has the program with checksum ",
        "line 10.0.0.7:502: over Modbus TCP",
        "board y (UNO): address 1, unit 1, read every 500ms",
        "no program: points are called Q1, D5 and so on",
        "history: h.db, every change for 30d, then summaries per minute and per hour",
        "journal: written to disk every 200ms, at most 256MB",
        "Modbus TCP: 127.0.0.1:1502; anyone who can reach this address can write x.TARGET",
    ] {
        assert!(told.contains(part), "{part}\n{told}");
    }
    assert!(plan(&site, Lang::Pt).contains("quem puder acessar este endereço pode escrever"));
}

#[test]
fn a_plan_says_what_a_broker_is_told_and_may_write() {
    let mqtt = "[mqtt]\nbroker = \"mqtt://10.0.0.7\"\nuser = \"u\"\npassword = \"secret\"\n";
    let more = "home_assistant = true\nwrite = [\"x.D1\"]\nsparkplug = { group = \"lab\", host = \"scada\" }\n";
    let site = of(&format!("{LINE}{mqtt}{more}")).unwrap();
    let told = plan(&site, Lang::En);
    for part in [
        "MQTT: mqtt://10.0.0.7:1883, topics under unoclp\n  not encrypted",
        "anyone who may publish to the broker can write x.D1\n  Home Assistant discovers each board\n",
        "group lab, edge node unoclp, while host scada is online",
    ] {
        assert!(told.contains(part), "{part}\n{told}");
    }
    assert!(!format!("{site:?}{told}").contains("secret"));
    let site = of(&format!("{LINE}[mqtt]\nbroker = \"mqtt://localhost\"\n")).unwrap();
    let told = plan(&site, Lang::En);
    assert!(
        told.ends_with("under unoclp\n  the broker cannot write anything\n"),
        "{told}"
    );
}

#[test]
fn a_plan_says_when_alarms_come_and_what_users_may() {
    let more = alarm("X.i1 AND NOT x.UP").replace("\"a\"", "\"door\"")
        + "for = \"90s\"\nseverity = \"high\"\n";
    let site = of(&format!("{LINE}{more}{}{}", alarm("x.A4 > 5"), user(KEY))).unwrap();
    let told = plan(&site, Lang::En);
    for part in [
        "alarm door (high): X.i1 AND NOT x.UP, for 90s\n",
        "alarm a (medium): x.A4 > 5\n",
        "user u: operates, and acknowledges alarms\n",
    ] {
        assert!(told.contains(part), "{part}\n{told}");
    }
    assert!(!format!("{site:?}{told}").contains(KEY));
    let [door, level] = &site.alarms[..] else {
        panic!("{:?}", site.alarms);
    };
    let reads = |of: &unoclp_site::Alarm| -> Vec<_> {
        let reads = of.when.reads.iter();
        reads.map(|(_, of)| (of.point.clone(), of.sort)).collect()
    };
    assert_eq!(
        reads(door),
        [("I1".into(), Sort::Bit), ("up".into(), Sort::Up)]
    );
    assert_eq!(reads(level), [("A4".into(), Sort::Whole)]);
    assert_eq!((&*level.text.en, &*level.text.pt), ("it is so", "it is so"));
    // Each text that is given in one language is said in the other too.
    let one = alarm("x.I1").replace("\"it is so\"", "{ pt = \"\u{e9} assim\" }");
    let site = of(&format!("{LINE}{one}")).unwrap();
    assert_eq!(site.alarms[0].text.of(Lang::En), "\u{e9} assim");
}

#[test]
fn a_point_of_every_board_is_written_whichever_program_it_keeps() {
    for (point, firsts) in [("x.D1", &[2000, 0][..]), ("x.T1", &[128]), ("x.M64", &[79])] {
        let site = of(&granted(point)).unwrap();
        let [grant] = &site.modbus.as_ref().unwrap().write[..] else {
            panic!("{point}");
        };
        assert_eq!(grant.while_kept, None, "{point}");
        let places: Vec<u16> = grant.places.iter().map(|place| place.first).collect();
        assert_eq!(places, firsts, "{point}");
    }
    assert!(matches!(
        of(&granted("x.A0")).unwrap_err()[0].wrong,
        Wrong::ReadOnly { .. }
    ));
}

/// A text that is no TOML at all is told once: it is one mistake.
#[test]
fn what_is_no_toml_is_told_once() {
    for text in ["<html>\n<body>\n<p>\n", &"x\n".repeat(1000)] {
        let told = of(text).unwrap_err();
        assert_eq!((told.len(), told[0].line), (1, 1), "{told:?}");
    }
}
