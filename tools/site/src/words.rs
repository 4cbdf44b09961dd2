//! The words of site files, in the two languages that the tools speak: one table, in which no text is without its twin.
//!
//! Owns the words. Must not know of what they tell.

unoclp_words::messages! {
    no_toml()
        "this is no TOML; check quotes, commas and brackets, and whether a key stands there twice"
        "isto não é TOML; confira aspas, vírgulas e colchetes, e se uma chave aparece duas vezes";
    no_key(key, known)
        "there is no key `{key}` here; there is {known}"
        "não existe aqui a chave `{key}`; existe {known}";
    missing(key, example)
        "the key `{key}` is missing; write `{key} = {example}`"
        "falta a chave `{key}`; escreva `{key} = {example}`";
    kind(key, example)
        "`{key}` takes another kind of value; write `{key} = {example}`"
        "`{key}` pede outro tipo de valor; escreva `{key} = {example}`";
    range(key, from, to)
        "`{key}` is out of its range; give a number from {from} to {to}"
        "`{key}` está fora da faixa; dê um número de {from} a {to}";
    choice(key, given, known)
        "`{key}` cannot be {given}; give {known}"
        "`{key}` não pode ser {given}; dê {known}";
    no_address(given)
        "{given} is no address with a port; write \"127.0.0.1:8420\", or \"0.0.0.0:8420\" for the network"
        "{given} não é um endereço com porta; escreva \"127.0.0.1:8420\", ou \"0.0.0.0:8420\" para a rede";
    no_host(given)
        "{given} is no host with a port; write \"10.0.0.7:502\""
        "{given} não é um computador com porta; escreva \"10.0.0.7:502\"";
    no_time(given, from, to)
        "{given} is no time from {from} to {to}; write \"100ms\", \"5s\", \"2m\", \"1h\" or \"400d\""
        "{given} não é um tempo de {from} a {to}; escreva \"100ms\", \"5s\", \"2m\", \"1h\" ou \"400d\"";
    open(listen)
        "{listen} is open to the network; write `tls = \"self-signed\"` to encrypt what goes over it, `tls = \"none\"` if you trust that network, or listen at 127.0.0.1"
        "{listen} fica aberto para a rede; escreva `tls = \"self-signed\"` para criptografar o que passa por ela, `tls = \"none\"` se confia nessa rede, ou use 127.0.0.1";
    no_line()
        "there is no line; write [[line]] with its port, and [[line.board]] for each board at it"
        "não há nenhuma linha; escreva [[line]] com a porta dela, e [[line.board]] para cada placa nela";
    way_of_line()
        "a line has either a `port` or a `tcp`; write `port = \"/dev/ttyACM0\"` or `tcp = \"10.0.0.7:502\"`"
        "uma linha tem ou uma `port` ou um `tcp`; escreva `port = \"/dev/ttyACM0\"` ou `tcp = \"10.0.0.7:502\"`";
    format_of_tcp(key)
        "a line over TCP has no `{key}`; remove it"
        "uma linha por TCP não tem `{key}`; tire essa chave";
    no_board()
        "this line has no board; write [[line.board]] below it"
        "esta linha não tem nenhuma placa; escreva [[line.board]] abaixo dela";
    two_lines(way)
        "two lines are at {way}; put all its boards below one [[line]]"
        "duas linhas estão em {way}; ponha todas as placas dela abaixo de um só [[line]]";
    name(given)
        "{given} is no name for a board; take a letter, then letters, digits, - or _, at most 32"
        "{given} não é um nome de placa; use uma letra e depois letras, algarismos, - ou _, no máximo 32";
    two_names(name)
        "two boards are called {name}; give each its own name"
        "duas placas se chamam {name}; dê a cada uma o seu nome";
    two_addresses(address, other)
        "{other} on this line has address {address} too; `unoclp settings --set-address` gives a board another"
        "{other} nesta linha também tem o endereço {address}; `unoclp settings --set-address` dá outro a uma placa";
    two_units(unit, other)
        "{other} has unit {unit} too; give each board of the site its own"
        "{other} também tem a unidade {unit}; dê a cada placa da instalação a sua";
    two_servers(address)
        "two servers listen at {address}; give each its own port"
        "dois servidores usam {address}; dê a cada um a sua porta";
    no_broker(given)
        "{given} is no broker; write \"mqtt://10.0.0.7:1883\", or \"mqtts://broker.example:8883\" for an encrypted connection"
        "{given} não é um broker; escreva \"mqtt://10.0.0.7:1883\", ou \"mqtts://broker.example:8883\" para uma conexão criptografada";
    broker_secret()
        "the broker's address holds a user or a password, and addresses are printed; write `user` and `password` below `broker`"
        "o endereço do broker contém usuário ou senha, e endereços são exibidos; escreva `user` e `password` abaixo de `broker`";
    ca_without_tls()
        "a broker at mqtt:// shows no certificate; write mqtts://, or remove `ca`"
        "um broker em mqtt:// não apresenta certificado; escreva mqtts://, ou tire `ca`";
    no_database(given)
        "{given} is no database; write \"history.db\" for a file, or \"postgres://gateway@db.example/plant\""
        "{given} não é um banco de dados; escreva \"history.db\" para um arquivo, ou \"postgres://gateway@db.example/plant\"";
    database_secret()
        "the database's address has more than user, host, port and name, and addresses are printed; write \"postgres://gateway@db.example/plant\", and `password` below it"
        "o endereço do banco tem mais que usuário, computador, porta e nome, e endereços são exibidos; escreva \"postgres://gateway@db.example/plant\", e `password` abaixo dele";
    of_server(key)
        "a history in a file has no `{key}`; remove it"
        "um histórico em arquivo não tem `{key}`; tire essa chave";
    one_file(file)
        "history and journal are both in {file}; give each its own file"
        "o histórico e o diário estão os dois em {file}; dê a cada um o seu arquivo";
    no_size(given)
        "{given} is no size from 1MB to 1000GB; write \"256MB\" or \"4GB\""
        "{given} não é um tamanho de 1MB a 1000GB; escreva \"256MB\" ou \"4GB\"";
    no_user()
        "MQTT takes no password without a user; write `user` too"
        "o MQTT não aceita senha sem usuário; escreva também `user`";
    no_topic(key, given)
        "`{key}` cannot be {given}; use letters, digits, - or _, at most 32"
        "`{key}` não pode ser {given}; use letras, algarismos, - ou _, no máximo 32";
    unreadable(file, why)
        "the program {file} cannot be read ({why}); check its name, which counts from the folder of the site file"
        "não foi possível ler o programa {file} ({why}); confira o nome, que conta da pasta do arquivo de instalação";
    faulty(file)
        "the program {file} has errors; `unoclp check {file}` shows them"
        "o programa {file} tem erros; `unoclp check {file}` os mostra";
    no_path(given)
        "{given} names no point; write board and point, \"estufa.alvo\""
        "{given} não indica um ponto; escreva placa e ponto, \"estufa.alvo\"";
    no_such_board(name, known)
        "there is no board {name}; there is {known}"
        "não existe a placa {name}; existe {known}";
    no_such_point(board, point, known)
        "{board} has no point {point}; what can be written is {known}"
        "{board} não tem o ponto {point}; pode-se escrever em {known}";
    read_only(point, known)
        "{point} cannot be written; what can is {known}"
        "não se pode escrever em {point}; pode-se em {known}";
    no_name(given)
        "{given} cannot be a name here; take a letter, then letters, digits, - or _, at most 32"
        "{given} não pode ser um nome aqui; use uma letra e depois letras, algarismos, - ou _, no máximo 32";
    two_alarms(name)
        "two alarms are called {name}; give each its own name"
        "dois alarmes se chamam {name}; dê a cada um o seu nome";
    no_condition(told, help)
        "this is no condition of Structured Text: {told}{help}; write one like \"estufa.temperature > 80.0 AND NOT estufa.fan\""
        "isto não é uma condição de Texto Estruturado: {told}{help}; escreva uma como \"estufa.temperature > 80.0 AND NOT estufa.fan\"";
    reads_nothing()
        "this condition reads no point, so it never changes; name one, \"estufa.temperature > 80.0\""
        "esta condição não lê nenhum ponto, e por isso nunca muda; indique um, \"estufa.temperature > 80.0\"";
    long_condition(most)
        "this condition is longer than {most} characters; let the program of a board compute a part of it"
        "esta condição tem mais de {most} caracteres; deixe o programa de uma placa calcular uma parte dela";
    no_text()
        "this alarm says nothing; write `text = {{ en = \"too hot\", pt = \"quente demais\" }}`, or one text for both languages"
        "este alarme não diz nada; escreva `text = {{ en = \"too hot\", pt = \"quente demais\" }}`, ou um só texto para as duas línguas";
    two_users(name)
        "two users are called {name}; give each its own name"
        "dois usuários se chamam {name}; dê a cada um o seu nome";
    no_key_of_user()
        "this is no key of a user; `unoclp site key NAME` makes one"
        "isto não é uma chave de usuário; `unoclp site key NOME` cria uma";

    page_here(address)
        "page: http://{address}/, for this PC alone"
        "página: http://{address}/, só para este PC";
    page_here_tls(address)
        "page: https://{address}/, for this PC alone"
        "página: https://{address}/, só para este PC";
    page_open_tls(address)
        "page: https://{address}/, open to the network, encrypted; a token watches, another controls"
        "página: https://{address}/, aberta para a rede, com criptografia; um token observa, outro controla";
    page_open(address)
        "page: http://{address}/, open to the network, not encrypted; a token watches, another controls"
        "página: http://{address}/, aberta para a rede, sem criptografia; um token observa, outro controla";
    serial(port, rate, parity) "line {port}: {rate} baud, {parity}" "linha {port}: {rate} baud, {parity}";
    tcp(server) "line {server}: by Modbus TCP" "linha {server}: por Modbus TCP";
    parity_none() "no parity" "sem paridade";
    parity_even() "even parity" "paridade par";
    parity_odd() "odd parity" "paridade ímpar";
    board(name, address, unit, every)
        "  board {name}: address {address}, unit {unit}, read every {every}"
        "  placa {name}: endereço {address}, unidade {unit}, lida a cada {every}";
    board_program(program, count, sum)
        "    program {program}: its names ({count}) hold while the board keeps check sum {sum}"
        "    programa {program}: os nomes dele ({count}) valem enquanto a placa tiver a soma de verificação {sum}";
    board_alone()
        "    no program: points have their own names"
        "    sem programa: os pontos têm os seus próprios nomes";
    history(store, keep)
        "history: {store}, every change for {keep}, then minutes and hours"
        "histórico: {store}, cada mudança por {keep}, depois minutos e horas";
    history_open()
        "  not encrypted: whoever is on the way there reads it, the password too"
        "  sem criptografia: quem estiver no caminho lê tudo, também a senha";
    journal(every, bound)
        "journal: on disk every {every}, at most {bound}"
        "diário: no disco a cada {every}, no máximo {bound}";
    modbus_reads(address)
        "Modbus TCP: {address}, reading only"
        "Modbus TCP: {address}, só leitura";
    mqtt(broker, topic)
        "MQTT: {broker}, topics below {topic}"
        "MQTT: {broker}, tópicos abaixo de {topic}";
    mqtt_open()
        "  not encrypted: whoever is on the way there reads it, the password too"
        "  sem criptografia: quem estiver no caminho lê tudo, também a senha";
    mqtt_reads() "  nothing can be written by it" "  nada pode ser escrito por ele";
    mqtt_writes(points)
        "  whoever may publish there may write {points}"
        "  quem puder publicar ali pode escrever em {points}";
    home_assistant()
        "  Home Assistant finds each board"
        "  o Home Assistant encontra cada placa";
    sparkplug(group, node)
        "  Sparkplug B: group {group}, edge node {node}"
        "  Sparkplug B: grupo {group}, nó {node}";
    sparkplug_host(group, node, host)
        "  Sparkplug B: group {group}, edge node {node}, while host {host} is online"
        "  Sparkplug B: grupo {group}, nó {node}, enquanto o host {host} estiver on-line";
    alarm(name, severity, when)
        "alarm {name} ({severity}): {when}"
        "alarme {name} ({severity}): {when}";
    alarm_for(name, severity, when, time)
        "alarm {name} ({severity}): {when}, for {time}"
        "alarme {name} ({severity}): {when}, por {time}";
    severity_low() "low" "baixa";
    severity_medium() "medium" "média";
    severity_high() "high" "alta";
    user_watch(name) "user {name}: watches" "usuário {name}: observa";
    user_operate(name)
        "user {name}: operates, and acknowledges alarms"
        "usuário {name}: opera e reconhece alarmes";
    user_engineer(name)
        "user {name}: operates, and changes programs and settings"
        "usuário {name}: opera e muda programas e ajustes";
    modbus_writes(address, points)
        "Modbus TCP: {address}; whoever reaches it may write {points}"
        "Modbus TCP: {address}; quem chegar até ele pode escrever em {points}";
}

#[cfg(test)]
mod tests {
    #[test]
    fn every_text_says_the_same_in_both_languages() {
        assert_eq!(unoclp_words::gaps(super::ALL), [""; 0]);
    }
}
