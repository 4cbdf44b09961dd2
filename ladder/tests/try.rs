use unoclp_core::*;
use unoclp_ladder::*;
#[test]
fn try_it() {
    for entry in std::env::var("FILES").unwrap().split(' ') {
        let file = std::fs::read(entry).unwrap();
        let mut memory = vec![0; 960];
        let mut loader = Loader::new(&mut memory, Profile::UNO);
        for b in file { loader.push(b).unwrap(); }
        let program = loader.finish().unwrap();
        let ladder = Ladder::new(program.steps());
        println!("== {entry}");
        let width = std::env::var("W").map_or(80, |w| w.parse().unwrap());
        for rung in &ladder.draw(&Style { width, names: &Names::new(), live: &|_| None }).rungs {
            println!("{rung}");
        }
    }
}
