//! The help of the command line: its languages, and all of it in Portuguese, held against the English one by a test.

use clap::builder::PossibleValue;
use clap::{Arg, Command};
use unoclp_program::{Lang, WrittenIn};

/// What a command does: its name, and the words.
const COMMANDS: &[(&str, &str)] = &[
    (
        "unoclp",
        "O CLP unoclp: confere e simula programas neste PC, envia-os a uma placa e a acompanha",
    ),
    (
        "check",
        "Confere um programa e mostra o tamanho dele, ou cada falha com a sua linha",
    ),
    ("compile", "Compila um texto para código numérico"),
    (
        "adapt",
        "Copia um texto, com pontos livres no lugar dos que a placa não tem",
    ),
    (
        "units",
        "Mostra as unidades de um projeto em PLCopen XML, com as suas linguagens e variáveis",
    ),
    (
        "list",
        "Mostra um programa como diagrama ladder, diagrama de blocos ou SFC, como Lista de Instruções, Texto Estruturado ou PLCopen XML, ou como código numérico comentado",
    ),
    (
        "sim",
        "Simula um programa, à mão neste terminal ou com um cenário",
    ),
    (
        "plant",
        "Confere uma máquina que os programas controlam, ou a desenha",
    ),
    (
        "plant check",
        "Mostra os elementos e as metas de uma máquina, ou cada erro com a sua linha",
    ),
    ("plant draw", "Desenha uma máquina no estado inicial"),
    (
        "lsp",
        "Atende um editor pelo Language Server Protocol, na entrada e na saída padrão",
    ),
    (
        "grade",
        "Testa os programas de uma turma com os casos de um exercício",
    ),
    (
        "mutants",
        "Gera programas errados a partir da solução de um exercício e mostra quais passam",
    ),
    ("run", "Executa um programa neste PC e mostra as variáveis"),
    (
        "card",
        "Grava um programa em um cartão de memória, ou em uma nova imagem de cartão",
    ),
    (
        "upload",
        "Envia um programa a uma placa pela porta serial, em vez de usar um cartão",
    ),
    (
        "flash",
        "Grava o firmware em uma placa pelo bootloader dela, lê de volta e compara",
    ),
    (
        "monitor",
        "Acompanha uma placa, força as suas entradas e saídas e a põe em RUN ou STOP",
    ),
    (
        "serve",
        "Serve a página do laboratório e, com --port ou --site, compartilha placas",
    ),
    (
        "site",
        "Confere um arquivo de instalação, que diz quais placas um gateway compartilha e com quem",
    ),
    (
        "site check",
        "Mostra o que um gateway faria com o arquivo, ou cada erro com a sua linha",
    ),
    (
        "site move",
        "Copia um arquivo de histórico para o banco de dados que o arquivo de instalação indica; encerre antes o unoclp serve",
    ),
    (
        "site key",
        "Cria um token para um usuário, e a chave dele para o arquivo de instalação",
    ),
    (
        "site history",
        "Mostra o histórico de um ponto para uma planilha: valores separados por vírgula",
    ),
    (
        "settings",
        "Mostra e muda o endereço, a taxa, a paridade, o pino de direção e o bloqueio de uma placa",
    ),
];

