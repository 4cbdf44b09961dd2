//! What is said of a program as a whole, in the two languages that the tools speak.

unoclp_words::messages! {
    size(codes, stored, room, free, parts)
        "{codes}, {stored} of {room} bytes ({free} free), {parts}"
        "{codes}, {stored} de {room} bytes ({free} livres), {parts}";
    run_memory(linked, room, pins)
        "{linked} of {room} bytes of run memory; {pins}"
        "{linked} de {room} bytes de memória de execução; {pins}";
    pins(used) "pins: {used}" "pinos: {used}";
    no_pins() "no pins" "nenhum pino";
    kept_number(minutes)
        "after a power cut: 1 number, at most {minutes} old"
        "após uma queda de energia: 1 número, gravado no máximo {minutes} antes";
    kept_numbers(count, minutes)
        "after a power cut: {count} numbers, at most {minutes} old"
        "após uma queda de energia: {count} números, gravados no máximo {minutes} antes";
    numeric_code() "numeric code" "código numérico";
    either(others, last) "{others} or {last}" "{others} ou {last}";
    minute() "1 minute" "1 minuto";
    minutes(count) "{count} minutes" "{count} minutos";
    code() "1 code" "1 código";
    codes(count) "{count} codes" "{count} códigos";
    timer() "1 timer" "1 temporizador";
    timers(count) "{count} timers" "{count} temporizadores";
    counter() "1 counter" "1 contador";
    counters(count) "{count} counters" "{count} contadores";
    register() "1 register" "1 registrador";
    registers(count) "{count} registers" "{count} registradores";
    marker() "1 marker" "1 memória";
    markers(count) "{count} markers" "{count} memórias";
    seal_changed()
        "this file was changed after unoclp wrote it: its last line gives a different length or checksum"
        "este arquivo foi alterado depois que o unoclp o gravou: a última linha indica outro tamanho ou outra soma de verificação";
    seal_changed_help()
        "if you changed it yourself, delete that line"
        "se foi você que o mudou, apague essa linha";
    seal_cut()
        "the end of this file is missing, and with it a part of the program; a full disk or card can cause this"
        "falta o fim deste arquivo, e com ele uma parte do programa; um disco ou cartão cheio pode causar isso";
    seal_cut_help()
        "write the file again; if you shortened it yourself, delete the comment [unoclp: …] in its first line"
        "grave o arquivo de novo; se foi você que o encurtou, apague o comentário [unoclp: …] na primeira linha";
    lost(parts) "Changes in the drawing remove this from the text: {parts}" "Mudanças no desenho apagam isto do texto: {parts}";
    lost_types() "declarations of types, blocks and arrays" "declarações de tipos, blocos e matrizes";
    lost_dialect(maker) "the mnemonics of {maker}" "os mnemônicos de {maker}";
    lost_comment(first) "the comment “{first}”" "o comentário “{first}”";
    lost_comments(count, first) "{count} lines of comments, such as “{first}”" "{count} linhas de comentários, como “{first}”";
    lacks(board, parts) "the {board} lacks {parts}" "faltam ao {board} {parts}";
    lacks_inputs() "inputs" "as entradas";
    lacks_outputs() "outputs" "as saídas";
    lacks_pwm() "PWM outputs" "as saídas PWM";
    lacks_analogue() "analogue inputs A" "as entradas analógicas A";
    lacks_pins() "separate pins for inputs" "pinos próprios para as entradas";
    lacks_markers() "markers" "as memórias";
    lacks_counters() "counters" "os contadores";
    lacks_labels() "labels" "os rótulos";
    lacks_real() "REAL numbers" "números REAL";
    lacks_stored(bytes) "{bytes} bytes of program memory" "{bytes} bytes de memória de programa";
    lacks_run(bytes) "{bytes} bytes of run memory" "{bytes} bytes de memória de execução";
    fits(board) "it fits the {board}: check it for that board" "ele cabe no {board}: verifique-o para essa placa";
    not_sent(own, why)
        "this program is for the {own}, which is not a board: {why}"
        "este programa é para o {own}, que não é uma placa: {why}";
    more_faults(count) "… and {count} more" "… e mais {count}";
    one_fault(name)
        "{name}: 1 fault; the board will not run this program"
        "{name}: 1 falha; a placa não executa este programa";
    faults(name, count)
        "{name}: {count} faults; the board will not run this program"
        "{name}: {count} falhas; a placa não executa este programa";
}

#[cfg(test)]
mod tests {
    #[test]
    fn every_text_says_the_same_in_both_languages() {
        assert_eq!(unoclp_words::gaps(super::ALL), [""; 0]);
    }
}
