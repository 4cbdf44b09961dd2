//! The words of scenarios, in the two languages that the tools speak: one table, in which no text is without its twin.
//!
//! Owns the words. Must not know of what they tell.

unoclp_words::messages! {
    too_long(most)
        "is longer than {most} bytes; no program or scenario is that long"
        "passa de {most} bytes; nenhum programa ou cenário é tão longo";
    not_read(error) "cannot be read: {error}" "não pode ser lido: {error}";
    the_file(why) "the file {why}" "o arquivo {why}";
    no_toml() "this is not valid TOML; check quotes, commas and brackets" "isto não é TOML válido; confira aspas, vírgulas e colchetes";
    no_key(key, valid) "there is no key `{key}` here; known keys: {valid}" "não existe a chave `{key}` aqui; chaves conhecidas: {valid}";
    missing_key(key) "the key `{key}` is missing" "falta a chave `{key}`";
    key_twice() "this key appears twice" "esta chave aparece duas vezes";
    wrong_kind() "this value has the wrong type" "este valor não é do tipo que a chave pede";
    key_in_step(told)
        "{told}; put file-wide keys above the first [[step]]"
        "{told}; ponha as chaves gerais do arquivo acima do primeiro [[step]]";
    a_text()
        "write `text` as a string, or as a list of strings and {{ repeat = 3, text = \"…\" }}"
        "escreva `text` como uma string, ou como uma lista de strings e {{ repeat = 3, text = \"…\" }}";
    both_languages()
        "write text as \"…\" or {{ en = \"…\", pt = \"…\" }}, or with only one of the two languages"
        "escreva um texto como \"…\" ou {{ en = \"…\", pt = \"…\" }}, ou em só uma das duas línguas";
    is_a_folder() "is a folder; name a file in it" "é uma pasta; indique um arquivo dela";
    no_file()
        "is a device or a pipe, which may never end; name a file"
        "é um dispositivo ou um pipe, que talvez nunca termine; indique um arquivo";
    no_scenario(told)
        "{told}; a scenario is a file in TOML (.toml)"
        "{told}; um cenário é um arquivo em TOML (.toml)";
    too_many_scans(scans, most)
        "this scenario would take {scans} scans, but all cases of a file together may take {most}; end it earlier (`until`), or increase `scan_ms`"
        "este cenário levaria {scans} varreduras, mas os casos de um arquivo podem somar {most}; termine antes (`until`) ou aumente `scan_ms`";
    program(name, why) "the program {name} {why}" "o programa {name} {why}";
    has_errors() "has errors; `unoclp check` shows them" "tem erros; `unoclp check` os mostra";
    no_program()
        "the scenario names no program; give a file: `sim FILE --scenario S.toml`"
        "o cenário não indica um programa; indique um arquivo: `sim ARQUIVO --scenario S.toml`";
    given_alone()
        "write `given` and `answer_in` together: a program, and the language for the answer"
        "escreva `given` e `answer_in` juntos: um programa e a linguagem da resposta";
    no_language(names)
        "`answer_in` names no language; write {names}"
        "`answer_in` não indica uma linguagem; escreva {names}";
    faulty_given()
        "the program in `given` has errors; `unoclp check` shows them"
        "o programa em `given` tem erros; `unoclp check` os mostra";
    find_without()
        "[find] hides a fault; name its machine with `plant`"
        "[find] esconde uma falha; indique a máquina dela com `plant`";
    seeds_without()
        "`seeds` are random seeds of a machine; name the machine with `plant`"
        "`seeds` são sementes aleatórias de uma máquina; indique a máquina com `plant`";
    many_seeds(most)
        "`seeds` has more than {most} numbers; remove some"
        "`seeds` tem mais de {most} números; tire alguns";
    hidden_chance(seed, why)
        "with hidden random values (seed {seed}): {why}"
        "com valores aleatórios ocultos (semente {seed}): {why}";
    two_programs()
        "`program` and `text` both give a program; keep one of them"
        "tanto `program` quanto `text` indicam um programa; deixe só um dos dois";
    long_text(most) "`text` is longer than {most} bytes" "`text` passa de {most} bytes";
    fault_and_steps()
        "a scenario that expects a `fault` does not run its program; remove `fault`, or the steps and `until`"
        "um cenário que espera uma falha (`fault`) não executa o programa; tire `fault`, ou os passos e `until`";
    no_fault(number)
        "there is no fault {number}; docs/faults.md lists them"
        "não existe a falha {number}; docs/faults.pt-BR.md lista todas";
    line_zero()
        "count lines from 1; omit `line` if the fault has no line"
        "conte as linhas a partir de 1; omita `line` se a falha não tem linha";
    no_period() "`scan_ms` must be 1 or more" "`scan_ms` deve ser 1 ou mais";
    ends_early(last)
        "`until` comes before the last step, at {last} ms"
        "`until` vem antes do último passo, aos {last} ms";
    no_board(name, known)
        "there is no board \"{name}\"; known boards: {known}"
        "não existe a placa \"{name}\"; placas conhecidas: {known}";
    cases_and_steps()
        "in a file with [[case]], the steps and `until` belong in the cases; move them there"
        "com [[case]] no arquivo, os passos e `until` ficam nos casos; passe-os para lá";
    several_cases(count)
        "the scenario has {count} cases, but only one can run here"
        "o cenário tem {count} casos, mas aqui só se executa um";
    not_named(name, inputs, analogue, outputs, markers, registers)
        "{name} is not a point; the points are I1 to I{inputs}, A0 to A{analogue}, Q1 to Q{outputs}, P1, P4, M1 to M{markers} and D1 to D{registers}"
        "{name} não é um ponto; os pontos são I1 a I{inputs}, A0 a A{analogue}, Q1 a Q{outputs}, P1, P4, M1 a M{markers} e D1 a D{registers}";
    nothing_happens()
        "nothing happens in this scenario; write a [[step]] or the expected `fault`"
        "nada acontece neste cenário; escreva um [[step]], ou a falha esperada em `fault`";
    goes_on()
        "the run ends at `stops`; remove `until` and later steps"
        "a execução termina em `stops`; tire `until` e os passos seguintes";
    no_scan(at, period)
        "no scan starts at {at} ms; scans start every {period} ms (`scan_ms`)"
        "nenhuma varredura começa aos {at} ms; começa uma a cada {period} ms (`scan_ms`)";
    order(at, last)
        "the step at {at} ms is not later than the one at {last} ms; put the steps in chronological order"
        "o passo aos {at} ms não é posterior ao de {last} ms; ponha os passos em ordem cronológica";
    not_set(name, inputs, analogue, markers, registers)
        "{name} cannot be set; set I1 to I{inputs}, A0 to A{analogue}, M1 to M{markers} or D1 to D{registers}"
        "{name} não pode receber um valor; use I1 a I{inputs}, A0 a A{analogue}, M1 a M{markers} ou D1 a D{registers}";
    not_expected(name, outputs, markers, registers)
        "a test cannot check {name}; use Q1 to Q{outputs}, M1 to M{markers}, D1 to D{registers}, P1 or P4"
        "um teste não pode verificar {name}; use Q1 a Q{outputs}, M1 a M{markers}, D1 a D{registers}, P1 ou P4";
    must_be(name, valid) "{name} must be {valid}" "{name} deve ser {valid}";
    zero_or_one() "0 or 1" "0 ou 1";
    number_from(from, to) "a number from {from} to {to}" "um número de {from} a {to}";
    or_any(valid) "{valid}, or \"any\"" "{valid}, ou \"any\"";

    the_program(name) "program: {name}" "programa: {name}";
    legend() "1 = closed, on; · = open, off" "1 = fechada, ligada; · = aberta, desligada";
    passed() "PASS" "PASSOU";
    failed() "FAIL" "FALHOU";
    nothing_expected() "the program ran; nothing was expected" "o programa rodou; nada era esperado";
    refused_as_expected(fault) "refused as expected: {fault}" "recusado como esperado: {fault}";
    stopped_as_expected(at, fault)
        "stopped as expected at {at} ms: {fault}"
        "parou como esperado aos {at} ms: {fault}";
    expected(what) "expected {what}" "esperado: {what}";
    came(what) "got      {what}" "obtido:   {what}";
    at_time(at, what) "at {at} ms {what}" "aos {at} ms, {what}";
    that_it_runs() "the program to run" "o programa em execução";
    that_it_runs_on() "the program to keep running" "o programa ainda em execução";
    but_ran_on() "but the program kept running" "mas o programa continuou";
    but_accepted() "but the program was accepted" "mas o programa foi aceito";
    unmet(place, from, expected, came)
        "{place} at {from} ms: expected {expected}, got {came}"
        "{place} aos {from} ms: esperado {expected}, obtido {came}";
    unmet_until(unmet, to) "{unmet} (until {to} ms)" "{unmet} (até {to} ms)";
    more(count) "… and {count} more" "… e mais {count}";
    while_loaded(reason)
        "while the program was loaded: {reason}"
        "enquanto o programa era carregado: {reason}";
    broken_at(at, reason) "at {at} ms: {reason}" "aos {at} ms: {reason}";
    fault(number) "fault {number}" "falha {number}";
    fault_in_line(number, line) "fault {number}, line {line}" "falha {number}, linha {line}";
    rule_broken(at, text) "at {at} a rule was broken: {text}" "aos {at} uma regra foi violada: {text}";
    goal_missed(at, text, since)
        "at {at} a goal was missed: {text} (since {since})"
        "aos {at} uma meta não foi atingida: {text} (desde {since})";
    stopped_in(at, fault)
        "at {at} the program stopped: {fault}"
        "aos {at} o programa parou: {fault}";
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_text_says_the_same_in_both_languages() {
        assert_eq!(unoclp_words::gaps(ALL), [""; 0]);
    }
}