/// What an argument means: its command, where others have one of the same name; its name; and the words.
const ARGUMENTS: &[(&str, &str, &str)] = &[
    (
        "compile",
        "file",
        "O texto: {texts}; - o lê da entrada padrão",
    ),
    (
        "adapt",
        "file",
        "O texto: Lista de Instruções (.il), Texto Estruturado (.st, .scl) ou PLCopen XML (.xml); - o lê da entrada padrão",
    ),
    (
        "adapt",
        "output",
        "O novo arquivo da cópia; sem esta opção, ou com -, a saída padrão",
    ),
    (
        "units",
        "file",
        "O projeto em PLCopen XML; - o lê da entrada padrão",
    ),
    (
        "run",
        "file",
        "O programa, em qualquer das linguagens; - o lê da entrada padrão",
    ),
    (
        "mutants",
        "exercise",
        "O exercício: um arquivo de cenário com casos (.toml)",
    ),
    (
        "grade",
        "exercise",
        "O exercício: um arquivo de cenário com casos (.toml), ou uma pasta com vários",
    ),
    (
        "grade",
        "files",
        "Os programas, em qualquer das linguagens, e as entregas, ou pastas que os contenham",
    ),
    (
        "grade",
        "moodle",
        "Mostra notas de 0 a 100 para importar no Moodle: uma linha por aluno",
    ),
    (
        "grade",
        "csv",
        "Mostra uma tabela para uma planilha: valores separados por vírgula",
    ),
    (
        "grade",
        "html",
        "Grava uma página com cada programa em ladder, e o primeiro caso que falha como diagrama de tempo",
    ),
    ("run", "text", "O próprio programa, em vez de um arquivo"),
    (
        "run",
        "scans",
        "Quantas vezes o programa é executado [padrão: 1]",
    ),
    (
        "run",
        "every",
        "O tempo do início de uma varredura ao início da seguinte, em ms [padrão: 1]",
    ),
    (
        "run",
        "set",
        "Define uma variável, como uma entrada, antes da primeira varredura",
    ),
    ("run", "json", "Mostra tudo como um só objeto JSON"),
    (
        "sim",
        "file",
        "O programa, em qualquer das linguagens; substitui o programa indicado em um cenário",
    ),
    (
        "flash",
        "file",
        "Um arquivo de firmware em Intel HEX; sem ele, o firmware testado que vem com este comando",
    ),
    (
        "flash",
        "board",
        "A placa: uno, nano, nano-old (um Nano com o bootloader usado até 2018) ou mega (um Mega 2560) [padrão: uno]",
    ),
    (
        "monitor",
        "file",
        "O programa que a placa executa, em qualquer das linguagens, para mostrar variáveis e degraus",
    ),
    (
        "",
        "file",
        "O programa: {programs}; - o lê da entrada padrão",
    ),
    (
        "",
        "force",
        "Grava por cima de um arquivo que já existe, mesmo que não tenha sido gravado pelo unoclp",
    ),
    (
        "",
        "output",
        "Onde gravar o código numérico; sem esta opção, ou com -, na saída padrão",
    ),
    (
        "lsp",
        "board",
        "A placa de destino dos programas do editor [padrão: uno]",
    ),
    (
        "",
        "board",
        "A placa de destino; sem esta opção, a placa na porta, ou um UNO. Um Nano não tem números REAL, um Mega tem mais entradas, saídas e memória, e um PC tem 99 pontos de cada tipo",
    ),
    (
        "",
        "dialect",
        "O fabricante do dialeto da Lista de Instruções; sem esta opção, é detectado pelas palavras-chave",
    ),
    (
        "",
        "language",
        "A linguagem do programa; sem esta opção, é detectada pelo nome do arquivo e pelo texto",
    ),
    (
        "",
        "lang",
        "O idioma das mensagens; sem esta opção, o do sistema",
    ),
    (
        "",
        "form",
        "A forma da listagem; xml é um projeto em PLCopen XML, para o OpenPLC Editor e outros [padrão: ladder]",
    ),
    ("plant check", "plant", "A máquina (.toml)"),
    ("plant draw", "plant", "A máquina (.toml)"),
    ("plant draw", "svg", "O arquivo SVG que será gravado"),
    (
        "sim",
        "plant",
        "Deixa o programa controlar esta máquina e verifica metas e regras",
    ),
    (
        "sim",
        "seed",
        "A semente dos eventos aleatórios, em vez da semente da máquina",
    ),
    (
        "sim",
        "at",
        "Com --svg, os instantes a desenhar, em vez daqueles em que regras foram violadas: 1s,2.5s,1min",
    ),
    (
        "sim",
        "gif",
        "Grava a execução da máquina como um GIF animado",
    ),
    (
        "sim",
        "span",
        "O trecho da execução que a animação mostra: 0s-12s",
    ),
    (
        "sim",
        "case",
        "Executa só este caso do cenário, contado a partir de 1",
    ),
    (
        "sim",
        "svg",
        "Desenha neste arquivo um diagrama de tempo: entradas, saídas esperadas e saídas reais; com uma máquina, imagens dela",
    ),
    (
        "",
        "svg",
        "Desenha o diagrama neste arquivo, como gráfico vetorial",
    ),
    (
        "",
        "paper",
        "Desenha um diagrama ladder em páginas deste papel (a4 ou letter), para um relatório: DESENHO.svg, ou DESENHO-1.svg e assim por diante se forem várias",
    ),
    (
        "",
        "title",
        "O título dessas páginas; sem esta opção, o primeiro comentário do programa",
    ),
    (
        "",
        "width",
        "As colunas que um diagrama ladder pode ocupar [padrão: 80]",
    ),
    (
        "",
        "scenario",
        "Executa este cenário sem terminal: mostra o que muda e compara com o esperado",
    ),
    (
        "",
        "vcd",
        "Grava o registro de entradas, saídas e temporizadores para um visualizador de formas de onda",
    ),
    (
        "",
        "card",
        "A pasta de um cartão montado, ou um novo arquivo de imagem (.img)",
    ),
    (
        "",
        "state",
        "Cria também o STATE.TXT, em que a placa grava entradas e saídas",
    ),
    ("", "stop", "Deixa a placa em STOP"),
    (
        "",
        "keep_forces",
        "Mantém os pontos forçados; sem esta opção, são liberados depois da gravação",
    ),
    (
        "serve",
        "http",
        "Onde servir a página; a porta 0 escolhe uma livre [padrão: 127.0.0.1:8420]",
    ),
    (
        "serve",
        "port",
        "Compartilha a placa nesta porta serial: /dev/ttyACM0, /dev/ttyUSB0, COM3 …",
    ),
    (
        "serve",
        "exercises",
        "Mostra na página também os exercícios e as máquinas desta pasta",
    ),
    (
        "serve",
        "site",
        "Compartilha as placas deste arquivo de instalação",
    ),
    ("site check", "site", "O arquivo de instalação (.toml)"),
    (
        "site move",
        "site",
        "O arquivo de instalação (.toml), com o banco de dados em [history]",
    ),
    (
        "site move",
        "from",
        "O arquivo em que o histórico estava até agora",
    ),
    (
        "site key",
        "name",
        "O usuário: uma letra, depois letras, algarismos, - ou _",
    ),
    (
        "site key",
        "role",
        "O que o usuário pode fazer: watch (observar), operate (operar) ou engineer (mudar programas também) [padrão: operate]",
    ),
    ("site history", "site", "O arquivo de instalação (.toml)"),
    ("site history", "point", "Placa e ponto: estufa.level"),
    (
        "site history",
        "last",
        "O período mostrado, até agora: 90s, 15m, 1h, 30d [padrão: 1h]",
    ),
    (
        "site history",
        "step",
        "Uma linha para cada intervalo, com o mínimo, o máximo e o último valor; sem esta opção, cada mudança",
    ),
    (
        "",
        "port",
        "A porta serial: /dev/ttyACM0, /dev/ttyUSB0, COM3 …",
    ),
    ("", "address", "O endereço da placa [padrão: 1]"),
    ("", "rate", "A taxa da placa, em baud [padrão: 115200]"),
    (
        "",
        "parity",
        "A paridade da placa: none (nenhuma), even (par) ou odd (ímpar) [padrão: none]",
    ),
    ("", "set_address", "O endereço a partir da próxima partida"),
    (
        "",
        "set_rate",
        "A taxa, em baud, a partir da próxima partida",
    ),
    (
        "",
        "set_parity",
        "A paridade a partir da próxima partida: none, even ou odd",
    ),
    (
        "",
        "set_direction",
        "Se A4 (D20 em um Mega) é o pino de direção de um driver RS-485: on ou off",
    ),
    (
        "",
        "end_forcing",
        "Faz a placa liberar todos os pontos forçados após este número de segundos sem requisições",
    ),
    (
        "",
        "lock",
        "Bloqueia também estas funções, separadas por vírgula; a placa passa a recusá-las a qualquer cliente: upload (envio), settings (ajustes), commands (comandos), writing (escrita) ou all (tudo)",
    ),
    ("", "help", "Mostra a ajuda"),
    ("", "version", "Mostra a versão"),
];

