fn main() { let t = std::fs::read_to_string(std::env::args().nth(1).unwrap()).unwrap(); let s = xtask::shorten::shorten(&t); eprintln!("{s}"); print!("{}", s.text); }
