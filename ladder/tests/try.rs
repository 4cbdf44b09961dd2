//! x
use unoclp_core::*;
use unoclp_ladder::*;
#[test]
fn try_it() {
    for entry in std::env::var("FILES").unwrap().split(' ') {
        let file = std::fs::read(entry).unwrap();
        let mut memory = vec![0; 960];
        let mut loader = Loader::new(&mut memory, Profile::UNO);
        for b in &file { loader.push(*b).unwrap(); }
        let program = loader.finish().unwrap();
        let ladder = Ladder::new(program.steps());
        println!("== {entry}");
        let width = std::env::var("W").map_or(80, |w| w.parse().unwrap());
        let source = Source::new(&file, program.steps());
        let mut names = Names::new();
        if std::env::var("N").is_ok() { names.insert(Address::Input(1), "START".into()); names.insert(Address::Output(1), "motor_forward".into()); names.insert(Address::Timer(1), "run-out time".into()); }
        let drawing = ladder.draw(&Style { width, names: &names, live: &|_| None });
        println!("{}", listing(&drawing, &source, &names));
        let stem = std::path::Path::new(entry).file_stem().unwrap().to_str().unwrap();
        std::fs::write(format!("/tmp/ldr/{stem}.svg"), to_svg(&drawing, &source, &names, source.title.first().map_or(stem, |s| s))).unwrap();
    }
}