/// What stands for the value of an argument.
const VALUES: &[(&str, &str)] = &[
    ("FILE", "ARQUIVO"),
    ("CARD", "CARTÃO"),
    ("PORT", "PORTA"),
    ("BOARD", "PLACA"),
    ("ADDRESS", "ENDEREÇO"),
    ("ADDRESS:PORT", "ENDEREÇO:PORTA"),
    ("RATE", "TAXA"),
    ("PARITY", "PARIDADE"),
    ("DIALECT", "DIALETO"),
    ("FORM", "FORMA"),
    ("LANG", "IDIOMA"),
    ("TEXT", "TEXTO"),
    ("LANGUAGE", "LINGUAGEM"),
    ("NAME=VALUE", "NOME=VALOR"),
    ("WHAT", "ITENS"),
    ("SECONDS", "SEGUNDOS"),
    ("OUT.svg", "DESENHO.svg"),
    ("PAPER", "PAPEL"),
    ("OUT.html", "PÁGINA.html"),
    ("EXERCISE", "EXERCÍCIO"),
    ("FILES", "ARQUIVOS"),
    ("OUT.vcd", "REGISTRO.vcd"),
    ("SITE.toml", "INSTALAÇÃO.toml"),
    ("BOARD.POINT", "PLACA.PONTO"),
    ("TIME", "TEMPO"),
    ("TIMES", "TEMPOS"),
    ("FROM-TO", "INÍCIO-FIM"),
    ("COPY", "CÓPIA"),
    ("FOLDER", "PASTA"),
    ("NAME", "NOME"),
    ("ROLE", "PAPEL"),
    ("OUT.gif", "ANIMAÇÃO.gif"),
    ("PLANT.toml", "MÁQUINA.toml"),
    ("HISTORY.db", "HISTÓRICO.db"),
];

