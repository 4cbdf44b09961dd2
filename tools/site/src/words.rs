//! The words of site files, in the two languages that the tools speak: one table, in which no text is without its twin.
//!
//! Owns the words. Must not know of what they tell.

unoclp_words::messages! {
    range(key, from, to)
        "`{key}` is out of range; use a number from {from} to {to}"
        "`{key}` está fora da faixa; use um número de {from} a {to}";
    no_address(given)
        "{given} is not an address with a port; write \"127.0.0.1:8420\", or \"0.0.0.0:8420\" for the network"
        "{given} não é um endereço com porta; escreva \"127.0.0.1:8420\", ou \"0.0.0.0:8420\" para a rede";
    no_host(given)
        "{given} is not a host with a port; write \"10.0.0.7:502\""
        "{given} não é um host com porta; escreva \"10.0.0.7:502\"";
    no_time(given, from, to)
        "{given} is not a time from {from} to {to}; write \"100ms\", \"5s\", \"2m\", \"1h\" or \"400d\""
        "{given} não é um tempo de {from} a {to}; escreva \"100ms\", \"5s\", \"2m\", \"1h\" ou \"400d\"";
    open(listen)
        "{listen} is open to the network; write `tls = \"self-signed\"` to encrypt its traffic, `tls = \"none\"` if you trust the network, or listen on 127.0.0.1"
        "{listen} fica aberto para a rede; escreva `tls = \"self-signed\"` para criptografar o tráfego, `tls = \"none\"` se confia nessa rede, ou use 127.0.0.1";
    no_line()
        "there are no lines; add a [[line]] with its port, and a [[line.board]] for each board on it"
        "não há linhas; acrescente um [[line]] com a porta, e um [[line.board]] para cada placa nela";
    way_of_line()
        "a line has either `port` or `tcp`; write `port = \"/dev/ttyACM0\"` or `tcp = \"10.0.0.7:502\"`"
        "uma linha tem `port` ou `tcp`, e só um dos dois; escreva `port = \"/dev/ttyACM0\"` ou `tcp = \"10.0.0.7:502\"`";
    format_of_tcp(key)
        "a line over TCP has no `{key}`; remove it"
        "uma linha por TCP não tem `{key}`; tire essa chave";
    no_board()
        "this line has no boards; add a [[line.board]] below it"
        "esta linha não tem placas; acrescente um [[line.board]] abaixo dela";
    two_lines(way)
        "two lines use {way}; put their boards under one [[line]]"
        "duas linhas usam {way}; ponha todas as placas abaixo de um só [[line]]";
    name(given)
        "{given} cannot be the name of a board; use at most 32 letters, digits, - or _, and start with a letter"
        "{given} não serve de nome de placa; use no máximo 32 letras, algarismos, - ou _, e comece com uma letra";
    two_names(name)
        "two boards are called {name}; give each its own name"
        "duas placas se chamam {name}; dê a elas nomes diferentes";
    two_addresses(address, other)
        "{other} on this line also has address {address}; give one board a different address with `unoclp settings --set-address`"
        "{other}, nesta linha, também tem o endereço {address}; dê outro endereço a uma das placas com `unoclp settings --set-address`";
    two_units(unit, other)
        "{other} also has unit {unit}; give each board of the site its own unit"
        "{other} também tem a unidade {unit}; dê a cada placa da instalação uma unidade própria";
    two_servers(address)
        "two servers listen on {address}; give each its own port"
        "dois servidores usam {address}; dê a cada um uma porta própria";
    no_broker(given)
        "{given} is not a broker's address; write \"mqtt://10.0.0.7:1883\", or \"mqtts://broker.example:8883\" for an encrypted connection"
        "{given} não é o endereço de um broker; escreva \"mqtt://10.0.0.7:1883\", ou \"mqtts://broker.example:8883\" para uma conexão criptografada";
    broker_secret()
        "the broker's address must not have a user or a password, because unoclp displays it; write `user` and `password` below `broker`"
        "o endereço do broker não pode ter usuário nem senha, porque o unoclp o exibe; escreva `user` e `password` abaixo de `broker`";
    ca_without_tls()
        "a broker at mqtt:// presents no certificate; write mqtts://, or remove `ca`"
        "um broker em mqtt:// não apresenta certificado; escreva mqtts://, ou tire `ca`";
    no_database(given)
        "{given} is not a database; write \"history.db\" for a file, or \"postgres://gateway@db.example/plant\""
        "{given} não é um banco de dados; escreva \"history.db\" para um arquivo, ou \"postgres://gateway@db.example/plant\"";
    database_secret()
        "the database's address may only have a user, host, port and name, because unoclp displays it; write \"postgres://gateway@db.example/plant\", and `password` below it"
        "o endereço do banco só pode ter usuário, host, porta e nome, porque o unoclp o exibe; escreva \"postgres://gateway@db.example/plant\", e `password` abaixo dele";
    of_server(key)
        "a history in a file has no `{key}`; remove that key"
        "um histórico em arquivo não tem `{key}`; tire essa chave";
    one_file(file)
        "history and journal both use {file}; give each its own file"
        "o histórico e o diário usam o mesmo arquivo, {file}; dê a cada um um arquivo próprio";
    no_size(given)
        "{given} is not a size from 1MB to 1000GB; write \"256MB\" or \"4GB\""
        "{given} não é um tamanho de 1MB a 1000GB; escreva \"256MB\" ou \"4GB\"";
    no_user()
        "MQTT does not accept a password without a user; write `user` too"
        "o MQTT não aceita senha sem usuário; escreva também `user`";
    no_topic(key, given)
        "`{key}` cannot be {given}; use at most 32 letters, digits, - or _"
        "`{key}` não pode ser {given}; use no máximo 32 letras, algarismos, - ou _";
    unreadable(file, why)
        "the program {file} cannot be read ({why}); check its path, which is relative to the folder of the site file"
        "não foi possível ler o programa {file} ({why}); confira o caminho, relativo à pasta do arquivo de instalação";
    faulty(file)
        "the program {file} has errors; `unoclp check {file}` shows them"
        "o programa {file} tem erros; `unoclp check {file}` os mostra";
    no_path(given)
        "{given} names no point; write board and point, like \"estufa.alvo\""
        "{given} não indica um ponto; escreva placa e ponto, como \"estufa.alvo\"";
    no_such_board(name, known)
        "there is no board {name}; known boards: {known}"
        "não existe a placa {name}; placas conhecidas: {known}";
    no_such_point(board, point, known)
        "{board} has no point {point}; you can write {known}"
        "{board} não tem o ponto {point}; você pode escrever em {known}";
    read_only(point, known)
        "{point} cannot be written; you can write {known}"
        "não se pode escrever em {point}; você pode escrever em {known}";
    no_name(given)
        "{given} is not a valid name; use at most 32 letters, digits, - or _, and start with a letter"
        "{given} não é um nome válido; use no máximo 32 letras, algarismos, - ou _, e comece com uma letra";
    two_alarms(name)
        "two alarms are called {name}; give each its own name"
        "dois alarmes se chamam {name}; dê a eles nomes diferentes";
    no_condition(told, help)
        "this is not a condition in Structured Text: {told}{help}; write one like \"estufa.temperature > 80.0 AND NOT estufa.fan\""
        "isto não é uma condição em Texto Estruturado: {told}{help}; escreva uma como \"estufa.temperature > 80.0 AND NOT estufa.fan\"";
    reads_nothing()
        "this condition reads no point, so it never changes; use one, as in \"estufa.temperature > 80.0\""
        "esta condição não lê nenhum ponto, e por isso nunca muda; use um, como em \"estufa.temperature > 80.0\"";
    long_condition(most)
        "this condition is longer than {most} characters; move part of it into the program of a board"
        "esta condição tem mais de {most} caracteres; passe uma parte dela para o programa de uma placa";
    no_text()
        "this alarm has no valid text (one line, at most 200 characters); write `text = {{ en = \"too hot\", pt = \"quente demais\" }}`, or one text for both languages"
        "este alarme não tem um texto válido (uma linha, no máximo 200 caracteres); escreva `text = {{ en = \"too hot\", pt = \"quente demais\" }}`, ou um só texto para os dois idiomas";
    no_panel(file, why)
        "{file} cannot be read ({why}); check its path, which is relative to the folder of the site file"
        "não foi possível ler {file} ({why}); confira o caminho, relativo à pasta do arquivo de instalação";
    no_text_file(file)
        "{file} is not a text file of at most 256 KB; save it as UTF-8, and remove any pictures"
        "{file} não é um arquivo de texto de até 256 KB; salve-o em UTF-8 e tire as imagens";
    two_panels(name)
        "two panels are called {name}; give each file its own name"
        "dois painéis se chamam {name}; dê aos arquivos nomes diferentes";
    not_recorded(board, point, known)
        "{board} has no point {point} to show; known points: {known}"
        "{board} não tem o ponto {point} para mostrar; pontos conhecidos: {known}";
    no_range()
        "`least` must be below `most`; their defaults are 0 and 100"
        "`least` deve ser menor que `most`; os valores padrão são 0 e 100";
    long_label(most)
        "this label is longer than {most} characters; write a shorter one"
        "este rótulo tem mais de {most} caracteres; escreva um mais curto";
    two_users(name)
        "two users are called {name}; give each its own name"
        "dois usuários se chamam {name}; dê a eles nomes diferentes";
    no_key_of_user()
        "this is not a valid user key; run `unoclp site key NAME` to make one"
        "esta não é uma chave de usuário válida; crie uma com `unoclp site key NOME`";

    page_here(address)
        "page: http://{address}/, for this PC only"
        "página: http://{address}/, só para este PC";
    page_here_tls(address)
        "page: https://{address}/, for this PC only"
        "página: https://{address}/, só para este PC";
    page_open_tls(address)
        "page: https://{address}/, open to the network, encrypted; every visitor needs a token"
        "página: https://{address}/, aberta para a rede, com criptografia; cada visitante precisa de um token";
    page_open(address)
        "page: http://{address}/, open to the network, not encrypted; every visitor needs a token"
        "página: http://{address}/, aberta para a rede, sem criptografia; cada visitante precisa de um token";
    serial(port, rate, parity) "line {port}: {rate} baud, {parity}" "linha {port}: {rate} baud, {parity}";
    tcp(server) "line {server}: over Modbus TCP" "linha {server}: por Modbus TCP";
    parity_none() "no parity" "sem paridade";
    parity_even() "even parity" "paridade par";
    parity_odd() "odd parity" "paridade ímpar";
    board(name, kind, address, unit, every)
        "  board {name} ({kind}): address {address}, unit {unit}, read every {every}"
        "  placa {name} ({kind}): endereço {address}, unidade {unit}, lida a cada {every}";
    board_program(program, count, sum)
        "    program {program}: its names ({count}) apply while the board has the program with checksum {sum}"
        "    programa {program}: os nomes dele ({count}) valem enquanto a placa tiver o programa com a soma de verificação {sum}";
    board_alone()
        "    no program: points are called Q1, D5 and so on"
        "    sem programa: os pontos se chamam Q1, D5 e assim por diante";
    history(store, keep)
        "history: {store}, every change for {keep}, then summaries per minute and per hour"
        "histórico: {store}, cada mudança por {keep}, depois resumos por minuto e por hora";
    history_open()
        "  not encrypted: anyone on the network path can read everything, including the password"
        "  sem criptografia: quem tem acesso ao tráfego da rede pode ler tudo, inclusive a senha";
    journal(every, bound)
        "journal: written to disk every {every}, at most {bound}"
        "diário: gravado em disco a cada {every}, no máximo {bound}";
    record(bound)
        "record: at most {bound}; then the oldest half is deleted"
        "livro de ocorrências: no máximo {bound}; depois a metade mais antiga é apagada";
    modbus_reads(address)
        "Modbus TCP: {address}, read-only"
        "Modbus TCP: {address}, só leitura";
    mqtt(broker, topic)
        "MQTT: {broker}, topics under {topic}"
        "MQTT: {broker}, tópicos sob {topic}";
    mqtt_open()
        "  not encrypted: anyone on the network path can read everything, including the password"
        "  sem criptografia: quem tem acesso ao tráfego da rede pode ler tudo, inclusive a senha";
    mqtt_reads() "  the broker cannot write anything" "  o broker não pode escrever nada";
    mqtt_writes(points)
        "  anyone who may publish to the broker can write {points}"
        "  quem puder publicar no broker pode escrever em {points}";
    mqtt_acknowledges()
        "  anyone who may publish to the broker can acknowledge alarms"
        "  quem puder publicar no broker pode reconhecer alarmes";
    home_assistant()
        "  Home Assistant discovers each board"
        "  o Home Assistant descobre cada placa";
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
    panel(name, count)
        "panel {name} (items: {count})"
        "painel {name} (itens: {count})";
    user_watch(name) "user {name}: watches" "usuário {name}: observa";
    user_operate(name)
        "user {name}: operates, and acknowledges alarms"
        "usuário {name}: opera e reconhece alarmes";
    user_engineer(name)
        "user {name}: operates, and changes programs and settings"
        "usuário {name}: opera e muda programas e ajustes";
    modbus_writes(address, points)
        "Modbus TCP: {address}; anyone who can reach this address can write {points}"
        "Modbus TCP: {address}; quem puder acessar este endereço pode escrever em {points}";
}

#[cfg(test)]
mod tests {
    #[test]
    fn every_text_says_the_same_in_both_languages() {
        assert_eq!(unoclp_words::gaps(super::ALL), [""; 0]);
    }
}
