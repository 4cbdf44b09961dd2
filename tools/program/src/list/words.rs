//! The words of listings, in the two languages that the tools speak: one table, in which no text is without its twin.
//!
//! Owns the words. Must not know what a listing looks like.

unoclp_words::messages! {
    rung(number) "Rung {number}" "Degrau {number}";
    rung_line(number, line) "Rung {number}, line {line}" "Degrau {number}, linha {line}";
    rung_lines(number, from, to)
        "Rung {number}, lines {from} to {to}"
        "Degrau {number}, linhas {from} a {to}";
    writer() "Name:" "Nome:";
    date() "Date:" "Data:";
    page(page, pages) "Page {page} of {pages}" "Página {page} de {pages}";
    points() "Points" "Pontos";
    point() "point" "ponto";
    name() "name" "nome";
    rungs() "rungs" "degraus";
    program_start() "program start" "início do programa";
    operand() "operand" "operando";
    register() "register XX" "registrador XX";
    preset(value) "preset: {value}" "pré-seleção: {value}";
    preset_ms(value) "preset: {value} ms" "pré-seleção: {value} ms";
    calls_again(timer) "calls {timer} again" "chama {timer} de novo";
    drives(target) "drives {target}" "aciona {target}";
    constant() "the constant" "a constante";
    popped() "value (the pushed value comes first)" "valor (o empilhado vem antes)";
    to_registers(first) "to {first} onwards" "a partir de {first}";
    so_many_registers() "number of registers" "número de registradores";
    so_many_steps() "number of steps" "número de passos";
    outputs_of(step) "step {step}: outputs 01 02 03 04" "passo {step}: saídas 01 02 03 04";
    from_this() "input: from this …" "entrada: deste valor …";
    to_this() "… to this" "… até este";
    becomes_from() "output: from this …" "saída: deste valor …";
    filter_time(value) "time: {value} ms" "tempo: {value} ms";
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_text_says_the_same_in_both_languages() {
        assert_eq!(unoclp_words::gaps(ALL), [""; 0]);
    }
}
