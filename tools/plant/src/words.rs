//! The words of plants, in the two languages that the tools speak: one table, in which no text is without its twin.
//!
//! Owns the words. Must not know of what they tell.

unoclp_words::messages! {
    range(key, from, to)
        "`{key}` is out of range; use {from} to {to}"
        "`{key}` está fora da faixa; use de {from} a {to}";
    no_number(key, given)
        "`{key}` must be a whole number, but {given} is not one; write one without quotes"
        "`{key}` deve ser um número inteiro, mas {given} não é; escreva um sem aspas";
    no_unit(key, given, known, example)
        "`{key}` must be a number with a unit ({known}), but {given} is not one; write \"{example}\""
        "`{key}` deve ser um número com unidade ({known}), mas {given} não é; escreva \"{example}\"";
    name(given)
        "{given} cannot be the name of a part; use a letter, then letters, digits or _, up to 24 characters, but not a Structured Text keyword"
        "{given} não serve de nome de elemento; use uma letra e depois letras, algarismos ou _, até 24 caracteres, mas não uma palavra-chave do Texto Estruturado";
    two_names(name)
        "two parts are called {name}; give each its own name"
        "dois elementos se chamam {name}; dê a eles nomes diferentes";
    no_part()
        "there are no parts; add a [[part]] with a name and a kind"
        "não há elementos; acrescente um [[part]] com nome e tipo";
    too_many(key, most)
        "there are more than {most} [[{key}]]; delete some"
        "há mais de {most} [[{key}]]; apague alguns";
    no_such_part(name, known)
        "there is no part {name}; known parts: {known}"
        "não existe o elemento {name}; elementos conhecidos: {known}";
    other_kind(name, kind, known)
        "{name} is of kind {kind}; name a part of kind {known}"
        "{name} é do tipo {kind}; indique um elemento do tipo {known}";
    no_such_value(name, value, known)
        "{name} has no value {value}; it has {known}"
        "{name} não tem o valor {value}; tem {known}";
    no_signal(given)
        "{given} cannot drive a part; write an output (\"Q1\"), its PWM (\"P1\") or a value of a part (\"k1.closed\"); add \"not\" before it to invert the value"
        "{given} não pode acionar um elemento; escreva uma saída (\"Q1\"), o PWM dela (\"P1\") ou um valor de um elemento (\"k1.closed\"); ponha \"not\" antes para inverter o valor";
    no_input(given)
        "{given} is not an input; write \"I1\", or \"I1 nc\" for a normally closed contact"
        "{given} não é uma entrada; escreva \"I1\", ou \"I1 nc\" para um contato normalmente fechado";
    no_analogue(given)
        "{given} is not an analogue input; write \"A0\""
        "{given} não é uma entrada analógica; escreva \"A0\"";
    no_point(point, board, known)
        "the {board} has no {point}; it has {known}; choose another, or write `board = \"pc\"`"
        "a placa {board} não tem {point}; tem {known}; escolha outro ponto, ou escreva `board = \"pc\"`";
    two_uses(point, other)
        "{other} also sets {point}; choose another input"
        "{other} também comanda {point}; escolha outra entrada";
    shared_pin(point, other)
        "{point} shares its pin with {other}, which is in use; choose another input"
        "{point} usa o mesmo pino que {other}, que está em uso; escolha outra entrada";
    both_ways(point)
        "{point} is used both with and without PWM; keep one of the two"
        "{point} é usada com e sem PWM; deixe só um dos usos";
    cycle(way)
        "these parts depend on each other in a loop: {way}; remove one of the references"
        "há uma dependência circular entre estes elementos: {way}; tire uma das referências";
    no_condition(told, help)
        "this is not a condition in Structured Text: {told}{help}; write one like \"tank.level > 950 AND NOT drain.open\""
        "isto não é uma condição em Texto Estruturado: {told}{help}; escreva uma como \"tank.level > 950 AND NOT drain.open\"";
    not_by_hand(path, known)
        "{path} cannot be changed by hand; change {known}"
        "{path} não pode ser mudado à mão; mude {known}";
    no_fault(kind, given, known)
        "a part of kind {kind} cannot be {given}; it can be {known}"
        "um elemento do tipo {kind} não pode ter a falha {given}; pode ter {known}";
    never_comes()
        "this fault never occurs; write `at = \"10 s\"` or `when = \"tank.level > 500\"`"
        "esta falha nunca acontece; escreva `at = \"10 s\"` ou `when = \"tank.level > 500\"`";
    too_late(key, until)
        "`{key}` is after the end, at {until}; increase `until`"
        "`{key}` vem depois do fim, em {until}; aumente `until`";
    nothing() "nothing" "nada";
    required() "required" "obrigatório";
    left_out() "optional" "opcional";
    the_kinds() "Kinds of parts" "Tipos de elementos";
    fields() "given" "recebe";
    values() "has" "tem";
    faults() "may be" "pode estar";
    by_hand() "by hand" "à mão";
    damage() "stays true until the reset" "permanece até o reset da máquina";
    flag() "true or false" "verdadeiro ou falso";
    group_panel() "Panel" "Painel";
    group_electric() "Electrical" "Elétrica";
    group_fluid() "Fluid" "Fluidos";
    group_heat() "Heat" "Calor";
    group_motion() "Motion" "Movimento";
    group_transport() "Transport" "Transporte";
    group_traffic() "Traffic" "Trânsito";
    takes_drive() "an output, its PWM or a value" "uma saída, o PWM dela ou um valor";
    takes_input() "an input" "uma entrada";
    takes_analogue() "an analogue input" "uma entrada analógica";
    takes_part(kinds) "a part: {kinds}" "um elemento: {kinds}";
    takes_value() "a value of a part" "um valor de um elemento";
    from_to(from, to) "{from} to {to}" "{from} a {to}";
    usual(value) "default {value}" "padrão {value}";
    never(what) "Never: {what}" "Nunca: {what}";
    longer_than(said, time) "{said}, for longer than {time}" "{said}, por mais de {time}";
    from_then_on(said, time) "{said}, from {time} on" "{said}, a partir de {time}";
    within(time, what) "Within {time}: {what}" "Em até {time}: {what}";
    within_after(time, each, what)
        "Each time (“{each}”), within {time}: {what}"
        "A cada vez (“{each}”), em até {time}: {what}";
    the_time() "the time" "o tempo";
    and() "and" "e";
    or() "or" "ou";
    either() "or else" "ou então";
    not() "not" "não";
    more() "is more than" "é maior que";
    at_least() "is at least" "é no mínimo";
    less() "is less than" "é menor que";
    at_most() "is at most" "é no máximo";
    is() "is" "é";
    is_not() "is not" "não é";
    panel_title() "Control panel" "Painel de comando";
}

#[cfg(test)]
mod tests {
    #[test]
    fn every_text_says_the_same_in_both_languages() {
        assert_eq!(unoclp_words::gaps(super::ALL), [""; 0]);
    }
}
