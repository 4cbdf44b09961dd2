//! Messages about projects in PLCopen XML: codes 501 to 599.

macro_rules! xml_rows {
    ($next:ident $($rest:tt)*) => {
        $next! { $($rest)*
    501 XmlBroken Error
        "this file is not valid XML: {0}"
        "export the project again"
        "este arquivo não é um XML válido: {0}"
        "exporte o projeto outra vez";
    502 XmlNoProject Error
        "this XML is not a PLCopen project: it begins with `{0}`"
        "open the plc.xml of an OpenPLC Editor or Beremiz project, or export PLCopen XML"
        "este XML não é um projeto PLCopen: começa com `{0}`"
        "abra o plc.xml de um projeto do OpenPLC Editor ou do Beremiz, ou exporte PLCopen XML";
    503 XmlNoProgram Error
        "the project has no program"
        "create a POU of type program, and draw the program in it"
        "o projeto não tem nenhum programa"
        "crie uma POU do tipo program e desenhe o programa nela";
    504 XmlBody Error
        "the body of `{0}` cannot be imported: it is {1}"
        "{2}"
        "o corpo de `{0}` não pode ser importado: está {1}"
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
        "acrescente ao projeto uma função ou um bloco de funções com esse nome, ou use blocos da norma (docs/structured-text.pt-BR.md)";
    510 XmlPin Error
        "{0}: nothing is connected to {1}"
        "draw a wire from the left, or enter a value"
        "{0}: nada está ligado a {1}"
        "puxe um fio da esquerda, ou escreva um valor";
    511 XmlValue Error
        "{0}: `{1}` is not a {2}"
        ""
        "{0}: `{1}` não é {2}"
        "";
    512 XmlWire Warning
        "{0}: a wire comes from an element that is not in the file, so the wire is ignored"
        "draw the wire again"
        "{0}: um fio vem de um elemento que não está no arquivo, e por isso o fio é ignorado"
        "puxe o fio outra vez";
    513 XmlLoop Error
        "{0}: the wires form a closed loop"
        "break the loop: feed back through a contact of the coil"
        "{0}: os fios formam um laço fechado"
        "abra o laço: realimente por um contato da bobina";
    514 XmlTangle Error
        "{0}: the wires around this element are neither in series nor in parallel"
        "draw it on a rung of its own, and read its result with a contact"
        "{0}: os fios em volta deste elemento não estão em série nem em paralelo"
        "desenhe-o em um degrau próprio e leia o resultado com um contato";
    515 XmlNotRun Warning
        "no task runs the program `{0}`, so it is ignored"
        "create an instance of it in the resource"
        "nenhuma tarefa executa o programa `{0}`; por isso ele é ignorado"
        "crie uma instância dele no recurso";
    516 XmlElement Error
        "{0}: the element `{1}` cannot be imported"
        "use the elements listed in docs/plcopen.md"
        "{0}: o elemento `{1}` não pode ser importado"
        "use os elementos listados em docs/plcopen.pt-BR.md";
    517 XmlWritten Error
        "{0}: `{1}` can only be read"
        "write to an output, marker or register"
        "{0}: `{1}` só pode ser lido"
        "escreva em uma saída, memória ou registrador";
    519 XmlNoneLeft Error
        "{0}: no {1} is left for `{2}`"
        "use fewer variables, timers or counters: the board has only {3}"
        "{0}: não há mais {1} livre para `{2}`"
        "use menos variáveis, temporizadores ou contadores: a placa só tem {3}";
    521 XmlTooLarge Error
        "the file is too large: {0}"
        "check that it is the right file; a project for this board is much smaller"
        "o arquivo é grande demais: {0}"
        "verifique se é o arquivo certo; um projeto para esta placa é bem menor";
    522 XmlLabel Error
        "{0}: there is no label `{1}`"
        "put the label at the head of a rung"
        "{0}: não existe o rótulo `{1}`"
        "ponha o rótulo no começo de um degrau";
    523 XmlLost Warning
        "rung {0}: a PLCopen XML ladder cannot express `{1}`; the project is in Instruction List"
        "use the contacts, coils and blocks listed in docs/plcopen.md"
        "degrau {0}: um ladder do PLCopen XML não tem `{1}`; por isso, o projeto está em Lista de Instruções"
        "use os contatos, bobinas e blocos listados em docs/plcopen.pt-BR.md";
    524 XmlNoSink Warning
        "{0}: `{1}` is not connected to any output"
        "draw a coil or a variable after it, or remove it"
        "{0}: `{1}` não está ligado a nenhuma saída"
        "desenhe uma bobina ou uma variável depois dele, ou remova-o";
    525 XmlNoJump Warning
        "{0}: no jump leads to the label `{1}`"
        "draw the jump, or remove the label"
        "{0}: nenhum desvio leva ao rótulo `{1}`"
        "desenhe o desvio, ou remova o rótulo";
    526 XmlInput Error
        "{0}: `{1}` has no input `{2}`"
        "use another input"
        "{0}: `{1}` não tem a entrada `{2}`"
        "ligue o fio a outra entrada";
    527 XmlNoPoint Warning
        "no program of the project reads an input or drives an output of the board"
        "give variables an address: %IX0.0 is the first input, %QX0.0 the first output"
        "nenhum programa do projeto lê uma entrada nem aciona uma saída da placa"
        "dê endereços às variáveis: %IX0.0 é a primeira entrada, %QX0.0 a primeira saída";
    528 XmlNotCalled Error
        "{0}: `{1}` has no block"
        "draw the block of this instance"
        "{0}: `{1}` não tem bloco"
        "desenhe o bloco desta instância";
    529 XmlOrder Warning
        "{0}: its execution order is {1}, but an element with a lower number uses its result; it is executed before that element"
        "give it a lower number than that element"
        "{0}: a ordem de execução dele é {1}, mas um elemento com número menor usa o resultado dele; ele é executado antes desse elemento"
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
        "use a number, %MX7.0 to %MX7.7 or a BOOL without an address, or remove retain"
        "{0}: `{1}` não pode ser retido em uma queda de energia"
        "use um número, %MX7.0 a %MX7.7 ou um BOOL sem endereço, ou tire o retain";
    533 XmlLong Error
        "{0}: the name or the expression has {1} bytes, but at most 1000 are read"
        "shorten it, or compute part of it first"
        "{0}: o nome ou a expressão tem {1} bytes, mas são lidos no máximo 1000"
        "encurte o nome, ou calcule antes uma parte da expressão";
    534 XmlJump Error
        "{0}: the label `{1}` is above; this diagram is compiled as Structured Text, so it can only jump to labels below"
        "the program starts again in every scan: jump to a label below, or write the loop in ST"
        "{0}: o rótulo `{1}` está acima; este diagrama é compilado como Texto Estruturado, e por isso só pode desviar para rótulos abaixo"
        "o programa recomeça a cada varredura: desvie para um rótulo abaixo, ou escreva o laço em ST";
    535 XmlNoGlobal Warning
        "the global variable `{0}` is not declared, so it is created"
        "declare it among the global variables of the resource, with its address"
        "a variável global `{0}` não foi declarada; por isso ela é criada"
        "declare-a entre as variáveis globais do recurso, com o endereço";
    536 XmlLoose Warning
        "{0}: nothing is connected to its input, so it is ignored"
        "draw a wire to it from the left, or remove it"
        "{0}: nada está ligado à entrada dele, e por isso ele é ignorado"
        "ligue-o a um fio vindo da esquerda, ou apague-o";
    538 XmlSameName Error
        "another unit is also called `{0}`; upper and lower case are not distinguished"
        "rename one of the two"
        "outra unidade também se chama `{0}`; maiúsculas e minúsculas não são diferenciadas"
        "mude o nome de uma das duas";
    540 XmlMacro Error
        "{0}: a macro step cannot be imported"
        "draw its steps in the chart itself"
        "{0}: uma macroetapa não pode ser importada"
        "desenhe as etapas dela no próprio SFC";
    541 XmlUnjoined Error
        "{0}: no step {1}"
        "draw the line to a step, or remove the line"
        "{0}: nenhuma etapa {1}"
        "desenhe a linha até uma etapa, ou remova a linha";
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
        "use the contacts, coils and blocks listed in docs/plcopen.md"
        "degrau {0}: um diagrama de blocos não consegue expressar `{1}`; o projeto está em LD ou Lista de Instruções"
        "use os contatos, bobinas e blocos listados em docs/plcopen.pt-BR.md";
    545 XmlOutput Error
        "{0}: `{1}` has no output `{2}`"
        "use another output"
        "{0}: `{1}` não tem a saída `{2}`"
        "ligue o fio a outra saída";
    546 XmlNameless Error
        "{0} has no name"
        "give the step a name"
        "{0} não tem nome"
        "dê um nome à etapa";
    547 XmlNoVariable Error
        "{0} has no variable"
        "enter its variable, or delete it"
        "{0} não tem variável"
        "indique a variável, ou apague o elemento";
        }
    };
}
