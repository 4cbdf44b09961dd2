use annotate_snippets::Renderer;
fn main() {
    for path in std::env::args().skip(1) {
        let text = std::fs::read_to_string(&path).unwrap();
        let c = unoclp_lang::compile(&text, &Default::default());
        println!("== {path} {} {} codes", c.dialect, c.lines.len());
        print!(
            "{}",
            unoclp_lang::show(
                &path,
                &text,
                &c.diagnostics,
                unoclp_lang::Lang::En,
                &Renderer::plain()
            )
        );
        let l: Vec<String> = c
            .lines
            .iter()
            .map(|l| {
                if l.letters.is_empty() {
                    l.code.to_string()
                } else {
                    l.letters.clone()
                }
            })
            .collect();
        println!("{}", l.join(" | "));
    }
}
