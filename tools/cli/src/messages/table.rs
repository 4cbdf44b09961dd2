//! The texts themselves: one table, in which no text is without its twin.

use super::spoken::spoken;

unoclp_words::messages! {
    in spoken;

    cannot_read(file, error)
        "{file} cannot be read ({error}); check its name and folder"
        "não foi possível ler {file} ({error}); confira o nome e a pasta";
    cannot_write(file, error)
        "{file} cannot be written: {error}"
        "não foi possível gravar {file}: {error}";
    is_read(file)
        "{file} is the input file; choose a different output file"
        "{file} é o arquivo de entrada; indique outro para gravar";
    is_compiled(file)
        "{file} is the source; name another output file with -o"
        "{file} é o arquivo-fonte; indique outro arquivo com -o";
    is_there(file)
        "{file} already exists and is not overwritten; name another output file"
        "{file} já existe e não será sobrescrito; indique outro arquivo de saída";
    not_adapted(file)
        "{file} is not Instruction List, Structured Text, SCL or PLCopen XML, which are the languages that adapt can change"
        "{file} não é Lista de Instruções, Texto Estruturado, SCL nem PLCopen XML, que são as linguagens que adapt pode alterar";
    no_editor(why)
        "only an editor can start this command, and no editor answered: {why}. docs/editors.md explains the setup"
        "só um editor pode iniciar este comando, e nenhum respondeu: {why}. docs/editors.pt-BR.md explica a configuração";
    can_be_adapted(file, points, board)
        "unoclp adapt {file} -o COPY writes a copy that moves {points} to free points of the {board}"
        "unoclp adapt {file} -o CÓPIA grava uma cópia que passa {points} para pontos livres do {board}";
    nothing_to_adapt(board)
        "the {board} has all points of this text; no copy was written"
        "o {board} tem todos os pontos deste texto; nenhuma cópia foi gravada";
    no_place(board, points)
        "the {board} has no free point for {points}; they stay as they are"
        "o {board} não tem ponto livre para {points}; eles ficam como estão";
    is_empty(file, languages)
        "{file} is empty: it contains no program. {languages}"
        "{file} está vazio: não há programa nele. {languages}";
    is_binary(file, languages)
        "{file} is not a program: it is a binary file, not text. {languages}"
        "{file} não é um programa: é um arquivo binário, não um texto. {languages}";
    is_no_program(file, languages)
        "{file} is not a program: its first lines match none of the languages. {languages}"
        "{file} não é um programa: as primeiras linhas não são de nenhuma das linguagens. {languages}";
    programs_are(languages)
        "Languages: {languages}. If neither the file name nor the first words show the language, use --language"
        "Linguagens: {languages}. Se nem o nome do arquivo nem as primeiras palavras indicarem a linguagem, use --language";
    nothing_to_run()
        "name what to run: a file, - for standard input, or --text \"…\""
        "diga o que executar: um arquivo, - para a entrada padrão, ou --text \"…\"";
    the_text() "the text" "o texto";
    the_input() "standard input" "entrada padrão";
    set_form(given)
        "--set takes NAME=VALUE, like --set start=TRUE; {given} has no ="
        "--set recebe NOME=VALOR, como --set liga=TRUE; {given} não tem =";
    no_variable(name, names)
        "the program has no variable {name}; it has {names}"
        "o programa não tem a variável {name}; ele tem {names}";
    no_variables(name)
        "the program has no variable {name}; it declares no variables"
        "o programa não tem a variável {name}; ele não declara nenhuma";
    no_value(written, name, type_name)
        "{written} is not a valid value for {name}, which is of type {type_name}"
        "{written} não é um valor válido para {name}, que é do tipo {type_name}";
    scan_endless(place, steps)
        "{place}: this scan does not end; unoclp stopped it here after {steps} steps. Does the loop's condition ever change?"
        "{place}: esta varredura não termina; o unoclp a parou aqui depois de {steps} passos. A condição do laço muda alguma vez?";
    run_too_long(scans, steps)
        "unoclp stopped the run after {scans} scans: they took {steps} steps, the limit for one run. Set fewer scans with --scans"
        "o unoclp parou a execução depois de {scans} varreduras: elas levaram {steps} passos, o limite de uma execução. Indique menos varreduras com --scans";
    calls_too_deep(place)
        "{place}: calls are nested too deeply here; split the expression"
        "{place}: há chamadas aninhadas demais; divida a expressão";
    codes_of_a_board(place)
        "{place}: unoclp run cannot execute the codes after CODE; use unoclp sim"
        "{place}: unoclp run não executa os códigos depois de CODE; use unoclp sim";
    not_computed(place)
        "{place}: this value could not be computed, and S 04 was set (division by 0, overflow, or subscript out of range)"
        "{place}: não foi possível calcular este valor, e S 04 foi ligado (divisão por 0, estouro ou índice fora da faixa)";
    symbol_name() "name" "nome";
    symbol_type() "type" "tipo";
    symbol_value() "value" "valor";
    symbol_place() "place" "lugar";
    no_case(case, file, count)
        "there is no case {case}: {file} has {count}"
        "não existe o caso {case}: {file} tem {count}";
    trace_of_one(file, count)
        "a trace records one run, but {file} has {count} cases; choose one with --case"
        "um registro contém uma só execução, mas {file} tem {count} casos; escolha um com --case";
    is_something_else(file, kind)
        "{file} exists and is not {kind} written by unoclp, so it was not changed. Name another file, or overwrite it with --force"
        "{file} já existe e não é {kind} gravado pelo unoclp; por isso não foi alterado. Indique outro arquivo, ou grave por cima com --force";
    a_drawing() "an SVG drawing" "um desenho SVG";
    a_trace() "a VCD trace" "um registro VCD";
    a_program() "numeric code" "código numérico";
    a_page() "a page in HTML" "uma página em HTML";
    no_programs(folder, languages)
        "{folder} contains no program and no hand-in (.unoclp.json). {languages}"
        "{folder} não tem nenhum programa nem entrega (.unoclp.json). {languages}";
    left_out(ends, files)
        "skipped, because their names end neither in {ends} nor in .unoclp.json: {files}"
        "ignorados, porque os nomes não terminam em {ends} nem em .unoclp.json: {files}";
    no_exercises(folder)
        "{folder} contains no exercise. An exercise is a scenario file with cases, and its name ends in .toml"
        "{folder} não tem nenhum exercício. Um exercício é um arquivo de cenário com casos, e seu nome termina em .toml";
    which_exercise()
        "this file does not say which exercise it solves; name one exercise instead of the folder, or ask for a hand-in"
        "este arquivo não diz qual exercício resolve; indique um exercício em vez da pasta, ou peça uma entrega";
    other_exercise(exercise)
        "it was handed in for the exercise {exercise}, which is not graded here; name the file of that exercise, or a folder that contains it"
        "foi entregue para o exercício {exercise}, que não está sendo avaliado; indique o arquivo dele, ou uma pasta em que ele esteja";
    hand_in_too_long(file, bytes, most)
        "{file}: the file has {bytes} bytes, but a hand-in has at most {most}; ask for a new hand-in from the page"
        "{file}: o arquivo tem {bytes} bytes, mas uma entrega tem no máximo {most}; peça ao aluno que entregue de novo pela página";
    hand_in_no_json(file, line, column)
        "{file}:{line}:{column}: the file is damaged (not valid JSON from here on); ask for a new hand-in from the page"
        "{file}:{line}:{column}: o arquivo está danificado (daqui em diante não é JSON válido); peça ao aluno que entregue de novo pela página";
    hand_in_lacks(file, key)
        "{file}: `{key}` is missing, or is not a string; ask for a new hand-in from the page"
        "{file}: falta `{key}`, ou o valor não é um texto; peça ao aluno que entregue de novo pela página";
    hand_in_other_form(file, form, due)
        "{file}: `form` is {form}, but this unoclp reads {due}; use the same version of unoclp as the page"
        "{file}: `form` é {form}, mas este unoclp lê {due}; use a mesma versão do unoclp que a página";
    says_passed(file)
        "{file}: the hand-in claims to have passed, but it did not; the table shows the real result"
        "{file}: a entrega informa que passou, mas não passou; a tabela mostra o resultado real";
    moodle_identifier() "Identifier" "Identificador";
    moodle_name() "Full name" "Nome completo";
    moodle_number() "ID number" "Número de identificação";
    grade_class() "The class" "A turma";
    grade_name() "name" "nome";
    grade_exercise() "exercise" "exercício";
    grade_minutes() "minutes" "minutos";
    not_graded() "not graded" "não avaliado";
    file_empty() "the file is empty" "o arquivo está vazio";
    file_binary() "the file is binary, not text" "o arquivo é binário, não texto";
    file_other() "the first lines match none of the languages" "as primeiras linhas não são de nenhuma das linguagens";
    written(file) "{file}: written" "{file}: gravado";
    grade_file() "file" "arquivo";
    grade_cases() "cases" "casos";
    grade_machine() "machine" "máquina";
    grade_tries() "tries" "tentativas";
    other_language(language)
        "the exercise asks for a program in `{language}`"
        "o exercício pede um programa em `{language}`";
    names_no_fault()
        "the file names no fault; write one part and its fault per line"
        "o arquivo não indica nenhuma falha; escreva em cada linha uma peça e a falha dela";
    fault_not_found(tries) "not found; tries: {tries}" "não encontrada; tentativas: {tries}";
    grade_failing() "first failing case" "primeiro caso que falha";
    passed() "passed" "passou";
    not_compiled() "does not compile" "não compila";
    in_line(line, message) "line {line}: {message}" "linha {line}: {message}";
    programs_passed(exercise, passed, programs)
        "{exercise}: {passed} of {programs} passed"
        "{exercise}: programas que passam: {passed} de {programs}";
    forced(points)
        "forced: {points}"
        "forçados: {points}";
    forced_before(points)
        "already forced: {points}; x releases all points"
        "já estavam forçados: {points}; x libera todos os pontos";
    stays_forced(points)
        "still forced: {points}; to release them, press x in the monitor or restart the board"
        "continuam forçados: {points}; para liberá-los, aperte x no monitor ou reinicie a placa";
    stays_forced_for(points, seconds)
        "still forced: {points}; the board releases them {seconds} s after the last request. To release them now, press x in the monitor or restart the board"
        "continuam forçados: {points}; a placa os libera {seconds} s depois da última requisição. Para liberá-los já, aperte x no monitor ou reinicie a placa";
    endless()
        "this board's firmware does not release points by itself: they stay forced when the monitor ends"
        "o firmware desta placa não libera pontos sozinho: eles ficam forçados quando o monitor termina";
    let_go(points)
        "no longer forced: {points}"
        "não estão mais forçados: {points}";
    stays_on(outputs)
        "outputs still on, because no rung writes them: {outputs}; STOP switches them off"
        "saídas ainda ligadas, porque nenhum degrau as escreve: {outputs}; STOP as desliga";
    may_stay_on(outputs)
        "outputs that stay on unless the program writes them: {outputs}; STOP switches them off"
        "saídas que ficam ligadas se o programa não as escrever: {outputs}; STOP as desliga";
    interrupted_with_old(state)
        "interrupted; the board is in {state} and keeps its old program"
        "interrompido; a placa está em {state} e mantém o programa antigo";
    interrupted_with_new(state)
        "interrupted; the board is in {state} and has the new program"
        "interrompido; a placa está em {state} e já tem o programa novo";
    interrupted_unknown(error)
        "interrupted; the board no longer answers ({error}). It may be running, with the old program or the new one"
        "interrompido; a placa não responde mais ({error}). Talvez esteja rodando, com o programa antigo ou o novo";
    said_reset()
        "opening the port has probably reset the board; this will not happen next time"
        "abrir a porta provavelmente reiniciou a placa; isso não acontecerá da próxima vez";
    was_reset()
        "opening the port has reset the board; this will not happen next time"
        "abrir a porta reiniciou a placa; isso não acontecerá da próxima vez";
    no_answer(line, port)
        "no answer from {line}, on {port}. Is the board powered and wired, and are these its settings? Set another address or rate with --address and --rate; to restore the defaults, reset the board with the STOP pin (A5 on a UNO) and inputs 01 to 04 connected to GND"
        "sem resposta de {line}, em {port}. A placa está ligada e conectada, e são estes os ajustes dela? Indique outro endereço ou taxa com --address e --rate; para voltar aos ajustes de fábrica, faça o reset com o pino STOP (A5 em um UNO) e as entradas 01 a 04 no GND";
    no_modbus(port, rate, parity)
        "{port} does not speak Modbus at {rate} baud, {parity}; are these the board's settings (--rate, --parity)?"
        "{port} não fala Modbus a {rate} baud, {parity}; são esses os ajustes da placa (--rate, --parity)?";
    no_unoclp(port, foreign)
        "the device at {port} does not run unoclp{foreign}; `unoclp flash` installs the firmware"
        "o dispositivo em {port} não roda o unoclp{foreign}; `unoclp flash` grava o firmware";
    no_port(port, others) "there is no port {port}; {others}" "não existe a porta {port}; {others}";
    no_ports()
        "this PC has no serial port: connect the board with a cable that carries data, not only power"
        "este PC não tem nenhuma porta serial: conecte a placa com um cabo de dados, e não só de energia";
    ports(names) "this PC has {names}" "este PC tem {names}";
    port_denied(port, remedy)
        "this user has no permission to open {port}; {remedy}"
        "este usuário não tem permissão para abrir {port}; {remedy}";
    join_group()
        "join its group, usually with `sudo usermod -aG dialout $USER`, and log in again"
        "entre no grupo dela, em geral com `sudo usermod -aG dialout $USER`, e inicie nova sessão";
    check_who() "check its permissions" "confira as permissões dela";
    port_busy(port)
        "another program, such as a serial monitor, is using {port}; close it"
        "outro programa, como um monitor serial, está usando {port}; feche-o";
    no_serial_port(port) "{port} is not a serial port" "{port} não é uma porta serial";
    port_not_opened(port, reason)
        "{port} cannot be opened: {reason}"
        "não foi possível abrir {port}: {reason}";
    settings_without_answer(why)
        "the board stored the settings, but did not answer after the restart: {why}"
        "a placa guardou os ajustes, mas não respondeu depois do reinício: {why}";
    no_lock()
        "the board has no lock; install newer firmware"
        "a placa não tem bloqueio; grave um firmware mais novo";
    nothing_locked() "nothing locked" "nada bloqueado";
    locked(what) "locked: {what}" "bloqueado: {what}";
    lock_upload() "upload" "envio";
    lock_settings() "settings" "ajustes";
    lock_commands() "commands" "comandos";
    lock_writing() "writing" "escrita";
    locked_now(lock, to_unlock) "now {lock}; {to_unlock}" "agora {lock}; {to_unlock}";
    reset_to_run()
        "in STOP: commands are locked, so only a reset brings the board back to RUN"
        "em STOP: os comandos estão bloqueados, por isso só um reset põe a placa de volta em RUN";
    reset_to_use()
        "commands are locked: reset the board to apply these settings"
        "os comandos estão bloqueados: faça o reset da placa para ela usar esses ajustes";
    restarting(settings) "{settings}; restarting" "{settings}; reiniciando";
    answers_from(line) "the board answers: {line}" "a placa responde: {line}";
    not_for(board)
        "the {board} at the port lacks something that the program needs; nothing was sent"
        "a placa {board} na porta não tem tudo o que o programa usa; nada foi enviado";
    met(identity, port, address)
        "{identity} at {port}, address {address}"
        "{identity} em {port}, endereço {address}";
    place(port, address) "{port}, address {address}" "{port}, endereço {address}";
    at(identity, place) "{identity} at {place}" "{identity} em {place}";
    line(address, rate, parity)
        "address {address} at {rate} baud, {parity}"
        "endereço {address} a {rate} baud, {parity}";
    settings_line(address, rate, parity, direction)
        "address {address}, {rate} baud, {parity}, direction pin {direction}"
        "endereço {address}, {rate} baud, {parity}, pino de direção {direction}";
    parity_none() "no parity" "sem paridade";
    parity_even() "even parity" "paridade par";
    parity_odd() "odd parity" "paridade ímpar";
    pin_on() "on" "ativo";
    pin_off() "off" "inativo";
    no_page()
        "this unoclp was built without the page; `cargo xtask dist` builds one with it, and `cargo xtask lab` serves the page from the source"
        "este unoclp foi compilado sem a página; `cargo xtask dist` compila um com ela, e `cargo xtask lab` serve a página a partir do código-fonte";
    not_served(address, error)
        "cannot serve the page at {address}: {error}. Give another address with --http; --http 127.0.0.1:0 picks a free port"
        "não é possível servir a página em {address}: {error}. Indique outro endereço com --http; --http 127.0.0.1:0 escolhe uma porta livre";
    own(folder, exercises, machines)
        "{folder} adds exercises ({exercises}) and machines ({machines})"
        "{folder} acrescenta exercícios ({exercises}) e máquinas ({machines})";
    own_too_long(file, most)
        "{file} is not a file, or is larger than {most} bytes; it does not appear on the page"
        "{file} não é um arquivo ou passa de {most} bytes; ele não aparece na página";
    watch_at(page) "to watch:   {page}" "acompanhar: {page}";
    control_at(page) "to control: {page}" "controlar:  {page}";
    open_to_network()
        "anyone who has the second address can control the machine; Ctrl-C stops the server"
        "quem tem o segundo endereço pode controlar a máquina; Ctrl-C encerra o servidor";
    shared(port)
        "the board at {port} is shared with this PC only"
        "a placa em {port} é compartilhada só com este PC";
    not_served_site(address, error)
        "cannot listen on {address}: {error}. Set another address under `listen` in the site file"
        "não é possível usar o endereço {address}: {error}. Indique outro em `listen`, no arquivo de instalação";
    overview_at(page)
        "all boards: {page}site.html"
        "todas as placas: {page}site.html";
    page_of_board(name)
        "board {name}: the same page with #board/{name} instead of #board"
        "placa {name}: a mesma página com #board/{name} em vez de #board";
    modbus_at(address) "Modbus TCP: {address}" "servidor Modbus TCP: {address}";
    mqtt_there(broker) "{broker}: connected" "{broker}: conectado";
    mqtt_away(broker, why) "{broker}: not reachable: {why}" "{broker}: fora do ar: {why}";
    mqtt_no_trust(why)
        "its certificate is not trusted ({why}); check `ca` in the site file, and the name in `broker`"
        "o certificado dele não é confiável ({why}); confira `ca` no arquivo de instalação e o nome em `broker`";
    mqtt_not_allowed()
        "it rejects the user or the password; check `user` and `password` in the site file"
        "ele recusa o usuário ou a senha; confira `user` e `password` no arquivo de instalação";
    mqtt_refused() "it refuses the connection" "ele recusa a conexão";
    mqtt_slow() "it does not answer" "ele não responde";
    mqtt_closed() "it has closed the connection" "ele encerrou a conexão";
    mqtt_other(why) "it does not follow the protocol: {why}" "ele não segue o protocolo: {why}";
    no_certificate(file)
        "{file} contains no PEM certificate; name the certificate file of the authority that signed the broker's certificate"
        "{file} não contém nenhum certificado em PEM; indique o arquivo com o certificado da autoridade que assinou o certificado do broker";
    no_trust()
        "this system has no trusted certificates; install ca-certificates, or name one with `ca`"
        "este sistema não tem certificados confiáveis; instale ca-certificates, ou indique um em `ca`";
    board_found(name) "{name}: found" "{name}: encontrada";
    board_away(name, why) "{name}: not reachable: {why}" "{name}: fora do ar: {why}";
    board_is_less(identity, kind)
        "the board identifies itself as {identity}, which has fewer points than a {kind}; change the board, or `kind` in the site file"
        "a placa se identifica como {identity}, que tem menos pontos que um {kind}; mude a placa, ou `kind` no arquivo de instalação";
    board_keeps(name, program) "{name}: has {program}" "{name}: tem {program}";
    board_keeps_other(name, program)
        "{name}: has a program other than {program}, so the names in that file do not apply; upload the file"
        "{name}: tem um programa que não é {program}, e por isso os nomes desse arquivo não valem; envie o arquivo";
    not_reached(server, error)
        "{server} cannot be reached: {error}; is it on, and does it run a Modbus TCP server?"
        "não foi possível acessar {server}: {error}; ele está ligado e roda um servidor Modbus TCP?";
    silent_behind(server, address)
        "no answer from address {address} behind {server}; is that board powered and wired?"
        "sem resposta do endereço {address} atrás de {server}; essa placa está ligada e conectada?";
    no_history()
        "this site keeps no history; add [history] with `store = \"history.db\"` to the site file"
        "esta instalação não guarda histórico; acrescente [history] com `store = \"history.db\"` ao arquivo de instalação";
    no_time(given)
        "{given} is not a time; write 90s, 15m, 1h or 30d"
        "{given} não é um tempo; escreva 90s, 15m, 1h ou 30d";
    not_in_history(point, points)
        "the history has no point {point}; it has {points}"
        "o histórico não tem o ponto {point}; ele tem {points}";
    history_foreign(file)
        "{file} is not a unoclp history file, so it was not changed. Name another file under `store`"
        "{file} não é um histórico do unoclp e não foi alterado. Indique outro arquivo em `store`";
    history_version(file, version)
        "{file} is a history file from another version of unoclp (format {version}), so it was not changed. Use that version, or name another file under `store`"
        "{file} é um histórico de outra versão do unoclp (formato {version}) e não foi alterado. Use essa versão, ou indique outro arquivo em `store`";
    history_full(file)
        "{file} cannot grow: the disk is full. New samples wait in the journal; free some space"
        "{file} não pode crescer: o disco está cheio. As amostras novas esperam no diário; libere espaço";
    history_read_only(file)
        "{file} is read-only; give this user write permission"
        "{file} é somente leitura; dê a este usuário permissão de gravar";
    history_fails(file, why)
        "{file} cannot be used: {why}; check its folder, and whether another program is using the file"
        "não foi possível usar {file}: {why}; confira a pasta e veja se outro programa está usando o arquivo";
    history_away(server, why)
        "{server}: not reachable: {why}. New samples wait in the journal"
        "{server}: fora do ar: {why}. As amostras novas esperam no diário";
    held() "another program has locked it" "outro programa o bloqueou";
    journal_foreign(file)
        "{file} is not a unoclp journal file, so it was not changed. Set a different `store` under [journal]"
        "{file} não é um diário do unoclp e não foi alterado. Indique outro `store` em [journal]";
    journal_version(file, version)
        "{file} is a journal file from another version of unoclp (format {version}), so it was not changed. Run that version until the history and the broker have all samples, or set a different `store` under [journal]"
        "{file} é um diário de outra versão do unoclp (formato {version}) e não foi alterado. Rode essa versão até o histórico e o broker receberem todas as amostras, ou indique outro `store` em [journal]";
    journal_full(file)
        "{file} cannot grow: the disk is full. New samples wait in memory, and the history and the broker get them later; free some space"
        "{file} não pode crescer: o disco está cheio. As amostras novas esperam na memória, e o histórico e o broker as recebem depois; libere espaço";
    journal_held(file)
        "{file}: another `unoclp serve` uses this journal; stop it first"
        "{file}: outro `unoclp serve` usa este diário; encerre-o primeiro";
    fingerprint(sum)
        "certificate: SHA-256 {sum}"
        "certificado: SHA-256 {sum}";
    cert_none(file)
        "{file} contains no PEM certificate; check `cert` under [http]"
        "{file} não contém nenhum certificado em PEM; confira `cert` em [http]";
    key_none(file)
        "{file} contains no PEM key; check `key` under [http]"
        "{file} não contém nenhuma chave em PEM; confira `key` em [http]";
    cert_refused(certificate, key, why)
        "{certificate} cannot be used with {key}: {why}; check that they belong together"
        "não foi possível usar {certificate} com {key}: {why}; confira se são do mesmo par";
    ended() "ended" "encerrado";
    nothing_to_move()
        "this site keeps its history in a file; first name a database under [history], such as `store = \"postgres://gateway@db.example/plant\"`"
        "esta instalação guarda o histórico em um arquivo; indique antes um banco de dados em [history], como `store = \"postgres://gateway@db.example/plant\"`";
    known_there(database, point)
        "{database} already has samples of {point}, so nothing was copied; use an empty database"
        "{database} já tem amostras de {point}, por isso nada foi copiado; use um banco vazio";
    moved(file, points, rows, database)
        "{file}: copied to {database} (points: {points}, rows: {rows}); start unoclp serve again"
        "{file}: copiado para {database} (pontos: {points}, linhas: {rows}); inicie o unoclp serve de novo";
    alarm_came(name, text) "alarm {name}: {text}" "alarme {name}: {text}";
    alarm_gone(name) "alarm {name}: cleared" "alarme {name}: normalizado";
    alarm_acknowledged(name, who)
        "alarm {name}: acknowledged by {who}"
        "alarme {name}: reconhecido por {who}";
    record_foreign(file)
        "{file} is not a unoclp record file, so it was not changed; move it elsewhere"
        "{file} não é um livro de ocorrências do unoclp e não foi alterado; mova-o para outro lugar";
    record_version(file, version)
        "{file} is a record file from a later version of unoclp (format {version}), so it was not changed; use that version, or move the file elsewhere"
        "{file} é um livro de ocorrências de uma versão mais nova do unoclp (formato {version}) e não foi alterado; use essa versão ou mova o arquivo para outro lugar";
    record_full(file)
        "{file} cannot grow: the disk is full. New entries wait in memory; free some space"
        "{file} não pode crescer: o disco está cheio. As novas entradas esperam na memória; libere espaço";
    user_key(token, name, role, key)
        "token for {name} only, shown only once: {token}\nfor the site file:\n\n[[user]]\nname = \"{name}\"\nrole = \"{role}\"\nkey = \"{key}\""
        "token só para {name}, mostrado uma única vez: {token}\npara o arquivo de instalação:\n\n[[user]]\nname = \"{name}\"\nrole = \"{role}\"\nkey = \"{key}\"";
    no_user_name(name)
        "{name} is not a valid user name; use at most 32 letters, digits, - or _, and start with a letter"
        "{name} não é um nome de usuário válido; use no máximo 32 letras, algarismos, - ou _, e comece com uma letra";
    no_key(why)
        "cannot make a key: {why}"
        "não foi possível criar uma chave: {why}";
    users_at(page)
        "users: {page}#board=TOKEN, each with the token that `unoclp site key` printed"
        "usuários: {page}#board=TOKEN, cada um com o token que `unoclp site key` mostrou";
    history_again(file) "{file}: works again" "{file}: voltou a funcionar";
    sent(pass, bytes, all) "{pass}: {bytes} of {all} bytes" "{pass}: {bytes} de {all} bytes";
    writing() "writing the program memory …" "gravando a memória de programa …";
    tested_firmware() "the tested firmware" "o firmware testado";
    flashing(name, bytes, board, port)
        "{name}: {bytes} bytes, for the board {board} at {port}"
        "{name}: {bytes} bytes, para a placa {board} em {port}";
    flash_progress(stage, percent) "{stage}: {percent} %" "{stage}: {percent} % pronto";
    calling_boot_loader() "calling the boot loader" "chamando o bootloader";
    writing_firmware() "writing" "gravando";
    comparing_firmware() "reading back" "lendo de volta";
    starting_firmware() "starting" "iniciando";
    flashed(bytes)
        "written, read back and compared: {bytes} bytes; the board is starting. Its program and settings have not changed"
        "gravado, lido de volta e comparado: {bytes} bytes; a placa está iniciando. O programa e os ajustes dela não mudaram";
    no_program_yet()
        "No program on the board yet: upload one, or insert a card with PROGRAM.TXT and restart"
        "a placa ainda não tem programa: envie um, ou insira um cartão com PROGRAM.TXT e reinicie";
    empty_board() "no program yet" "sem programa ainda";
    board_says(trouble) "the board reports {trouble}" "a placa informa: {trouble}";
    interrupted() "interrupted" "interrompido";
    watcher_ended()
        "unoclp stopped reading the board; start the monitor again"
        "o unoclp parou de ler a placa; inicie o monitor de novo";
    card_is_there(file)
        "{file} already exists, but unoclp overwrites only PROGRAM.TXT on a card; name a new image file, or the folder of a mounted card"
        "{file} já existe, mas o unoclp só grava por cima do PROGRAM.TXT de um cartão; indique um novo arquivo de imagem ou a pasta de um cartão montado";
    card_is_a_device(file)
        "{file} is a device; mount the card, and name its folder"
        "{file} é um dispositivo; monte o cartão e indique a pasta dele";
    cannot_look_at(file, error)
        "{file} cannot be examined: {error}"
        "não foi possível examinar {file}: {error}";
    no_folder(file)
        "the folder {file} does not exist; is the card mounted? For a card image, name a file that ends in .img"
        "não existe a pasta {file}; o cartão está montado? Para a imagem de um cartão, indique um arquivo que termine em .img";
    on_card(program, card, bytes)
        "{program}: on {card} as PROGRAM.TXT, {bytes} bytes"
        "{program}: em {card} como PROGRAM.TXT, {bytes} bytes";
    no_plain_file(file)
        "{file} is not a regular file; remove it from the card first"
        "{file} não é um arquivo comum; primeiro, tire-o do cartão";
    state_is_there()
        "STATE.TXT: exists, not changed"
        "STATE.TXT: já existe e não foi alterado";
    image_not_built(error)
        "the card image cannot be built: {error}"
        "não foi possível montar a imagem do cartão: {error}";
    dialect(name) "dialect {name}" "dialeto {name}";
    dialect_by_words(name) "dialect {name}, detected from its keywords" "dialeto {name}, detectado pelas palavras-chave";
    compiled(dialect, codes, warnings)
        "{dialect}; codes: {codes}, warnings: {warnings}"
        "{dialect}; códigos: {codes}, avisos: {warnings}";
    there_is_no_program() "there is no program" "não há programa";
    one_error() "1 error; there is no program" "1 erro; não há programa";
    errors(count) "{count} errors; there is no program" "{count} erros; não há programa";
    error(error) "error: {error}" "erro: {error}";
    warning(warning) "warning: {warning}" "aviso: {warning}";
    fault_of(number, text) "fault {number}: {text}" "falha {number}: {text}";
    power() "power" "energia";
    unknown() "unknown" "desconhecida";
    no_reset() "no reset" "sem reset";
    command() "command" "comando";
    all_registers() "all D 0" "todos os D em 0";
    forced_flag() "FORCED  " "FORÇADO  ";
    recording() "REC  " "GRAVA  ";
    needs_terminal() "the monitor needs a terminal" "o monitor precisa de um terminal";
    sim_needs_terminal()
        "the simulator needs a terminal; without one, run a scenario: --scenario S.toml"
        "o simulador precisa de um terminal; sem um, execute um cenário: --scenario S.toml";
    nothing_to_simulate()
        "nothing to simulate; name a program or a --scenario"
        "nada a simular; indique um programa ou um --scenario";
    plant_without_program()
        "a machine needs a program that controls it; name one before --plant"
        "uma máquina precisa de um programa que a controle; indique um antes de --plant";
    svg_of_what()
        "--svg draws the run of a --scenario or of a --plant; name one of them"
        "--svg desenha a execução de um --scenario ou de uma --plant; indique um deles";
    plant_binary(file)
        "{file} is not a machine: it is a binary file, not text"
        "{file} não é uma máquina: é um arquivo binário, não um texto";
    plant_has(parts, rules, goals, until)
        "parts: {parts}, rules: {rules}, goals: {goals}; a run takes {until}"
        "elementos: {parts}, regras: {rules}, metas: {goals}; uma execução dura {until}";
    plant_never(text) "rule: {text}" "regra: {text}";
    plant_goal(text, within) "goal: {text} ({within})" "meta: {text} ({within})";
    plant_board(file, board)
        "{file} is wired to the board {board}; use --board {board}"
        "{file} está ligada à placa {board}; use --board {board}";
    no_model(file)
        "{file} names no program; write `program = \"…\"` with a solution that passes"
        "{file} não indica um programa; escreva `program = \"…\"` com uma solução que passe";
    model_faulty(file)
        "the solution {file} has errors; `unoclp check {file}` shows them"
        "a solução {file} tem erros; `unoclp check {file}` os mostra";
    mutants_passed(passed, count)
        "wrong programs that pass: {passed} of {count}"
        "programas errados que passam: {passed} de {count}";
    slip_inverted() "a contact inverted" "um contato invertido";
    slip_dropped() "a contact left out" "um contato a menos";
    slip_joined() "series in place of parallel" "série no lugar de paralelo";
    slip_halved() "a number halved" "um número pela metade";
    slip_doubled() "a number doubled" "um número dobrado";
    slip_swapped() "two coils swapped" "duas bobinas trocadas";
    slip_not_reset() "a coil that is not reset" "uma bobina sem reset";
    no_moment(given)
        "{given} is not a time; write 2.5s, 300ms or 1min"
        "{given} não é um tempo; escreva 2.5s, 300ms ou 1min";
    late_moment(given, until)
        "{given} is after the end of the run ({until})"
        "{given} vem depois do fim da execução ({until})";
    no_span(given)
        "{given} is not a part of a run; write start-end, like 0s-12s"
        "{given} não é um trecho da execução; escreva início-fim, como 0s-12s";
    no_film(why)
        "the animation cannot be made: {why}"
        "não foi possível fazer a animação: {why}";
    built_without_gif()
        "this unoclp was built without support for animations"
        "este unoclp foi compilado sem suporte a animações";
    a_film() "an animated GIF" "um GIF animado";
    rules_kept(kept, rules, met, goals)
        "rules kept: {kept} of {rules}; goals met: {met} of {goals}"
        "regras cumpridas: {kept} de {rules}; metas atingidas: {met} de {goals}";
    machine_passed() "the machine does what it should: PASS" "a máquina faz o que deve: PASSOU";
    machine_failed() "the machine does not do what it should: FAIL" "a máquina não faz o que deve: FALHOU";
    svg_is_a_ladder()
        "--svg draws a ladder diagram, a block diagram (--as fbd) or a chart (--as sfc, --as grafcet); leave out --as or --svg"
        "--svg desenha um diagrama ladder, um diagrama de blocos (--as fbd) ou um SFC (--as sfc, --as grafcet); tire --as ou --svg";
    paper_is_a_ladder()
        "--paper prints a ladder diagram; leave out --paper to draw blocks or a chart"
        "--paper imprime um diagrama ladder; tire --paper para desenhar blocos ou um SFC";
    no_chart()
        "the program has no chart; leave out --as to see its ladder diagram"
        "o programa não tem SFC; tire --as para ver o diagrama ladder";
    drawn(file) "{file}: drawn" "{file}: desenhado";
    is_numeric(file)
        "{file} is numeric code; there is nothing to compile"
        "{file} já é código numérico; não há o que compilar";
    stored(bytes, sum)
        "stored: {bytes} bytes, checksum {sum}"
        "gravado: {bytes} bytes, soma de verificação {sum}";
    in_stop() "in STOP" "em STOP";
    in_fault() "in FAULT" "em FAULT";
    in_stop_by_switch() "in STOP: the STOP switch is closed" "em STOP: a chave STOP está fechada";
    in_stop_until()
        "in STOP until the STOP switch is opened"
        "em STOP até a chave STOP ser aberta";
    in_fault_until()
        "in FAULT: the board runs the program after the next restart"
        "em FAULT: a placa executa o programa depois do próximo reinício";
    refused_program()
        "the board rejects the program and keeps the old one:"
        "a placa recusa o programa e mantém o antigo:";
    inputs_toggle(last) "Inputs: 1 to {last} toggle" "Entradas: 1 a {last} alternam";
    inputs_held(last)
        "Inputs: hold 1 to {last} to close"
        "Entradas: segure 1 a {last} para fechar";
    inputs_force(last) "Inputs: force 1 to {last}" "Entradas: force 1 a {last}";
    outputs_force(last) "Outputs: force 1 to {last}" "Saídas: force 1 a {last}";
    inputs() "Inputs" "Entradas";
    outputs() "Outputs" "Saídas";
    memory() "Memory" "Memória";
    variables() "Variables" "Variáveis";
    watched() "Watched (PRINT)" "Observadas (PRINT)";
    board() "Board" "Placa";
    timers() "Timers (ms)" "Temporizadores (ms)";
    timers_of(first, last, count)
        "Timers (ms): {first} to {last} of {count}"
        "Temporizadores (ms): {first} a {last} de {count}";
    timers_and_counters() "Timers (ms) and counters" "Temporizadores (ms) e contadores";
    lines_of(what, first, last, count)
        "{what}: lines {first} to {last} of {count}"
        "{what}: linhas {first} a {last} de {count}";
    text() "Text" "Texto";
    rungs() "Rungs" "Degraus";
    to_text() "text" "texto";
    chart() "Chart" "SFC";
    to_chart() "chart" "SFC";
    fault_in_line(number, line) "FAULT {number}, line {line}" "FAULT {number}, linha {line}";
    paused() "PAUSED" "PAUSA";
    ran(ms, scans) "{ms} ms  {scans} scans " "{ms} ms  {scans} varreduras ";
    sim_keys(run, view, mode, more)
        " q quit  space {run}  s scan  r restart  v {view}  m {mode}{more}  e slow  ↑↓ scroll"
        " q sai  espaço {run}  s varre  r reset  v {view}  m {mode}{more}  e lento  ↑↓ rola";
    slow_keys()
        " e element  g rung  l line  s end  ↑↓ h to here  b break  space resume  q quit"
        " e elemento  g degrau  l linha  s fim  ↑↓ h aqui  b parada  espaço segue  q sai";
    slow_next(line, acc, value, stack)
        "next line {line}  acc {acc}  value {value}{stack}"
        "próxima linha {line}  acc {acc}  valor {value}{stack}";
    slow_last(acc, value, stack) "end of the scan  acc {acc}  value {value}{stack}" "fim da varredura  acc {acc}  valor {value}{stack}";
    slow_stack(values) "  stack {values}" "  pilha {values}";
    pause() "pause" "pausa";
    run() "run" "roda";
    stop() "stop" "para";
    toggle() "toggle" "alternar";
    momentary() "momentary" "pulsar";
    turn(input) "  a A{input}  +-<> turn" "  a A{input}  +-<> gira";
    t_timers() "  t timers" "  t tempos";
    d_memory() "  d memory" "  d memória";
    monitor_keys(run, other, view)
        " q quit  space {run}  1-8 force  o {other}  x free  s scan  r restart{view}  ↑↓"
        " q sai  espaço {run}  1-8 força  o {other}  x libera  s varre  r reset{view}  ↑↓";
    to_outputs() "outputs" "saídas";
    to_inputs() "inputs" "entradas";
    no_board() "NO BOARD" "SEM PLACA";
    waiting() "waiting for the board" "aguardando a placa";
    lost(why) "connection lost, retrying: {why}" "conexão perdida, tentando de novo: {why}";
    last_upload() "last upload: " "último envio: ";
    switch_closed()
        "the STOP switch is closed: STOP until it is opened"
        "a chave STOP está fechada: STOP até ser aberta";
    upload_under_way() "an upload is in progress" "há um envio em andamento";
    card_failed()
        "the card failed: STATE.TXT is no longer updated"
        "o cartão falhou: STATE.TXT não é mais atualizado";
    another_program(file, bytes, sum, own_bytes, own_sum)
        "the board runs a program other than {file}: {bytes} bytes, checksum {sum}, not {own_bytes} bytes, {own_sum}"
        "a placa executa um programa que não é {file}: {bytes} bytes, soma de verificação {sum}, e não {own_bytes} bytes, {own_sum}";
    figures(last, least, most, volts, stack)
        " scan {last} µs ({least} to {most})  supply {volts} V  stack {stack} bytes free"
        " varredura {last} µs ({least} a {most})  fonte {volts} V  pilha {stack} bytes livres";
    history(cause, restarts, faults)
        " last start: {cause}  since power-up: restarts {restarts}, faults {faults}"
        " última partida: {cause}  desde que foi ligada: reinícios {restarts}, falhas {faults}";
    over(most) "over {most}" "mais de {most}";
    too_small(columns, lines)
        "this screen is too small: {columns} x {lines}"
        "esta tela é pequena demais: {columns} x {lines}";
    needs(columns, lines)
        "at least {columns} x {lines} is needed"
        "é preciso pelo menos {columns} x {lines}";
    q_quits() "q quits" "q encerra";
    in_fault_later(ms)
        "in FAULT, within the first {ms} ms of scanning:"
        "em FAULT nos primeiros {ms} ms de varredura:";
}