/// The layout of a help page.
const PAGE: &str = "{about-with-newline}\nUso: {usage}\n\n{all-args}";

/// The same command line with all languages in the place of `{programs}` and `{texts}`.
pub fn naming_languages(command: Command, lang: Lang) -> Command {
    let command = command.mut_args(|argument| {
        let help = argument.get_help().map(ToString::to_string);
        match help.filter(|help| help.contains('{')) {
            Some(help) => argument.help(
                help.replace("{programs}", &WrittenIn::programs(lang))
                    .replace("{texts}", &WrittenIn::texts(lang)),
            ),
            None => argument,
        }
    });
    command.mut_subcommands(|command| naming_languages(command, lang))
}

/// The same command line, explained in Portuguese.
pub fn in_portuguese(command: Command) -> Command {
    below("", command)
}

/// The name of a command of another: `site check`. Those of `unoclp` have their own.
fn full_name(above: &str, command: &Command) -> String {
    match above {
        "" | "unoclp" => command.get_name().to_owned(),
        above => format!("{above} {}", command.get_name()),
    }
}

fn below(above: &str, command: Command) -> Command {
    let name = full_name(above, &command);
    let mut command = command
        .help_template(PAGE)
        .subcommand_help_heading("Comandos")
        .subcommand_value_name("COMANDO")
        .disable_help_subcommand(true)
        .disable_help_flag(true)
        .arg(
            Arg::new("help")
                .short('h')
                .long("help")
                .action(clap::ArgAction::Help),
        );
    if name == "unoclp" {
        let version = Arg::new("version").short('V').long("version");
        command = command
            .disable_version_flag(true)
            .arg(version.action(clap::ArgAction::Version));
    }
    if let Some((_, about)) = COMMANDS.iter().find(|(command, _)| *command == name) {
        command = command.about(*about);
    }
    let command = command.mut_args(|argument| {
        let heading = match argument.is_positional() {
            true => "Argumentos",
            false => "Opções",
        };
        let words = words(&name, argument.get_id().as_str()).unwrap_or_default();
        let valid = argument.get_possible_values();
        let valid: Vec<&str> = valid.iter().map(PossibleValue::get_name).collect();
        let told = valid.iter().all(|value| words.contains(value));
        let words = match told || !argument.get_action().takes_values() {
            true => words.to_owned(),
            false => format!("{words} [valores: {}]", valid.join(", ")),
        };
        let argument = argument.help(words).help_heading(heading);
        let value = argument.get_value_names().and_then(|names| names.first());
        let value = value.and_then(|value| VALUES.iter().find(|row| row.0 == *value));
        let argument = match value {
            Some((_, portuguese)) => argument.value_name(*portuguese),
            None => argument,
        };
        match argument.get_action().takes_values() {
            true => argument.hide_possible_values(true).hide_default_value(true),
            false => argument,
        }
    });
    command.mut_subcommands(|command| below(&name, command))
}

