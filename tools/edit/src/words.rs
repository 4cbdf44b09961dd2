//! What is told of a drawing in words.

unoclp_words::messages! {
    unfinished() "the drawing is not complete; the list of problems shows what is missing" "o desenho não está completo; a lista de problemas mostra o que falta";
    no_element(id) "no element is called {id}" "nenhum elemento se chama {id}";
    no_field(key) "this element has no field {key}" "este elemento não tem o campo {key}";
    no_drawing() "no drawing is open" "nenhum desenho está aberto";
    select_one() "select one element first" "selecione um elemento primeiro";
    no_name(name) "{name} cannot be a name; use letters, digits and _, but not an address" "{name} não serve de nome; use letras, algarismos e _, mas não um endereço";
    no_address(text) "{text} is not an address; write one such as I1, Q1 or M1" "{text} não é um endereço; escreva um como I1, Q1 ou M1";
    no_such_point(name) "no point is called {name}; write an address, such as I1, and the name after it: I1 {name}" "nenhum ponto se chama {name}; escreva o endereço, como I1, e o nome depois dele: I1 {name}";
    system_marker(name) "{name} is a system marker of the board, not a button. Which one do you mean?" "{name} é uma memória de sistema da placa, não um botão. Qual dos dois você quer?";
    is_system_marker(name) "{name}, the system marker" "{name}, a memória de sistema";
    timer_drives(name) "{name} is the timer itself, numbered by its position. Enter the output or marker that it drives" "{name} é o próprio temporizador, numerado pela posição. Indique a saída ou a memória que ele aciona";
    free_point(point) "{point}, which is free" "{point}, que está livre";
    no_time(text) "{text} is not a time; write one such as 4000 (ms), 4s or T#1m30s" "{text} não é um tempo; escreva um como 4000 (ms), 4s ou T#1m30s";
    no_number(text) "{text} is not a number, a register, an analogue input, a timer or a counter that fits here" "{text} não é um número, registrador, entrada analógica, temporizador ou contador que sirva aqui";
    contacts() "Contacts" "Contatos";
    coils() "Coils" "Bobinas";
    timers() "Timers" "Temporizadores";
    counters() "Counters" "Contadores";
    comparisons() "Comparisons" "Comparações";
    arithmetic() "Arithmetic" "Aritmética";
    others() "Others" "Outros";
    contact() "contact, normally open" "contato normalmente aberto";
    closed() "contact, normally closed" "contato normalmente fechado";
    rising() "contact, rising edge" "contato de borda de subida";
    falling() "contact, falling edge" "contato de borda de descida";
    not() "NOT: inverts the power flow" "NOT: inverte o fluxo de energia";
    coil() "coil" "bobina";
    negated() "negated coil" "bobina negada";
    set() "set coil" "bobina set";
    reset() "reset coil" "bobina reset";
    ton() "on-delay timer (TON)" "temporizador com retardo na energização (TON)";
    tof() "off-delay timer (TOF)" "temporizador com retardo na desenergização (TOF)";
    tp() "pulse timer (TP)" "temporizador de pulso (TP)";
    tonr() "retentive on-delay timer" "temporizador retentivo com retardo na energização";
    ctu() "up counter (CTU)" "contador crescente (CTU)";
    ctd() "down counter (CTD)" "contador decrescente (CTD)";
    gt() "greater" "maior";
    ge() "greater or equal" "maior ou igual";
    eq() "equal" "igual";
    ne() "not equal" "diferente";
    le() "less or equal" "menor ou igual";
    lt() "less" "menor";
    value() "load a value" "carregar um valor";
    add() "add" "somar";
    sub() "subtract" "subtrair";
    mul() "multiply" "multiplicar";
    div() "divide" "dividir";
    modulo() "remainder" "resto da divisão";
    store() "store the value" "guardar o valor";
    left() "Compared value" "Valor comparado";
    operand() "With" "Com";
    drives() "Drives" "Aciona";
    point() "Point" "Ponto";
    number() "Number" "Número";
    name() "Name" "Nome";
    preset_ms() "Preset, ms" "Pré-seleção, ms";
    preset() "Preset" "Pré-seleção";
    operand_line(n) "Operand {n}" "Operando {n}";
    at_rung(rung, about) "rung {rung} {about}" "degrau {rung} {about}";
    at_run(count, rung) "{count} elements selected, rung {rung}" "{count} elementos selecionados, degrau {rung}";
    at_element(what, rung) "{what}, rung {rung}" "{what}, degrau {rung}";
    at_path(rung) "empty branch, rung {rung}" "ramo vazio, degrau {rung}";
    at_branch(rung) "the whole branch, rung {rung}" "o ramo inteiro, degrau {rung}";
    say_open(point) "contact {point}, normally open" "contato {point}, normalmente aberto";
    say_closed(point) "contact {point}, normally closed" "contato {point}, normalmente fechado";
    say_coil(letter, point) "coil {letter} {point}" "bobina {letter} {point}";
}

#[cfg(test)]
mod tests {
    #[test]
    fn every_text_says_the_same_in_both_languages() {
        let none: Vec<&str> = Vec::new();
        assert_eq!(unoclp_words::gaps(super::ALL), none);
    }
}
