//! A mosquitto on a free port, which can be killed and begun again; and a subscriber of its own clients.

use std::io::{BufRead, BufReader, Write};
use std::net::{TcpListener, TcpStream};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::thread;
use std::time::{Duration, Instant};

/// No test waits for longer: what has not come by then does not come.
const PATIENCE: Duration = Duration::from_secs(20);

/// A broker of these further lines of configuration.
pub struct Broker {
    folder: tempfile::TempDir,
    more: String,
    child: Option<Child>,
    pub port: u16,
}

fn exists(name: &str) -> bool {
    Path::new(name).exists()
}

fn mosquitto() -> &'static str {
    // Debian puts it where only root's path leads.
    match exists("/usr/sbin/mosquitto") {
        true => "/usr/sbin/mosquitto",
        false => "mosquitto",
    }
}

impl Broker {
    pub fn new() -> Broker {
        Broker::of("allow_anonymous true\n", &[])
    }

    /// One with these files in its folder, `{}` in the configuration.
    pub fn of(more: &str, files: &[(&str, &str)]) -> Broker {
        let folder = tempfile::tempdir().unwrap();
        for (name, text) in files {
            std::fs::write(folder.path().join(name), text).unwrap();
        }
        let more = more.replace("{}", folder.path().to_str().unwrap());
        let free = TcpListener::bind("127.0.0.1:0").unwrap();
        let port = free.local_addr().unwrap().port();
        drop(free);
        let mut broker = Broker {
            folder,
            more,
            child: None,
            port,
        };
        broker.begin();
        broker
    }

    /// One at this port.
    pub fn at(port: u16, more: &str) -> Broker {
        let mut broker = Broker {
            folder: tempfile::tempdir().unwrap(),
            more: more.to_owned(),
            child: None,
            port,
        };
        broker.begin();
        broker
    }

    pub fn file(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// Begins it, at the same port each time.
    pub fn begin(&mut self) {
        let conf = self.file("mosquitto.conf");
        let port = self.port;
        // Whoever begins it as root lets it stay root: its folder is root's alone.
        let text = format!(
            "user root\nlistener {port} 127.0.0.1\npersistence false\n{}",
            self.more
        );
        std::fs::write(&conf, text).unwrap();
        let mut child = Command::new(mosquitto())
            .arg("-c")
            .arg(&conf)
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .expect("`cargo xtask setup` brings mosquitto");
        let begun = Instant::now();
        while TcpStream::connect(("127.0.0.1", port)).is_err() {
            assert_eq!(child.try_wait().unwrap(), None, "mosquitto has ended");
            assert!(begun.elapsed() < PATIENCE, "mosquitto takes no connection");
            thread::yield_now();
        }
        self.child = Some(child);
    }

    /// Kills it: it says goodbye to nobody.
    pub fn kill(&mut self) {
        if let Some(mut child) = self.child.take() {
            child.kill().unwrap();
            child.wait().unwrap();
        }
    }

    /// Publishes a message by a client of mosquitto's.
    pub fn publish(&self, topic: &str, payload: &[u8], more: &[&str]) {
        let mut child = Command::new("mosquitto_pub")
            .args(["-h", "127.0.0.1", "-p", &self.port.to_string()])
            .args(["-q", "1", "-t", topic, "-s"])
            .args(more)
            .stdin(Stdio::piped())
            .spawn()
            .expect("`cargo xtask setup` brings mosquitto-clients");
        child.stdin.take().unwrap().write_all(payload).unwrap();
        assert!(child.wait().unwrap().success());
    }
}

impl Drop for Broker {
    fn drop(&mut self) {
        self.kill();
    }
}

/// A message as mosquitto's subscriber hears it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Heard {
    pub topic: String,
    /// It was kept from before.
    pub retained: bool,
    pub qos: u8,
    /// The payload in hexadecimal digits.
    pub hex: String,
}

impl Heard {
    pub fn text(&self) -> String {
        let digits: Vec<char> = self.hex.chars().collect();
        let byte = |two: &[char]| {
            let two: String = two.iter().collect();
            u8::from_str_radix(&two, 16).unwrap()
        };
        String::from_utf8(digits.chunks(2).map(byte).collect()).unwrap()
    }
}

/// A subscriber.
pub struct Listener {
    child: Child,
    lines: Receiver<Heard>,
}

impl Listener {
    /// Hears these topics from now on; it is there once the broker has confirmed it.
    pub fn new(broker: &Broker, filter: &str) -> Listener {
        let mut child = Command::new("stdbuf")
            .args(["-oL", "mosquitto_sub", "-d", "-h", "127.0.0.1"])
            .args(["-p", &broker.port.to_string(), "-q", "1", "-t", filter])
            .args(["-F", "= %t %r %q %x"])
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("`cargo xtask setup` brings mosquitto-clients");
        let out = BufReader::new(child.stdout.take().unwrap());
        let (send, lines) = channel();
        let (there, is_there) = channel();
        thread::spawn(move || {
            for line in out.lines().map_while(Result::ok) {
                if line.starts_with("Subscribed") {
                    let _ = there.send(());
                }
                let Some(line) = line.strip_prefix("= ") else {
                    continue;
                };
                let mut parts = line.split(' ');
                let mut next = || parts.next().unwrap_or_default().to_owned();
                let heard = Heard {
                    topic: next(),
                    retained: next() == "1",
                    qos: next().parse().unwrap(),
                    hex: next(),
                };
                // After the end of the test nobody listens.
                let _ = send.send(heard);
            }
        });
        is_there.recv_timeout(PATIENCE).expect("it is subscribed");
        Listener { child, lines }
    }

    pub fn next(&self) -> Heard {
        self.lines.recv_timeout(PATIENCE).expect("more is said")
    }

    /// The next message whose topic ends so.
    pub fn next_at(&self, end: &str) -> Heard {
        loop {
            let heard = self.next();
            if heard.topic.ends_with(end) {
                return heard;
            }
        }
    }

    /// Reads until this has been said at a topic that ends so.
    pub fn until(&self, end: &str, text: &str) {
        while !self.next_at(end).text().contains(text) {}
    }
}

impl Drop for Listener {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