/// What this argument of this command means.
fn words(command: &str, argument: &str) -> Option<&'static str> {
    let is =
        |row: &&(&str, &str, &str)| row.1 == argument && (row.0 == command || row.0.is_empty());
    ARGUMENTS.iter().find(is).map(|row| row.2)
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    fn arguments(command: &Command) -> Vec<String> {
        let arguments = command.get_arguments();
        arguments
            .map(|argument| argument.get_id().to_string())
            .collect()
    }

    /// A command and all below it, each with its name.
    fn all(above: &str, command: &Command) -> Vec<(String, Command)> {
        let name = full_name(above, command);
        let below = command.get_subcommands();
        let below: Vec<_> = below.flat_map(|of| all(&name, of)).collect();
        [vec![(name, command.clone())], below].concat()
    }

    #[test]
    fn everything_is_explained_in_portuguese() {
        let english = crate::arguments::Arguments::command();
        let portuguese = in_portuguese(english.clone());
        let (english, portuguese) = (all("", &english), all("", &portuguese));
        assert!(english.len() > 14);
        for ((name, english), (_, portuguese)) in english.iter().zip(&portuguese) {
            assert!(
                COMMANDS.iter().any(|(command, _)| command == name),
                "{name}"
            );
            let about = |command: &Command| command.get_about().map(ToString::to_string);
            assert_ne!(about(english), about(portuguese), "{name}");
            for argument in arguments(english) {
                assert!(words(name, &argument).is_some(), "{name}: {argument}");
            }
        }
    }

    #[test]
    fn a_page_of_help_has_no_english_left() {
        let mut command = in_portuguese(crate::arguments::Arguments::command());
        let mut pages = vec![command.render_long_help().to_string()];
        for (_, mut subcommand) in all("", &command) {
            pages.push(subcommand.render_long_help().to_string());
        }
        for page in pages {
            for word in [
                "Usage",
                "Options",
                "Arguments",
                "Commands",
                "default",
                "possible",
                " the ",
                "Print",
                "FILE",
                "PORT>",
                "RATE",
                "PARITY",
                "LANG",
                "WHAT",
                "SECONDS",
            ] {
                assert!(!page.contains(word), "{word} in\n{page}");
            }
        }
    }
}
