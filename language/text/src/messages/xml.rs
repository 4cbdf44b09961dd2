//! Messages about projects in PLCopen XML: codes 501 to 599.

macro_rules! xml_rows {
    ($next:ident $($rest:tt)*) => {
        $next! { $($rest)*
    501 XmlBroken Error
        "this is not XML: {0}"
        "export the project again"
        "isto não é XML: {0}"
        "exporte o projeto outra vez";
    502 XmlNoProject Error
        "this XML is not a PLCopen project: it begins with `{0}`"
        "open the plc.xml of a project of OpenPLC Editor or Beremiz, or export PLCopen XML"
        "este XML não é um projeto PLCopen: começa com `{0}`"
        "abra o plc.xml de um projeto do OpenPLC Editor ou do Beremiz, ou exporte PLCopen XML";
    503 XmlNoProgram Error
        "the project has no program"
        "create a POU of type program, and draw in it"
        "o projeto não tem nenhum programa"
        "crie uma POU do tipo program e desenhe nela";
    504 XmlBody Error
        "the body of `{0}` is {1}, which cannot be imported"
        "{2}"
        "o corpo de `{0}` é {1}, que não pode ser importado"
        "{2}";
    505 XmlMixed Error
        "`{0}` is in IL in a project with other languages, where {1} cannot be imported"
        "write `{0}` in ST, or the whole project in IL"
        "`{0}` está em IL em um projeto com outras linguagens, e ali {1} não pode ser importado"
        "escreva `{0}` em ST, ou o projeto inteiro em IL";
    506 XmlAddress Error
        "{0}: there is no point `{1}` on this board"
        "{2}"
        "{0}: não existe o ponto `{1}` nesta placa"
        "{2}";
    507 XmlType Error
        "{0}: `{1}` is {2}, but {3} is needed here"
        ""
        "{0}: `{1}` é {2}, mas aqui é preciso {3}"
        "";
    508 XmlUndeclared Error
        "{0}: `{1}` is not declared"
        "declare it in the table of variables"
        "{0}: `{1}` não foi declarado"
        "declare-o na tabela de variáveis";
    509 XmlBlock Error
        "{0}: the block `{1}` cannot be imported"
        "add a function or a function block with this name to the project, or use standard blocks (docs/structured-text.md)"
        "{0}: o bloco `{1}` não pode ser importado"
        "acrescente ao projeto uma função ou um bloco de funções com este nome, ou use blocos da norma (docs/structured-text.pt-BR.md)";
    510 XmlPin Error
        "{0}: nothing is connected to {1}"
        "draw a wire from the left, or enter a value there"
        "{0}: nada está ligado a {1}"
        "puxe um fio da esquerda, ou escreva um valor ali";
    511 XmlValue Error
        "{0}: `{1}` is not a valid {2}"
        ""
        "{0}: `{1}` não é {2} válido"
        "";
    512 XmlWire Warning
        "{0}: a wire comes from an element that the file does not have, so it is ignored"
        "draw the wire again"
        "{0}: um fio vem de um elemento que o arquivo não tem, e por isso é ignorado"
        "puxe o fio outra vez";
    513 XmlLoop Error
        "{0}: the wires lead back to where they began"
        "break the loop: feed back through a contact of the coil"
        "{0}: os fios voltam para onde começaram"
        "abra o laço: realimente por um contato da bobina";
    514 XmlTangle Error
        "{0}: the wires around it are neither in series nor in parallel"
        "give it a rung of its own, and read its result with a contact"
        "{0}: os fios em volta dele não estão em série nem em paralelo"
        "dê a ele um degrau próprio, e leia o resultado com um contato";
    515 XmlNotRun Warning
        "no task runs the program `{0}`, so it is skipped"
        "create an instance of it in the resource"
        "nenhuma tarefa executa o programa `{0}`; por isso ele fica de fora"
        "crie uma instância dele no recurso";
    516 XmlElement Error
        "{0}: an element `{1}` cannot be imported"
        "draw it with contacts, coils and blocks"
        "{0}: um elemento `{1}` não pode ser importado"
        "desenhe com contatos, bobinas e blocos";
    517 XmlWritten Error
        "{0}: `{1}` can only be read"
        "write to an output, a marker or a number"
        "{0}: `{1}` só pode ser lido"
        "escreva em uma saída, uma memória ou um número";
    519 XmlNoneLeft Error
        "{0}: no {1} is left for `{2}`"
        "the board has {3}"
        "{0}: não sobra {1} para `{2}`"
        "a placa tem {3}";
    521 XmlTooLarge Error
        "the file is too large: {0}"
        "a project for this board is much smaller"
        "o arquivo é grande demais: {0}"
        "um projeto para esta placa é bem menor";
    522 XmlLabel Error
        "{0}: there is no label `{1}`"
        "put the label at the head of a rung"
        "{0}: não há um rótulo `{1}`"
        "ponha o rótulo no começo de um degrau";
    523 XmlLost Warning
        "rung {0}: a PLCopen XML ladder cannot express `{1}`; the project is in Instruction List"
        "draw it with the contacts, coils and blocks listed in docs/plcopen.md"
        "degrau {0}: um ladder do PLCopen XML não consegue expressar `{1}`; o projeto está em Lista de Instruções"
        "desenhe com os contatos, bobinas e blocos listados em docs/plcopen.pt-BR.md";
    524 XmlNoSink Warning
        "{0}: `{1}` is not connected to any output"
        "draw a coil or a variable after it, or remove it"
        "{0}: `{1}` não está ligado a nenhuma saída"
        "desenhe uma bobina ou uma variável depois dele, ou tire-o";
    525 XmlNoJump Warning
        "{0}: no jump leads to the label `{1}`"
        "draw the jump, or remove the label"
        "{0}: nenhum desvio leva ao rótulo `{1}`"
        "desenhe o desvio, ou remova o rótulo";
    526 XmlInput Error
        "{0}: `{1}` has no input `{2}`"
        "wire another input"
        "{0}: `{1}` não tem a entrada `{2}`"
        "ligue o fio a outra entrada";
    527 XmlNoPoint Warning
        "no program of the project reads an input or drives an output of the board"
        "give variables an address: %IX0.0 is the first input, %QX0.0 the first output"
        "nenhum programa do projeto lê uma entrada ou aciona uma saída da placa"
        "dê endereços às variáveis: %IX0.0 é a primeira entrada, %QX0.0 a primeira saída";
    528 XmlNotCalled Error
        "{0}: no block calls `{1}`"
        "draw the block of this instance"
        "{0}: nenhum bloco chama `{1}`"
        "desenhe o bloco desta instância";
    529 XmlOrder Warning
        "{0}: its execution order {1} comes after that of an element that uses its result, so it runs earlier"
        "give it a lower number than that element"
        "{0}: a ordem de execução {1} é posterior à de um elemento que usa o resultado dele; por isso ele é chamado antes"
        "dê a ele um número menor que o desse elemento";
    530 XmlSameId Error
        "{0}: another element has the same `localId`"
        "draw one of the two again"
        "{0}: outro elemento tem o mesmo `localId`"
        "desenhe de novo um dos dois";
    531 XmlFirst Warning
        "{0}: the initial value of `{1}` is ignored, because inputs are read before the first scan"
        "remove the initial value"
        "{0}: o valor inicial de `{1}` é ignorado, porque as entradas são lidas antes da primeira varredura"
        "remova o valor inicial";
    532 XmlNotKept Warning
        "{0}: `{1}` cannot be retained through a power cut"
        "use a number, a BOOL without an address or %MX7.0 to %MX7.7, or remove retain"
        "{0}: `{1}` não pode ser retido em uma queda de energia"
        "use um número, um BOOL sem endereço ou %MX7.0 a %MX7.7, ou tire o retain";
    533 XmlLong Error
        "{0}: the name or the expression has {1} bytes, but at most 1000 are read"
        "shorten it, or compute part of it first"
        "{0}: o nome ou a expressão tem {1} bytes, mas são lidos no máximo 1000"
        "encurte-o, ou calcule antes uma parte";
    534 XmlJump Error
        "{0}: the label `{1}` is above; a ladder with feedback wires, the project's own blocks, conversions or SEL can only jump to labels below"
        "a scan begins again by itself: jump to a label below, or write the loop in ST"
        "{0}: o rótulo `{1}` está acima; um ladder com fios de realimentação, blocos do próprio projeto, conversões ou SEL só desvia para rótulos abaixo"
        "a varredura recomeça por si mesma: desvie para um rótulo abaixo, ou escreva o laço em ST";
    535 XmlNoGlobal Warning
        "no global variable `{0}` is declared, so it is created"
        "declare it among the global variables of the resource, with its address"
        "nenhuma variável global `{0}` está declarada; por isso ela foi criada"
        "declare-a entre as variáveis globais do recurso, com o endereço";
    536 XmlLoose Warning
        "{0}: nothing is connected to its input, so it is left out"
        "draw a wire to it from the left, or remove it"
        "{0}: nada está ligado à entrada dele, e por isso ele é ignorado"
        "ligue-o a um fio vindo da esquerda, ou apague-o";
    538 XmlSameName Error
        "another unit is also called `{0}`; upper and lower case are not distinguished"
        "rename one of the two"
        "outra unidade também se chama `{0}`; maiúsculas e minúsculas valem o mesmo"
        "mude o nome de uma das duas";
    540 XmlMacro Error
        "{0}: a macro step cannot be imported"
        "draw its steps in the chart itself"
        "{0}: uma macroetapa não pode ser importada"
        "desenhe as etapas dela no próprio SFC";
    541 XmlUnjoined Error
        "{0}: no step {1}"
        "draw the line to a step, or remove it"
        "{0}: nenhuma etapa {1}"
        "desenhe a linha até uma etapa, ou remova-a";
    542 XmlCondition Error
        "{0}: {1} cannot be imported as a condition"
        "write the condition as an expression in ST"
        "{0}: {1} não pode ser importado como condição"
        "escreva a condição como uma expressão em ST";
    543 XmlAction Error
        "{0}: {1} cannot be imported as the body of an action"
        "write what the action does in ST"
        "{0}: {1} não pode ser importado como corpo de uma ação"
        "escreva em ST o que a ação faz";
    544 XmlNoBlocks Warning
        "rung {0}: a block diagram cannot express `{1}`; the project is in LD or Instruction List"
        "draw it with contacts, coils and the blocks listed in docs/plcopen.md"
        "degrau {0}: um diagrama de blocos não consegue expressar `{1}`; o projeto está em LD ou Lista de Instruções"
        "desenhe com contatos, bobinas e os blocos listados em docs/plcopen.pt-BR.md";
    545 XmlOutput Error
        "{0}: `{1}` has no output `{2}`"
        "wire another output"
        "{0}: `{1}` não tem a saída `{2}`"
        "ligue o fio a outra saída";
    546 XmlNameless Error
        "{0} has no name"
        "give the step a name"
        "{0} não tem nome"
        "dê um nome à etapa";
        }
    };
}
